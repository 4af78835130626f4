// SPDX-License-Identifier: MIT
// This worker makes pictures, and draws frames of the last one. The page terminates it to cancel.
import { PICTURE, SOURCE, load } from "./hrbfnpr/src/index.js";
import { cameraOf, isShaded, optionsOf, scaled, styleOf } from "./look.js";
import { readShape } from "./readers/read.js";
import { buildScene } from "./scenes.js";

const LATER = ["marks", "lines"]; // A change of style runs these stages again.

let library;
let context;
// The shown picture: { key, source, facts, notes, picture, parts, style, renderer }; if it is shaded, { occluders, shadings,
// lit }, too
let held;

/** Returns the input of Context.draw. */
function inputOf({ scene, saved, name, bytes }) {
  if (saved) return { model: context.loadModel(saved) };
  if (scene) return { model: buildScene(context, scene) };
  const shape = readShape(name, bytes);
  const up = /\.stl$/i.test(name) ? { up: [0, 0, 1], upBy: "STL files" } : {};
  if (shape.kind === "cloud") return { name, points: shape.points, normals: shape.normals };
  const { vertices, triangles, sharpEdges } = shape;
  return { name, ...up, points: vertices, triangles, ...(sharpEdges ? { sharpEdges, flags: SOURCE.HAS_SHARP_EDGES } : {}) };
}

/**
 * Tells the page how far the work is. Keeps the facts and notes of the stages before the marks, because a change of style
 * does not run these stages again.
 */
class Watch {
  facts = [];
  notes = [];
  #stage = "Working";
  #isLater = false;
  #last = 0;

  onEvent = ({ stage, fraction, name, doing, says, note }) => {
    if (LATER.includes(stage)) this.#isLater = true;
    if (note) {
      if (!this.#isLater && note.severity !== "info") this.notes.push(note.text);
      return;
    }
    if (doing) this.#stage = doing[0].toUpperCase() + doing.slice(1);
    if (fraction === 1 && says && !LATER.includes(stage)) this.facts.push(`${name}: ${says}`);
  };

  onProgress = (progress) => {
    const now = performance.now();
    if (now - this.#last < 50 && progress < 1) return;
    this.#last = now;
    postMessage({ type: "progress", stage: this.#stage, progress });
  };
}

function letGo({ picture, parts, renderer, occluders, shadings = [] }) {
  for (const shading of shadings) shading.free();
  occluders?.free();
  for (const { model, pointSet, lineSet, mesh } of parts)
    for (const handle of [model, pointSet, lineSet, mesh]) handle?.free();
  renderer.free();
  picture.free();
}

function make({ key, source, settings, size }) {
  const watch = new Watch();
  const up = source.name === undefined ? { up: [0, 1, 0] } : {}; // y is up in the surfaces of the page
  // The page turns the picture, so it needs the marks for all cameras.
  const options = { ...optionsOf(settings, size), ...up, flags: PICTURE.KEEP_MARKS, onEvent: watch.onEvent };
  const isRestyled = held?.source === source.key;
  const picture = isRestyled ? held.picture.restyle(options, watch) : context.draw(inputOf(source), options, watch);
  const { facts, notes } = isRestyled ? held : watch;
  const told = picture.notes.filter(({ severity }) => severity !== "info").map(({ text }) => text);
  if (held) letGo(held);
  // A renderer numbers the lines that it sees, and the strokes of a sketch depend on these numbers. So each picture has
  // its own renderer.
  held = { key, source: source.key, facts, notes, picture, parts: picture.parts(), style: picture.style(),
           renderer: context.createRenderer() };
  postMessage({ type: "picture", key, facts, notes: [...new Set([...notes, ...told])] });
}

/** Gives the items their shadings. New ones are made if the light has moved, which moves with the camera. */
function shade(items, camera) {
  held.occluders ??= context.createOccluders(items);
  const lit = JSON.stringify([items[0].style.light, camera.view]);
  if (held.lit !== lit) {
    const before = held.shadings ?? [];
    held.shadings = items.map((item, at) => held.occluders.createShading(item, { camera, previous: before[at] }));
    held.lit = lit;
    for (const shading of before) shading.free();
  }
  items.forEach((item, at) => { item.shading = held.shadings[at]; });
}

/** Calls use(drawing, camera), and frees the drawing. */
function drawn({ settings, scale }, use) {
  const style = scaled(styleOf(held.style, settings), scale);
  const camera = cameraOf(held.picture, settings, scale);
  const items = held.parts.map(({ pointSet, lineSet, sides }) => ({ pointSet, lineSet, sides, style }));
  if (isShaded(settings)) shade(items, camera);
  const drawing = held.renderer.draw(items, camera);
  try {
    return use(drawing, camera);
  } finally {
    drawing.free();
  }
}

function frame(request) {
  if (!held) return postMessage({ type: "frame", missing: true });
  const begin = performance.now();
  const { image, dots, strokes } = drawn(request, (drawing, camera) =>
    ({ image: held.picture.rasterize({ drawing, camera }), ...drawing.info() }));
  return postMessage({ type: "frame", key: held.key, use: request.use, ...image, dots, strokes,
                       milliseconds: performance.now() - begin }, [image.data.buffer]);
}

function svg(request) {
  if (!held) return postMessage({ type: "svg" });
  const page = { title: "hrbfnpr", metadata: request.link };
  return postMessage({ type: "svg", text: drawn(request, (drawing, camera) => held.picture.toSVG({ drawing, camera, page })) });
}

const hex = (colour) => `#${colour.slice(0, 3).map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;

/** Describes a preset for the controls of the page. */
function described(name) {
  const { layers, lines, paper } = library.style(name);
  const shown = layers.filter((layer) => layer.shown);
  return { name, hatches: library.presetLayers(name).some(({ kind }) => kind === "hatch"), paper: hex(paper),
           ink: hex((shown[0] ?? lines?.[0] ?? { ink: [0, 0, 0] }).ink) };
}

async function begin({ wasm, threads }) {
  library = await load({ wasm, threads });
  context = library.createContext();
  postMessage({ type: "ready", presets: library.presetNames.map(described), version: library.version });
}

const ACTIONS = { make, frame, svg };
let begun; // Requests wait until the module has started.

onmessage = async ({ data }) => {
  try {
    if (data.type === "begin") begun = begin(data);
    await begun;
    ACTIONS[data.type]?.(data);
  } catch (error) {
    postMessage({ type: "failed", what: data.type, message: error.message });
  }
};
