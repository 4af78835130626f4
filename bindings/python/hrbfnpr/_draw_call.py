# SPDX-License-Identifier: MIT
"""A drawing of anything in one call.  Needs NumPy."""
from __future__ import annotations

import argparse
import io
import os
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO, Iterator, Optional, Tuple, Union

import numpy as np

from . import _pictures
from ._arrays import Array
from ._call_options import in_python, namespace, set_style
from ._call_report import CallReport, Progress
from ._camera import Camera
from ._context import Context
from ._drawing import Drawing
from ._errors import Error, OutOfMemoryError
from ._foreign import name_of, shape_of
from ._line_set import LineSet
from ._model import Model
from ._point_set import PointSet
from ._scene import Look, Scene, draw_scene, make_camera, set_scene
from ._style import Style
from .cli import _lines
from .cli._inputs import Loaded, load, of_made, of_shape
from .cli._values import words_of


class Picture:
    """What `draw` made: a drawing, and what it was made of.  Shows itself in a notebook.

    Attributes
    ----------
    drawing : Drawing
    camera : Camera
    notes : tuple of str
        What was chosen or repaired on the way.
    """

    def __init__(
        self,
        scene: Scene,
        drawing: Drawing,
        camera: Camera,
        notes: Tuple[str, ...] = (),
        view: Optional[argparse.Namespace] = None,
    ) -> None:
        self._scene = scene
        self._view = scene.arguments if view is None else view  # options of its camera
        self.drawing, self.camera, self.notes = drawing, camera, notes

    @property
    def model(self) -> Optional[Model]:
        """The surface, the largest where parts of a mesh are fitted apart; None of saved marks."""
        return self._scene.source if isinstance(self._scene.source, Model) else None

    @property
    def marks(self) -> PointSet:
        """The marks on that surface."""
        return self._scene.marks

    @property
    def line_set(self) -> Optional[LineSet]:
        """What its lines are drawn from; None without lines."""
        return self._scene.line_set

    @property
    def style(self) -> Style:
        """How it is drawn, with marks sized for the picture; a copy."""
        return self._scene.style.copy()

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height of the drawing, pixels; a section or a scale bar makes the image larger."""
        return self.drawing.size

    @property
    def image(self) -> Array:
        """The pixels: straight RGBA, a new uint8 array of the shape (height, width, 4)."""
        return self.drawing.image() if not self._scene.is_plate else np.array(self.to_pil().convert("RGBA"))

    def seen(
        self,
        azimuth: Optional[float] = None,
        elevation: Optional[float] = None,
        *,
        direction: Optional[Any] = None,
        camera: Optional[Camera] = None,
    ) -> Picture:
        """The same model, marks and lines from another side; what is not given stays.

        Parameters
        ----------
        azimuth, elevation : float, optional
            Degrees, as in `draw`.
        direction : sequence of float, optional
            From the eye into the scene, instead of these.
        camera : Camera, optional
            Instead of all of these.
        """
        scene, view = self._scene, argparse.Namespace(**vars(self._view))
        if camera is not None:
            view.own_camera = camera
        elif direction is not None or azimuth is not None or elevation is not None:
            view.own_camera = view.eye = None
            view.direction = direction
            view.azimuth = view.azimuth if azimuth is None else azimuth
            view.elevation = view.elevation if elevation is None else elevation
        seen_by = make_camera(view, scene.bounds, scene.places)
        return Picture(scene, scene.draw(seen_by), seen_by, self.notes, view)

    def restyled(self, style: Union[str, Style]) -> Picture:
        """The same surface from the same side in another style; marks are placed, and lines looked for, anew."""
        arguments = argparse.Namespace(**vars(self._scene.arguments))
        set_style(arguments, style)
        arguments.own_camera = self.camera
        report = CallReport()
        rest = tuple(Loaded(part.model, part.shape, arguments.up) for part in self._scene.rest)
        loaded = Loaded(self._scene.source, arguments.input_shape, arguments.up, rest)
        with said_in_python():
            scene = set_scene(arguments, loaded, self._scene.context, report)
            drawing = draw_scene(scene, report)
        report.finish()
        return Picture(scene, drawing, self.camera, tuple(report.notes), self._view)

    def to_pil(self) -> Any:
        """A PIL.Image.  Needs Pillow."""
        return self._scene.picture(self.drawing, self.camera)

    def to_png(self) -> bytes:
        """The bytes of a PNG file.  Needs Pillow."""
        buffer = io.BytesIO()
        _pictures.save(self.to_pil(), buffer, "PNG")
        return buffer.getvalue()

    def save(self, target: Union[str, "os.PathLike[str]", BinaryIO], format: Optional[str] = None) -> None:
        """Write a picture, or vectors where the path ends in .svg, .pdf, .hpgl or .gcode; paths atomically.

        Parameters
        ----------
        target : path or binary file object
        format : str, optional
            As in `Drawing.save`; by default as the path's ending says, or PNG.
        """
        if not isinstance(target, (str, os.PathLike)) or format is not None:
            if format is None or format.upper() in _pictures_formats():
                _pictures.save(self.to_pil(), target, format)
            else:
                self.drawing.save(target, format)
            return
        report = CallReport()
        self._scene.write(Path(target), self.drawing, self.camera, report)
        report.finish()

    def _repr_png_(self) -> bytes:
        return self.to_png()

    def _repr_svg_(self) -> Optional[str]:
        return None if self._scene.is_plate else self.drawing._repr_svg_()

    def __repr__(self) -> str:
        width, height = self.size
        return f"<hrbfnpr.Picture {self._scene.arguments.style}, {width}x{height}, {self._scene.mark_count} marks>"


def _pictures_formats() -> Any:
    from PIL import Image

    Image.init()
    return Image.SAVE


def draw(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    **options: Any,
) -> Picture:
    """Draw a file, arrays, or a mesh or cloud of another package, in one call.

    Parameters
    ----------
    source : path, arrays, Shape, Mesh, Model, PointSet, or a mesh or cloud of PyVista, trimesh or Open3D
        A path is that of any file that the command line reads.  Arrays are points of shape (n, 3), whose normals are
        found, (points, normals) with an array of floats, or (points, triangles) with an array of integers.
    style : str or Style
        A named style (`hrbfnpr.PRESETS`), whose marks are sized for the picture, or one that is used as it is.
    camera : Camera, optional
        By default one that sees all, from `azimuth` and `elevation` in degrees: 30, or another where that sees the back
        of an open surface, and 20.
    progress : callable, tqdm bar or True, optional
        Called with what is done and a fraction in [0, 1] of it; True makes a bar of tqdm's.
    context : Context, optional
        A new one if omitted, whose log becomes warnings.
    **options
        Any option of ``python3 -m hrbfnpr draw --help`` that is not about files, by its name with underscores, as
        Python's values: ``size=(800, 600)``, ``samples=2000``, ``lines=["contour", "ridges"]``, ``ink="#203040"``,
        ``marks={"stipples": 20000}``, ``flip=True``, ``set={"principal.ink": "#800000"}``.

    Returns
    -------
    Picture
        Shows itself in a notebook; ``save``, ``image``, ``seen`` from another side.

    Raises
    ------
    TypeError
        For a source or an option that is unknown.
    ValueError
        For a source that cannot be drawn, a value out of its range, and a picture that would be blank
        (``allow_blank=True`` lets it be).

    Warns
    -----
    DrawingWarning
        Where the command line prints a warning.

    Examples
    --------
    >>> hrbfnpr.draw("bunny.ply", "hatch", size=800).save("bunny.png")
    >>> hrbfnpr.draw((points, normals), azimuth=60, lines="contour,suggestive")
    """
    report = CallReport(progress)
    with said_in_python():
        scene = scene_of(source, style, camera, context, options, report)
        drawing = draw_scene(scene, report)
    for doubt in _lines.doubts(drawing.info):
        report.warn(doubt)
    report.finish()
    return Picture(scene, drawing, scene.camera, tuple(report.notes))


@contextmanager
def said_in_python() -> Iterator[None]:
    """Errors name the options as a call has them; what comes of odd numbers is said in words."""
    try:
        with np.errstate(all="ignore"):
            yield
    except ValueError as error:
        if isinstance(error, Error) or "--" not in str(error):
            raise
        raise type(error)(in_python(str(error))) from error


def scene_of(
    source: Any, style: Any, camera: Optional[Camera], context: Optional[Context], options: Any, report: CallReport,
    look: Look = make_camera,
) -> Scene:  # fmt: skip
    """What is drawn of a source with these options."""
    is_path = isinstance(source, (str, os.PathLike))
    arguments = namespace(style, camera, os.fspath(source) if is_path else name_of(source), options)
    if context is None:
        context = Context(log=report.logged, log_level="warning")
    return set_scene(arguments, _loaded(source, arguments, context, report), context, report, look)


def _loaded(source: Any, arguments: argparse.Namespace, context: Context, report: CallReport) -> Loaded:
    if isinstance(source, (Model, PointSet)):
        return of_made(source, arguments, context, report)
    if not isinstance(source, (str, os.PathLike)):
        return of_shape(shape_of(source), arguments, context, report)
    try:
        return load(Path(source), arguments, context, report)
    except OutOfMemoryError:
        raise
    except (Error, ValueError) as error:
        raise ValueError(f"{os.fspath(source)}: {words_of(error)}") from error
