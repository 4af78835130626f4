# SPDX-License-Identifier: MIT
"""The time at which this process started."""
from __future__ import annotations

import os
import time

_loaded = time.monotonic()


def process_start() -> float:
    """When this process started, on the scale of time.monotonic().

    On Linux this is before the interpreter starts.  On other systems it is the time when this module was imported.
    """
    try:
        with open("/proc/self/stat", "rb") as file:
            # The second field is the name of the program in brackets.  It may contain spaces and brackets.
            fields = file.read().rpartition(b")")[2].split()
        began = int(fields[19]) / os.sysconf("SC_CLK_TCK")
        age = time.clock_gettime(time.CLOCK_BOOTTIME) - began
    except (OSError, ValueError, IndexError, AttributeError):
        return _loaded
    return time.monotonic() - age if 0 <= age < 1e6 else _loaded
