# SPDX-License-Identifier: MIT
"""How near a fitted surface is to what it was fitted to.

A measurement from the surface to the mesh, too, belongs in `of_mesh`.
"""
from __future__ import annotations

from typing import Any, List, NamedTuple

import numpy as np

from .._context import Context
from .._model import Model
from ..shapes import Shape
from ..shapes._shape import Floats
from ._progress import Reporter

PLACES = 3000  # on the mesh
FAR = 0.01  # of the diagonal
DOUBTED = 0.005  # share of samples that look wrong and is warned of
SHARE = 0.01  # of the mesh that may be as far without a warning


class Nearness(NamedTuple):
    """Distances from places on a mesh to the surface, as shares of the diagonal; `lost`: where none was found."""

    usual: float  # 99 of 100 are nearer
    most: float
    far: float  # share of the places that is farther than FAR


def of_mesh(shape: Shape, model: Model, context: Context, seed: int = 1) -> Nearness:
    """Measured at random places, even over the mesh."""
    measured = places(shape, seed, PLACES)
    found = model.project(measured)
    distance = np.linalg.norm(np.asarray(found.position) - measured, axis=1)
    diagonal = float(np.linalg.norm(np.ptp(measured, axis=0)))
    # Where projecting does not converge, the value over its gradient's length is near enough to tell.
    lost = np.asarray(found.status) != 0
    if lost.any():
        there: Any = model.evaluate(measured[lost], gradient=True)
        slope = np.maximum(np.linalg.norm(np.asarray(there.gradient), axis=1), 1e-12)
        distance[lost] = np.minimum(np.abs(np.asarray(there.value)) / slope, diagonal)
    share = distance / diagonal
    return Nearness(float(np.quantile(share, 0.99)), float(share.max()), float((share > FAR).mean()))


def places(shape: Shape, seed: int, count: int) -> Floats:
    """Random ones on the faces, even over their area."""
    assert shape.triangles is not None
    random = np.random.default_rng(seed)
    a, b, c = (shape.points[shape.triangles[:, i]] for i in range(3))
    total = np.cumsum(np.linalg.norm(np.cross(b - a, c - a), axis=1))
    chosen = np.minimum(np.searchsorted(total, random.random(count) * total[-1], side="right"), len(total) - 1)
    root, turn = np.sqrt(random.random((count, 1))), random.random((count, 1))
    result: Floats = (1 - root) * a[chosen] + root * (1 - turn) * b[chosen] + root * turn * c[chosen]
    return result


def tell(shape: Shape, model: Model, samples_given: bool, context: Context, report: Reporter) -> None:
    """Print how near the surface is; warn if it is not."""
    if not shape.is_mesh:
        return
    with report.stage("compare", "comparing") as stage:
        near = of_mesh(shape, model, context)
        stage.says = (
            f"mesh to surface: 99 % within {near.usual:.2%} of the diagonal, all within {near.most:.2%} "
            f"({PLACES} places)"
        )
    if near.far > SHARE:
        more = 4 * model.info.samples
        report.warn(
            f"the surface is off the mesh by more than {FAR:.0%} of the diagonal at {near.far:.1%} of it (at most "
            f"{near.most:.1%}): thin parts need more samples, --samples {more} for example"
        )


def of_points(model: Model) -> str:
    """The same of points, from the fit's own figures."""
    info = model.info
    diagonal = float(np.linalg.norm(np.subtract(info.bounds_max, info.bounds_min))) or 1.0
    most, rms = info.input_distance_max / diagonal, info.input_distance_rms / diagonal
    if most < 1e-6:
        return "through all samples"
    return f"samples within {most:.2g} of the diagonal, {rms:.2g} rms"


def of(count: int, what: str = "sample") -> str:
    """A number of things."""
    return f"{count} {what}" + ("" if count == 1 else "s")


def repairs(model: Model) -> List[str]:
    """What the fit made of the samples."""
    info = model.info
    counts = (
        (info.merged_samples, "merged with another at the same place"),
        (info.near_duplicates, "merged with another very near"),
        (info.outliers_dropped, "dropped as strays"),
        (info.flipped_repaired, "with a flipped normal repaired"),
    )
    return [f"{of(count)} {what}" for count, what in counts if count > 0]


def doubts(model: Model) -> List[str]:
    """What the fit found wrong and left as it is."""
    info = model.info
    found = []
    least = max(3, DOUBTED * info.samples)  # at thin parts a few look so, and are right
    strays, flipped = info.outliers_found - info.outliers_dropped, info.flipped_found - info.flipped_repaired
    if strays >= least:
        found.append(f"{of(strays)} look like strays: --outliers drop leaves them out")
    if flipped >= least:
        found.append(f"{of(flipped)} look as if their normal were flipped: --flipped-normals reorient turns them")
    return found
