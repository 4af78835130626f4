// SPDX-License-Identifier: MIT
// What Emscripten's loader expects of Node, which modules have not.
const hrbfnprNode = typeof process === "object" && process.versions?.node ? await import("node:module") : undefined;
const require = hrbfnprNode?.createRequire(import.meta.url);
const __dirname = hrbfnprNode && decodeURIComponent(new URL(".", import.meta.url).pathname);
