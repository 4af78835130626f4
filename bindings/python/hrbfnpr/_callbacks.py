# SPDX-License-Identifier: MIT
"""Python functions that the library calls.  Their exceptions are kept, and raised when the library returns."""
from __future__ import annotations

from typing import Any, Callable, Optional

from ._errors import CallbackError, CancelledError, make_error
from ._library import ffi


class CallbackState:
    """The Python function of a callback, and the exception that it raised.

    A callback must not raise into C.  It leaves its exception here and returns a failure.  The call then fails, and
    `check` raises the exception.
    """

    def __init__(self, function: Optional[Callable[..., Any]] = None) -> None:
        self.function = function
        self.exception: Optional[BaseException] = None

    def new_handle(self) -> Any:
        """The `user` pointer.  Keep it as long as the library may call back."""
        return ffi.new_handle(self)


def _keep_exception(kind: Any, exception: BaseException, traceback: Any) -> None:
    # cffi calls this function for every exception that leaves a callback, even for a KeyboardInterrupt before the callback's
    # first line.  The first argument of each callback must be named `user`.
    if traceback is not None:
        state = ffi.from_handle(traceback.tb_frame.f_locals["user"])
        if state.exception is None:
            state.exception = exception


def callback(signature: str, failure: Any) -> Callable[[Callable[..., Any]], Any]:
    """Decorator that makes a C function, whose first parameter `user` is the handle of a `CallbackState`.

    The C function returns `failure` if the Python function raises.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        return ffi.callback(signature, function, error=failure, onerror=_keep_exception)

    return decorate


def plain_callback(signature: str) -> Callable[[Callable[..., Any]], Any]:
    """Decorator that makes a C function that cannot fail.  An exception is printed."""

    def decorate(function: Callable[..., Any]) -> Any:
        return ffi.callback(signature, function)

    return decorate


def check(
    status: int,
    error: Any,
    *states: Optional[CallbackState],
    shared: Optional[CallbackState] = None,
) -> None:
    """Raise if the call failed, or if a callback of this call raised an exception.

    CancelledError, and exceptions such as KeyboardInterrupt, are raised as they are.  Any other exception becomes the cause
    of a CallbackError.

    Parameters
    ----------
    states
        The states of callbacks that served only this call.
    shared
        The state of a callback that may serve several calls at the same time.  It is looked at only if the call failed.
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
