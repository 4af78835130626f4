// SPDX-License-Identifier: MIT
// The worker that fits surfaces and places marks: what takes seconds.  The page ends it to cancel.
import { load } from "./hrbfnpr/src/index.js";
import { layersOf } from "./look.js";
import { readShape } from "./readers/read.js";
import { buildScene } from "./scenes.js";

const TOLERANCE = 0.003; // of a fit, in diagonals
const MOST_CENTRES = 4000;

let library;
let context;
let held = { key: undefined, model: undefined };

function control(stage) {
  let last = 0;
  return {
    onProgress(progress) {
      const now = performance.now();
      if (now - last < 50 && progress < 1) return;
      last = now;
      postMessage({ type: "progress", stage, progress });
    },
  };
}

function diagonalOf(points) {
  let sum = 0;
  for (let axis = 0; axis < 3; ++axis) {
    let low = Infinity;
    let high = -Infinity;
    for (let at = axis; at < points.length; at += 3) {
      low = Math.min(low, points[at]);
      high = Math.max(high, points[at]);
    }
    sum += (high - low) ** 2;
  }
  return Math.sqrt(sum);
}

function fitMesh({ vertices, triangles }) {
  const mesh = context.createMesh({ vertices, triangles });
  try {
    const options = { tolerance: TOLERANCE * diagonalOf(vertices), maximumCentres: MOST_CENTRES };
    const model = context.fitMesh(mesh, options, control("Fitting the mesh"));
    const { closed, faces } = mesh.info();
    return [model, `${faces} faces, ${closed ? "closed" : "open"}; ${model.meshFit.centres} centres`];
  } finally {
    mesh.free();
  }
}

function fitCloud({ points, normals }) {
  const model = context.fit({ points, normals, normalMode: normals ? "auto" : "none", outliers: "drop",
                              regularizationMode: "auto", tolerance: TOLERANCE * diagonalOf(points),
                              maximumCentres: MOST_CENTRES },
                            control(normals ? "Fitting the points" : "Finding normals and fitting"));
  const { samples, centres } = model.info();
  return [model, `${samples} points${normals ? "" : ", normals found"}; ${centres} centres`];
}

function modelOf({ scene, saved, name, bytes }) {
  if (saved) return [context.loadModel(saved), undefined];
  if (scene) return [buildScene(context, scene), undefined];
  const shape = readShape(name, bytes);
  return shape.kind === "mesh" ? fitMesh(shape) : fitCloud(shape);
}

function provide(source) {
  if (held.key === source.key) return held.model;
  held.model?.free();
  held = { key: undefined, model: undefined };
  const [model, facts] = modelOf(source);
  held = { key: source.key, model };
  const saved = source.scene ? undefined : model.save();
  postMessage({ type: "model", key: source.key, scene: source.scene, saved, facts });
  return model;
}

function make({ source, settings, key }) {
  const model = provide(source);
  const layers = layersOf(library.presetLayers(settings.preset), settings);
  const set = model.generate({ layers }, control("Placing marks"));
  const bytes = set.save();
  const { marks } = set.info();
  set.free();
  postMessage({ type: "marks", key, model: source.key, bytes, marks }, [bytes.buffer]);
}

async function begin({ wasm, threads }) {
  library = await load({ wasm, threads });
  context = library.createContext();
  postMessage({ type: "ready" });
}

// What is asked for while the module still starts waits for that.
let begun;

onmessage = async ({ data }) => {
  try {
    if (data.type === "begin") begun = begin(data);
    await begun;
    if (data.type === "make") make(data);
  } catch (error) {
    postMessage({ type: "failed", key: data.key, message: error.message, cancelled: error.isCancelled === true });
  }
};
