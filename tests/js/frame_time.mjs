// SPDX-License-Identifier: MIT
// Measures the frame time of the page's first picture while it turns: frame_time.mjs ADDRESS CHROMIUM
import { opened, picture, settled, started, told, whole } from "./page_tools.mjs";

const [address, chromium] = process.argv.slice(2);
const browser = await started(chromium);
try {
  const { page } = await opened(browser, address);
  await whole(page, "bunny contour-and-stipple");
  const { width, height } = await picture(page);
  const times = [];
  for (let step = 0; step < 12; ++step) {
    await page.focus("#picture");
    await page.keyboard.press("ArrowRight");
    await settled(page);
    times.push(Number(await told(page, "frameMs")));
  }
  times.sort((a, b) => a - b);
  console.log(`page: first picture after ${await told(page, "firstPicture")} ms; a frame of ${width} x ${height} takes ` +
              `${times[6].toFixed(1)} ms (${await page.textContent("#status")})`);
} finally {
  await browser.close();
}
