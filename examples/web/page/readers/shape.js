// SPDX-License-Identifier: MIT
// What a file holds: { kind: "mesh", vertices, triangles, sharpEdges } or { kind: "cloud", points, normals }, flat arrays.

/** A file that cannot be read: says where, and what would be right. */
export class ShapeError extends Error {
  /** @param {number} [line] from 1 */
  constructor(message, line) {
    super(line === undefined ? message : `line ${line}: ${message}`);
    this.name = "ShapeError";
    this.line = line;
  }
}

export function number(word, what, line) {
  const value = Number(word);
  if (word === undefined || word === "" || !Number.isFinite(value))
    throw new ShapeError(`${what} must be a number, not ${word === undefined ? "missing" : `"${word}"`}`, line);
  return value;
}

/** Corners of a polygon as triangles from its first one. */
export function addPolygon(triangles, corners, line) {
  if (corners.length < 3) throw new ShapeError(`a face has ${corners.length} corners: it takes 3 or more`, line);
  for (let at = 2; at < corners.length; ++at) triangles.push(corners[0], corners[at - 1], corners[at]);
}

/** A mesh if there are faces, else a cloud; normals only if each point has one.  sharpEdges(vertices, triangles) is asked of
 *  a mesh. */
export function shapeOf(points, triangles, normals = [], sharpEdges = () => undefined) {
  if (points.length === 0) throw new ShapeError("the file has no points: it needs some with x, y and z");
  const place = points.findIndex((value) => !Number.isFinite(value));
  if (place >= 0) throw new ShapeError(`point ${Math.floor(place / 3)} is not finite: leave it out`);
  if (triangles.length > 0)
    return { kind: "mesh", vertices: Float64Array.from(points), triangles: Int32Array.from(triangles),
             sharpEdges: sharpEdges(points, triangles) };
  return { kind: "cloud", points: Float64Array.from(points),
           normals: normals.length === points.length ? Float64Array.from(normals) : undefined };
}

export const textOf = (bytes) => new TextDecoder().decode(bytes);
