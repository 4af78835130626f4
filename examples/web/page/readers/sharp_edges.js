// SPDX-License-Identifier: MIT
// Finds the sharp edges of a mesh from the normals in its file: those at which the two faces have different normals.

const MOST_FACES = 50000; // In larger meshes the library finds sharp edges from the faces.
const OWN = Math.cos(Math.PI / 180); // Normals that differ by more than a degree are different.

/** Numbers the vertices; vertices at the same place have the same number. */
function placesOf(points) {
  const numbers = new Map();
  return Array.from({ length: points.length / 3 }, (_, vertex) => {
    const place = points.slice(3 * vertex, 3 * vertex + 3).join(" ");
    if (!numbers.has(place)) numbers.set(place, numbers.size);
    return numbers.get(place);
  });
}

/** Returns the cosine of the angle between two normals, or NaN if one of them is zero. */
function cosine(normals, a, b) {
  const [first, second] = [a, b].map((at) => normals.slice(3 * at, 3 * at + 3));
  return first.reduce((sum, part, axis) => sum + part * second[axis], 0) / (Math.hypot(...first) * Math.hypot(...second));
}

/**
 * Returns pairs of vertices, one after the other, or undefined if the normals tell nothing.
 * @param {number[]} shading the number of the normal at each corner of the triangles
 */
export function edgesByNormals(points, triangles, normals, shading) {
  if (triangles.length > 3 * MOST_FACES) return undefined;
  const places = placesOf(points);
  const edges = new Map(); // the sides of triangles on each edge, by the places of its ends
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
