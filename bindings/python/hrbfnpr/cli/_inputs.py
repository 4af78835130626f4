# SPDX-License-Identifier: MIT
"""What a command works on: a saved model or point set, or a model fitted to what a file holds.

The stages of points are read, sample, orient, fit and end: `_usable`, `_samples`, `_normals`, `Model.fit` and `_ends.end`.
Points without normals get some from `_orient.make`.  A mesh is looked at by `_mesh.read`; the rest is the same.
"""
from __future__ import annotations

from argparse import Namespace
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np

from .. import shapes
from .._context import Context
from .._errors import CorruptDataError, Error
from .._mesh import farthest_points
from .._model import Model
from .._point_set import PointSet
from ..shapes import Shape, ShapeError
from ..shapes._shape import Floats, Vector
from . import _automatic, _depth_image, _ends, _far, _mesh, _nearness, _orient, _script, _strays, _up
from ._progress import Reporter

_MAGIC = b"\x89HRB\r\n\x1a\n"
MOST_SAMPLES = 4096  # a direct fit of more takes minutes and gigabytes
MOST_ORIENTED = 20_000  # points that get normals, within some ten seconds
THIN = 1e-4  # of the longest extent, what is none
FEW = 10  # samples with which a surface is a guess

FIT = (
    "kernel", "kernel_radius", "polynomial_degree", "regularization", "solver", "tolerance", "maximum_centres",
    "refinement_steps", "outliers", "flipped_normals",
)  # fmt: skip


@dataclass(frozen=True)
class Loaded:
    """A model or a point set, what it comes from if that was read, and which way is up.

    A mesh whose parts are no surface together makes several, which are drawn in one picture: the others are in `rest`.
    """

    content: Union[Model, PointSet]
    shape: Optional[Shape]
    up: Vector
    rest: Tuple[Loaded, ...] = ()


def given(arguments: Any, names: Tuple[str, ...]) -> "dict[str, Any]":
    """The options that were given, by the names of the arguments that they stand for."""
    return {name: value for name in names if (value := getattr(arguments, name, None)) is not None}


def fit_options(arguments: Any) -> "dict[str, Any]":
    """Of a fit to points: those given, before those of settings that were read."""
    return {**(getattr(arguments, "own_fit", None) or {}), **given(arguments, FIT)}


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


def in_words(shape: Shape) -> str:
    """What was read, in a line."""
    count = f"{len(shape.points)} points"
    if shape.is_mesh:
        assert shape.triangles is not None
        count = f"{len(shape.points)} vertices, {len(shape.triangles)} triangles"
    elif shape.normals is not None:
        count += " with normals"
    return f"{shape.format}: {count}"


def _usable(shape: Shape, report: Reporter) -> Shape:
    shape, left_out = finite_faces(shape)
    if left_out:
        report.warn(f"{_nearness.of(left_out, 'face')} with a corner that is not finite left out")
    for note in shape.notes:
        report.note(note)
    shape, empty, value = _far.without_data(shape)
    if empty:
        what = "point" if not shape.is_mesh else "vertex" if empty == 1 else "vertice"
        report.note(f"{_nearness.of(empty, what)} at {value:g}, which stands for no data, left out")
    return shape


def finite_faces(shape: Shape) -> Tuple[Shape, int]:
    """Without the faces that cannot be used, and how many they are."""
    if not shape.is_mesh:
        return shape, 0
    assert shape.triangles is not None
    finite = np.isfinite(shape.points[shape.triangles]).all(axis=(1, 2))
    if not finite.any():
        raise ShapeError("no face has three corners that are finite")
    return (shape, 0) if finite.all() else (replace(shape, triangles=shape.triangles[finite]), int((~finite).sum()))


def has_normals(shape: Shape) -> bool:
    """Whether points have normals, others than zeros."""
    return shape.normals is not None and bool(np.any(np.nan_to_num(shape.normals)))


def _without_strays(points: Floats, report: Reporter) -> Floats:
    strays = _strays.find(points)
    if not strays.any():
        return points
    _tell_strays(int(strays.sum()), report)
    return points[~strays]


def _tell_strays(count: int, report: Reporter) -> None:
    report.note(f"{_nearness.of(count, 'point')} far from all others left out (--outliers keep keeps them)")


def _without_far(shape: Shape, arguments: Any, report: Reporter) -> Shape:
    """Points without a few that would make all others a dot."""
    if fit_options(arguments).get("outliers") == "keep":
        return shape
    shape, far = _far.without_strays(shape)
    if far:
        _tell_strays(far, report)
    return shape


def _seen(shape: Shape, arguments: Any) -> Dict[str, Optional[Vector]]:
    """What open surfaces look to, as far as it is known; for a model no direction of up is asked."""
    return {"up": getattr(arguments, "up", None) or shape.up, "viewpoint": arguments.viewpoint or shape.viewpoint}


def _with_normals(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Shape:
    """Points that have none, with those that the library finds."""
    points = shape.points[np.isfinite(shape.points).all(axis=1)]
    if fit_options(arguments).get("outliers") != "keep":
        points = _without_strays(points, report)
    if len(points) > MOST_ORIENTED:
        chosen, _ = farthest_points(points, MOST_ORIENTED, context=context)
        points = points[np.asarray(chosen)]
        report.note(f"{len(shape.points)} points, of which {MOST_ORIENTED} get normals")
    with report.stage("orient", "looking for normals") as stage:
        made = _orient.make(points, "none", None, stage.bar, context, **_seen(shape, arguments))
        stage.says = _orient.in_words_of(made, len(points))
    seen = ", which look to where the scanner stood" if made.info.outward_by == "viewpoint" else ""
    report.note(f"the points have no normals: {len(points)} are made{seen}")
    for doubt in _orient.doubts_of(made):
        report.warn(doubt)
    return replace(shape, points=points, normals=np.asarray(made.normals, dtype=float))


def _samples(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Tuple[Floats, Floats]:
    count = arguments.samples
    options = fit_options(arguments)
    fit_chooses = options.get("tolerance") or options.get("maximum_centres")  # the fit itself chooses, from all of them
    if count is None and not fit_chooses and len(shape.points) > MOST_SAMPLES:
        count = MOST_SAMPLES
        report.note(f"{len(shape.points)} points, of which {count} are used; --samples N sets another number")
    with report.stage("sample", "sampling") as stage:
        bar = stage.bar
        progress = None if bar is None else lambda fraction: bar.update(fraction - bar.n)
        of_all = None if shape.is_picture else count
        points, normals = shapes.samples(shape, of_all, report=progress, **given(arguments, ("random_seed",)))
        if shape.is_picture and count is not None and count < len(points):
            chosen = _depth_image.chosen(points, count, context)
            points, normals = points[chosen], normals[chosen]
        stage.says = f"{len(points)} samples"
    if count is None and len(points) < len(shape.points):
        left_out = len(shape.points) - len(points)
        report.note(f"{left_out} points without a usable position or normal are left out")
    return points, normals


def _normals(
    points: Floats, normals: Floats, shape: Shape, arguments: Any, context: Context, report: Reporter
) -> Tuple[Floats, Floats]:
    """Those that look outward; --flip is the user's own word on it."""
    points, normals, joined, opposite = _orient.agreed(points, normals)
    if joined:
        report.note(f"{_nearness.of(joined, 'place')} with several normals, as on a sharp edge: their mean is used")
    if opposite:
        report.warn(f"{_nearness.of(opposite, 'place')} with opposite normals left out")
    if len(points) == 0:
        raise ShapeError("all points are in pairs with opposite normals")
    if arguments.flip:
        return points, -normals
    with report.stage("orient", "orienting") as stage:
        mode, seen = arguments.normals or "auto", _seen(shape, arguments)
        normals, stage.says = _orient.settle(points, normals, mode, report, stage.bar, context, **seen)
        axis = _up.hangs(points, normals) if arguments.normals != "keep" else None
        if axis is not None:
            normals, stage.says = -normals, "a terrain looked down: its normals are turned"
            what = f"the surface is a terrain that looked down along {axis}"
            report.note(f"{what}: its normals are turned (--normals keep leaves them)")
    return points, normals


def load(path: Path, arguments: Any, context: Context, report: Reporter) -> Loaded:
    """The saved model or point set, the solid of a script, or a model fitted to the samples in the file."""
    if is_script(path, arguments):
        return _load_script(path, arguments, context, report)
    with report.stage("read", "reading") as stage:
        saved = load_saved(path, context)
        shape = None if saved is not None else _usable(shapes.read(path), report)
        stage.says = in_words(shape) if shape is not None else _saved_in_words(saved)
    if saved is not None:
        return of_made(saved, arguments, context, report)
    assert shape is not None
    return _fitted(shape, arguments, context, report)


def of_made(made: Union[Model, PointSet], arguments: Any, context: Context, report: Reporter) -> Loaded:
    """A model or a point set that is there."""
    return Loaded(made, None, _up_of_saved(made, arguments, context, report))


def of_shape(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Loaded:
    """A model fitted to points or a mesh that are there."""
    return _fitted(_usable(shape, report), arguments, context, report)


def _fitted(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Loaded:
    if arguments.viewpoint and (shape.is_mesh or (has_normals(shape) and arguments.normals in (None, "auto", "keep"))):
        report.warn("--viewpoint is for points whose normals are made, and these have some: --normals none makes new ones")
    if shape.is_mesh:
        return _load_mesh(shape, arguments, context, report)
    shape = _without_far(shape, arguments, report)
    made, hole = arguments.normals == "none" or not has_normals(shape), None
    if made and shape.image_shape is not None:
        if arguments.viewpoint:
            report.warn("--viewpoint is not used: the points are a picture, whose camera is known")
        shape, hole = _depth_image.smooth(shape, arguments, context, report)
    elif made:
        shape = _with_normals(shape, arguments, context, report)
    points, normals = _samples(shape, arguments, context, report)
    if not made:
        points, normals = _normals(points, normals, shape, arguments, context, report)
    elif arguments.flip:
        normals = -normals
    up = _up_of(shape, points, normals, arguments, report)
    # Scans have noise, of which none is seen in clean samples; what has no normals is one, and has dust, too.
    own = {"regularization": "auto", **({"outliers": "drop"} if made else {})}
    model = _fit(points, normals, arguments, context, report, **own)
    return Loaded(_ends.end(model, shape, arguments.close, report, hole), shape, up)


def is_script(path: Path, arguments: Any) -> bool:
    """Whether a file is a script of solids: by the command, or by its name."""
    return arguments.command == "csg" or path.suffix.lower() == ".csg"


def _load_script(path: Path, arguments: Any, context: Context, report: Reporter) -> Loaded:
    def leaf(name: Path) -> Model:
        # A solid has no end; what its file is drawn by alone does not matter here.
        options = Namespace(**{**vars(arguments), "command": "fit", "close": True})
        try:
            content = load(name, options, context, report).content
        except (Error, ValueError) as error:
            raise ValueError(f"{name}: {error}") from error
        if not isinstance(content, Model):
            raise ValueError(f"{name} holds a point set; solids are models")
        return content

    model = _script.read(path, leaf, context)
    info = model.csg_info
    report.note(f"a solid of {_nearness.of(info.nodes, 'node')}, {_nearness.of(info.sheets, 'sheet')}")
    return Loaded(model, None, _up_of_saved(model, arguments, context, report))


def _load_mesh(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Loaded:
    read = _mesh.read(shape, arguments, context, report)
    for doubt in _thin_evidence(read.points):
        report.warn(doubt)
    up = _up_of(read.shape, read.points, read.normals, arguments, report)
    groups = _mesh.in_groups(read, arguments, context, report)
    across = 0.0 if len(groups) == 1 else float(np.linalg.norm(np.ptp(read.shape.points, axis=0)))
    made = [_of_mesh(group, up, across, arguments, context, report) for group in groups]
    return replace(made[0], rest=tuple(made[1:]))


def _of_mesh(
    read: _mesh.Read, up: Vector, across: float, arguments: Any, context: Context, report: Reporter
) -> Loaded:
    if _mesh.chooses(arguments):
        model = _mesh.fit(read, arguments, report, across)
    else:
        model = _fit(read.points, read.normals, arguments, context, report)
        _nearness.tell(read.mesh, model, report)
    return Loaded(_ends.end_of_mesh(model, read.mesh, arguments.close, report), read.shape, up)


def _fit(
    points: Floats, normals: Floats, arguments: Any, context: Context, report: Reporter, **unless_given: Any
) -> Model:
    """A model of these samples, and what there is to say of it."""
    options = {**unless_given, **fit_options(arguments)}
    with report.stage("fit", "fitting") as stage:
        model = Model.fit(points, normals, trim="never", progress=stage.bar, context=context, **options)
        info = model.info
        how = _nearness.of_points(model)
        stage.says = f"{_nearness.of(info.centres, 'centre')}, {info.kernel}, {info.solver}; {how}"
    if "regularization" in unless_given and options["regularization"] == "auto" and info.regularization > 0:
        report.note("the samples have noise, and the surface is smooth (--regularization 0 goes through all of them)")
    for repair in _nearness.repairs(model):
        report.note(repair)
    for doubt in [*_nearness.doubts(model), *_thin_evidence(points)]:
        report.warn(doubt)
    return model


def _saved_in_words(saved: Union[Model, PointSet, None]) -> str:
    if isinstance(saved, Model):
        if saved.csg_info.nodes:
            return f"a saved solid of {saved.csg_info.nodes} nodes"
        return f"a saved model of {saved.info.centres} centres"
    return f"a saved point set of {0 if saved is None else len(saved)} marks"


def _thin_evidence(points: Floats) -> Tuple[str, ...]:
    """What is said of samples that hardly make a surface."""
    if len(points) == 1:
        return ("there is one point only: what is drawn is its plane",)
    if len(points) < FEW:
        return (f"there are {len(points)} points only: the surface between them is a guess",)
    away = points - points.mean(axis=0)
    extent = np.sqrt(np.maximum(np.linalg.eigvalsh(away.T @ away)[::-1], 0))  # of the longest side first
    if extent[1] < THIN * extent[0]:
        return ("all points are on a line: the surface beside it is a guess",)
    if extent[2] < THIN * extent[0]:
        return ("all points lie in a plane: the surface is flat, and ends where they do",)
    return ()


def _up_of(shape: Optional[Shape], points: Floats, normals: Floats, arguments: Any, report: Reporter) -> Vector:
    """--up, or what is found."""
    wanted: Optional[Vector] = getattr(arguments, "up", None)
    if wanted is not None or not hasattr(arguments, "up"):
        return wanted or _up.Y
    up, why = _up.choose(shape, points, normals)
    if up != _up.Y:
        report.note(f"up is {_up.name(up)}: {why}; --up y sets another direction")
    return up


def _up_of_saved(saved: Union[Model, PointSet], arguments: Any, context: Context, report: Reporter) -> Vector:
    if getattr(arguments, "up", None) is not None or not hasattr(arguments, "up"):
        return _up_of(None, np.zeros((0, 3)), np.zeros((0, 3)), arguments, report)
    marks = _automatic.probe(saved, context) if isinstance(saved, Model) else saved
    normals = np.concatenate([np.asarray(layer.normals, dtype=float) for layer in marks.layers])
    return _up_of(None, _automatic.positions(marks), normals, arguments, report)
