# SPDX-License-Identifier: MIT
"""Exceptions: one class for each status of the library."""
from __future__ import annotations

from typing import Any, Dict, Type

from ._library import ffi, lib


class Error(Exception):
    """Base class of the package's errors: a call of the library failed.

    Attributes
    ----------
    status : int
        The library's status, a negative number that never changes its meaning, such as -1.
    status_name : str
        The name of the status, such as ``"INVALID_ARGUMENT"``.
    """

    default_status = -99

    def __init__(self, message: str, status: "int | None" = None) -> None:
        super().__init__(message)
        self.status = self.default_status if status is None else status

    @property
    def status_name(self) -> str:
        """The name of the status, such as ``"INVALID_ARGUMENT"``."""
        return str(ffi.string(lib.hrbfnpr_status_name(self.status)).decode())


class InvalidArgumentError(Error, ValueError):
    """An argument is wrong.  The message names it and says what to give instead."""

    default_status = -1


class OutOfMemoryError(Error, MemoryError):
    """There is not enough memory."""

    default_status = -2


class BufferTooSmallError(Error):
    """A destination is too small.  This package sizes its buffers itself, so you should never see this error."""

    default_status = -3


class UnsupportedStructError(Error):
    """The library is older than this package and does not know a field that is set."""

    default_status = -4


class SingularSystemError(Error, ArithmeticError):
    """The linear system of a fit has no unique solution within rounding.  The message says how to change the fit."""

    default_status = -5


class NotConvergedError(Error, ArithmeticError):
    """A computation ended before it reached its goal.  The message names the computation and its result."""

    default_status = -6


class CancelledError(Error):
    """The call was cancelled by `Operation.cancel` or by its progress callback."""

    default_status = -7


class StreamError(Error, OSError):
    """A file object failed while a model or a point set was saved or loaded."""

    default_status = -8

    def __str__(self) -> str:
        return str(self.args[0])


class CorruptDataError(Error, ValueError):
    """The data is not a saved model or point set, or it is truncated or damaged."""

    default_status = -9


class VersionMismatchError(Error):
    """A newer version of the library wrote the data."""

    default_status = -10


class CallbackError(Error, RuntimeError):
    """A callback failed.  The exception that it raised is the ``__cause__``."""

    default_status = -11


class InternalError(Error, RuntimeError):
    """The library has a bug.  Please report it."""


_CLASSES: Dict[int, Type[Error]] = {
    kind.default_status: kind
    for kind in (
        InvalidArgumentError, OutOfMemoryError, BufferTooSmallError, UnsupportedStructError,
        SingularSystemError, NotConvergedError, CancelledError, StreamError, CorruptDataError,
        VersionMismatchError, CallbackError, InternalError,
    )
}  # fmt: skip


def new_error() -> Any:
    """A `hrbfnpr_error` to pass to a call."""
    error = ffi.new("hrbfnpr_error *")
    lib.hrbfnpr_error_init(error, ffi.sizeof("hrbfnpr_error"))
    return error


def make_error(status: int, error: Any = None) -> Error:
    """The exception for a status that is not 0."""
    message = ffi.string(error.message).decode("utf-8", "replace") if error is not None else ""
    kind = _CLASSES.get(status, InternalError)
    return kind(message or f"{ffi.string(lib.hrbfnpr_status_name(status)).decode()} ({status})", status)


def check(status: int, error: Any = None) -> None:
    """Raise for a status that is not 0."""
    if status != 0:
        raise make_error(status, error)


def new_struct(name: str) -> Any:
    """A struct of the library, set up by its `_init` function."""
    struct = ffi.new(f"{name} *")
    check(getattr(lib, f"{name}_init")(struct, ffi.sizeof(name)))
    return struct


def new_list(kind: str, count: int) -> Any:
    """A list of structs, each set up by its `_init` function."""
    structs = ffi.new(f"{kind}[]", max(count, 1))
    for i in range(count):
        check(getattr(lib, f"{kind}_init")(ffi.addressof(structs, i), ffi.sizeof(kind)))
    return structs
