// SPDX-License-Identifier: MIT
// A link and back, and the camera that it stands for.
import assert from "node:assert/strict";
import test from "node:test";
import { directionOf, lightOf, scaled, styleOf } from "../../examples/web/page/look.js";
import { defaults, fromLink, toLink } from "../../examples/web/page/settings.js";

test("a link gives back the settings that it was made from", () => {
  const settings = { ...defaults(), model: "cup", preset: "woodcut", turn: -12.5, zoom: 2.25, ink: "#12ab34", hidden: "dashed" };
  assert.deepEqual(fromLink(toLink(settings)), settings);
  assert.equal(toLink(defaults()), "#");
});

test("a link with nonsense gives the defaults, and numbers within their range", () => {
  assert.deepEqual(fromLink("#zoom=many&ink=red&hidden=maybe&other=1&marks="), defaults());
  assert.equal(fromLink("#zoom=1e9").zoom, 12);
  assert.equal(fromLink("#marks=-5").marks, 2000);
});

test("directions and lights are of unit length", () => {
  for (const [turn, tilt] of [[0, 0], [90, 45], [-180, 90]])
    assert.ok(Math.abs(Math.hypot(...directionOf({ turn, tilt })) - 1) < 1e-12);
  assert.deepEqual(directionOf({ turn: 0, tilt: 0 }).map((x) => x + 0), [0, 0, -1]);
  assert.ok(lightOf({ lx: 0.98, ly: 0 })[2] > 0);
});

test("a style takes pen, contours and colours, and is scaled as a whole", () => {
  const preset = { toneExponent: 1, silhouetteWidth: 1, silhouetteRadius: 1, haloWidth: 2, silhouetteInk: [0, 0, 0, 1],
                   layers: [{ radius: 1, hatchPen: 0.6, hatchSpacing: 4, contours: 1, ink: [0, 0, 0, 1] }],
                   lines: [{ width: 2, hiddenWidth: 1, ink: [0, 0, 0, 1], hidden: "none" }] };
  const style = styleOf(preset, { ...defaults(), pen: 2, contour: 0, ink: "#ff0000", paper: "#0000ff" });
  assert.equal(style.layers[0].radius, 2);
  assert.equal(style.layers[0].contours, 0);
  assert.deepEqual(style.layers[0].ink, [1, 0, 0, 1]);
  assert.equal(style.lines, undefined);
  assert.deepEqual(style.paper, [0, 0, 1, 1]);
  const twice = scaled(styleOf(preset, defaults()), 2);
  assert.deepEqual([twice.layers[0].radius, twice.lines[0].width, twice.haloWidth], [2, 4, 4]);
});
