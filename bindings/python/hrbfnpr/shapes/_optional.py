# SPDX-License-Identifier: MIT
"""Packages that some formats need, and what is said where they are missing."""
from __future__ import annotations

import importlib
import importlib.util
import sys
from typing import Any

from ._shape import ShapeError


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
