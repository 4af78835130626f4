// SPDX-License-Identifier: MIT
import { Made } from "./model.js";

/** Holds what the lines of one model are drawn from, for every camera. */
export class LineSet extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_line_set", pointer);
  }

  info() {
    return this.readInfo("hrbfnpr_line_set_get_info", "hrbfnpr_line_set_info");
  }
}
