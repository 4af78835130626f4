# SPDX-License-Identifier: MIT
"""How near a fitted surface is to what it was fitted to."""
from __future__ import annotations

from typing import List, Union

import numpy as np

from .._mesh import Comparison, Mesh, MeshFitInfo
from .._model import Model
from ._progress import Reporter

FAR = 0.01  # of the diagonal, as Model.compare has it
DOUBTED = 0.005  # share of samples that look wrong and is warned of
SHARE = 0.01  # of the mesh that may be as far without a warning


def in_words(found: Union[Comparison, MeshFitInfo], diagonal: float) -> str:
    """Distances both ways, as shares of the diagonal."""
    # From some places of the mesh no surface may be found at all.
    far = f"{found.mesh_max / diagonal:.2%}" if np.isfinite(found.mesh_max) else "and somewhere none is near"
    near = f"{found.mesh_p99 / diagonal:.2%}" if np.isfinite(found.mesh_p99) else "not found"
    if np.isnan(found.surface_p99):
        return f"no surface was found to measure from; mesh to surface: {near}"
    return (
        f"surface to mesh: 99 % within {found.surface_p99 / diagonal:.2%} of the diagonal, all within "
        f"{found.surface_max / diagonal:.2%}; mesh to surface: {near}, {far}"
    )


def tell(mesh: Mesh, model: Model, report: Reporter) -> None:
    """Print how near the surface is; warn if the mesh is far from it."""
    with report.stage("compare", "comparing") as stage:
        found = model.compare(mesh, progress=stage.bar)
        stage.says = in_words(found, found.diagonal)
    if found.missed_share > SHARE:
        more = 4 * model.info.samples
        report.warn(
            f"the surface is off the mesh by more than {FAR:.0%} of the diagonal at {found.missed_share:.1%} of it (at "
            f"most {found.mesh_max / found.diagonal:.1%}): thin parts need more samples, --samples {more} for example"
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
