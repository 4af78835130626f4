# SPDX-License-Identifier: MIT
"""Reads Gaussian cubes, grids of the values of a molecule, and makes surfaces of equal values by marching tetrahedra."""
from __future__ import annotations

import itertools
import re
from typing import List, Tuple

import numpy as np

from ._shape import Floats, Integers, Shape, ShapeError
from ._table import at

_MOST = 1 << 26  # largest number of values
_ENCLOSED, _OF_SQUARES = 0.95, 0.9  # shares of the sum of the values, or of their squares, within the surface
_SIGNED = 0.05  # values whose least is below this share of the greatest, turned over, have both signs
# The tetrahedra of a cell: one for each way along its edges from corner (0, 0, 0) to corner (1, 1, 1).
_CORNERS = np.array(list(itertools.product((0, 1), repeat=3)))
_TETRAHEDRA = np.array([
    [0, 4 >> a, (4 >> a) + (4 >> b), 7] for a, b, _ in itertools.permutations(range(3))
])  # fmt: skip
_HEAD = re.compile(r"\s*-?\d+(?:\s+[-+\d.eEdD]+){3}")


def read_cube(data: bytes) -> Shape:
    """Read a cube: the surface around most of a density, or around both signs of an orbital.  Lengths are as in the file."""
    lines = data.decode("latin-1").splitlines()
    if len(lines) < 6 or not _HEAD.match(lines[2]):
        raise ShapeError("not a Gaussian cube: line 3 must hold the number of atoms and the place of the grid")
    rows = [_numbers(lines, i, 4) for i in range(2, 6)]
    atoms, counts = int(rows[0][0]), [abs(int(row[0])) for row in rows[1:]]
    origin, axes = np.array(rows[0][1:4]), np.array([row[1:4] for row in rows[1:]])
    of_each = int(rows[0][4]) if len(rows[0]) > 4 and rows[0][4] >= 1 else 1
    if min(counts) < 2 or counts[0] * counts[1] * counts[2] * of_each > _MOST:
        raise ShapeError(f"the grid of the cube has {' x '.join(map(str, counts))} values: it is damaged, or too large")
    first, notes = 6 + abs(atoms), []
    if atoms < 0:  # a line with the number of orbitals, and their numbers
        of_each = max(int(_numbers(lines, first, 1)[0]), 1)
        skip = of_each + 1
        while skip > 0 and first < len(lines):
            skip -= len(lines[first].split())
            first += 1
    if of_each > 1:
        notes.append(f"the first of {of_each} sets of values is drawn")
    try:
        values = np.array(" ".join(lines[first:]).replace("D", "E").replace("d", "e").split(), dtype=np.float64)
    except ValueError:
        raise ShapeError(f"a value of the cube after line {first} is not a number") from None
    size = counts[0] * counts[1] * counts[2]
    if len(values) < size * of_each or of_each > 1000:
        raise ShapeError(f"the cube is cut short: it has {len(values)} of {size * of_each} values")
    grid = np.nan_to_num(values[: size * of_each : of_each].reshape(counts), nan=0.0, posinf=0.0, neginf=0.0)
    levels = _levels(grid)
    made = [isosurface(grid, level) for level in levels]
    points = np.concatenate([part for part, _ in made])
    start = np.cumsum([0] + [len(part) for part, _ in made])
    triangles = np.concatenate([faces + at_ for (_, faces), at_ in zip(made, start)])
    if not len(triangles):
        raise ShapeError("all values of the cube are the same: there is no surface")
    share, of = (_OF_SQUARES, "squares of the values") if len(levels) > 1 else (_ENCLOSED, "values")
    level = f"{'+-' if len(levels) > 1 else ''}{abs(levels[0]):.3g}"
    notes.insert(0, f"the surface of the value {level}, which encloses {share:.0%} of the sum of the {of}")
    if np.linalg.det(axes) < 0.0:
        triangles = triangles[:, ::-1]
    unit = "angstroms" if rows[1][0] < 0 else "bohr"
    return Shape(origin + points @ axes, None, triangles, "Gaussian cube", ("x", "y", "z"), notes=tuple(notes), unit=unit)


def _numbers(lines: List[str], number: int, least: int) -> List[float]:
    words = lines[number].replace("D", "E").split() if number < len(lines) else []
    try:
        found = [float(word) for word in words]
    except ValueError:
        found = []
    if len(found) < least or not np.isfinite(found).all() or max(map(abs, found)) > 1e9:
        raise at(number + 1, 0, f"the head of the cube has {least} numbers here")
    return found


def _levels(grid: Floats) -> Tuple[float, ...]:
    """The values of the surface: one, or two for values of both signs."""
    signed = float(grid.min()) < -_SIGNED * float(grid.max())
    size = np.sort(np.abs(grid if signed else np.maximum(grid, 0.0)).reshape(-1))[::-1]
    sums = np.cumsum(size**2 if signed else size)
    if not sums[-1] > 0.0:
        raise ShapeError("all values of the cube are 0: there is no surface")
    level = float(size[int(np.searchsorted(sums, (_OF_SQUARES if signed else _ENCLOSED) * sums[-1]))])
    return (level, -level) if signed else (level,)


def isosurface(grid: Floats, level: float) -> Tuple[Floats, Integers]:
    """The surface of a value in a grid, as points in units of cells, and triangles.

    Its front looks away from values that are beyond the level, as seen from 0.  [Doi and Koide, 1991]
    """
    inside = grid > level if level >= 0.0 else grid < level
    shape = np.array(grid.shape)
    one = np.array([shape[1] * shape[2], shape[2], 1])
    corner = _CORNERS @ one
    some = sum(inside[tuple(slice(c, s - 1 + c) for c, s in zip(at_, shape))].astype(np.int8) for at_ in _CORNERS)
    cells = np.argwhere((some > 0) & (some < 8)) @ one
    tetra: Integers = (cells[:, None, None] + corner[_TETRAHEDRA]).reshape(-1, 4)
    is_in = inside.reshape(-1)[tetra]
    count = is_in.sum(axis=1)
    pieces = []
    for number in (1, 2, 3):
        these, within = tetra[count == number], is_in[count == number]
        order = np.argsort(~within, axis=1, kind="stable")
        t = np.take_along_axis(these, order, axis=1)  # the corners inside first
        if number == 1:
            pieces += [[(t[:, 0], t[:, 1]), (t[:, 0], t[:, 2]), (t[:, 0], t[:, 3])]]
        elif number == 3:
            pieces += [[(t[:, 0], t[:, 3]), (t[:, 1], t[:, 3]), (t[:, 2], t[:, 3])]]
        else:
            a, b, c, d = ((t[:, i], t[:, j]) for i, j in ((0, 2), (0, 3), (1, 3), (1, 2)))
            pieces += [[a, b, c], [a, c, d]]
    ends = np.concatenate([np.stack([np.stack(edge, axis=1) for edge in piece], axis=1) for piece in pieces])
    if not len(ends):
        return np.empty((0, 3)), np.empty((0, 3), np.int64)
    low, high = ends.min(axis=2), ends.max(axis=2)
    key, faces = np.unique(low.reshape(-1) * grid.size + high.reshape(-1), return_inverse=True)
    begin, end = key // grid.size, key % grid.size
    flat = grid.reshape(-1)
    share = np.clip((level - flat[begin]) / (flat[end] - flat[begin]), 0.01, 0.99)[:, None]
    place = lambda number: np.column_stack(np.unravel_index(number, grid.shape)).astype(np.float64)  # noqa: E731
    points: Floats = place(begin) * (1.0 - share) + place(end) * share
    triangles: Integers = faces.reshape(-1, 3)
    within = place(ends[:, :, 0].reshape(-1)).reshape(-1, 3, 3).mean(axis=1)  # corners inside, of each triangle
    outward = points[triangles].mean(axis=1) - within
    p = points[triangles]
    turned = (np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) * outward).sum(axis=1) < 0.0
    triangles[turned] = triangles[turned][:, ::-1]
    return points, triangles
