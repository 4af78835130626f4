# SPDX-License-Identifier: MIT
"""When this process began, as far as the system tells."""
from __future__ import annotations

import os
import time

_loaded = time.monotonic()


def process_start() -> float:
    """On the scale of time.monotonic(): before the interpreter started where that is known, else about after it."""
    try:
        with open("/proc/self/stat", "rb") as file:
            # The name of the program, in brackets, may hold anything.
            fields = file.read().rpartition(b")")[2].split()
        began = int(fields[19]) / os.sysconf("SC_CLK_TCK")
        age = time.clock_gettime(time.CLOCK_BOOTTIME) - began
    except (OSError, ValueError, IndexError, AttributeError):
        return _loaded
    return time.monotonic() - age if 0 <= age < 1e6 else _loaded
