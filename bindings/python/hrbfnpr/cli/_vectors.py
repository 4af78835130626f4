# SPDX-License-Identifier: MIT
"""Drawings as vectors: on which paper, with which pens."""
from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .. import __version__
from .._arrays import Array
from .._drawing_info import DrawingLayerInfo
from .._names import DOT_SHAPES, LINE_TYPES, WIDTHS, number_of
from .._page import PIXEL, PageInfo, PageItem, Pen, format_of, write_page
from .._fields import color
from ._progress import Reporter
from ._values import number

PLOTTERS = ("hpgl", "gcode")
# Millimetres, upright.
PAPERS = {
    "a0": (841.0, 1189.0), "a1": (594.0, 841.0), "a2": (420.0, 594.0), "a3": (297.0, 420.0), "a4": (210.0, 297.0),
    "a5": (148.0, 210.0), "a6": (105.0, 148.0), "letter": (215.9, 279.4), "legal": (215.9, 355.6),
    "tabloid": (279.4, 431.8),
}  # fmt: skip
PAPER_MARGIN = 10.0  # mm


def page(text: str) -> "Tuple[float, float]":
    """A paper's name, or WIDTHxHEIGHT in millimetres."""
    if text.lower() in PAPERS:
        return PAPERS[text.lower()]
    width, _, height = text.lower().partition("x")
    try:
        size = float(width), float(height)
    except ValueError:
        size = 0.0, 0.0
    if not (0 < size[0] < 1e6 and 0 < size[1] < 1e6):
        names = ", ".join(PAPERS)
        raise argparse.ArgumentTypeError(f"must be one of {names}, or WIDTHxHEIGHT in mm, such as 210x297, not {text!r}")
    return size


def pens(text: str) -> List[Pen]:
    """GROUP=COLOUR[:WIDTH[:TYPE]], with commas between; a colour or a width that is left out is as drawn."""
    found = []
    for i, part in enumerate(filter(None, text.split(","))):
        groups, equals, rest = part.partition("=")
        ink, width, kind, *more = [*rest.split(":"), "", "", ""]
        if not equals or not groups or any(more):
            raise argparse.ArgumentTypeError(
                f"{part!r} must be GROUP=COLOUR:WIDTH or GROUP=COLOUR:WIDTH:TYPE, such as contour=#000000:0.5 or "
                "hatch*=:0.3:dashed"
            )
        try:
            line_type = kind or "as_drawn"
            number_of("type", LINE_TYPES, line_type)
            found.append(Pen(groups, _width(width), color("colour", ink) if ink else None, i + 1, line_type))
        except ValueError as error:
            raise argparse.ArgumentTypeError(f"{part!r}: {error}") from None
    return found


def _width(text: str) -> float:
    width = number(text) if text else 0.0
    if not 0 <= width < 1e3:
        raise ValueError(f"a width must be from 0 to 1000 mm, not {text}")
    return width


def pen_widths(text: str) -> List[float]:
    """Of the pens at hand, mm."""
    widths = sorted(number(part) for part in text.split(",") if part)
    if not widths or not 0 < widths[0] <= widths[-1] < 1e3:
        raise argparse.ArgumentTypeError(f"must be widths above 0 in mm with commas between, not {text!r}")
    return widths


def add_options(parser: Any) -> None:
    """Those of the command line."""
    group = parser.add_argument_group("vectors", "of .svg, .pdf, .hpgl (.plt) and .gcode (.nc, .ngc)")
    add = group.add_argument
    add("--page", type=page, metavar="PAPER", help=f"paper that the drawing fills but for {PAPER_MARGIN:g} mm, turned "
        "as it fits better: a4, a3, letter, ... or WIDTHxHEIGHT in mm; by default a pixel is 1/96 inch")  # fmt: skip
    add("--page-margin", type=number, metavar="MM", help="free on each side of --page; 10")
    add("--dots", choices=tuple(DOT_SHAPES), metavar="NAME", help="of stipples: circles, lines of no length that a pen "
        "touches the paper with, or spirals that fill them; circles, which plotters fill unless --single-pass")
    add("--stroke-widths", choices=tuple(WIDTHS), metavar="NAME", help="of strokes that swell: outlines, or classes of "
        "even widths; outlines")  # fmt: skip
    add("--pens", type=pens, metavar="GROUP=COLOUR:MM", help="pens of groups, with commas between, such as "
        "contour=#000000:0.5,hatch*=#803000:0.3; a third part is a line type of ISO 128, such as dashed")  # fmt: skip
    add("--pen-widths", type=pen_widths, metavar="MM,MM", help="widths of the pens at hand: each group gets the one "
        "that is nearest to its lines' median width, or to its dots' median diameter")  # fmt: skip
    add("--single-pass", action="store_true", help="draw a line that is wider than its pen once, along its centre, and "
        "touch the paper for a dot; else plotters, and pens in --plot-order, fill both by several passes")  # fmt: skip
    add("--plot-order", action="store_true", help="sort lines so that a pen travels little; plotters' files always are")
    add("--vector-tolerance", type=number, metavar="MM", help="between what is drawn and what is written; 0.05")
    add("--draw-speed", type=number, metavar="MM/S", help="of a plotter's pen, for the time it takes; 30")
    add("--pen-up", metavar="GCODE", help="raises the pen in .gcode; G0 Z5")
    add("--pen-down", metavar="GCODE", help="lowers it; G1 Z0")


def is_vector(path: Any) -> bool:
    """Whether the file's ending means vectors."""
    return format_of(path) is not None


def given(arguments: Any) -> List[str]:
    """Options of vectors that were given."""
    names = ("page", "page_margin", "dots", "stroke_widths", "pens", "pen_widths", "plot_order", "single_pass",
             "vector_tolerance", "draw_speed", "pen_up", "pen_down")  # fmt: skip
    return [f"--{name.replace('_', '-')}" for name in names if getattr(arguments, name, None) not in (None, False)]


def placed(size: Tuple[float, float], arguments: Any) -> Tuple[float, float, float, Dict[str, float]]:
    """Left, top and millimetres of a pixel of what is so many pixels large, and the page's size if it was asked for."""
    if arguments.page is None:
        return 0.0, 0.0, PIXEL, {}
    width, height = arguments.page
    if (width > height) != (size[0] > size[1]):
        width, height = height, width
    margin = PAPER_MARGIN if arguments.page_margin is None else arguments.page_margin
    room = width - 2 * margin, height - 2 * margin
    if margin < 0 or min(room) <= 0:
        raise ValueError(f"--page-margin {margin:g} must be 0 or more, and leave room on a page of {width:g} x {height:g} mm")
    scale = min(room[0] / size[0], room[1] / size[1])
    left, top = (width - scale * size[0]) / 2, (height - scale * size[1]) / 2
    return left, top, scale, {"width": width, "height": height}


@dataclass
class Nearest:
    """A pen for a group, and how wide what it draws is."""

    pen: Pen
    what: str
    width: float

    def __str__(self) -> str:
        return f"{self.pen.groups.rstrip('*')} {self.pen.width:g} mm ({self.what} of {self.width:.2g})"


def _group_of(layer: DrawingLayerInfo) -> str:
    """What its groups' names begin with."""
    if layer.layer >= 0:
        return layer.name + (" contour" if layer.mark_class == "silhouette" else "")
    return layer.name if layer.name and layer.kind == "own" else layer.kind.replace("_contour", "").replace("_", " ")


def nearest_pens(items: Sequence[PageItem], widths: Sequence[float]) -> List[Nearest]:
    """For each layer the pen that is nearest to the median width of its lines, or diameter of its dots; mm."""
    drawn: Dict[Tuple[str, str], List[Array]] = {}
    for item in items:
        dots = item.drawing.vertices("points", ("radius", "layer"))[0]
        for i, layer in enumerate(item.drawing.layers):
            lines = [stroke["radius"] for stroke in item.drawing.polylines(i)] if layer.strokes else []
            found = np.concatenate(lines) if lines else dots["radius"][dots["layer"] == i]
            if len(found):
                drawn.setdefault((_group_of(layer), "lines" if lines else "dots"), []).append(2 * item.scale * found)
    chosen = []
    for (name, what), parts in sorted(drawn.items()):  # "stipples contour" behind "stipples": the last that fits is taken
        width = float(np.median(np.concatenate(parts)))
        best = min(range(len(widths)), key=lambda k: abs(widths[k] - width))
        chosen.append(Nearest(Pen(f"{name}*", widths[best], None, best + 1), what, width))
    return chosen


def write(
    arguments: Any, items: Sequence[PageItem], size: Tuple[float, float], path: Path, annotations: Sequence[Any],
    metadata: str, report: Reporter,
) -> PageInfo:  # fmt: skip
    """Write drawings, placed in pixels, whose box has so many of them."""
    format = format_of(path)
    left, top, scale, page_size = placed(size, arguments)
    on_page = [PageItem(one.drawing, left + scale * one.x, top + scale * one.y, scale, one.name) for one in items]
    for annotation in annotations:
        annotation.points = np.asarray(annotation.points, dtype=float) * scale + (left, top)
        annotation.width *= scale
    if not page_size:
        page_size = {"width": scale * size[0], "height": scale * size[1]}
    chosen: List[Pen] = []
    if arguments.pen_widths is not None:
        nearest = nearest_pens(on_page, arguments.pen_widths)
        chosen += [one.pen for one in nearest]
        report.note("pens: " + ", ".join(map(str, nearest)))
    chosen += arguments.pens or []
    dots: Optional[str] = arguments.dots or ("lines" if format in PLOTTERS and arguments.single_pass else "circles")
    options = {"tolerance": arguments.vector_tolerance, "draw_speed": arguments.draw_speed, "pen_up": arguments.pen_up,
               "pen_down": arguments.pen_down}  # fmt: skip
    info = write_page(
        path, on_page, format=format, pens=chosen, annotations=annotations, dots=dots,
        widths=arguments.stroke_widths or "outlines", plot_order=arguments.plot_order,
        single_pass=arguments.single_pass, title=Path(arguments.input).name,
        description=f"Drawn by hrbfnpr {__version__}", metadata=metadata, **page_size,
        **{name: value for name, value in options.items() if value is not None},
    )  # fmt: skip
    if arguments.plot_order or format in PLOTTERS:
        report.note(_plotted(info))
    return info


def _plotted(info: PageInfo) -> str:
    minutes, seconds = divmod(round(info.seconds), 60)
    text = (
        f"the pen draws {info.drawn / 1000:.2f} m and travels {info.travelled / 1000:.2f} m, in about {minutes} min "
        f"{seconds} s"
    )
    if info.filled_paths:
        text += f"; {info.filled_paths} lines wider than their pen are filled by several passes"
    if info.joined:
        text += f"; {info.joined} ends joined"
    left_out = [f"{count} {what}" for count, what in ((info.dropped_paths, "lines"), (info.dropped_dots, "dots")) if count]
    return text + (f"; {' and '.join(left_out)} left out, too fine for the pen" if left_out else "")
