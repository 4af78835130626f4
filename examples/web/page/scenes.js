// SPDX-License-Identifier: MIT
// The surfaces of the page: CSG solids, and one formula in JavaScript.

const move = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
// Turns the z axis of a primitive to the y axis of the scene, which is up.
const upright = (x = 0, y = 0, z = 0) => [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, x, y, z, 1];

const torus = [{ kind: "torus", radius: 1, secondRadius: 0.42, transform: upright() }];

const cup = [
  { kind: "union", blend: 0.12 },
  { kind: "difference", parent: 0, blend: 0.06 },
  { kind: "cylinder", parent: 1, radius: 0.8, height: 1.7, transform: upright() },
  { kind: "cylinder", parent: 1, radius: 0.68, height: 1.7, transform: upright(0, 0.14) },
  { kind: "difference", parent: 0 },
  { kind: "torus", parent: 4, radius: 0.45, secondRadius: 0.11, transform: move(0.85, 0.02, 0) },
  { kind: "cylinder", parent: 4, radius: 0.72, height: 3, transform: upright() },
];

const blob = [
  { kind: "union", blend: 0.5 },
  { kind: "sphere", parent: 0, radius: 0.75 },
  { kind: "sphere", parent: 0, radius: 0.45, transform: move(0.85, 0.45, 0.1) },
  { kind: "sphere", parent: 0, radius: 0.38, transform: move(-0.8, 0.35, 0.35) },
  { kind: "sphere", parent: 0, radius: 0.5, transform: move(-0.2, -0.8, 0.3) },
  { kind: "torus", parent: 0, radius: 0.5, secondRadius: 0.16, transform: move(0.2, 0.95, -0.2) },
];

const part = [
  { kind: "difference" },
  { kind: "union", parent: 0, blend: 0.12 },
  { kind: "box", parent: 1, size: [2.2, 0.4, 1.3], transform: move(0, -0.45, 0) },
  { kind: "cylinder", parent: 1, radius: 0.5, height: 1.3, transform: upright(0, 0.1) },
  { kind: "cylinder", parent: 0, radius: 0.3, height: 3, transform: upright() },
  { kind: "cylinder", parent: 0, radius: 0.16, height: 3, transform: upright(0.8) },
  { kind: "cylinder", parent: 0, radius: 0.16, height: 3, transform: upright(-0.8) },
];

/**
 * The tangle cube, x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 11.8, divided by its slope, so that values near the surface are
 * roughly distances.
 */
function tangle(points, { value, gradient }) {
  for (let at = 0; at < value.length; ++at) {
    let sum = 11.8;
    const slope = [0, 0, 0];
    for (let axis = 0; axis < 3; ++axis) {
      const x = points[3 * at + axis];
      sum += x ** 4 - 5 * x ** 2;
      slope[axis] = 4 * x ** 3 - 10 * x;
    }
    const scale = 1 / 9; // 9 is about the slope at the surface.
    value[at] = sum * scale;
    if (gradient) gradient.set(slope.map((part) => part * scale), 3 * at);
  }
}

const CUSTOM_HAS_GRADIENT = 1;

/** Names and titles. "bunny" is a fitted model in a file of the page. */
export const SCENES = {
  bunny: { title: "Stanford bunny", file: "bunny.model" },
  blob: { title: "Blended spheres", nodes: blob },
  cup: { title: "Cup", nodes: cup },
  part: { title: "Machine part", nodes: part },
  torus: { title: "Torus", nodes: torus },
  tangle: { title: "Tangle cube", custom: { function: tangle, flags: CUSTOM_HAS_GRADIENT,
                                                       boundsMin: [-2.6, -2.6, -2.6], boundsMax: [2.6, 2.6, 2.6] } },
};

/** Makes the model of a scene that has no file. */
export function buildScene(context, name) {
  const { nodes, custom } = SCENES[name];
  return nodes ? context.createCsg(nodes) : context.createCustom(custom);
}
