# SPDX-License-Identifier: MIT
"""Ownership of the library's handles."""
from __future__ import annotations

from types import TracebackType
from typing import Any, Callable, Optional, Type, TypeVar

from ._library import ffi

Self = TypeVar("Self", bound="Owner")


def own(raw: Any, release: Callable[[Any], None], *keep: Any) -> Any:
    """`raw`, released with its last Python reference; `keep` stays alive as long."""

    def destroy(pointer: Any, keep: Any = keep) -> None:
        release(pointer)

    return ffi.gc(raw, destroy)


class Owner:
    """A Python object that holds one reference of a handle of the library.

    The handle is given back with the last Python reference to it, by `close`, or at the end of a
    ``with`` block.  What was made from it, views of its memory included, goes on working.
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
        """Whether `close` was called."""
        return self._owned is None

    def close(self) -> None:
        """Let go of the handle.  Calls that are running on other threads keep theirs."""
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
