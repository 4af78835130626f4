#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of docs/csg.md: one of its first script, and one of examples/blends.csg.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/csg_pictures.py [FOLDER]

FOLDER is docs by default.  Pictures have 16 greys, so that their files are small.
"""

import re
import sys
import tempfile
from pathlib import Path

from PIL import Image

from hrbfnpr import cli

STYLE = ["--style", "engraving", "--up", "z", "--quiet"]


def script_of(page, name):
    """The code block that begins with the comment `# name`."""
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    found = [block for block in blocks if block.startswith(f"# {name}\n")]
    if len(found) != 1:
        raise SystemExit(f"{page} has {len(found)} scripts {name}")
    return found[0]


def draw(text, target, *options):
    with tempfile.TemporaryDirectory() as scratch:
        script = Path(scratch) / "solid.csg"
        script.write_text(text, encoding="utf-8")
        if cli.main(["csg", str(script), str(target), *options, *STYLE]) != 0:
            raise SystemExit(f"{target.name} could not be drawn")
    picture = Image.open(target).convert("L")
    picture.quantize(16, dither=Image.Dither.NONE).save(target, optimize=True)
    print(f"{target.name}: {target.stat().st_size} bytes", flush=True)


def main():
    page = Path(__file__).resolve().parent / "csg.md"
    pictures = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent) / "images" / "csg"
    pictures.mkdir(parents=True, exist_ok=True)
    draw(script_of(page, "flange.csg"), pictures / "flange.png", "--size", "640", "--elevation", "35")
    draw((page.parents[1] / "examples" / "blends.csg").read_text(encoding="utf-8"), pictures / "blends.png", "--size", "800", "--azimuth", "0", "--fov", "0")


if __name__ == "__main__":
    main()
