# SPDX-License-Identifier: MIT
"""Ownership of the library's handles."""
from __future__ import annotations

from types import TracebackType
from typing import Any, Callable, Optional, Type, TypeVar

from ._library import ffi

Self = TypeVar("Self", bound="Owner")


def own(raw: Any, release: Callable[[Any], None], *keep: Any) -> Any:
    """Own the handle `raw`: it is released with its last Python reference, and `keep` stays alive until then."""

    def destroy(pointer: Any, keep: Any = keep) -> None:
        release(pointer)

    return ffi.gc(raw, destroy)


class Owner:
    """Base class of Python objects that hold a reference to a handle of the library.

    The handle is released by `close`, at the end of a ``with`` block, or with the last Python reference.  Objects that were
    made from it, and views of its memory, stay valid.
    """

    def __init__(self, handle: Any) -> None:
        self._owned: Any = handle

    @property
    def _handle(self) -> Any:
        if self._owned is None:
            raise ValueError(f"this {type(self).__name__} is closed")
        return self._owned

    @property
    def closed(self) -> bool:
        """Whether `close` has been called."""
        return self._owned is None

    def close(self) -> None:
        """Release the handle.  Calls that run on other threads keep it until they end."""
        self._owned = None

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        exception: Optional[BaseException],
        traceback: Optional[TracebackType],
    ) -> None:
        self.close()
