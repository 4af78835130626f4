// SPDX-License-Identifier: MIT
// Which edges of a mesh are sharp by the normals of its file: those whose two faces have normals of their own there.

const MOST_FACES = 50000; // edges of finer meshes are told from their faces
const OWN = Math.cos(Math.PI / 180); // normals that differ by more than a degree are not shared

/** A number for each vertex; those at the same place have the same one. */
function placesOf(points) {
  const numbers = new Map();
  return Array.from({ length: points.length / 3 }, (_, vertex) => {
    const place = points.slice(3 * vertex, 3 * vertex + 3).join(" ");
    if (!numbers.has(place)) numbers.set(place, numbers.size);
    return numbers.get(place);
  });
}

/** The cosine of the angle between two of the normals; NaN if one of them is zero. */
function cosine(normals, a, b) {
  const [first, second] = [a, b].map((at) => normals.slice(3 * at, 3 * at + 3));
  return first.reduce((sum, part, axis) => sum + part * second[axis], 0) / (Math.hypot(...first) * Math.hypot(...second));
}

/**
 * Pairs of vertices, one after the other; undefined where the normals tell nothing.
 * @param {number[]} shading the number of the normal at each corner of the triangles
 */
export function edgesByNormals(points, triangles, normals, shading) {
  if (triangles.length > 3 * MOST_FACES) return undefined;
  const places = placesOf(points);
  const edges = new Map(); // by its places, the sides of triangles that lie on it
  for (let corner = 0; corner < triangles.length; ++corner) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [from, to] = [places[triangles[corner]], places[triangles[next]]];
    if (from === to) continue;
    const [low, high] = from < to ? [corner, next] : [next, corner];
    const name = `${Math.min(from, to)} ${Math.max(from, to)}`;
    if (!edges.has(name)) edges.set(name, []);
    edges.get(name).push({ low, high, ends: [triangles[corner], triangles[next]] });
  }
  const sharp = [];
  let isKnown = false;
  for (const sides of edges.values()) {
    if (sides.length !== 2) continue;
    const cosines = ["low", "high"].map((end) => cosine(normals, shading[sides[0][end]], shading[sides[1][end]]));
    if (!cosines.every(Number.isFinite)) continue;
    isKnown = true;
    if (Math.min(...cosines) < OWN) sharp.push(...sides[0].ends);
  }
  return isKnown ? Int32Array.from(sharp) : undefined;
}
