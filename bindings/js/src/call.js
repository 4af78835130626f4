// SPDX-License-Identifier: MIT
// The memory of one call.  It writes arguments into the module's memory, reads results from there, and then frees all.
import { HrbfnprError } from "./errors.js";
import { SCALAR, STATUS } from "./generated/constants.js";
import { OFFSETS } from "./generated/layout.js";
import { read, sizeOf, write } from "./structs.js";

const TYPES = [[Float32Array, SCALAR.FLOAT32], [Float64Array, SCALAR.FLOAT64], [Uint8Array, SCALAR.UINT8],
               [Uint8ClampedArray, SCALAR.UINT8], [Uint32Array, SCALAR.UINT32], [Int32Array, SCALAR.INT32],
               [BigInt64Array, SCALAR.INT64]];
const MAKERS = { 1: Float32Array, 2: Float64Array, 3: Uint8Array, 4: Uint32Array, 5: Int32Array, 6: BigInt64Array };

function scalarOf(array) {
  return TYPES.find(([type]) => array instanceof type)?.[1];
}

/** Returns the elements as one flat typed array.  `value` is a typed array, numbers, or rows of numbers. */
function flat(value, what) {
  if (scalarOf(value)) return value;
  if (Array.isArray(value)) return Float64Array.from(value.flat());
  throw new TypeError(`${what} must be an array of numbers, such as a Float64Array`);
}

function bytesOf(array) {
  return new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
}

/** Joins arrays of bytes. */
export function joined(chunks) {
  const whole = new Uint8Array(chunks.reduce((size, chunk) => size + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    whole.set(chunk, at);
    at += chunk.length;
  }
  return whole;
}

export class Call {
  #addresses = [];
  #outputs = [];
  #users = [];

  constructor(library) {
    this.library = library;
    this.error = this.struct("hrbfnpr_error", {});
  }

  /** Runs `work` with a Call, and then frees the memory that the Call allocated. */
  static with(library, work) {
    const call = new Call(library);
    try {
      return work(call);
    } finally {
      call.free();
    }
  }

  free() {
    this.#addresses.forEach((address) => this.library.free(address));
    this.#users.forEach((user) => this.library.callbacks.forget(user));
  }

  /** Allocates bytes that are zero. */
  allocate(bytes) {
    const address = this.library.malloc(bytes);
    if (address === 0)
      throw new HrbfnprError(STATUS.OUT_OF_MEMORY, `the module has no memory left for ${bytes} bytes; free handles, or use smaller data`);
    this.#addresses.push(address);
    this.library.views.bytes.fill(0, address, address + bytes);
    return address;
  }

  setPointer(at, address) {
    this.library.views.data.setUint32(at, address, true);
  }

  getPointer(at) {
    return this.library.views.data.getUint32(at, true);
  }

  text(value) {
    const encoded = new TextEncoder().encode(String(value));
    const address = this.allocate(encoded.length + 1);
    this.library.views.bytes.set(encoded, address);
    return address;
  }

  bytes(values) {
    const address = this.allocate(Math.max(values.byteLength, 1));
    this.library.views.bytes.set(bytesOf(values), address);
    return address;
  }

  doubles(values, count, what) {
    const numbers = Float64Array.from(values ?? []);
    if (numbers.length !== count) throw new TypeError(`${what} must be ${count} numbers, not ${numbers.length}`);
    return this.bytes(numbers);
  }

  sizeOf(name) {
    return sizeOf(name);
  }

  /** Returns the offset of a field in a struct. */
  offsetOf(name, field) {
    return OFFSETS[name][field];
  }

  /** Allocates a struct with its defaults, changed by `options`.  If `sized` is false, it stays all zero. */
  struct(name, options, sized = true) {
    const address = this.allocate(sizeOf(name));
    if (sized) write(this, address, name, options);
    return address;
  }

  /** Allocates a struct with the fields of `value`, such as a Camera; returns NULL if `value` is missing. */
  structOf(value, name, what = name) {
    if (value === undefined || value === null) return 0;
    const address = this.allocate(sizeOf(name));
    write(this, address, name, value, what);
    return address;
  }

  read(address, name) {
    return read(this.library, address, name);
  }

  callback(type, value, what) {
    const [address, user] = this.library.callbacks.register(type, value, what);
    this.#users.push(user);
    return [address, user];
  }

  /** Keeps the callbacks of this call after its end, such as that of a custom model. */
  keepCallbacks() {
    return this.#users.splice(0);
  }

  #describe(at, address, count, scalar, components) {
    const { data } = this.library.views;
    data.setUint32(at, address, true);
    data.setBigInt64(at + 8, BigInt(count), true);
    data.setBigInt64(at + 16, 0n, true);
    data.setUint32(at + 24, scalar, true);
    data.setUint32(at + 28, components, true);
  }

  /** Writes an hrbfnpr_array at `at`, with a copy of the elements. */
  writeArray(at, value, components, what) {
    const given = value?.data !== undefined && !ArrayBuffer.isView(value) ? value : { data: value, components };
    const elements = flat(given.data, what);
    if (elements.length % given.components !== 0)
      throw new TypeError(`${what} has ${elements.length} numbers; it must have ${given.components} for each element`);
    this.#describe(at, this.bytes(elements), elements.length / given.components, scalarOf(elements), given.components);
  }

  array(value, components, what) {
    const at = this.allocate(sizeOf("hrbfnpr_array"));
    this.writeArray(at, value, components, what);
    return at;
  }

  /** Writes an hrbfnpr_array_out at `at`.  `check` copies the results into the caller's array. */
  writeArrayOut(at, value, what) {
    const given = ArrayBuffer.isView(value) ? { data: value, components: 1 } : value ?? {};
    const scalar = scalarOf(given.data);
    if (!scalar) throw new TypeError(`${what} must be a typed array, or { data, components }`);
    const address = this.allocate(Math.max(given.data.byteLength, 1));
    this.#outputs.push([address, given.data]);
    this.#describe(at, address, given.data.length / given.components, scalar, given.components);
  }

  arrayOut(data, components, what = "array") {
    const at = this.allocate(sizeOf("hrbfnpr_array_out"));
    this.writeArrayOut(at, { data, components }, what);
    return at;
  }

  /** Calls a function whose last parameter is an error, and throws if it fails. */
  check(name, ...values) {
    const status = this.library.raw[name](...values, this.error);
    this.#raise(status);
    for (const [address, array] of this.#outputs)
      bytesOf(array).set(this.library.views.bytes.subarray(address, address + array.byteLength));
  }

  #raise(status) {
    const thrown = this.library.callbacks.takeThrown();
    if (thrown) throw thrown.error;
    if (status === STATUS.OK) return;
    throw new HrbfnprError(status, this.library.text(this.error + 8));
  }

  /** Returns the handle that a function makes.  Its last parameters are the destination and the error. */
  made(name, ...values) {
    const out = this.allocate(4);
    this.check(name, ...values, out);
    return this.getPointer(out);
  }

  /** Copies the elements of an hrbfnpr_array that the library filled. */
  copyOfView(at) {
    const { bytes, data } = this.library.views;
    const count = Number(data.getBigInt64(at + 8, true));
    const type = MAKERS[data.getUint32(at + 24, true)] ?? Float64Array;
    const element = type.BYTES_PER_ELEMENT * data.getUint32(at + 28, true);
    const stride = Number(data.getBigInt64(at + 16, true)) || element;
    const first = data.getUint32(at, true);
    const result = new type(count * element / type.BYTES_PER_ELEMENT);
    if (stride === element) bytesOf(result).set(bytes.subarray(first, first + count * element));
    else for (let row = 0; row < count; ++row)
      bytesOf(result).set(bytes.subarray(first + row * stride, first + row * stride + element), row * element);
    return result;
  }
}
