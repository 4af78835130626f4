# SPDX-License-Identifier: MIT
"""Packages that some formats need, and what is said where they are missing."""
from __future__ import annotations

import importlib
from typing import Any

from ._shape import ShapeError


def needed(module: str, what: str, package: str, otherwise: str) -> Any:
    """A module, or an error that says which package to install, and what to do without it."""
    try:
        return importlib.import_module(module)
    except ImportError:
        raise ShapeError(f"reading {what} needs {module} ({package}); or without it: {otherwise}") from None
