# SPDX-License-Identifier: MIT
"""What lies so far away that all else would be a dot in the picture: values that stand for none, strays, lost parts."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, Optional, Tuple

import numpy as np

from .._mesh import Mesh
from ..shapes import Shape
from ..shapes._shape import Floats

NO_DATA = (-9999.0, -99999.0, -999999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1.7976931348623157e308)
FAR = 4.0  # times as far from the middle as all that is left, or as large
FEW = 0.005  # of the points, ...
LITTLE = 0.001  # ... of the area


def without_data(shape: Shape) -> Tuple[Shape, int, float]:
    """Without the points that have such a coordinate, far below all others; how many they are, and which it is."""
    for value in NO_DATA:
        empty = (shape.points == value).any(axis=1)
        if not empty.any() or empty.all():
            continue
        rest = shape.points[~empty]
        rest = rest[np.isfinite(rest).all(axis=1)]
        if len(rest) == 0 or rest.min() - value < np.ptp(rest, axis=0).max():
            continue
        left = _left(shape, ~empty)
        if left is not None:
            return left, int(empty.sum()), value
    return shape, 0, 0.0


def without_strays(shape: Shape) -> Tuple[Shape, int]:
    """Points without a few that lie apart from all others, and how many these are."""
    far = strays(shape.points)
    left = _left(shape, ~far) if far.any() else None
    return (shape, 0) if left is None else (left, int(far.sum()))


def _left(shape: Shape, kept: Any) -> Optional[Shape]:
    """Those points alone, with the faces that have no others; None if there would be none."""
    normals = None if shape.normals is None else shape.normals[kept]
    if not shape.is_mesh:
        return replace(shape, points=shape.points[kept], normals=normals, image_shape=None)
    assert shape.triangles is not None
    faces = shape.triangles[kept[shape.triangles].all(axis=1)]
    if len(faces) == 0:
        return None
    number = np.cumsum(kept) - 1
    sharp = shape.sharp_edges
    if sharp is not None:
        sharp = number[sharp[kept[sharp].all(axis=1)]]
    return replace(shape, points=shape.points[kept], normals=normals, triangles=number[faces], sharp_edges=sharp)


def strays(points: Floats) -> Any:
    """Which of many points are a few that lie apart from all others."""
    finite = np.isfinite(points).all(axis=1)
    far = np.zeros(len(points), dtype=bool)
    if finite.sum() < 2 / FEW:
        return far
    distance = np.full(len(points), -1.0)
    distance[finite] = np.linalg.norm(points[finite] - np.median(points[finite], axis=0), axis=1)
    last = np.sort(distance)[-int(FEW * finite.sum()) - 1 :]
    gaps = np.flatnonzero(last[1:] > FAR * last[:-1])
    if len(gaps) and last[gaps[0]] > 0:
        far = distance > last[gaps[0]]
    return far


def lost_parts(mesh: Mesh) -> Any:
    """Which faces belong to parts of next to no area without which the mesh is much smaller; None if there are none."""
    if mesh.info.components - mesh.info.left_out_components < 2:
        return None
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    part = np.unique(np.asarray(mesh.components), return_inverse=True)[1].reshape(-1)
    corner = points[faces]
    area = np.bincount(part, np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1))
    small = area < LITTLE * area.sum()
    if not small.any() or area[small].sum() > LITTLE * area.sum():
        return None
    kept = corner[~small[part]].reshape(-1, 3)
    low, high = kept.min(axis=0), kept.max(axis=0)
    size = float(np.linalg.norm(high - low))
    beyond = np.linalg.norm(np.maximum(np.maximum(low - corner, corner - high), 0).max(axis=1), axis=1)
    nearest = np.full(len(area), np.inf)
    np.minimum.at(nearest, part, beyond)
    lost = small & (nearest > (FAR - 1) * size)
    return lost[part] if lost.any() else None
