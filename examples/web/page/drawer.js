// SPDX-License-Identifier: MIT
// The worker that draws frames from marks that are there already.
import { load } from "./hrbfnpr/src/index.js";
import { cameraOf, scaled, styleOf } from "./look.js";
import { buildScene } from "./scenes.js";

const MOST_SETS = 6; // kept, so that going back to a style is quick

let library;
let context;
let renderer;
const sets = new Map();
let model = {};

/** The middle of marks and the farthest of them from it. */
function sphereOf(set) {
  const { boundsMin, boundsMax, origin } = set.info();
  const centre = boundsMin.map((low, axis) => (low + boundsMax[axis]) / 2);
  const positions = set.view(0, "position");
  let farthest = 0;
  for (let at = 0; at < positions.length; at += 3)
    farthest = Math.max(farthest, Math.hypot(...[0, 1, 2].map((axis) => positions[at + axis] + origin[axis] - centre[axis])));
  return { centre, radius: farthest };
}

function forget() {
  model.lines?.free();
  model.model?.free();
  sets.forEach(({ set }) => set.free());
  sets.clear();
}

function takeModel({ key, scene, saved }) {
  if (model.key === key) return;
  forget();
  model = { key, model: scene ? buildScene(context, scene) : context.loadModel(saved) };
}

function takeMarks({ key, bytes }) {
  const set = context.loadPointSet(bytes);
  if (sets.size >= MOST_SETS) {
    const [oldest, entry] = sets.entries().next().value;
    entry.set.free();
    sets.delete(oldest);
  }
  sets.set(key, { set, sphere: sphereOf(set) });
}

/** The contours of the model, and its ridges where the preset draws them, which take longer. */
function traceLines(preset) {
  const { lines } = library.style(preset);
  const ridges = lines?.some(({ kind }) => kind === "ridge") === true;
  if (!lines || (model.lines && (model.hasRidges || !ridges))) return;
  model.lines?.free();
  model.lines = model.model.createLineSet(ridges ? { lines: [{ kind: "ridge" }] } : {});
  model.hasRidges = ridges;
}

function draw({ settings, key, width, height, ratio }) {
  const { set, sphere } = sets.get(key);
  const style = scaled(styleOf(library.style(settings.preset), settings), ratio);
  const item = { pointSet: set, style, ...(model.lines ? { lineSet: model.lines } : {}) };
  return renderer.draw(item, cameraOf(library, sphere, settings, width, height));
}

function frame(request) {
  if (!sets.has(request.key)) return postMessage({ type: "frame", id: request.id, missing: true });
  const begin = performance.now();
  const drawing = draw(request);
  const { data } = drawing.rasterize();
  const { dots, strokes } = drawing.info();
  drawing.free();
  const milliseconds = performance.now() - begin;
  return postMessage({ type: "frame", id: request.id, use: request.use, width: request.width, height: request.height, data,
                       dots, strokes, milliseconds, hasLines: model.lines !== undefined }, [data.buffer]);
}

function svg(request) {
  const drawing = draw(request);
  const text = drawing.toSVG({ title: "hrbfnpr", metadata: request.link });
  drawing.free();
  postMessage({ type: "svg", text });
}

const hex = (colour) => `#${colour.slice(0, 3).map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;

/** What the page's controls go by. */
function described(name) {
  const { layers, lines, paper } = library.style(name);
  const drawn = layers.filter(({ shown }) => shown);
  return { name, hatches: library.presetLayers(name).some(({ kind }) => kind === "hatch"), paper: hex(paper),
           ink: hex((drawn[0] ?? lines?.[0] ?? { ink: [0, 0, 0] }).ink) };
}

async function begin({ wasm, threads }) {
  library = await load({ wasm, threads });
  context = library.createContext();
  renderer = context.createRenderer();
  postMessage({ type: "ready", presets: library.presetNames.map(described), version: library.version });
}

const ACTIONS = {
  begin, frame, svg, model: takeModel, marks: takeMarks,
  lines: ({ key, preset }) => {
    if (model.key === key) traceLines(preset);
    postMessage({ type: "lines", key, preset });
  },
};

onmessage = async ({ data }) => {
  try {
    await ACTIONS[data.type](data);
  } catch (error) {
    postMessage({ type: "failed", what: data.type, message: error.message });
  }
};
