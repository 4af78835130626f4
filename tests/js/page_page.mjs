// SPDX-License-Identifier: MIT
// Tests the page in Chromium with one thread: page_page.mjs ADDRESS CHROMIUM WORK. Screenshots are kept in WORK.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { drop, opened, patience, picture, set, settled, started, told, whole } from "./page_tools.mjs";

const [address, chromium, work] = process.argv.slice(2);
const MOST_FIRST = 5000; // ms to the first picture, on a machine with two idle processors
const browser = await started(chromium);
const screenshot = (page, name) => page.screenshot({ path: `${work}/${name}.png` });

async function check(name, work_) {
  const begin = Date.now();
  await work_();
  console.log(`page: ${name}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
}

const tetrahedron = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

async function draws() {
  const { page, done } = await opened(browser, address);
  const first = Number(await told(page, "firstPicture"));
  console.log(`page: first picture after ${first} ms (goal: ${MOST_FIRST})`);
  assert.ok(first < 4 * MOST_FIRST, `${first} ms`);
  await page.waitForFunction(() => document.documentElement.dataset.made !== undefined);
  await settled(page);
  const hasBunny = await page.evaluate(async () => (await fetch("bunny.model")).ok);
  if (hasBunny) assert.equal(await told(page, "made"), "bunny contour-and-stipple", "a fit to a mesh loads again");
  const { dark, width, height } = await picture(page);
  assert.ok(dark > 0.005 && dark < 0.5, `${dark}`);
  assert.ok(width > 800 && height > 700);
  assert.match(await page.textContent("#status"), /dots and strokes/);
  await screenshot(page, "wide");
  await done();
}

async function turns() {
  const { page, done } = await opened(browser, `${address}#model=blob`);
  await whole(page, "blob contour-and-stipple");
  const before = await picture(page);
  const frames = Number(await told(page, "frames"));
  await page.mouse.move(400, 400);
  await page.mouse.down();
  for (let step = 1; step <= 10; ++step) await page.mouse.move(400 + 15 * step, 400 + 5 * step);
  await page.mouse.up();
  await settled(page);
  const after = await picture(page);
  assert.notEqual(after.hash, before.hash);
  assert.equal(after.width, before.width, "the picture is whole again after it has moved");
  assert.ok(Number(await told(page, "frames")) - frames >= 3);
  assert.match(page.url(), /turn=/);
  const handle = await (await page.$("#light")).boundingBox();
  await page.mouse.click(handle.x + 70, handle.y + 60);
  await settled(page);
  assert.notEqual((await picture(page)).hash, after.hash, "the light");
  await done();
}

async function styles() {
  const { page, done } = await opened(browser, `${address}#model=torus&marks=4000`);
  await whole(page, "torus contour-and-stipple");
  const seen = new Map([["contour-and-stipple", (await picture(page)).hash]]);
  const names = await page.$$eval("#preset option", (options) => options.map(({ value }) => value));
  assert.ok(names.length >= 15);
  for (const name of names.filter((one) => one !== "contour-and-stipple")) {
    await set(page, "preset", name);
    await whole(page, `torus ${name}`);
    seen.set(name, (await picture(page)).hash);
    await screenshot(page, name);
  }
  assert.equal(new Set(seen.values()).size, names.length, "each preset has a picture of its own");
  await set(page, "preset", "engraving");
  await whole(page, "torus engraving");
  for (const [id, value] of [["pen", 2], ["spacing", 2], ["contour", 0], ["tone", 2], ["fill", 1], ["ink", "#aa2200"],
                             ["paper", "#eeeedd"], ["hidden", "shown"]]) {
    const before = (await picture(page)).hash;
    await set(page, id, value);
    await settled(page);
    if (id !== "hidden") assert.notEqual((await picture(page)).hash, before, id);
  }
  await screenshot(page, "changed");
  await set(page, "model", "cup"); // whose handle casts a shadow
  await whole(page, "cup engraving");
  for (const id of ["occlusion", "shadow"]) {
    const unshaded = (await picture(page)).hash;
    const frames = Number(await told(page, "frames"));
    await set(page, id, 1);
    await page.waitForFunction((old) => Number(document.documentElement.dataset.frames) > old, frames);
    await settled(page);
    assert.notEqual((await picture(page)).hash, unshaded, id);
  }
  await screenshot(page, "shaded");
  await set(page, "model", "torus");
  await whole(page, "torus engraving");
  const before = await picture(page);
  await set(page, "angle", 60);
  await page.waitForFunction(() => /angle=60/.test(location.hash));
  await page.waitForFunction((old) => Number(document.documentElement.dataset.frames) > old, Number(await told(page, "frames")));
  await settled(page);
  assert.notEqual((await picture(page)).hash, before.hash, "angle");
  await done();
}

async function exports() {
  const { page, done } = await opened(browser, `${address}#model=torus&marks=4000`);
  await whole(page, "torus contour-and-stipple");
  const saved = {};
  for (const kind of ["png", "svg"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${kind}`)]);
    assert.equal(download.suggestedFilename(), `drawing.${kind}`);
    saved[kind] = await readFile(await download.path());
  }
  assert.equal(saved.png.subarray(1, 4).toString(), "PNG");
  const { width } = await picture(page);
  assert.equal(saved.png.readUInt32BE(16), 2 * width);
  assert.match(saved.svg.toString(), /^<\?xml[^]*<svg[^]*<\/svg>\s*$/);
  assert.ok(saved.svg.length > 20000);
  await done();
}

async function links() {
  const link = `${address}#model=cup&preset=hatch&marks=4000&pen=1.5&lx=0.5&ly=0.1&turn=-40&tilt=30&zoom=1.2`;
  const hashes = [];
  for (let round = 0; round < 2; ++round) {
    const { page, done } = await opened(browser, link);
    await whole(page, "cup hatch");
    assert.equal(await page.inputValue("#preset"), "hatch");
    assert.equal(await page.inputValue("#pen"), "1.5");
    hashes.push((await picture(page)).hash);
    await done();
  }
  assert.equal(hashes[0], hashes[1], "a link gives the same picture again");
}

async function files() {
  const { page, done } = await opened(browser, `${address}#model=torus&marks=4000`);
  await whole(page, "torus contour-and-stipple");
  const before = await picture(page);
  await drop(page, "broken.obj", "v 0 0 0\nv 1 zero 0\nf 1 2 3\n");
  await page.waitForSelector("#message:not([hidden])");
  assert.match(await page.textContent("#message"), /broken\.obj, line 2: vertex y is "zero"; it must be a number/);
  await settled(page);
  await screenshot(page, "bad-file");
  assert.equal((await picture(page)).hash, before.hash, "the picture before stays");
  assert.equal(await page.inputValue("#model"), "torus");
  await drop(page, "picture.png", "nothing");
  await page.waitForFunction(() => /cannot be read; convert it to \.ply/.test(document.getElementById("message").textContent));
  await page.click("#message button");
  await drop(page, "tetrahedron.obj", tetrahedron);
  await page.waitForFunction(() => /^file tetrahedron\.obj/.test(document.documentElement.dataset.made ?? ""));
  await settled(page);
  assert.match(await page.textContent("#facts"), /fit: \d+ centres/);
  assert.notEqual((await picture(page)).hash, before.hash);
  await screenshot(page, "own-file");
  const cloud = Array.from({ length: 300 }, (_, i) => {
    const z = 1 - (2 * i + 1) / 300;
    const angle = i * 2.399963;
    return [Math.sqrt(1 - z * z) * Math.cos(angle), Math.sqrt(1 - z * z) * Math.sin(angle), z].join(" ");
  }).join("\n");
  await drop(page, "ball.xyz", cloud);
  await page.waitForFunction(() => /^file ball\.xyz/.test(document.documentElement.dataset.made ?? ""));
  assert.match(await page.textContent("#facts"), /fit: 300 centres/);
  assert.match(await page.textContent("#notes"), /the points have no normals: 300 are computed/);
  await done();
}

async function cancels() {
  const { page, done } = await opened(browser, `${address}#model=torus&marks=4000`);
  await whole(page, "torus contour-and-stipple");
  const before = await picture(page);
  await set(page, "marks", 80000);
  await set(page, "preset", "etching");
  await page.waitForSelector("#work:not([hidden])");
  if (await page.isVisible("#cancel")) await page.click("#cancel");
  await page.waitForSelector("#work", { state: "hidden", timeout: patience });
  assert.equal(await page.inputValue("#preset"), "contour-and-stipple");
  await settled(page);
  assert.equal((await picture(page)).hash, before.hash, "the picture before is there again");
  await page.focus("#picture");
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.notEqual((await picture(page)).hash, before.hash, "and turns");
  await set(page, "preset", "stipple");
  await whole(page, "torus stipple");
  await done();
}

async function narrow() {
  for (const [width, height] of [[360, 740], [320, 600]]) {
    const { page, done } = await opened(browser, `${address}#model=blob&preset=contour-and-stipple`,
                                        { viewport: { width, height }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    await whole(page, "blob contour-and-stipple");
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} is too narrow`);
    const before = await picture(page);
    assert.equal(before.width, 2 * width);
    const touch = await page.context().newCDPSession(page);
    const at = (x) => [{ x, y: 150 }];
    await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(100) });
    for (let x = 110; x <= 200; x += 10) await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(x) });
    await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await settled(page);
    assert.notEqual((await picture(page)).hash, before.hash, "a finger turns it");
    await screenshot(page, `narrow-${width}`);
    await done();
  }
}

async function keys() {
  const { page, done } = await opened(browser, `${address}#model=torus&marks=4000`, { colorScheme: "dark" });
  await whole(page, "torus contour-and-stipple");
  const reached = new Set();
  for (let step = 0; step < 40; ++step) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement?.id));
  }
  for (const id of ["picture", "light", "model", "open", "preset", "marks", "pen", "contour", "tone", "fill", "hidden", "ink",
                    "paper", "png", "svg", "link", "reset"]) assert.ok(reached.has(id), `the tab key does not reach ${id}`);
  const unnamed = await page.$$eval("button, select, input:not([hidden])", (all) =>
    all.filter((one) => !one.ariaLabel && !one.textContent.trim() && !(one.labels?.length > 0)).map(({ id }) => id));
  assert.deepEqual(unnamed, [], "controls without a name");
  let last = await picture(page);
  const changes = async (id, key) => {
    await page.focus(`#${id}`);
    await page.keyboard.press(key);
    await settled(page);
    const now = await picture(page);
    assert.notEqual(now.hash, last.hash, `${key} on ${id}`);
    last = now;
  };
  for (const key of ["ArrowRight", "ArrowUp", "+", "0"]) await changes("picture", key);
  for (const key of ["ArrowLeft", "ArrowDown"]) await changes("light", key);
  await changes("pen", "ArrowRight");
  const outline = await page.$eval("#pen", (input) => { input.focus(); return getComputedStyle(input).outlineStyle; });
  assert.equal(outline, "solid", "the focus is seen");
  await screenshot(page, "keys-dark");
  await done();
}

try {
  const all = { draws, turns, styles, exports, links, files, cancels, narrow, keys };
  for (const [name, run] of Object.entries(all)) await check(name, run);
} finally {
  await browser.close();
}
