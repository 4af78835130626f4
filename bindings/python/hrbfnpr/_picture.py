# SPDX-License-Identifier: MIT
"""Pictures, the results of `hrbfnpr.draw`.  Needs NumPy."""
from __future__ import annotations

import io
import os
from typing import Any, BinaryIO, Mapping, Optional, Tuple, Union

from . import _pictures
from ._arrays import Array
from ._camera import Camera
from ._context import Context
from ._drawing import Drawing
from ._line_set import LineSet
from ._model import Model
from ._names import PRESETS
from ._page import format_of
from ._point_set import PointSet
from ._report import CallReport, Note, Progress
from ._request import Options, chosen, options_of
from ._scene import Scene
from ._sources import scene_of
from ._style import Style

View = Tuple[Any, Optional[float], Optional[float]]
"""Direction, azimuth and elevation of a camera; None for those that the picture was made with."""
_DEFAULT_ANGLES = 30.0, 20.0  # azimuth and elevation, in degrees


class Picture:
    """Result of `draw`: a drawing, and the model, marks and lines that it shows.

    In a notebook, a picture shows itself.

    Attributes
    ----------
    drawing : Drawing
        The drawing.
    camera : Camera
        The camera of the drawing.
    notes : tuple of Note
        Choices and repairs: sentences, each with a `code`, a `severity` and `figures`.
    """

    def __init__(
        self, scene: Scene, drawing: Drawing, camera: Camera, notes: Tuple[Note, ...] = (), view: Optional[View] = None
    ) -> None:  # fmt: skip
        self._scene, self._view = scene, view or (None, None, None)
        self.drawing, self.camera, self.notes = drawing, camera, notes

    @property
    def model(self) -> Optional[Model]:
        """The surface, or the largest one if parts of a mesh were fitted separately; None for saved marks."""
        return self._scene.model

    @property
    def marks(self) -> PointSet:
        """The marks on the surface, or on the largest one if parts of a mesh were fitted separately.

        Without ``keep_marks=True`` they are only those that this camera and style need.  They cannot be saved, and no
        other camera can draw them.
        """
        marks = self._scene.parts[0].marks
        assert marks is not None
        return marks

    @property
    def line_set(self) -> Optional[LineSet]:
        """The line set of that surface; None without lines."""
        return self._scene.parts[0].line_set

    @property
    def style(self) -> Style:
        """The style of the drawing, with marks sized for the picture; a copy."""
        return self._scene.style

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height of the drawing, in pixels.  A section or a scale bar makes the image larger."""
        return self.drawing.size

    @property
    def image(self) -> Array:
        """The pixels, straight RGBA: a new uint8 array of the shape (height, width, 4)."""
        return self._scene.image(self.drawing, self.camera)

    @property
    def angles(self) -> Tuple[float, float]:
        """Azimuth and elevation of the view, in degrees: those that were given, or else chosen."""
        found = {note.code: note.figures for note in self.notes if note.code.startswith("seen_from_")}
        usual = (next(iter(found.values()))[0], 0.0 if "seen_from_camera" in found else _DEFAULT_ANGLES[1]) if found else _DEFAULT_ANGLES
        options = self._scene.options
        azimuth, elevation = (self._view[i] if self._view[i] is not None else options.get(name)
                              for i, name in ((1, "azimuth"), (2, "elevation")))  # fmt: skip
        return usual[0] if azimuth is None else azimuth, usual[1] if elevation is None else elevation

    def seen(
        self,
        azimuth: Optional[float] = None,
        elevation: Optional[float] = None,
        *,
        direction: Optional[Any] = None,
        camera: Optional[Camera] = None,
    ) -> Picture:
        """Draw the same model, marks and lines from another side.  Arguments that are not given keep their values.

        Parameters
        ----------
        azimuth, elevation : float, optional
            The angles of the view in degrees, as in `draw`.
        direction : sequence of float, optional
            The direction from the eye into the scene; it replaces the angles.
        camera : Camera, optional
            The camera; it replaces all others.

        Returns
        -------
        Picture
            A new picture.
        """
        view = self._view
        if camera is None and (direction is not None or azimuth is not None or elevation is not None):
            view = direction, view[1] if azimuth is None else azimuth, view[2] if elevation is None else elevation
            camera = self._scene.look(*view)
        camera = camera or self.camera
        return Picture(self._scene, self._scene.draw(camera), camera, self.notes, view)

    def restyled(self, style: Union[str, Style]) -> Picture:
        """Draw the same surface from the same side in another style.  Marks are placed, and lines are found, again.

        Parameters
        ----------
        style : str or Style
            As in `draw`.

        Returns
        -------
        Picture
            A new picture.
        """
        options, report = self._scene.options, CallReport()
        scene = self._scene.restyled(options, checked_style(style, options), report, camera=self.camera)
        drawing = scene.draw(report=report)
        report.finish()
        return Picture(scene, drawing, self.camera, tuple(report.notes), self._view)

    def to_pil(self) -> Any:
        """Return the image as a PIL.Image.  Needs Pillow."""
        return _pictures.to_pil(self.image)

    def to_png(self) -> bytes:
        """Return the bytes of a PNG file.  Needs Pillow."""
        buffer = io.BytesIO()
        _pictures.save(self.to_pil(), buffer, "PNG")
        return buffer.getvalue()

    def save(self, target: Union[str, "os.PathLike[str]", BinaryIO], format: Optional[str] = None) -> None:
        """Write the picture to a file, as pixels or as vectors.

        A file is written whole or not at all.

        Parameters
        ----------
        target : path or binary file object
            Where to write.  Paths that end in .svg, .pdf, .hpgl, .gcode or .dxf get vectors.
        format : str, optional
            As in `Drawing.save`; by default the path's ending chooses it, and PNG is used for file objects.
        """
        if format is not None and format.upper() not in _formats_of_pillow():
            self.drawing.save(target, format)
        elif format is not None or format_of(target) is None:
            _pictures.save(self.to_pil(), target, format or (None if isinstance(target, (str, os.PathLike)) else "PNG"))
        else:
            report = CallReport()
            self._scene.write(target, self.drawing, self.camera, report)
            report.finish()

    def _repr_png_(self) -> bytes:
        return self.to_png()

    def _repr_svg_(self) -> Optional[str]:
        return None if self._scene.is_plate(self.drawing, self.camera) else self.drawing._repr_svg_()

    def __repr__(self) -> str:
        width, height = self.size
        return f"<hrbfnpr.Picture {self._scene.preset}, {width}x{height}, {self._scene.info.marks} marks>"


def _formats_of_pillow() -> Any:
    from PIL import Image

    Image.init()
    return Image.SAVE


def checked_style(style: Any, options: Options) -> Union[str, Style]:
    """The name of a named style, or a copy of a `Style`."""
    if not isinstance(style, Style):
        return chosen("style", str(style), PRESETS)
    if "mark_radius" in options:
        raise ValueError("mark_radius is for named styles: set the radius of each layer of a Style")
    return style.copy()


def asked(
    source: Any, style: Any, options: Mapping[str, Any], camera: Optional[Camera], context: Optional[Context],
    report: CallReport, **more: Any,
) -> Scene:  # fmt: skip
    """The scene of a source, with options as values of Python."""
    read = options_of(options)
    wanted = checked_style(style, read)
    if camera is not None and not isinstance(camera, Camera):
        raise TypeError(f"camera must be a hrbfnpr.Camera, not {type(camera).__name__}")
    return scene_of(source, wanted, read, camera, context, report, **more)


def draw_of(
    source: Any, style: Any, options: Mapping[str, Any], camera: Optional[Camera], progress: Progress,
    context: Optional[Context], fields: Optional[Mapping[str, Any]] = None,
) -> Picture:  # fmt: skip
    """The work of `draw`."""
    report = CallReport(progress)
    scene = asked(source, style, options, camera, context, report, fields=fields)
    drawing = scene.draw(report=report)
    report.finish()
    return Picture(scene, drawing, scene.camera, tuple(report.notes))
