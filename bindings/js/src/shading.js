// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
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

  /** Copies what the marks of a layer see of a light, or, if `light` is -1, of the sky. */
  view(layer = 0, light = -1) {
    return Call.with(this.library, (call) => {
      const view = call.struct("hrbfnpr_array", {});
      call.check("hrbfnpr_shading_view", this.pointer, layer, light, view);
      return call.copyOfView(view);
    });
  }
}
