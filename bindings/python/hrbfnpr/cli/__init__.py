# SPDX-License-Identifier: MIT
"""The command line: python3 -m hrbfnpr, or hrbfnpr where it is installed."""
from ._main import main

__all__ = ["main"]
