# SPDX-License-Identifier: MIT
"""Where the surface of a fitted model ends: where what was read does."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .._errors import NotConvergedError
from .._model import Model
from ..shapes import Shape
from ..shapes._shape import Floats
from . import _mesh, _nearness
from ._progress import Reporter

MOST_POINTS = 500_000  # that are asked where the surface ends
ON_MESH = 60_000  # places on a mesh, some 0.005 diagonals from each other
DOUBTED = 0.002  # share of a closed surface left out that is warned of


def end(model: Model, shape: Shape, closed: bool, close: bool, report: Reporter) -> Model:
    """The model with what lies beyond the input left out, unless it shall be closed; says what that is.

    closed: of a mesh; what the surface has beyond that is none of it.
    """
    if close:
        return model
    with report.stage("end", "looking for the end of the surface") as stage:
        places = _places(shape)
        off = _mesh.off(model) if shape.is_mesh else 0.0
        mesh = {"hole": off, "closest": off} if shape.is_mesh else {}
        try:
            ended = model.trim(places, progress=stage.bar, **mesh)
        except NotConvergedError as error:
            report.warn(f"where the surface ends was not found ({error}); it goes on to the end of its box")
            return model
        info = ended.trim_info
        stage.says = "the surface is whole"
        if not info.is_trimmed:
            return ended
        of = "mesh" if shape.is_mesh else "points"
        farthest = info.farthest / _mesh.diagonal(model)
        parts = "1 part" if info.parts == 1 else f"{info.parts} parts"
        stage.says = (
            f"{info.share:.1%} of the surface, {parts}, is beyond the {of} (up to {farthest:.1%} of the diagonal) and "
            "left out; --close keeps it"
        )
    if closed and info.share > DOUBTED:
        report.warn(
            f"the fit made {parts} of surface that the mesh does not have, left out: more samples may do without, "
            f"--samples {4 * model.info.centres} for example"
        )
    return ended


def end_of_saved(model: Model, close: bool) -> Model:
    """The same of a saved model, which knows its centres only."""
    if close or model.trim_info.is_trimmed or model.info.centres == 0:
        return model
    try:
        return model.trim()
    except NotConvergedError:
        return model


def _places(shape: Shape) -> Optional[Floats]:
    """On what was read."""
    if shape.is_mesh:
        return _nearness.places(shape, 1, ON_MESH)
    points = shape.points[np.isfinite(shape.points).all(axis=1)]
    if len(points) > MOST_POINTS:
        points = points[np.random.default_rng(1).choice(len(points), MOST_POINTS, replace=False)]
    return points
