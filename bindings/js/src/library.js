// SPDX-License-Identifier: MIT
// One instance of the WebAssembly module: its functions, its memory, and everything that needs no context.
import { Call } from "./call.js";
import { Callbacks } from "./callbacks.js";
import { Camera } from "./camera.js";
import { Context } from "./context.js";
import { FUNCTIONS } from "./generated/functions.js";
import { OFFSETS } from "./generated/layout.js";
import { constant, read } from "./structs.js";

/** Wraps a function of the module, so that 64-bit integers and addresses are numbers. */
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

  /** Private: use load(). */
  constructor(module, memory, threads, compiled) {
    this.#memory = memory;
    /** The WebAssembly.Module, for load() in another worker. */
    this.wasm = compiled;
    /** Default number of threads of a context, the calling one included. */
    this.threads = threads;
    /** The functions of the C interface by their names in C, for everything that the classes do not offer. */
    this.raw = {};
    for (const [name, signature] of Object.entries(FUNCTIONS)) this.raw[name] = plain(module[`_${name}`], signature);
    this.malloc = (bytes) => module._malloc(bytes) >>> 0;
    this.free = module._free;
    this.callbacks = new Callbacks(this, module.addFunction);
  }

  /** Views of the module's memory.  A call that makes the memory grow invalidates them. */
  get views() {
    const { buffer } = this.#memory;
    if (this.#views.buffer !== buffer)
      this.#views = { buffer, bytes: new Uint8Array(buffer), data: new DataView(buffer) };
    return this.#views;
  }

  /** Returns the text at an address; undefined for NULL. */
  text(address) {
    if (address === 0) return undefined;
    const { bytes } = this.views;
    return new TextDecoder().decode(bytes.slice(address, bytes.indexOf(0, address)));
  }

  /** The library's version, "major.minor.patch". */
  get version() {
    return this.text(this.raw.hrbfnpr_version_string());
  }

  /** Describes the build: { version, abi, compiler, instruction_sets, thread_backends, dependencies }. */
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

  /** Returns how the module lays out a struct, such as "hrbfnpr_fit_desc"; undefined for an unknown name. */
  layout(name) {
    return Call.with(this, (call) => {
      const text = this.text(this.raw.hrbfnpr_layout(call.text(name)));
      return text && JSON.parse(text);
    });
  }

  /** Throws, with the names of the structs, if this package and the module lay out structs differently. */
  checkLayouts() {
    const wrong = Object.entries(OFFSETS).filter(([name, fields]) => {
      const found = Object.fromEntries(this.layout(name).fields.map((field) => [field.name, field.offset]));
      return JSON.stringify(found) !== JSON.stringify(fields);
    });
    if (wrong.length > 0)
      throw new Error(`the WebAssembly module has another version than this package; rebuild it. These differ: ${wrong.map(([name]) => name).join(", ")}`);
  }

  /** Creates a context, from which everything else is made. */
  createContext(options = {}) {
    return new Context(this, { threadCount: this.threads, ...options });
  }

  createCamera(options = {}) {
    return new Camera(this, options);
  }

  /** The names of the presets, such as "stipple", in the order of their numbers. */
  get presetNames() {
    const names = [];
    for (let name; (name = this.text(this.raw.hrbfnpr_preset_name(names.length))) !== undefined;) names.push(name);
    return names;
  }

  /**
   * Returns a style as plain data, which can be changed and passed to Renderer.draw.
   * @param {string | number} [preset] a name such as "stipple"; without it, the default style is returned
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
   * Returns the layers that a preset draws, as plain data for Model.generate.
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

  /** Returns the defaults of a struct of options, such as "hrbfnpr_fit_desc", as plain data. */
  defaults(name) {
    return Call.with(this, (call) => read(this, call.struct(name, {}), name));
  }
}
