# SPDX-License-Identifier: MIT
"""Draws the figures of the article and of the gallery; scripts/gallery runs it with the library of this checkout."""

import argparse
import sys
import tempfile
from pathlib import Path

from draw import Failed, command, draw
from figures import PAPER
from models import Missing, Models
from ours import OURS
from page import page

FIGURES = (*PAPER, *OURS)


def arguments():
    parser = argparse.ArgumentParser(prog="gallery", description="Draw the figures of the article and of the gallery.")
    parser.add_argument(
        "out", nargs="?", default="out/gallery", type=Path, metavar="OUT",
        help="folder for the pictures and index.html; default: out/gallery",
    )
    parser.add_argument("--data", type=Path, metavar="DIR", help="folder with the models")
    parser.add_argument("--bunny", type=Path, metavar="MESH", help="mesh of the bunny, used if DIR has none")
    parser.add_argument(
        "--size", type=int, default=640, metavar="N", help="longer side of a picture in pixels, 32 to 4096; default: 640"
    )
    numbers = ",".join(figure.number for figure in FIGURES)
    parser.add_argument(
        "--figures", default=numbers, metavar="LIST", help=f"figures to draw, with commas between; default: {numbers}"
    )
    given = parser.parse_args()
    if not 32 <= given.size <= 4096:
        parser.error(f"--size must be 32 to 4096 pixels, not {given.size}")
    if given.data is not None and not given.data.is_dir():
        parser.error(f"--data: {given.data} is not a folder")
    given.figures = given.figures.split(",")
    for number in given.figures:
        if number not in numbers.split(","):
            parser.error(f"--figures: there is no figure {number!r}; choose some of {numbers}")
    return given


def progress(total):
    """Returns a function to call with the name of each panel before it is drawn.

    The function shows a bar on a terminal, otherwise lines.
    """
    if sys.stderr.isatty():
        try:
            from tqdm import tqdm

            bar = tqdm(total=total, bar_format="{desc:<32}{percentage:3.0f}% |{bar:30}| {elapsed}")

            def advance(text):
                bar.set_description_str(text)
                bar.update(1)

            return advance
        except ImportError:
            pass
    return lambda text: print(text, flush=True)


def draw_figure(figure, models, given, credits, begin):
    """Draws a figure; returns it with its drawn panels and the reasons why other panels are left out."""
    drawn, left_out = [], []
    for panel in figure.panels:
        begin(f"figure {figure.number}, {panel.name}")
        target = given.out / f"figure_{figure.number}_{panel.name}.png"
        try:
            draw(panel, models, given.size, target)
            words, credit = command(panel, models, given.size, target.name)
        except Missing as reason:
            left_out.append(str(reason))
            continue
        credits.add(credit)
        drawn.append((target.name, panel.title, words))
    return figure, drawn, left_out


def main():
    given = arguments()
    wanted = [figure for figure in FIGURES if figure.number in given.figures]
    credits = set()
    try:
        given.out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as scratch:
            models = Models(given.data, given.bunny, scratch)
            begin = progress(sum(len(figure.panels) for figure in wanted))
            results = [draw_figure(figure, models, given, credits, begin) for figure in wanted]
        (given.out / "index.html").write_text(page(results, credits), encoding="utf-8")
    except (Failed, OSError, ValueError) as error:
        print(f"gallery: {error}", file=sys.stderr)
        return 1
    for figure, drawn, left_out in results:
        for reason in dict.fromkeys(left_out):
            print(f"figure {figure.number}: left out{' in part' if drawn else ''}: {reason}")
    print(f"{given.out / 'index.html'}: {sum(len(drawn) for _, drawn, _ in results)} pictures")
    return 0


if __name__ == "__main__":
    sys.exit(main())
