# SPDX-License-Identifier: MIT
"""The command turntable: draws an animation in which the camera turns around a model."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Iterator

from .. import _movies
from .._context import Context
from .._request import Options
from .._scene import Scene
from .._sources import scene_of
from ._draw import style_of
from ._outputs import check
from ._progress import Reporter


def turn(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Draw the frames and write the animation."""
    output = Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".gif")
    _movies.check_movie(output, arguments.fps)
    check(output)
    scene = scene_of(arguments.input, style_of(arguments), options, None, context, report,
                     turn=(arguments.turn, arguments.frames))  # fmt: skip
    scene.draw(report=report)  # an error if the first frame would be blank
    with report.stage("frames", "drawing frames") as stage:
        frames = _draw_frames(scene, arguments, stage.bar)
        _movies.write(output, frames, arguments.fps, arguments.loops, scene.style.paper)
        stage.says = f"{arguments.frames} frames"
    width, height = scene.camera.size
    report.summary(f"{output}: {arguments.frames} frames of {width} x {height} pixels")


def _draw_frames(scene: Scene, arguments: Any, bar: Any) -> Iterator[Any]:
    """Yield the frames as arrays."""
    for camera in scene.orbit(arguments.frames, arguments.turn):
        yield scene.draw(camera).image()
        if bar is not None:
            bar.update(1 / arguments.frames)
