// SPDX-License-Identifier: MIT
// Settings survive in a link, and give the right camera.
import assert from "node:assert/strict";
import test from "node:test";
import { lightOf, optionsOf, scaled, styleOf, turned } from "../../examples/web/page/look.js";
import { defaults, fromLink, toLink } from "../../examples/web/page/settings.js";

test("a link gives back the settings that it was made from", () => {
  const settings = { ...defaults(), model: "cup", preset: "woodcut", turn: -12.5, zoom: 2.25, ink: "#12ab34", hidden: "dashed" };
  assert.deepEqual(fromLink(toLink(settings)), settings);
  assert.equal(toLink(defaults()), "#");
});

test("invalid values in a link give the defaults, and numbers are clamped", () => {
  assert.deepEqual(fromLink("#zoom=many&ink=red&hidden=maybe&other=1&marks="), defaults());
  assert.equal(fromLink("#zoom=1e9").zoom, 12);
  assert.equal(fromLink("#marks=-5").marks, 0);
});

test("directions and lights are of unit length", () => {
  for (const [turn, tilt] of [[0, 0], [90, 45], [-180, 90]])
    assert.ok(Math.abs(Math.hypot(...turned([1, -2, 3], [0, 0, 2], { turn, tilt })) - 1) < 1e-12);
  assert.ok(lightOf({ lx: 0.98, ly: 0 })[2] > 0);
});

test("a camera turns around up, and goes up and down", () => {
  const near = (found, wanted) => assert.ok(found.every((part, axis) => Math.abs(part - wanted[axis]) < 1e-12), found.join());
  near(turned([0, 0, -1], [0, 1, 0], { turn: 0, tilt: 0 }), [0, 0, -1]);
  near(turned([0, 0, -1], [0, 1, 0], { turn: 90, tilt: 0 }), [-1, 0, 0]);
  near(turned([0, 0, -1], [0, 1, 0], { turn: 0, tilt: 30 }), [0, -0.5, -Math.sqrt(0.75)]);
  near(turned([0, 2, 0], [0, 0, 1], { turn: 180, tilt: 0 }), [0, -1, 0]);
  assert.ok(turned([0, -1, 0], [0, 1, 0], { turn: 0, tilt: 90 })[1] < -0.999, "not over the top");
});

test("only what the user has set goes to the library", () => {
  const size = { width: 30, height: 20 };
  assert.equal(optionsOf(defaults(), size).set, undefined);
  assert.deepEqual(optionsOf({ ...defaults(), marks: 4000 }, size).set, { "marks.layers.budget": 4000 });
  const planned = { light: [1, 1, 1], toneExponent: 1.3, fillLight: 0.1, haloWidth: 2 };
  const { layers, lines, ...style } = styleOf(planned, defaults());
  assert.deepEqual({ layers, lines, style }, { layers: undefined, lines: undefined, style: planned });
  assert.notDeepEqual(styleOf(planned, { ...defaults(), lx: 0.2 }).light, planned.light);
});

test("a style takes pen, contours and colours, and is scaled as a whole", () => {
  const preset = { toneExponent: 1, haloWidth: 2,
                   layers: [{ radius: 1, hatchPen: 0.6, hatchSpacing: 4, ink: [0, 0, 0, 1] }],
                   lines: [{ width: 2, hiddenWidth: 1, ink: [0, 0, 0, 1], hidden: "none" }] };
  const style = styleOf(preset, { ...defaults(), pen: 2, contour: 0, ink: "#ff0000", paper: "#0000ff" });
  assert.equal(style.layers[0].radius, 2);
  assert.deepEqual(style.layers[0].ink, [1, 0, 0, 1]);
  assert.equal(style.lines, undefined);
  assert.deepEqual(style.paper, [0, 0, 1, 1]);
  const twice = scaled(styleOf(preset, defaults()), 2);
  assert.deepEqual([twice.layers[0].radius, twice.lines[0].width, twice.haloWidth], [2, 4, 4]);
});
