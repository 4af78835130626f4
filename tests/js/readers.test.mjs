// SPDX-License-Identifier: MIT
// The page's readers give the same tetrahedron from each format, and report errors in files.
import assert from "node:assert/strict";
import test from "node:test";
import { readShape } from "../../examples/web/page/readers/read.js";

const POINTS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
const bytes = (text) => new TextEncoder().encode(text);
const read = (name, text) => readShape(name, typeof text === "string" ? bytes(text) : text);

function cornersOf({ vertices, triangles }) {
  return Array.from(triangles, (corner) => Array.from(vertices.slice(3 * corner, 3 * corner + 3)));
}
const CORNERS = FACES.flat().map((corner) => POINTS[corner]);

function fails(name, text, pattern) {
  assert.throws(() => read(name, text), (error) => {
    assert.equal(error.name, "ShapeError");
    assert.match(error.message, pattern);
    return true;
  });
}

const plyHeader = (format, faceType = "uchar") => ["ply", `format ${format} 1.0`, "comment a tetrahedron", "element vertex 4",
  "property float x", "property float y", "property float z", "property uchar red", "element face 4",
  `property list ${faceType} int vertex_indices`, "end_header", ""].join("\n");
const asciiPly = plyHeader("ascii") + POINTS.map((p) => `${p.join(" ")} 255\n`).join("") +
  FACES.map((f) => `3 ${f.join(" ")}\n`).join("");

function binaryPly(little) {
  const header = bytes(plyHeader(little ? "binary_little_endian" : "binary_big_endian"));
  const whole = new Uint8Array(header.length + 4 * 13 + 4 * 13);
  whole.set(header);
  const data = new DataView(whole.buffer);
  let at = header.length;
  for (const point of POINTS) {
    point.forEach((value, axis) => data.setFloat32(at + 4 * axis, value, little));
    data.setUint8(at + 12, 255);
    at += 13;
  }
  for (const face of FACES) {
    data.setUint8(at, 3);
    face.forEach((corner, k) => data.setInt32(at + 1 + 4 * k, corner, little));
    at += 13;
  }
  return whole;
}

function binaryStl() {
  const whole = new Uint8Array(84 + 50 * FACES.length);
  const data = new DataView(whole.buffer);
  data.setUint32(80, FACES.length, true);
  FACES.forEach((face, number) => face.forEach((corner, k) => POINTS[corner].forEach((value, axis) =>
    data.setFloat32(84 + 50 * number + 12 + 12 * k + 4 * axis, value, true))));
  return whole;
}

const asciiStl = "solid t\n" + FACES.map((face) => "facet normal 0 0 0\nouter loop\n" +
  face.map((corner) => `vertex ${POINTS[corner].join(" ")}\n`).join("") + "endloop\nendfacet\n").join("") + "endsolid t\n";

test("PLY, OBJ and STL give the same triangles", () => {
  const obj = POINTS.map((p) => `v ${p.join(" ")}\n`).join("") + FACES.map((f) => `f ${f.map((c) => `${c + 1}/1/1`).join(" ")}\n`).join("");
  const shapes = { "a.ply": asciiPly, "b.PLY": binaryPly(true), "c.ply": binaryPly(false), "a.obj": obj, "a.stl": asciiStl, "b.stl": binaryStl() };
  for (const [name, text] of Object.entries(shapes)) {
    const shape = read(name, text);
    assert.equal(shape.kind, "mesh", name);
    assert.deepEqual(cornersOf(shape), CORNERS, name);
  }
});

test("polygons become triangles, negative corners count from the end", () => {
  const shape = read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n");
  assert.deepEqual(Array.from(shape.triangles), [0, 1, 2, 0, 2, 3]);
});

test("clouds come with their normals, or without", () => {
  assert.deepEqual(Array.from(read("a.xyz", "# heading\nx y z nx ny nz\n1,2,3,0,0,1\n4;5;6;0;1;0\n").normals), [0, 0, 1, 0, 1, 0]);
  const bare = read("a.txt", "1 2 3\n\n4 5 6\r\n");
  assert.equal(bare.kind, "cloud");
  assert.equal(bare.normals, undefined);
  assert.deepEqual(Array.from(bare.points), [1, 2, 3, 4, 5, 6]);
  assert.equal(read("b.ply", asciiPly.replace("element face 4\nproperty list uchar int vertex_indices\n", "")).kind, "cloud");
});

test("what is wrong is named by its line, with the remedy", () => {
  fails("a.xyz", "1 2 3\n1 2\n", /a\.xyz, line 2: there are 2 columns, but 3 in the rows before; each row must have x y z/);
  fails("a.xyz", "1 2 3\n1 two 3\n", /line 2: y is "two"; it must be a number/);
  fails("a.obj", "v 0 0 0\nv 1 0\n", /line 2: vertex z is missing; it must be a number/);
  fails("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", /line 3: a face has 2 corners; it needs at least 3/);
  fails("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", /line 3: a face has the corner 3, but there are only 2 vertices/);
  fails("a.obj", "f 1.5 2 3\n", /corner 1.5/);
  fails("a.obj", "", /a\.obj is empty/);
  fails("a.obj", "# nothing\n", /no points/);
  fails("a.png", "x", /files that end in "\.png" cannot be read; convert it to \.ply/);
});

test("a PLY that is cut off or odd is refused", () => {
  fails("a.ply", asciiPly.slice(0, 40), /no "end_header"/);
  fails("a.ply", asciiPly.split("\n").slice(0, -3).join("\n"), /line 18: the file ends before the last/);
  fails("a.ply", binaryPly(true).slice(0, -5), /the file ends at byte \d+/);
  fails("a.ply", asciiPly.replace("ascii 1.0", "text 1.0"), /the format is "text"/);
  fails("a.ply", asciiPly.replace("property float y", "property float w"), /need the properties x, y and z/);
  fails("a.ply", asciiPly.replace("3 0 2 1", "3 0 2 9"), /line 16: face 0 has the corner 9/);
  fails("a.ply", asciiPly.replace("property float x", "property real x"), /the type "real"/);
});

test("an STL whose size is wrong is refused", () => {
  fails("a.stl", binaryStl().slice(0, -10), /needs 284 bytes for its 4 facets, but it has 274/);
  fails("a.stl", "short", /needs 84 bytes for its header, but it has 5/);
  fails("a.stl", "solid\nvertex 0 0 0\nvertex 1 0 0\n", /2 vertices, but each facet needs 3/);
});

test("edges between faces with different normals are sharp", () => {
  const places = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 -1\nvn 0 -1 0\n";
  const bent = read("a.obj", `${places}f 1//1 3//1 2//1\nf 1//2 2//2 4//2\n`);
  assert.deepEqual(Array.from(bent.sharpEdges).sort(), [0, 1]);
  assert.equal(read("a.obj", `${places}f 1//1 3//1 2//1\nf 1//1 2//1 4//1\n`).sharpEdges.length, 0);
  assert.equal(read("a.obj", `${places}f 1 3 2\nf 1//2 2//2 4//2\n`).sharpEdges, undefined);
  const rows = ["0 0 0 0 0 -1", "1 0 0 0 0 -1", "0 1 0 0 0 -1", "0 0 0 0 -1 0", "1 0 0 0 -1 0", "0 0 1 0 -1 0"];
  const ply = ["ply", "format ascii 1.0", "element vertex 6", ...["x", "y", "z", "nx", "ny", "nz"].map((name) => `property float ${name}`),
               "element face 2", "property list uchar int vertex_indices", "end_header", ...rows, "3 0 2 1", "3 3 4 5", ""].join("\n");
  assert.deepEqual(Array.from(read("a.ply", ply).sharpEdges).sort(), [0, 1]);
});
