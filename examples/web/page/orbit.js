// SPDX-License-Identifier: MIT
// Turning by mouse, finger or keys, and the handle of the light.

import { SETTINGS } from "./settings.js";

const DEGREES_PER_WIDTH = 220;
const STEP = 5;

const clamped = (value, low, high) => Math.min(Math.max(value, low), high);
const wrapped = (angle) => ((angle + 180) % 360 + 360) % 360 - 180;

export function turnBy(settings, turn, tilt) {
  settings.turn = wrapped(settings.turn + turn);
  settings.tilt = clamped(settings.tilt + tilt, SETTINGS.tilt.min, SETTINGS.tilt.max);
}

export function zoomBy(settings, factor) {
  settings.zoom = clamped(settings.zoom * factor, 0.25, 12);
}

function onKey(settings, event) {
  const keys = {
    ArrowLeft: () => turnBy(settings, -STEP, 0), ArrowRight: () => turnBy(settings, STEP, 0),
    ArrowUp: () => turnBy(settings, 0, STEP), ArrowDown: () => turnBy(settings, 0, -STEP),
    "+": () => zoomBy(settings, 1.15), "=": () => zoomBy(settings, 1.15), "-": () => zoomBy(settings, 1 / 1.15),
    0: () => Object.assign(settings, { turn: 0, tilt: 0, zoom: 1 }),
  };
  if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return false;
  keys[event.key]();
  event.preventDefault();
  return true;
}

/** Calls changed(isMoving) after it has changed turn, tilt and zoom of settings(). */
export function orbitBy(canvas, settings, changed) {
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const was = pointers.size === 2 ? spread() : 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const scale = DEGREES_PER_WIDTH / Math.min(canvas.clientWidth, canvas.clientHeight);
    if (pointers.size === 2) zoomBy(settings(), spread() / Math.max(was, 1));
    else turnBy(settings(), (event.clientX - before.x) * -scale, (event.clientY - before.y) * scale);
    changed(true);
  });
  for (const name of ["pointerup", "pointercancel"])
    canvas.addEventListener(name, (event) => {
      pointers.delete(event.pointerId);
      changed(pointers.size > 0);
    });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(settings(), Math.exp(-event.deltaY / 600));
    changed(true);
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => onKey(settings(), event) && changed(true));
}

/** Sets the place of the light on its disc, x right and y up, and keeps it inside. */
export function setLight(settings, x, y) {
  const length = Math.max(Math.hypot(x, y) / 0.98, 1);
  Object.assign(settings, { lx: x / length, ly: y / length });
}

export function lightBy(handle, settings, changed) {
  const place = (event) => {
    const box = handle.getBoundingClientRect();
    setLight(settings(), 2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    changed(true);
  };
  handle.addEventListener("pointerdown", (event) => {
    handle.setPointerCapture(event.pointerId);
    place(event);
  });
  handle.addEventListener("pointermove", (event) => handle.hasPointerCapture(event.pointerId) && place(event));
  handle.addEventListener("pointerup", () => changed(false));
  handle.addEventListener("keydown", (event) => {
    const [x, y] = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key] ?? [];
    if (x === undefined) return;
    event.preventDefault();
    setLight(settings(), settings().lx + x, settings().ly + y);
    changed(true);
  });
}

/** Shows the light at its place in the settings. */
export function showLight(handle, { lx, ly }) {
  handle.style.setProperty("--x", `${50 + 50 * lx}%`);
  handle.style.setProperty("--y", `${50 - 50 * ly}%`);
  const degrees = (part) => Math.round(Math.asin(part) * 180 / Math.PI);
  handle.setAttribute("aria-valuenow", degrees(lx));
  handle.setAttribute("aria-valuetext", `${degrees(lx)}° to the right, ${degrees(ly)}° up`);
}
