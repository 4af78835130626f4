#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes docs/gallery.md, what is not in the article, and draws its pictures and those of README.md.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/gallery_pictures.py MESH DATA [NAME...]

MESH is that of scripts/fetch_bunny, DATA a folder of models as for scripts/gallery --data.  With names only these pictures
are drawn, such as solids-bracket.  The panels are those of scripts/figures/ours.py; pictures have few colours, to be small.
"""

import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent / "scripts" / "figures"))

from draw import command, draw  # noqa: E402
from models import Models  # noqa: E402
from ours import OURS  # noqa: E402

SIZE = 480
LARGEST = 200_000  # bytes of a picture
TILE = (480, 400)  # of README.md
BEST = {
    "styles-stipple": "A bust in scientific stipple",
    "styles-etching": "The Stanford bunny, etched",
    "edges-sharp": "A lantern with sharp edges, engraved",
    "styles-terrain": "A valley, etched, in raking light",
    "solids-bracket": "A bracket put together from solids, engraved",
    "solids-sheet": "Its views and a section on a sheet, to scale",
}
HEAD = """# Gallery

What is not in the article, by subject. Below each picture is the command that draws it. `scripts/gallery` draws these and the
article's figures again, as published and in our way, larger, on a page of its own. Models are not part of the project: files
named here are samples and meshes of the sources [below](#credits), and `bunny-1.0.1.obj` is what `scripts/fetch_bunny` fetches.

All named styles of one model are in [presets.md](presets.md). This page and its pictures are written by
`docs/gallery_pictures.py` from `scripts/figures/ours.py`.

"""


def shrink(source, target, colours=16):
    picture = Image.open(source).convert("RGB")
    picture.quantize(colours, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(target, optimize=True)
    size = target.stat().st_size
    print(f"{target.name}: {picture.width} x {picture.height}, {size} bytes", flush=True)
    if size > LARGEST:
        raise SystemExit(f"{target.name} has more than {LARGEST} bytes: draw less")


def tile(source, target):
    """The picture in the middle of a page of the size that all tiles have."""
    picture, page = Image.open(source).convert("RGB"), Image.new("RGB", TILE, "white")
    picture.thumbnail((TILE[0] - 16, TILE[1] - 16), Image.Resampling.LANCZOS)
    page.paste(picture, tuple((whole - part) // 2 for whole, part in zip(TILE, picture.size)))
    page.save(target.with_suffix(".large.png"))
    shrink(target.with_suffix(".large.png"), target)
    target.with_suffix(".large.png").unlink()


def entry(name, title, words):
    shown = f'<p align="center"><img src="images/gallery/{name}.png" alt="{title[0].upper() + title[1:]}"></p>'
    return f"**{title[0].upper() + title[1:]}.**\n\n{shown}\n\n```sh\n{words}\n```\n\n"


def main():
    given, names = Path(sys.argv[2]), sys.argv[3:]
    text, credits = HEAD, set()
    for folder in ("gallery", "best"):
        (DOCS / "images" / folder).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        models = Models(given, Path(sys.argv[1]), scratch)
        for figure in OURS:
            text += f"## {figure.title}\n\n{figure.caption}{' ' + figure.settings if figure.settings else ''}\n\n"
            for panel in figure.panels:
                if panel.kind == "sheet":  # docs/presets.md has all styles, larger
                    continue
                name = f"{figure.number}-{panel.name}"
                target = DOCS / "images" / "gallery" / f"{name}.png"
                drawn = Path(scratch) / target.name
                words, credit = command(panel, models, SIZE, drawn.name)
                text += entry(name, panel.title, words)
                credits.add(credit)
                if not names or name in names:
                    draw(panel, models, SIZE, drawn)
                    shrink(drawn, target, 64 if panel.kind == "plot" else 16)
                    if name in BEST:
                        tile(drawn, DOCS / "images" / "best" / target.name)
    text += "## Credits\n\n" + "".join(f"- {credit}\n" for credit in sorted(credits) if not credit.startswith("made"))
    (DOCS / "gallery.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
