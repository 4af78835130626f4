// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
import { Drawing } from "./drawing.js";
import { Made } from "./model.js";
import { operated } from "./operation.js";
import { sizeOf, write } from "./structs.js";

/** Writes items as an array of structs. */
export function itemStructs(call, list) {
  const size = sizeOf("hrbfnpr_item");
  const first = call.allocate(Math.max(size * list.length, 1));
  list.forEach((item, at) => write(call, first + at * size, "hrbfnpr_item", item, `items[${at}]`));
  return first;
}

/** Makes drawings of items for a camera. */
export class Renderer extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_renderer", pointer);
  }

  draw(items, camera, control) {
    const list = Array.isArray(items) ? items : [items];
    return Call.with(this.library, (call) => {
      const first = itemStructs(call, list);
      const seen = call.structOf({ ...camera }, "hrbfnpr_camera", "camera");
      return operated(call, this.context.pointer, control, (operation) => {
        const pointer = call.made("hrbfnpr_renderer_draw_with_operation", this.pointer, first, list.length,
          sizeOf("hrbfnpr_item"), seen, operation);
        return new Drawing(this.context, pointer, camera.viewport);
      });
    });
  }
}
