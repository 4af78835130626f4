# SPDX-License-Identifier: MIT
"""The command draw: what is drawn goes to files."""
from __future__ import annotations

from pathlib import Path
from typing import Any, List

from .._context import Context
from .._model import Model
from .._scene import Scene, draw_scene, set_scene
from . import _lines, _settings_use
from ._inputs import Loaded
from ._progress import Reporter


def outputs_of(arguments: Any) -> List[Path]:
    """Where the drawing goes, in one format or several."""
    return [Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".png"),
            *(Path(path) for path in arguments.also)]  # fmt: skip


def draw(arguments: Any, loaded: Loaded, context: Context, report: Reporter) -> None:
    """Draw a model or a point set and write the picture."""
    outputs = outputs_of(arguments)
    scene = set_scene(arguments, loaded, context, report)
    drawing = draw_scene(scene, report)
    with report.stage("write", "writing") as stage:
        for path in outputs:
            scene.write(path, drawing, scene.camera, report)
        stage.says = ", ".join(map(str, outputs)) + _save(arguments, scene)
        if arguments.save_settings:
            lost = _settings_use.save(Path(arguments.save_settings), arguments, scene)
            stage.says += f", {arguments.save_settings}"
            if lost:
                report.note(f"settings do not hold {', '.join(lost)}: give them again with --settings")
    for doubt in _lines.doubts(drawing.info):
        report.warn(doubt)
    width, height = scene.camera.size
    report.summary(f"{outputs[0]}: {width} x {height} pixels, {scene.mark_count} marks")


def _save(arguments: Any, scene: Scene) -> str:
    """The other files that are wanted, in words."""
    model, points = arguments.save_model, arguments.save_points
    if isinstance(scene.source, Model) and model:
        scene.source.save(model)
    if points:
        scene.marks.save(points)
    return "".join(f", {path}" for path in (model, points) if path)
