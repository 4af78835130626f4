// SPDX-License-Identifier: MIT
// From the page's settings to the library's styles, layers and cameras.

const straight = (colour, alpha) =>
  [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255).concat(alpha);

/** The light, towards it, in the camera's space: x right, y up, z to the eye. */
export function lightOf({ lx, ly }) {
  return [lx, ly, Math.sqrt(Math.max(1 - lx * lx - ly * ly, 0.02))];
}

function penOf(layer, settings) {
  const { pen, spacing, ink } = settings;
  return { ...layer, radius: layer.radius * pen, hatchPen: layer.hatchPen * pen,
           hatchSpacing: layer.hatchSpacing * spacing, ...(ink ? { ink: straight(ink, layer.ink[3]) } : {}) };
}

function lineOf(line, { contour, hidden, ink }) {
  return { ...line, width: Math.max(line.width * contour, 0.05), hiddenWidth: Math.max(line.hiddenWidth * contour, 0.05),
           ...(hidden === "preset" ? {} : { hidden }), ...(ink ? { ink: straight(ink, line.ink[3]) } : {}) };
}

/** The preset's style as the settings change it. */
export function styleOf(preset, settings) {
  const { contour, hidden, ink, paper } = settings;
  const style = { ...preset, light: lightOf(settings), lightSpace: "camera", toneExponent: preset.toneExponent * settings.tone,
                  fillLight: settings.fill };
  style.layers = preset.layers?.map((layer) => penOf({ ...layer, contours: contour > 0 ? layer.contours : 0 }, settings));
  style.lines = contour > 0 ? preset.lines?.map((line) => lineOf(line, settings)) : undefined;
  style.silhouetteWidth = Math.max(preset.silhouetteWidth * contour, 0.1);
  style.silhouetteRadius = Math.max(preset.silhouetteRadius * contour, 0.1);
  if (hidden !== "preset")
    style.hiddenLines = { none: "hide", attenuated: "attenuate", dashed: "attenuate", shown: "show" }[hidden];
  if (ink) style.silhouetteInk = straight(ink, preset.silhouetteInk[3]);
  if (paper) style.paper = straight(paper, 1);
  return style;
}

const LAYER_LENGTHS = ["radius", "hatchPen", "hatchSpacing", "hatchWhite", "hatchTaper", "hatchShortest", "hatchOvershoot"];
const LINE_LENGTHS = ["width", "hiddenWidth", "taper", "shortest"];
const STYLE_LENGTHS = ["silhouetteWidth", "silhouetteRadius", "haloWidth"];

function multiplied(fields, names, ratio) {
  return Object.fromEntries(names.filter((name) => name in fields).map((name) => [name, fields[name] * ratio]));
}

/** The style for a picture that is shown at 1 / ratio of its size. */
export function scaled(style, ratio) {
  return { ...style, ...multiplied(style, STYLE_LENGTHS, ratio),
           layers: style.layers?.map((layer) => ({ ...layer, ...multiplied(layer, LAYER_LENGTHS, ratio) })),
           lines: style.lines?.map((line) => ({ ...line, ...multiplied(line, LINE_LENGTHS, ratio) })) };
}

/** The layers to generate. */
export function layersOf(layers, { marks, angle }) {
  return layers.map((layer) => ({ ...layer, budget: marks,
                                  ...(layer.kind === "hatch" ? { angle: layer.angle + angle } : {}) }));
}

/** The direction from the eye into the scene, for y up. */
export function directionOf({ turn, tilt }) {
  const a = turn * Math.PI / 180;
  const b = Math.min(Math.max(tilt, -89), 89) * Math.PI / 180;
  return [-Math.sin(a) * Math.cos(b), -Math.sin(b), -Math.cos(a) * Math.cos(b)];
}

/** A perspective camera around a sphere. */
export function cameraOf(library, { centre, radius }, settings, width, height) {
  const angle = 0.5;
  const direction = directionOf(settings);
  const distance = 1.08 * radius / Math.sin(angle / 2) / settings.zoom * Math.max(1, height / width);
  const eye = centre.map((c, axis) => c - direction[axis] * distance);
  return library.createCamera()
    .perspective(angle, width, height, Math.max(distance - 3 * radius, distance / 100), distance + 3 * radius)
    .lookAt(eye, centre, [0, 1, 0]);
}
