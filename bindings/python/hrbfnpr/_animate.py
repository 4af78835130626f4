# SPDX-License-Identifier: MIT
"""Turntables: the camera goes around the model.  This module needs NumPy and Pillow."""
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

SIZE = 480  # longer side, in pixels


class Animation:
    """The frames of a turntable, as `animate` makes them.

    A frame is drawn when it is asked for: ``animation[0]`` is a `Picture`, and ``len(animation)`` the number of frames.
    In a notebook, an animation shows itself as a GIF.

    Attributes
    ----------
    cameras : list of Camera
        The camera of each frame.
    fps : float
        Frames per second.
    loops : int
        How often a GIF or an animated PNG is played; 0 = without end.
    notes : tuple of str
        Remarks on the drawing, as in `Picture`.
    """

    def __init__(self, scene: Scene, cameras: List[Camera], fps: float, loops: int, notes: Any = ()) -> None:
        self._scene, self.cameras, self.fps, self.loops, self.notes = scene, cameras, fps, loops, tuple(notes)

    def __len__(self) -> int:
        return len(self.cameras)

    def __getitem__(self, number: int) -> Picture:
        camera = self.cameras[number]
        return Picture(self._scene, self._scene.draw(camera), camera, self.notes)

    def images(self, progress: Progress = None) -> Iterator[Array]:
        """Draw the frames one by one, as straight RGBA, uint8 (height, width, 4), without section and scale bar."""
        with CallReport(progress).stage("frames", "drawing frames") as stage:
            for camera in self.cameras:
                yield self._scene.draw(camera).image()
                if stage.bar is not None:
                    stage.bar.update(1 / len(self))

    def save(self, path: Union[str, "os.PathLike[str]"], *, progress: Progress = None) -> None:
        """Draw all frames and write them to one or several files.

        Parameters
        ----------
        path : path
            Its ending chooses the format: .gif, .png or .apng (an animated PNG), or .mp4 (which needs the program
            ffmpeg).  A name with a number, such as "frame-%03d.png", writes one picture for each frame, numbered from 0.
        progress : callable, tqdm bar or True, optional
            As in `draw`.

        Raises
        ------
        ValueError
            If the ending is not one of these, or the format does not allow this number of frames per second.
        OSError
            If ffmpeg is not installed or fails, or a file cannot be written.
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
    """Draw a turntable: the camera goes around the model.

    The model is fitted, its marks are placed and its lines are found once.  One renderer draws all frames, so that lines
    keep their numbers and their wobble from frame to frame.  The picture has room for the whole turn.

    Parameters
    ----------
    source, style, camera, progress, context, **options
        As in `draw`, except that `size` is 480 by default.  A given camera, or `eye`, is that of the first frame.
    path : path, optional
        The file to write, as in `Animation.save`; None: no file.
    frames : int
        Number of frames, at least 1.
    fps : float
        Frames per second, above 0 and at most 1000.
    turn : float
        Angle in degrees by which the camera turns about the up axis, through the middle of the model.  With a whole turn,
        the last frame leads on to the first.  With a part of a turn, the last frame is at its end.
    loops : int
        How often a GIF or an animated PNG is played; 0 = without end.

    Returns
    -------
    Animation
        The frames.

    Raises
    ------
    ValueError
        If `frames` or `fps` is out of its range, or for the reasons of `draw` and `Animation.save`.

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
    """The scene of a turntable, with a camera that has room for the whole turn.  Its warnings are raised."""
    scene = asked(source, style, options, camera, context, report, turn=(turn, frames))
    scene.draw(report=report)  # warns if the picture would be blank
    report.finish()
    return scene
