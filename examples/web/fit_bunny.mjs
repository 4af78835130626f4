// SPDX-License-Identifier: MIT
// Fits the bunny when the page is built: fit_bunny.mjs PACKAGE MESH.obj MODEL
import { readFile, writeFile } from "node:fs/promises";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { readObj } from "./page/readers/obj.js";

const [folder, meshPath, modelPath] = process.argv.slice(2);
const { PICTURE, load } = await import(pathToFileURL(resolve(folder, "src/index.js")));
const context = (await load()).createContext();
const { vertices, triangles } = readObj(await readFile(meshPath));
const picture = context.draw({ points: vertices, triangles }, { flags: PICTURE.SURFACE_ONLY });
await writeFile(modelPath, picture.model().save());
