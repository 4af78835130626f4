// SPDX-License-Identifier: MIT
// The shape in a file: { kind: "mesh", vertices, triangles, sharpEdges } or { kind: "cloud", points, normals }, flat arrays.

/** The error of a file that cannot be read. It says where, and what would be right. */
export class ShapeError extends Error {
  /** @param {number} [line] counted from 1 */
  constructor(message, line) {
    super(line === undefined ? message : `line ${line}: ${message}`);
    this.name = "ShapeError";
    this.line = line;
  }
}

export function number(word, what, line) {
  const value = Number(word);
  if (word === undefined || word === "" || !Number.isFinite(value))
    throw new ShapeError(`${what} is ${word === undefined ? "missing" : `"${word}"`}; it must be a number`, line);
  return value;
}

/** Adds a polygon as triangles that share its first corner. */
export function addPolygon(triangles, corners, line) {
  if (corners.length < 3) throw new ShapeError(`a face has ${corners.length} corners; it needs at least 3`, line);
  for (let at = 2; at < corners.length; ++at) triangles.push(corners[0], corners[at - 1], corners[at]);
}

/**
 * Returns a mesh if there are faces, or else a cloud; with normals only if each point has one. Calls
 * sharpEdges(vertices, triangles) for a mesh.
 */
export function shapeOf(points, triangles, normals = [], sharpEdges = () => undefined) {
  if (points.length === 0) throw new ShapeError("the file has no points");
  const place = points.findIndex((value) => !Number.isFinite(value));
  if (place >= 0) throw new ShapeError(`point ${Math.floor(place / 3)} is not finite; remove it`);
  if (triangles.length > 0)
    return { kind: "mesh", vertices: Float64Array.from(points), triangles: Int32Array.from(triangles),
             sharpEdges: sharpEdges(points, triangles) };
  return { kind: "cloud", points: Float64Array.from(points),
           normals: normals.length === points.length ? Float64Array.from(normals) : undefined };
}

export const textOf = (bytes) => new TextDecoder().decode(bytes);
