// SPDX-License-Identifier: MIT
// One instance of the WebAssembly module: its functions, its memory, and what belongs to no context.
import { Call } from "./call.js";
import { Callbacks } from "./callbacks.js";
import { Camera } from "./camera.js";
import { Context } from "./context.js";
import { FUNCTIONS } from "./generated/functions.js";
import { OFFSETS } from "./generated/layout.js";
import { constant, read } from "./structs.js";

/** A function of the module that takes and gives numbers where C has 64-bit integers and addresses. */
function plain(native, signature) {
  const wide = [...signature.slice(1)].map((letter) => letter === "j");
  const call = wide.includes(true)
    ? (...values) => native(...values.map((value, at) => (wide[at] ? BigInt(value) : value)))
    : native;
  if (signature[0] === "j") return (...values) => Number(call(...values));
  return signature[0] === "p" ? (...values) => call(...values) >>> 0 : call;
}

export class Library {
  #memory;
  #views = { buffer: undefined };

  /** Use load(). */
  constructor(module, memory, threads, compiled) {
    this.#memory = memory;
    /** The WebAssembly.Module, for load() in another worker. */
    this.wasm = compiled;
    /** Threads that a context uses unless told otherwise, the calling one included. */
    this.threads = threads;
    /** The functions of the C interface by their own names, for what the classes do not offer. */
    this.raw = {};
    for (const [name, signature] of Object.entries(FUNCTIONS)) this.raw[name] = plain(module[`_${name}`], signature);
    this.malloc = (bytes) => module._malloc(bytes) >>> 0;
    this.free = module._free;
    this.callbacks = new Callbacks(this, module.addFunction);
  }

  /** Views of the module's memory as it is now: a call that makes it grow makes them useless. */
  get views() {
    const { buffer } = this.#memory;
    if (this.#views.buffer !== buffer)
      this.#views = { buffer, bytes: new Uint8Array(buffer), data: new DataView(buffer) };
    return this.#views;
  }

  /** The text at an address, or undefined at NULL. */
  text(address) {
    if (address === 0) return undefined;
    const { bytes } = this.views;
    return new TextDecoder().decode(bytes.slice(address, bytes.indexOf(0, address)));
  }

  /** "major.minor.patch". */
  get version() {
    return this.text(this.raw.hrbfnpr_version_string());
  }

  /** What this build is: version, abi, compiler, instruction_sets, thread_backends, dependencies. */
  buildInfo() {
    return Call.with(this, (call) => {
      const needed = call.allocate(8);
      this.raw.hrbfnpr_build_info(0, 0, needed);
      const size = Number(this.views.data.getBigInt64(needed, true));
      const text = call.allocate(size);
      this.raw.hrbfnpr_build_info(text, size, 0);
      return JSON.parse(this.text(text));
    });
  }

  /** How the module lays out a struct, such as "hrbfnpr_fit_desc"; undefined where there is none of that name. */
  layout(name) {
    return Call.with(this, (call) => {
      const text = this.text(this.raw.hrbfnpr_layout(call.text(name)));
      return text && JSON.parse(text);
    });
  }

  /** Fails with the names of structs that this package and the module lay out differently. */
  checkLayouts() {
    const wrong = Object.entries(OFFSETS).filter(([name, fields]) => {
      const found = Object.fromEntries(this.layout(name).fields.map((field) => [field.name, field.offset]));
      return JSON.stringify(found) !== JSON.stringify(fields);
    });
    if (wrong.length > 0)
      throw new Error(`the module is of another version than this package: ${wrong.map(([name]) => name).join(", ")}`);
  }

  /** What threads, log and memory hang on, and everything else is made from. */
  createContext(options = {}) {
    return new Context(this, { threadCount: this.threads, ...options });
  }

  createCamera(options = {}) {
    return new Camera(this, options);
  }

  /** "stipple", "hatch", ... in the order of their numbers. */
  get presetNames() {
    const names = [];
    for (let name; (name = this.text(this.raw.hrbfnpr_preset_name(names.length))) !== undefined;) names.push(name);
    return names;
  }

  /**
   * A style as plain data, to be changed and given to Renderer.draw.
   * @param {string | number} [preset] "stipple", "hatch", ...; the default style without one
   */
  style(preset) {
    return Call.with(this, (call) => {
      if (preset === undefined) return read(this, call.struct("hrbfnpr_style", {}), "hrbfnpr_style");
      const style = call.struct("hrbfnpr_style", {}, false);
      call.check("hrbfnpr_style_init_preset", style, call.sizeOf("hrbfnpr_style"),
                 constant("PRESET", preset, "preset"));
      return read(this, style, "hrbfnpr_style");
    });
  }

  /**
   * The layers that a preset draws, as plain data for Model.generate.
   * @param {string | number} preset
   */
  presetLayers(preset) {
    return Call.with(this, (call) => {
      const count = call.allocate(8);
      const first = this.raw.hrbfnpr_preset_layers(constant("PRESET", preset, "preset"), count);
      const { data } = this.views;
      const size = first === 0 ? 0 : data.getUint32(first, true);
      return Array.from({ length: Number(data.getBigInt64(count, true)) },
                        (_, at) => read(this, first + at * size, "hrbfnpr_layer_desc"));
    });
  }

  /** The defaults of a struct of options, such as "hrbfnpr_fit_desc", as plain data. */
  defaults(name) {
    return Call.with(this, (call) => read(this, call.struct(name, {}), name));
  }
}
