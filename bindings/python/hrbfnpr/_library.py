# SPDX-License-Identifier: MIT
"""Finds and loads the C library, and checks that its version fits this package."""
from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any, Iterator, List, Tuple

from ._cffi import ffi as _ffi

ffi: Any = _ffi

_ABI_VERSION: int = ffi.integer_const("HRBFNPR_ABI_VERSION")


def _file_names() -> Tuple[str, ...]:
    if sys.platform == "win32":
        return ("libhrbfnpr.dll", "hrbfnpr.dll")
    if sys.platform == "darwin":
        return (f"libhrbfnpr.{_ABI_VERSION}.dylib", "libhrbfnpr.dylib")
    return (f"libhrbfnpr.so.{_ABI_VERSION}", "libhrbfnpr.so")


def _build_tree_candidates(package: Path) -> List[Path]:
    """Libraries that were built in the checkout of this package, release builds first."""
    root = package.parents[2]
    if not (root / "include" / "hrbfnpr.h").is_file():
        return []
    found = [
        path
        for name in _file_names()
        for pattern in (f"build/{name}", f"build/*/{name}", f"build/*/*/{name}")
        for path in root.glob(pattern)
    ]
    found.sort(key=lambda path: ("release" not in path.parts, -path.stat().st_mtime))
    return found


def _candidates() -> Iterator[str]:
    """The libraries to try.  Each is looked for only after those before it failed."""
    package = Path(__file__).resolve().parent
    yield from (str(package / name) for name in _file_names() if (package / name).is_file())
    yield from map(str, _build_tree_candidates(package))
    yield from _file_names()  # for the system's loader
    from ctypes.util import find_library  # runs other programs

    by_linker = find_library("hrbfnpr")
    if by_linker:
        yield by_linker


def _open(name: str) -> Any:
    lib = ffi.dlopen(name)
    try:
        abi = lib.hrbfnpr_abi_version()
    except (AttributeError, ffi.error):
        raise OSError(f"{name} is not a hrbfnpr library") from None
    if abi != _ABI_VERSION:
        raise OSError(f"{name} has ABI version {abi}, this package needs {_ABI_VERSION}")
    return lib


def load() -> Tuple[Any, str]:
    """Load the library.  Returns it and the name under which it was found.

    If the environment variable ``HRBFNPR_LIBRARY`` is set, only the library that it names is tried.  Otherwise these are
    tried in turn: the folder of this package, the build tree of the checkout, and the system's loader.

    Raises
    ------
    ImportError
        If no library can be loaded.  The message gives the reason for each that was tried.
    """
    chosen = os.environ.get("HRBFNPR_LIBRARY")
    failures = []
    for name in [chosen] if chosen else _candidates():
        try:
            return _open(name), name
        except OSError as error:
            failures.append(str(error))
    where = "HRBFNPR_LIBRARY" if chosen else "the hrbfnpr shared library"
    remedy = (
        "let it name a libhrbfnpr shared library"
        if chosen
        else "build and install it, or name it in the environment variable HRBFNPR_LIBRARY"
    )
    reasons = "\n  ".join(dict.fromkeys(failures))
    raise ImportError(f"cannot load {where}; {remedy}. Tried:\n  {reasons}")


lib, library_path = load()
