# SPDX-License-Identifier: MIT
"""Where the surface of a fitted model ends: where what was read does."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .._errors import NotConvergedError
from .._mesh import Mesh
from .._model import Model
from ..shapes import Shape
from . import _mesh, _orient
from ._progress import Reporter

ON_MESH = 60_000  # places on a mesh, some 0.005 diagonals from each other, chosen from three times as many: no gaps
CLOSED = 0.5  # share of the surface left out, below which the rest is no strips along curves
DOUBTED = 0.002  # share of a closed surface left out that is warned of


def end(model: Model, shape: Shape, close: bool, report: Reporter, hole: Optional[float] = None) -> Model:
    """The model with what lies beyond the points left out, unless it shall be closed; says what that is.

    `hole` is of points with normals whose gaps are known to be some where they are larger, in their unit.
    """
    if close:
        return model
    if hole is not None:
        options = {"hole": hole / _mesh.diagonal(model), "normals": shape.normals}
        return _ended(model, shape.points, "points", options, report)
    points = shape.points[np.isfinite(shape.points).all(axis=1)]
    ended = _ended(model, points, "points", {}, report)
    if ended.trim_info.share < CLOSED and _orient.along_curves(points):
        report.note("the points lie along curves, as of wires or cross sections: the surface between these is drawn, too")
    return ended


def end_of_mesh(model: Model, mesh: Mesh, close: bool, report: Reporter) -> Model:
    """The same beyond a mesh; what the surface has that a closed one does not was made by the fit."""
    fitted = model.mesh_fit
    of_sheets = fitted is not None and fitted.sheets > 1
    off = _mesh.off(model)
    if close or (fitted and of_sheets and mesh.info.closed and fitted.surface_max <= off * _mesh.diagonal(model)):
        return model
    if fitted is not None and mesh.info.boundary_edges:  # the fit has ended it along the border
        with report.stage("end", "looking for the end of the surface") as stage:
            stage.says = _in_words(model, "mesh")
        return model
    places = mesh.sample(ON_MESH, candidates=3 * ON_MESH).points
    ended = _ended(model, places, "mesh", {"hole": off, "closest": off}, report)
    info = ended.trim_info
    if mesh.info.closed and info.share > DOUBTED:
        remedy = (
            "its faces cross or are folded there, and mending them may do without"
            if of_sheets
            else f"more samples may do without, --samples {4 * model.info.centres} for example"
        )
        report.warn(f"the fit made {_parts(info.parts)} of surface that the mesh does not have, left out: {remedy}")
    return ended


def _ended(model: Model, places: Any, of: str, options: "dict[str, Any]", report: Reporter) -> Model:
    with report.stage("end", "looking for the end of the surface") as stage:
        try:
            ended = model.trim(places, progress=stage.bar, **options)
        except NotConvergedError as error:
            report.warn(f"where the surface ends was not found ({error}); it goes on to the end of its box")
            return model
        stage.says = _in_words(ended, of)
    return ended


def _in_words(ended: Model, of: str) -> str:
    info = ended.trim_info
    if not info.is_trimmed:
        return "the surface is whole"
    farthest = info.farthest / _mesh.diagonal(ended)
    return (
        f"{info.share:.1%} of the surface, {_parts(info.parts)}, is beyond the {of} (up to {farthest:.1%} of the "
        "diagonal) and left out; --close keeps it"
    )


def _parts(count: int) -> str:
    return "1 part" if count == 1 else f"{count} parts"
