# SPDX-License-Identifier: MIT
"""Draws the path of a plotter's pen."""

import re

import numpy as np
from PIL import Image, ImageDraw

FIRST, LAST = np.array([20, 60, 200.0]), np.array([200, 20, 30.0])
LIFTED = (205, 205, 205)


def moves(text):
    """Yields the moves of the pen in an HPGL file, in order: whether the pen is down, the start and the end."""
    at = (0.0, 0.0)
    for command, numbers in re.findall(r"(PU|PD)([-\d,. ]*);", text):
        values = [float(x) for x in re.findall(r"-?[\d.]+", numbers)]
        for to in zip(values[::2], values[1::2]):
            yield command == "PD", at, to
            at = to


def paint(source, target, size):
    """Draws the moves, with colours from FIRST to LAST in the order of drawing, and grey where the pen is up. Deletes `source`."""
    way = list(moves(source.read_text(encoding="ascii", errors="replace")))
    source.unlink()
    drawn = np.array([point for down, *ends in way if down for point in ends])
    low, high = drawn.min(axis=0), drawn.max(axis=0)
    scale = 2 * size / (1.04 * (high - low).max())
    edge = 0.02 * (high - low).max()
    picture = Image.new("RGB", tuple(int(x) for x in scale * (high - low + 2 * edge)), "white")
    pen = ImageDraw.Draw(picture)
    for lifted in (True, False):  # drawn lines are on top
        for number, (down, *ends) in enumerate(way):
            if down != lifted:
                colour = tuple(int(x) for x in FIRST + (LAST - FIRST) * number / len(way)) if down else LIFTED
                points = [(scale * (x - low[0] + edge), scale * (high[1] - y + edge)) for x, y in ends]
                pen.line(points, fill=colour, width=2)
    picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.LANCZOS).save(target)
