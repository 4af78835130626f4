# SPDX-License-Identifier: MIT
"""What is not in the article, by subject: panels that scripts/gallery draws, and docs/gallery.md shows."""

from panels import BUNNY, CANYON, HEAD, HEART, KNOT, LAMP, RAKING, TORI, Figure, Panel

BRACKET = "--up z --azimuth 40 --elevation 30"
SHEET = "--up z --section y --centre-lines --views front,left,top,iso --title Bracket --page a3 --scale 15:1 --line-width 0.9"
SOLID = "--style engraving --up z"

OURS = (
    Figure(
        "styles",
        "Styles",
        "Some of the named styles, each a full set of parameters to go on from.",
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
        "Hatching that follows something",
        "Lines whose width makes the tone, along curvature, or turned towards sections, the light or the contour.",
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
        "Feature lines beside contours; sections; what lies behind, by the number of layers that hide it.",
        "",
        (
            Panel("features", "contours, suggestive contours and the border", "canyon",
                  f"{CANYON} --style silhouette --lines contour,suggestive,border"),
            Panel("sections", "sections", "heart", f"{HEART} --style silhouette --lines contour,section=y:24 --hidden none"),
            Panel("hidden", "hidden parts dashed", "tori", f"{TORI} --style xray"),
            Panel("blueprint", "the same as a blueprint", "tori", f"{TORI} --style blueprint"),
        ),
    ),
    Figure(
        "edges",
        "Sharp edges",
        "A mesh with edges is cut along them and fitted sheet by sheet; the sheets meet in creases.",
        "",
        (
            Panel("sharp", "edges kept", "lantern", f"{LAMP} --style engraving"),
            Panel("smooth", "one smooth surface", "lantern", f"{LAMP} --style engraving --edges smooth"),
        ),
    ),
    Figure(
        "solids",
        "Solids and technical drawings",
        "Solids put together from primitives and models, with creases or blends; views and sections to scale.",
        "",
        (
            Panel("bracket", "a bracket, engraved", "bracket", f"{BRACKET} --style engraving", "csg"),
            Panel("sheet", "its views and a section, by ISO 128", "bracket", SHEET, "sheet-views", scale=1.6),
            Panel("blends", "two bars: with a crease, with two kinds of blend", "blends",
                  f"{SOLID} --azimuth 0 --fov 0", "csg", scale=1.6),
        ),
    ),
    Figure(
        "input",
        "What comes in",
        "Points without normals get them; an open surface ends where its samples do.",
        "",
        (
            Panel("cloud", "from 2000 points without normals", "cloud", f"{KNOT} --style etching"),
            Panel("trimmed", "a terrain ends where its samples do", "canyon",
                  f"{CANYON} {RAKING} --style engraving --lines contour,border"),
            Panel("closed", "the same, closed as the fit goes on", "canyon", f"{CANYON} {RAKING} --style engraving --close"),
        ),
    ),
    Figure(
        "vectors",
        "Vectors and plotters",
        "Curves with exact ends, in layers; and the order in which a pen draws them.",
        "Of the plot, the pen's way goes from blue to red; grey is where it is lifted.",
        (
            Panel("svg", "an SVG", "bunny_mesh", f"{BUNNY} --style etching", "svg"),
            Panel("detail", "a part of it, five times as large", "bunny_mesh", f"{BUNNY} --style etching", "svg", part=(0.13, 0.27, 0.33, 0.47)),
            Panel("plot", "the way of a plotter's pen", "bunny_mesh",
                  f"{BUNNY} --style hatch --page 120x120 --pen-widths 0.5", "plot"),
        ),
    ),
)  # fmt: skip
