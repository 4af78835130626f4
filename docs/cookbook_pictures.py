#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs each recipe of docs/cookbook.md separately, and keeps the pictures that it draws.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/cookbook_pictures.py [FOLDER]

FOLDER is docs/images/cookbook by default.  Pictures are reduced to few colours, so that the files are small.  A plot (.hpgl)
becomes a picture of the pen's path.  rsvg-convert draws SVG files (Debian: librsvg2-bin).
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent / "scripts" / "figures"))

import plot  # noqa: E402

LARGEST = 120_000  # bytes of a picture


def recipes(page: str) -> list:
    """Returns the names and the programs of the recipes."""
    sections = re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", page, re.DOTALL | re.MULTILINE)
    return [(name, block) for name, text in sections for block in re.findall(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)]


def shrink(source: Path, target: Path) -> None:
    """Copies a picture in few colours. Animations are left out."""
    picture = Image.open(source)
    if getattr(picture, "is_animated", False):
        return
    picture = picture.convert("RGB").quantize(32, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    picture.save(target, optimize=True)
    print(f"{target.name}: {target.stat().st_size} bytes")
    if target.stat().st_size > LARGEST:
        raise SystemExit(f"{target.name} is larger than {LARGEST} bytes: draw less")


def main() -> None:
    target = Path(sys.argv[1] if len(sys.argv) > 1 else DOCS / "images" / "cookbook").resolve()
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, program in recipes((DOCS / "cookbook.md").read_text(encoding="utf-8")):
            began = time.process_time()
            exec(compile(program, name, "exec"), {"__name__": "recipe"})
            print(f"{name}: {time.process_time() - began:.1f} s of the processors", flush=True)
        for source in Path(folder).glob("*.hpgl"):
            plot.paint(source, source.with_suffix(".png"), 480)
        for source in Path(folder).glob("*.svg"):
            subprocess.run(["rsvg-convert", "-b", "white", "-w", "720", "-o", str(source.with_suffix(".png")), str(source)], check=True)
        for picture in sorted(Path(folder).glob("*.png")):
            shrink(picture, target / picture.name)


if __name__ == "__main__":
    main()
