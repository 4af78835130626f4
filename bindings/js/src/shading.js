// SPDX-License-Identifier: MIT
import { Made } from "./model.js";

/** Holds the surfaces that cast shadows and hide the sky. */
export class Occluders extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_occluders", pointer);
  }

  createShading(item, options, control) {
    return this.context.createShading(this, item, options, control);
  }
}

/** Holds how much of the sky and of each light with a shadow the marks of an item see. */
export class Shading extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_shading", pointer);
  }
}
