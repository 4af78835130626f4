# SPDX-License-Identifier: MIT
"""Which direction is up: by the format's convention, by the shape where that is clear, else y."""
from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from ..shapes import Shape
from ..shapes._shape import Floats, Vector

Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
_FLAT = 0.3  # relief of a terrain over its shorter side, at most ...
_RELIEF = 0.003  # ... and at least
_UPWARD = 0.7  # mean of the normals' upward parts
_BASE = 0.05  # share of the surface that a base has, at least
_NOTHING = "nothing speaks for another direction"
_OTHERS = 4.0  # how much larger it is than any other flat end


def choose(shape: Optional[Shape], points: Floats, normals: Floats) -> Tuple[Vector, str]:
    """Up, and why."""
    if shape is not None and shape.up is not None:
        return shape.up, f"it is so in {shape.format.split(',')[0]} files"
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    if (extent <= 0).any():
        return Y, _NOTHING
    if _is_terrain(extent, normals, 2) and not _is_terrain(extent, normals, 1):
        return Z, "the surface is a terrain: it is flat, and looks along z everywhere"
    if (np.abs(normals[:, 2]) > 0.05).mean() > 0.98 and abs(np.sign(normals[:, 2]).mean()) > 0.95:
        return Y, _NOTHING  # a view from one side, or a relief: it has no end to stand on
    bases = _bases(points, normals, low, extent)
    if bases[4] >= _BASE and bases[4] >= _OTHERS * np.delete(bases, 4).max():
        return Z, "it has a flat base below along z, and no other flat end"
    if _stands(low, high, extent, 2) and not _stands(low, high, extent, 1) and bases[4] >= bases[2]:
        return Z, "it stands on z = 0, in the middle of x and y"
    return Y, _NOTHING


def hangs(points: Floats, normals: Floats) -> Optional[str]:
    """The axis along which a terrain looks down; None if it does not, or is none."""
    extent = np.ptp(points, axis=0)
    for axis in (2, 1):
        if (extent > 0).all() and _is_terrain(extent, normals, axis) and normals[:, axis].mean() < 0:
            return "xyz"[axis]
    return None


def _is_terrain(extent: Floats, normals: Floats, axis: int) -> bool:
    upward = normals[:, axis]
    upward = upward * np.sign(upward.mean())
    wide = np.delete(extent, axis).min()
    return bool(
        _RELIEF * wide < extent[axis] < _FLAT * wide and (upward > 0).mean() > 0.99 and upward.mean() > _UPWARD
    )


def _bases(points: Floats, normals: Floats, low: Floats, extent: Floats) -> Any:
    """Shares of the samples on a flat end: below along x, above along x, below along y, ..."""
    place = (points - low) / extent
    shares = []
    for axis in range(3):
        for height, outward in ((place[:, axis], -normals[:, axis]), (1 - place[:, axis], normals[:, axis])):
            shares.append(float(((height < 0.02) & (outward > 0.9)).mean()))
    return np.array(shares)


def _stands(low: Floats, high: Floats, extent: Floats, axis: int) -> bool:
    across = [other for other in range(3) if other != axis]
    middle = np.abs(low + high)[across] / 2
    return bool(abs(low[axis]) <= 0.005 * extent[axis] and (middle <= 0.05 * extent[across]).all())


def name(up: Vector) -> str:
    """x, -x, ... or the numbers."""
    for i, axis in enumerate("xyz"):
        if abs(up[i]) == np.abs(up).sum():
            return axis if up[i] > 0 else f"-{axis}"
    return ",".join(f"{part:g}" for part in up)
