# SPDX-License-Identifier: MIT
"""Saves to and loads from paths, file objects and bytes."""
from __future__ import annotations

import os
import secrets
from pathlib import Path
from typing import Any, BinaryIO, Callable, Union

from ._callbacks import CallbackState, callback, check
from ._errors import new_error
from ._library import ffi

Source = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, BinaryIO]
Target = Union[str, "os.PathLike[str]", BinaryIO]


@callback("int32_t(void *, const void *, uint64_t)", failure=1)
def _on_write(user: Any, data: Any, size: int) -> int:
    write = ffi.from_handle(user).function
    block = bytes(ffi.buffer(data, size))
    while block:
        written = write(block)
        if written is None or written >= len(block):
            return 0
        block = block[written:]
    return 0


@callback("int64_t(void *, void *, uint64_t)", failure=-1)
def _on_read(user: Any, data: Any, size: int) -> int:
    block = ffi.from_handle(user).function(size)
    if len(block) > size:
        raise ValueError(f"read({size}) returned {len(block)} bytes")
    ffi.memmove(data, block, len(block))
    return len(block)


def _stream_call(call: Callable[[Any, Any], int], function: Callable[..., Any]) -> None:
    """Make a call with a stream.  `call` gets the user pointer and the error; `function` reads or writes."""
    state = CallbackState(function)
    user, error = state.new_handle(), new_error()
    check(call(user, error), error, state)


def write_atomically(path: Union[str, "os.PathLike[str]"], write: Callable[[BinaryIO], Any]) -> None:
    """Let `write` fill a temporary file, then move it to `path`, so that there is never half a file."""
    target = Path(os.path.realpath(os.fsdecode(path)))
    if target.exists() and not target.is_file():  # a pipe or a device must not be replaced
        with open(target, "wb") as file:
            write(file)
        return
    temporary = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
    try:
        with open(temporary, "xb") as file:
            write(file)
        os.replace(temporary, target)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        if isinstance(error, OSError) and error.filename == str(temporary):
            error.filename = os.fsdecode(path)  # the name that the caller knows
        raise


def save(function: Callable[..., int], handle: Any, target: Target) -> None:
    """Save a handle with `function`, the library's `_save`."""

    def to_file(file: BinaryIO) -> None:
        _stream_call(lambda user, error: function(handle, _on_write, user, error), file.write)

    if isinstance(target, (str, os.PathLike)):
        write_atomically(target, to_file)
    else:
        to_file(target)


def to_bytes(function: Callable[..., int], handle: Any) -> bytes:
    """The bytes that `function`, the library's `_save`, writes."""
    parts: "list[bytes]" = []
    _stream_call(lambda user, error: function(handle, _on_write, user, error), parts.append)
    return b"".join(parts)


def load(
    from_stream: Callable[..., int], from_memory: Callable[..., int], context: Any, out: Any, source: Source
) -> None:
    """Load a handle into `out` with the library's `_load` and `_load_memory`."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        error = new_error()
        data = ffi.from_buffer(source)
        check(from_memory(context, data, len(data), out, error), error)
    elif isinstance(source, (str, os.PathLike)):
        with open(source, "rb") as file:
            load(from_stream, from_memory, context, out, file)
    else:
        _stream_call(lambda user, error: from_stream(context, _on_read, user, out, error), source.read)
