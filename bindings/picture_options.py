# SPDX-License-Identifier: MIT
"""The table of a drawing's options, as plain data, for languages that let users name options.

A row holds what a user writes, and the field of the C interface that it sets.  A row without words takes its description
from the header's comment.  The names that an option takes, and its default, come from the header, too.

    name     with underscores: mark_radius is --mark-radius of the command line
    target   pen                    a field of hrbfnpr_picture_desc
             flags.FLIP             a flag of hrbfnpr_picture_desc
             style.halo_width       the path of a hrbfnpr_change; marks.*.budget is one for each kind of layers
             page.tolerance         a field of hrbfnpr_page_desc or hrbfnpr_picture_page_desc, or a flag of the page
             (empty)                several fields; each binding knows which
    kind     how a value is written: "number", "count LOW HIGH", "choice NAMES" and so on; each binding reads them
    metavar  the placeholder for a value in a list of options
    words    a description that replaces the header's comment
    alias    a second name: the name of the field
"""
from typing import NamedTuple


class Option(NamedTuple):
    name: str
    target: str
    kind: str
    metavar: str = ""
    words: str = ""
    alias: str = ""


def number(name, target, metavar, words="", alias=""):
    return Option(name, target, "number", metavar, words, alias)


def count(name, target, low, high=None, words="", alias=""):
    return Option(name, target, f"count {low}" + ("" if high is None else f" {high}"), "N", words, alias)


def choice(name, target, words, only=None, alias=""):
    """A choice between constants.  only: the allowed names, if not all constants are allowed."""
    return Option(name, target, "choice" + (f" {only}" if only else ""), "NAME", words, alias)


def flag(name, target, words=""):
    return Option(name, target, "flag", "", words)


GROUPS = {
    "": [
        flag("allow_blank", "flags.ALLOW_BLANK", "make the picture even if hardly anything is seen"),
        Option("size", "", "size", "WxH", "pixels, or the longer side alone; 1600"),
    ],
    "style": [
        number("mark_radius", "pen", "PIXELS"),
        Option("ink", "style.ink", "paint", "COLOUR", "of all marks: #rrggbb[aa] or R,G,B[,A] in 0 to 1"),
        Option("paper", "style.paper", "paint", "COLOUR", "as that of ink"),
        flag("transparent", "flags.TRANSPARENT", "paper that lets all through"),
        choice("sides", "sides", "of a surface on which marks are drawn: auto = both of one that ends"),
        choice("hidden_lines", "style.hidden_lines", "what becomes of them"),
        choice("visibility", "style.visibility", "how hidden marks are found"),
        number("delta", "style.silhouette_threshold", "X", "limit of silhouettes, 0 to 1", "silhouette_threshold"),
        Option("lines", "lines", "lines", "KINDS", "lines drawn as curves: contour, suggestive, ridges, valleys, apparent, "
               "parabolic, isophotes, section, border, crease, with commas between; section=z:20, isophotes=0.3:0.6; none; "
               "those of the style"),  # fmt: skip
        choice("hidden", "style.lines.hidden", "hidden parts of lines"),
        number("support", "line_set.support", "S", "where lines end beyond the samples of open data: 1.5 close to even "
               "ones, 3 farther; 0 nowhere; 3 with a border among the lines, else 0"),  # fmt: skip
        number("line_width", "line_width", "PIXELS", "of contours; others are finer"),
        number("outline", "style.lines.outline_factor", "X", "times the width of lines where nothing lies beside them; 1.5 "
               "of silhouette and xray, else 1", "outline_factor"),  # fmt: skip
        number("far_lines", "style.lines.far_factor", "X", "times the width of lines at the farthest place; 1", "far_factor"),
        number("lit_lines", "style.lines.lit_factor", "X", "times the width of lines towards the light; 1", "lit_factor"),
        number("sharp_lines", "style.lines.curvature_factor", "X", "times the width of lines where the surface bends sharply; "
               "1", "curvature_factor"),  # fmt: skip
        number("wobble", "style.lines.wobble", "WIDTHS", "how far lines stray, as of an unsteady hand; their width varies by "
               "half as much; 0"),  # fmt: skip
        number("attenuation_front", "style.attenuation_front", "LAMBDA", "of what lies behind front marks"),
        number("attenuation_back", "style.attenuation_back", "LAMBDA", "of what lies behind back marks"),
        number("splat_radius", "style.splat_radius", "PIXELS", "of the splats that stand for the surface; automatic"),
        number("splat_overlap", "style.splat_overlap", "N", "opacity of a layer of surface; 0 as published"),
        number("halo", "style.halo_width", "PIXELS", "how far beyond its contour a surface hides; as the pen", "halo_width"),
        choice("tone", "style.tone", "what marks are dense by", "none light"),
        choice("tone_rule", "style.tone_rule", "how tone, depth, zoom and share combine"),
        choice("tone_curve", "style.tone_curve", "what is as dark as asked for"),
        number("tone_fade", "style.tone_fade", "X", "share of marks that grow instead of popping, 0 to 1"),
        number("tone_exponent", "style.tone_exponent", "LAMBDA", "of the tone law; more is darker"),
        number("fill_light", "style.fill_light", "X", "from the side opposite to the light, 0 to 1"),
        Option("light", "style.light", "direction", "X,Y,Z", "towards the light"),
        choice("light_space", "style.light_space", "frame of the light"),
        Option("depth_range", "", "interval", "MIN,MAX", "distances between which marks vanish"),
        number("zoom_reference", "style.zoom_reference", "X", "pixels per unit at which all marks show"),
        number("zoom_exponent", "style.zoom_exponent", "X", "how fast they vanish below it"),
        Option("silhouette_ink", "style.silhouette_ink", "paint", "COLOUR", "as that of ink"),
        number("silhouette_radius", "style.silhouette_radius", "PIXELS", "of silhouette marks"),
        choice("shape", "style.layers.shape", "how marks of strokes are drawn"),
        Option("scale_bar", "scale_bar", "text", "UNIT", "a scale bar below the picture, its length in this unit; none: no "
               "bar; units of archaeological"),  # fmt: skip
        choice("profile", "profile", "whether an upright section through the middle is drawn beside the picture; yes of "
               "archaeological", "yes no"),  # fmt: skip
        number("share", "style.layers.share", "X", "share of the style's marks that is used, 0 to 1"),
        Option("set", "", "assignment", "[LAYER.]FIELD=VALUE", "any other field of a style, such as "
               "hatch.hatch_pen=1.5 or stipples.ink=#800000; may be repeated", "assignments"),  # fmt: skip
    ],
    "camera": [
        Option("up", "up", "up", "AXIS", "x, y, z, -y, ... or X,Y,Z; auto (default): by the kind of file and the shape, y "
               "where neither tells"),  # fmt: skip
        number("azimuth", "azimuth", "DEGREES"),
        number("elevation", "elevation", "DEGREES"),
        Option("direction", "direction", "direction", "X,Y,Z", "from the eye into the scene, instead of these"),
        Option("eye", "eye", "vector", "X,Y,Z", "place of the eye, looking at the target"),
        Option("target", "target", "vector", "X,Y,Z", "the middle of the model"),
        number("fov", "fov", "DEGREES", "vertical angle of view, 0 = orthographic; 30"),
        number("margin", "margin", "SHARE", "free on each side, 0 to 0.45; 0.05"),
    ],
    "marks": [
        Option("layers", "mark_kinds", "layers", "NAMES", "stipples,hatch; those the style draws"),
        choice("distribution", "marks.distribution", "of marks over the surface"),
        Option("marks", "marks.*.budget", "per_layer", "N", "the most marks of each layer, or LAYER=N,...; enough to make the "
               "darkest tone nearly black", "budget"),  # fmt: skip
        Option("levels", "marks.*.levels", "per_layer", "N", "refinement steps of published, or LAYER=N,..."),
        number("step", "marks.initial_step", "LENGTH", "initial step rho_0 of published", "initial_step"),
        choice("seeds", "marks.seed_source", "where marks start", alias="seed_source"),
        Option("seed_points", "seed_points", "file", "FILE", "points to be the seeds"),
        count("box_resolution", "marks.box_resolution", 1, 256, "cells of the box of seeds; 8"),
        number("box_jitter", "marks.box_jitter", "X", "in cell sides, 0 to 0.5; 0.25"),
        choice("stroke_start", "marks.layers.start", "what strokes of published start from", alias="start"),
        count("start_level", "marks.layers.start_level", 0, 12, "last level of those stipples; 0"),
        number("separation", "marks.layers.separation", "LENGTH", "of neighbouring lines of hatching"),
        number("stroke_step", "marks.layers.step", "LENGTH", "of the marks along a line"),
        choice("guide", "marks.layers.guide", "what lines of hatching follow"),
        Option("guide_direction", "marks.layers.guide_direction", "direction", "X,Y,Z", "to the light, or to the eye, that "
               "such a guide means; z"),  # fmt: skip
        number("guide_weight", "marks.layers.guide_weight", "X", "of that guide; the rest of 1 is curvature's; 1"),
        number("hatch_angle", "hatch_angle", "DEGREES", "by which all lines of hatching are turned; 90 is across what they "
               "follow; 0"),  # fmt: skip
        choice("density", "marks.layers.density", "where stipples are denser", "uniform curvature"),
        number("density_strength", "marks.layers.density_strength", "X", "of curvature, 0 to 1; 0.5"),
        choice("tone_ranges", "marks.tone_ranges", "whether one layer of marks follows the other from light to dark"),
        count("shared_marks", "marks.shared_budget", 0, None, "the most marks of all layers together, in place of those of "
              "each", "shared_budget"),  # fmt: skip
        number("tone_smoothing", "marks.layers.tone_smoothing", "X", "share of the diagonal over which normals are averaged "
               "for tone, 0 to 0.1; 0.006 of hatching, else 0"),  # fmt: skip
        number("projection_tolerance", "marks.projection_tolerance", "X", "share of the diagonal; 1e-7"),
        Option("curvature_of", "", "layers", "NAMES", "keep curvatures of these layers too"),
    ],
    "fit": [
        choice("kernel", "fit.kernel", "radial function", "triharmonic gaussian wendland_c2"),
        number("kernel_radius", "fit.kernel_radius", "LENGTH", "of gaussian and wendland-c2"),
        count("degree", "fit.polynomial_degree", -1, 3, "of the polynomial, -1 (none) to 3; 1", "polynomial_degree"),
        Option("regularization", "fit.regularization", "number_or_auto", "X", "0 interpolates, more is smoother, auto takes "
               "it from the noise, and is 0 if none is seen; auto, but 0 for samples of meshes"),  # fmt: skip
        choice("solver", "fit.solver", "solver"),
        number("tolerance", "tolerance", "LENGTH", "choose samples as centres until all are this near to the surface"),
        count("max_centres", "maximum_centres", 0, None, "choose no more samples than this as centres", "maximum_centres"),
        choice("outliers", "fit.outliers", "what becomes of stray samples; without normals they are dropped", "keep drop"),
        choice("flipped_normals", "fit.flipped_normals", "what becomes of them"),
        count("refinement_steps", "fit.refinement_steps", 0, 20, "after a direct solve; 2"),
    ],
    "samples": [
        count("samples", "samples", 1, None, "how many samples: of a mesh (by default as many as its shape needs), or chosen "
              "from a point set (all up to 4096 by default)"),  # fmt: skip
        number("crease", "crease_angle", "DEGREES", "faces of a mesh that meet at a sharper angle do not share their normals; "
               "60"),  # fmt: skip
        Option("edges", "", "edges", "EDGES", "of a mesh: auto keeps those sharp that stand out, as of machine parts, smooth "
               "rounds them, a number of degrees keeps all that bend more; by default as auto, and where faces are coarse as "
               "the normals of the file tell, if they do"),  # fmt: skip
        Option("subdivide", "subdivide", "count_or_auto 0 6", "N", "divide the faces of a mesh into four, so often, to "
               "something round; by default where they are coarse and no edges stand out"),  # fmt: skip
        choice("parts", "parts", "which parts of a mesh: all but those inside others (default), all, or that of the largest "
               "area"),  # fmt: skip
        flag("together", "flags.TOGETHER", "fit an open mesh as one surface, also where parts cross"),
        choice("normals", "normals", "what is known of those of points: auto (default) finds it out and repairs them, keep "
               "leaves them, none makes new ones, unoriented and mixed turn some, inward turns all",
               "auto keep none unoriented mixed inward"),  # fmt: skip
        Option("viewpoint", "viewpoint", "vector", "X,Y,Z", "where the scanner stood, in the coordinates of the file: open "
               "surfaces of points whose normals are made look to it; by default what the file tells"),  # fmt: skip
        number("depth_smoothing", "depth_smoothing", "F", "factor of the width over which the picture of a depth camera is "
               "smoothed; 1, and 0 leaves its points where they are"),  # fmt: skip
        flag("flip", "flags.FLIP"),
        flag("close", "flags.CLOSE", "let the surface go on beyond open data, as the fit has it"),
        count("random_seed", "random_seed", 0, 2**64 - 1),
    ],
    "vectors": [
        Option("page", "page.paper", "page", "PAPER", "paper that the drawing fills but for 10 mm, turned as it fits better: "
               "a4, a3, letter, ... or WIDTHxHEIGHT in mm; by default a pixel is 1/96 inch"),  # fmt: skip
        number("page_margin", "page.paper_margin", "MM", "free on each side of the page; 10"),
        choice("dots", "page.dots", "of stipples: circles, lines of no length that a pen touches the paper with, or spirals "
               "that fill them; circles, which plotters fill unless in a single pass"),  # fmt: skip
        choice("stroke_widths", "page.widths", "of strokes that swell: outlines, or classes of even widths; outlines"),
        Option("pens", "page.pens", "pens", "GROUP=COLOUR:MM", "pens of groups, with commas between, such as "
               "contour=#000000:0.5,hatch*=#803000:0.3; a third part is a line type of ISO 128, such as dashed"),  # fmt: skip
        Option("pen_widths", "page.pen_widths", "pen_widths", "MM,MM", "widths of the pens at hand: each group gets the one "
               "that is nearest to its lines' median width, or to its dots' median diameter"),  # fmt: skip
        flag("single_pass", "page.SINGLE_PASS", "draw a line that is wider than its pen once, along its centre, and touch the "
             "paper for a dot; else plotters, and pens in plot order, fill both by several passes"),  # fmt: skip
        flag("plot_order", "page.IN_PLOT_ORDER", "sort lines so that a pen travels little; plotters' files always are"),
        number("vector_tolerance", "page.tolerance", "MM", "between what is drawn and what is written; 0.05"),
        number("draw_speed", "page.draw_speed", "MM/S", "of a plotter's pen, for the time it takes; 30"),
        Option("pen_up", "page.pen_up", "text", "GCODE", "raises the pen in .gcode; G0 Z5"),
        Option("pen_down", "page.pen_down", "text", "GCODE", "lowers it; G1 Z0"),
    ],
}


# ---- What the header says about an option

import re  # noqa: E402

_STRUCTS = {"style": "style", "fit": "fit_desc", "mesh_fit": "mesh_fit_desc", "marks": "generate_desc",
            "line_set": "line_set_desc", "page": "page_desc"}  # fmt: skip


def field_of(target, api):
    """The field or the constant that a target names; None if the header has no single one."""
    section, _, rest = target.rpartition(".")
    if section == "flags":
        flags = next(group for group in api["constants"] if group["prefix"] == "HRBFNPR_PICTURE")
        return next(one for one in flags["constants"] if one["name"] == f"HRBFNPR_PICTURE_{rest}")
    first, _, layer = section.partition(".")
    names = [_STRUCTS.get(first, "picture_desc")]
    if layer:
        names = ["line_style" if layer == "lines" else "layer_style" if first == "style" else "layer_desc"]
    names += ["picture_page_desc"] if first == "page" else []
    fields = (field for struct in api["structs"] if struct["name"][8:] in names for field in struct["fields"])
    return next((field for field in fields if field["name"] == rest), None)


def choices_of(option, api):
    """The names that an option takes; empty for an option that is not a choice."""
    if not option.kind.startswith("choice"):
        return ()
    only = option.kind.split()[1:]
    if only:
        return tuple(only)
    prefix = field_of(option.target, api)["constants"]
    group = next(group for group in api["constants"] if group["prefix"] == prefix)
    return tuple(one["name"][len(prefix) + 1:].lower() for one in group["constants"])


def words_of(option, api):
    """A short description of an option."""
    if option.words:
        return option.words
    doc = field_of(option.target, api)["doc"].split("\n")[0]
    return re.sub(r"\b(?:NaN|0) = (?=\w+ 800th|[\d.]+, and|[\d.]+$)", "", doc)
