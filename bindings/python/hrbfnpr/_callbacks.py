# SPDX-License-Identifier: MIT
"""Python functions called by the library: exceptions are carried across it and raised on return."""
from __future__ import annotations

from typing import Any, Callable, Optional

from ._errors import CallbackError, CancelledError, make_error
from ._library import ffi


class CallbackState:
    """What a callback works with, and where it leaves its exception.

    A callback must not raise into C.  It leaves its exception here and returns a failure; the call
    then fails, and `check` raises what the callback had raised.
    """

    def __init__(self, function: Optional[Callable[..., Any]] = None) -> None:
        self.function = function
        self.exception: Optional[BaseException] = None

    def new_handle(self) -> Any:
        """The `user` pointer; it must be kept as long as the library may call back."""
        return ffi.new_handle(self)


def _keep_exception(kind: Any, exception: BaseException, traceback: Any) -> None:
    # cffi calls this for an exception that leaves the callback, also for a KeyboardInterrupt
    # that struck before its first line.  The first argument of each callback is called `user`.
    if traceback is not None:
        state = ffi.from_handle(traceback.tb_frame.f_locals["user"])
        if state.exception is None:
            state.exception = exception


def callback(signature: str, failure: Any) -> Callable[[Callable[..., Any]], Any]:
    """Decorator: makes a C function whose first parameter, `user`, is the handle of a `CallbackState`.

    `failure` is what it returns when the Python function raises.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        return ffi.callback(signature, function, error=failure, onerror=_keep_exception)

    return decorate


def plain_callback(signature: str) -> Callable[[Callable[..., Any]], Any]:
    """Decorator: makes a C function that cannot fail; what it raises is printed."""

    def decorate(function: Callable[..., Any]) -> Any:
        return ffi.callback(signature, function)

    return decorate


def check(
    status: int,
    error: Any,
    *states: Optional[CallbackState],
    shared: Optional[CallbackState] = None,
) -> None:
    """Raise if the call failed, or if a callback of this call raised.

    KeyboardInterrupt and its like, and CancelledError, are raised as they are; any other exception
    becomes the cause of a CallbackError.

    Parameters
    ----------
    states
        Of callbacks that served this call alone.
    shared
        Of a callback that may serve several calls at a time: asked only if the call failed.
    """
    exception: Optional[BaseException] = None
    for state in (*states, shared if status != 0 else None):
        if state is not None and exception is None:
            exception, state.exception = state.exception, None
    if exception is None:
        if status != 0:
            raise make_error(status, error)
        return
    if isinstance(exception, CancelledError) or not isinstance(exception, Exception):
        raise exception
    raise CallbackError(f"a callback raised {type(exception).__name__}: {exception}") from exception
