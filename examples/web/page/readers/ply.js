// SPDX-License-Identifier: MIT
import { edgesByNormals } from "./sharp_edges.js";
import { ShapeError, addPolygon, number, shapeOf, textOf } from "./shape.js";

const SIZES = { char: 1, int8: 1, uchar: 1, uint8: 1, short: 2, int16: 2, ushort: 2, uint16: 2, int: 4, int32: 4,
                uint: 4, uint32: 4, float: 4, float32: 4, double: 8, float64: 8 };
const READERS = { char: "getInt8", int8: "getInt8", uchar: "getUint8", uint8: "getUint8", short: "getInt16",
                  int16: "getInt16", ushort: "getUint16", uint16: "getUint16", int: "getInt32", int32: "getInt32",
                  uint: "getUint32", uint32: "getUint32", float: "getFloat32", float32: "getFloat32",
                  double: "getFloat64", float64: "getFloat64" };
const FORMATS = ["ascii", "binary_little_endian", "binary_big_endian"];

function property(words, line) {
  const [, type, ...rest] = words;
  const types = type === "list" ? rest.slice(0, 2) : [type];
  const wrong = types.find((one) => !SIZES[one]);
  if (wrong !== undefined) throw new ShapeError(`a property has the type "${wrong}"; use one of ${Object.keys(SIZES).join(", ")}`, line);
  return { name: rest.at(-1), type: types.at(-1), count: type === "list" ? types[0] : undefined };
}

function headerOf(bytes) {
  const end = textOf(bytes.subarray(0, 65536)).match(/^end_header[ \t]*\r?\n/m);
  if (!end) throw new ShapeError('the header has no "end_header"; the file is cut off, or is not a PLY file');
  const lines = textOf(bytes.subarray(0, end.index)).split("\n");
  const header = { elements: [], body: new TextEncoder().encode(lines.join("\n")).length + end[0].length, line: lines.length + 1 };
  lines.forEach((text, at) => {
    const words = text.trim().split(/\s+/);
    if (words[0] === "format") header.format = words[1];
    if (words[0] === "element") header.elements.push({ name: words[1], count: number(words[2], "a count", at + 1), properties: [] });
    if (words[0] !== "property") return;
    if (header.elements.length === 0) throw new ShapeError("a property is before the first element", at + 1);
    header.elements.at(-1).properties.push(property(words, at + 1));
  });
  if (!FORMATS.includes(header.format))
    throw new ShapeError(`the format is "${header.format}"; it must be one of ${FORMATS.join(", ")}`);
  return header;
}

/** Reads numbers one after the other from lines of text. */
function textSource(bytes, header) {
  const lines = textOf(bytes.subarray(header.body)).split("\n");
  let line = -1;
  let words = [];
  return {
    begin() {
      do line += 1; while (line < lines.length && lines[line].trim() === "");
      if (line >= lines.length)
        throw new ShapeError("the file ends before the last element of its header; it is cut off", header.line + line);
      words = lines[line].trim().split(/\s+/).reverse();
    },
    next: (type, name) => number(words.pop(), name, header.line + line),
    get line() { return header.line + line; },
  };
}

function binarySource(bytes, header) {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const little = header.format === "binary_little_endian";
  let at = header.body;
  return {
    begin() {},
    next(type) {
      if (at + SIZES[type] > bytes.length)
        throw new ShapeError(`the file ends at byte ${bytes.length}, before the last element of its header; it is cut off`);
      const value = data[READERS[type]](at, little);
      at += SIZES[type];
      return value;
    },
    line: undefined,
  };
}

function elementOf(source, properties) {
  source.begin();
  const element = {};
  for (const { name, type, count } of properties) {
    element[name] = count === undefined ? source.next(type, name)
      : Array.from({ length: source.next(count, `the length of ${name}`) }, () => source.next(type, name));
  }
  return element;
}

export function readPly(bytes) {
  const header = headerOf(bytes);
  const source = header.format === "ascii" ? textSource(bytes, header) : binarySource(bytes, header);
  const points = [];
  const normals = [];
  const triangles = [];
  for (const { name, count, properties } of header.elements) {
    if (name === "vertex" && !["x", "y", "z"].every((axis) => properties.some((one) => one.name === axis)))
      throw new ShapeError("the vertices need the properties x, y and z");
    for (let at = 0; at < count; ++at) {
      const element = elementOf(source, properties);
      if (name === "vertex") {
        points.push(element.x, element.y, element.z);
        if (element.nx !== undefined) normals.push(element.nx, element.ny, element.nz);
      } else if (name === "face") {
        const corners = element.vertex_indices ?? element.vertex_index;
        if (!corners) throw new ShapeError("the faces need the list property vertex_indices");
        const wrong = corners.find((corner) => corner < 0 || corner >= points.length / 3);
        if (wrong !== undefined)
          throw new ShapeError(`face ${at} has the corner ${wrong}, but there are ${points.length / 3} vertices, counted from 0`, source.line);
        addPolygon(triangles, corners, source.line);
      }
    }
  }
  return shapeOf(points, triangles, normals, () => (normals.length === points.length
    ? edgesByNormals(points, triangles, normals, triangles) : undefined));
}
