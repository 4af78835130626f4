# SPDX-License-Identifier: MIT
"""Packages that some formats need, and what is said where they are missing."""
from __future__ import annotations

import importlib
import importlib.util
import subprocess
import sys
from typing import Any, Mapping, Optional, Sequence

from ._shape import ShapeError

_LONGEST = 600  # seconds


def needed(module: str, what: str, package: str, otherwise: str) -> Any:
    """A module, or an error that says which package to install, and what to do without it."""
    try:
        return importlib.import_module(module)
    except ImportError:
        raise ShapeError(f"reading {what} needs {module} ({package}); or without it: {otherwise}") from None


def is_here(module: str) -> bool:
    """Whether it is installed; it is not imported for that."""
    if module in sys.modules:
        return sys.modules[module] is not None
    return importlib.util.find_spec(module) is not None


def run(
    name: str,
    command: Sequence[str],
    otherwise: str,
    folder: Optional[str] = None,
    environment: Optional[Mapping[str, str]] = None,
) -> "subprocess.CompletedProcess[bytes]":
    """A program, in a process of its own: damaged files may end the one that reads them, or keep it for ever."""
    try:
        return subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=_LONGEST, check=False, cwd=folder, env=environment
        )
    except subprocess.TimeoutExpired:
        raise ShapeError(f"{name} does not come to an end with it; {otherwise}") from None
