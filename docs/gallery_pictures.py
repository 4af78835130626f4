#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes docs/gallery.md, and draws its pictures and those of README.md.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/gallery_pictures.py MESH DATA [NAME...]

MESH is the file that scripts/fetch_bunny fetches.  DATA is a folder of models, as for scripts/gallery --data.  NAME, such as
solids-bracket, selects a picture; without names all are drawn.  The panels are those of scripts/figures/ours.py.  Pictures
are reduced to few colours, so that the files are small.
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
LARGEST = 200_000  # bytes of a picture file
TILE = (480, 400)  # pixels of a picture of README.md
BEST = {
    "styles-stipple": "A bust in scientific stipple",
    "styles-etching": "The Stanford bunny, etched",
    "edges-sharp": "A lantern with sharp edges, engraved",
    "styles-terrain": "A valley in raking light, etched",
    "solids-bracket": "A bracket built from solids, engraved",
    "solids-sheet": "Views and a section of the bracket, to scale",
}
HEAD = """# Gallery

Drawings by subject, each with the command that draws it. [The named styles](presets.md) are on a page of their own.
`scripts/gallery` draws these pictures larger, on one HTML page, with the figures of the article.

The project does not contain the models. The commands name samples and meshes from the sources [below](#credits).
`scripts/fetch_bunny` fetches `bunny-1.0.1.obj`.

<!-- docs/gallery_pictures.py writes this page and its pictures from scripts/figures/ours.py. -->

"""


def shrink(source, target, colours=16):
    picture = Image.open(source).convert("RGB")
    picture.quantize(colours, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(target, optimize=True)
    size = target.stat().st_size
    print(f"{target.name}: {picture.width} x {picture.height}, {size} bytes", flush=True)
    if size > LARGEST:
        raise SystemExit(f"{target.name} has {size} bytes, more than {LARGEST}: reduce its size or colours")


def tile(source, target):
    """Centres the picture on a white tile; all tiles have one size."""
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
                if panel.kind == "sheet":  # docs/presets.md shows all styles, larger
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
