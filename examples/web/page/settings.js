// SPDX-License-Identifier: MIT
// The settings of a drawing, and the link that holds them.

/** The settings with their defaults, and the ranges of numbers. With the defaults the library chooses everything. */
export const SETTINGS = {
  model: { value: "bunny" },
  preset: { value: "contour-and-stipple" },
  marks: { value: 0, min: 0, max: 80000, step: 2000, label: "Marks", zero: "auto" }, // in each layer
  angle: { value: 0, min: -90, max: 90, step: 5, label: "Hatch angle", unit: "°" },
  pen: { value: 1, min: 0.4, max: 3, step: 0.1, label: "Pen", unit: "×" },
  spacing: { value: 1, min: 0.6, max: 3, step: 0.1, label: "Hatch spacing", unit: "×" },
  contour: { value: 1, min: 0, max: 3, step: 0.1, label: "Contours", unit: "×" },
  tone: { value: 1, min: 0.3, max: 3, step: 0.1, label: "Darkness" },
  fill: { value: 0, min: 0, max: 1, step: 0.05, label: "Fill light" },
  occlusion: { value: 0, min: 0, max: 1, step: 0.05, label: "Occlusion" },
  shadow: { value: 0, min: 0, max: 1, step: 0.05, label: "Cast shadows" },
  hidden: { value: "preset", choices: { preset: "as in the preset", none: "not drawn", attenuated: "paler",
                                        dashed: "dashed", shown: "drawn" }, label: "Hidden lines" },
  ink: { value: "", label: "Ink" },
  paper: { value: "", label: "Paper" },
  lx: { value: -0.4, min: -1, max: 1, step: 0.001 },
  ly: { value: 0.6, min: -1, max: 1, step: 0.001 },
  // Degrees from the view that the library chose.
  turn: { value: 0, min: -180, max: 180, step: 0.1 },
  tilt: { value: 0, min: -120, max: 90, step: 0.1 },
  zoom: { value: 1, min: 0.25, max: 12, step: 0.001 },
};

export const defaults = () => Object.fromEntries(Object.entries(SETTINGS).map(([key, { value }]) => [key, value]));

/** Returns a valid value of a setting, or undefined. */
function checked(key, text) {
  const { value, min, max, choices } = SETTINGS[key];
  if (choices) return Object.hasOwn(choices, text) ? text : undefined;
  if (typeof value !== "number") return key === "ink" || key === "paper" ? text.match(/^#[0-9a-f]{6}$/i)?.[0] : text;
  const number = Number(text);
  return text !== "" && Number.isFinite(number) ? Math.min(Math.max(number, min), max) : undefined;
}

/** Returns the settings in the fragment of a link. Missing and invalid settings have their defaults. */
export function fromLink(fragment) {
  const settings = defaults();
  for (const [key, text] of new URLSearchParams(fragment.replace(/^#/, ""))) {
    if (!Object.hasOwn(SETTINGS, key)) continue;
    settings[key] = checked(key, text) ?? settings[key];
  }
  return settings;
}

/** Returns the fragment of a link for these settings. */
export function toLink(settings) {
  const parameters = new URLSearchParams();
  for (const [key, { value }] of Object.entries(SETTINGS)) {
    if (settings[key] === value) continue;
    parameters.set(key, typeof value === "number" ? String(Math.round(settings[key] * 1000) / 1000) : settings[key]);
  }
  return `#${parameters}`;
}
