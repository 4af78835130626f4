# SPDX-License-Identifier: MIT
"""Well-spread samples with normals of meshes and point sets."""
from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

import numpy as np

import hrbfnpr

from ._shape import Floats, Integers, Shape, ShapeError

CANDIDATES = 40  # random candidates for each sample that is chosen
Report = Callable[[float], Any]


def farthest_points(points: Floats, count: int, report: Optional[Report] = None) -> Integers:
    """Indices of `count` points, each as far as can be from those before it; `hrbfnpr.farthest_points`.

    Starts with the point nearest to the middle of the bounding box, so that the choice depends on the points alone.
    """
    count = min(count, len(points))
    if count == 0:
        return np.empty(0, dtype=np.int64)
    return hrbfnpr.farthest_points(points, count, progress=report)[0]


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
        A mesh is sampled evenly over the area of all its parts, by `hrbfnpr.Mesh`; of a point set with normals,
        points are chosen.  Points that are not finite, or whose normal is zero, are left out.
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
        raise ShapeError("no point is finite and has a normal that is not zero")
    return points[usable], normals[usable] / length[usable, None]


def _on_mesh(shape: Shape, count: int, crease: float, seed: int, report: Optional[Report]) -> Tuple[Floats, Floats]:
    """Points, even over the area, with interpolated corner normals; each next one the farthest from those before."""
    try:
        mesh = hrbfnpr.Mesh(shape.points, shape.triangles, parts="all", crease_angle=crease)
    except hrbfnpr.InvalidArgumentError as error:
        raise ShapeError(str(error)) from None
    points, normals = mesh.sample(count, random_seed=seed, progress=report)
    return points, normals
