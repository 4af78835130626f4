// SPDX-License-Identifier: MIT
import { Made } from "./model.js";

/** Settings that were read from a file, for the option `settings` of Context.draw. */
export class Settings extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_settings", pointer);
  }
}
