# SPDX-License-Identifier: MIT
"""The table of named styles, one row each.  bindings/generate makes everything that lists them from these rows.

    name    the name as users write it, and HRBFNPR_PRESET_... in the order of this table.  Add new rows at the end, because
            the number of a style never changes
    draws   the comment of the constant: which lines and marks the style draws
    use     a sentence for docs/presets.md: what the style is good for
    marks   the layers of marks that are generated for the style (hrbfnpr_layer_desc)
    layers  how layers of marks are drawn (hrbfnpr_layer_style); a layer takes the first element that fits it
    lines   how lines are drawn (hrbfnpr_line_style)
    style   the other fields (hrbfnpr_style)

An element is a dictionary of the C struct's fields.  A field that is not in it keeps the struct's default.  A constant is
written by its name: "dashed" is HRBFNPR_HIDDEN_PARTS_DASHED.  Lengths are in pixels, for a picture of 800 pixels.  Tones and
coverages are shares, 0 to 1.
"""
from typing import NamedTuple, Sequence


class Preset(NamedTuple):
    name: str
    draws: str
    use: str
    marks: Sequence[dict]
    layers: Sequence[dict]
    lines: Sequence[dict]
    style: dict


# ---- Colours (sRGB with alpha) and light

GRAPHITE = (0.20, 0.20, 0.22, 1.0)
CHALK = (0.91, 0.95, 1.0, 1.0)
WARM_PAPER = (0.98, 0.96, 0.915, 1.0)
BLUE_PAPER = (0.09, 0.25, 0.47, 1.0)
OCCLUSION = 0.8  # how much of the light is lost in hollows, in pictures and on items with a shading
UPPER_LEFT = (-0.5, 0.5, 0.7071067811865476)  # 45 degrees from the view, the convention of scientific drawings


# ---- Layers of marks that are generated

# Styles that draw only lines have stipples, too: stipples show where the surface is, and so what it hides.
STIPPLES = {"kind": "stipples"}


def hatching(angle=0.0, name=None, **fields):
    return {"kind": "hatch", "angle": angle, "name": name, **fields}


# ---- How layers are drawn

# With hatch_fade, lines in the lights become fewer and break, one after the other.  Without it, all would end on one
# tone, and forms that face the light would be blank.

# A style without contours draws its marks a little larger, so that they reach the rim.
FULL_RADIUS = 1.1


def shown(kind, **fields):
    return {"kind": kind, **fields}


def hidden(kind, **fields):
    return {"kind": kind, "shown": False, **fields}


def swelling(begin, end, coverage, name=None, **fields):
    """Lines that swell with the tone: from the darkness `begin` to the darkness `end`, where they cover the share `coverage`."""
    return {"kind": "hatch", "name": name, "shape": "hatch", "contours": False, "hatch_tone_begin": begin,
            "hatch_tone_end": end, "hatch_coverage_end": coverage, "hatch_spacing": 2.8, "hatch_pen": 0.45,
            "hatch_white": 0.68, "hatch_taper": 12.0, "hatch_shortest": 7.0, **fields}


def even(begin, end, coverage, name=None, **fields):
    """Lines of nearly one width.  Darker places have more of them."""
    return swelling(begin, end, coverage, name, **{"hatch_taper": 8.0, "hatch_shortest": 8.0, **fields})


def crossed(begin, end, coverage, name=None):
    """One of several sets of lines that cross at 30 to 65 degrees.  Each set begins where the set before it is full."""
    return even(begin, end, coverage, name, hatch_pen=0.6, hatch_spacing=2.6, hatch_coverage_begin=0.09, hatch_fade=0.09)


def pencilled(begin, end, coverage, seed, name=None):
    """Lines that wobble, and run past the tone at which they end."""
    return swelling(begin, end, coverage, name, hatch_coverage_begin=0.08, hatch_pen=0.7, hatch_spacing=2.8,
                    hatch_white=0.6, hatch_taper=4.0, hatch_shortest=9.0, hatch_wobble=1.2, hatch_overshoot=16.0,
                    hatch_seed=seed, hatch_fade=0.1, ink=GRAPHITE)


# ---- How lines are drawn, for items with a line set

# Nearer lines are heavier: the farthest ones have this share of the width of the nearest ones.
FAR = 0.45

def contour(width, **fields):
    return {"kind": "contour", "width": width, **fields}


def with_creases(line, width, *more):
    """A contour style, and styles for creases and for the intersections of items: thinner, and not heavier on outlines."""
    return [line, {**line, "kind": "crease", "width": width, "outline_factor": 1.0}, *more,
            {**line, "kind": "intersection", "width": width, "outline_factor": 1.0}]


def pencil(width, wobble, seed, **fields):
    return contour(width, cap="pointed", taper=30.0, lit_factor=0.6, far_factor=FAR, wobble=wobble, wobble_width=0.35,
                   wobble_length=46.0, wobble_seed=seed, ink=GRAPHITE, **fields)


def blueprint(kind, width, outline, name=None):
    return {"kind": kind, "name": name, "width": width, "outline_factor": outline, "hidden": "dashed", "hidden_width": 0.8,
            "taper": 0.0, "ink": CHALK}


# Soft edges of 60 degrees have the whole width, and weaker ones are narrower.
SOFT = {"taper": 24.0, "lower": 15.0, "upper": 60.0}


def with_edges(line, crease, soft):
    """As with_creases(), and a style for soft edges, which are thinner still, narrow to their ends, and do not show hidden parts."""
    return with_creases(line, crease, {**line, "kind": "soft_edge", "width": soft, "outline_factor": 1.0,
                                       "hidden": "none", **SOFT})


PLAIN_LINES = with_edges(contour(2.2), 1.4, 1.1)

# Hidden contours are pale, but visible through one or two layers of surface.
PALE = {"attenuation_front": 0.2, "attenuation_back": 0.1}

PRESETS = [
    Preset(
        "stipple",
        draws="stipples, denser where it is darker, without contours",
        use="Soft forms and fine tones without any line: the classic look of scientific drawing.",
        marks=[STIPPLES],
        layers=[shown("stipples", radius=FULL_RADIUS, contours=False), shown("any", contours=False)],
        lines=[],
        style={"silhouette_threshold": 0.05, "silhouette_radius": 1.2},
    ),
    Preset(
        "hatch",
        draws="lines of one width, denser where it is darker, and contours",
        use="Lines around the form, closer together where it is darker: tone and shape from one set of lines.",
        marks=[STIPPLES, hatching()],
        layers=[hidden("stipples"), even(0.12, 0.95, 0.42, hatch_pen=0.8, hatch_spacing=1.9, hatch_fade=0.1)],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2},
    ),
    Preset(
        "cross-hatch",
        draws="up to three sets of lines of one width, at 0, 35 and -30 degrees, each for a darker tone, and contours",
        use="Up to three sets of lines that cross at 30 to 65 degrees; dark places have more sets.",
        marks=[STIPPLES, hatching(0.0, "hatch-1"), hatching(35.0, "hatch-2"), hatching(-30.0, "hatch-3")],
        layers=[hidden("stipples"), crossed(0.12, 0.45, 0.24, "hatch-1"), crossed(0.38, 0.66, 0.24, "hatch-2"),
                crossed(0.60, 0.90, 0.30, "hatch-3"), crossed(0.12, 0.90, 0.30)],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2},
    ),
    Preset(
        "combing",
        draws="lines along Stark's combing direction, with a second set in the darks, and contours",
        use="Lines that do not follow the curvature: for surfaces that bend strongly and irregularly.",
        marks=[STIPPLES, hatching(0.0, "hatch-1", guide="combing"), hatching(40.0, "hatch-2", guide="combing")],
        layers=[hidden("stipples"), crossed(0.10, 0.60, 0.32, "hatch-1"), crossed(0.50, 0.92, 0.34, "hatch-2"),
                crossed(0.10, 0.92, 0.34)],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2},
    ),
    Preset(
        "silhouette",
        draws="contours only; hidden ones are paler",
        use="Contours only, with pale hidden ones: icons, instructions, a base to paint over.",
        marks=[STIPPLES],
        layers=[hidden("any")],
        # In a drawing of lines only, the outline is heavier.
        lines=with_edges(contour(2.8, hidden="attenuated", outline_factor=1.5, far_factor=FAR), 1.8, 1.5),
        style={"silhouette_radius": 1.2, **PALE},
    ),
    Preset(
        "contour-and-stipple",
        draws="contours and stipples",
        use="Contours and stipples: a good first choice for any model.",
        marks=[STIPPLES],
        layers=[shown("stipples"), hidden("hatch")],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2},
    ),
    Preset(
        "xray",
        draws="contours only; hidden ones are dashed",
        use="Contours only, with dashed hidden ones: technical drawings, assemblies.",
        marks=[STIPPLES],
        layers=[hidden("any")],
        lines=with_creases(contour(2.0, hidden="dashed", outline_factor=1.5), 1.4),
        style={"silhouette_radius": 1.2, "hidden_lines": "show"},
    ),
    Preset(
        "full",
        draws="stipples, cross hatching in the darks, contours and halos [NPAR, Figure 1 (e)]",
        use="Contours with a white halo, stipples, and lines in the darks, like the article's most finished drawing.",
        marks=[STIPPLES, hatching(0.0, "hatch-1"), hatching(40.0, "hatch-2")],
        # The lights have stipples only.  The darks have lines with stipples between them.
        layers=[shown("stipples", radius=0.7, share=0.45), crossed(0.40, 0.75, 0.34, "hatch-1"), crossed(0.62, 0.95, 0.34, "hatch-2"),
                crossed(0.40, 0.95, 0.34)],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2, "halo_width": 4.0, "occlusion_lights": OCCLUSION},
    ),
    Preset(
        "engraving",
        draws="one set of lines that swell with the tone, and contours; lights have a few broken lines",
        use="Parallel lines that swell with the tone, as in a banknote or an old book.",
        marks=[STIPPLES, hatching()],
        layers=[swelling(0.15, 0.95, 0.74, hatch_fade=0.12), hidden("any")],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2, "hidden_lines": "hide", "occlusion_lights": OCCLUSION},
    ),
    Preset(
        "etching",
        draws="up to three sets of thin lines, at 0, 50 and -40 degrees, each for a darker tone, and contours",
        use="Up to three sets of thin lines that cross each other; dark places have more sets.",
        # Illustrators leave highlights almost empty, and let their lines cross at 30 to 60 degrees.
        marks=[STIPPLES, hatching(0.0, "hatch-1"), hatching(50.0, "hatch-2"), hatching(-40.0, "hatch-3")],
        layers=[swelling(0.15, 0.55, 0.36, "hatch-1", hatch_fade=0.12),
                swelling(0.40, 0.75, 0.36, "hatch-2", hatch_fade=0.08),
                swelling(0.66, 0.92, 0.36, "hatch-3", hatch_fade=0.08), hidden("any")],
        lines=PLAIN_LINES,
        style={"silhouette_radius": 1.2, "hidden_lines": "hide", "occlusion_lights": OCCLUSION},
    ),
    Preset(
        "woodcut",
        draws="few wide lines, which close up to black, and heavy contours",
        use="Few wide lines that close up to black, and heavy contours: posters, small prints.",
        marks=[STIPPLES, hatching()],
        layers=[swelling(0.22, 0.75, 1.0, hatch_spacing=5.0, hatch_pen=0.9, hatch_white=0.0, hatch_taper=20.0,
                         hatch_shortest=12.0, hatch_fade=0.18), hidden("any")],
        lines=with_edges(contour(4.6, outline_factor=1.5, far_factor=FAR), 3.0, 2.2),
        style={"silhouette_radius": 1.2, "hidden_lines": "hide", "occlusion_lights": OCCLUSION},
    ),
    Preset(
        "scientific-stipple",
        draws="fine stipples lit from the upper left, and outlines that swell in the shade; lights stay empty",
        use="Stipples in even tones with fine contours, as in plates of biology and palaeontology.",
        marks=[{**STIPPLES, "tone_begin": 0.08, "tone_end": 1.0}],  # the lights stay empty
        layers=[shown("stipples", radius=0.6, share=0.85), hidden("any")],
        lines=with_edges(contour(1.3, outline_factor=1.6, lit_factor=0.55, taper=16.0), 0.9, 0.7),
        style={"silhouette_radius": 0.8, "light": UPPER_LEFT, "tone_exponent": 0.8, "occlusion_lights": OCCLUSION},
    ),
    Preset(
        "sketch",
        draws="pencil on warm paper: two sets of lines that stray and run past their ends, and contours drawn twice",
        use="Lines that wobble and overshoot, and contours drawn twice: first ideas, unfinished designs.",
        marks=[STIPPLES, hatching(0.0, "hatch-1"), hatching(40.0, "hatch-2")],
        layers=[pencilled(0.20, 0.70, 0.26, 1, "hatch-1"), pencilled(0.50, 0.92, 0.28, 2, "hatch-2"),
                pencilled(0.20, 0.92, 0.28, 3), hidden("any", ink=GRAPHITE)],
        lines=[pencil(2.2, 0.7, 1), pencil(1.4, 2.5, 2), {**pencil(1.6, 0.7, 3), "kind": "crease"},
               {**pencil(1.1, 0.7, 4), "kind": "soft_edge", **SOFT}, {**pencil(1.6, 0.7, 3), "kind": "intersection"}],
        style={"silhouette_radius": 1.2, "silhouette_ink": GRAPHITE, "hidden_lines": "hide", "paper": WARM_PAPER,
               "halo_width": 0.0},
    ),
    Preset(
        "blueprint",
        draws="pale lines on blue without tone: contours, borders, creases and lines called \"crease\"; hidden ones "
              "are dashed",
        use="Pale lines on dark paper, hidden ones dashed: plans.",
        marks=[STIPPLES],
        layers=[hidden("any", ink=CHALK)],
        lines=[blueprint("contour", 1.5, 1.6), blueprint("border", 1.5, 1.6), blueprint("own", 1.1, 1.0, "crease"),
               blueprint("crease", 1.1, 1.0), blueprint("intersection", 1.1, 1.0)],
        style={"silhouette_radius": 1.2, "silhouette_ink": CHALK, "paper": BLUE_PAPER, **PALE},
    ),
    Preset(
        "archaeological",
        draws="short lines along the curvature that taper to the light from the upper left, heavy outlines, and the "
              "RIDGE lines of a line set",
        use="The conventions for drawing finds: light from the upper left, scars along the curvature.",
        marks=[STIPPLES, hatching(smoothing=0.03, axis_weight=0.02)],
        # Lines are short, and get thinner towards the light.
        layers=[swelling(0.28, 0.92, 0.45, hatch_coverage_begin=0.08, hatch_taper=26.0, hatch_shortest=6.0,
                         hatch_spacing=3.2, hatch_fade=0.1), hidden("any")],
        # The outline is heavy.  Ridges between scars are thin lines.
        lines=[contour(1.8, outline_factor=1.8), {"kind": "ridge", "width": 1.2, "taper": 20.0, "shortest": 12.0},
               {"kind": "crease", "width": 1.2}, {"kind": "intersection", "width": 1.2}],
        style={"silhouette_radius": 1.2, "light": UPPER_LEFT, "hidden_lines": "hide"},
    ),
]
