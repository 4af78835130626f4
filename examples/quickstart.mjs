// SPDX-License-Identifier: MIT
// Draws 192 samples of a torus in pen and ink: as pixels for ImageData, and as torus.svg.
import { writeFile } from "node:fs/promises";
import { load } from "hrbfnpr";

const points = [];
const normals = [];
for (let i = 0; i < 192; ++i) {
  const a = 2 * Math.PI * Math.floor(i / 8) / 24;
  const b = 2 * Math.PI * (i % 8) / 8;
  const normal = [Math.cos(a) * Math.cos(b), Math.sin(a) * Math.cos(b), Math.sin(b)];
  normals.push(normal);
  points.push([Math.cos(a) + 0.4 * normal[0], Math.sin(a) + 0.4 * normal[1], 0.4 * normal[2]]);
}

const context = (await load()).createContext();
const picture = context.draw({ points, normals }, { style: "engraving", width: 800, height: 600 });
const { width, height, data } = picture.rasterize();
await writeFile("torus.svg", picture.toSVG());
console.log(`${width} x ${height} pixels, ${data.length} bytes`);
