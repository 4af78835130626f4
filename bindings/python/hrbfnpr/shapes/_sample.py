# SPDX-License-Identifier: MIT
"""Chooses well-spread samples with normals from meshes and point sets."""
from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

import numpy as np

import hrbfnpr

from ._shape import Floats, Integers, Shape, ShapeError

CANDIDATES = 40  # number of random candidates for each sample
Report = Callable[[float], Any]


def farthest_points(points: Floats, count: int, report: Optional[Report] = None) -> Integers:
    """Return the numbers of `count` points, each the farthest from those before it, as `hrbfnpr.farthest_points` does.

    The first is the point nearest to the middle of the bounding box, so that the choice depends only on the points.
    """
    count = min(count, len(points))
    if count == 0:
        return np.empty(0, dtype=np.int64)
    numbers: Integers = hrbfnpr.farthest_points(points, count, progress=report)[0]
    return numbers


def samples(
    shape: Shape,
    count: Optional[int] = None,
    *,
    crease: float = 60.0,
    flip: bool = False,
    random_seed: int = 1,
    report: Optional[Report] = None,
) -> Tuple[Floats, Floats]:
    """Choose points and unit normals from a shape, for `Model.fit`.

    Parameters
    ----------
    shape : Shape
        A mesh, or points with normals.  A mesh is sampled evenly over the area of all its parts.  Points that are not
        finite, or whose normal is 0, are left out.
    count : int, optional
        Number of samples; None: 1000 for a mesh, all points for a point set.
    crease : float
        Angle between the normals of two faces, in degrees; faces that meet at a larger angle do not share normals.
    flip : bool
        True: turn all normals.  A closed mesh that is inside out is turned in any case.
    random_seed : int
        Start of the random numbers, for meshes.
    report : callable, optional
        A function that gets the progress, 0 to 1.

    Returns
    -------
    points, normals : arrays of float64, shape (n, 3)
        The samples and their unit normals.
    """
    if count is not None and count < 1:
        raise ShapeError(f"the number of samples must be at least 1, not {count}")
    if shape.is_mesh:
        points, normals = _on_mesh(shape, 1000 if count is None else count, crease, random_seed, report)
        return points, -normals if flip else normals
    if shape.normals is not None:
        points, normals = _usable(shape.points, shape.normals)
        wanted = len(points) if count is None else count
        if CANDIDATES * wanted < len(points):
            random = np.random.default_rng(random_seed)
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
        raise ShapeError("no point has both a finite position and a normal that is not zero")
    return points[usable], normals[usable] / length[usable, None]


def _on_mesh(shape: Shape, count: int, crease: float, seed: int, report: Optional[Report]) -> Tuple[Floats, Floats]:
    """Evenly spread points of a mesh with interpolated corner normals; each is the farthest from those before it."""
    try:
        mesh = hrbfnpr.Mesh(shape.points, shape.triangles, parts="all", crease_angle=crease)
    except hrbfnpr.InvalidArgumentError as error:
        raise ShapeError(str(error)) from None
    points, normals = mesh.sample(count, random_seed=seed, progress=report)
    return points, normals
