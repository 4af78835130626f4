# SPDX-License-Identifier: MIT
"""The LÖVE example, examples/love: the contents of its window."""

import os

import run

NAME = "LÖVE"


def version():
    return run.run([run.need("love", "love"), "--version"]).split()[1]


def draw(work, library, examples):
    try:
        from PIL import Image
    except ImportError:
        raise run.Missing("there is no Pillow here, to read the screenshot (Debian: python3-pil)") from None
    values = {**os.environ, "HRBFNPR_LIBRARY": str(library), "HOME": str(work), "XDG_DATA_HOME": str(work)}
    screenshot, picture = work / "screenshot.png", work / "picture.rgba"
    run.on_a_screen(["love", run.EXAMPLES / "love", "--screenshot", screenshot], env=values)
    picture.write_bytes(Image.open(screenshot).convert("RGBA").tobytes())
    return picture
