# SPDX-License-Identifier: MIT
"""NumPy, or None if it is not installed."""
from __future__ import annotations

from typing import Any

np: Any = None
try:
    import numpy as _numpy

    np = _numpy
except ImportError:
    pass
