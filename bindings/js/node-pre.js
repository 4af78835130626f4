// SPDX-License-Identifier: MIT
// Emscripten's loader expects `require` and `__dirname`, which Node does not give to ES modules.
const hrbfnprNode = typeof process === "object" && process.versions?.node ? await import("node:module") : undefined;
const require = hrbfnprNode?.createRequire(import.meta.url);
const __dirname = hrbfnprNode && decodeURIComponent(new URL(".", import.meta.url).pathname);
