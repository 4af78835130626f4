# SPDX-License-Identifier: MIT
"""Lights of a style."""
from __future__ import annotations

from typing import Any, Optional, Sequence

from ._records import LightFields
from ._style_part import StylePart


class Light(LightFields, StylePart):
    """A light; an element of `Style.lights`.

    Parameters
    ----------
    kind : {"directional", "place"}
        Where the light comes from: from far away, everywhere from the same direction, or from a place.
    place : (x, y, z), optional
        The direction to the light, of any length but 0, or its place; None: the default.
    **fields
        Other fields to change: `space` ("camera", "world" or "item"), `intensity` (0 to 16; 1: a surface that faces the
        light is white), `shadow` (the share of its light that cast shadows take away, 0 to 1) and `softness` (its radius
        as the surface sees it, in radians, 0 to 0.5).

    Examples
    --------
    >>> style = hrbfnpr.Style("engraving", ambient_sky=0.2)
    >>> style.lights = [hrbfnpr.Light(place=(-1, 1, 1)), hrbfnpr.Light("place", (0, 0, 3), space="world", intensity=0.4)]
    """

    _c_type = "hrbfnpr_light"

    def __init__(self, kind: str = "directional", place: Optional[Sequence[float]] = None, **fields: Any) -> None:
        super().__init__(kind, fields if place is None else {"place": place, **fields})
