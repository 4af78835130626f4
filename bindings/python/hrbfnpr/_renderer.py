"""Drawing point sets: pixels and vertex arrays."""
from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Any, Iterable, List, Optional, Sequence, Tuple, Union

from ._arrays import Array, block_in, matrix_in, new_array, output
from ._callbacks import CallbackState, check
from ._camera import Camera
from ._context import Context, resolve
from ._drawing import Drawing
from ._errors import new_error, new_struct
from ._handles import Owner, own
from ._library import ffi, lib
from ._model import Model
from ._names import FORMATS, number_of
from ._numpy import np
from ._point_set import PointSet
from ._structs import read_struct
from ._style import Style
from ._vertices import layout_of, vertex_array

Items = Union[PointSet, "Item", Tuple[PointSet, Style], Iterable[Any]]


@dataclass(frozen=True)
class FrameInfo:
    """What a frame did.

    Attributes
    ----------
    marks, outside : int
        Marks of the groups that the styles use, and those outside the frustum.
    front, back, silhouette : int
        Those inside, by class.
    shown : int
        Marks drawn as ink.
    dropped_tone, dropped_depth, dropped_zoom, dropped_hidden : int
        Marks that are not shown, by reason.
    painted : int
        Discs of paper.
    culled : int
        Marks of no class: no tone or contour could show them.  Only by sheets.
    nanoseconds_classify, nanoseconds_visibility, nanoseconds_sort, nanoseconds_draw : int
    scratch_bytes : int
    """

    marks: int
    outside: int
    front: int
    back: int
    silhouette: int
    shown: int
    dropped_tone: int
    dropped_depth: int
    dropped_zoom: int
    dropped_hidden: int
    painted: int
    culled: int
    nanoseconds_classify: int
    nanoseconds_visibility: int
    nanoseconds_sort: int
    nanoseconds_draw: int
    scratch_bytes: int


@dataclass
class Item:
    """One thing to draw.

    Attributes
    ----------
    point_set : PointSet
    style : Style, optional
        The library's default style if None.
    transform : array of float, shape (4, 4), optional
        Object to world, affine, invertible; the identity if None.
    model : Model, optional
        The surface that the marks lie on.  With the visibility "sheets", what hides a mark is then
        found by casting a ray from it to the eye: exact, but some 10 microseconds a mark drawn.
    """

    point_set: PointSet
    style: Optional[Style] = None
    transform: Optional[Array] = None
    model: Optional[Model] = None


def _as_items(items: Items) -> List[Item]:
    if isinstance(items, Item):
        return [items]
    if isinstance(items, PointSet):
        return [Item(items)]
    if isinstance(items, tuple) and len(items) == 2 and isinstance(items[1], Style):
        return [Item(*items)]
    parts: Iterable[Any] = items
    return [one for part in parts for one in _as_items(part)]


def _image(pixels: Array, format: str) -> Any:
    """A hrbfnpr_image on an array of shape (height, width, 4)."""
    image = new_struct("hrbfnpr_image")
    image.format = number_of("format", FORMATS, format)
    image.height, image.width = pixels.shape[0], pixels.shape[1]
    if np is not None and isinstance(pixels, np.ndarray):
        image.pixels = ffi.cast("void *", pixels.__array_interface__["data"][0])
        image.row_stride = pixels.strides[0]
    else:
        image.pixels = ffi.cast("void *", ffi.from_buffer(pixels))
    return image


def _check_pixels(out: Any, size: Optional[Tuple[int, int]]) -> Array:
    out = np.asarray(out) if np is not None else memoryview(out)
    code = out.dtype.str[1:] if np is not None else out.format
    if code not in ("u1", "B") or len(out.shape) != 3 or out.shape[2] != 4 or 0 in out.shape:
        raise ValueError("out must be a uint8 array of the shape (height, width, 4)")
    if size is not None and (out.shape[1], out.shape[0]) != tuple(size):
        raise ValueError(f"out has {out.shape[1]} x {out.shape[0]} pixels, but size asks for {size[0]} x {size[1]}")
    packed_rows = out.strides[1:] == (4, 1) if np is not None else out.c_contiguous
    writeable = out.flags.writeable if np is not None else not out.readonly
    if not packed_rows or not writeable:
        raise ValueError("out must be writable and the pixels of a row side by side")
    return out


class Renderer(Owner):
    """Draws point sets with a camera [NPAR 6].

    It keeps its scratch memory from frame to frame.  Calls from several threads wait for each
    other: give each thread a renderer of its own.

    Parameters
    ----------
    context : Context, optional
        The default context if omitted.

    Examples
    --------
    >>> style = hrbfnpr.Style("contour-and-stipple")
    >>> marks = hrbfnpr.PointSet.generate(model, style.groups)
    >>> image = hrbfnpr.Renderer().draw((marks, style), hrbfnpr.Camera.fit(marks))
    """

    def __init__(self, *, context: Optional[Context] = None) -> None:
        context = resolve(context)
        out, error = ffi.new("hrbfnpr_renderer **"), new_error()
        check(lib.hrbfnpr_renderer_create(context._handle, out, error), error)
        super().__init__(own(out[0], lib.hrbfnpr_renderer_release, context))
        self._lock = threading.RLock()

    def prepare(self, items: Items, camera: Camera) -> FrameInfo:
        """Classify, shade and order the marks of a frame; `draw` and `vertices` do it themselves.

        Raises
        ------
        InvalidArgumentError
            For a camera without a viewport, a singular transform, or styles of different paper or
            visibility.
        CallbackError
            If a tone function or the function of an item's model raised.
        """
        chosen = _as_items(items)
        structs = ffi.new("hrbfnpr_item[]", max(len(chosen), 1))
        keep: List[Any] = []
        states: List[Optional[CallbackState]] = []
        functions: List[CallbackState] = []  # of the models
        for item, struct in zip(chosen, structs):
            check(lib.hrbfnpr_item_init(ffi.addressof(struct), ffi.sizeof("hrbfnpr_item")), None)
            struct.point_set = item.point_set._handle
            keep.append(struct.point_set)
            if item.style is not None:
                struct.style, state, kept = item.style._prepared()
                states.append(state)
                keep.append(kept)
            if item.model is not None:
                struct.model = item.model._handle
                keep.append(struct.model)
                if item.model._function is not None:
                    functions.append(item.model._function)
            if item.transform is not None:
                struct.transform = matrix_in("transform", item.transform)
        info, error = new_struct("hrbfnpr_frame_info"), new_error()
        with self._lock:
            size = ffi.sizeof("hrbfnpr_item")
            status = lib.hrbfnpr_renderer_prepare(
                self._handle, structs, len(chosen), size, camera._struct, info, error
            )
        del keep
        raised = next((function for function in functions if function.exception is not None), None)
        check(status, error, *states, shared=raised)
        return read_struct(FrameInfo, info)

    def draw(
        self,
        items: Items,
        camera: Camera,
        size: Optional[Tuple[int, int]] = None,
        out: Optional[Array] = None,
        *,
        format: str = "rgba8",
        over: bool = False,
        linear_light: bool = False,
        host_depth: Optional[Array] = None,
        depth: Optional[Array] = None,
        id: Optional[Array] = None,
        class_: Optional[Array] = None,
    ) -> Array:
        """Draw a frame.

        Parameters
        ----------
        items : PointSet, (PointSet, Style), Item, or an iterable of these
        camera : Camera
        size : (width, height), optional
            Of the image; by default it just holds the camera's viewport.
        out : array of uint8, shape (height, width, 4), optional
            The image to draw into, for instance a mapped texture; rows may have any stride.
        format : {"rgba8", "bgra8", "rgba8_premultiplied", "bgra8_premultiplied"}
        over : bool
            Lay the drawing over the image's contents; wants a style with transparent paper.
        linear_light : bool
            Blend in linear light (sRGB decoded), not in encoded values.
        host_depth : array of float32, shape (height, width), optional
            Depth buffer of the host's scene, in the camera's convention: hides marks behind it.
        depth, id, class_ : arrays, shape (height, width), optional
            To be filled: float32 depth of the nearest surface; uint32 1 + number of the nearest
            mark, 0 = none; uint8 or uint32 class (`hrbfnpr.CLASSES`).

        Returns
        -------
        array of uint8, shape (height, width, 4)
            `out`, or a new array.
        """
        width, height = camera.size if size is None else size
        if out is None and (width <= 0 or height <= 0):
            raise ValueError(f"size must be positive, not {width} x {height}")
        pixels = new_array((height, width, 4), "B") if out is None else _check_pixels(out, size)
        shape = tuple(pixels.shape[:2])
        image = _image(pixels, format)
        desc = new_struct("hrbfnpr_draw_desc")
        for flag, wanted in (("OVER", over), ("LINEAR_LIGHT", linear_light)):
            if wanted:
                desc.flags |= ffi.integer_const(f"HRBFNPR_DRAW_{flag}")
        keep: List[Any] = []
        if host_depth is not None:
            block = block_in("host_depth", host_depth, 1, "f")
            if block.shape != shape:
                raise ValueError(f"host_depth must have the shape {shape}, not {block.shape}")
            keep.append(block.fill(desc.host_depth))
        for name, target, code in (("depth", depth, "f"), ("id", id, "I"), ("class_", class_, "B")):
            if target is not None:
                _, view = output(name, target, shape, 1, code)
                keep.append(view)
                setattr(desc, name, view[0])
        error = new_error()
        with self._lock:
            self.prepare(items, camera)
            check(lib.hrbfnpr_renderer_draw_image(self._handle, image, desc, error), error)
        del keep
        return pixels if out is None else out

    def drawing(
        self,
        items: Items,
        camera: Camera,
        size: Optional[Tuple[int, int]] = None,
        *,
        depth: bool = False,
        id: bool = False,
        class_: bool = False,
        **options: Any,
    ) -> Drawing:
        """Draw a frame and keep what is known of it: shows itself in a notebook, saves itself.

        Parameters
        ----------
        items, camera, size
            As in `draw`.
        depth, id, class_ : bool
            Which outputs to make beside the image.
        **options
            `over`, `linear_light` and `host_depth` of `draw`.
        """
        width, height = camera.size if size is None else size
        wanted = (("depth", depth, "f"), ("id", id, "I"), ("class_", class_, "B"))
        outputs = {name: new_array((height, width), code) for name, want, code in wanted if want}
        with self._lock:
            image = self.draw(items, camera, size, **outputs, **options)
            info = self.info
        return Drawing(image, info=info, **outputs)

    def vertices(
        self,
        items: Items,
        camera: Camera,
        attributes: Sequence[str] = ("position", "radius", "color", "is_paper"),
    ) -> Array:
        """The marks of a frame as points, far to near: discs of paper and of ink.

        Painted in this order as round points with "source over" blending they give the picture of
        `draw`.

        Parameters
        ----------
        items, camera
            As in `draw`.
        attributes : sequence of str
            Of "position" (3 float32), "window" (pixel x, y and depth: 3 float32), "radius" (pixels:
            float32), "color" (straight RGBA: 4 uint8), "normal", "direction" (3 float32), "id"
            (uint32), "class" (uint8) and "is_paper" (uint8).

        Returns
        -------
        structured array, shape (n,)
            With the attributes as fields; without NumPy a memoryview of bytes, shape (n, stride).
        """
        layout, fields = layout_of(attributes)
        error, count = new_error(), ffi.new("int64_t *")
        with self._lock:
            self.prepare(items, camera)
            check(lib.hrbfnpr_renderer_vertex_bound(self._handle, count, error), error)
            array, address = vertex_array(count[0], layout, fields)
            status = lib.hrbfnpr_renderer_write_vertices(self._handle, layout, address, count[0], count, error)
            check(status, error)
        return array[: count[0]]

    @property
    def info(self) -> FrameInfo:
        """What the last frame did."""
        info, error = new_struct("hrbfnpr_frame_info"), new_error()
        with self._lock:
            check(lib.hrbfnpr_renderer_get_info(self._handle, info, error), error)
        return read_struct(FrameInfo, info)
