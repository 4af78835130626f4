# SPDX-License-Identifier: MIT
"""Turntables: an orbit about what is drawn.  Needs NumPy and Pillow."""
from __future__ import annotations

import base64
import os
import tempfile
from pathlib import Path
from typing import Any, Iterator, List, Optional, Union

from . import _movies
from ._arrays import Array
from ._camera import Camera
from ._context import Context
from ._picture import Picture, asked
from ._report import CallReport, Progress
from ._scene import Scene
from ._style import Style

SIZE = 480  # longer side


class Animation:
    """Frames of an orbit, each drawn when it is asked for.  Shows itself in a notebook, as a GIF.

    Attributes
    ----------
    cameras : list of Camera
        Of the frames.
    fps : float
        Frames in a second.
    loops : int
        How often a GIF or a PNG is shown, 0 = without end.
    notes : tuple of str
        As `Picture` has them.
    """

    def __init__(self, scene: Scene, cameras: List[Camera], fps: float, loops: int, notes: Any = ()) -> None:
        self._scene, self.cameras, self.fps, self.loops, self.notes = scene, cameras, fps, loops, tuple(notes)

    def __len__(self) -> int:
        return len(self.cameras)

    def __getitem__(self, number: int) -> Picture:
        camera = self.cameras[number]
        return Picture(self._scene, self._scene.draw(camera), camera, self.notes)

    def images(self, progress: Progress = None) -> Iterator[Array]:
        """The frames one by one: straight RGBA, uint8 (height, width, 4), without section and scale bar."""
        with CallReport(progress).stage("frames", "drawing frames") as stage:
            for camera in self.cameras:
                yield self._scene.draw(camera).image()
                if stage.bar is not None:
                    stage.bar.update(1 / len(self))

    def save(self, path: Union[str, "os.PathLike[str]"], *, progress: Progress = None) -> None:
        """Draw all frames and write them.

        Parameters
        ----------
        path : path
            Ends in .gif, .png or .apng (an animated PNG), .mp4 (by the program ffmpeg); or has a number, such as
            "frame-%03d.png": a picture for each frame, from 0.
        progress
            As in `draw`.

        Raises
        ------
        ValueError
            For an ending that is none of these.
        OSError
            If ffmpeg is not there, or fails.
        """
        _movies.check_movie(path, self.fps)
        _movies.write(path, self.images(progress), self.fps, self.loops, self._scene.style.paper)

    def _repr_html_(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            self.save(Path(folder) / "orbit.gif")
            data = base64.b64encode((Path(folder) / "orbit.gif").read_bytes()).decode()
        return f'<img src="data:image/gif;base64,{data}" alt="{len(self)} frames of an orbit"/>'

    def __repr__(self) -> str:
        width, height = self._scene.camera.size
        return f"<hrbfnpr.Animation {len(self)} frames of {width}x{height}, {self.fps:g} in a second>"


def animate(
    source: Any,
    path: Union[None, str, "os.PathLike[str]"] = None,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    frames: int = 36,
    fps: float = 12.0,
    turn: float = 360.0,
    loops: int = 0,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    **options: Any,
) -> Animation:
    """A turntable: the camera goes around what is drawn.

    The model is fitted, its marks are placed and its lines are looked for once; one renderer draws all frames, so that
    lines keep their numbers, and wobble the same, from one frame to the next.  The picture has room for the whole turn.

    Parameters
    ----------
    source, style, camera, progress, context, **options
        As in `draw`; `size` is 480 by default.  A camera, or `eye`, is that of the first frame.
    path : path, optional
        Where the frames go, as in `Animation.save`; nowhere yet if omitted.
    frames : int
    fps : float
        Frames in a second.
    turn : float
        Degrees about the up axis, through the middle of the model.  After a whole turn the first frame follows the last
        as any other; a part of one ends with its last frame.
    loops : int
        How often a GIF or a PNG is shown, 0 = without end.

    Examples
    --------
    >>> hrbfnpr.animate("bunny.ply", "bunny.gif", "hatch", frames=48)
    """
    if frames < 1:
        raise ValueError(f"frames must be at least 1, not {frames}")
    _movies.check_movie("any.gif" if path is None else path, fps)
    report = CallReport(progress)
    scene = turntable_of(source, style, frames, turn, camera, context, {"size": SIZE, **options}, report)
    made = Animation(scene, scene.orbit(frames, turn), fps, loops, report.notes)
    if path is not None:
        made.save(path, progress=report.told)
    return made


def turntable_of(
    source: Any, style: Any, frames: int, turn: float, camera: Optional[Camera], context: Optional[Context], options: Any,
    report: CallReport,
) -> Scene:  # fmt: skip
    """What is drawn, by a camera with room for the whole turn; its warnings are raised."""
    scene = asked(source, style, options, camera, context, report, turn=(turn, frames))
    scene.draw(report=report)  # says if it would be blank
    report.finish()
    return scene
