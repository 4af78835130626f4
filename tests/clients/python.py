# SPDX-License-Identifier: MIT
"""The Python package."""

import os
import platform
import sys

import run

NAME = "Python (cffi)"

PROGRAM = """
import sys
import numpy as np, hrbfnpr

samples = np.loadtxt(sys.argv[1])
picture = hrbfnpr.draw((samples[:, :3], samples[:, 3:]), direction=(0, 1, -1), up=(0, 0, 1), size=(640, 480))
picture.image.tofile(sys.argv[2])
"""


def version():
    return platform.python_version()


def draw(work, library, examples):
    picture = work / "picture.rgba"
    package = run.ROOT / "bindings" / "python"
    values = {**os.environ, "PYTHONPATH": str(package), "HRBFNPR_LIBRARY": str(library)}
    run.run([sys.executable, "-B", "-c", PROGRAM, run.SAMPLES, picture], env=values)
    return picture
