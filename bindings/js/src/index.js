// SPDX-License-Identifier: MIT
import { Library } from "./library.js";

const PAGES = 65536; // bytes of a page of WebAssembly memory
const isNode = typeof process === "object" && process.versions?.node !== undefined && process.type !== "renderer";

/** Whether the build with threads can run here.  A web page must be cross-origin isolated. */
export function canUseThreads() {
  return typeof SharedArrayBuffer === "function" && (isNode || globalThis.crossOriginIsolated === true);
}

function processors() {
  return globalThis.navigator?.hardwareConcurrency ?? 4;
}

async function binaryAt(url, given) {
  if (given instanceof WebAssembly.Module) return given;
  if (given) return WebAssembly.compile(given);
  if (url.protocol === "file:" && isNode) {
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} cannot be fetched: ${response.status} ${response.statusText}`);
  const isNamed = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return isNamed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

export async function load({ threads = 1, wasm, base } = {}) {
  const count = threads === "auto" ? (canUseThreads() ? processors() : 1) : threads;
  if (!Number.isInteger(count) || count < 1 || count > 256)
    throw new TypeError(`threads must be "auto" or a whole number from 1 to 256, not ${threads}`);
  if (count > 1 && !canUseThreads())
    throw new Error("threads need SharedArrayBuffer; serve the page with the headers Cross-Origin-Opener-Policy: " +
                    "same-origin and Cross-Origin-Embedder-Policy: require-corp, or load with threads: 1");
  const folder = new URL(count > 1 ? "../wasm-threads/" : "../wasm/", base ?? import.meta.url);
  const [{ default: create }, compiled] = await Promise.all([
    import(new URL("hrbfnpr.mjs", folder).href), binaryAt(new URL("hrbfnpr.wasm", folder), wasm)]);
  const memory = new WebAssembly.Memory({ initial: 512, maximum: 4294967296 / PAGES, shared: count > 1 });
  const module = await create({
    wasmMemory: memory,
    poolSize: count - 1,
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    // Node starts workers by path, not by URL.  Only the worker of the build with threads is located here.
    locateFile: (name) => (isNode ? decodeURIComponent(new URL(name, folder).pathname).replace(/^\/([A-Z]:)/, "$1")
                                  : new URL(name, folder).href),
  });
  if (isNode) module.PThread?.unusedWorkers.forEach((worker) => worker.unref()); // else Node would not exit
  return new Library(module, memory, count, compiled);
}

export * from "./generated/constants.js";
export { Camera } from "./camera.js";
export { Context } from "./context.js";
export { Drawing } from "./drawing.js";
export { Handle } from "./handle.js";
export { HrbfnprError } from "./errors.js";
export { Field } from "./field.js";
export { Library } from "./library.js";
export { LineSet } from "./line_set.js";
export { Mesh } from "./mesh.js";
export { Model } from "./model.js";
export { Picture } from "./picture.js";
export { PointSet } from "./point_set.js";
export { Renderer } from "./renderer.js";
export { Settings } from "./settings.js";
export { Occluders, Shading } from "./shading.js";
