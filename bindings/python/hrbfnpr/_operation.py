# SPDX-License-Identifier: MIT
"""Progress and cancelling of long calls."""
from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Sequence, Tuple, cast

from ._callbacks import CallbackState, callback
from ._callbacks import check as check_call
from ._context import Context, resolve
from ._errors import check as check_status
from ._errors import new_error
from ._handles import Owner, own
from ._library import ffi, lib

Progress = Any
"""A function that gets a fraction in [0, 1], or a progress bar such as tqdm's."""


def _reporter(progress: Progress) -> Callable[[float], Any]:
    """The function that receives the fraction: `progress` itself, or an update of a tqdm bar."""
    if callable(progress):
        return cast("Callable[[float], Any]", progress)
    if not hasattr(progress, "update") or not hasattr(progress, "n"):
        raise TypeError("progress must be callable, or a progress bar with `n` and `update` such as tqdm's")

    if getattr(progress, "bar_format", "") is None and getattr(progress, "total", None) in (None, 1):
        progress.total = 1.0
        progress.bar_format = "{l_bar}{bar}| {elapsed}"  # shows percent; a count would be a fraction with all its digits
        if getattr(progress, "ncols", None) == 0:
            progress.ncols = 80  # a terminal without a width: tqdm would ignore the format

    def update(fraction: float) -> None:
        total = progress.total if getattr(progress, "total", None) else 1.0
        progress.update(fraction * total - progress.n)

    return update


@callback("int32_t(void *, double)", failure=1)
def _on_progress(user: Any, fraction: float) -> int:
    # This runs even without a progress function, because Python notices Ctrl-C here.
    function = ffi.from_handle(user).function
    if function is not None:
        function(fraction)
    return 0


class Operation(Owner):
    """A handle through which one long call reports its progress and is cancelled.

    Every long call takes an `operation`, or a `progress`, for which it makes an operation.  An operation serves one call at
    a time, and may serve other calls afterwards.  Ctrl-C during a long call on the main thread cancels the call and raises
    KeyboardInterrupt.

    Parameters
    ----------
    progress : callable or progress bar, optional
        A function that gets a fraction in [0, 1], which never falls within a call.  It runs on the thread that made the
        call.  Its result is ignored; an exception cancels the call.  A tqdm bar is filled up to its `total` (1 if it has
        none).
    context : Context, optional
        The context of the calls; None: the default context.

    Notes
    -----
    `cancel`, `cancelled` and `fraction` may be used from any thread while a call runs.  A cancelled operation stays
    cancelled: every further call that gets it raises CancelledError at once.

    Examples
    --------
    >>> operation = hrbfnpr.Operation()
    >>> threading.Timer(10.0, operation.cancel).start()
    >>> model = hrbfnpr.Model.fit(points, normals, operation=operation)
    """

    def __init__(self, progress: Optional[Progress] = None, *, context: Optional[Context] = None) -> None:
        self._init(progress, resolve(context)._handle)

    def _init(self, progress: Optional[Progress], context: Any) -> None:
        """Create the operation.  `context` is a handle, so that a model's operation works after its context is closed."""
        self._state = CallbackState(None if progress is None else _reporter(progress))
        user = self._state.new_handle()
        out, error = ffi.new("hrbfnpr_operation **"), new_error()
        check_status(lib.hrbfnpr_operation_create(context, out, error), error)
        super().__init__(own(out[0], lib.hrbfnpr_operation_release, user, context))
        self._busy = threading.Lock()
        status = lib.hrbfnpr_operation_set_callback(self._handle, _on_progress, user, error)
        check_status(status, error)

    def cancel(self) -> None:
        """Make the running call, and every later one, raise CancelledError.  May be called from any thread at any time."""
        lib.hrbfnpr_operation_cancel(self._handle)

    @property
    def cancelled(self) -> bool:
        """Whether `cancel` was called, or a progress function raised an exception."""
        return bool(lib.hrbfnpr_operation_is_cancelled(self._handle))

    @property
    def fraction(self) -> float:
        """Progress of the running or last call, in [0, 1]."""
        return float(lib.hrbfnpr_operation_progress(self._handle))


@contextmanager
def running(
    operation: Optional[Operation], progress: Optional[Progress], context: Any
) -> Iterator[Tuple[Any, CallbackState]]:
    """The handle to pass to a long call, and the state of its progress callback.

    `context` is a handle.  Every call gets an operation, so that Ctrl-C can cancel it.
    """
    if operation is not None and progress is not None:
        raise TypeError("give either operation or progress, not both")
    if operation is None:
        operation = Operation.__new__(Operation)
        operation._init(progress, context)
    if not operation._busy.acquire(blocking=False):
        raise ValueError("this operation already serves a call that is running")
    try:
        yield operation._handle, operation._state
    finally:
        operation._busy.release()


def run(
    function: Callable[..., int], arguments: Sequence[Any], operation: Optional[Operation], progress: Optional[Progress],
    context: Any, *, results: Sequence[Any] = (), states: Sequence[Optional[CallbackState]] = (), shared: Any = None,
) -> None:  # fmt: skip
    """Make a long call.  Its arguments are `arguments`, an operation, `results` (which it writes), and an error.

    `states` and `shared` are those of `_callbacks.check`.
    """
    error = new_error()
    with running(operation, progress, context) as (handle, state):
        check_call(function(*arguments, handle, *results, error), error, state, *states, shared=shared)


def make(
    kind: str, function: Callable[..., int], arguments: Sequence[Any], operation: Optional[Operation],
    progress: Optional[Progress], context: Any, keep: Any, **more: Any,
) -> Any:  # fmt: skip
    """Make a long call that creates a handle of a `kind` such as "model".  The handle keeps `keep` alive.  See `run`."""
    out = ffi.new(f"hrbfnpr_{kind} **")
    run(function, arguments, operation, progress, context, results=(out,), **more)
    return own(out[0], getattr(lib, f"hrbfnpr_{kind}_release"), keep)
