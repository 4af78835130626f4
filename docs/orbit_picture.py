#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws docs/images/orbit.gif, the turntable of docs/cookbook.md.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/orbit_picture.py MESH [FILE]

MESH is that of scripts/fetch_bunny.  Frames have few greys, to be small.
"""

import sys
from pathlib import Path

from PIL import Image

import hrbfnpr

FRAMES, SIZE, GREYS, LARGEST = 36, 400, 6, 1_000_000


def main():
    target = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).parent / "images" / "orbit.gif"
    look = {"samples": 1100, "elevation": 15}
    orbit = hrbfnpr.animate(sys.argv[1], None, "engraving", frames=FRAMES, size=SIZE, **look)
    frames = [Image.fromarray(frame.image).convert("L") for frame in orbit]
    palette = Image.new("P", (1, 1))
    shades = [round(255 * i / (GREYS - 1)) for i in range(GREYS)]
    palette.putpalette([shade for grey in shades + [0] * (256 - GREYS) for shade in (grey, grey, grey)])
    first, *others = (frame.convert("RGB").quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames)
    first.save(target, append_images=others, save_all=True, duration=100, loop=0, optimize=True)
    size = target.stat().st_size
    print(f"{target}: {len(frames)} frames of {first.width} x {first.height}, {size} bytes")
    if size > LARGEST:
        raise SystemExit(f"that is more than {LARGEST} bytes: draw less")


if __name__ == "__main__":
    main()
