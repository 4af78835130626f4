// SPDX-License-Identifier: MIT
// tests/js/run.py types compiles this file and never runs it.
import { load, HrbfnprError, Style } from "hrbfnpr";
async function main() {
  const hrbf = await load({ threads: "auto" });
  const context = hrbf.createContext({ log: (message, level) => console.log(level, message) });
  const model = context.fit({ points: new Float64Array(9), normals: [[0, 0, 1]], kernel: "wendland-c2" }, { onProgress: (p) => p < 0.5 });
  const marks = model.generate({ preset: "hatch", layers: hrbf.presetLayers("hatch").map((one) => ({ ...one, budget: 100 })) });
  const style: Style = { ...hrbf.style("hatch"), light: [0, 0, 1] };
  style.lights = [{ kind: "place", place: [0, 0, 3], shadow: 1 }, { space: "item" }];
  const item = { pointSet: marks, style, lineSet: model.createLineSet() };
  const occluders = context.createOccluders([item], { onProgress: (p) => p < 0.5 });
  const heat = context.createField({ kind: "scalar", points: [[0, 0, 0]], values: [1], range: [0, 2] });
  const painted = item.pointSet!.withFields({ heat, cold: null });
  const weights: Float32Array = painted.field(0, "heat").weights;
  void weights;
  const shading = context.createShading(occluders, item, { skyRays: 16, camera: hrbf.createCamera() });
  // @ts-expect-error: there is no such kind of light
  style.lights.push({ kind: "lamp" });
  const camera = hrbf.createCamera().fitBounds([0, 0, 0], [1, 1, 1], { width: 10, height: 20 });
  const drawing = context.createRenderer().draw({ ...item, shading }, camera);
  const svg: string = drawing.toSVG();
  const picture = context.draw({ points: [[0, 0, 0]] }, { style: "hatch", allowBlank: true });
  const parts: (typeof marks | undefined)[] = picture.parts().map(({ pointSet }) => pointSet);
  const planned: Style = picture.style();
  const status: number = hrbf.raw.hrbfnpr_status_name(-1);
  // @ts-expect-error: there is no such kernel
  context.fit({ kernel: "cubic" });
  // @ts-expect-error: there is no such option
  context.fit({ pionts: new Float64Array(3) });
  try { marks.free(); } catch (error) { if (error instanceof HrbfnprError) console.log(error.statusName, svg, status, parts, planned); }
}
main();
