// SPDX-License-Identifier: MIT
// The page turns what the user does into settings, settings into requests to the worker, and answers into the picture.
import { Controls } from "./controls.js";
import { save, copyText } from "./exports.js";
import { lightBy, orbitBy, showLight } from "./orbit.js";
import { SCENES } from "./scenes.js";
import { SETTINGS, defaults, fromLink, toLink } from "./settings.js";
import { compileModule, Painter } from "./workers.js";

const MOVING = 160; // A picture is drawn in full after this many ms without a change.
const SLOW = 45; // Moving pictures are drawn smaller if a frame takes more ms than this.
const RESTING = 250; // A new picture is made after this many ms without a change.
const MAKING = ["model", "preset", "marks", "angle", "occlusion", "shadow"]; // A change of these settings needs a new picture.

const files = new Map(); // the model files of the page, by the name of the scene

const find = (id) => document.getElementById(id);
const canvas = find("picture");
let settings = fromLink(location.hash);
let source; // what to draw: { key, scene } or { key, saved } or { key, name, bytes }
let chosen; // the scene that was chosen last
let shown; // the request that made the shown picture
let painter;
let controls;
let threads = 1;
let movingUntil;
let restingUntil;
let slowness = 1;
let isReady = false;

const say = (text) => { find("status").textContent = text; };

function complain(text) {
  const message = find("message");
  const close = Object.assign(document.createElement("button"), { type: "button", textContent: "✕", ariaLabel: "Close" });
  close.addEventListener("click", () => { message.hidden = true; });
  message.replaceChildren(text, close);
  message.hidden = false;
}

// Requests.

/** Returns the request for a picture of the source with the settings, in the size of the canvas. */
function pictureRequest() {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(Math.round(side * ratio), 16));
  const making = MAKING.slice(1).map((key) => settings[key]);
  return { key: [source.key, ...making, width, height].join("|"), source, settings: { ...settings },
           size: { width, height } };
}

function requestFrame(isMoving = false) {
  showLight(find("light"), settings);
  if (!shown) return;
  painter.frame({ settings: { ...settings }, scale: isMoving ? slowness : 1 });
  clearTimeout(movingUntil);
  if (isMoving) movingUntil = setTimeout(() => { requestFrame(); keepLink(); }, MOVING);
}

function make(request) {
  if (painter.making === request.key) return;
  find("work").hidden = false;
  find("progress").removeAttribute("value");
  painter.make(request);
}

/** Shows a picture by the settings, and makes a new one if the shown one does not serve. */
function update() {
  if (!isReady || !source) return;
  const request = pictureRequest();
  if (painter.making === undefined && painter.hasPicture && shown?.key === request.key) requestFrame();
  else make(request);
}

function updateSoon() {
  clearTimeout(restingUntil);
  restingUntil = setTimeout(update, RESTING);
}

async function chooseScene(name) {
  chosen = name;
  if (SCENES[name].file && !files.has(name)) {
    const response = await fetch(new URL(SCENES[name].file, import.meta.url)).catch(() => undefined);
    if (!response?.ok) {
      if (name !== "bunny" || shown) complain(`The page has no ${SCENES[name].file}. Build the page with examples/web/build.`);
      settings.model = "blob";
      controls.show();
      return chooseScene("blob");
    }
    files.set(name, new Uint8Array(await response.arrayBuffer()));
  }
  if (chosen !== name) return undefined; // The user has chosen another one meanwhile.
  source = SCENES[name].file ? { key: name, saved: files.get(name) } : { key: name, scene: name };
  return update();
}

async function openFile(file) {
  if (!file) return;
  find("message").hidden = true;
  const bytes = new Uint8Array(await file.arrayBuffer());
  chosen = undefined;
  source = { key: `file ${file.name} ${file.lastModified} ${bytes.length}`, name: file.name, bytes };
  controls.addFile(file.name);
  settings.model = "file";
  controls.show();
  say(`Reading ${file.name} …`);
  update();
}

/** Goes back to the shown picture after a request failed or was cancelled. */
function goBack(failed) {
  find("work").hidden = true;
  if (failed.key === shown?.key) shown = undefined; // Do not ask for it again and again.
  if (!shown) {
    if (failed.source.key === "blob") return;
    settings.model = "blob";
    controls.show();
    chooseScene("blob");
    return;
  }
  source = shown.source;
  for (const key of MAKING) settings[key] = shown.settings[key];
  controls.show();
  keepLink();
  if (painter.hasPicture) requestFrame();
  else make(shown);
}

function keepLink() {
  history.replaceState(null, "", toLink(settings));
}

// Answers.

function paint({ width, height, data }) {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  canvas.getContext("2d").putImageData(new ImageData(data, width, height), 0, 0);
}

function list(id, texts) {
  find(id).replaceChildren(...texts.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
}

const ANSWERS = {
  ready({ presets, version }) {
    if (isReady) return; // A cancel starts another worker.
    controls.setPresets(presets);
    document.documentElement.dataset.version = version;
    isReady = true;
    controls.show();
    chooseScene(Object.hasOwn(SCENES, settings.model) ? settings.model : "bunny");
    if (settings.model === "file") complain("This link was made with a file of the sender. Drop that file on the picture.");
  },
  progress({ stage, progress }) {
    find("progress").value = progress;
    say(`${stage}: ${Math.round(100 * progress)} %`);
  },
  picture({ request, facts, notes }) {
    find("work").hidden = painter.making === undefined;
    shown = request;
    find("facts").textContent = facts.join("\n");
    list("notes", notes);
    requestFrame();
    if (painter.making === undefined && pictureRequest().key !== shown.key) updateSoon();
  },
  frame(frame) {
    if (frame.missing) return;
    if (frame.use === "png") {
      save.png(frame);
      return;
    }
    paint(frame);
    const { dataset } = document.documentElement;
    dataset.firstPicture ??= String(Math.round(performance.now()));
    dataset.frames = String(Number(dataset.frames ?? 0) + 1);
    dataset.frameMs = frame.milliseconds.toFixed(1);
    if (frame.key === shown?.key) dataset.made = `${shown.source.key} ${shown.settings.preset}`;
    slowness = Math.min(Math.max(slowness * Math.sqrt(SLOW / Math.max(frame.milliseconds, 5)), 0.45), 1);
    if (painter.making === undefined)
      say(`${frame.dots + frame.strokes} dots and strokes, ${frame.milliseconds.toFixed(0)} ms per frame` +
          (threads > 1 ? `, ${threads} threads` : ""));
  },
  svg: ({ text }) => text && save.svg(text),
  failed({ request, message, what, cancelled }) {
    if (!cancelled) complain(what === "begin" || !what ? `The library did not start: ${message}` : message);
    if (what !== "make") return;
    say(cancelled ? "Cancelled" : "No picture was made");
    goBack(request);
  },
};

// What the user does.

function changed(key) {
  find("message").hidden = true;
  if (key === "model") {
    settings.model = controls.model.value;
    if (settings.model !== "file") chooseScene(settings.model);
  } else if (key === "preset") {
    Object.assign(settings, { ink: "", paper: "" });
    controls.show();
    update();
  } else if (MAKING.includes(key)) {
    updateSoon();
  } else {
    requestFrame(true);
  }
  keepLink();
}

function listenForFiles() {
  find("open").addEventListener("click", () => find("file").click());
  find("file").addEventListener("change", ({ target }) => { openFile(target.files[0]); target.value = ""; });
  let depth = 0;
  const over = (step) => { depth = Math.max(depth + step, 0); find("drop").hidden = depth === 0; };
  addEventListener("dragenter", (event) => { event.preventDefault(); over(1); });
  addEventListener("dragleave", () => over(-1));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    over(-depth);
    openFile(event.dataTransfer.files[0]);
  });
}

function listenForExports() {
  const ask = (request) => shown && painter.export({ settings: { ...settings }, ...request });
  find("png").addEventListener("click", () => ask({ type: "frame", use: "png", scale: 2 }));
  find("svg").addEventListener("click", () => ask({ type: "svg", link: location.href, scale: 1 / (window.devicePixelRatio || 1) }));
  find("link").addEventListener("click", async () => {
    keepLink();
    say(await copyText(location.href) ? "The link was copied" : `Copy this link: ${location.href}`);
  });
  find("reset").addEventListener("click", () => {
    settings = { ...defaults(), model: settings.model === "file" ? "file" : SETTINGS.model.value };
    changed("model");
    controls.show();
    update();
    keepLink();
  });
}

async function begin() {
  const moved = (isMoving) => {
    requestFrame(isMoving);
    if (!isMoving) keepLink();
  };
  controls = new Controls(find("controls"), () => settings, changed);
  find("controls").addEventListener("submit", (event) => event.preventDefault());
  find("cancel").addEventListener("click", () => painter.cancel());
  orbitBy(canvas, () => settings, moved);
  lightBy(find("light"), () => settings, moved);
  listenForFiles();
  listenForExports();
  new ResizeObserver(updateSoon).observe(canvas);
  addEventListener("hashchange", () => { settings = fromLink(location.hash); controls.show(); changed("model"); });
  const module = await compileModule();
  threads = module.threads;
  painter = new Painter(module, (data) => ANSWERS[data.type](data));
}

begin().catch((error) => { say(""); complain(error.message); });
