# SPDX-License-Identifier: MIT
"""Figures beyond the article, by subject: scripts/gallery draws them, and docs/gallery.md shows them."""

from panels import BUNNY, CANYON, HEAD, HEART, KNOT, LAMP, RAKING, TORI, Figure, Panel

BRACKET = "--up z --azimuth 40 --elevation 30"
SHEET = "--up z --section y --centre-lines --views front,left,top,iso --title Bracket --page a3 --scale 15:1 --line-width 0.9"
SOLID = "--style engraving --up z"

OURS = (
    Figure(
        "styles",
        "Styles",
        "A named style sets all parameters. Options change single ones.",
        "",
        (
            Panel("sheet", "all named styles", "knot", KNOT, "sheet"),
            Panel("stipple", "scientific stipple", "head", f"{HEAD} --style scientific-stipple"),
            Panel("etching", "etching", "bunny_mesh", f"{BUNNY} --style etching"),
            Panel("engraving", "engraving", "knot", f"{KNOT} --style engraving"),
            Panel("woodcut", "woodcut", "heart", f"{HEART} --style woodcut"),
            Panel("archaeological", "archaeological, with a profile and a scale bar", "head",
                  f"{HEAD} --style archaeological --scale-bar m --tone-exponent 1.3"),
            Panel("terrain", "etching of a terrain, in raking light", "canyon",
                  f"{CANYON} {RAKING} --style etching --lines contour,border"),
        ),
    ),
    Figure(
        "hatching",
        "Directions of hatching",
        "Lines follow the curvature, horizontal sections or the light. Their width makes the tone.",
        "",
        tuple(
            Panel(guide, title, "heart", f"{HEART} --style engraving {options}".strip())
            for guide, title, options in (
                ("curvature", "along curvature", ""),
                ("sections", "along sections", "--guide sections"),
                ("light", "along the light", "--guide light"),
            )
        ),
    ),
    Figure(
        "lines",
        "Lines",
        "Contours with feature lines, sections, and hidden parts. More surfaces in front make the dashes shorter.",
        "",
        (
            Panel("features", "contours, suggestive contours and the border", "canyon",
                  f"{CANYON} --style silhouette --lines contour,suggestive,border"),
            Panel("sections", "sections", "heart", f"{HEART} --style silhouette --lines contour,section=y:24 --hidden none"),
            Panel("hidden", "hidden parts, dashed", "tori", f"{TORI} --style xray"),
            Panel("blueprint", "the same as a blueprint", "tori", f"{TORI} --style blueprint"),
        ),
    ),
    Figure(
        "edges",
        "Sharp edges",
        "A mesh is divided into patches along its sharp edges. Each patch is fitted with a sheet, and the sheets meet in creases.",
        "",
        (
            Panel("sharp", "sharp edges", "lantern", f"{LAMP} --style engraving"),
            Panel("smooth", "the same mesh as one smooth surface", "lantern", f"{LAMP} --style engraving --edges smooth"),
        ),
    ),
    Figure(
        "solids",
        "Solids and technical drawings",
        "Solids are built from primitives and models. Their parts meet in creases or blends. Views and sections are to scale.",
        "",
        (
            Panel("bracket", "a bracket, engraved", "bracket", f"{BRACKET} --style engraving", "csg"),
            Panel("sheet", "views and a section of the bracket", "bracket", SHEET, "sheet-views", scale=1.6),
            Panel("blends", "two crossing bars, with a crease and with two kinds of blend", "blends",
                  f"{SOLID} --azimuth 0 --fov 0", "csg", scale=1.6),
        ),
    ),
    Figure(
        "input",
        "Input",
        "The normals of points are found if there are none. An open surface ends where its samples end.",
        "",
        (
            Panel("cloud", "from 2000 points without normals", "cloud", f"{KNOT} --style etching"),
            Panel("trimmed", "a terrain that ends where its samples end", "canyon",
                  f"{CANYON} {RAKING} --style engraving --lines contour,border"),
            Panel("closed", "the same terrain, not trimmed", "canyon", f"{CANYON} {RAKING} --style engraving --close"),
        ),
    ),
    Figure(
        "vectors",
        "Vectors and plotters",
        "Drawings are written as curves in layers, or as the moves of a pen.",
        "The path of the pen goes from blue to red. It is grey where the pen is up.",
        (
            Panel("svg", "an SVG", "bunny_mesh", f"{BUNNY} --style etching", "svg"),
            Panel("detail", "a part of the SVG, five times as large", "bunny_mesh", f"{BUNNY} --style etching", "svg", part=(0.13, 0.27, 0.33, 0.47)),
            Panel("plot", "the path of a plotter's pen", "bunny_mesh",
                  f"{BUNNY} --style hatch --page 120x120 --pen-widths 0.5", "plot"),
        ),
    ),
)  # fmt: skip
