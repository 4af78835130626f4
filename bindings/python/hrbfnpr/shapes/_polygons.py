# SPDX-License-Identifier: MIT
"""Cuts polygons into triangles: fans, or ears for polygons that are not convex.  Bent quads are cut for the least area."""
from __future__ import annotations

from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

import numpy as np

from ._shape import Floats, Integers, ShapeError

TURNED = 1e-9  # a fan is not used if one of its triangles faces the other way by more than this share of the polygon's area
LESS = 1e-6  # the other diagonal cuts a quad if it saves more than this share of the area; larger: more quads keep their fan
MOST_CORNERS = 4096  # polygons with more corners keep their fan


def fans(polygons: Iterable[Sequence[int]], points: Optional[Floats] = None) -> Integers:
    """Triangles of polygons, by the numbers of their corners.  Polygons with fewer than three corners are left out."""
    given = [polygon for polygon in polygons if len(polygon) >= 3]
    by_size: Dict[int, List[int]] = {}
    for number, polygon in enumerate(given):
        by_size.setdefault(len(polygon), []).append(number)
    made: List[Any] = [None] * len(given)
    for some in by_size.values():
        for number, triangles in zip(some, fans_of_block([given[number] for number in some], points)):
            made[number] = triangles
    joined: Integers = np.concatenate(made).astype(np.int64) if made else np.empty((0, 3), dtype=np.int64)
    return joined


def fans_of_row(row: Any, points: Optional[Floats] = None) -> Integers:
    """Triangles of polygons in a row of integers, in which each is its number of corners and then its corners, as in VTK."""
    row = np.asarray(row)
    step = int(row[0]) + 1 if len(row) else 0
    if step > 3 and len(row) % step == 0 and (row[::step] == row[0]).all():
        return fans_of_block(row.reshape(-1, step)[:, 1:], points).reshape(-1, 3)
    polygons, at = [], 0
    while at < len(row):
        count = int(row[at])
        if count < 0 or at + 1 + count > len(row):
            raise ShapeError(f"faces must be lists of a count and then its corners, not {count} at {at}")
        polygons.append(row[at + 1 : at + 1 + count].tolist())
        at += 1 + count
    return fans(polygons, points)


def fans_of_block(corners: Any, points: Optional[Floats] = None) -> Integers:
    """Triangles of n polygons with k corners each, shape (n, k - 2, 3).

    With `points`, each fan starts at the corner of the least x, then y, then z, so that two cells of a solid cut the face
    between them alike.  Quads are cut along the other diagonal if that gives less area.  Polygons that a fan would not cover
    are cut by ears in their best plane [Meisters, "Polygons have ears", 1975].  A polygon that crosses itself keeps its fan.
    """
    corners = np.asarray(corners, dtype=np.int64)
    size = corners.shape[1]
    if size < 3:
        return np.empty((len(corners), 0, 3), dtype=np.int64)
    if points is not None and size > 3:
        corners = _from_the_least(corners, points)
    made: Integers = np.stack([corners[:, [0, i, i + 1]] for i in range(1, size - 1)], axis=1)
    if points is None or size == 3 or size > MOST_CORNERS:
        return made
    if size == 4:
        _cut_along_other_diagonals(made, corners, points)
        return made
    for number in _not_covered(corners, points):
        ears = _ears(points[corners[number]])
        if ears is not None:
            made[number] = corners[number][ears]
    return made


def _from_the_least(corners: Integers, points: Floats) -> Integers:
    """The same polygons, each from its corner of the least x; if several have it, the least y, then the least z."""
    place = points[np.clip(corners, 0, len(points) - 1)]  # invalid corners are reported later
    least = np.ones(corners.shape, dtype=bool)
    for axis in range(3):
        value = np.where(least, place[:, :, axis], np.inf)
        least &= value == value.min(axis=1, keepdims=True)
    turned = (np.argmax(least, axis=1)[:, None] + np.arange(corners.shape[1])) % corners.shape[1]
    return np.take_along_axis(corners, turned, axis=1)


def _not_covered(corners: Integers, points: Floats) -> Integers:
    """The numbers of polygons in whose fan a triangle faces the other way."""
    usable = _usable(corners, points)
    place = points[corners[usable]]
    spokes = place[:, 1:] - place[:, :1]
    fan = np.cross(spokes[:, :-1], spokes[:, 1:])
    whole = fan.sum(axis=1)
    along = np.einsum("nij,nj->ni", fan, whole)
    with np.errstate(invalid="ignore"):
        other_way: Integers = usable[(along < -TURNED * np.einsum("nj,nj->n", whole, whole)[:, None]).any(axis=1)]
    return other_way


def _usable(corners: Integers, points: Floats) -> Any:
    """The numbers of polygons whose corners all exist."""
    return np.flatnonzero(((corners >= 0) & (corners < len(points))).all(axis=1))


def _cut_along_other_diagonals(made: Integers, corners: Integers, points: Floats) -> None:
    """Cut those quads along their other diagonals whose triangles face opposite ways, or whose area becomes less."""
    usable = _usable(corners, points)
    a, b, c, d = corners[usable].T
    other = np.stack([np.stack([a, b, d], axis=1), np.stack([b, c, d], axis=1)], axis=1)
    with np.errstate(invalid="ignore"):
        (covers, size), (other_covers, other_size) = (_cover(points[pairs]) for pairs in (made[usable], other))
        better = other_covers & (~covers | (other_size < (1 - LESS) * size))
    made[usable[better]] = other[better]


def _cover(place: Floats) -> Tuple[Any, Any]:
    """Whether two triangles of each quad face the same way as both together, and their area."""
    doubled = np.cross(place[:, :, 1] - place[:, :, 0], place[:, :, 2] - place[:, :, 0])
    same_way = (np.einsum("nij,nj->ni", doubled, doubled.sum(axis=1)) > 0).all(axis=1)
    return same_way, np.linalg.norm(doubled, axis=2).sum(axis=1)


def _ears(place: Floats) -> Optional[Integers]:
    """The triangles of a polygon, by numbers of its corners; None if no ear is found, as when it crosses itself."""
    flat = _in_plane(place)
    left, triangles, at = list(range(len(place))), [], 0
    while len(left) > 3:
        for step in range(len(left)):
            i = (at + step) % len(left)
            ear = (left[i - 1], left[i], left[(i + 1) % len(left)])
            if _is_ear(flat, left, ear):
                break
        else:
            return None
        triangles.append(ear)
        del left[i]
        at = i % len(left)  # go on beside this ear, which avoids slivers around one corner
    triangles.append((left[0], left[1], left[2]))
    return np.array(triangles)


def _in_plane(place: Floats) -> Floats:
    """The polygon in its best plane, counter-clockwise as seen from where its normal points.

    Each corner moves along the normal to the plane.  Then the axis nearest to the normal is left out, which keeps the
    coordinates of flat polygons exact.
    """
    spokes = place - place[0]
    normal = np.cross(spokes[1:-1], spokes[2:]).sum(axis=0)
    axis = int(np.abs(normal).argmax())
    kept = [(axis + 1) % 3, (axis + 2) % 3]
    height = spokes @ normal / max(float(normal @ normal), 1e-300)
    flat: Floats = (place - height[:, None] * normal)[:, kept if normal[axis] > 0 else kept[::-1]]
    return flat


def _is_ear(flat: Floats, left: List[int], ear: Sequence[int]) -> bool:
    a, b, c = (flat[i] for i in ear)
    if _turn(a, b, c) <= 0:
        return False
    others = flat[[i for i in left if i not in ear]]
    inside = (_turn(a, b, others) >= 0) & (_turn(b, c, others) >= 0) & (_turn(c, a, others) >= 0)
    if not inside.any():
        return True
    # A corner at the place of one of the ear's corners does not block it; a slit that leads to a hole has such corners.
    same = [(others[inside] == one).all(axis=1) for one in (a, b, c)]
    return bool(np.logical_or.reduce(same).all())


def _turn(a: Any, b: Any, c: Any) -> Any:
    """Twice the area of a triangle; above 0 if it runs counter-clockwise.  `c` may be many points."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])
