# SPDX-License-Identifier: MIT
"""The grammar of the command line.  The options of drawings come from the table in `_options.py`."""
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
_TITLES = {"vectors": "for outputs .svg, .pdf, .hpgl (.plt), .gcode (.nc, .ngc) and .dxf"}
_DRAWING_GROUPS = ("", "style", "camera", "marks", "fit", "samples", "vectors")
_SURFACE_GROUPS = ("fit", "samples")


class Parser(argparse.ArgumentParser):
    """A parser that prints an error as one line, without the usage.

    `add_options` adds the options of a command when they are first needed, because a run needs those of one command only.
    Options of a command may stand before, between and after its files.
    """

    add_options: Optional[Callable[[Parser], None]] = None

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        if self.add_options is not None:
            add, self.add_options = self.add_options, None
            add(self)
            if "--" not in args:  # after it, a name that begins with a hyphen may follow
                return self.parse_known_intermixed_args(args, namespace)
        return super().parse_known_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        sys.stderr.write(f"hrbfnpr: error: {message} (see {self.prog} --help)\n")
        sys.exit(2)

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        # argparse mistakes the value "-1,0,0" for an option.  Join it with the option before, as --option=-1,0,0.
        given: List[str] = []
        for word in sys.argv[1:] if args is None else args:
            if word == "--ground":  # its value is optional, and may stand before a file
                given.append("--ground=lowest")
            elif given and given[-1].startswith("--") and "=" not in given[-1] and re.match(r"-[\d.]|-[xyz](:|$)", word):
                given[-1] += "=" + word
            else:
                given.append(word)
        return super().parse_args(given, namespace)


def options_of(arguments: Any) -> Options:
    """The options of the drawing that are on the command line, by name."""
    found = {row.name: getattr(arguments, f"option_{row.name}", None) for row in OPTIONS}
    if found["light"]:
        found["light"] = ";".join(found["light"])
    given = {name: value for name, value in found.items() if value is not None and value is not False and value != []}
    return {name: _plain(BY_NAME[name], value) for name, value in given.items()}


def _plain(row: Option, value: Any) -> Any:
    """The value of an option as `hrbfnpr.draw` has it."""
    if row.choices:
        return value.replace("-", "_")
    return ",".join(value) if row.kind == "fields" else value


def _add_option(group: Any, row: Option) -> None:
    words, dest = row.words.replace("%", "%%"), f"option_{row.name}"
    name = "--" + row.name.replace("_", "-")
    if row.kind == "flag":
        group.add_argument(name, dest=dest, action="store_true", help=words)
    elif row.choices:
        shown = [choice.replace("_", "-") for choice in row.choices]
        words = f"{words}; one of {', '.join(shown)}"
        group.add_argument(name, dest=dest, default=None, choices=shown, metavar=row.metavar, help=words)
    elif row.kind == "lights":
        group.add_argument(name, dest=dest, action="append", default=[], type=values.light, metavar=row.metavar, help=words)
    elif row.kind in ("assignment", "fields"):  # may be given more than once
        parse = values.parser_of(row.kind)
        group.add_argument(name, dest=dest, action="append", default=[], type=parse, metavar=row.metavar, help=words)
    else:
        group.add_argument(name, dest=dest, default=None, type=values.parser_of(row.kind), metavar=row.metavar, help=words)


def _add_groups(parser: Parser, groups: Sequence[str], without: Sequence[str] = ()) -> None:
    for title in groups:
        group = parser.add_argument_group(title, _TITLES.get(title)) if title else parser
        for row in OPTIONS:
            if row.group == title and row.name not in without:
                _add_option(group, row)
        if title == "style":
            group.add_argument("--style", default=None, choices=PRESETS, metavar="NAME", help="style of the "
                               f"drawing, one of {', '.join(PRESETS)} (default: {DEFAULT_STYLE})")  # fmt: skip
        if title == "marks":
            group.add_argument("--budget", dest="option_marks", type=values.per_layer, help=argparse.SUPPRESS)


def _add(group: Any, option: str, kind: Any, metavar: str, words: str, default: Any = None, **more: Any) -> None:
    group.add_argument(option, type=kind, metavar=metavar, help=words, default=default, **more)


def _add_common(parser: Parser) -> None:
    group = parser.add_argument_group("general")
    _add(group, "--threads", values.count(0, 256), "N", "number of threads, 0 to 256; 0 uses all processors (default: 0)")
    either = group.add_mutually_exclusive_group()
    either.add_argument("-q", "--quiet", action="store_true", help="print only warnings and errors")
    either.add_argument("-v", "--verbose", action="store_true", help="print the details of notes and warnings too")


def _add_output(parser: Parser, ending: str, what: str = "file of the picture, or of vectors if the command draws them (.svg, "
                ".pdf, .hpgl, .gcode, .dxf)") -> None:  # fmt: skip
    words = f"{what} (default: the name of INPUT with {ending})"
    parser.add_argument("output", metavar="OUTPUT", nargs="?", help=words)
    parser.add_argument("-o", "--output", dest="output_option", metavar="OUTPUT", help="the output, given as an option")


def _add_cells(parser: Parser) -> None:
    group = parser.add_argument_group("sheet")
    _add(group, "--styles", values.styles, "NAMES", f"styles, with commas between: {', '.join(PRESETS)} (default: all)")
    _add(group, "--views", values.one_of("view", VIEWS), "NAMES", "views of each style, with commas between, in place of "
         f"--azimuth and --elevation: {', '.join(VIEWS)}")  # fmt: skip
    _add(group, "--size", values.count(16, 4096), "PIXELS", "longer side of each drawing in pixels, 16 to 4096 (default: 640)",
         dest="option_size")  # fmt: skip
    _add(group, "--columns", values.count(1), "N", "number of drawings side by side (default: one for each view, or as "
         "many as make the sheet about square)")  # fmt: skip


def _add_turn(parser: Parser) -> None:
    _add_output(parser, ".gif", "animation (.gif, .png, .apng or .mp4), or pictures if the name has a number, such as "
                "%%03d.png")  # fmt: skip
    group = parser.add_argument_group("turntable")
    _add(group, "--frames", values.count(1, 100_000), "N", "number of frames, 1 to 100000 (default: 36)", 36)
    _add(group, "--fps", values.number, "N", "frames per second, above 0, at most 1000 (default: 12)", 12.0)
    _add(group, "--turn", values.number, "DEGREES", "angle that the camera turns around the up axis, from --azimuth "
         "(default: 360)", 360.0)  # fmt: skip
    _add(group, "--loops", values.count(0, 65535), "N", "how often .gif and .png play, 0 to 65535; 0 is for ever "
         "(default: 0)", 0)  # fmt: skip
    _add(group, "--size", values.size, "WxH", "size of the frames in pixels, or the longer side alone (default: 480)", 480,
         dest="option_size")  # fmt: skip


def _cut(text: str) -> str:
    """Check the plane of a section: AXIS, AXIS:PLACE, or A:B:C:D for A x + B y + C z = D."""
    parts = text.split(":")
    if parts[0].lstrip("+-") in ("x", "y", "z") and len(parts) <= 2:
        for part in parts[1:]:
            values.number(part)
        return text
    if len(parts) == 4 and any([values.number(part) for part in parts][:3]):
        return text
    raise values.wrong(f"{text!r} is not a plane: write z:20, z for the middle, or A:B:C:D for Ax + By + Cz = D")  # fmt: skip


def _scale(text: str) -> str:
    drawn, _, real = text.partition(":")
    try:
        value = 1.0 if text == "auto" else float(drawn) / float(real)
    except (ValueError, ZeroDivisionError):
        value = 0.0
    if not 0 < value < float("inf"):
        raise values.wrong(f"auto or a scale like 1:2, 2:1 or 1:1 is needed, not {text!r}")
    return text


def _smooth(text: str) -> Optional[str]:
    for name in () if text == "none" else text.split(","):
        if name not in SMOOTH:
            raise values.wrong(f"there are no edges {name!r}; there are {', '.join(SMOOTH)} and none")
    return text


def _paper(text: str) -> str:
    return "auto" if text.lower() == "auto" else values.page(text)


def _add_views(parser: Parser) -> None:
    """Add the options of a sheet of views.  Their names are those of the fields of hrbfnpr_views_desc."""
    group = parser.add_argument_group("sheet")
    _add(group, "--views", values.one_of("view", SHEET_VIEWS), "NAMES", f"views, with commas between: {', '.join(SHEET_VIEWS)} "
         "(default: front, top, iso and the side view on the right)")  # fmt: skip
    group.add_argument("--section", type=_cut, action="append", default=[], metavar="AXIS:PLACE", help="plane of a "
                       "section: z:20 is z = 20, -z:20 is the same seen from below, z cuts through the middle, 1:1:0:5 is "
                       "x + y = 5; may be repeated")  # fmt: skip
    group.add_argument("--projection", choices=("first", "third"), default="first", metavar="NAME", help="order of "
                       "the views: first angle, with the left view on the right, or third angle (default: first)")  # fmt: skip
    _add(group, "--page", _paper, "PAPER", "landscape paper: a0 to a6, WIDTHxHEIGHT in mm, or auto, which takes a3, or with "
         "--scale the smallest of a4 to a0 that holds the views (default: auto)")  # fmt: skip
    _add(group, "--scale", _scale, "N:M", "scale, such as 1:2, or auto, which takes the largest of 1:1, 1:2, 1:5, 2:1, ... "
         "that fits the page (default: auto)")
    _add(group, "--unit-mm", values.positive, "MM", "length of a unit of the model in mm, above 0 (default: 1, or 1000 "
         "for glTF)")  # fmt: skip
    group.add_argument("--hidden", choices=("dashed", "none", "shown"), default="dashed", metavar="NAME", help="hidden edges: "
                       "dashed, none or shown (default: dashed)")  # fmt: skip
    group.add_argument("--tangent", choices=("short", "thin", "none"), default="short", metavar="NAME", help="edges of "
                       "fillets and other edges without a kink: short (thin lines that touch no outline), thin or none "
                       "(default: short)")  # fmt: skip
    _add(group, "--smooth", _smooth, "KINDS", "rounded edges to draw as thin lines, with commas between: "
         f"{', '.join(SMOOTH)} or none (default: none)")
    _add(group, "--crease-angle", values.positive, "DEGREES", "angle in degrees above which an edge between faces is sharp "
         "(default: 30)")  # fmt: skip
    _add(group, "--line-width", values.positive, "MM", "width of outlines in mm; thin lines are half as wide (default: 0.5)")
    _add(group, "--hatch-spacing", values.positive, "MM", "distance of hatch lines in cut faces in mm (default: 3)")
    _add(group, "--spacing", values.positive, "MM", "distance between views in mm (default: 15)")
    group.add_argument("--centre-lines", action="store_true", help="draw centre lines of planes of symmetry")
    group.add_argument("--labels", action="store_true", help="write the name of each view above it, as sections always have")
    group.add_argument("--verify", action="store_true", help="compare all lines with rays, repair wrong pieces, and say how "
                       "many agree")  # fmt: skip
    group.add_argument("--title", metavar="TEXT", help="title in the title block (default: the file name without its ending)")
    _add_option(group, next(row for row in OPTIONS if row.name == "up"))


def _add_drawing(draw: Parser) -> None:
    _add_output(draw, ".png")
    draw.add_argument("--also", action="append", default=[], metavar="FILE", help="another file for the same drawing, "
                      "such as a .pdf; may be repeated")  # fmt: skip
    draw.add_argument("--save-model", metavar="FILE", help="save the fitted model too, as .hrbf")
    draw.add_argument("--save-points", metavar="FILE", help="save the marks too, as .hrbm")
    draw.add_argument("--settings", metavar="FILE", help="file of settings, from --save-settings or hrbfnpr-view; other "
                      "options override it (docs/settings.md)")  # fmt: skip
    draw.add_argument("--save-settings", metavar="FILE", help="save the settings of the drawing, for --settings")
    _add_groups(draw, _DRAWING_GROUPS)


def build() -> Parser:
    """The parser of all commands."""
    parser = Parser(prog="hrbfnpr", description="Draw surfaces in pen and ink, from meshes, scans and points.")
    parser.add_argument("--version", action="version", version=f"hrbfnpr {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    source = "a mesh or points with normals (check --help lists the formats), a script of solids (.csg), a saved model"

    def add(name: str, short: str, long: str, fill: Callable[[Parser], None], what: str, metavar: str = "INPUT",
            nargs: Any = None) -> None:  # fmt: skip
        command = commands.add_parser(name, help=short, description=long)

        def add_options(parser: Parser) -> None:
            parser.add_argument("input", metavar=metavar, nargs=nargs, help=what)
            fill(parser)
            _add_common(parser)

        command.add_options = add_options

    def add_sheet(sheet: Parser) -> None:
        _add_output(sheet, "-sheet.png")
        _add_cells(sheet)
        _add_groups(sheet, ("style", "camera", "marks", *_SURFACE_GROUPS))

    def add_turntable(turn: Parser) -> None:
        _add_turn(turn)
        _add_groups(turn, ("", "style", "camera", "marks", *_SURFACE_GROUPS), without=("size",))

    def add_views(views: Parser) -> None:
        _add_output(views, "-views.svg", "file of the sheet (.svg, .pdf, .hpgl, .gcode, .dxf)")
        _add_views(views)
        _add_groups(views, _SURFACE_GROUPS)

    def add_saved(what: str, groups: Sequence[str]) -> Callable[[Parser], None]:
        def fill(command: Parser) -> None:
            command.add_argument("output", metavar="OUTPUT", help=what)
            _add_groups(command, groups)

        return fill

    def add_json(command: Parser) -> None:
        command.add_argument("--json", action="store_true", help="print JSON, for programs")

    marks_too = f"{source} or point set"
    add("draw", "draw a picture", "Draw a picture.", _add_drawing, marks_too)
    add("csg", "combine solids and draw the result", "Draw the solid that a script combines from boxes, cylinders, files and "
        "others; see docs/csg.md.", _add_drawing, "script with lines of `name = solid`; it draws the last one", "SCRIPT")  # fmt: skip
    add("sheet", "draw a model in all styles, in one picture", "Draw a model in several styles in one picture, each as the "
        "command draw does at this size.", add_sheet, source)  # fmt: skip
    add("turntable", "draw an animation that turns around a model", "Draw an animation in which the camera turns around a "
        "model.", add_turntable, marks_too)  # fmt: skip
    add("sheet-views", "draw views and sections to scale", "Draw views and sections of a model to scale on a sheet, by the "
        "conventions of technical drawing.", add_views, source)  # fmt: skip
    add("fit", "fit a model and save it", "Fit a model and save it.", add_saved("file of the model, .hrbf", _SURFACE_GROUPS),
        "a mesh or points with normals")  # fmt: skip
    add("points", "place marks and save them", "Place marks and save them.",
        add_saved("file of the marks, .hrbm or .ply", ("marks", *_SURFACE_GROUPS)), source)  # fmt: skip
    add("check", "report what is in a file and what is wrong with it", "Print what a file holds, what is wrong "
        f"with it, what a fit repairs and what you can do. These are read: {READ}. Exit status: 0 fine, 1 warnings, 2 unusable.",
        add_json, "a mesh or points, a saved model or point set", "FILE")  # fmt: skip
    add("info", "print facts about a file or the library", "Print facts about a file, or about the library "
        "if no FILE is given.", add_json,
        marks_too, "FILE", "?")  # fmt: skip
    return parser
