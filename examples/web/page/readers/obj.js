// SPDX-License-Identifier: MIT
import { edgesByNormals } from "./sharp_edges.js";
import { ShapeError, addPolygon, number, shapeOf, textOf } from "./shape.js";

function three(words, what, line) {
  return [1, 2, 3].map((at) => number(words[at], `${what} ${"xyz"[at - 1]}`, line));
}

/** Returns the vertex of a corner such as "7", "7/1/2" or "-1", counted from 0. */
function corner(word, count, line) {
  const given = number(word.split("/")[0], "a face's corner", line);
  const index = given < 0 ? count + given : given - 1;
  if (!Number.isInteger(given) || index < 0 || index >= count)
    throw new ShapeError(`a face has the corner ${given}, but there are only ${count} vertices before it, counted from 1`, line);
  return index;
}

/** Returns the normal of a corner such as "7/1/2" or "7//-1", counted from 0, or -1. Normals are hints: none is an error. */
function normalOf(word, count) {
  const given = Number(word.split("/")[2] || Number.NaN);
  const index = given < 0 ? count + given : given - 1;
  return Number.isInteger(index) && index >= 0 && index < count ? index : -1;
}

export function readObj(bytes) {
  const points = [];
  const normals = [];
  const triangles = [];
  const shading = []; // the normal of each corner
  textOf(bytes).split("\n").forEach((text, at) => {
    const words = text.split("#")[0].trim().split(/\s+/);
    if (words[0] === "v") points.push(...three(words, "vertex", at + 1));
    if (words[0] === "vn") normals.push(...three(words, "normal", at + 1));
    if (words[0] !== "f") return;
    addPolygon(triangles, words.slice(1).map((word) => corner(word, points.length / 3, at + 1)), at + 1);
    addPolygon(shading, words.slice(1).map((word) => normalOf(word, normals.length / 3)), at + 1);
  });
  return shapeOf(points, triangles, normals, () => (shading.includes(-1)
    ? undefined : edgesByNormals(points, triangles, normals, shading)));
}
