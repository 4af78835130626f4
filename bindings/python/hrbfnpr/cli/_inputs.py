# SPDX-License-Identifier: MIT
"""What a command works on: a saved model or point set, or samples from a file."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Tuple, Union

from .. import shapes
from .._context import Context
from .._errors import CorruptDataError
from .._model import Model
from .._point_set import PointSet
from ._progress import Reporter

_MAGIC = b"\x89HRB\r\n\x1a\n"
MOST_SAMPLES = 4096  # a direct fit of more takes minutes and gigabytes

FIT = (
    "kernel", "kernel_radius", "polynomial_degree", "regularization", "solver", "tolerance", "maximum_centres",
    "refinement_steps", "outliers", "flipped_normals",
)  # fmt: skip


def given(arguments: Any, names: Tuple[str, ...]) -> "dict[str, Any]":
    """The options that were given, by the names of the arguments that they stand for."""
    return {name: value for name in names if (value := getattr(arguments, name, None)) is not None}


def load_saved(path: Path, context: Context) -> Union[Model, PointSet, None]:
    """A saved model or point set; None if the file is something else."""
    with open(path, "rb") as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            return None
    try:
        return Model.load(path, context=context)
    except CorruptDataError as as_model:
        try:
            return PointSet.load(path, context=context)
        except CorruptDataError as as_points:
            # The one that fails later knows more about what is wrong.
            raise as_points if "model" in str(as_points) else as_model from None


def _samples(path: Path, arguments: Any, report: Reporter) -> Any:
    shape = shapes.read(path)
    count = arguments.samples
    chosen = arguments.tolerance or arguments.maximum_centres  # the fit itself chooses, from all of them
    if count is None and not shape.is_mesh and not chosen and len(shape.points) > MOST_SAMPLES:
        count = MOST_SAMPLES
        report.note(f"{len(shape.points)} points, of which {count} are used; --samples N sets another number")
    options = given(arguments, ("crease", "random_seed"))
    with report.stage("sampling") as bar:
        progress = None if bar is None else lambda fraction: bar.update(fraction - bar.n)
        points, normals = shapes.samples(shape, count, flip=arguments.flip, report=progress, **options)
    if not shape.is_mesh and count is None and len(points) < len(shape.points):
        left_out = len(shape.points) - len(points)
        report.note(f"{left_out} points without a usable position or normal are left out")
    return points, normals


def load(path: Path, arguments: Any, context: Context, report: Reporter) -> Union[Model, PointSet]:
    """The saved model or point set, or a model fitted to the samples in the file."""
    saved = load_saved(path, context)
    if saved is not None:
        return saved
    points, normals = _samples(path, arguments, report)
    with report.stage("fitting") as bar:
        return Model.fit(points, normals, progress=bar, context=context, **given(arguments, FIT))
