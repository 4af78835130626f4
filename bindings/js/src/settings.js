// SPDX-License-Identifier: MIT
import { Made } from "./model.js";

/** A file of settings that was read: the option `settings` of Context.draw. */
export class Settings extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_settings", pointer);
  }
}
