# SPDX-License-Identifier: MIT
"""The figures of the article and their panels, as options of `python3 -m hrbfnpr draw`.

--mark-radius and --halo are for pictures whose longer side has 640 pixels. They are scaled with the size.
"""

from panels import (
    ALONG_FIRST, ALONG_SECOND, BOX, BUNNY, CANYON, FIRST, HEAD, HEART, KNOT, LAMP, MANY, RAKING, SECOND, TORI, Figure, Panel, both,
)  # fmt: skip

PAPER = (
    Figure(
        "1",
        "Steps of drawing a head",
        "(a) point and normal samples; (b) silhouettes with hidden-line attenuation; (c) a small number of stippling "
        "marks; (d) more stipples and cross hatching by curvature; (e) yet more stipples, and interior contours with a "
        "white halo. 4096 samples, 700 000 marks.",
        "A bust in place of David's head, with 4096 samples as seeds. (e) has 512 000 stipples and 221 000 marks of strokes, "
        "both of 3 refinement steps. The article does not give the numbers for (c) and (d). Here (c) shows 8 % of the "
        "stipples of 3 steps, and (d) has the stipples of 2 steps.",
        (
            Panel("a", "(a) samples", "head", HEAD, "samples"),
            *both(
                "b",
                "(b) silhouettes",
                "head",
                f"{HEAD} --style silhouette --levels 3",
                f"{HEAD} --style silhouette",
            ),
            *both(
                "c",
                "(c) few stipples",
                "head",
                f"{HEAD} --levels 3 --share 0.08 --mark-radius 0.5",
                f"{HEAD} --share 0.25",
            ),
            *both(
                "d",
                "(d) cross hatching",
                "head",
                f"{HEAD} --style full --layers stipples,hatch --levels stipples=2,hatch=3 --mark-radius 0.5",
                f"{HEAD} --style etching",
            ),
            *both(
                "e",
                "(e) more stipples and a halo",
                "head",
                f"{HEAD} --style full --layers stipples,hatch --levels 3 --halo 4 --mark-radius 0.5",
                f"{HEAD} --style full --halo 4",
            ),
        ),
    ),
    Figure(
        "7",
        "Directions of drawing",
        "(a) 256 samples of the Stanford bunny. Combing directions over (b) the sphere and (c) the bunny. (d) First "
        "and second principal directions of curvature.",
        "256 samples, seeds from a box of 8 cells, strokes of 4 refinement steps (3 on the sphere), no light. The drawings of "
        "hrbfnpr have light. Their lines follow the direction in which the surface bends most, or run across it.",
        (
            Panel("a", "(a) samples", "bunny", BUNNY, "samples"),
            *both(
                "b",
                "(b) combing, sphere",
                "sphere",
                f"{BOX} --style combing --levels 3 --tone none",
                "--style combing",
            ),
            *both(
                "c",
                "(c) combing",
                "bunny",
                f"{BUNNY} {BOX} --style combing --levels 4 --tone none --mark-radius 0.7",
                f"{BUNNY} --style combing",
            ),
            *both(
                "d1",
                "(d) first principal direction",
                "bunny",
                f"{BUNNY} {BOX} --style cross-hatch {FIRST} --levels 4 --tone none --mark-radius 0.7",
                f"{BUNNY} {ALONG_FIRST}",
            ),
            *both(
                "d2",
                "(d) second principal direction",
                "bunny",
                f"{BUNNY} {BOX} --style cross-hatch {SECOND} --levels 4 --tone none --mark-radius 0.7",
                f"{BUNNY} {ALONG_SECOND}",
            ),
        ),
    ),
    Figure(
        "8",
        "Hidden-line attenuation",
        "Left: the decay of alpha when the point gets closer to the silhouette: back points (red) and front points "
        "(green). Middle: without hidden-line attenuation. Right: the final result.",
        "The article does not name the model. Here it is two linked tori. Lambda is 1.",
        (
            Panel("a", "alpha by n.v", "tori", "", "decay"),
            *both(
                "b",
                "without attenuation",
                "tori",
                f"{TORI} --style silhouette --levels 5 --hidden-lines show",
                f"{TORI} --style silhouette --hidden-lines show",
            ),
            *both("c", "attenuated", "tori", f"{TORI} --style silhouette --levels 5", f"{TORI} --style silhouette"),
        ),
    ),
    Figure(
        "10",
        "Tone, and tone by scale",
        "(From left to right) Tone by removing marks in proportion to the light's intensity. Scaling a shaded heart by "
        "removing marks.",
        "The exponents of the light are 0.5, 1 and 2. The heart is drawn at full size, half and a quarter, with marks of the "
        "same size. The share of marks that remains falls with the square of the size, in every tone. By the printed rule a "
        "mark has a single random number for light and size, so only the darkest places would keep marks. Without the data "
        "the heart is Taubin's surface.",
        (
            *both(
                "a",
                "exponent 0.5",
                "heart",
                f"{HEART} {MANY} --tone-exponent 0.5",
                f"{HEART} --tone-exponent 0.5",
            ),
            *both("b", "exponent 1", "heart", f"{HEART} {MANY}", HEART),
            *both("c", "exponent 2", "heart", f"{HEART} {MANY} --tone-exponent 2", f"{HEART} --tone-exponent 2"),
            *both(
                "d",
                "at a half",
                "heart",
                f"{HEART} {MANY} --tone-rule share --zoom-reference {{zoom}} --zoom-exponent 2",
                f"{HEART} --mark-radius 1",
                scale=0.5,
            ),
            *both(
                "e",
                "at a quarter",
                "heart",
                f"{HEART} {MANY} --tone-rule share --zoom-reference {{zoom}} --zoom-exponent 2",
                f"{HEART} --mark-radius 1",
                scale=0.25,
            ),
        ),
    ),
    Figure(
        "11",
        "Principal directions",
        "First and second principal directions of curvature applied locally on two tori and a knot.",
        "Strokes from the samples, 4 refinement steps (3 on the knot). The first direction is the one in which the surface "
        "bends most.",
        tuple(
            panel
            for model, view, levels in (("tori", TORI, 4), ("knot", KNOT, 3))
            for name, direction, ours in (("first", FIRST, ALONG_FIRST), ("second", SECOND, ALONG_SECOND))
            for panel in both(
                f"{model}_{name}",
                f"{name} direction",
                model,
                f"{view} --style cross-hatch {direction} --levels {levels} --mark-radius 0.7",
                f"{view} {ours}",
            )
        ),
    ),
    Figure(
        "12",
        "A garden lamp",
        "General and detailed rendering of a garden lamp.",
        "1500 samples of the mesh. hrbfnpr draws mesh edges of 30 degrees and more as lines. The published method has no such "
        "lines.",
        tuple(
            panel
            for name, part in (("general", None), ("detail", (0.25, 0.0, 0.75, 0.5)))
            for panel in both(
                name,
                name,
                "lamp",
                f"{LAMP} --style full --layers stipples,hatch --levels 3",
                f"{LAMP} --style engraving --lines contour,crease",
                part=part,
                scale=1.0 if part is None else 2.0,
            )
        ),
    ),
    Figure(
        "13",
        "A canyon",
        "From top to bottom: stippling with depth modulation; cross-hatching along the principal directions; the 512 "
        "samples; three different visual abstractions of the model. 512 samples, 400 000 marks.",
        "hrbfnpr ends the surface where its samples end, and draws this border. Depth modulation begins at the nearest "
        "place of the model and ends a little beyond the farthest. The light comes from the left.",
        (
            *both(
                "a",
                "stipples, depth",
                "canyon",
                f"{CANYON} --levels 4 --style stipple --mark-radius 0.6 --tone none --depth-range {{near}},{{far}}",
                f"{CANYON} --style stipple --tone none --depth-range {{near}},{{far}} --lines contour,border",
                scale=2.0,
            ),
            *both(
                "b",
                "cross-hatching",
                "canyon",
                f"{CANYON} {RAKING} --levels 5 --style cross-hatch --mark-radius 0.6",
                f"{CANYON} {RAKING} --style etching --lines contour,border",
                scale=2.0,
            ),
            Panel("c", "samples", "canyon", CANYON, "samples", scale=2.0),
            *both(
                "d",
                "silhouettes",
                "canyon",
                f"{CANYON} --levels 5 --style silhouette",
                f"{CANYON} --style silhouette --lines contour,suggestive,border",
                scale=2.0,
            ),
            *both(
                "e",
                "contours and stipples",
                "canyon",
                f"{CANYON} {RAKING} --levels 4 --mark-radius 0.6",
                f"{CANYON} {RAKING} --lines contour,border",
                scale=2.0,
            ),
            *both(
                "f",
                "strokes and stipples",
                "canyon",
                f"{CANYON} {RAKING} --levels 4 --style full --layers stipples,hatch --mark-radius 0.6",
                f"{CANYON} {RAKING} --style full --lines contour,border",
                scale=2.0,
            ),
        ),
    ),
)
