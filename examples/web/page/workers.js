// SPDX-License-Identifier: MIT
// The worker, as the page talks to it.

const MOST_THREADS = 8;

/** The module, compiled once, and how many threads it has: one, or with ?threads as many as there can be. */
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

/**
 * Makes pictures and draws frames of them, one request at a time.  Of pictures and of frames that are asked for meanwhile
 * only the last one is made.  Exports wait in line.
 */
export class Painter {
  #module;
  #answer;
  #worker;
  #now; // the request that the worker has
  #picture; // requests that wait
  #frame;
  #exports = [];

  constructor(module, answer) {
    this.#module = module;
    this.#answer = answer;
    this.#start();
  }

  /** The key of the last picture that is being made or waits for it, or undefined. */
  get making() {
    return (this.#picture ?? (this.#now?.type === "make" ? this.#now : undefined))?.key;
  }

  #start() {
    this.#now = undefined;
    /** Whether the worker has a picture to draw. */
    this.hasPicture = false;
    this.#worker = new Worker(new URL("painter.js", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) => this.#take({ type: "failed", message: event.message || "painter.js does not start" });
    this.#worker.postMessage({ type: "begin", ...this.#module });
  }

  #take(data) {
    const request = this.#now;
    if (data.type === "picture") this.hasPicture = true;
    if (!["ready", "progress"].includes(data.type)) this.#now = undefined;
    this.#answer({ ...data, request });
    this.#next();
  }

  #next() {
    if (this.#now !== undefined) return;
    if (this.#picture !== undefined) {
      this.#now = this.#picture;
      this.#picture = undefined;
    } else if (this.#exports.length > 0) {
      this.#now = this.#exports.shift();
    } else {
      this.#now = this.#frame;
      this.#frame = undefined;
    }
    if (this.#now !== undefined) this.#worker.postMessage(this.#now);
  }

  /** Makes a picture.  One of another source that is being made is given up. */
  make(request) {
    if (this.#now?.type === "make" && this.#now.source.key !== request.source.key) this.#end();
    this.#picture = this.#now?.type === "make" && this.#now.key === request.key ? undefined : { type: "make", ...request };
    this.#next();
  }

  frame(request) {
    this.#frame = { type: "frame", ...request };
    this.#next();
  }

  export(request) {
    this.#exports.push(request);
    this.#next();
  }

  // Without shared memory nothing else reaches a worker in the middle of a call; its memory, and its picture, go with it.
  #end() {
    this.#worker.terminate();
    this.#start();
  }

  /** Gives up the picture that is being made. */
  cancel() {
    if (this.making === undefined) return;
    const request = this.#picture ?? this.#now;
    this.#picture = undefined;
    if (this.#now?.type === "make") this.#end();
    this.#answer({ type: "failed", what: "make", request, cancelled: true });
  }
}
