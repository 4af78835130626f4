// SPDX-License-Identifier: MIT
// Functions of JavaScript that the library calls.  The module has one function for each type of callback; its user
// pointer is the number of the JavaScript function.
import { CALLBACKS } from "./generated/functions.js";
import { OFFSETS } from "./generated/layout.js";
import { read } from "./structs.js";

const LEVELS = ["debug", "info", "warning"];

function doubles(library, address, count) {
  return address === 0 ? null : new Float64Array(library.views.buffer, address, count);
}
function floats(library, address, count) {
  return new Float32Array(library.views.buffer, address, count);
}

// How each type of callback calls a function: (library, function, arguments after the user pointer) -> result.
// No result means 0.
const ADAPTERS = {
  hrbfnpr_progress_fn: (_, call, progress) => (call(progress) === false ? 1 : 0),
  hrbfnpr_log_fn: (library, call, level, message) => void call(library.text(message >>> 0), LEVELS[level] ?? level),
  // A picture keeps this callback and calls it for later drawings, too, after the function has been forgotten.
  hrbfnpr_picture_event_fn: (library, call, event) => void call?.(eventOf(library, event >>> 0)),
  hrbfnpr_write_fn: (library, call, data, size) =>
    void call(library.views.bytes.slice(data >>> 0, (data >>> 0) + Number(size))),
  hrbfnpr_read_fn: (library, call, data, size) => {
    const chunk = call(Number(size));
    library.views.bytes.set(chunk, data >>> 0);
    return BigInt(chunk.length);
  },
  hrbfnpr_implicit_fn: (library, call, count, points, value, gradient, hessian) => {
    const n = Number(count);
    return void call(doubles(library, points >>> 0, 3 * n), {
      value: doubles(library, value >>> 0, n), gradient: doubles(library, gradient >>> 0, 3 * n),
      hessian: doubles(library, hessian >>> 0, 6 * n) });
  },
  hrbfnpr_density_fn: (library, call, count, positions, normals, density) => {
    const n = Number(count);
    return void call(doubles(library, positions >>> 0, 3 * n), doubles(library, normals >>> 0, 3 * n),
                     doubles(library, density >>> 0, n));
  },
  hrbfnpr_direction_fn: (library, call, count, positions, normals, directions) => {
    const n = Number(count);
    return void call(doubles(library, positions >>> 0, 3 * n), doubles(library, normals >>> 0, 3 * n),
                     doubles(library, directions >>> 0, 3 * n));
  },
  hrbfnpr_field_fn: (library, call, count, positions, normals, values, weights) => {
    const n = Number(count);
    return void call(doubles(library, positions >>> 0, 3 * n), doubles(library, normals >>> 0, 3 * n), {
      values: doubles(library, values >>> 0, call.components * n), weights: doubles(library, weights >>> 0, n) });
  },
  hrbfnpr_tone_fn: (library, call, count, positions, normals, tau) => {
    const n = Number(count);
    return void call(floats(library, positions >>> 0, 3 * n), floats(library, normals >>> 0, 3 * n),
                     floats(library, tau >>> 0, n));
  },
};

// Reads an event of a picture.  It has a note if the event is about a note.
function eventOf(library, address) {
  const event = read(library, address, "hrbfnpr_picture_event");
  const note = library.views.data.getUint32(address + OFFSETS.hrbfnpr_picture_event.note, true);
  return note === 0 ? event : { ...event, note: read(library, note, "hrbfnpr_note") };
}

export class Callbacks {
  #library;
  #addFunction;
  #addresses = new Map();
  #functions = new Map();
  #releases = new Map();
  #next = 1;
  #thrown;

  constructor(library, addFunction) {
    this.#library = library;
    this.#addFunction = addFunction;
  }

  /** Registers a function of JavaScript.  Returns [address of the module's function, user pointer]. */
  register(type, call, what) {
    if (!ADAPTERS[type]) throw new TypeError(`${what} cannot be a function here; use the functions of Library.raw`);
    if (typeof call !== "function") throw new TypeError(`${what} must be a function`);
    if (!this.#addresses.has(type)) this.#addresses.set(type, this.#enter(type));
    const user = this.#next++;
    this.#functions.set(user, call);
    return [this.#addresses.get(type), user];
  }

  forget(user) {
    this.#functions.delete(user);
    this.#releases.delete(user);
  }

  /** Returns the address of a release function.  Called with `user`, it forgets the function and calls `then`. */
  releaseOf(user, then) {
    this.#releases.set(user, then);
    if (!this.#addresses.has("release"))
      this.#addresses.set("release", this.#addFunction((released) => {
        const call = this.#releases.get(released);
        this.forget(released);
        call?.();
      }, "vi"));
    return this.#addresses.get("release");
  }

  #enter(type) {
    const signature = CALLBACKS[type];
    const failed = { v: undefined, i: 1, j: -1n }[signature[0]];
    const good = { v: undefined, i: 0, j: 0n }[signature[0]];
    const run = (user, ...values) => {
      try {
        return ADAPTERS[type](this.#library, this.#functions.get(user), ...values) ?? good;
      } catch (error) {
        this.#thrown ??= { error };
        return failed;
      }
    };
    return this.#addFunction(run, signature.replaceAll("p", "i"));
  }

  /** Returns { error } with the first exception since the last call of this method; undefined if there was none. */
  takeThrown() {
    const thrown = this.#thrown;
    this.#thrown = undefined;
    return thrown;
  }
}
