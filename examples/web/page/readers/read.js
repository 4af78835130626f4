// SPDX-License-Identifier: MIT
import { readObj } from "./obj.js";
import { readPly } from "./ply.js";
import { ShapeError } from "./shape.js";
import { readStl } from "./stl.js";
import { readXyz } from "./xyz.js";

const READERS = { ply: readPly, obj: readObj, stl: readStl, xyz: readXyz, xyzn: readXyz, txt: readXyz };

/**
 * Reads the shape in a file. The ending of its name gives the format.
 * @param {string} name
 * @param {Uint8Array} bytes
 */
export function readShape(name, bytes) {
  const ending = name.includes(".") ? name.split(".").pop().toLowerCase() : "";
  if (!READERS[ending])
    throw new ShapeError(`${name}: files that end in ".${ending}" cannot be read; convert it to .ply, .obj, .stl or .xyz`);
  if (bytes.length === 0) throw new ShapeError(`${name} is empty`);
  try {
    return READERS[ending](bytes);
  } catch (error) {
    if (error instanceof ShapeError) error.message = `${name}, ${error.message}`;
    throw error;
  }
}
