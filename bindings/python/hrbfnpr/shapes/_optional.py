# SPDX-License-Identifier: MIT
"""Packages and programs that some formats need, and the errors if they are missing."""
from __future__ import annotations

import importlib
import importlib.util
import subprocess
import sys
from typing import Any, Mapping, Optional, Sequence

from ._shape import ShapeError

_LONGEST = 600  # largest running time of a program, in seconds


def needed(module: str, what: str, package: str, otherwise: str) -> Any:
    """Import a module.  If it is missing, the error says which package to install, and what to do without it."""
    try:
        return importlib.import_module(module)
    except ImportError:
        raise ShapeError(f"reading {what} needs {module} ({package}); without it, {otherwise}") from None


def is_here(module: str) -> bool:
    """Whether a module is installed.  It is not imported."""
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
    """Run a program in a separate process, because a damaged file may crash it or keep it running for ever."""
    try:
        return subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=_LONGEST, check=False, cwd=folder, env=environment
        )
    except subprocess.TimeoutExpired:
        raise ShapeError(f"{name} did not finish reading it; {otherwise}") from None
