# SPDX-License-Identifier: MIT
"""Cancels the fit of examples/sdl2 by pressing Escape on a virtual screen.

    cancel.py WORK PROGRAM

The status is 77 if there is no virtual screen or no way to press keys.
"""

import ctypes
import math
import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
SAMPLES = 30000  # many seconds of fitting
ESCAPE = 0xFF1B  # XK_Escape
PATIENCE = 90.0  # seconds after which a program counts as hanging


def write_samples(path):
    """Writes samples of a rough ball, which is slow to fit."""
    draw = random.Random(1)
    with path.open("w") as file:
        for _ in range(SAMPLES):
            v = [draw.gauss(0, 1) for _ in range(3)]
            length = math.hypot(*v)
            n = [x / length for x in v]
            radius = 1 + 0.02 * draw.random()
            file.write(" ".join(f"{x:.9g}" for x in [*(radius * x for x in n), *n]) + "\n")


class Keyboard:
    """Presses keys through the X server."""

    def __init__(self):
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(None))

    def press(self, symbol):
        code = self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(symbol))
        for is_down in (1, 0):
            self.test.XTestFakeKeyEvent(self.display, code, is_down, ctypes.c_ulong(0))
        self.x11.XFlush(self.display)


def press_escape(work, program):
    """Starts the program, presses Escape while it fits, and waits for its end. Runs on the virtual screen."""
    keyboard = Keyboard()
    with subprocess.Popen([program, work / "ball.xyzn"], stderr=subprocess.PIPE, text=True) as host:
        deadline = time.monotonic() + PATIENCE
        try:
            while host.poll() is None and time.monotonic() < deadline:
                time.sleep(0.3)  # before the window is open, key presses are lost
                keyboard.press(ESCAPE)
            _, said = host.communicate(timeout=0.3)
        except subprocess.TimeoutExpired:
            print(f"after {PATIENCE} s of pressing Escape the program still runs")
            return 1
        finally:
            host.kill()
    print(f"ended with {host.returncode}: {said.strip()}")
    return 0 if said.startswith("CANCELLED") else 1


def main():
    work, program = Path(sys.argv[1]), sys.argv[2]
    if sys.argv[3:] == ["here"]:
        return press_escape(work, program)
    for needed, package in [("xvfb-run", "xvfb"), ("xauth", "xauth")]:
        if shutil.which(needed) is None:
            print(f"skipped: there is no {needed} here (Debian: {package})")
            return SKIPPED
    try:
        ctypes.CDLL("libX11.so.6")
        ctypes.CDLL("libXtst.so.6")
    except OSError as error:
        print(f"skipped: {error} (Debian: libxtst6)")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    write_samples(work / "ball.xyzn")
    values = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "SDL_VIDEODRIVER": "x11"}
    return subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 800x600x24 -noreset", sys.executable, "-B", __file__, work, program, "here"],
        env=values).returncode


if __name__ == "__main__":
    sys.exit(main())
