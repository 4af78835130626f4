// SPDX-License-Identifier: MIT
// Tests the package as npm installs it from its tarball.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import * as hrbfnpr from "hrbfnpr";

const { HrbfnprError, KERNEL, STATUS, load } = hrbfnpr;
const library = await load();
const context = library.createContext({ threadCount: 1 });

/** Samples of the unit sphere. */
function sphere(count) {
  const points = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const z = 1 - (2 * i + 1) / count;
    const angle = i * Math.PI * (3 - Math.sqrt(5));
    points.set([Math.sqrt(1 - z * z) * Math.cos(angle), Math.sqrt(1 - z * z) * Math.sin(angle), z], 3 * i);
  }
  return points;
}
const points = sphere(200);
const ball = context.fit({ points, normals: points });
const marks = ball.generate({ preset: "contour-and-stipple", layers: [{ budget: 3000 }] });
const camera = library.createCamera().fitBounds([-1, -1, -1], [1, 1, 1], { width: 160, height: 120 });

function fails(work, status, pattern) {
  assert.throws(work, (error) => {
    assert.ok(error instanceof HrbfnprError, String(error));
    assert.equal(error.statusName, status);
    assert.match(error.message, pattern);
    return true;
  });
}

test("version, build and layouts are those of the package", async () => {
  const described = JSON.parse(await readFile(new URL("node_modules/hrbfnpr/package.json", import.meta.url)));
  assert.equal(library.version, described.version);
  assert.equal(library.buildInfo().version, library.version);
  library.checkLayouts();
  assert.equal(library.layout("hrbfnpr_nothing"), undefined);
});

test("every struct's size is the module's, and every function is there", async () => {
  const { STRUCTS } = await import(new URL("node_modules/hrbfnpr/src/generated/layout.js", import.meta.url));
  const { FUNCTIONS } = await import(new URL("node_modules/hrbfnpr/src/generated/functions.js", import.meta.url));
  for (const [name, { size }] of Object.entries(STRUCTS)) assert.equal(library.layout(name).size, size, name);
  for (const name of Object.keys(FUNCTIONS)) assert.equal(typeof library.raw[name], "function", name);
});

test("a fit of a sphere is a sphere", () => {
  const { value, gradient } = ball.evaluate([[0, 0, 0], [0, 0, 1.5]], { gradient: true });
  assert.ok(value[0] < -0.5 && value[1] > 0.3);
  assert.ok(Math.abs(gradient[5]) > 0.5 && Math.abs(gradient[3]) < 0.05);
  const { position, converged } = ball.project(new Float32Array([0.2, 0.3, 0.9]));
  assert.equal(converged, 1);
  assert.ok(Math.abs(Math.hypot(...position) - 1) < 0.01);
  assert.ok(Math.abs(ball.curvature([0, 0, 1]).k1[0] + 1) < 0.1);
  const rays = ball.castRays([[0, 0, 5]], [[0, 0, -1]], { maximumHits: 2 });
  assert.deepEqual([...rays.count], [2]);
  assert.ok(Math.abs(rays.t[0] - 4) < 0.01 && Math.abs(rays.t[1] - 6) < 0.01);
  const lineSet = ball.createLineSet();
  const byMesh = ball.castRays([[0, 0, 5]], [[0, 0, -1]], { maximumHits: 2, lineSet });
  assert.ok(Math.abs(byMesh.t[1] - rays.t[1]) < 1e-6);
  lineSet.free();
  assert.deepEqual([...ball.contains([[0, 0, 0], [2, 0, 0]])], [1, 0]);
  assert.equal(ball.info().kernel, "triharmonic");
  assert.equal(context.fit({ points, normals: points, kernel: KERNEL.GAUSSIAN }).info().kernel, "gaussian");
  assert.ok(ball.lipschitz() > 0.9);
});

test("every preset draws", () => {
  const renderer = context.createRenderer();
  const lineSet = ball.createLineSet(); // some presets draw only lines
  for (const preset of library.presetNames) {
    const layers = library.presetLayers(preset).map((layer) => ({ ...layer, budget: 2000 }));
    const set = ball.generate({ layers });
    const drawing = renderer.draw({ pointSet: set, lineSet, style: library.style(preset) }, camera);
    const { data, width, height } = drawing.rasterize();
    assert.deepEqual([width, height, data.length], [160, 120, 4 * 160 * 120]);
    const darkest = Math.min(...data.filter((_, at) => at % 4 === 0));
    const lightest = Math.max(...data.filter((_, at) => at % 4 === 0));
    assert.ok(lightest - darkest > 100, preset);
    for (const handle of [drawing, set]) handle.free();
  }
  lineSet.free();
});

test("lights, occluders and shadings", () => {
  const renderer = context.createRenderer();
  const lineSet = ball.createLineSet();
  const style = { ...library.style(), fillLight: 0, toneFade: 0 };
  const view = library.createCamera().fitBounds([-1, -3.2, -1], [1, 1, 1], { width: 120, height: 240 });
  const shown = (item) => {
    const drawing = renderer.draw(item, view);
    const count = drawing.info().shown;
    drawing.free();
    return count;
  };
  const above = { pointSet: marks, style, lineSet };
  const below = { ...above, transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2.2, 0, 1] };
  const alone = shown(above);
  style.lights = [{}];
  assert.equal(shown(above), alone);
  style.lights = [{ place: [0, 1, 0], space: "world", shadow: 1 }];
  style.ambientSky = 0.2;
  const open = shown(below);
  const progress = [];
  const occluders = context.createOccluders([above, below], { onProgress: (at) => void progress.push(at) });
  below.shading = occluders.createShading(below, { skyRays: 16 }, { onProgress: (at) => void progress.push(at) });
  assert.ok(progress.length >= 2 && progress.at(-1) === 1);
  const closed = shown(below);
  assert.ok(closed > open, `${closed} and ${open} marks`);
  const moved = context.createShading(occluders, below, { previous: below.shading });
  assert.equal(shown({ ...below, shading: moved }), closed);
  moved.free();
  style.occlusion = 0;
  assert.ok(shown(below) < closed);
  below.shading.free();
  assert.throws(() => shown(below), /this shading has been freed/);
  style.lights[0].space = "camera";
  assert.throws(() => context.createShading(occluders, below), /camera/);
  below.shading = context.createShading(occluders, below, { camera: view });
  assert.throws(() => context.createOccluders({ pointSet: marks }), /line_set/);
  assert.throws(() => context.createShading(occluders, below, { camera: view, skyRays: 0 }), /sky_rays/);
  assert.throws(() => context.createShading(occluders, below, { rays: 1 }), /no option "rays"/);
  assert.throws(() => context.createOccluders(above, { onProgress: () => false }), (error) => error.isCancelled);
  style.lights.push({ kind: "lamp" });
  assert.throws(() => shown(below), /items\[0\]\.style\.lights\[1\]\.kind is "lamp"/);
  for (const handle of [below.shading, occluders, lineSet, renderer]) handle.free();
});

test("fields", () => {
  const corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0]];
  const heat = context.createField({ points: corners, values: [10, 50, 10], triangles: [[0, 1, 2]], range: [10, 50] });
  assert.equal(heat.fieldKind, "scalar");
  const { values, weights } = heat.evaluate([[1, 1, 5], [-3, 0, 0]]);
  assert.ok(Math.abs(values[0] - 0.25) < 1e-12 && values[1] === 0);
  assert.deepEqual([...weights], [1, 1]);
  let calls = 0;
  const colour = context.createField({ kind: "colour", function: (positions, normals, out) => {
    ++calls;
    out.values.set(normals.map(Math.abs));
    out.weights.fill(0.5);
  } });
  const painted = marks.withFields({ heat, colour });
  assert.ok(calls > 0);
  assert.deepEqual(painted.fields(), { heat: "scalar", colour: "colour" });
  assert.deepEqual(marks.fields(), {});
  const normals = marks.view(0, "normal");
  const at = painted.field(0, "colour");
  assert.equal(at.values.length, normals.length);
  assert.ok(at.values.every((value, i) => Math.abs(value - Math.abs(normals[i])) < 1e-5));
  assert.ok(at.weights.every((weight) => weight === 0.5));
  assert.equal(painted.field(0, "heat").weights.length, 0);
  const loaded = context.loadPointSet(painted.save());
  assert.deepEqual(loaded.field(0, "colour"), at);
  const moved = marks.withFields({ heat: null, place: context.createField({ kind: "direction", function: (positions, _, out) =>
    void out.values.set(positions) }) }, { transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1] });
  assert.ok(moved.field(0, "place").values[2] > 7.9);
  const dabs = context.createField({ dabs: [{ position: [0, 0, 1], normal: [0, 0, 1], radius: 0.5, value: 0.75, strength: 0.5 }] });
  assert.deepEqual([...dabs.evaluate([[0, 0, 1]], [[0, 0, 1]]).weights], [0.5]);
  const green = { width: 3, height: 2, data: new Uint8Array([0, 255, 0, 255].flatMap((one) => Array(1).fill(one))) };
  assert.throws(() => context.createField({ image: green, camera }), /image\.data must have 4 numbers/);
  green.data = Uint8Array.from({ length: 24 }, (_, i) => (i % 2 === 1 ? 255 : 0));
  const photo = marks.withFields({ photo: context.createField({ kind: "colour", image: green, camera }) }).field(0, "photo");
  const seen = photo.weights.filter((weight) => weight > 0.9).length;
  assert.ok(seen > 0.3 * photo.weights.length && seen < 0.7 * photo.weights.length);
  assert.ok(photo.values.every((value, i) => Math.abs(value - (i % 3 === 1 ? photo.weights[(i - 1) / 3] : 0)) < 1e-5));
  const wrong = context.createField({ function: () => { throw new RangeError("lost"); } });
  assert.throws(() => marks.withFields({ wrong }), /RangeError: lost/);
  fails(() => context.createField({ points: corners, values: [1] }), "INVALID_ARGUMENT", /values has 1 elements/);
  fails(() => painted.field(0, "cold"), "INVALID_ARGUMENT", /no field "cold"/);
  assert.throws(() => context.createField({ heat: 1 }), /no option "heat"/);
  const half = context.createField({ function: (positions, _, out) =>
    void out.values.forEach((__, i) => { out.values[i] = positions[3 * i] > 0 ? 1 : 0; }) });
  const right = ball.generate({ layers: [{ kind: "stipples", budget: 300, density: "field", densityField: half }] });
  const left = -1e-3 - right.info().origin[0];
  assert.ok(right.view(0, "position").every((value, i) => i % 3 !== 0 || value > left));
  const style = { ...library.style("stipple"), palette: [[1, 0, 0, 1], [0, 0, 1, 1]] };
  const drawing = context.createRenderer().draw({ pointSet: painted, style }, camera);
  assert.throws(() => context.createRenderer().draw({ pointSet: painted, style: { palette: [[1, 0, 0]] } }, camera), /palette\[0\]/);
  for (const handle of [heat, colour, painted, loaded, moved, dabs, wrong, half, right, drawing]) handle.free();
});

test("lines, planes, vertices and pages of a drawing", () => {
  const lineSet = ball.createLineSet();
  const drawing = context.createRenderer().draw({ pointSet: marks, lineSet, style: library.style("contour-and-stipple") }, camera);
  assert.ok(drawing.info().lineCurves >= 1);
  const { depth, id, markClass } = drawing.rasterize({ depth: true, id: true, markClass: true });
  const middle = 60 * 160 + 80;
  assert.ok(depth[middle] < depth[0]);
  const seen = id.find((one) => one !== 0);
  assert.equal(drawing.identify(seen).id, seen);
  assert.ok(markClass.some((one) => one === hrbfnpr.CLASS.FRONT));
  const { vertices, stride, offsets } = drawing.vertices("points", ["window", "radius", "color"]);
  assert.equal(vertices.length, stride * drawing.info().dots);
  assert.deepEqual(offsets, { window: 0, radius: 12, color: 16 });
  const count = marks.layerInfo(0).marks;
  assert.equal(drawing.markIndices(0, 0).length, drawing.markResults(0, 0, count).shown.filter((one) => one === 1).length);
  assert.match(drawing.toSVG({ title: "A ball" }), /^<\?xml[^]*<title>A ball<\/title>[^]*<\/svg>\s*$/);
  const { bytes, info } = context.writePage({ format: "pdf", items: [{ drawing, name: "ball" }] });
  assert.equal(info.bytes, bytes.length);
  assert.equal(new TextDecoder().decode(bytes.slice(0, 5)), "%PDF-");
});

test("models and marks are saved and loaded", () => {
  const again = context.loadModel(ball.save());
  assert.deepEqual(again.evaluate([0.3, 0.2, 0.1]), ball.evaluate([0.3, 0.2, 0.1]));
  const loaded = context.loadPointSet(marks.save());
  assert.deepEqual(loaded.view(0, "position"), marks.view(0, "position"));
  const broken = ball.save();
  broken[broken.length >> 1] ^= 1;
  fails(() => context.loadModel(broken), "CORRUPT_DATA", /damaged/);
});

test("meshes, solids and formulas", () => {
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z])));
  const faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
  const triangles = Int32Array.from(faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]));
  const mesh = context.createMesh({ vertices: corners, triangles });
  assert.equal(mesh.info().closed, 1);
  assert.ok(Math.abs(mesh.info().volume - 8) < 1e-9);
  assert.equal(mesh.sample(20).points.length, 60);
  const cube = context.fitMesh(mesh, { tolerance: 0.01 });
  assert.equal(cube.meshFit.reached, 1);
  assert.ok(cube.compareMesh(mesh, { points: 500 }).surfaceP99 < 0.02);
  const solid = context.createCsg([{ kind: "difference" }, { kind: "box", parent: 0, size: [2, 2, 2] },
                                   { kind: "sphere", parent: 0, radius: 0.5 }]);
  assert.equal(solid.csgInfo().nodes, 3);
  assert.deepEqual([...solid.contains([[0, 0, 0], [0.9, 0.9, 0.9]])], [0, 1]);
});

test("a formula in JavaScript is released with its last user", () => {
  let released = 0;
  const formula = context.createCustom({
    function(at, { value, gradient }) {
      for (let i = 0; i < value.length; ++i) {
        const length = Math.hypot(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        value[i] = length - 1;
        for (let axis = 0; axis < 3; ++axis) if (gradient) gradient[3 * i + axis] = at[3 * i + axis] / (length || 1);
      }
    },
    flags: hrbfnpr.CUSTOM.HAS_GRADIENT, boundsMin: [-1, -1, -1], boundsMax: [1, 1, 1], release: () => { ++released; },
  });
  const lines = formula.createLineSet({ cellSize: 0.2 });
  formula.free();
  assert.equal(released, 0);
  lines.free();
  assert.equal(released, 1);
  assert.throws(() => formula.info(), /this model has been freed/);
});

test("exceptions in callbacks come out of the call", () => {
  const wrong = context.createCustom({ function() { throw new RangeError("no such place"); },
                                       boundsMin: [-1, -1, -1], boundsMax: [1, 1, 1] });
  assert.throws(() => wrong.evaluate([0, 0, 0]), new RangeError("no such place"));
  wrong.free();
  const asked = [];
  const tone = (positions, normals, tau) => { asked.push(tau.length); tau.fill(0); };
  context.createRenderer().draw({ pointSet: marks, style: { tone: "callback", toneFunction: tone } }, camera);
  assert.ok(asked.length > 0);
  assert.throws(() => context.createCustom({ flags: hrbfnpr.CUSTOM.THREAD_SAFE, function() {} }), /THREAD_SAFE/);
});

test("long calls report progress and can be cancelled", () => {
  const told = [];
  ball.generate({ layers: [{ budget: 20000 }] }, { onProgress: (progress) => void told.push(progress) });
  assert.ok(told.length > 2 && told.at(-1) <= 1 && told.every((one, at) => at === 0 || one >= told[at - 1]));
  fails(() => ball.generate({}, { onProgress: () => false }), "CANCELLED", /./);
  const flag = new Int32Array(new SharedArrayBuffer(4)).fill(1);
  fails(() => ball.generate({}, { cancelFlag: flag }), "CANCELLED", /./);
  fails(() => ball.generate({}, { signal: AbortSignal.abort() }), "CANCELLED", /./);
  const renderer = context.createRenderer();
  const frames = [];
  renderer.draw({ pointSet: marks }, camera, { onProgress: (progress) => void frames.push(progress) });
  assert.equal(frames.at(-1), 1);
  fails(() => renderer.draw({ pointSet: marks }, camera, { onProgress: () => false }), "CANCELLED", /./);
});

test("errors name the argument", () => {
  fails(() => context.fit({ points, normals: points.slice(3) }), "INVALID_ARGUMENT", /normals/);
  fails(() => context.fit({ points: [NaN, 0, 0], normals: [0, 0, 1] }), "INVALID_ARGUMENT", /points/);
  assert.throws(() => context.fit({ pionts: points }), /fit has no option "pionts"; choose one of kernel, points/);
  assert.throws(() => context.fit({ points: "all" }), /fit\.points must be an array of numbers/);
  assert.throws(() => context.fit({ points: [1, 2] }), /fit\.points has 2 numbers; it must have 3 for each/);
  assert.throws(() => context.fit({ kernel: "cubic" }), /fit\.kernel is "cubic"; it must be one of triharmonic/);
  assert.throws(() => context.fit({ polynomialDegree: 1.5 }), /fit\.polynomialDegree must be a whole number/);
  assert.throws(() => ball.generate({ layers: [{}, { budget: "9" }] }), /generate\.layers\[1\]\.budget must be a number/);
  assert.throws(() => context.createRenderer().draw({ pointSet: ball }, camera), /items\[0\]\.pointSet must be a handle of kind point_set/);
  assert.throws(() => library.style("oil"), /preset is "oil"; it must be one of stipple/);
  assert.equal(library.text(library.raw.hrbfnpr_status_name(STATUS.IO)), "IO");
});

test("an invalid number of threads is refused", async () => {
  await assert.rejects(load({ threads: 0 }), /threads must be "auto" or a whole number from 1 to 256, not 0/);
});

test("nothing stays in memory when all is freed", () => {
  const own = library.createContext();
  const before = own.info().bytesNow;
  const handles = [];
  for (let round = 0; round < 3; ++round) {
    const model = own.fit({ points, normals: points });
    const set = model.generate({ layers: [{ budget: 500 }] });
    const renderer = own.createRenderer();
    handles.push(model, set, renderer, renderer.draw({ pointSet: set }, camera));
  }
  assert.ok(own.info().bytesNow > before);
  for (const handle of handles) handle.free();
  assert.equal(own.info().bytesNow, before);
});

test("the image of a depth camera is smoothed", () => {
  const [columns, rows] = [32, 24];
  const seen = [];
  for (let row = 0; row < rows; row += 1)
    for (let column = 0; column < columns; column += 1) {
      const z = row === 3 && column === 5 ? 0 : 2 + 0.01 * Math.sin(7 * row + 3 * column);
      seen.push((column - 16) * z / 40, (row - 12) * z / 40, z);
    }
  const { points: moved, normals, info } =
    context.smoothDepthImage({ columns, rows, points: new Float64Array(seen), noise: 0.002 });
  assert.equal(info.seen, columns * rows - 1);
  assert.ok(Number.isNaN(moved[3 * (3 * columns + 5)]));
  const middle = 3 * (12 * columns + 16);
  assert.ok(Math.abs(moved[middle + 2] - 2) < 0.003 && normals[middle + 2] < -0.99);
  assert.throws(() => context.smoothDepthImage({ columns: rows, rows: columns, points: new Float64Array(seen) }),
    /not an image of a camera/);
});

test("normals of a cloud are found", () => {
  const { normals, info } = context.orient({ points, mode: "none" });
  assert.equal(info.closed, 1);
  assert.ok(normals[0] * points[0] + normals[1] * points[1] + normals[2] * points[2] > 0.9);
  const { indices } = context.farthestPoints(points, 10);
  assert.equal(new Set(indices).size, 10);
});

test("one call draws points and reports its choices", () => {
  const stages = [];
  const normals = points.map((part) => -part);
  const picture = context.draw({ points, normals, name: "ball" }, {
    style: "engraving", width: 160, height: 120, set: { "style.paper": "#ffeedd" },
    onEvent: ({ name, fraction, note }) => { if (!note && fraction === 1) stages.push(name); },
  });
  assert.deepEqual([picture.drawing.width, picture.drawing.height], [160, 120]);
  assert.ok(stages.includes("fit") && stages.includes("place marks"), stages.join());
  const [note] = picture.notes;
  assert.equal(note.code, "normals-turned");
  assert.equal(note.severity, "note");
  assert.match(note.text, /all normals pointed inward/);
  assert.equal(note.detail, undefined);
  const { data } = picture.rasterize();
  assert.deepEqual([...data.subarray(0, 4)], [255, 238, 221, 255]);
  assert.deepEqual(data, picture.drawing.rasterize().data);
  assert.match(picture.toSVG(), /<title>ball<\/title>/);
  assert.ok(picture.info().marks > 1000);
  assert.ok(picture.model().info().centres === 200);
});

test("a picture is seen from another side and drawn in another style", () => {
  const picture = context.draw({ points, normals: points }, { style: "stipple", size: 100, set: { "marks.stipples.budget": 500 } });
  assert.ok(picture.info().marks <= 500);
  const before = picture.drawing.rasterize().data;
  assert.notDeepEqual(picture.draw(picture.look({ azimuth: 200 })).rasterize().data, before);
  assert.notDeepEqual(picture.draw(picture.orbit(90)).rasterize().data, before);
  const other = picture.restyle({ style: "silhouette", size: 100 });
  assert.equal(other.info().preset, "silhouette");
  const settings = context.loadSettings(picture.settings());
  assert.deepEqual(context.draw({ points, normals: points }, { settings }).drawing.rasterize().data, before);
});

test("a renderer draws the parts of a picture", () => {
  let events = 0;
  const picture = context.draw({ points, normals: points },
    { style: "contour-and-stipple", size: 100, flags: hrbfnpr.PICTURE.KEEP_MARKS, onEvent: () => void ++events });
  const style = picture.style();
  const items = picture.parts().map(({ pointSet, lineSet, sides }) => ({ pointSet, lineSet, sides, style }));
  assert.equal(items.length, 1);
  const planned = picture.drawing.rasterize().data;
  assert.deepEqual(context.createRenderer().draw(items, picture.camera()).rasterize().data, planned);
  style.light = [1, 0, 0];
  assert.notDeepEqual(context.createRenderer().draw(items, picture.camera()).rasterize().data, planned);
  assert.ok(events > 0);
  const before = events;
  picture.draw(picture.orbit(90));
  assert.equal(events, before, "only the making of a picture is told");
  const surface = context.draw({ points, normals: points }, { flags: hrbfnpr.PICTURE.SURFACE_ONLY });
  assert.equal(surface.model().info().centres, 200);
  assert.equal(surface.parts()[0].pointSet, undefined);
});

test("sources and options of a picture are checked", () => {
  fails(() => context.draw([], {}), "INVALID_ARGUMENT", /sources|source_count/);
  fails(() => context.draw({ points }, { set: { "style.halo": 2 } }), "INVALID_ARGUMENT", /halo_width/);
  assert.throws(() => context.draw({ points }, { colour: 1 }), /no option "colour"/);
});
