# SPDX-License-Identifier: MIT
"""The command line's grammar.

Each option's `dest` is the name of the argument or field that it sets, so that the commands can
hand over what was given and leave the rest to the library's own defaults.
"""
from __future__ import annotations

import argparse
import re
import sys
from typing import Any, List, NoReturn, Sequence

from .. import __version__
from .._names import (
    DENSITIES,
    DISTRIBUTIONS,
    GUIDES,
    HIDDEN_LINES,
    HIDDEN_PARTS,
    KERNELS,
    LIGHT_SPACES,
    PRESETS,
    REPAIRS,
    SEED_SOURCES,
    SHAPES,
    SIDES,
    SILHOUETTE_LAWS,
    SOLVERS,
    STROKE_STARTS,
    SYMMETRIES,
    TONE_CURVES,
    TONE_RANGES,
    TONE_RULES,
    VISIBILITIES,
)
from ..shapes._read import READ
from . import _lines, _sheet_views, _vectors
from . import _values as values


DEFAULT_STYLE = "contour-and-stipple"


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
        found = super().parse_args(given, namespace)
        if getattr(found, "style", "") is None and not getattr(found, "settings", None):
            found.style = DEFAULT_STYLE  # else that of the settings
        return found


def _choices(names: Sequence[str]) -> "dict[str, Any]":
    shown = [name.replace("_", "-") for name in names]
    return {"choices": shown, "metavar": "NAME"}


def _listed(text: str, names: Sequence[str]) -> str:
    return f"{text}: {', '.join(name.replace('_', '-') for name in names)}"


def _add(group: Any, option: str, dest: str, kind: Any, metavar: str, help: str, **more: Any) -> None:
    group.add_argument(option, dest=dest, type=kind, metavar=metavar, help=help, default=None, **more)


def _add_choice(group: Any, option: str, dest: str, names: Sequence[str], help: str) -> None:
    group.add_argument(option, dest=dest, default=None, help=_listed(help, names), **_choices(names))


def _add_common(parser: Parser) -> None:
    group = parser.add_argument_group("general")
    _add(group, "--threads", "threads", values.count(0, 256), "N", "threads, 0 = all processors (default)")
    group.add_argument("-q", "--quiet", action="store_true", help="warnings and errors only")


def _add_input(parser: Parser) -> None:
    group = parser.add_argument_group("samples")
    _add(group, "--samples", "samples", values.count(1), "N", "how many samples: of a mesh (by default as many as "
         "its shape needs), or chosen from a point set (all up to 4096 by default)")  # fmt: skip
    _add(group, "--crease", "crease", values.number, "DEGREES", "faces of a mesh that meet at a sharper angle do "
         "not share their normals; 60")  # fmt: skip
    _add(group, "--edges", "edges", values.edges, "EDGES", "of a mesh: auto keeps those sharp that stand out, as of "
         "machine parts, smooth rounds them, a number of degrees keeps all that bend more; by default as auto, and where faces "
         "are coarse as the normals of the file tell, if they do")  # fmt: skip
    _add(group, "--subdivide", "subdivide", values.count_or_auto(0, 6), "N", "divide the faces of a mesh into four, so often, to "
         "something round; by default where they are coarse and no edges stand out")  # fmt: skip
    _add_choice(group, "--parts", "parts", ("outer", "all", "largest"), "which parts of a mesh: all but those inside "
                "others (default), all, or that of the largest area")  # fmt: skip
    group.add_argument("--together", action="store_true", help="fit an open mesh as one surface, also where parts cross")
    _add_choice(group, "--normals", "normals", ("auto", "keep", "none", "unoriented", "mixed", "inward"), "what is "
                "known of those of points: auto (default) finds it out and repairs them, keep leaves them, none makes "
                "new ones, unoriented and mixed turn some, inward turns all")  # fmt: skip
    _add(group, "--viewpoint", "viewpoint", values.vector, "X,Y,Z", "where the scanner stood, in the coordinates of the "
         "file: open surfaces of points whose normals are made look to it; by default what the file tells")  # fmt: skip
    _add(group, "--depth-smoothing", "depth_smoothing", values.number, "F", "factor of the width over which the picture "
         "of a depth camera is smoothed; 1, and 0 leaves its points where they are")  # fmt: skip
    group.add_argument("--flip", action="store_true", help="turn all normals, whatever they look like")
    group.add_argument("--close", action="store_true", help="let the surface go on beyond open data, as the fit has it")
    _add(group, "--random-seed", "random_seed", values.count(0, 2**64 - 1), "N", "of all that is random; 1")


def _add_fit(parser: Parser) -> None:
    group = parser.add_argument_group("fit")
    _add_choice(group, "--kernel", "kernel", [name for name in KERNELS if name not in ("custom", "csg")], "radial function")
    _add(group, "--kernel-radius", "kernel_radius", values.number, "LENGTH", "of gaussian and wendland-c2")
    _add(group, "--degree", "polynomial_degree", values.count(-1, 3), "N", "of the polynomial, -1 (none) to 3; 1")
    _add(group, "--regularization", "regularization", values.number_or_auto, "X", "0 interpolates, more is smoother, "
         "auto takes it from the noise, and is 0 if none is seen; auto, but 0 for samples of meshes")  # fmt: skip
    _add_choice(group, "--solver", "solver", tuple(SOLVERS), "solver")
    _add(group, "--tolerance", "tolerance", values.number, "LENGTH", "choose samples as centres until all are this "
         "near to the surface")  # fmt: skip
    _add(group, "--max-centres", "maximum_centres", values.count(0), "N", "choose no more samples than this as centres")
    _add_choice(group, "--outliers", "outliers", ("keep", "drop"), "what becomes of stray samples; without normals they are dropped")
    _add_choice(group, "--flipped-normals", "flipped_normals", tuple(REPAIRS), "what becomes of them")
    _add(group, "--refinement-steps", "refinement_steps", values.count(0, 20), "N", "after a direct solve; 2")


def _add_marks(parser: Parser) -> None:
    group = parser.add_argument_group("marks")
    _add(group, "--layers", "layers", values.layers, "NAMES", "stipples,principal,combing; those the style draws")
    _add_choice(group, "--distribution", "distribution", tuple(DISTRIBUTIONS), "of marks over the surface")
    _add(group, "--marks", "budget", values.per_layer, "N", "the most marks of each layer, or LAYER=N,...; enough "
         "to make the darkest tone nearly black")  # fmt: skip
    group.add_argument("--budget", dest="budget", type=values.per_layer, help=argparse.SUPPRESS)
    _add(group, "--levels", "levels", values.per_layer, "N", "refinement steps of published, or LAYER=N,...")
    _add(group, "--step", "initial_step", values.number, "LENGTH", "initial step rho_0 of published")
    _add_choice(group, "--seeds", "seed_source", tuple(SEED_SOURCES), "where marks start")
    _add(group, "--seed-points", "seed_points", str, "FILE", "points to be the seeds")
    _add(group, "--box-resolution", "box_resolution", values.count(1, 256), "N", "cells of the box of seeds; 8")
    _add(group, "--box-jitter", "box_jitter", values.number, "X", "in cell sides, 0 to 0.5; 0.25")
    _add_choice(group, "--stroke-start", "start", tuple(STROKE_STARTS), "what strokes of published start from")
    _add(group, "--start-level", "start_level", values.count(0, 12), "N", "last level of those stipples; 0")
    _add(group, "--separation", "separation", values.number, "LENGTH", "of neighbouring strokes")
    _add(group, "--stroke-step", "step", values.number, "LENGTH", "of the marks along a stroke")
    _add(group, "--stroke-length", "length", values.number, "LENGTH", "of the longest stroke; 0 = no limit")
    _add_choice(group, "--symmetry", "symmetry", tuple(SYMMETRIES), "where the directions change places")
    _add_choice(group, "--guide", "guide", tuple(GUIDES), "what lines of hatching follow")
    _add(group, "--guide-direction", "guide_direction", values.direction, "X,Y,Z", "to the light, or to the eye, that "
         "such a guide means; z")  # fmt: skip
    _add(group, "--guide-weight", "guide_weight", values.number, "X", "of that guide; the rest of 1 is curvature's; 1")
    _add(group, "--hatch-angle", "hatch_angle", values.number, "DEGREES", "by which all lines of hatching are turned; "
         "90 is across what they follow; 0")  # fmt: skip
    _add_choice(group, "--density", "density", tuple(name for name in DENSITIES if name != "callback"),
                "where stipples are denser")  # fmt: skip
    _add(group, "--density-strength", "density_strength", values.number, "X", "of curvature, 0 to 1; 0.5")
    _add_choice(group, "--tone-ranges", "tone_ranges", tuple(TONE_RANGES), "whether one layer of marks follows the "
                "other from light to dark")  # fmt: skip
    _add(group, "--shared-marks", "shared_budget", values.count(0), "N", "the most marks of all layers together, in "
         "place of --marks")  # fmt: skip
    _add(group, "--tone-smoothing", "tone_smoothing", values.number, "X", "share of the diagonal over which normals are "
         "averaged for tone, 0 to 0.1; 0.006 of hatching, else 0")  # fmt: skip
    _add(group, "--projection-tolerance", "projection_tolerance", values.number, "X", "share of the diagonal; 1e-7")
    _add(group, "--curvature-of", "curvature_of", values.layers, "NAMES", "keep curvatures of these layers too")


def _add_output(parser: Parser, ending: str) -> None:
    parser.add_argument("output", metavar="OUTPUT", nargs="?", help=f"picture, or vectors where the command draws them (.svg, "
                        f".pdf, .hpgl, .gcode); INPUT's name with {ending} by default")
    parser.add_argument("-o", "--output", dest="output_option", metavar="OUTPUT", help="the same as an option")


def _add_size(parser: Parser) -> None:
    _add(parser, "--size", "size", values.size, "WxH", "pixels, or the longer side alone; 1600")


def _add_camera(parser: Parser) -> None:
    group = parser.add_argument_group("camera")
    _add(group, "--up", "up", values.up, "AXIS", "x, y, z, -y, ... or X,Y,Z; auto (default): by the kind of file "
         "and the shape, y where neither tells")  # fmt: skip
    _add(group, "--azimuth", "azimuth", values.number, "DEGREES", "of the camera about the up axis; 30, and "
         "another where that sees the back of an open surface")  # fmt: skip
    _add(group, "--elevation", "elevation", values.number, "DEGREES", "of the camera above the horizon; 20")
    _add(group, "--direction", "direction", values.direction, "X,Y,Z", "from the eye into the scene, instead of these")
    _add(group, "--eye", "eye", values.vector, "X,Y,Z", "place of the eye, looking at --target")
    _add(group, "--target", "target", values.vector, "X,Y,Z", "the middle of the model")
    _add(group, "--fov", "fov", values.number, "DEGREES", "vertical angle of view, 0 = orthographic; 30")
    _add(group, "--margin", "margin", values.number, "SHARE", "free on each side, 0 to 0.45; 0.05")


def _add_name(parser: Parser) -> None:
    parser.add_argument("--style", default=None, choices=PRESETS, metavar="NAME",
                        help=_listed(f"named style, {DEFAULT_STYLE} by default", PRESETS))  # fmt: skip


def _add_cells(parser: Parser) -> None:
    group = parser.add_argument_group("sheet")
    _add(group, "--styles", "styles", values.styles, "NAMES", _listed("named styles, all by default", PRESETS))
    _add(group, "--views", "views", values.views, "NAMES", "each style from these sides, instead of --azimuth and "
         f"--elevation: {', '.join(values.VIEWS)}")  # fmt: skip
    _add(group, "--size", "size", values.count(16, 4096), "PIXELS", "longer side of each drawing; 640")
    _add(group, "--columns", "columns", values.count(1), "N", "drawings beside each other; as many as make the sheet "
         "about square, or one for each view")  # fmt: skip


def _add_style(parser: Parser) -> None:
    group = parser.add_argument_group("style")
    _add(group, "--mark-radius", "mark_radius", values.number, "PIXELS", "of the pen, which the styles vary a little; "
         "an 800th of the picture")  # fmt: skip
    _add(group, "--ink", "ink", values.paint, "COLOUR", "of all marks: #rrggbb[aa] or R,G,B[,A] in 0 to 1")
    _add(group, "--paper", "paper", values.paint, "COLOUR", "as --ink")
    group.add_argument("--transparent", action="store_true", help="paper that lets all through")
    _add_choice(group, "--sides", "sides", ("auto", *SIDES), "of a surface on which marks are drawn: auto = both of one "
                "that ends")
    _add_choice(group, "--hidden-lines", "hidden_lines", tuple(HIDDEN_LINES), "what becomes of them")
    _add_choice(group, "--visibility", "visibility", tuple(VISIBILITIES), "how hidden marks are found")
    _add(group, "--delta", "silhouette_threshold", values.number, "X", "limit of silhouettes, 0 to 1")
    _add_choice(group, "--silhouette-law", "silhouette_law", tuple(SILHOUETTE_LAWS), "which marks are silhouettes")
    _add(group, "--silhouette-width", "silhouette_width", values.number, "PIXELS", "on either side of the contour")
    _add(group, "--lines", "lines", _lines.parse, "KINDS", f"lines drawn as curves: {', '.join(_lines.NAMES)}, with "
         "commas between; section=z:20, isophotes=0.3:0.6; none: contours by marks; those of the style")  # fmt: skip
    _add_choice(group, "--hidden", "hidden", tuple(HIDDEN_PARTS), "hidden parts of lines")
    _add(group, "--support", "support", values.number, "S", "where lines end beyond the samples of open "
         "data: 1.5 close to even ones, 3 farther; 0 nowhere; 3 with a border among the lines, else 0")  # fmt: skip
    _add(group, "--line-width", "line_width", values.number, "PIXELS", "of contours; others are finer")
    _add(group, "--outline", "outline_factor", values.number, "X", "times the width of lines where nothing lies "
         "beside them; 1.5 of silhouette and xray, else 1")  # fmt: skip
    _add(group, "--far-lines", "far_factor", values.number, "X", "times the width of lines at the farthest place; 1")
    _add(group, "--lit-lines", "lit_factor", values.number, "X", "times the width of lines towards the light; 1")
    _add(group, "--sharp-lines", "curvature_factor", values.number, "X", "times the width of lines where the "
         "surface bends sharply; 1")  # fmt: skip
    _add(group, "--wobble", "wobble", values.number, "WIDTHS", "how far lines stray, as of an unsteady hand; their "
         "width varies by half as much; 0")  # fmt: skip
    _add(group, "--attenuation-front", "attenuation_front", values.number, "LAMBDA", "of what lies behind front marks")
    _add(group, "--attenuation-back", "attenuation_back", values.number, "LAMBDA", "of what lies behind back marks")
    _add(group, "--splat-radius", "splat_radius", values.number, "PIXELS", "of the splats that stand for the "
         "surface; automatic")  # fmt: skip
    _add(group, "--splat-overlap", "splat_overlap", values.number, "N", "opacity of a layer of surface; 0 as published")
    _add(group, "--halo", "halo_width", values.number, "PIXELS", "how far beyond its contour a surface hides; as "
         "the pen")  # fmt: skip
    group.add_argument("--tone", choices=["none", "light"], metavar="NAME", default=None, help="none or light")
    _add_choice(group, "--tone-rule", "tone_rule", tuple(TONE_RULES), "how tone, depth, zoom and share combine")
    _add_choice(group, "--tone-curve", "tone_curve", tuple(TONE_CURVES), "what is as dark as asked for")
    _add(group, "--tone-fade", "tone_fade", values.number, "X", "share of marks that grow instead of popping, 0 to 1")
    _add(group, "--tone-exponent", "tone_exponent", values.number, "LAMBDA", "of the tone law; more is darker")
    _add(group, "--fill-light", "fill_light", values.number, "X", "from the side opposite to the light, 0 to 1")
    _add(group, "--light", "light", values.direction, "X,Y,Z", "towards the light")
    _add_choice(group, "--light-space", "light_space", tuple(LIGHT_SPACES), "frame of the light")
    _add(group, "--depth-range", "depth_range", values.interval, "MIN,MAX", "distances between which marks vanish")
    _add(group, "--zoom-reference", "zoom_reference", values.number, "X", "pixels per unit at which all marks show")
    _add(group, "--zoom-exponent", "zoom_exponent", values.number, "X", "how fast they vanish below it")
    _add(group, "--silhouette-ink", "silhouette_ink", values.paint, "COLOUR", "as --ink")
    _add(group, "--silhouette-radius", "silhouette_radius", values.number, "PIXELS", "of silhouette marks")
    _add(group, "--contours-of", "contours_of", values.layers, "NAMES", "layers whose marks draw contours")
    _add_choice(group, "--shape", "shape", tuple(SHAPES), "how marks of strokes are drawn")
    _add(group, "--scale-bar", "scale_bar", str, "UNIT", "a scale bar below the picture, its length in this unit; none: "
         "no bar; units of archaeological")  # fmt: skip
    _add_choice(group, "--profile", "profile", ("yes", "no"), "whether an upright section through the middle is drawn "
                "beside the picture; yes of archaeological")  # fmt: skip
    _add(group, "--share", "share", values.number, "X", "share of the style's marks that is used, 0 to 1")
    group.add_argument("--set", dest="assignments", action="append", type=values.assignment, default=[],
                       metavar="[LAYER.]FIELD=VALUE", help="any other field of a style, such as "
                       "principal.directions=first or stipples.ink=#800000; may be repeated")  # fmt: skip


def _add_turn(parser: Parser) -> None:
    parser.add_argument("output", metavar="OUTPUT", nargs="?", help="animation (.gif, .png or .apng, .mp4), or pictures "
                        "where it has a number, such as %%03d.png; INPUT's name with .gif by default")  # fmt: skip
    parser.add_argument("-o", "--output", dest="output_option", metavar="OUTPUT", help="the same as an option")
    group = parser.add_argument_group("turntable")
    for option, kind, default, metavar, words in (
        ("--frames", values.count(1, 100_000), 36, "N", "how many"),
        ("--fps", values.number, 12.0, "N", "frames in a second"),
        ("--turn", values.number, 360.0, "DEGREES", "of the camera about the up axis, from --azimuth on"),
        ("--loops", values.count(0, 65535), 0, "N", "how often .gif and .png are shown, 0 = without end"),
        ("--size", values.size, 480, "WxH", "pixels, or the longer side alone"),
    ):
        group.add_argument(option, type=kind, default=default, metavar=metavar, help=f"{words}; {default:g}")


def _add_blank(parser: Parser) -> None:
    parser.add_argument("--allow-blank", action="store_true", help="write the picture even if hardly anything is seen")


# What a drawing is like, whoever asks for it.
_DRAWING = (_add_name, _add_size, _add_style, _add_camera, _add_marks, _add_fit, _add_input)


def of_a_drawing() -> Parser:
    """The options of a drawing alone, without files: for `hrbfnpr.draw`."""
    parser = Parser(prog="hrbfnpr.draw", add_help=False)
    parser.set_defaults(command="draw")
    for add in (_add_blank, *_DRAWING, _vectors.add_options):
        add(parser)
    return parser


def _add_drawing(draw: Parser) -> None:
    _add_output(draw, ".png")
    draw.add_argument("--also", action="append", default=[], metavar="FILE", help="the same drawing in another format; "
                      "may be repeated")  # fmt: skip
    draw.add_argument("--save-model", metavar="FILE", help="save the model too")
    draw.add_argument("--save-points", metavar="FILE", help="save the marks too")
    draw.add_argument("--settings", metavar="FILE", help="draw by a file of settings, as hrbfnpr-view saves them; other "
                      "options win over it (docs/settings.md)")  # fmt: skip
    draw.add_argument("--save-settings", metavar="FILE", help="save what the drawing was made with, for --settings")
    for add in (_add_blank, *_DRAWING, _vectors.add_options, _add_common):
        add(draw)


def build() -> Parser:
    """The whole grammar."""
    parser = Parser(prog="hrbfnpr", description="Pen-and-ink drawings of surfaces given by points and normals.")
    parser.add_argument("--version", action="version", version=f"hrbfnpr {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    source = "a mesh or points with normals (check --help lists the formats), a script of solids (.csg), a saved model"

    draw = commands.add_parser("draw", help="draw a picture", description="Draw a picture.")
    draw.add_argument("input", metavar="INPUT", help=f"{source} or point set")
    _add_drawing(draw)

    solids = commands.add_parser("csg", help="put solids together and draw them", description="Draw the solid that a "
                                 "script puts together from boxes, cylinders, files and others: docs/csg.md.")  # fmt: skip
    solids.add_argument("input", metavar="SCRIPT", help="lines of `name = solid`; the last one is drawn")
    _add_drawing(solids)

    sheet = commands.add_parser("sheet", help="draw a model in all styles, on one picture", description="Draw a model "
                                "in all named styles on one picture: each as draw does at this size.")  # fmt: skip
    sheet.add_argument("input", metavar="INPUT", help=source)
    _add_output(sheet, "-sheet.png")
    for add in (_add_cells, _add_style, _add_camera, _add_marks, _add_fit, _add_input, _add_common):
        add(sheet)

    turn = commands.add_parser("turntable", help="draw an orbit as an animation", description="Draw an orbit about a model "
                               "as an animation.")  # fmt: skip
    turn.add_argument("input", metavar="INPUT", help=f"{source} or point set")
    for add in (_add_turn, _add_blank, *(add for add in _DRAWING if add is not _add_size), _add_common):
        add(turn)

    views = commands.add_parser("sheet-views", help="draw views and sections on a sheet, to scale", description="Draw "
                                "views and sections of a model on a sheet, to scale, by the conventions of technical "
                                "drawing.")  # fmt: skip
    views.add_argument("input", metavar="INPUT", help=source)
    views.add_argument("output", metavar="OUTPUT", nargs="?", help="vectors (.svg, .pdf, .hpgl, .gcode); INPUT's name "
                       "with -views.svg by default")  # fmt: skip
    views.add_argument("-o", "--output", dest="output_option", metavar="OUTPUT", help="the same as an option")
    for add in (_sheet_views.add_options, _add_fit, _add_input, _add_common):
        add(views)

    fit = commands.add_parser("fit", help="fit a model and save it", description="Fit a model and save it.")
    fit.add_argument("input", metavar="INPUT", help="a mesh or points with normals")
    fit.add_argument("output", metavar="OUTPUT", help="the model")
    for add in (_add_fit, _add_input, _add_common):
        add(fit)

    points = commands.add_parser("points", help="place marks and save them", description="Place marks and save them.")
    points.add_argument("input", metavar="INPUT", help=source)
    points.add_argument("output", metavar="OUTPUT", help="the point set, or its marks as .ply")
    for add in (_add_marks, _add_fit, _add_input, _add_common):
        add(points)

    check = commands.add_parser("check", help="look at a file without drawing it", description="Look at a file without "
                                "drawing it: what it holds, what is wrong with it, what a fit would repair, and what "
                                f"to do. Read are {READ}. Exit status: 0 fine, 1 warnings, 2 unusable.")  # fmt: skip
    check.add_argument("input", metavar="FILE", help="a mesh or points, a saved model or point set")
    check.add_argument("--json", action="store_true", help="as JSON")
    _add_common(check)

    info = commands.add_parser("info", help="tell about a file or the library", description="Tell about a file, or, "
                               "without one, about the library.")  # fmt: skip
    info.add_argument("input", metavar="FILE", nargs="?", help=f"{source} or point set")
    info.add_argument("--json", action="store_true", help="as JSON")
    _add_common(info)
    return parser
