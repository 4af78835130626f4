# SPDX-License-Identifier: MIT
"""Scenes: sources that any number of cameras can draw.  A scene is a picture (hrbfnpr_picture) of the library."""
from __future__ import annotations

import math
import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Callable, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _records, _streams
from ._arrays import Array
from ._callbacks import CallbackState, callback, check
from ._camera import Camera
from ._context import Context
from ._drawing import Drawing
from ._errors import Error, OutOfMemoryError, new_error, new_list, new_struct
from ._handles import Owner, own
from ._images import image_for
from ._library import ffi, lib
from ._line_set import LineSet
from ._model import Model
from ._names import PRESETS
from ._operation import running
from ._page import format_of
from ._point_set import PointSet
from ._records import read
from ._report import Reporter
from ._request import Options, describe, describe_page, fill_source, in_names
from ._style import Style
from ._values import words_of

if TYPE_CHECKING:
    from ._records import PageInfo

Source = Union[Any, Model, PointSet, Tuple[Model, PointSet]]
"""A Shape, a model, a point set, or a model with its point set."""


class BlankError(ValueError):
    """A drawing shows hardly anything.  The message says why."""


class Part(NamedTuple):
    """A surface that is drawn, with its marks and lines; None for a missing one."""

    model: Optional[Model]
    marks: Optional[PointSet]
    line_set: Optional[LineSet]


def _may_use_fields(options: Options, style: Any, settings: Any) -> bool:
    """Whether a picture may need values of the points.  They are not passed otherwise, because scans have many."""
    changes = [path for path, _ in options.get("set", ())]
    return settings is not None or isinstance(style, Style) or "field" in options or any("_field" in path for path in changes)


class _Listener:
    """Receives the events of pictures and passes them to the reporter of the running call."""

    def __init__(self) -> None:
        self.state = CallbackState(self.hear)
        self.user = self.state.new_handle()
        self.report: Optional[Reporter] = None
        self.last_stage = 0
        self.of_options = False  # whether the last error was about the descriptor

    def hear(self, event: Any) -> None:
        self.last_stage = max(self.last_stage, event.stage)
        if self.report is not None and self.state.exception is None:
            self.report.take(event)

    def stop(self, fraction: float) -> None:
        """The progress function of an operation: an exception of a listener ends the call."""
        if self.state.exception is not None:
            raise self.state.exception

    @contextmanager
    def telling(self, report: Reporter, context: Any) -> Iterator[Callable[..., None]]:
        """Yields a function that makes one call with an operation and checks its status."""
        self.report = report
        report.failure = None
        try:
            with running(None, self.stop, context) as (operation, state):
                yield lambda call, *states: self._check(call(operation), report, state, *states)
        finally:
            self.report = None
            report.fail()

    def _check(self, result: Tuple[int, Any], report: Reporter, *states: Any) -> None:
        status, error = result
        raised, self.state.exception = self.state.exception, None
        if raised is not None:  # an exception of a progress function
            raise raised
        try:
            check(status, error, *states)
        except Error as failed:
            failure = report.failure
            if failure is not None and failure.code == "blank":
                raise BlankError(str(failure)) from None
            as_option = report.wording == lib.HRBFNPR_WORDING_OPTIONS
            text = in_names(str(failed) if failure is None else str(failure), as_option)
            self.of_options = str(failed).startswith(("picture_desc.", "changes["))
            if text == str(failed):
                raise
            raise type(failed)(text, failed.status) from None


@callback("void(void *, const hrbfnpr_picture_event *)", failure=None)
def on_event(user: Any, event: Any) -> None:
    ffi.from_handle(user).function(event)


class Scene(Owner):
    """A picture of the library, which holds its surfaces, marks and lines.

    Attributes
    ----------
    options, style_given
        The options and the style with which it was made.
    """

    def __init__(
        self, handle: Any, context: Context, listener: _Listener, options: Options, style: Any, states: List[Any], *keep: Any
    ) -> None:  # fmt: skip
        super().__init__(own(handle, lib.hrbfnpr_picture_release, listener.user, *keep))
        self._context, self._listener, self._states = context, listener, states
        self._lock = threading.RLock()
        self.options, self.style_given = options, style
        self.sources: Sequence[Source] = ()
        self._shared: List[Any] = []  # the objects of a scene that shares its surfaces with this one
        self._parts: Optional[Tuple[Part, ...]] = None

    # ---- Making

    @classmethod
    def create(
        cls, sources: Sequence[Source], options: Options, style: Any, context: Context, report: Reporter, *,
        camera: Optional[Camera] = None, flags: Sequence[str] = (), name: Optional[str] = None, settings: Any = None,
        turn: Optional[Tuple[float, int]] = None, path: Optional[str] = None,
        with_fields: bool = False,
    ) -> Scene:  # fmt: skip
        """Fit the surfaces, place marks and find lines.

        Parameters
        ----------
        style : str, Style or None
            None: the style of the settings, or the default.
        name : str, optional
            The name for titles and metadata.
        settings : Settings, optional
            Settings from a file.
        turn : (degrees, frames), optional
            An orbit for which the picture has room.
        path : str, optional
            The file that errors about the contents name.
        with_fields : bool
            Whether the picture gets the values of points even if neither the options nor the style may name them.
        """
        desc, keep = describe(options, flags)
        structs = new_list("hrbfnpr_picture_source", len(sources))
        for struct, source in zip(structs, sources):
            keep.append(fill_source(struct, source, name, with_fields or _may_use_fields(options, style, settings)))
        desc.sources, desc.source_count = structs, len(sources)
        if settings is not None:
            desc.settings = settings._handle
        if turn is not None:
            desc.turn, desc.turn_frames = turn
        listener = _Listener()
        functions = [part._function for source in sources for part in _parts_of(source) if isinstance(part, Model)]
        handle = context._handle
        try:
            made = cls._made(
                lambda *rest: lib.hrbfnpr_picture_create(handle, desc, *rest),
                desc, keep, [structs, settings], options, style, camera, context, report, listener, functions)  # fmt: skip
        except (Error, ValueError) as error:
            # After the end of the surface was found, errors are about the options, not about the contents of the file.
            of_contents = path is not None and listener.last_stage < lib.HRBFNPR_STAGE_END and not listener.of_options
            if not of_contents or isinstance(error, (OutOfMemoryError, BlankError)):
                raise
            raise ValueError(f"{path}: {words_of(error)}") from error
        made.sources = tuple(sources)
        return made

    def restyled(
        self, options: Options, style: Any, report: Reporter, *, camera: Optional[Camera] = None, flags: Sequence[str] = ()
    ) -> Scene:  # fmt: skip
        """A scene of the same surfaces in another style, size or view."""
        desc, keep = describe(options, flags)
        handle = self._handle
        made = self._made(
            lambda *rest: lib.hrbfnpr_picture_restyle(handle, desc, *rest),
            desc, keep, [self], options, style, camera, self._context, report, _Listener(), [])  # fmt: skip
        made.sources, made._shared = self.sources, [one for part in self.parts for one in part if one is not None]
        return made

    @classmethod
    def _made(
        cls, call: Any, desc: Any, keep: List[Any], hold: List[Any], options: Options, style: Any,
        camera: Optional[Camera], context: Context, report: Reporter, listener: _Listener, functions: List[Any],
    ) -> Scene:  # fmt: skip
        desc.wording, desc.on_event, desc.event_user = report.wording, on_event, listener.user
        if camera is not None:
            desc.camera = camera._struct
        states: List[Any] = [function for function in functions if function is not None]
        if isinstance(style, Style):
            desc.style, state, kept = style._prepared()
            hold.append(kept)
            states += [] if state is None else [state]
            desc.preset = PRESETS.index(style.preset) if style.preset else desc.preset
        elif style is not None:
            name = ffi.new("char[]", style.encode())
            keep.append(name)
            desc.style_name = name
        out, error = ffi.new("hrbfnpr_picture **"), new_error()
        with listener.telling(report, context._handle) as checked:
            try:
                checked(lambda operation: (call(operation, out, error), error), *states)
            except BaseException:
                lib.hrbfnpr_picture_release(out[0])
                raise
        del keep
        return cls(out[0], context, listener, options, style, states, *hold)

    # ---- Looking at it

    def _get(self, what: str, *arguments: Any) -> Any:
        """A struct that a getter of the library fills."""
        struct, error = new_struct(f"hrbfnpr_{what}"), new_error()
        getter = getattr(lib, f"hrbfnpr_picture_get_{what.replace('picture_', '')}")
        check(getter(self._handle, *arguments, struct, error), error)
        return struct

    @property
    def info(self) -> Any:
        """The hrbfnpr_picture_info of the scene."""
        return self._get("picture_info")

    @property
    def parts(self) -> Tuple[Part, ...]:
        """The surfaces, the largest first."""
        if self._parts is None:
            self._parts = tuple(self._part(number) for number in range(self.info.parts))
        return self._parts

    def _part(self, number: int) -> Part:
        struct = self._get("picture_part", number)
        there = [part for source in self.sources for part in _parts_of(source)] + self._shared
        handles: List[Any] = []
        for kind, field in (("model", struct.model), ("point_set", struct.point_set), ("line_set", struct.line_set)):
            if field == ffi.NULL:
                handles.append(None)
                continue
            raw = ffi.cast(f"hrbfnpr_{kind} *", field)
            known = next((part for part in there if not part.closed and part._handle == raw), None)
            if known is None:
                getattr(lib, f"hrbfnpr_{kind}_retain")(raw)
                handle = own(raw, getattr(lib, f"hrbfnpr_{kind}_release"))
                known = {"model": Model, "point_set": PointSet}[kind](handle, self._context) if kind != "line_set" else (
                    LineSet._of(handle, handles[0], _is_curved(self.style)))  # fmt: skip
            handles.append(known)
        return Part(*handles)

    @property
    def model(self) -> Optional[Model]:
        """The surface, or the largest of several; None for saved marks."""
        return self.parts[0].model if self.parts else None

    @property
    def style(self) -> Style:
        """The style of the scene; a copy."""
        out, error = ffi.new("const hrbfnpr_style **"), new_error()
        check(lib.hrbfnpr_picture_get_style(self._handle, out, error), error)
        given = self.style_given
        return Style._from_struct(out[0], self.preset, given._tone if isinstance(given, Style) else None)

    @property
    def preset(self) -> str:
        """The name of the scene's named style."""
        return str(PRESETS[self.info.preset])

    @property
    def camera(self) -> Camera:
        """The planned camera."""
        return _camera_of(self._get("camera"))

    def look(self, direction: Any, azimuth: Optional[float], elevation: Optional[float]) -> Camera:
        """A camera that looks from another side; None: the planned direction or angle."""
        struct, error = new_struct("hrbfnpr_camera"), new_error()
        towards = ffi.NULL if direction is None else ffi.new("double[3]", [float(x) for x in direction])
        angles = (math.nan if angle is None else float(angle) for angle in (azimuth, elevation))
        check(lib.hrbfnpr_picture_look(self._handle, towards, *angles, struct, error), error)
        return _camera_of(struct)

    def orbit(self, frames: int, turn: float) -> List[Camera]:
        """The cameras of an orbit that starts at the planned camera."""
        cameras = []
        for angle in angles_of(frames, turn):
            struct, error = new_struct("hrbfnpr_camera"), new_error()
            check(lib.hrbfnpr_picture_orbit(self._handle, angle, struct, error), error)
            cameras.append(_camera_of(struct))
        return cameras

    # ---- Drawing

    def draw(self, camera: Optional[Camera] = None, report: Optional[Reporter] = None) -> Drawing:
        """The drawing without the parts of a plate.  With the planned camera, a blank drawing is an error."""
        seen_by = ffi.NULL if camera is None else camera._struct
        report = Reporter() if report is None else report
        out, error, handle = ffi.new("hrbfnpr_drawing **"), new_error(), self._handle
        with self._lock, self._listener.telling(report, self._context_handle) as checked:
            try:
                checked(lambda operation: (lib.hrbfnpr_picture_draw(handle, seen_by, operation, out, error), error),
                        *self._states)  # fmt: skip
            except BaseException:
                lib.hrbfnpr_drawing_release(out[0])
                raise
        drawn = own(out[0], lib.hrbfnpr_drawing_release, self._context)
        layers = [part.marks.layers for part in self.parts if part.marks is not None]
        return Drawing(drawn, (camera or self.camera).size, layers)

    @property
    def _context_handle(self) -> Any:
        return self._context._handle

    def plate_size(self, camera: Camera) -> Tuple[int, int]:
        """Size of the plate: the drawing with a section and a scale bar beside it."""
        size, error = ffi.new("int32_t[2]"), new_error()
        check(lib.hrbfnpr_picture_plate_size(self._handle, camera._struct, size, size + 1, error), error)
        return size[0], size[1]

    def image(self, drawing: Drawing, camera: Camera) -> Array:
        """The plate as straight RGBA, uint8 (height, width, 4)."""
        pixels, image = image_for("rgba8", None, self.plate_size(camera), drawing.size)
        error = new_error()
        status = lib.hrbfnpr_picture_rasterize(self._handle, drawing._handle, camera._struct, image, error)
        check(status, error)
        return pixels

    def is_plate(self, drawing: Drawing, camera: Camera) -> bool:
        """Whether the plate shows more than the drawing."""
        return self.plate_size(camera) != drawing.size

    def write(self, target: Any, drawing: Drawing, camera: Camera, report: Reporter, format: Optional[str] = None) -> PageInfo:
        """Write the plate as vectors, with the options of the page."""
        desc, keep = describe_page(self.options, format or format_of(target) or "svg")
        info = new_struct("hrbfnpr_page_info")
        arguments = drawing._handle, camera._struct, desc
        self._written(target, lib.hrbfnpr_picture_write, arguments, info, report)
        del keep
        return read(_records.PageInfo, info)

    def write_views(self, target: Any, desc: Any, report: Reporter) -> Any:
        """Write a sheet of views.  Returns a hrbfnpr_views_info."""
        info = new_struct("hrbfnpr_views_info")
        self._written(target, lib.hrbfnpr_picture_write_views, (desc,), info, report)
        return info

    def _written(self, target: Any, function: Any, arguments: Any, info: Any, report: Reporter) -> None:
        handle = self._handle

        def to_file(file: Any) -> None:
            error, state = new_error(), CallbackState(file.write)
            user = state.new_handle()
            with self._lock, self._listener.telling(report, self._context_handle) as checked:
                checked(lambda operation: (function(
                    handle, *arguments, _streams._on_write, user, info, operation, error), error), state)  # fmt: skip

        if isinstance(target, (str, bytes)) or hasattr(target, "__fspath__"):
            _streams.write_atomically(target, to_file)
        else:
            to_file(target)

    def write_settings(self, path: Any, report: Reporter) -> None:
        """Write the settings of the scene, for `Settings`.  A note says what the file does not hold."""
        self._listener.report = report
        try:
            _streams.save(lib.hrbfnpr_picture_write_settings, self._handle, path)
        finally:
            self._listener.report = None


class Settings(Owner):
    """Settings from a file that the viewer or `Scene.write_settings` wrote."""

    def __init__(self, path: Any, context: Context) -> None:
        out = ffi.new("hrbfnpr_settings **")
        with open(path, "rb") as file:
            _streams._stream_call(
                lambda user, error: int(lib.hrbfnpr_settings_load(context._handle, _streams._on_read, user, out, error)),
                file.read)  # fmt: skip
        super().__init__(own(out[0], lib.hrbfnpr_settings_release, context))


def angles_of(frames: int, turn: float) -> List[float]:
    """The angles of the frames of an orbit, from 0.

    In a whole turn, the first frame follows the last one.  In a part of a turn, the last frame is at its end.
    """
    whole = math.isclose(abs(turn) % 360, 0, abs_tol=1e-9) and turn != 0
    return [turn * i / (frames if whole else max(frames - 1, 1)) for i in range(frames)]


def _parts_of(source: Any) -> List[Any]:
    """The models and point sets of a source."""
    return [part for part in (source if isinstance(source, tuple) else (source,)) if isinstance(part, (Model, PointSet))]


def _is_curved(style: Style) -> bool:
    """Whether the lines of a style need curvatures."""
    return any(line.kind in ("suggestive_contour", "apparent_ridge", "isophote") for line in style.lines)


def _camera_of(struct: Any) -> Camera:
    camera = Camera()
    camera._struct[0] = struct[0]
    return camera
