# SPDX-License-Identifier: MIT
"""Well-spread samples with normals of meshes and point sets."""
from __future__ import annotations

import math
from typing import Any, Callable, Optional, Tuple

import numpy as np

from ._shape import Floats, Integers, Shape, ShapeError

CANDIDATES = 40  # random candidates for each sample that is chosen
Report = Callable[[float], Any]


def farthest_points(points: Floats, count: int, report: Optional[Report] = None) -> Integers:
    """Indices of `count` points, each as far as can be from those before it.

    Starts with the point farthest from the centre, so that the choice depends on the points alone.
    """
    columns = [np.ascontiguousarray(points[:, axis]) for axis in range(3)]

    def squared_distance(place: Any) -> Any:
        return sum((column - x) ** 2 for column, x in zip(columns, place))

    chosen = np.empty(min(count, len(points)), dtype=np.int64)
    nearest = np.full(len(points), math.inf)
    place = int(np.argmax(squared_distance(points.mean(axis=0))))
    for i in range(len(chosen)):
        chosen[i] = place
        np.minimum(nearest, squared_distance(points[place]), out=nearest)
        place = int(np.argmax(nearest))
        if report is not None and i % 16 == 0:
            report(i / len(chosen))
    if report is not None:
        report(1.0)
    return chosen


def samples(
    shape: Shape,
    count: Optional[int] = None,
    *,
    crease: float = 60.0,
    flip: bool = False,
    random_seed: int = 1,
    report: Optional[Report] = None,
) -> Tuple[Floats, Floats]:
    """Points and unit normals of a shape, ready for `Model.fit`.

    Parameters
    ----------
    shape : Shape
        A mesh is sampled evenly over its area; of a point set with normals, points are chosen.
        Points that are not finite, or whose normal is zero, are left out.
    count : int, optional
        How many; 1000 by default for a mesh, all for a point set.
    crease : float
        Degrees: faces of a mesh that meet at a sharper angle do not share their normals.
    flip : bool
        Turn all normals.  A closed mesh that is inside out is turned anyhow.
    random_seed : int
    report : callable, optional
        Called with a fraction in [0, 1].

    Returns
    -------
    points, normals : arrays of float64, shape (n, 3)
    """
    if count is not None and count < 1:
        raise ShapeError(f"the number of samples must be at least 1, not {count}")
    random = np.random.default_rng(random_seed)
    if shape.is_mesh:
        wanted = 1000 if count is None else count
        points, normals = _on_mesh(shape, CANDIDATES * wanted, crease, random)
    elif shape.normals is not None:
        points, normals = _usable(shape.points, shape.normals)
        wanted = len(points) if count is None else count
        if CANDIDATES * wanted < len(points):
            chosen = random.choice(len(points), CANDIDATES * wanted, replace=False)
            points, normals = points[chosen], normals[chosen]
    else:
        raise ShapeError("the points have no normals, and there are no faces to compute them from")
    if wanted < len(points):
        chosen = farthest_points(points, wanted, report)
        points, normals = points[chosen], normals[chosen]
    return points, -normals if flip else normals


def _usable(points: Floats, normals: Floats) -> Tuple[Floats, Floats]:
    length = np.linalg.norm(normals, axis=1)
    usable = np.isfinite(points).all(axis=1) & np.isfinite(length) & (length > 0)
    if not usable.any():
        raise ShapeError("no point is finite and has a normal that is not zero")
    return points[usable], normals[usable] / length[usable, None]


def _weld(shape: Shape) -> Tuple[Floats, Integers]:
    """Vertices and triangles with exact repeats joined, degenerate triangles left out."""
    assert shape.triangles is not None
    if not np.isfinite(shape.points[shape.triangles]).all():
        raise ShapeError("a vertex of a face is not finite")
    vertices, inverse = np.unique(shape.points, axis=0, return_inverse=True)
    triangles = inverse.reshape(-1)[shape.triangles]
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    triangles = triangles[area > 0]
    if len(triangles) == 0:
        raise ShapeError("all faces are degenerate")
    return vertices, triangles


def _is_inside_out(vertices: Floats, triangles: Integers) -> bool:
    """Whether it is closed, each edge being run through once in each direction, and of negative volume."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    count = len(vertices)
    forward, backward = edges[:, 0] * count + edges[:, 1], edges[:, 1] * count + edges[:, 0]
    if not np.array_equal(np.sort(forward), np.sort(backward)):
        return False
    a, b, c = (vertices[triangles[:, i]] - vertices.mean(axis=0) for i in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) < 0.0


def _corner_angles(vertices: Floats, triangles: Integers) -> Floats:
    angles = np.empty(triangles.shape)
    for i in range(3):
        at, left, right = (vertices[triangles[:, (i + k) % 3]] for k in range(3))
        u, v = left - at, right - at
        angles[:, i] = np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), np.einsum("ij,ij->i", u, v))
    return angles


def _corner_normals(vertices: Floats, triangles: Integers, faces: Floats, crease: float) -> Floats:
    """Angle-weighted normals for each corner of each triangle, shape (m, 3, 3).

    A corner takes in the faces about its vertex whose normal is within `crease` degrees of its own.
    """
    corners = triangles.reshape(-1)
    face_of = np.repeat(np.arange(len(triangles)), 3)
    weighted = faces[face_of] * _corner_angles(vertices, triangles).reshape(-1, 1)
    order = np.argsort(corners, kind="stable")
    starts = np.searchsorted(corners[order], np.arange(len(vertices) + 1))
    valence = np.diff(starts)
    result = np.zeros((len(corners), 3))
    # Round k adds, to each corner, the k-th corner at its vertex.
    for k in range(int(valence.max())):
        own = np.flatnonzero(valence[corners] > k)
        other = order[starts[corners[own]] + k]
        cosine = np.einsum("ij,ij->i", faces[face_of[own]], faces[face_of[other]])
        joined = cosine >= math.cos(math.radians(crease)) - 1e-12
        result[own[joined]] += weighted[other[joined]]
    return result.reshape(-1, 3, 3)


def _on_mesh(shape: Shape, count: int, crease: float, random: Any) -> Tuple[Floats, Floats]:
    """Random points, even over the area, with interpolated corner normals."""
    vertices, triangles = _weld(shape)
    if _is_inside_out(vertices, triangles):
        triangles = triangles[:, ::-1]
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    cross = np.cross(b - a, c - a)
    doubled_area = np.linalg.norm(cross, axis=1)
    faces = cross / doubled_area[:, None]
    corner_normals = _corner_normals(vertices, triangles, faces, crease)
    cumulative = np.cumsum(doubled_area)
    chosen = np.searchsorted(cumulative, random.random(count) * cumulative[-1], side="right")
    chosen = np.minimum(chosen, len(triangles) - 1)
    root, turn = np.sqrt(random.random(count)), random.random(count)
    weights = np.column_stack([1 - root, root * (1 - turn), root * turn])
    points = np.einsum("ij,ijk->ik", weights, vertices[triangles[chosen]])
    normals = np.einsum("ij,ijk->ik", weights, corner_normals[chosen])
    length = np.linalg.norm(normals, axis=1)
    normals = np.where(length[:, None] > 1e-12, normals, faces[chosen])
    return points, normals / np.linalg.norm(normals, axis=1)[:, None]
