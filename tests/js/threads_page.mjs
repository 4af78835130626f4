// SPDX-License-Identifier: MIT
// Tests the page with shared memory: threads_page.mjs ADDRESS CHROMIUM WORK
import assert from "node:assert/strict";
import { opened, picture, started, told, whole } from "./page_tools.mjs";

const [address, chromium] = process.argv.slice(2);
const browser = await started(chromium);
try {
  const { page, done } = await opened(browser, `${address}?threads#model=torus&marks=6000`);
  assert.equal(await page.evaluate(() => crossOriginIsolated), true);
  await whole(page, "torus contour-and-stipple");
  assert.match(await page.textContent("#status"), /\d+ threads/);
  assert.ok((await picture(page)).dark > 0.005);
  console.log(`page with threads: first picture after ${await told(page, "firstPicture")} ms`);
  await done();
} finally {
  await browser.close();
}
