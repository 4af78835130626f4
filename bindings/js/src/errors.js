// SPDX-License-Identifier: MIT
import { STATUS } from "./generated/constants.js";

const NAMES = new Map(Object.entries(STATUS).map(([name, value]) => [value, name]));

/** A call of the library failed.  The message names the wrong argument and says what to do. */
export class HrbfnprError extends Error {
  /**
   * @param {number} status a number of STATUS
   * @param {string} message
   */
  constructor(status, message) {
    super(message);
    this.name = "HrbfnprError";
    this.status = status;
    /** The name of the status, such as "INVALID_ARGUMENT". */
    this.statusName = NAMES.get(status) ?? "UNKNOWN";
  }

  /** Whether the caller cancelled the call. */
  get isCancelled() {
    return this.status === STATUS.CANCELLED;
  }
}
