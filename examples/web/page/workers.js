// SPDX-License-Identifier: MIT
// The two workers, as the page talks to them.

const MOST_THREADS = 8;

/** The module, compiled once for both workers, and how many threads it has: one, or with ?threads as many as there can be. */
export async function compileModule() {
  const asked = new URLSearchParams(location.search).has("threads") && globalThis.crossOriginIsolated;
  const wanted = asked ? Math.min(navigator.hardwareConcurrency ?? 1, MOST_THREADS) : 1;
  for (const threads of wanted > 1 ? [wanted, 1] : [1]) {
    const folder = threads > 1 ? "wasm-threads" : "wasm";
    const response = await fetch(new URL(`hrbfnpr/${folder}/hrbfnpr.wasm`, import.meta.url));
    if (response.ok) return { threads, wasm: await WebAssembly.compile(await response.arrayBuffer()) };
  }
  throw new Error("hrbfnpr/wasm/hrbfnpr.wasm is missing: examples/web/build puts it beside the page");
}

function started(name, module, answer) {
  const worker = new Worker(new URL(name, import.meta.url), { type: "module" });
  worker.onmessage = ({ data }) => answer(data);
  worker.onerror = (event) => answer({ type: "failed", message: event.message || `${name} does not start` });
  worker.postMessage({ type: "begin", ...module });
  return worker;
}

/** Fits and places marks, one request at a time; a new one ends the one before. */
export class Maker {
  #module;
  #answer;
  #worker;
  #busy;

  constructor(module, answer) {
    this.#module = module;
    this.#answer = answer;
    this.#start();
  }

  /** The key of what is being made, or undefined. */
  get busy() {
    return this.#busy;
  }

  #start() {
    this.#worker = started("maker.js", this.#module, (data) => this.#take(data));
  }

  #take(data) {
    if (data.type === "marks" || data.type === "failed") this.#busy = undefined;
    this.#answer(data);
  }

  make(request) {
    if (this.#busy !== undefined) this.#end();
    this.#busy = request.key;
    this.#worker.postMessage({ type: "make", ...request });
  }

  // Without shared memory nothing else reaches a worker in the middle of a call; its memory goes with it.
  #end() {
    this.#worker.terminate();
    this.#busy = undefined;
    this.#start();
  }

  cancel() {
    if (this.#busy === undefined) return;
    const key = this.#busy;
    this.#end();
    this.#answer({ type: "failed", key, cancelled: true });
  }
}

/** Draws frames: one at a time, and of those asked for meanwhile the last one. */
export class Drawer {
  #answer;
  #worker;
  #waiting;
  #isBusy = false;

  constructor(module, answer) {
    this.#answer = answer;
    const threads = Math.min(module.threads, 4);
    this.#worker = started("drawer.js", { ...module, threads }, (data) => this.#take(data));
  }

  #take(data) {
    if (data.type === "frame" || (data.type === "failed" && data.what === "frame")) this.#next();
    this.#answer(data);
  }

  #next() {
    this.#isBusy = this.#waiting !== undefined;
    if (this.#isBusy) this.#worker.postMessage(this.#waiting);
    this.#waiting = undefined;
  }

  frame(request) {
    const message = { type: "frame", ...request };
    if (request.use || !this.#isBusy) {
      this.#isBusy = true;
      this.#worker.postMessage(message);
    } else {
      this.#waiting = message;
    }
  }

  send(message, transfer = []) {
    this.#worker.postMessage(message, transfer);
  }
}
