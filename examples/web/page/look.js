// SPDX-License-Identifier: MIT
// Turns the page's settings into options of a picture, and into changes of its planned style and camera.
import { SETTINGS } from "./settings.js";

const DEGREE = Math.PI / 180;
const STEEPEST = 89; // degrees above or below the horizon

const straight = (colour, alpha) =>
  [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255).concat(alpha);

/** Returns the options of a picture. The library chooses all options that are not set here. */
export function optionsOf({ preset, marks, angle, occlusion, shadow }, { width, height }) {
  const set = { ...(marks > 0 ? { "marks.layers.budget": marks } : {}),
                ...(occlusion > 0 ? { "style.occlusion_lights": occlusion } : {}),
                ...(shadow > 0 ? { "style.light_shadow": shadow } : {}) };
  return { style: preset, width, height, hatchAngle: angle, allowBlank: true,
           ...(Object.keys(set).length > 0 ? { set } : {}) };
}

/** Returns whether the marks of a picture need a shading. */
export const isShaded = ({ occlusion, shadow }) => occlusion > 0 || shadow > 0;

/** Returns the direction to the light in camera space: x right, y up, z to the eye. */
export function lightOf({ lx, ly }) {
  return [lx, ly, Math.sqrt(Math.max(1 - lx * lx - ly * ly, 0.02))];
}

const isMoved = ({ lx, ly }) => lx !== SETTINGS.lx.value || ly !== SETTINGS.ly.value;

function penOf(layer, settings) {
  const { pen, spacing, ink } = settings;
  return { ...layer, radius: layer.radius * pen, hatchPen: layer.hatchPen * pen,
           hatchSpacing: layer.hatchSpacing * spacing, ...(ink ? { ink: straight(ink, layer.ink[3]) } : {}) };
}

function lineOf(line, { contour, hidden, ink }) {
  return { ...line, width: Math.max(line.width * contour, 0.05), hiddenWidth: Math.max(line.hiddenWidth * contour, 0.05),
           ...(hidden === "preset" ? {} : { hidden }), ...(ink ? { ink: straight(ink, line.ink[3]) } : {}) };
}

/** Returns the planned style with the changes of the settings. The default settings change nothing. */
export function styleOf(planned, settings) {
  const { contour, hidden, ink, paper, tone, fill } = settings;
  const style = { ...planned, toneExponent: planned.toneExponent * tone,
                  fillLight: Math.min((planned.fillLight ?? 0) + fill, 1) };
  if (isMoved(settings)) Object.assign(style, { light: lightOf(settings), lightSpace: "camera" });
  style.layers = planned.layers?.map((layer) => penOf(layer, settings));
  style.lines = contour > 0 ? planned.lines?.map((line) => lineOf(line, settings)) : undefined;
  if (hidden !== "preset")
    style.hiddenLines = { none: "hide", attenuated: "attenuate", dashed: "attenuate", shown: "show" }[hidden];
  if (paper) style.paper = straight(paper, 1);
  return style;
}

const LAYER_LENGTHS = ["radius", "hatchPen", "hatchSpacing", "hatchWhite", "hatchTaper", "hatchShortest", "hatchOvershoot"];
const LINE_LENGTHS = ["width", "hiddenWidth", "taper", "shortest"];
const STYLE_LENGTHS = ["haloWidth"];

function multiplied(fields, names, ratio) {
  return Object.fromEntries(names.filter((name) => name in fields).map((name) => [name, fields[name] * ratio]));
}

/** Returns the style for a picture of `ratio` times the size. */
export function scaled(style, ratio) {
  if (ratio === 1) return style;
  return { ...style, ...multiplied(style, STYLE_LENGTHS, ratio),
           layers: style.layers?.map((layer) => ({ ...layer, ...multiplied(layer, LAYER_LENGTHS, ratio) })),
           lines: style.lines?.map((line) => ({ ...line, ...multiplied(line, LINE_LENGTHS, ratio) })) };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((part) => part / Math.hypot(...a));

/** Returns the direction of view after the eye has gone `turn` degrees around `up`, and `tilt` degrees upward. */
export function turned(direction, up, { turn, tilt }) {
  const axis = unit(up);
  const ahead = unit(direction);
  const height = -dot(ahead, axis); // sine of the elevation
  let level = ahead.map((part, k) => part + height * axis[k]);
  if (Math.hypot(...level) < 1e-6) level = cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
  level = unit(level);
  const side = cross(axis, level);
  const [sine, cosine] = [Math.sin(turn * DEGREE), Math.cos(turn * DEGREE)];
  const elevation = Math.asin(Math.min(Math.max(height, -1), 1)) / DEGREE + tilt;
  const rise = Math.min(Math.max(elevation, -STEEPEST), STEEPEST) * DEGREE;
  return level.map((part, k) => (part * cosine + side[k] * sine) * Math.cos(rise) - axis[k] * Math.sin(rise));
}

/** Returns the picture's camera as the settings move it, for an image of `scale` times the picture's size. */
export function cameraOf(picture, settings, scale) {
  let camera = picture.camera();
  if (settings.turn !== 0 || settings.tilt !== 0) {
    const direction = [2, 6, 10].map((at) => -camera.view[at]);
    camera = picture.look({ direction: turned(direction, picture.info().up, settings) });
  }
  camera.projection = camera.projection.map((part, at) => part * (at % 4 < 2 ? settings.zoom : 1));
  camera.viewport = camera.viewport.map((part) => Math.round(part * scale));
  return camera;
}
