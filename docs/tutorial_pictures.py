#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the code of docs/tutorial.md as one program, and keeps the pictures that it draws.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/tutorial_pictures.py [FOLDER]

FOLDER is docs/images/tutorial by default.  Pictures are reduced to 32 colours, so that the files are small.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
LARGEST = 60_000  # bytes of a picture


def program(tutorial: str) -> str:
    """Joins all Python blocks of the tutorial into one program."""
    return "\n".join(re.findall(r"^```python\n(.*?)^```$", tutorial, re.DOTALL | re.MULTILINE))


def shrink(source: Path, target: Path) -> None:
    """Copies a picture in few colours."""
    picture = Image.open(source).convert("RGB").quantize(32, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    picture.save(target, optimize=True)
    print(f"{target.name}: {target.stat().st_size} bytes")
    if target.stat().st_size > LARGEST:
        raise SystemExit(f"{target.name} is larger than {LARGEST} bytes: draw less")


def main() -> None:
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "images" / "tutorial"
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        code = program((DOCS / "tutorial.md").read_text(encoding="utf-8"))
        subprocess.run([sys.executable, "-B", "-c", code], cwd=folder, check=True)
        for picture in sorted(Path(folder).glob("*.png")):
            shrink(picture, target / picture.name)


if __name__ == "__main__":
    main()
