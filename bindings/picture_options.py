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
        flag("allow_blank", "flags.ALLOW_BLANK", "write the picture even if hardly anything is visible in it"),
        Option("size", "", "size", "WxH", "size of the picture in pixels, or its longer side alone; 1 to 32768 "
               "(default: 1600)"),  # fmt: skip
    ],
    "style": [
        number("mark_radius", "pen", "PIXELS", "radius of the pen in pixels, which sets the size of all marks "
               "(default: 1/800 of the longer side, at least 0.75)"),  # fmt: skip
        Option("ink", "style.ink", "paint", "COLOUR", "colour of all marks: #rrggbb, #rrggbbaa, or R,G,B or R,G,B,A "
               "from 0 to 1 (default: black)"),  # fmt: skip
        Option("paper", "style.paper", "paint", "COLOUR", "colour of the paper, written as for ink (default: white)"),
        flag("transparent", "flags.TRANSPARENT", "leave the paper transparent"),
        Option("field", "style.field", "fields", "USE=NAME", "let values of the source's points change the drawing, such as "
               "tone=quality or ink=rgb; USE is tone, density, width, ink, mask or direction, and NAME:LOW..HIGH says which "
               "values become 0 and 1"),  # fmt: skip
        Option("palette", "style.palette", "palette", "COLOURS", "inks for ink=NAME of field: up to 8 colours #rrggbb with commas "
               "between (default: three, from the colours)"),  # fmt: skip
        choice("sides", "sides", "sides of the surface that are drawn; auto draws both sides of an open surface "
               "(default: auto)"),  # fmt: skip
        choice("hidden_lines", "style.hidden_lines", "hidden marks are drawn paler, left out or drawn in full "
               "(default: from the style)"),  # fmt: skip
        choice("visibility", "style.visibility", "how hidden marks are found: by the layers of depth, or as in the "
               "published article (default: depth-layers)"),  # fmt: skip
        number("delta", "style.silhouette_threshold", "X", "largest cosine between the normal and the view at which a "
               "mark is on the silhouette; 0 to 1 (default: 0.2)", "silhouette_threshold"),  # fmt: skip
        Option("lines", "lines", "lines", "KINDS", "kinds of lines to draw, with commas between: contour, suggestive, "
               "ridges, valleys, apparent, parabolic, isophotes, section, border, crease, intersection, shadow, terminator, "
               "soft, tangent, or none; "
               "section=z:20 sets planes, isophotes=0.3:0.6 sets levels (default: from the style)"),  # fmt: skip
        choice("hidden", "style.lines.hidden", "how the hidden parts of lines are drawn (default: from the style)"),
        flag("verify", "flags.VERIFY", "compare all lines with rays, repair wrong pieces, and say how many agree"),
        number("support", "line_set.support", "S", "where an open surface ends beyond its samples: 1.5 near them, 3 "
               "farther out, 0 nowhere (default: 3 with border lines, else 0)"),  # fmt: skip
        number("line_width", "line_width", "PIXELS", "width of contours in pixels; other lines are finer (default: "
               "from the style)"),  # fmt: skip
        number("outline", "style.lines.outline_factor", "X", "factor of the width of lines with nothing beside them, "
               "the outline (default: 1.5 in silhouette and xray, else 1)", "outline_factor"),  # fmt: skip
        number("far_lines", "style.lines.far_factor", "X", "factor of the width of the farthest lines (default: 0.45 in "
               "silhouette, woodcut and sketch, else 1)", "far_factor"),  # fmt: skip
        number("lit_lines", "style.lines.lit_factor", "X", "factor of the width of lines on the side towards the light "
               "(default: 1)", "lit_factor"),  # fmt: skip
        number("sharp_lines", "style.lines.curvature_factor", "X", "factor of the width of lines where the surface "
               "bends sharply (default: 1)", "curvature_factor"),  # fmt: skip
        number("wobble", "style.lines.wobble", "WIDTHS", "how far lines stray to either side, as if drawn by hand, in "
               "line widths; 0 to 16 (default: 0)"),  # fmt: skip
        number("attenuation_front", "style.attenuation_front", "LAMBDA", "how strongly the front of a surface hides "
               "marks behind it; 0 shows them in full (default: from the style)"),  # fmt: skip
        number("attenuation_back", "style.attenuation_back", "LAMBDA", "how strongly the back of a surface hides marks "
               "behind it; 0 shows them in full (default: from the style)"),  # fmt: skip
        number("splat_radius", "style.splat_radius", "PIXELS", "radius in pixels of the piece of surface around a mark "
               "that hides others (default: from the marks' spacing)"),  # fmt: skip
        number("splat_overlap", "style.splat_overlap", "N", "how opaque the surface is, as the number of pieces that "
               "overlap; 0 as published (default: 8)"),  # fmt: skip
        number("halo", "style.halo_width", "PIXELS", "how far a surface hides what is behind it beyond its contour, in "
               "pixels (default: as wide as the pen)", "halo_width"),  # fmt: skip
        choice("tone", "style.tone", "what makes the drawing light and dark: light shades it, none draws all marks "
               "(default: from the style)", "none light"),  # fmt: skip
        choice("tone_rule", "style.tone_rule", "how tone, depth, zoom and share combine: share multiplies them, "
               "published follows the article (default: share)"),  # fmt: skip
        choice("tone_curve", "style.tone_curve", "whether the tone sets the area that ink covers or the number of "
               "marks (default: coverage)"),  # fmt: skip
        number("tone_fade", "style.tone_fade", "X", "share of the marks that grow gradually in place of popping up; 0 "
               "to 1 (default: 0.25)"),  # fmt: skip
        number("tone_exponent", "style.tone_exponent", "LAMBDA", "exponent of the tone, above 0; larger is darker "
               "(default: 1)"),  # fmt: skip
        number("fill_light", "style.fill_light", "X", "strength of a second light from the opposite side; 0 to 1 "
               "(default: 0.25)"),  # fmt: skip
        Option("light", "style.light", "lights", "X,Y,Z", "direction towards the light; X,Y,Z:intensity=N,shadow=N,"
               "softness=N,space=NAME,place says more, and place makes X,Y,Z its position; may be repeated for up to 8 "
               "lights (default: -0.4,0.6,0.7)"),  # fmt: skip
        choice("light_space", "style.light_space", "whether the light stands in the world or moves with the camera "
               "(default: camera)"),  # fmt: skip
        number("shadow", "style.light_shadow", "X", "how dark the shadows are that the light casts; 0 to 1 (default: 0 = "
               "it casts none)"),  # fmt: skip
        number("softness", "style.light_softness", "RADIANS", "radius of the light as it is seen from the surface; larger "
               "is softer shadows; 0 to 0.5 (default: 0 = sharp borders)"),  # fmt: skip
        number("occlusion", "style.occlusion_lights", "X", "share of the light that is lost in hollows, where no sky is seen; "
               "0 to 1 (default: from the style)"),  # fmt: skip
        number("rim_light", "style.rim_light", "X", "strength of a light that makes contours lighter; 0 to 16 (default: "
               "0)"),  # fmt: skip
        number("steps", "style.tone_steps", "N", "number of flat tones, 2 to 6 (default: 0 = continuous tones)"),
        number("black_point", "style.tone_black", "X", "light that is drawn as black (default: 0)"),
        number("white_point", "style.tone_white", "X", "light that is drawn as white (default: 1)"),
        number("gamma", "style.tone_gamma", "X", "exponent of the tone law; larger is darker mid-tones (default: 1)"),
        Option("ground", "", "ground", "HEIGHT", "ground under the object, on which only the shadow is drawn: at the lowest "
               "place of the object, or with =HEIGHT at that height (default: none)"),  # fmt: skip
        number("contrast", "style.curvature_contrast", "X", "light that ridges add and hollows take away; 0 to 16 (default: "
               "0)"),  # fmt: skip
        Option("depth_range", "", "interval", "MIN,MAX", "distances from the camera between which marks fade out, with "
               "0 < MIN < MAX (default: they do not)"),  # fmt: skip
        number("zoom_reference", "style.zoom_reference", "X", "pixels per unit of the model from which all marks are "
               "drawn; fewer marks below it (default: all marks always)"),  # fmt: skip
        number("zoom_exponent", "style.zoom_exponent", "X", "how fast marks vanish below zoom_reference; at least 0, "
               "and 2 keeps the tone (default: 2)"),  # fmt: skip
        Option("silhouette_ink", "style.silhouette_ink", "paint", "COLOUR", "colour of silhouette marks, written as "
               "for ink (default: black)"),  # fmt: skip
        number("silhouette_radius", "style.silhouette_radius", "PIXELS", "radius of silhouette marks in pixels "
               "(default: from the style)"),  # fmt: skip
        choice("shape", "style.layers.shape", "how marks along lines of hatching are drawn (default: from the style)"),
        Option("scale_bar", "scale_bar", "text", "UNIT", "unit of a scale bar below the picture, such as mm, or none "
               "(default: none, units in archaeological)"),  # fmt: skip
        choice("profile", "profile", "whether a vertical section through the middle is drawn beside the picture "
               "(default: no, yes in archaeological)", "yes no"),  # fmt: skip
        number("share", "style.layers.share", "X", "share of the marks that is used; 0 to 1 (default: 1)"),
        Option("set", "", "assignment", "[LAYER.]FIELD=VALUE", "any other field of a style, such as "
               "hatch.hatch_pen=1.5 or stipples.ink=#800000; may be repeated", "assignments"),  # fmt: skip
    ],
    "camera": [
        Option("up", "up", "up", "AXIS", "direction that points up: x, y, z, -x, -y, -z, X,Y,Z or auto, which judges "
               "the format and the shape (default: auto)"),  # fmt: skip
        number("azimuth", "azimuth", "DEGREES", "angle of the camera around the up axis in degrees (default: 30, or "
               "the front of an open surface)"),  # fmt: skip
        number("elevation", "elevation", "DEGREES", "angle of the camera above the horizon in degrees (default: 20)"),
        Option("direction", "direction", "direction", "X,Y,Z", "direction from the eye into the scene, in place of "
               "azimuth and elevation"),  # fmt: skip
        Option("eye", "eye", "vector", "X,Y,Z", "position of the eye, which looks at the target"),
        Option("target", "target", "vector", "X,Y,Z", "point that the camera looks at (default: the middle of the model)"),
        number("fov", "fov", "DEGREES", "vertical angle of view in degrees; 0 is orthographic (default: 30, 0 in "
               "archaeological)"),  # fmt: skip
        number("margin", "margin", "SHARE", "share of the picture left free on each side; 0 to 0.45 (default: 0.05)"),
    ],
    "marks": [
        flag("keep_marks", "flags.KEEP_MARKS", "place all marks, even those that only other cameras or other styles "
             "show; for marks that are saved"),  # fmt: skip
        Option("layers", "mark_kinds", "layers", "NAMES", "layers of marks to draw: stipples, hatch or stipples,hatch "
               "(default: from the style)"),  # fmt: skip
        choice("distribution", "marks.distribution", "how marks are spread over the surface: evenly, or as in the "
               "published article (default: blue-noise)"),  # fmt: skip
        Option("marks", "marks.*.budget", "per_layer", "N", "largest number of marks of each layer, or LAYER=N,... "
               "(default: enough for nearly black tones)", "budget"),  # fmt: skip
        Option("levels", "marks.*.levels", "per_layer", "N", "refinement steps of the published distribution, or "
               "LAYER=N,...; 0 to 12 (default: enough to fill the picture)"),  # fmt: skip
        number("step", "marks.initial_step", "LENGTH", "first step of the published distribution, in units of the "
               "model (default: from the seeds)", "initial_step"),  # fmt: skip
        choice("seeds", "marks.seed_source", "where marks start: at the samples, in a box of cells or at seed_points "
               "(default: auto)", alias="seed_source"),  # fmt: skip
        Option("seed_points", "seed_points", "file", "FILE", "file of points to use as seeds"),
        count("box_resolution", "marks.box_resolution", 1, 256, "number of cells along the longest side of the box of "
              "seeds; 1 to 256 (default: 8)"),  # fmt: skip
        number("box_jitter", "marks.box_jitter", "X", "how far seeds are moved at random, in cell sides; 0 to 0.5 "
               "(default: 0.25)"),  # fmt: skip
        choice("stroke_start", "marks.layers.start", "what strokes of the published distribution start from (default: "
               "seeds)", alias="start"),  # fmt: skip
        count("start_level", "marks.layers.start_level", 0, 12, "last level of stipples that strokes start from; 0 to "
              "12 (default: 0)"),  # fmt: skip
        number("separation", "marks.layers.separation", "LENGTH", "distance between neighbouring lines of hatching, in "
               "units of the model (default: from the number of marks)"),  # fmt: skip
        number("stroke_step", "marks.layers.step", "LENGTH", "distance of marks along a line of hatching, in units of "
               "the model (default: 0.4 of the separation)"),  # fmt: skip
        choice("guide", "marks.layers.guide", "what lines of hatching follow (default: from the style)"),
        Option("guide_direction", "marks.layers.guide_direction", "direction", "X,Y,Z", "direction to the light or the "
               "eye for the guides light and silhouette (default: 0,0,1)"),  # fmt: skip
        number("guide_weight", "marks.layers.guide_weight", "X", "weight of the guide against the curvature; 0 to 1 "
               "(default: 1)"),  # fmt: skip
        number("hatch_angle", "hatch_angle", "DEGREES", "angle in degrees by which lines of hatching are turned; 90 "
               "crosses the guide (default: 0)"),  # fmt: skip
        choice("density", "marks.layers.density", "where stipples are denser: nowhere, or where the surface bends "
               "(default: from the style)", "uniform curvature"),  # fmt: skip
        number("density_strength", "marks.layers.density_strength", "X", "how much denser stipples are where the "
               "surface bends; 0 to 1 (default: 0.5)"),  # fmt: skip
        choice("tone_ranges", "marks.tone_ranges", "whether each layer shows all tones, or one layer after the other "
               "from light to dark (default: from the style)"),  # fmt: skip
        count("shared_marks", "marks.shared_budget", 0, None, "largest number of marks of all layers together, in "
              "place of one number for each layer", "shared_budget"),  # fmt: skip
        number("tone_smoothing", "marks.layers.tone_smoothing", "X", "share of the diagonal over which normals are "
               "averaged for the tone; 0 to 0.1 (default: 0.006 for hatch, else 0)"),  # fmt: skip
        number("projection_tolerance", "marks.projection_tolerance", "X", "largest distance of a mark from the "
               "surface, as a share of the diagonal (default: 1e-7)"),  # fmt: skip
        Option("curvature_of", "", "layers", "NAMES", "layers whose curvatures are kept in the result"),
    ],
    "fit": [
        choice("kernel", "fit.kernel", "radial function of the fit (default: triharmonic)",
               "triharmonic gaussian wendland_c2"),  # fmt: skip
        number("kernel_radius", "fit.kernel_radius", "LENGTH", "radius of the kernels gaussian and wendland-c2, in "
               "units of the points (default: from their spacing)"),  # fmt: skip
        count("degree", "fit.polynomial_degree", -1, 3, "degree of the polynomial of the fit, -1 (none) to 3 (default: "
              "1)", "polynomial_degree"),  # fmt: skip
        Option("regularization", "fit.regularization", "number_or_auto", "X", "smoothness of the fit, at least 0: 0 "
               "passes through all samples, larger is smoother, auto measures the noise (default: auto for points, 0 "
               "for meshes)"),  # fmt: skip
        choice("solver", "fit.solver", "solver of the linear system (default: auto)"),
        number("tolerance", "tolerance", "LENGTH", "largest distance between samples and surface, in units of the "
               "model; more centres are chosen until it is reached (default: 0.002 of the diagonal for meshes, none "
               "for points)"),  # fmt: skip
        count("max_centres", "maximum_centres", 0, None, "largest number of samples that become centres (default: 8000 "
              "for meshes, no limit for points)", "maximum_centres"),  # fmt: skip
        choice("outliers", "fit.outliers", "keep or drop stray samples (default: keep, drop for points without normals)",
               "keep drop"),  # fmt: skip
        choice("flipped_normals", "fit.flipped_normals", "keep samples with flipped normals, drop them or turn their "
               "normals (default: keep)"),  # fmt: skip
        count("refinement_steps", "fit.refinement_steps", 0, 20, "steps of refinement after a direct solve; 0 to 20 "
              "(default: 2)"),  # fmt: skip
    ],
    "samples": [
        count("samples", "samples", 1, None, "number of samples of a mesh or a point set (default: as many as the mesh "
              "needs, or up to 4096 points)"),  # fmt: skip
        number("crease", "crease_angle", "DEGREES", "angle in degrees from which faces of a mesh do not share normals; "
               "0 to 180 (default: 60)"),  # fmt: skip
        Option("edges", "", "edges", "EDGES", "which edges of a mesh stay sharp: auto keeps edges that stand out, "
               "smooth rounds all, a number of degrees keeps all that bend more (default: auto, or as the normals of "
               "the file say if faces are coarse)"),  # fmt: skip
        Option("subdivide", "subdivide", "count_or_auto 0 6", "N", "how often each face of a mesh is divided into four "
               "and rounded; 0 to 6 (default: as needed if faces are coarse)"),  # fmt: skip
        choice("parts", "parts", "parts of a mesh to draw: outer leaves out those inside others, solids keeps cavities, "
               "all keeps open parts inside others too, largest keeps one; auto is solids for hidden lines, sections, "
               "sheets and fits, else outer (default: auto)"),  # fmt: skip
        flag("together", "flags.TOGETHER", "fit an open mesh as one surface, even if its parts cross"),
        choice("normals", "normals", "state of the normals of points: auto finds out and repairs them, keep leaves "
               "them, none computes new ones, unoriented and mixed turn some, inward turns all (default: auto)",
               "auto keep none unoriented mixed inward"),  # fmt: skip
        Option("classes", "", "classes", "NUMBERS", "classes of the points to read from a LAS or LAZ file, with commas "
               "between, such as 2,6, or all (default: all but noise, or the ground alone if vegetation covers it)"),  # fmt: skip
        Option("viewpoint", "viewpoint", "vector", "X,Y,Z", "position of the scanner; open surfaces without normals "
               "face it (default: from the file)"),  # fmt: skip
        number("depth_smoothing", "depth_smoothing", "F", "factor of the width over which a depth image is smoothed; 0 "
               "leaves the points (default: 1)"),  # fmt: skip
        flag("flip", "flags.FLIP", "turn all normals, whichever way they point"),
        flag("close", "flags.CLOSE", "draw the surface beyond open data too, as the fit continues it"),
        count("random_seed", "random_seed", 0, 2**64 - 1, "seed of everything random, a whole number of at least 0 "
              "(default: 1)"),  # fmt: skip
    ],
    "vectors": [
        Option("page", "page.paper", "page", "PAPER", "size of the paper: a0 to a6, letter, legal, tabloid or "
               "WIDTHxHEIGHT in mm; the drawing is turned to fill it (default: 1/96 inch for each pixel)"),  # fmt: skip
        number("page_margin", "page.paper_margin", "MM", "free space on each side of the page in mm (default: 10)"),
        choice("dots", "page.dots", "how dots are drawn: circles, points that the pen touches, or spirals that fill "
               "them (default: circles)"),  # fmt: skip
        choice("stroke_widths", "page.widths", "how lines of varying width are drawn: as filled outlines, or split "
               "into classes of one width (default: outlines)"),  # fmt: skip
        Option("pens", "page.pens", "pens", "GROUP=COLOUR:MM", "pens for groups of lines, with commas between, as "
               "GROUP=COLOUR:MM or GROUP=COLOUR:MM:TYPE, such as contour=#000000:0.5 or hatch*=#803000:0.3:dashed"),  # fmt: skip
        Option("pen_widths", "page.pen_widths", "pen_widths", "MM,MM", "widths of your pens in mm: each group of lines "
               "gets the nearest one"),  # fmt: skip
        flag("single_pass", "page.SINGLE_PASS", "draw each line once along its centre, even if it is wider than the "
             "pen; dots are touched once"),  # fmt: skip
        flag("plot_order", "page.IN_PLOT_ORDER", "order lines so that a pen travels little; files for plotters always are"),
        number("vector_tolerance", "page.tolerance", "MM", "largest distance between drawn and written lines in mm, "
               "0.001 to 10 (default: 0.05)"),  # fmt: skip
        number("draw_speed", "page.draw_speed", "MM/S", "speed of the plotter's pen in mm/s, to estimate the time "
               "(default: 30)"),  # fmt: skip
        choice("curves", "page.curves", "how curves of lines of one width are written: arcs (of circles, where lines consist "
               "of them), splines, or straight lines (default: arcs)"),  # fmt: skip
        number("longest_path", "page.longest", "MM", "length that a pen draws at most before it is raised, in mm, at "
               "least 1; 0 is no limit (default: 0)"),  # fmt: skip
        Option("pen_up", "page.pen_up", "text", "GCODE", "G-code that raises the pen (default: G0 Z5)"),
        Option("pen_down", "page.pen_down", "text", "GCODE", "G-code that lowers the pen (default: G1 Z0)"),
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
