# SPDX-License-Identifier: MIT
"""What the operators of a model return."""
from __future__ import annotations

from typing import NamedTuple, Optional

from ._arrays import Array
from ._numpy import np


class Evaluation(NamedTuple):
    """Result of `Model.evaluate`; what was not asked for is None."""

    value: Array
    gradient: Optional[Array]
    hessian: Optional[Array]

    def hessian_matrix(self) -> Array:
        """The Hessians as symmetric matrices, shape (..., 3, 3); a copy.  Needs NumPy."""
        if self.hessian is None:
            raise ValueError("the Hessian was not asked for: use evaluate(points, hessian=True)")
        return np.asarray(self.hessian)[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]


class Projection(NamedTuple):
    """Result of `Model.project`.

    `status` is 0 where a point converged; see `PROJECTION_STATUS` for the other numbers.
    """

    position: Array
    normal: Array
    status: Array
    converged: int


class Curvature(NamedTuple):
    """Result of `Model.curvature`."""

    k1: Array
    k2: Array
    d1: Array
    d2: Array
    confidence: Array


class RayHits(NamedTuple):
    """Result of `Model.cast_rays`.

    `hits` is how many were found on a ray; `status` is 0 on one that is hit, 1 on one that is not; see
    `RAY_STATUS` for the other numbers.
    """

    hits: Array
    t: Array
    position: Array
    normal: Array
    entering: Array
    status: Array
    hit_rays: int
