# SPDX-License-Identifier: MIT
"""Results of a model's methods."""
from __future__ import annotations

from typing import NamedTuple, Optional

from ._arrays import Array
from ._numpy import np


class Evaluation(NamedTuple):
    """Result of `Model.evaluate`: `value`, `gradient` and `hessian`; None for a result that was not requested."""

    value: Array
    gradient: Optional[Array]
    hessian: Optional[Array]

    def hessian_matrix(self) -> Array:
        """Return the Hessians as symmetric matrices, shape (..., 3, 3); a copy.  Needs NumPy."""
        if self.hessian is None:
            raise ValueError("the Hessian was not asked for: use evaluate(points, hessian=True)")
        return np.asarray(self.hessian)[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]


class Projection(NamedTuple):
    """Result of `Model.project`: `position`, `normal`, `status` and `converged`.

    `status` is 0 for a point that converged.  `hrbfnpr.PROJECTION_STATUS` names the other numbers.
    """

    position: Array
    normal: Array
    status: Array
    converged: int


class Curvature(NamedTuple):
    """Result of `Model.curvature`: `k1`, `k2`, `d1`, `d2` and `confidence`."""

    k1: Array
    k2: Array
    d1: Array
    d2: Array
    confidence: Array


class RayHits(NamedTuple):
    """Result of `Model.cast_rays`: `hits`, `t`, `position`, `normal`, `entering`, `status` and `hit_rays`.

    `hits` is the number of hits on each ray.  `status` is 0 for a ray with a hit and 1 for a ray without one.
    `hrbfnpr.RAY_STATUS` names the other numbers.
    """

    hits: Array
    t: Array
    position: Array
    normal: Array
    entering: Array
    status: Array
    hit_rays: int
