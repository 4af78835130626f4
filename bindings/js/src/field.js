// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
import { FIELD_KIND, FORMAT } from "./generated/constants.js";
import { Made } from "./model.js";
import { operated } from "./operation.js";
import { constant } from "./structs.js";

const KINDS = Object.fromEntries(Object.entries(FIELD_KIND).map(([name, value]) => [value, name.toLowerCase()]));
const SOURCES = ["points", "function", "dabs", "image"];

const length3 = (points) => (Array.isArray(points) ? points.flat().length : points.length) / 3;

/** Returns the fields of an hrbfnpr_image whose pixels are in the memory of a call. */
function imageOf(call, { width, height, data }) {
  if (data?.length !== 4 * width * height)
    throw new TypeError("field.image.data must have 4 numbers for each pixel: red, green, blue and opacity");
  const format = data instanceof Float32Array ? FORMAT.RGBA32F : FORMAT.RGBA8;
  return { width, height, format, pixels: call.bytes(data) };
}

/** Values on a surface. */
export class Field extends Made {
  #users = [];

  /** Private: use Context.createField. */
  constructor(context, pointer, kind, users) {
    super(context, "hrbfnpr_field", pointer);
    this.fieldKind = KINDS[kind];
    this.#users = users;
  }

  static made(context, { values, image, camera, triangles, ...options }, control) {
    const kind = constant("FIELD_KIND", options.kind ?? FIELD_KIND.SCALAR, "field.kind");
    const source = SOURCES.find((name) => name === "image" ? image : options[name]) ?? "points";
    const components = kind === FIELD_KIND.SCALAR ? 1 : 3;
    const given = options.function;
    return Call.with(context.library, (call) => {
      const desc = call.structOf({
        ...options, source,
        // The adapter of the callback asks for `components`.
        function: typeof given === "function" ? Object.assign((...passed) => given(...passed), { components }) : given,
        values: values === undefined ? undefined : { data: values, components },
        triangles: Array.isArray(triangles) ? Int32Array.from(triangles.flat()) : triangles,
        image: image && imageOf(call, image), camera: camera && { ...camera },
      }, "hrbfnpr_field_desc", "field");
      const pointer = operated(call, context.pointer, control,
        (operation) => call.made("hrbfnpr_field_create", context.pointer, desc, operation));
      return new Field(context, pointer, kind, source === "function" ? call.keepCallbacks() : []);
    });
  }

  evaluate(positions, normals, control) {
    const count = length3(positions);
    const components = this.fieldKind === "scalar" ? 1 : 3;
    const result = { values: new Float64Array(components * count), weights: new Float64Array(count) };
    return Call.with(this.library, (call) => {
      const facing = normals === undefined ? 0 : call.array(normals, 3, "normals");
      const out = [call.arrayOut(result.values, components), call.arrayOut(result.weights, 1)];
      const at = call.array(positions, 3, "positions");
      operated(call, this.context.pointer, control,
        (operation) => call.check("hrbfnpr_field_evaluate", this.pointer, at, facing, ...out, operation));
      return result;
    });
  }

  free() {
    super.free();
    this.#users.splice(0).forEach((user) => this.library.callbacks.forget(user));
  }
}
