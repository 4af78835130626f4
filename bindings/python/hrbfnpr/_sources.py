# SPDX-License-Identifier: MIT
"""Sources of drawings: files, arrays, meshes and scenes of other packages, saved models and marks, and scripts of solids."""
from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Any, Mapping, Optional, Union

from . import shapes
from ._camera import Camera
from ._context import Context
from ._csg import union_of_balls
from ._errors import CorruptDataError, Error, OutOfMemoryError
from ._foreign import name_of, shape_of
from ._model import Model
from ._point_set import PointSet
from ._report import Reporter
from ._request import Options
from ._scene import Scene
from ._script import run
from ._values import words_of
from ._vtk_scene import camera_in, options_in, scene_in

MOST_BALLS = 60_000  # a solid has at most 65 536 nodes
_MAGIC = b"\x89HRB\r\n\x1a\n"
_OF_SOLIDS = ("SURFACE_ONLY", "IS_SOLID", "CLOSE")


def load_saved(path: Path, context: Context) -> Union[Model, PointSet, None]:
    """A saved model or point set, or None if the file is something else."""
    with open(path, "rb") as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            return None
    try:
        return Model.load(path, context=context)
    except CorruptDataError as as_model:
        try:
            return PointSet.load(path, context=context)
        except CorruptDataError as as_points:
            # The kind that fits the file gives the better message.
            raise as_points if "model" in str(as_points) else as_model from None


def in_words(content: Any) -> str:
    """A line that describes the source."""
    if isinstance(content, Model):
        if content.csg_info.nodes:
            return f"a saved solid of {content.csg_info.nodes} nodes"
        return f"a saved model of {content.info.centres} centres"
    if isinstance(content, PointSet):
        return f"a saved point set of {len(content)} marks"
    count = f"{len(content.points)} points"
    if content.radii is not None:
        count = f"{len(content.points)} balls"
    elif content.is_mesh:
        count = f"{len(content.points)} vertices, {len(content.triangles)} triangles"
    elif content.normals is not None:
        count += " with normals"
    return f"{content.format}: {count}"


def read(path: Path, options: Options, context: Context, report: Reporter, is_script: bool = False) -> Any:
    """Read a file: a saved model or point set, the solid of a script, or a shape.

    Raises
    ------
    ValueError
        If the file cannot be used; the message names it.
    """
    try:
        if is_script or path.suffix.lower() == ".csg":
            return _solid(path, options, context, report)
        with report.stage("read", "reading") as stage:
            content: Any = load_saved(path, context)
            if content is None:
                content = shapes.read(path, options.get("classes"))
                for note in content.notes:
                    report.note(note)
            elif "classes" in options:
                raise ValueError("classes are of the points of a LAS or LAZ file, and this is a saved one")
            stage.says = in_words(content)
        return _solid_of(content, context)
    except OutOfMemoryError:
        raise
    except (Error, ValueError) as error:
        raise ValueError(f"{path}: {words_of(error)}") from error


def _solid_of(content: Any, context: Context) -> Any:
    """The union of the balls of a shape that has radii; all else as it is."""
    if not isinstance(content, shapes.Shape) or content.radii is None:
        return content
    if len(content.points) > MOST_BALLS:
        raise ValueError(f"{len(content.points)} balls are too many for one solid: keep a part of the file, at most {MOST_BALLS}")
    return union_of_balls(Model, context._handle, content.points.tolist(), content.radii.tolist())


def _solid(path: Path, options: Options, context: Context, report: Reporter) -> Model:
    def leaf(name: str) -> Model:
        file = path.parent / name
        content = read(file, options, context, report)
        if not isinstance(content, Model) and not isinstance(content, PointSet):
            # As a leaf of a solid, a surface must have no end, however its file would be drawn alone.
            content = Scene.create([content], options, None, context, report, flags=_OF_SOLIDS, path=str(file)).model
        if not isinstance(content, Model):
            raise ValueError(f"{file} holds a point set; solids are models")
        return content

    model = run(path.read_text(encoding="utf-8"), leaf, context)
    nodes, sheets = (f"{count} {what}{'' if count == 1 else 's'}" for count, what in (
        (model.csg_info.nodes, "node"), (model.csg_info.sheets, "sheet")))  # fmt: skip
    report.note(f"a solid of {nodes}, {sheets}")
    return model


def _with_fields(content: Any, fields: Mapping[str, Any], options: Options) -> Any:
    """A shape with more values of its points.  Three numbers are a direction if the options use them as such, else a colour."""
    if not isinstance(content, shapes.Shape):
        raise ValueError("fields are values of points: a model and saved marks have no points to give them to")
    directions = [part[10:] for part in options.get("field", "").split(",") if part.startswith("direction=")]
    found = {name: shapes.values_of(name, values, len(content.points), name in directions) for name, values in fields.items()}
    return replace(content, fields={**content.fields, **found})


def scene_of(
    source: Any, style: Any, options: Options, camera: Optional[Camera], context: Optional[Context], report: Reporter,
    is_script: bool = False, fields: Optional[Mapping[str, Any]] = None, **more: Any,
) -> Scene:  # fmt: skip
    """The scene of a source.  `fields` are more values of its points; `more` are arguments of `Scene.create`."""
    context = Context() if context is None else context
    name, file = name_of(source), None
    if isinstance(source, (str, os.PathLike)):
        path = Path(source)
        contents, name, file = [read(path, options, context, report, is_script)], path.name, os.fspath(source)
    elif isinstance(source, (Model, PointSet)):
        contents = [source]
    else:
        scene = scene_in(source)
        found = [shape_of(source)] if scene is None else scene.shapes
        for note in scene.notes if scene is not None else found[0].notes:
            report.note(note)
        contents = [_solid_of(one, context) for one in found]
        if scene is not None:
            options = options_in(scene, options, style)
            camera = camera_in(scene, options) if camera is None else camera
    if "classes" in options and file is None:
        raise ValueError("classes are of the points of a LAS or LAZ file, and the source is no file")
    if fields:
        if len(contents) > 1:
            raise ValueError(f"fields are values of the points of one surface, and {name} has {len(contents)}")
        contents, more["with_fields"] = [_with_fields(contents[0], fields, options)], True
    return Scene.create(contents, options, style, context, report, camera=camera, name=name, path=file, **more)
