// SPDX-License-Identifier: MIT
// Writes structs of the C interface from plain objects, and reads them, by the layouts of generated/layout.js.
import { GROUPS } from "./generated/constants.js";
import { STRUCTS } from "./generated/layout.js";

const SIZES = { i8: 1, u8: 1, i32: 4, u32: 4, f32: 4, i64: 8, u64: 8, f64: 8 };
const GET = { i8: "getInt8", u8: "getUint8", i32: "getInt32", u32: "getUint32", f32: "getFloat32", f64: "getFloat64",
              i64: "getBigInt64", u64: "getBigUint64" };
const SET = Object.fromEntries(Object.entries(GET).map(([kind, name]) => [kind, name.replace("get", "set")]));

const word = (name) => name.toLowerCase().replaceAll("_", "-");
const WORDS = Object.fromEntries(Object.entries(GROUPS).map(([group, constants]) => [
  group, new Map(Object.entries(constants).map(([name, value]) => [word(name), value]))]));

/** Returns the number of a constant of a group, such as "KERNEL", from its number or its name ("wendland-c2"). */
export function constant(group, value, what) {
  if (typeof value === "number") return value;
  const found = WORDS[group].get(word(String(value)));
  if (found === undefined)
    throw new TypeError(`${what} is "${value}"; it must be one of ${[...WORDS[group].keys()].join(", ")}`);
  return found;
}

function layoutOf(name) {
  if (!Object.hasOwn(STRUCTS, name)) throw new TypeError(`there is no struct ${name}`);
  return STRUCTS[name];
}

function setNumber(data, address, kind, value, what) {
  if (typeof value !== "number" && typeof value !== "bigint" && typeof value !== "boolean")
    throw new TypeError(`${what} must be a number, not ${value === null ? "null" : typeof value}`);
  if (kind === "i64" || kind === "u64") {
    if (typeof value === "number" && !Number.isSafeInteger(value))
      throw new TypeError(`${what} must be a whole number, not ${value}`);
    data[SET[kind]](address, BigInt(value), true);
    return;
  }
  const number = Number(value);
  data[SET[kind]](address, number, true);
  if (!kind.startsWith("f") && data[GET[kind]](address, true) !== number)
    throw new TypeError(`${what} must be a whole number that fits ${kind}, not ${value}`);
}

function setNumbers(data, address, kind, count, values, what) {
  const list = Array.from(values ?? []);
  if (list.length !== count) throw new TypeError(`${what} must be ${count} numbers, not ${list.length}`);
  list.forEach((value, at) => setNumber(data, address + at * SIZES[kind], kind, value, `${what}[${at}]`));
}

function addressOf(value, kind, what) {
  if (value === null || value?.kind !== kind)
    throw new TypeError(`${what} must be a handle of kind ${kind.replace("hrbfnpr_", "")}`);
  return value.pointer;
}

const SETTERS = {
  array: (call, at, [, , components], value, what) => call.writeArray(at, value, components, what),
  arrayOut: (call, at, _, value, what) => call.writeArrayOut(at, value, what),
  text: (call, at, _, value) => call.setPointer(at, call.text(value)),
  address: (call, at, _, value) => call.setPointer(at, value),
  handle: (call, at, [, , kind], value, what) => call.setPointer(at, addressOf(value, kind, what)),
  pointer: (call, at, [, , name], value, what) => call.setPointer(at, call.structOf(value, name, what)),
};

function setList(call, base, [, offset, name, count, stride], value, what) {
  const { size } = layoutOf(name);
  const first = call.allocate(Math.max(size * value.length, 1));
  value.forEach((item, at) => write(call, first + at * size, name, item, `${what}[${at}]`));
  const { data } = call.library.views;
  data.setUint32(base + offset, value.length > 0 ? first : 0, true);
  data.setBigInt64(base + count, BigInt(value.length), true);
  data.setBigInt64(base + stride, BigInt(size), true);
}

function setColours(call, base, [, offset, count], value, what) {
  const numbers = Array.from(value, (colour, at) => {
    if (colour.length !== 4) throw new TypeError(`${what}[${at}] must be 4 numbers: red, green, blue and opacity`);
    return Array.from(colour);
  });
  call.setPointer(base + offset, call.bytes(Float32Array.from(numbers.flat())));
  call.library.views.data.setBigInt64(base + count, BigInt(numbers.length), true);
}

function setField(call, base, layout, value, what) {
  const [kind, offset, count, group] = layout;
  if (kind === "colours") return setColours(call, base, layout, value, what);
  if (kind === "list") return setList(call, base, layout, value, what);
  if (kind === "callback") {
    const [address, user] = call.callback(count, value, what);
    call.setPointer(base + offset, address);
    return call.setPointer(base + group, user);
  }
  if (SETTERS[kind]) return SETTERS[kind](call, base + offset, layout, value, what);
  const { data } = call.library.views;
  if (count) return setNumbers(data, base + offset, kind, count, value, what);
  return setNumber(data, base + offset, kind, group ? constant(group, value, what) : value, what);
}

/** Sets up the struct at an address with all defaults, and changes the fields that `options` names. */
export function write(call, address, name, options, what = name) {
  const { size, sized, fields } = layoutOf(name);
  if (sized) call.library.raw[`${name}_init`](address, size);
  for (const [key, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (!Object.hasOwn(fields, key))
      throw new TypeError(`${what} has no option "${key}"; choose one of ${Object.keys(fields).join(", ")}`);
    setField(call, address, fields[key], value, `${what}.${key}`);
  }
}

function readList(library, address, [, offset, name, count, stride]) {
  const { data } = library.views;
  const first = data.getUint32(address + offset, true);
  if (first === 0) return undefined;
  const step = Number(data.getBigInt64(address + stride, true)) || data.getUint32(first, true);
  return Array.from({ length: Number(data.getBigInt64(address + count, true)) },
                    (_, at) => read(library, first + at * step, name));
}

function readNumber(data, address, kind) {
  return Number(data[GET[kind]](address, true));
}

function readField(library, address, layout) {
  const [kind, offset, count, group] = layout;
  const { data } = library.views;
  if (kind === "list") return readList(library, address, layout);
  if (kind === "text") return library.text(data.getUint32(address + offset, true));
  if (kind === "chars") return library.text(address + offset);
  if (!GET[kind]) return undefined; // the caller reads arrays, callbacks and handles
  if (count)
    return Array.from({ length: count }, (_, at) => readNumber(data, address + offset + at * SIZES[kind], kind));
  const value = readNumber(data, address + offset, kind);
  if (!group) return value;
  return Object.keys(GROUPS[group]).filter((name) => GROUPS[group][name] === value).map(word)[0] ?? value;
}

/** Reads the struct at an address as a plain object. */
export function read(library, address, name) {
  const result = {};
  for (const [key, layout] of Object.entries(layoutOf(name).fields)) {
    const value = readField(library, address, layout);
    if (value !== undefined) result[key] = value;
  }
  return result;
}

export const sizeOf = (name) => layoutOf(name).size;
