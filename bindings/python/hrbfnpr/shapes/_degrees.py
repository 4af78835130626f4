# SPDX-License-Identifier: MIT
"""Tells longitudes and latitudes from lengths, and turns degrees into metres, the unit of heights."""
from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any, Optional, Tuple

import numpy as np

from ._shape import Floats

_METRES = 111_320.0  # length of a degree of latitude, in metres
_LOCAL = 10.0  # largest extent of coordinates around 0, 0 that count as lengths: few surveys are of the sea at 0, 0
# Heights in metres are at least this many times the extent in degrees.  Larger: fewer surfaces count as degrees.  A local
# grid is hardly higher than wide, and 0.5 degrees of flat land have a relief of 10 m.  Loose points may be a needle.
STEEP_GRID, STEEP_POINTS = 10.0, 100.0
NOTE = "degrees are converted to metres, the unit of the heights"


def are_degrees(low: Any, high: Any, steep: float) -> bool:
    """Whether a box of x, y and z can hold longitudes, latitudes, and heights in metres, and nothing else is likely.

    That is so if x and y are within the ranges of degrees, the heights are large beside the extents in degrees, and small
    beside these extents in metres.
    """
    extent = np.subtract(high, low)
    wide, relief = float(max(extent[:2])), float(extent[2])
    if not (low[0] >= -360 and high[0] <= 360 and low[1] >= -90 and high[1] <= 90 and relief > 0):
        return False
    has_origin = all(low[i] <= 0 <= high[i] for i in range(2))
    return steep * wide < relief < wide * _METRES and not (has_origin and wide < _LOCAL)


def metres(latitude: float) -> Tuple[float, float]:
    """The lengths in metres of a degree of longitude and of one of latitude."""
    return _METRES * math.cos(math.radians(latitude)), _METRES


def in_metres(points: Floats) -> Floats:
    """Points with longitude, latitude and height, in metres from the middle of their box."""
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) == 0:
        return points
    middle = (finite[:, :2].min(axis=0) + finite[:, :2].max(axis=0)) / 2
    result = points.copy()
    result[:, :2] = (points[:, :2] - middle) * metres(float(middle[1]))
    return result


def points_are_degrees(points: Floats, said: Optional[bool] = None) -> bool:
    """Whether points have longitudes and latitudes.  `said` is what the file says; None if it says nothing."""
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) == 0:
        return False
    low, high = finite.min(axis=0), finite.max(axis=0)
    if said is None:
        return are_degrees(low, high, STEEP_POINTS)
    return said and bool(low[0] >= -360 and high[0] <= 360 and low[1] >= -90 and high[1] <= 90)


def crs_says(text: str) -> Optional[bool]:
    """Whether a coordinate system, as WKT or as a .prj file of ArcInfo, has degrees; None if the text does not tell."""
    if re.search(r"\b(PROJCS|PROJCRS|PROJECTEDCRS|GEOCCS|LOCAL_CS|ENGCRS)\b|^\s*Units\s+(?!DD|DECIMAL)\w", text, re.I | re.M):
        return False
    if re.search(r"\b(GEOGCS|GEOGCRS|GEODCRS|GEODETICCRS|GEOGRAPHICCRS)\b|^\s*Projection\s+GEOGRAPHIC", text, re.I | re.M):
        return True
    return None


def prj_says(path: Path) -> Optional[bool]:
    """What the .prj file beside a file says, as `crs_says`; None without one."""
    stem = path.with_suffix("") if path.suffix.lower() in (".gz", ".gzip") else path
    for ending in (".prj", ".PRJ"):
        try:
            return crs_says(stem.with_suffix(ending).read_text(encoding="utf-8", errors="replace"))
        except (OSError, ValueError):
            pass
    return None
