# SPDX-License-Identifier: MIT
"""Styles of lines: contours and feature lines as curves."""
from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Tuple

from ._arrays import block_in
from ._fields import choice, color_field, integer, number
from ._kind_style import KindStyle
from ._names import CAPS, CREASES, HIDDEN_PARTS, LINE_KINDS


class LineStyle(KindStyle):
    """How the lines of one kind are drawn, of items that have a `LineSet`; an element of `Style.lines`.

    Parameters
    ----------
    kind : {"contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section", \
            "border", "own", "crease"}
    name : str, optional
        Of lines that are found once: those that are called so; None: whatever they are called.
    levels : sequence of float, optional
        Of isophotes: n . l, from -1 to 1.
    **fields
        Other fields to change.  Lengths are in pixels.
    """

    kind = choice(LINE_KINDS, "The lines that this is for.")
    hidden = choice(HIDDEN_PARTS, 'Parts that surface hides: "none", "attenuated", "dashed" or "shown".')
    cap = choice(CAPS, 'Of free ends, where a line turns behind its own surface: "round", "flat" or "pointed".')
    width = number("Pixels.")
    taper = number(
        "Pixels over which a line narrows to a free end; 0 = not at all.  Parts with a free end that are shorter than "
        "two tapers are the thinner, the shorter they are."
    )
    hidden_width = number('Of "attenuated" and "dashed".')
    hidden_opacity = number('Of "attenuated", for each layer of surface before it, 0 to 1.')
    dash = number('Of "dashed", in hidden_widths; the more layers lie before it, the shorter.')
    gap = number("Between dashes, in hidden_widths.")
    shortest = number("Parts with a free end, and hidden ones, that are shorter are not drawn.")
    fade = number("0 to 1: how much paler a line is where its strength is `lower` than where it is `upper`.")
    lower = number("A line goes on while its strength is at least this; 0 with `upper` 0 = that of the kind.")
    upper = number("... and is drawn if it is this somewhere.")
    ink = color_field("Straight RGBA in [0, 1], or '#rrggbb'.")
    outline_factor = number(
        "Of the width of contours and borders, where nothing lies beside them: the drawing's outline."
    )
    far_factor = number("Of the width at the farthest of all lines' places in view; 1 at the nearest.")
    lit_factor = number("Of the width where the surface faces the style's light; 1 where it faces away.")
    curvature_factor = number("Of the width where the surface bends sharply: of contours along the line of sight.")
    curvature_radius = number("Diagonals: the radius of curvature from which on curvature_factor has no effect.")
    wobble = number("How far an unsteady hand may stray to either side, in widths.")
    wobble_width = number("0 to 1: the share by which its width may vary.")
    wobble_length = number("From swing to swing, about, in widths.")
    wobble_seed = integer("Which of many wobbles.")
    creases = choice(CREASES, 'Of creases, by the way that the surface bends: "all", "convex" or "concave".')

    _c_type = "hrbfnpr_line_style"

    def __init__(
        self, kind: str = "contour", name: Optional[str] = None, levels: Sequence[float] = (), **fields: Any
    ) -> None:
        super().__init__(kind, name, fields)
        self.levels = tuple(levels)

    @property
    def levels(self) -> Tuple[float, ...]:
        """Of isophotes: n . l, from -1 to 1."""
        return self._levels

    @levels.setter
    def levels(self, value: Sequence[float]) -> None:
        self._levels = tuple(float(level) for level in value)

    def scale(self, factor: float) -> None:
        """Multiply all lengths that are in pixels, as for a picture so many times as large.

        The others are in widths.  Of a `Style`, `halo_width` belongs to them.
        """
        for field in ("width", "hidden_width", "taper", "shortest"):
            setattr(self, field, getattr(self, field) * factor)

    def _values(self) -> Dict[str, Any]:
        return {**super()._values(), "levels": self.levels}

    def _fill(self, target: Any) -> Any:
        keep = [super()._fill(target)]
        if self._levels:
            keep.append(block_in("levels", self._levels, 1, "d").fill(target.levels))
        return keep
