# SPDX-License-Identifier: MIT
"""The command line's grammar: the options of a drawing are those of `_options.py`."""
from __future__ import annotations

import argparse
import re
import sys
from typing import Any, Callable, List, NoReturn, Optional, Sequence

from .. import __version__
from .. import _values as values
from .._names import PRESETS
from .._options import OPTIONS, Option
from .._request import BY_NAME, Options
from ..shapes._read import READ

DEFAULT_STYLE = "contour-and-stipple"
VIEWS = {
    "front": (0.0, 0.0), "right": (90.0, 0.0), "back": (180.0, 0.0), "left": (-90.0, 0.0),
    "top": (0.0, 89.0), "bottom": (0.0, -89.0),
}  # fmt: skip
SHEET_VIEWS = ("front", "back", "left", "right", "top", "bottom", "iso")
SMOOTH = ("ridges", "valleys", "suggestive")
_TITLES = {"vectors": "of .svg, .pdf, .hpgl (.plt) and .gcode (.nc, .ngc)"}
_DRAWING = ("", "style", "camera", "marks", "fit", "samples", "vectors")
_SURFACE = ("fit", "samples")


class Parser(argparse.ArgumentParser):
    """Errors are one line."""

    def error(self, message: str) -> NoReturn:
        sys.stderr.write(f"hrbfnpr: error: {message} (see {self.prog} --help)\n")
        sys.exit(2)

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        # argparse takes "-1,0,0" for an option; glued to the option before, it is a value.
        given: List[str] = []
        for word in sys.argv[1:] if args is None else args:
            if given and given[-1].startswith("--") and "=" not in given[-1] and re.match(r"-[\d.]|-[xyz](:|$)", word):
                given[-1] += "=" + word
            else:
                given.append(word)
        return super().parse_args(given, namespace)


def options_of(arguments: Any) -> Options:
    """The options of a drawing that were given."""
    found = {row.name: getattr(arguments, f"option_{row.name}", None) for row in OPTIONS}
    return {name: value.replace("-", "_") if BY_NAME[name].choices else value for name, value in found.items()
            if value is not None and value is not False and value != []}  # fmt: skip


def _add_option(group: Any, row: Option) -> None:
    words, dest = row.words.replace("%", "%%"), f"option_{row.name}"
    name = "--" + row.name.replace("_", "-")
    if row.kind == "flag":
        group.add_argument(name, dest=dest, action="store_true", help=words)
    elif row.choices:
        shown = [choice.replace("_", "-") for choice in row.choices]
        words = f"{words}: {', '.join(shown)}"
        group.add_argument(name, dest=dest, default=None, choices=shown, metavar=row.metavar, help=words)
    elif row.kind == "assignment":
        group.add_argument(name, dest=dest, action="append", default=[], type=values.assignment, metavar=row.metavar, help=words)
    else:
        group.add_argument(name, dest=dest, default=None, type=values.parser_of(row.kind), metavar=row.metavar, help=words)


def _add_groups(parser: Parser, groups: Sequence[str], without: Sequence[str] = ()) -> None:
    for title in groups:
        group = parser.add_argument_group(title, _TITLES.get(title)) if title else parser
        for row in OPTIONS:
            if row.group == title and row.name not in without:
                _add_option(group, row)
        if title == "style":
            group.add_argument("--style", default=None, choices=PRESETS, metavar="NAME", help="named style, "
                               f"{DEFAULT_STYLE} by default: {', '.join(PRESETS)}")  # fmt: skip
        if title == "marks":
            group.add_argument("--budget", dest="option_marks", type=values.per_layer, help=argparse.SUPPRESS)


def _add(group: Any, option: str, kind: Any, metavar: str, words: str, default: Any = None, **more: Any) -> None:
    group.add_argument(option, type=kind, metavar=metavar, help=words, default=default, **more)


def _add_common(parser: Parser) -> None:
    group = parser.add_argument_group("general")
    _add(group, "--threads", values.count(0, 256), "N", "threads, 0 = all processors (default)")
    group.add_argument("-q", "--quiet", action="store_true", help="warnings and errors only")


def _add_output(parser: Parser, ending: str, what: str = "picture, or vectors where the command draws them (.svg, .pdf, "
                ".hpgl, .gcode)") -> None:  # fmt: skip
    words = f"{what}; INPUT's name with {ending} by default"
    parser.add_argument("output", metavar="OUTPUT", nargs="?", help=words)
    parser.add_argument("-o", "--output", dest="output_option", metavar="OUTPUT", help="the same as an option")


def _add_cells(parser: Parser) -> None:
    group = parser.add_argument_group("sheet")
    _add(group, "--styles", values.styles, "NAMES", f"named styles, all by default: {', '.join(PRESETS)}")
    _add(group, "--views", values.one_of("view", VIEWS), "NAMES", "each style from these sides, instead of --azimuth and "
         f"--elevation: {', '.join(VIEWS)}")  # fmt: skip
    _add(group, "--size", values.count(16, 4096), "PIXELS", "longer side of each drawing; 640", dest="option_size")
    _add(group, "--columns", values.count(1), "N", "drawings beside each other; as many as make the sheet about square, or "
         "one for each view")  # fmt: skip


def _add_turn(parser: Parser) -> None:
    _add_output(parser, ".gif", "animation (.gif, .png or .apng, .mp4), or pictures where it has a number, such as %%03d.png")
    group = parser.add_argument_group("turntable")
    _add(group, "--frames", values.count(1, 100_000), "N", "how many; 36", 36)
    _add(group, "--fps", values.number, "N", "frames in a second; 12", 12.0)
    _add(group, "--turn", values.number, "DEGREES", "of the camera about the up axis, from --azimuth on; 360", 360.0)
    _add(group, "--loops", values.count(0, 65535), "N", "how often .gif and .png are shown, 0 = without end; 0", 0)
    _add(group, "--size", values.size, "WxH", "pixels, or the longer side alone; 480", 480, dest="option_size")


def _cut(text: str) -> str:
    """AXIS, AXIS:PLACE or A:B:C:D, where A x + B y + C z = D."""
    parts = text.split(":")
    if parts[0].lstrip("+-") in ("x", "y", "z") and len(parts) <= 2:
        for part in parts[1:]:
            values.number(part)
        return text
    if len(parts) == 4 and any([values.number(part) for part in parts][:3]):
        return text
    raise values.wrong(f"{text!r} must be AXIS:PLACE, such as z:20, AXIS alone for the middle, or the plane A:B:C:D, where "
                       "Ax + By + Cz = D")  # fmt: skip


def _scale(text: str) -> str:
    drawn, _, real = text.partition(":")
    try:
        value = 1.0 if text == "auto" else float(drawn) / float(real)
    except (ValueError, ZeroDivisionError):
        value = 0.0
    if not 0 < value < float("inf"):
        raise values.wrong(f"must be such as 1:2, 2:1 or 1:1, or auto, not {text!r}")
    return text


def _smooth(text: str) -> Optional[str]:
    for name in () if text == "none" else text.split(","):
        if name not in SMOOTH:
            raise values.wrong(f"there are no edges {name!r}; there are {', '.join(SMOOTH)} and none")
    return text


def _paper(text: str) -> str:
    return "auto" if text.lower() == "auto" else values.page(text)


def _add_views(parser: Parser) -> None:
    """Names are those of hrbfnpr_views_desc."""
    group = parser.add_argument_group("sheet")
    _add(group, "--views", values.one_of("view", SHEET_VIEWS), "NAMES", f"with commas between: {', '.join(SHEET_VIEWS)}; "
         "front, top, iso and the side that is on the right by default")  # fmt: skip
    group.add_argument("--section", type=_cut, action="append", default=[], metavar="AXIS:PLACE", help="a section by the "
                       "plane, such as z:20; -z:20 is seen from below, z is through the middle, 1:1:0:5 is x + y = 5; may be "
                       "repeated")  # fmt: skip
    group.add_argument("--projection", choices=("first", "third"), default="first", metavar="NAME", help="where views are: "
                       "first angle (default), the left view at the right, or third angle")  # fmt: skip
    _add(group, "--page", _paper, "PAPER", "a4, a3, ... lying, WIDTHxHEIGHT in mm, or auto (default): the smallest of a4 to "
         "a0 that holds the views; a3 where the scale is auto, too")  # fmt: skip
    _add(group, "--scale", _scale, "N:M", "such as 1:2, or auto (default): the largest of 1, 2, 5, 10, ... that fits the page")
    _add(group, "--unit-mm", values.positive, "MM", "millimetres of a unit of the model; 1, of glTF 1000")
    group.add_argument("--hidden", choices=("dashed", "none", "shown"), default="dashed", metavar="NAME", help="hidden edges: "
                       "dashed (default), none or shown")  # fmt: skip
    _add(group, "--smooth", _smooth, "KINDS", f"edges that are not sharp, as thin lines: {', '.join(SMOOTH)}; none by default")
    _add(group, "--crease-angle", values.positive, "DEGREES", "edges of a mesh are sharp if its faces meet at more than this; "
         "30")  # fmt: skip
    _add(group, "--line-width", values.positive, "MM", "of outlines; thin lines are half as wide; 0.5")
    _add(group, "--hatch-spacing", values.positive, "MM", "of lines in cut faces; 3")
    _add(group, "--spacing", values.positive, "MM", "between views; 15")
    group.add_argument("--centre-lines", action="store_true", help="of planes of symmetry")
    group.add_argument("--labels", action="store_true", help="write the views' names above them; sections have theirs always")
    group.add_argument("--title", metavar="TEXT", help="in the title block; the file's name without its ending by default")
    _add_option(group, next(row for row in OPTIONS if row.name == "up"))


def _add_drawing(draw: Parser) -> None:
    _add_output(draw, ".png")
    draw.add_argument("--also", action="append", default=[], metavar="FILE", help="the same drawing in another format; "
                      "may be repeated")  # fmt: skip
    draw.add_argument("--save-model", metavar="FILE", help="save the model too")
    draw.add_argument("--save-points", metavar="FILE", help="save the marks too")
    draw.add_argument("--settings", metavar="FILE", help="draw by a file of settings, as hrbfnpr-view saves them; other "
                      "options win over it (docs/settings.md)")  # fmt: skip
    draw.add_argument("--save-settings", metavar="FILE", help="save what the drawing was made with, for --settings")
    _add_groups(draw, _DRAWING)


def build() -> Parser:
    """The whole grammar."""
    parser = Parser(prog="hrbfnpr", description="Pen-and-ink drawings of surfaces given by points and normals.")
    parser.add_argument("--version", action="version", version=f"hrbfnpr {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    source = "a mesh or points with normals (check --help lists the formats), a script of solids (.csg), a saved model"

    def add(name: str, short: str, long: str, fill: Callable[[Parser], None], what: str, metavar: str = "INPUT",
            nargs: Any = None) -> None:  # fmt: skip
        command = commands.add_parser(name, help=short, description=long)
        command.add_argument("input", metavar=metavar, nargs=nargs, help=what)
        fill(command)
        _add_common(command)

    def add_sheet(sheet: Parser) -> None:
        _add_output(sheet, "-sheet.png")
        _add_cells(sheet)
        _add_groups(sheet, ("style", "camera", "marks", *_SURFACE))

    def add_turntable(turn: Parser) -> None:
        _add_turn(turn)
        _add_groups(turn, ("", "style", "camera", "marks", *_SURFACE), without=("size",))

    def add_views(views: Parser) -> None:
        _add_output(views, "-views.svg", "vectors (.svg, .pdf, .hpgl, .gcode)")
        _add_views(views)
        _add_groups(views, _SURFACE)

    def add_saved(what: str, groups: Sequence[str]) -> Callable[[Parser], None]:
        def fill(command: Parser) -> None:
            command.add_argument("output", metavar="OUTPUT", help=what)
            _add_groups(command, groups)

        return fill

    def add_json(command: Parser) -> None:
        command.add_argument("--json", action="store_true", help="as JSON")

    marks_too = f"{source} or point set"
    add("draw", "draw a picture", "Draw a picture.", _add_drawing, marks_too)
    add("csg", "put solids together and draw them", "Draw the solid that a script puts together from boxes, cylinders, files "
        "and others: docs/csg.md.", _add_drawing, "lines of `name = solid`; the last one is drawn", "SCRIPT")  # fmt: skip
    add("sheet", "draw a model in all styles, on one picture", "Draw a model in all named styles on one picture: each as draw "
        "does at this size.", add_sheet, source)  # fmt: skip
    add("turntable", "draw an orbit as an animation", "Draw an orbit about a model as an animation.", add_turntable, marks_too)
    add("sheet-views", "draw views and sections on a sheet, to scale", "Draw views and sections of a model on a sheet, to "
        "scale, by the conventions of technical drawing.", add_views, source)  # fmt: skip
    add("fit", "fit a model and save it", "Fit a model and save it.", add_saved("the model", _SURFACE),
        "a mesh or points with normals")  # fmt: skip
    add("points", "place marks and save them", "Place marks and save them.",
        add_saved("the point set, or its marks as .ply", ("marks", *_SURFACE)), source)  # fmt: skip
    add("check", "look at a file without drawing it", "Look at a file without drawing it: what it holds, what is wrong with "
        f"it, what a fit would repair, and what to do. Read are {READ}. Exit status: 0 fine, 1 warnings, 2 unusable.",
        add_json, "a mesh or points, a saved model or point set", "FILE")  # fmt: skip
    add("info", "tell about a file or the library", "Tell about a file, or, without one, about the library.", add_json,
        marks_too, "FILE", "?")  # fmt: skip
    return parser
