// SPDX-License-Identifier: MIT
// Browser helpers for the tests of the page.
import assert from "node:assert/strict";
import { createRequire } from "node:module";

const { chromium } = createRequire(import.meta.url)(process.env.PLAYWRIGHT);

export const patience = 120000; // ms; other programs may be using the processors

export async function started(executablePath) {
  return chromium.launch({ executablePath, args: ["--no-sandbox"] });
}

/** Opens the page. `done` checks that it had no errors and asked no other server, and closes it. */
export async function opened(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(patience);
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  const outside = [];
  page.on("request", (request) => {
    if (!request.url().startsWith(new URL(address).origin) && !/^(data|blob):/.test(request.url())) outside.push(request.url());
  });
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.firstPicture);
  const done = async () => {
    assert.deepEqual(errors, []);
    assert.deepEqual(outside, [], "the page asks other servers");
    await context.close();
  };
  return { page, done };
}

export const told = (page, key) => page.evaluate((name) => document.documentElement.dataset[name], key);

/** Waits until a model is drawn in a preset. */
export async function whole(page, name) {
  await page.waitForFunction((wanted) => document.documentElement.dataset.made === wanted, name);
  await settled(page);
}

/** Waits until no more frames are drawn. */
export async function settled(page) {
  for (let before = -1, now = 0; before !== now;) {
    before = now;
    await page.waitForTimeout(600);
    now = Number(await told(page, "frames"));
  }
}

/** Reads the canvas: a hash of the picture, and the shares of dark and of light pixels. */
export async function picture(page) {
  return page.evaluate(() => {
    const canvas = document.getElementById("picture");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let hash = 0;
    let dark = 0;
    for (let at = 0; at < data.length; at += 4) {
      hash = (Math.imul(hash, 31) + data[at]) | 0;
      if (data[at] < 100) ++dark;
    }
    return { hash, dark: dark / (data.length / 4), width: canvas.width, height: canvas.height };
  });
}

export async function set(page, id, value) {
  await page.evaluate(([name, to]) => {
    const input = document.getElementById(name);
    input.value = to;
    input.dispatchEvent(new Event("input", { bubbles: true }));
    input.dispatchEvent(new Event("change", { bubbles: true }));
  }, [id, String(value)]);
}

/** Drops a file on the picture. */
export async function drop(page, name, text) {
  await page.evaluate(([fileName, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], fileName));
    for (const type of ["dragenter", "dragover", "drop"])
      document.getElementById("picture").dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, [name, text]);
}
