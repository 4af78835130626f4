// SPDX-License-Identifier: MIT
import { STATUS } from "./generated/constants.js";

const NAMES = new Map(Object.entries(STATUS).map(([name, value]) => [value, name]));

/** A call of the library that failed.  Its message names the argument and the remedy. */
export class HrbfnprError extends Error {
  /**
   * @param {number} status one of STATUS
   * @param {string} message
   */
  constructor(status, message) {
    super(message);
    this.name = "HrbfnprError";
    this.status = status;
    /** Such as "INVALID_ARGUMENT". */
    this.statusName = NAMES.get(status) ?? "UNKNOWN";
  }

  /** Whether the caller cancelled the call. */
  get isCancelled() {
    return this.status === STATUS.CANCELLED;
  }
}
