// SPDX-License-Identifier: MIT
// Progress and cancelling of one long call.

/** Runs `work(address)` with an operation for `control`; the address is NULL if `control` asks for nothing. */
export function operated(call, context, control, work) {
  if (!control || !(control.onProgress || control.signal || control.cancelFlag)) return work(0);
  const { raw } = call.library;
  const operation = call.made("hrbfnpr_operation_create", context);
  try {
    const stopped = () => control.signal?.aborted || (control.cancelFlag && Atomics.load(control.cancelFlag, 0) !== 0);
    const [address, user] = call.callback("hrbfnpr_progress_fn",
      (progress) => control.onProgress?.(progress) !== false && !stopped(), "onProgress");
    call.check("hrbfnpr_operation_set_callback", operation, address, user);
    if (stopped()) raw.hrbfnpr_operation_cancel(operation);
    return work(operation);
  } finally {
    raw.hrbfnpr_operation_release(operation);
  }
}
