# SPDX-License-Identifier: MIT
"""Finer meshes of coarse ones: Loop's subdivision through the vertices that are given.

[Loop] C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; [Hoppe] H. Hoppe et al., "Piecewise Smooth
Surface Reconstruction", SIGGRAPH 1994, for borders, creases and corners; [Cheng] F. Cheng et al., "Loop Subdivision
Surface Based Progressive Interpolation", JCST 24(1), 2009, for going through the vertices.
"""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Optional, Tuple

import numpy as np

from ._shape import Floats, Integers, Shape, ShapeError

MOST_FACES = 4_000_000
_CORNER = np.cos(np.radians(60.0))  # of a border or crease that turns by more: it stays where it is
_NARROW = 0.25  # share of the area of a flat face: one beside it that has no more is a bevel
_BEVELLED = np.radians(15.0)  # by which edges of bevels bend at least
_FLAT = np.radians(2.0)  # triangles that bend by less to each other are one flat face
_CORRECTIONS = 4  # of the vertices: what is left is some hundredth of what plain subdivision moves them by


def subdivide(shape: Shape, rounds: int = 1, crease_angle: float = 60.0) -> Shape:
    """A mesh with four times as many faces after each round, round where the given one is coarse.

    Parameters
    ----------
    shape : Shape
        With faces, whose vertices are joined; those at one place that are not joined come apart. Normals are left out.
    rounds : int
        0 .. 6.
    crease_angle : float
        Degrees: edges between faces that meet at more stay sharp, as borders do, and edges of more than two faces. So
        do those that the shape says are sharp, and then also parts that are bevelled: of which most of the others lie
        between flat faces and narrow ones.

    Returns
    -------
    Shape
        The given vertices come first, nearly where they were.

    Raises
    ------
    ShapeError
        Without faces, or with more than 4 000 000 after the last round.
    """
    if not shape.is_mesh:
        raise ShapeError("there are no faces to subdivide")
    if not 0 <= rounds <= 6:
        raise ValueError(f"rounds is {rounds}; it must be from 0 to 6")
    assert shape.triangles is not None
    if len(shape.triangles) * 4**rounds > MOST_FACES:
        raise ShapeError(
            f"{len(shape.triangles)} faces are {len(shape.triangles) * 4**rounds} after {rounds} rounds of subdivision, "
            f"and {MOST_FACES} are the most: subdivide fewer times"
        )
    edges = _Edges(np.asarray(shape.triangles, dtype=np.int64))
    steps, sharp = _steps(shape.points, edges, _sharp(shape, edges, crease_angle), rounds)
    control = shape.points
    for _ in range(_CORRECTIONS if steps else 0):
        control = control + shape.points - _refined(control, steps)[: len(control)]
    triangles = steps[-1].triangles if steps else shape.triangles
    kept = None if shape.sharp_edges is None else sharp
    return replace(shape, points=_refined(control, steps), triangles=triangles, normals=None, sharp_edges=kept)


def subdivide_round(shape: Shape, rounds: int, crease_angle: float, tolerance: float) -> Tuple[Shape, Integers]:
    """The same of the parts that are coarse: of which a smooth edge bulges by more than a share of the diagonal. And of
    which given face each one is."""
    assert shape.triangles is not None
    triangles = np.asarray(shape.triangles, dtype=np.int64)
    edges = _Edges(triangles)
    part = _joined(len(triangles), *edges.both_faces())
    one, _ = edges.both_faces()
    coarse = np.isin(part, part[one[_bulge(shape, edges) > tolerance]])
    if not coarse.any():
        return shape, np.arange(len(triangles))
    fine = subdivide(replace(shape, triangles=triangles[coarse]), rounds, crease_angle)
    assert fine.triangles is not None
    of = np.concatenate([np.flatnonzero(~coarse), _parents(np.flatnonzero(coarse), fine)])
    return replace(fine, triangles=np.concatenate([triangles[~coarse], fine.triangles])), of


def _parents(faces: Integers, finer: Shape) -> Integers:
    """Of which face each one of a finer mesh is: a round puts the four parts of all faces one after another."""
    assert finer.triangles is not None
    return np.resize(faces, len(finer.triangles))


def coarseness(shape: Shape, percent: float = 90.0) -> float:
    """How far faces are off something round, as a share of the diagonal: for nine tenths of the edges at most this.

    What the shape says is sharp is none of it.
    Two faces whose normals are an angle apart bulge by its product with what they measure across their edge over eight.
    Of a bevel beside a flat face that is the bevel's width, however long it is, and what is equilateral measures an edge.
    """
    assert shape.triangles is not None
    edges = _Edges(np.asarray(shape.triangles, dtype=np.int64))
    bulge = _bulge(shape, edges)
    bulge = bulge[~_sharp(shape, edges, 180.0)[edges.plain]]
    return float(np.percentile(bulge, percent)) if len(bulge) else 0.0


def raised(shape: Shape, finer: Shape, of: Optional[Integers] = None) -> Floats:
    """How far `subdivide` has moved each place out of the planes of the faces that it is of, as a share of the diagonal.
    `of` is as `subdivide_round` has it."""
    assert shape.triangles is not None and finer.triangles is not None
    corner = shape.points[np.asarray(shape.triangles)]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    of = _parents(np.arange(len(corner)), finer) if of is None else of
    least = np.full(len(finer.points), np.inf)
    for place in np.asarray(finer.triangles).T:
        np.minimum.at(least, place, np.abs(((finer.points[place] - corner[of, 0]) * normal[of]).sum(axis=1)))
    diagonal = _diagonal(shape.points)
    rise: Floats = least[np.isfinite(least)] / max(diagonal, 1e-300)
    return rise


def mean_edge(shape: Shape) -> float:
    """As a share of the diagonal."""
    assert shape.triangles is not None
    corner = shape.points[shape.triangles]
    diagonal = _diagonal(shape.points)
    length = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).mean()
    return float(length) / diagonal if diagonal > 0 else 0.0


class _Edges:
    """The edges of triangles; `of_side` says which one each side of a face is, the sides 0-1 of all faces first."""

    def __init__(self, triangles: Integers) -> None:
        self.triangles = triangles
        sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        self.opposite = np.concatenate([triangles[:, 2], triangles[:, 0], triangles[:, 1]])
        low, high = sides.min(axis=1), sides.max(axis=1)
        size = int(triangles.max()) + 1
        names, self.of_side, self.faces = np.unique(low * size + high, return_inverse=True, return_counts=True)
        self.ends: Integers = np.column_stack([names // size, names % size])
        self.plain = self.faces == 2

    def both_faces(self) -> Tuple[Integers, Integers]:
        """Of each plain edge."""
        order = np.argsort(self.of_side, kind="stable")
        first = np.searchsorted(self.of_side[order], np.flatnonzero(self.plain))
        count = len(self.triangles)
        return order[first] % count, order[first + 1] % count


def _diagonal(points: Floats) -> float:
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def _across(points: Floats, edges: _Edges) -> Tuple[Floats, Floats]:
    """What both faces at each plain edge measure across it, shape (2, n); what is equilateral measures an edge. And the
    areas of all faces."""
    corner = points[edges.triangles]
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1) / 2
    length = np.linalg.norm(points[edges.ends[:, 0]] - points[edges.ends[:, 1]], axis=1)[edges.plain]
    one, other = edges.both_faces()
    across: Floats = 4 / np.sqrt(3) * np.stack([area[one], area[other]]) / np.maximum(length, 1e-300)
    return across, area


def _bulge(shape: Shape, edges: _Edges) -> Floats:
    """Of each plain edge, as a share of the diagonal; 0 of sharp ones."""
    diagonal = _diagonal(shape.points)
    if not diagonal > 0:
        return np.zeros(int(edges.plain.sum()))
    across = _across(shape.points, edges)[0].min(axis=0)
    smooth = ~_sharp(shape, edges, 180.0)[edges.plain]
    bulge: Floats = np.where(smooth, _angles(shape.points, edges) * across / (8 * diagonal), 0.0)
    return bulge


def _of_bevelled_parts(points: Floats, edges: _Edges, angle: Floats, smooth: Any) -> Any:
    """Whether a plain edge is of a part of which most smooth edges lie between a flat face and a narrow one beside it."""
    _, area = _across(points, edges)
    one, other = edges.both_faces()
    face = _joined(len(area), one[angle < _FLAT], other[angle < _FLAT])
    area = np.bincount(face, area, len(area))[face]
    narrow = np.minimum(area[one], area[other]) <= _NARROW * np.maximum(area[one], area[other])
    part = _joined(len(area), one, other)[one]
    length = np.linalg.norm(points[edges.ends[:, 0]] - points[edges.ends[:, 1]], axis=1)[edges.plain]
    bends = smooth & (angle > _BEVELLED)
    of_bevels, of_all = (np.bincount(part[some], length[some], len(area)) for some in (bends & narrow, bends))
    return bends & (2 * of_bevels > of_all)[part]


def _joined(count: int, one: Integers, other: Integers) -> Integers:
    """Of each triangle the least number of those that it is joined to."""
    least = np.arange(count)
    while True:
        before = least.copy()
        low = np.minimum(least[one], least[other])
        np.minimum.at(least, least[one], low)
        np.minimum.at(least, least[other], low)
        least = least[least]
        if (least == before).all():
            return least


def _angles(points: Floats, edges: _Edges) -> Floats:
    """Radians between the faces at each plain edge."""
    corner = points[edges.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    one, other = edges.both_faces()
    angles: Floats = np.arccos(np.clip((normal[one] * normal[other]).sum(axis=1), -1.0, 1.0))
    return angles


@dataclass(frozen=True)
class _Step:
    """One round: the edges before it, which of them are sharp, which vertices lie on sharp lines or stay; the faces."""

    edges: _Edges
    sharp: Any
    on_line: Any
    stays: Any
    triangles: Integers


def _sharp(shape: Shape, edges: _Edges, crease_angle: float) -> Any:
    sharp = ~edges.plain
    angle = _angles(shape.points, edges)
    sharp[edges.plain] = angle > np.radians(crease_angle)
    if shape.sharp_edges is not None:
        size = len(shape.points)
        given = np.sort(shape.sharp_edges, axis=1)
        sharp |= np.isin(edges.ends[:, 0] * size + edges.ends[:, 1], given[:, 0] * size + given[:, 1])
        sharp[edges.plain] |= _of_bevelled_parts(shape.points, edges, angle, ~sharp[edges.plain])
    return sharp


def _steps(points: Floats, edges: _Edges, sharp: Any, rounds: int) -> Tuple[List[_Step], Integers]:
    """And the ends of what is sharp after the last."""
    lines = np.bincount(edges.ends[sharp].ravel(), minlength=len(points))
    stays = (lines == 1) | (lines > 2) | _turns(points, edges.ends[sharp], lines)
    steps: List[_Step] = []
    for _ in range(rounds):
        count = len(lines)
        a, b, c = (count + part for part in np.split(edges.of_side, 3))
        p, q, r = edges.triangles.T
        finer = np.concatenate([np.c_[p, a, c], np.c_[q, b, a], np.c_[r, c, b], np.c_[a, b, c]])
        steps.append(_Step(edges, sharp, lines == 2, stays, finer))
        middles = count + np.flatnonzero(sharp)
        halves = np.concatenate([np.c_[edges.ends[sharp][:, end], middles] for end in (0, 1)])
        edges = _Edges(finer)
        size = count + len(sharp)
        sharp = np.isin(edges.ends[:, 0] * size + edges.ends[:, 1], halves[:, 0] * size + halves[:, 1])
        lines = np.bincount(edges.ends[sharp].ravel(), minlength=size)
        stays = np.concatenate([stays, np.zeros(size - count, dtype=bool)])
    return steps, edges.ends[sharp]


def _turns(points: Floats, sharp: Integers, lines: Any) -> Any:
    """Vertices in which a sharp line turns a corner."""
    way = np.zeros_like(points)
    unit = points[sharp[:, 1]] - points[sharp[:, 0]]
    unit = unit / np.maximum(np.linalg.norm(unit, axis=1, keepdims=True), 1e-300)
    np.add.at(way, sharp[:, 0], unit)
    np.add.at(way, sharp[:, 1], -unit)
    # Two units a and b away from it: |a + b|^2 = 2 + 2 a . b, and straight on a . b = -1.
    return (lines == 2) & ((way**2).sum(axis=1) > 2 - 2 * _CORNER)


def _refined(points: Floats, steps: List[_Step]) -> Floats:
    for step in steps:
        points = _refine(points, step)
    return points


def _refine(points: Floats, step: _Step) -> Floats:
    edges, ends = step.edges, step.edges.ends
    middle = 0.5 * (points[ends[:, 0]] + points[ends[:, 1]])
    beside = np.zeros_like(middle)
    np.add.at(beside, edges.of_side, points[edges.opposite])
    middle = np.where(step.sharp[:, None], middle, 0.75 * middle + 0.125 * beside)
    count = len(points)
    valence = np.bincount(ends.ravel(), minlength=count)
    share = (5 / 8 - (3 / 8 + np.cos(2 * np.pi / np.maximum(valence, 3)) / 4) ** 2)[:, None]
    smooth = (1 - share) * points + share * _around(points, ends) / np.maximum(valence, 1)[:, None]
    on_line = 0.75 * points + 0.125 * _around(points, ends[step.sharp])
    moved = np.where(step.on_line[:, None], on_line, smooth)
    keeps = step.stays | (valence == 0)
    return np.concatenate([np.where(keeps[:, None], points, moved), middle])


def _around(points: Floats, ends: Integers) -> Floats:
    """The sums of what lies at the other ends."""
    sums = np.zeros_like(points)
    np.add.at(sums, ends[:, 0], points[ends[:, 1]])
    np.add.at(sums, ends[:, 1], points[ends[:, 0]])
    return sums
