# SPDX-License-Identifier: MIT
"""Styles of lines: how contours and feature lines are drawn as curves."""
from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Tuple

from ._arrays import block_in
from ._records import LineStyleFields
from ._style_part import KindStyle


class LineStyle(LineStyleFields, KindStyle):
    """How the lines of one kind are drawn, for items that have a `LineSet`; an element of `Style.lines`.

    Parameters
    ----------
    kind : {"contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section", \
            "border", "own", "crease", "shadow", "terminator", "soft_edge", "intersection", "tangent_edge"}
        The kind of lines that the style is for.
    name : str, optional
        For lines that are found once: the name of the lines that the style is for; None: any name.
    levels : sequence of float, optional
        For isophotes: the values of n . l, -1 to 1, where n is the normal and l the direction to the light.
    **fields
        Other fields to change.  Lengths are in pixels.
    """

    _c_type = "hrbfnpr_line_style"

    def __init__(
        self, kind: str = "contour", name: Optional[str] = None, levels: Sequence[float] = (), **fields: Any
    ) -> None:
        super().__init__(kind, name, fields)
        self.levels = tuple(levels)

    @property
    def levels(self) -> Tuple[float, ...]:
        """For isophotes: the values of n . l, -1 to 1."""
        return self._levels

    @levels.setter
    def levels(self, value: Sequence[float]) -> None:
        self._levels = tuple(float(level) for level in value)

    def scale(self, factor: float) -> None:
        """Multiply the lengths in pixels by a factor, for a picture that is larger by this factor.

        Other lengths are in widths of the line and follow.  Multiply `Style.halo_width` by the same factor.
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
