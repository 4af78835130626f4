# SPDX-License-Identifier: MIT
"""What the operators of a model return."""
from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Optional, Tuple

from ._arrays import Array
from ._numpy import np

Vector = Tuple[float, float, float]


@dataclass(frozen=True)
class ModelInfo:
    """What a fit did.  Lengths are in the unit of the points.

    Attributes
    ----------
    kernel, polynomial_degree
        As used.
    choice_rounds : int
        Fits made to choose the centres; 0 if all samples are centres.
    samples, centres : int
        Samples given; centres after merging, cleaning and choosing.
    merged_samples, near_duplicates : int
        Samples that coincided, or nearly, with another and were merged into it.
    rescaled_normals : int
        Normals whose length was off 1 by more than 1e-4.
    outliers_found, outliers_dropped, flipped_found, flipped_repaired : int
        What looked wrong with the samples, and what was done about it.
    bounds_min, bounds_max : tuple of float
        Box of the samples.
    spacing : float
        Mean distance of a sample to its nearest neighbour.
    kernel_radius, regularization : float
        As used.
    noise_estimate : float or None
        Standard deviation of the samples off their surface; 0 if none is seen, None if nobody asked.
    value_residual_max, value_residual_rms : float
        Of abs(f(x_i)).
    gradient_residual_max, gradient_residual_rms : float
        Of the length of grad f(x_i) - n_i.
    input_distance_max, input_distance_rms : float
        Distance of all samples, but dropped ones, from the surface: abs(f) / abs(grad f).
    input_share_within : float or None
        Share of all samples within the tolerance; a dropped one counts as outside; None with tolerance 0.
    solver : str
        The one used.
    solver_reason : str
        "requested", "small", "large", "not_converged" or "not_definite".
    iterations : int
        Refinement steps of "direct", steps of "iterative".
    fallback : bool
        Whether the matrix was not definite and a pivoted LU was used.
    solver_residual : float
        Relative residual of the linear system in the 2-norm.
    condition_estimate : float
        Of the matrix, 1-norm ("direct"), or of the preconditioned one, 2-norm ("iterative").
    seconds_clean, seconds_choose, seconds_assemble, seconds_precondition, seconds_solve, seconds_total : float
    bytes : int
        Memory kept by the model.
    peak_bytes : int
        The most that the context had allocated at a time, up to the fit's end.
    normals_found, normals_turned, normals_confidence
        Of a fit with a `normal_mode` but "given": see `OrientInfo`.
    normals_inward : bool
        Whether normals as given all point into a closed surface.
    seconds_orient : float
    """

    kernel: str
    polynomial_degree: int
    choice_rounds: int
    samples: int
    centres: int
    merged_samples: int
    near_duplicates: int
    rescaled_normals: int
    outliers_found: int
    outliers_dropped: int
    flipped_found: int
    flipped_repaired: int
    bounds_min: Vector
    bounds_max: Vector
    spacing: float
    kernel_radius: float
    regularization: float
    noise_estimate: Optional[float]
    value_residual_max: float
    value_residual_rms: float
    gradient_residual_max: float
    gradient_residual_rms: float
    input_distance_max: float
    input_distance_rms: float
    input_share_within: Optional[float]
    solver: str
    solver_reason: str
    iterations: int
    fallback: bool
    solver_residual: float
    condition_estimate: float
    seconds_clean: float
    seconds_choose: float
    seconds_assemble: float
    seconds_precondition: float
    seconds_solve: float
    seconds_total: float
    bytes: int
    peak_bytes: int
    normals_found: str
    normals_inward: bool
    normals_turned: int
    normals_confidence: Optional[float]
    seconds_orient: float


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
