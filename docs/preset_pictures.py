#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of docs/presets.md: one for each named style of the library.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/preset_pictures.py MESH [FOLDER [STYLE...]]

MESH is the file that scripts/fetch_bunny fetches.  FOLDER is docs by default.  By default all STYLEs are drawn.  Pictures have
16 colours, so that their files are small.  bindings/generate writes the page.
"""

import sys
import tempfile
from pathlib import Path

from PIL import Image

import hrbfnpr
from hrbfnpr import cli

SIZE = 480
LARGEST = 1_500_000  # largest size of all pictures together, in bytes
VIEW = ["--azimuth", "20", "--elevation", "15", "--size", str(SIZE)]


def draw(model, name, target):
    """Draws one picture in few colours."""
    if cli.main(["draw", str(model), str(target), "--style", name, *VIEW, "--quiet"]) != 0:
        raise SystemExit(f"the style {name} could not be drawn")
    picture = Image.open(target).convert("RGB")
    picture.quantize(16, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(target, optimize=True)
    print(f"{target.name}: {target.stat().st_size} bytes", flush=True)


def main():
    mesh, folder = sys.argv[1], Path(sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parent)
    names = sys.argv[3:] or hrbfnpr.PRESETS
    pictures = folder / "images" / "presets"
    pictures.mkdir(parents=True, exist_ok=True)
    for old in pictures.glob("*.png"):
        if old.stem not in hrbfnpr.PRESETS:
            old.unlink()
    with tempfile.TemporaryDirectory() as scratch:
        model = Path(scratch) / "bunny.hrbf"
        if cli.main(["fit", mesh, str(model), "--samples", "1100", "--quiet"]) != 0:
            raise SystemExit(f"{mesh} could not be fitted")
        for name in names:
            draw(model, name, pictures / f"{name}.png")
    total = sum(path.stat().st_size for path in pictures.iterdir())
    if total > LARGEST:
        raise SystemExit(f"the pictures have {total} bytes, more than {LARGEST}: draw less")
    print(f"{len(names)} pictures; all have {total} bytes")


if __name__ == "__main__":
    main()
