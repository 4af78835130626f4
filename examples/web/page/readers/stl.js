// SPDX-License-Identifier: MIT
import { ShapeError, number, shapeOf, textOf } from "./shape.js";

const HEADER = 84;
const FACET = 50;

function readBinary(bytes, count) {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const points = [];
  for (let facet = 0; facet < count; ++facet)
    for (let at = 0; at < 9; ++at) points.push(data.getFloat32(HEADER + facet * FACET + 12 + 4 * at, true));
  return points;
}

function readText(bytes) {
  const points = [];
  textOf(bytes).split("\n").forEach((text, at) => {
    const words = text.trim().split(/\s+/);
    if (words[0]?.toLowerCase() !== "vertex") return;
    points.push(...[1, 2, 3].map((axis) => number(words[axis], `vertex ${"xyz"[axis - 1]}`, at + 1)));
  });
  return points;
}

export function readStl(bytes) {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length >= HEADER ? data.getUint32(80, true) : -1;
  const isBinary = bytes.length === HEADER + FACET * count;
  const startsAsText = textOf(bytes.subarray(0, 6)).toLowerCase().startsWith("solid");
  if (!isBinary && !startsAsText) {
    const needed = count < 0 ? `${HEADER} bytes for its header` : `${HEADER + FACET * count} bytes for its ${count} facets`;
    throw new ShapeError(`the STL file needs ${needed}, but it has ${bytes.length}; it is cut off, or is not an STL file`);
  }
  const points = isBinary ? readBinary(bytes, count) : readText(bytes);
  if (points.length === 0) throw new ShapeError("the STL file has no facets");
  if (points.length % 9 !== 0)
    throw new ShapeError(`the STL file has ${points.length / 3} vertices, but each facet needs 3; it may be cut off`);
  return shapeOf(points, Array.from({ length: points.length / 3 }, (_, corner) => corner));
}
