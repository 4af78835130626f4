# SPDX-License-Identifier: MIT
"""The commands draw and csg: they draw a source and write the drawing to files."""
from __future__ import annotations

from pathlib import Path
from typing import Any, List

from .. import _pictures
from .._context import Context
from .._model import Model
from .._options import OPTIONS
from .._page import format_of
from .._request import Options
from .._scene import Scene, Settings
from .._sources import scene_of
from .._values import words_of
from ._outputs import UsageError, check_all
from ._progress import Reporter

DEFAULT_STYLE = "contour-and-stipple"
_NEED_ONE_SURFACE = ("save_model", "save_points", "save_settings", "settings")  # these options need a single surface


def outputs_of(arguments: Any) -> List[Path]:
    """The files for the drawing: the output and those of --also."""
    return [Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".png"),
            *(Path(path) for path in arguments.also)]  # fmt: skip


def draw(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Draw a source and write the drawing to all outputs."""
    outputs = outputs_of(arguments)
    check_all(arguments, outputs)
    settings = None if not arguments.settings else read_settings(arguments.settings, context)
    unused = [f"--{row.name.replace('_', '-')}" for row in OPTIONS if row.group == "vectors" and row.name in options]
    if unused and not any(map(format_of, outputs)):
        raise UsageError(f"{', '.join(unused)} is for vectors: name an output .svg, .pdf, .hpgl, .gcode or .dxf")  # fmt: skip
    flags = ["TOGETHER"] if any(getattr(arguments, name) for name in _NEED_ONE_SURFACE) else []
    flags += ["KEEP_MARKS"] if arguments.save_points else []
    scene = scene_of(
        arguments.input, style_of(arguments), options, None, context, report, flags=flags, settings=settings,
        is_script=arguments.command == "csg",
    )  # fmt: skip
    drawing, camera = scene.draw(report=report), scene.camera
    with report.stage("write", "writing") as stage:
        for path in outputs:
            if format_of(path) is not None:
                scene.write(path, drawing, camera, report)
            else:
                _pictures.save(_pictures.to_pil(scene.image(drawing, camera)), path, None)
        stage.says = ", ".join(map(str, outputs)) + _save_model_and_marks(arguments, scene)
        if arguments.save_settings:
            scene.write_settings(arguments.save_settings, report)
            stage.says += f", {arguments.save_settings}"
    width, height = camera.size
    report.summary(f"{outputs[0]}: {width} x {height} pixels, {scene.info.marks} marks")


def style_of(arguments: Any) -> Any:
    """The name of the style.  None means the style of the file of settings."""
    if arguments.style is None and not getattr(arguments, "settings", None):
        return DEFAULT_STYLE
    return arguments.style


def read_settings(path: str, context: Context) -> Settings:
    """Read a file of settings.  Errors name the file."""
    try:
        return Settings(path, context)
    except ValueError as error:
        raise ValueError(f"{path}: {words_of(error)}") from None


def _save_model_and_marks(arguments: Any, scene: Scene) -> str:
    """Save the files of --save-model and --save-points.  Return their names as text."""
    model, points = arguments.save_model, arguments.save_points
    if isinstance(scene.model, Model) and model:
        scene.model.save(model)
    if points:
        scene.parts[0].marks.save(points)  # type: ignore[union-attr]
    return "".join(f", {path}" for path in (model, points) if path)
