# SPDX-License-Identifier: MIT
"""The command turntable: an orbit as an animation."""
from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any, Iterator

from .. import _movies
from .._orbit import cameras_of, first_camera
from .._scene import Scene, draw_scene, set_scene
from ._inputs import Loaded
from ._progress import Reporter


def output_of(arguments: Any) -> Path:
    """Where the animation goes."""
    return Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".gif")


def turn(arguments: Any, output: Path, loaded: Loaded, context: Any, report: Reporter) -> None:
    """Draw the frames and write them."""
    look = partial(first_camera, frames=arguments.frames, turn=arguments.turn)
    scene = set_scene(arguments, loaded, context, report, look)
    draw_scene(scene, report)  # says if it would be blank
    with report.stage("frames", "drawing frames") as stage:
        frames = _drawn(scene, arguments.frames, arguments.turn, stage.bar)
        _movies.write(output, frames, arguments.fps, arguments.loops, scene.style.paper)
        stage.says = f"{arguments.frames} frames"
    width, height = scene.camera.size
    report.summary(f"{output}: {arguments.frames} frames of {width} x {height} pixels")


def _drawn(scene: Scene, frames: int, turn: float, bar: Any) -> Iterator[Any]:
    for camera in cameras_of(scene, frames, turn):
        yield scene.draw(camera).image()
        if bar is not None:
            bar.update(1 / frames)
