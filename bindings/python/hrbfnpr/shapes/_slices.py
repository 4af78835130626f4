# SPDX-License-Identifier: MIT
"""Makes a closed mesh of a stack of slices, each of which has closed polygons."""
from __future__ import annotations

from typing import Any, List, NamedTuple, Tuple

import numpy as np

from ._shape import Floats, Integers, ShapeError

_CELLS = 80  # number of cells along the longest side.  Larger: finer and slower.
_LINES = 3  # number of lines along x on which each row of cells is measured
_MARGIN = 2  # number of empty cells around the solid


class Slice(NamedTuple):
    """The upper end of a slice, and the corners of its polygons in order.  Polygons that turn the other way are holes."""

    top: float
    polygons: List[Floats]


def stacked(bottom: float, slices: List[Slice]) -> Tuple[Floats, Integers, float]:
    """The corners and triangles of the solid that slices make, and the side of the cells in which it is measured.

    Each cell gets the share that is inside.  The mesh is where this is one half [Gibson 1998, surface nets].
    """
    corners = np.concatenate([np.empty((0, 2)), *(polygon for one in slices for polygon in one.polygons)])
    tops = np.array([one.top for one in slices])
    if len(corners) == 0 or not np.isfinite(corners).all() or not np.isfinite([bottom, *tops]).all():
        raise ShapeError("its slices have no polygons, or corners that are not finite")
    if not (np.diff(tops, prepend=bottom) > 0).all():
        raise ShapeError("its slices do not rise")
    low, high = np.array([*corners.min(axis=0), bottom]), np.array([*corners.max(axis=0), tops[-1]])
    side = float((high - low).max()) / _CELLS
    if not 0 < side < np.inf or not (high > low).all():
        raise ShapeError("its slices enclose nothing")
    counts = np.ceil((high - low) / side).astype(int) + 2 * _MARGIN
    origin = (low + high) / 2 - side * counts / 2
    filled = np.zeros(counts[::-1])
    middles = origin[2] + side * (np.arange(counts[2]) + 0.5)
    which = np.where((middles > bottom) & (middles < tops[-1]), np.searchsorted(tops, middles), -1)
    for number in np.unique(which[which >= 0]):
        filled[which == number] = _covered(slices[number].polygons, origin, side, counts)
    points, triangles = _surface(filled)
    if len(triangles) == 0:
        raise ShapeError("its slices enclose nothing")
    return origin + side * (points + 0.5), triangles, side


def _covered(polygons: List[Floats], origin: Floats, side: float, counts: Any) -> Floats:
    """The share of each cell of a level that is inside polygons."""
    start = np.concatenate([np.empty((0, 2)), *polygons])
    end = np.concatenate([np.empty((0, 2)), *(np.roll(polygon, -1, axis=0) for polygon in polygons)])
    lines = origin[1] + side * (np.arange(counts[1] * _LINES) + 0.5) / _LINES
    edge, line = np.nonzero((start[:, 1:] <= lines) != (end[:, 1:] <= lines))
    a, b = start[edge], end[edge]
    x = a[:, 0] + (lines[line] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    place = (x - origin[0]) / side
    cell = np.floor(place).astype(int)
    way = np.where(b[:, 1] > a[:, 1], 1.0, -1.0)
    wound = np.zeros((len(lines), counts[0] + 1))  # how often the polygons wind around a cell, as steps along the line
    np.add.at(wound, (line, cell), way * (cell + 1 - place))
    np.add.at(wound, (line, cell + 1), way * (place - cell))
    inside = np.clip(np.abs(np.cumsum(wound, axis=1)[:, :-1]), 0.0, 1.0)
    covered: Floats = inside.reshape(counts[1], _LINES, counts[0]).mean(axis=1)
    return covered


def _surface(filled: Floats) -> Tuple[Floats, Integers]:
    """The surface at one half between the samples of a grid [z, y, x], with places in x, y, z in units of the grid."""
    inside = filled > 0.5
    shape = tuple(count - 1 for count in filled.shape)
    eighths = [tuple(slice(k, k + n) for k, n in zip(corner, shape)) for corner in np.ndindex(2, 2, 2)]
    known = np.sum([inside[part] for part in eighths], axis=0)
    mixed = (known > 0) & (known < 8)
    number = np.cumsum(mixed.ravel()).reshape(shape) - 1
    place, count = np.zeros((int(mixed.sum()), 3)), np.zeros(int(mixed.sum()))
    quads: List[Any] = []
    for axis in range(3):
        others = [other for other in range(3) if other != axis]
        for shift in np.ndindex(2, 2):
            first = [0, 0, 0]
            first[others[0]], first[others[1]] = shift
            second = list(first)
            second[axis] = 1
            a, b = (filled[tuple(slice(k, k + n) for k, n in zip(corner, shape))][mixed] for corner in (first, second))
            crossed = (a > 0.5) != (b > 0.5)
            at = np.array(first, dtype=float)[None].repeat(int(crossed.sum()), 0)
            at[:, axis] = (0.5 - a[crossed]) / (b[crossed] - a[crossed])
            place[crossed] += at
            count[crossed] += 1
        here = [slice(1, -1)] * 3
        here[axis] = slice(0, -1)
        following = list(here)
        following[axis] = slice(1, None)
        edge = np.argwhere(inside[tuple(here)] != inside[tuple(following)]) + [0 if k == axis else 1 for k in range(3)]
        around = []
        for shift in ((1, 1), (0, 1), (0, 0), (1, 0)):
            cube = edge.copy()
            cube[:, others[0]] -= shift[0]
            cube[:, others[1]] -= shift[1]
            around.append(number[tuple(cube.T)])
        quad = np.column_stack(around)
        turned = inside[tuple(edge.T)] != (axis == 1)
        quad[turned] = quad[turned][:, ::-1]
        quads.append(quad)
    corners = np.concatenate(quads)
    points = (np.argwhere(mixed) + place / count[:, None])[:, ::-1]
    return points, np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]]).astype(np.int64)
