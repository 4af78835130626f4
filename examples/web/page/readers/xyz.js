// SPDX-License-Identifier: MIT
import { ShapeError, number, shapeOf, textOf } from "./shape.js";

/** Reads rows of x y z, or of x y z nx ny nz. A first row of words is a heading, and is skipped. */
export function readXyz(bytes) {
  const points = [];
  const normals = [];
  let columns = 0;
  textOf(bytes).split("\n").forEach((text, at) => {
    const words = text.split(/#|\/\//)[0].trim().split(/[\s,;]+/).filter((word) => word !== "");
    if (words.length === 0 || (columns === 0 && words.every((word) => Number.isNaN(Number(word))))) return;
    columns ||= words.length;
    if (words.length < 3 || words.length !== columns)
      throw new ShapeError(`there are ${words.length} columns` +
        (columns >= 3 ? `, but ${columns} in the rows before` : "") + "; each row must have x y z, or x y z nx ny nz", at + 1);
    points.push(...words.slice(0, 3).map((word, axis) => number(word, "xyz"[axis], at + 1)));
    if (columns === 6) normals.push(...words.slice(3).map((word, axis) => number(word, `n${"xyz"[axis]}`, at + 1)));
  });
  return shapeOf(points, [], normals);
}
