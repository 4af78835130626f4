# SPDX-License-Identifier: MIT
"""Which direction is up: by the format's convention, by the shape where that is clear, else y."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

import numpy as np

from ..shapes import Shape
from ..shapes._shape import Floats, Vector

Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
_FLAT = 0.3  # relief of a terrain over its shorter side, at most ...
_RELIEF = 0.003  # ... and at least
_UPWARD = 0.7  # mean of the normals' upward parts
_BASE = 0.05  # share of the surface that a base has, at least
_MAP = 10000.0  # eastings and northings, at least
_FOOT = 0.04  # share of the height that what it stands on has ...
_STEADY = 0.3  # ... and the share of its shadow
_NOTHING = "nothing speaks for another direction"
_OTHERS = 4.0  # how much larger it is than any other flat end; a top than feet
_MIRRORED = 1.0  # distance of mirrored samples from others, in spacings: where it is less, left and right are alike ...
_UNLIKE = 1.2  # ... and where it is more they are not
_CLEARLY = 1.8  # how much farther those mirrored along another axis are
_LEAF = 0.1  # thickness of a leaf, over its shorter side: it lies
_LOOKED_AT = 1200  # samples that are mirrored
_BELOW = 0.15  # share of the height that the border of what is open below has ...
_ITS_BORDER = 0.5  # ... for that share of its length ...
_NOT_ABOVE = 0.05  # ... with less than that in the same share of the height above ...
_ITS_HOLE = 2.0  # ... and how much larger its hole is, seen along that axis, than along others


def choose(shape: Optional[Shape], points: Floats, normals: Floats) -> Tuple[Vector, str]:
    """Up, and why."""
    if shape is not None and shape.up is not None:
        of = "pictures of a depth camera" if shape.is_picture else f"{shape.format.split(',')[0]} files"
        return shape.up, f"it is so in {of}"
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    if (extent <= 0).any():
        return Y, _NOTHING
    if _on_a_map(low, high, extent):
        return Z, "x and y are coordinates of a map"
    if _is_terrain(extent, normals, 2) and not _is_terrain(extent, normals, 1):
        return Z, "the surface is a terrain: it is flat, and looks along z everywhere"
    if (np.abs(normals[:, 2]) > 0.05).mean() > 0.98 and abs(np.sign(normals[:, 2]).mean()) > 0.95:
        return Y, _NOTHING  # a view from one side, or a relief: it has no end to stand on
    bases = _bases(points, normals, low, extent)
    if bases[4] >= _BASE and bases[4] >= _OTHERS * np.delete(bases, 4).max():
        return Z, "it has a flat base below along z, and no other flat end"
    left_right = _sideways(points, extent)
    if left_right == 1:
        return Z, "left and right, along y, are alike, above and below along z are not"
    if left_right == 2 or _opens_below(shape, 1):
        return Y, _NOTHING
    if _stands(low, high, extent, 2) and not _stands(low, high, extent, 1) and bases[4] >= bases[2]:
        return Z, "it stands on z = 0, in the middle of x and y"
    if _rests(points, 2, 1) and not (_rests(points, 1, 1) or _rests(points, 1, -1)):
        feet, top = (int(_end_of(points, 2, side).sum()) for side in (1, -1))
        if top > _OTHERS * feet or not _rests(points, 2, -1):
            return Z, "it stands on its feet below along z, and would fall along y"
    return Y, _NOTHING


def _on_a_map(low: Floats, high: Floats, extent: Floats) -> bool:
    """Eastings and northings are far from 0, heights are not."""
    middle, height = np.abs(low + high)[:2] / 2, max(abs(low[2]), abs(high[2]))
    return bool((middle > np.maximum(_MAP, 2 * extent[:2])).all() and middle.min() > 2 * height)


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


def _sideways(points: Floats, extent: Floats) -> Optional[int]:
    """Along which of y and z both sides are alike, where along the other they are not: most things have a left and a
    right, but few the same above and below [Fu et al. 2008]."""
    if len(points) < 8:
        return None
    spacing = _farther(points[::2], points[1::2])
    off = []
    for axis in (1, 2):
        mirrored = points[:: max(1, len(points) // _LOOKED_AT)].copy()
        both = (points[:, axis].mean(), (points[:, axis].min() + points[:, axis].max()) / 2)
        sides = [np.where(np.arange(3) == axis, 2 * middle - mirrored, mirrored) for middle in both]
        off.append(min(_farther(side, points) for side in sides))
    for k, axis in enumerate((1, 2)):
        lies = extent[axis] < _LEAF * np.delete(extent, axis).min()
        alike, unlike = off[k] < _MIRRORED * spacing, off[1 - k] > max(_UNLIKE * spacing, _CLEARLY * off[k])
        if alike and unlike and not lies:
            return axis
    return None


def _opens_below(shape: Optional[Shape], axis: int) -> bool:
    """Whether it is a mesh with a hole to stand on, as busts have and what was scanned on a table."""
    if shape is None or shape.triangles is None or len(shape.triangles) == 0:
        return False
    faces = np.asarray(shape.triangles, dtype=np.int64)
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = sides.min(axis=1), sides.max(axis=1)
    _, first, count = np.unique(low * len(shape.points) + high, return_index=True, return_counts=True)
    start, end = (np.asarray(shape.points)[sides[first[count == 1], k]] for k in (0, 1))
    length = np.linalg.norm(end - start, axis=1)
    if not length.sum() > 0:
        return False
    height = (start[:, axis] + end[:, axis]) / 2
    heights = np.asarray(shape.points)[faces.ravel(), axis]
    share = (height - heights.min()) / np.ptp(heights)
    hole = np.abs(np.cross(start - start[0], end - start[0]).sum(axis=0))
    return bool(
        length[share < _BELOW].sum() >= _ITS_BORDER * length.sum()
        and length[share > 1 - _BELOW].sum() <= _NOT_ABOVE * length.sum()
        and hole[axis] > _ITS_HOLE * np.delete(hole, axis).max()
    )


def _farther(places: Floats, points: Floats) -> float:
    """Distance from the nearest of the points that nine in ten of the places are within."""
    nearest = [np.sqrt(((points - place) ** 2).sum(axis=1).min()) for place in places[:_LOOKED_AT]]
    return float(np.percentile(nearest, 90))


def _rests(points: Floats, axis: int, side: int) -> bool:
    """Whether it stands on what is lowest along an axis: that is wide, and the middle of all lies above it."""
    flat = np.delete(points, axis, axis=1)
    shadow, base = _hull(flat), _hull(flat[_end_of(points, axis, side)])
    if len(base) < 3 or _area(base) < _STEADY * _area(shadow):
        return False
    along, off = np.roll(base, -1, axis=0) - base, flat.mean(axis=0) - base
    return bool((along[:, 0] * off[:, 1] - along[:, 1] * off[:, 0] > 0).all())


def _end_of(points: Floats, axis: int, side: int) -> Any:
    height = side * points[:, axis]
    return height < height.min() + _FOOT * np.ptp(height)


def _area(polygon: Floats) -> float:
    following = np.roll(polygon, -1, axis=0)
    return float((polygon[:, 0] * following[:, 1] - polygon[:, 1] * following[:, 0]).sum()) / 2


def _hull(points: Floats) -> Floats:
    """Corners of the convex hull, anticlockwise [Andrew 1979]."""
    ordered = np.unique(points, axis=0)
    chains = []
    for half in (ordered, ordered[::-1]):
        chain: List[Floats] = []
        for point in half:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains += chain[:-1]
    return np.array(chains).reshape(-1, 2)


def _turn(a: Floats, b: Floats, c: Floats) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def name(up: Vector) -> str:
    """x, -x, ... or the numbers."""
    for i, axis in enumerate("xyz"):
        if abs(up[i]) == np.abs(up).sum():
            return axis if up[i] > 0 else f"-{axis}"
    return ",".join(f"{part:g}" for part in up)
