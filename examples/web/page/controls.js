// SPDX-License-Identifier: MIT
// The form has a row for each setting with a label.
import { SCENES } from "./scenes.js";
import { SETTINGS } from "./settings.js";

const HATCHES_ONLY = ["angle", "spacing"];

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function option(value, text) {
  return element("option", { value, textContent: text });
}

function inputOf(key, { value, min, max, step, choices }) {
  if (choices)
    return element("select", { id: key }, ...Object.entries(choices).map(([name, text]) => option(name, text)));
  if (typeof value === "number") return element("input", { id: key, type: "range", min, max, step });
  return element("input", { id: key, type: "color" });
}

const titled = (name) => name.replaceAll("-", " ").replace(/^./, (first) => first.toUpperCase());

export class Controls {
  #rows = new Map();
  #presets = new Map();

  /** Calls changed(key) after the user has changed settings()[key]. */
  constructor(form, settings, changed) {
    this.form = form;
    this.settings = settings;
    this.model = form.querySelector("#model");
    for (const [name, { title }] of Object.entries(SCENES)) this.model.append(option(name, title));
    this.model.addEventListener("change", () => changed("model"));
    const style = form.querySelector("#style");
    this.#add(style, "preset", { label: "Preset", choices: {} }, changed);
    for (const [key, setting] of Object.entries(SETTINGS)) if (setting.label) this.#add(style, key, setting, changed);
  }

  #add(parent, key, setting, changed) {
    const input = inputOf(key, setting);
    const output = element("output");
    const row = element("label", { className: "row" }, element("span", { textContent: setting.label }), input);
    if (input.type === "range") row.append(output);
    input.addEventListener("input", () => {
      this.settings()[key] = input.type === "range" ? Number(input.value) : input.value;
      this.show();
      changed(key);
    });
    this.#rows.set(key, { row, input, output, setting });
    parent.append(row);
  }

  setPresets(presets) {
    this.#presets = new Map(presets.map((one) => [one.name, one]));
    this.#rows.get("preset").input.replaceChildren(...presets.map(({ name }) => option(name, titled(name))));
    if (!this.#presets.has(this.settings().preset)) this.settings().preset = SETTINGS.preset.value;
  }

  /** Adds a file to the list of models. */
  addFile(name) {
    this.model.querySelector("[value='file']")?.remove();
    this.model.append(option("file", name));
  }

  /** Shows the settings in the form. */
  show() {
    const settings = this.settings();
    const preset = this.#presets.get(settings.preset);
    this.model.value = settings.model;
    for (const [key, { row, input, output, setting }] of this.#rows) {
      input.value = settings[key] === "" ? preset?.[key] ?? "#000000" : settings[key];
      output.value = typeof settings[key] !== "number" ? "" : settings[key] === 0 && setting.zero !== undefined
        ? setting.zero : `${Number(settings[key].toFixed(2))}${setting.unit ?? ""}`;
      row.hidden = HATCHES_ONLY.includes(key) && preset !== undefined && !preset.hatches;
    }
  }
}
