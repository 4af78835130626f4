// SPDX-License-Identifier: MIT
// The page's side of the worker.

const MOST_THREADS = 8;

/** Compiles the module, and chooses its number of threads: one, or with ?threads all cores up to MOST_THREADS. */
export async function compileModule() {
  const asked = new URLSearchParams(location.search).has("threads") && globalThis.crossOriginIsolated;
  const wanted = asked ? Math.min(navigator.hardwareConcurrency ?? 1, MOST_THREADS) : 1;
  for (const threads of wanted > 1 ? [wanted, 1] : [1]) {
    const folder = threads > 1 ? "wasm-threads" : "wasm";
    const response = await fetch(new URL(`hrbfnpr/${folder}/hrbfnpr.wasm`, import.meta.url));
    if (response.ok) return { threads, wasm: await WebAssembly.compile(await response.arrayBuffer()) };
  }
  throw new Error("the page has no hrbfnpr/wasm/hrbfnpr.wasm; build it with examples/web/build");
}

/**
 * Makes pictures and draws frames of them, one request at a time. Of the pictures that wait, only the last one is made;
 * the same holds for frames. All exports are made, in order.
 */
export class Painter {
  #module;
  #answer;
  #worker;
  #now; // the request that the worker is busy with
  #picture; // requests that wait
  #frame;
  #exports = [];

  constructor(module, answer) {
    this.#module = module;
    this.#answer = answer;
    this.#start();
  }

  /** The key of the picture that waits, or else is being made; undefined if no picture is. */
  get making() {
    return (this.#picture ?? (this.#now?.type === "make" ? this.#now : undefined))?.key;
  }

  #start() {
    this.#now = undefined;
    /** True if the worker has a picture to draw. */
    this.hasPicture = false;
    this.#worker = new Worker(new URL("painter.js", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) =>
      this.#take({ type: "failed", message: event.message || "painter.js did not start; reload the page" });
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

  /** Makes a picture. Cancels the picture of another source that is being made. */
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

  // Without shared memory, only termination stops a worker in the middle of a call. It loses its memory and its picture.
  #end() {
    this.#worker.terminate();
    this.#start();
  }

  /** Cancels the picture that is being made. */
  cancel() {
    if (this.making === undefined) return;
    const request = this.#picture ?? this.#now;
    this.#picture = undefined;
    if (this.#now?.type === "make") this.#end();
    this.#answer({ type: "failed", what: "make", request, cancelled: true });
  }
}
