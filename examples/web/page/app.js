// SPDX-License-Identifier: MIT
// The page: what the user does becomes settings, settings become requests to the workers, answers become the picture.
import { Controls } from "./controls.js";
import { save, copyText } from "./exports.js";
import { lightBy, orbitBy, showLight } from "./orbit.js";
import { SCENES } from "./scenes.js";
import { SETTINGS, defaults, fromLink, toLink } from "./settings.js";
import { compileModule, Drawer, Maker } from "./workers.js";

const DRAFT = 4000; // marks of the first picture
const MOVING = 160; // ms without a change after which a picture is drawn in full
const SLOW = 45; // ms of a frame above which moving pictures are drawn smaller
const MAKING = ["model", "preset", "marks", "angle"]; // settings that want other marks

const find = (id) => document.getElementById(id);
const canvas = find("picture");
let settings = fromLink(location.hash);
let source; // of the model that is wanted: { key, scene } or { key, saved } or { key, name, bytes }
let shown; // of the marks that are drawn: { key, preset, made, source }
let models = new Map(); // saved ones of files, by key
let maker;
let drawer;
let controls;
let threads = 1;
let movingUntil;
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

const keyOf = (marks = settings.marks) => [source.key, settings.preset, marks, settings.angle].join("|");

function sizeOf(scale) {
  const ratio = (window.devicePixelRatio || 1) * scale;
  return { ratio, width: Math.max(Math.round(canvas.clientWidth * ratio), 16),
           height: Math.max(Math.round(canvas.clientHeight * ratio), 16) };
}

function requestFrame(isMoving = false) {
  showLight(find("light"), settings);
  if (!shown) return;
  const scale = isMoving ? slowness : 1;
  drawer.frame({ key: shown.key, settings: { ...settings, preset: shown.preset }, ...sizeOf(scale) });
  clearTimeout(movingUntil);
  if (isMoving) movingUntil = setTimeout(() => { requestFrame(); keepLink(); }, MOVING);
}

function make(marks) {
  const key = keyOf(marks);
  if (maker.busy === key) return;
  find("work").hidden = false;
  find("progress").removeAttribute("value");
  maker.make({ key, source: models.get(source.key) ?? source, settings: { ...settings, marks } });
}

/** Marks for the settings: those that are there, or new ones. */
function update() {
  if (!isReady) return;
  if (shown?.key === keyOf()) {
    if (maker.busy !== undefined) maker.cancel();
    requestFrame();
    return;
  }
  const isFirst = !shown && !controls.hatches();
  make(isFirst ? Math.min(DRAFT, settings.marks) : settings.marks);
}

async function chooseScene(name) {
  source = { key: name, scene: name };
  if (SCENES[name].file && !models.has(name)) {
    const response = await fetch(new URL(SCENES[name].file, import.meta.url)).catch(() => undefined);
    if (!response?.ok) {
      if (name !== "bunny" || shown) complain(`${SCENES[name].file} is not beside the page: run examples/web/build`);
      settings.model = "blob";
      controls.show();
      return chooseScene("blob");
    }
    models.set(name, { key: name, saved: new Uint8Array(await response.arrayBuffer()) });
  }
  return update();
}

async function openFile(file) {
  if (!file) return;
  find("message").hidden = true;
  const bytes = new Uint8Array(await file.arrayBuffer());
  source = { key: `file ${file.name} ${file.lastModified} ${bytes.length}`, name: file.name, bytes };
  controls.addFile(file.name);
  settings.model = "file";
  controls.show();
  say(`Reading ${file.name} …`);
  update();
}

/** Back to what is drawn, after a failure or a cancel. */
function goBack() {
  find("work").hidden = true;
  if (!shown) {
    if (settings.model !== "blob") Object.assign(settings, { model: "blob" });
    controls.show();
    chooseScene("blob");
    return;
  }
  source = shown.source;
  Object.assign(settings, shown.made);
  controls.show();
  requestFrame();
}

function keepLink() {
  history.replaceState(null, "", toLink(settings));
}

// Answers.

const FROM_MAKER = {
  ready() {},
  progress({ stage, progress }) {
    find("progress").value = progress;
    say(`${stage}: ${Math.round(100 * progress)} %`);
  },
  model({ key, scene, saved, facts }) {
    if (saved) models.set(key, { key, saved });
    if (facts) find("facts").textContent = facts;
    drawer.send({ type: "model", key, scene, saved });
  },
  marks({ key, bytes, marks }) {
    drawer.send({ type: "marks", key, bytes }, [bytes.buffer]);
    find("work").hidden = maker.busy === undefined;
    const made = Object.fromEntries(MAKING.map((name) => [name, settings[name]]));
    shown = { key, preset: settings.preset, made, source, marks };
    requestFrame();
    if (key !== keyOf()) make(settings.marks);
    else drawer.send({ type: "lines", key: source.key, preset: settings.preset });
  },
  failed({ message, cancelled }) {
    if (!cancelled) complain(message);
    say(cancelled ? "Cancelled" : "That did not work");
    goBack();
  },
};

function paint({ width, height, data }) {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  canvas.getContext("2d").putImageData(new ImageData(data, width, height), 0, 0);
}

const FROM_DRAWER = {
  ready({ presets, version }) {
    controls.setPresets(presets);
    document.documentElement.dataset.version = version;
    isReady = true;
    controls.show();
    chooseScene(Object.hasOwn(SCENES, settings.model) ? settings.model : "bunny");
    if (settings.model === "file") complain("This link was made with a file: drop that file on the picture.");
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
    slowness = Math.min(Math.max(slowness * Math.sqrt(SLOW / Math.max(frame.milliseconds, 5)), 0.45), 1);
    if (maker.busy === undefined)
      say(`${frame.dots + frame.strokes} dots and strokes, ${frame.milliseconds.toFixed(0)} ms` +
          (threads > 1 ? `, ${threads} threads` : ""));
  },
  lines({ key, preset }) {
    document.documentElement.dataset.lines = `${key} ${preset}`;
    requestFrame();
  },
  svg: ({ text }) => save.svg(text),
  failed: ({ message, what }) => complain(what === "begin" || !what ? `The library does not start: ${message}` : message),
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
    clearTimeout(changed.waiting);
    changed.waiting = setTimeout(update, 250);
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
  const full = () => ({ key: shown.key, settings: { ...settings, preset: shown.preset } });
  find("png").addEventListener("click", () => shown && drawer.frame({ use: "png", ...full(), ...sizeOf(2) }));
  find("svg").addEventListener("click", () => shown &&
    drawer.send({ type: "svg", link: location.href, ...full(), ...sizeOf(1 / (window.devicePixelRatio || 1)) }));
  find("link").addEventListener("click", async () => {
    keepLink();
    say(await copyText(location.href) ? "The link is in the clipboard" : `The link: ${location.href}`);
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
  find("cancel").addEventListener("click", () => maker.cancel());
  orbitBy(canvas, () => settings, moved);
  lightBy(find("light"), () => settings, moved);
  listenForFiles();
  listenForExports();
  new ResizeObserver(() => requestFrame(true)).observe(canvas);
  addEventListener("hashchange", () => { settings = fromLink(location.hash); controls.show(); changed("model"); });
  const module = await compileModule();
  threads = module.threads;
  maker = new Maker(module, (data) => FROM_MAKER[data.type](data));
  drawer = new Drawer(module, (data) => FROM_DRAWER[data.type](data));
}

begin().catch((error) => { say(""); complain(error.message); });
