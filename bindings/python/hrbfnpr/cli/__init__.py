# SPDX-License-Identifier: MIT
"""The command line: `python3 -m hrbfnpr`, or `hrbfnpr` after installation."""
from ._main import main

__all__ = ["main"]
