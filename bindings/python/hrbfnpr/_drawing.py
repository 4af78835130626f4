# SPDX-License-Identifier: MIT
"""Drawings: pictures as values."""
from __future__ import annotations

import io
import os
from functools import partial
from typing import TYPE_CHECKING, Any, BinaryIO, ClassVar, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _images, _page, _pictures, _records
from ._arrays import Array, block_in, new_array, output, output_field
from ._callbacks import check
from ._errors import new_error, new_struct
from ._handles import Owner
from ._library import ffi, lib
from ._marks import MarkLayer
from ._names import CLASSES, LINE_KINDS, PAGE_FORMATS, PRIMITIVES, name_of, number_of
from ._numpy import np
from ._records import DrawingLayerFields, get, read
from ._vertices import layout_of, vertex_array

if TYPE_CHECKING:
    from ._records import DrawingInfo, MarkIdentity, PageInfo

_MOST_IN_NOTEBOOK = 20_000  # largest number of dots and strokes that a notebook shows as SVG


class Raster(NamedTuple):
    """Result of `Drawing.raster`: `image`, `depth`, `id` and `class_`, as in `Drawing.image`; None for unwanted arrays."""

    image: Array
    depth: Optional[Array]
    id: Optional[Array]
    class_: Optional[Array]


class Vertices(NamedTuple):
    """Result of `Drawing.vertices`: `vertices` and `indices`."""

    vertices: Array
    indices: Array


class MarkResults(NamedTuple):
    """Result of `Drawing.mark_results`: `shown`, `radius` and `opacity`, with one element for each mark."""

    shown: Array
    radius: Array
    opacity: Array


class DrawingLayerInfo(DrawingLayerFields):
    __doc__ = DrawingLayerFields.__doc__

    _lines: ClassVar[Any]  # a function without arguments, which each object has

    @property
    def polylines(self) -> List[Array]:
        """The strokes of the layer, far to near: float32 (n, 2) each, pixel x and y.  `Drawing.polylines` gives more."""
        return [np.array(line["window"][:, :2]) for line in self._lines()]


def _read_layer(struct: Any) -> DrawingLayerInfo:
    """A record from a filled hrbfnpr_drawing_layer_info."""
    of_lines = {"kind": name_of(LINE_KINDS, struct.kind)} if struct.layer < 0 else {}
    return read(DrawingLayerInfo, struct, **of_lines)


class Drawing(Owner):
    """Dots and strokes in window coordinates, as `Renderer.draw` makes them.

    A drawing never changes, and several threads may read it at the same time.  It shows itself in a notebook.
    """

    def __init__(self, handle: Any, size: Tuple[int, int], layers: Sequence[Tuple[MarkLayer, ...]]) -> None:
        super().__init__(handle)
        self._size = size
        self._marks = tuple(layers)  # the layers of marks of each item

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height of the smallest image that holds the camera's viewport, in pixels."""
        return self._size

    @property
    def info(self) -> DrawingInfo:
        """What the drawing holds, and what making it did."""
        return get(_records.DrawingInfo, lib.hrbfnpr_drawing_get_info, self._handle)

    @property
    def layers(self) -> Tuple[DrawingLayerInfo, ...]:
        """The layers of the drawing.  Each holds the ink of one layer of marks, of front marks or of contours, or of lines."""
        handle, result = self._handle, []
        info, error = new_struct("hrbfnpr_drawing_layer_info"), new_error()
        for number in range(self.info.layers):
            check(lib.hrbfnpr_drawing_get_layer_info(handle, number, info, error), error)
            layer = _read_layer(info)
            object.__setattr__(layer, "_lines", partial(self.polylines, number))
            result.append(layer)
        return tuple(result)

    def image(
        self,
        width: Optional[int] = None,
        height: Optional[int] = None,
        *,
        out: Optional[Array] = None,
        format: str = "rgba8",
        over: bool = False,
        linear_light: bool = False,
        host_depth: Optional[Array] = None,
        depth: Optional[Array] = None,
        id: Optional[Array] = None,
        class_: Optional[Array] = None,
    ) -> Array:
        """Draw into an array of pixels.

        Parameters
        ----------
        width, height : int, optional
            Size of the image in pixels; by default the `size` of the drawing.
        out : array of uint8 or float32, shape (height, width, 4) or (height, width), optional
            The image to draw into, such as a mapped texture.  It must have the type and shape of `format`; its rows may
            have any stride.  By default a new array.
        format : str
            "rgba8", "bgra8", "rgba8_premultiplied" or "bgra8_premultiplied": uint8 (height, width, 4).  "rgba32f" or
            "rgba32f_premultiplied": float32 in [0, 1] of this shape.  "coverage8": uint8 (height, width), the share of
            each pixel that ink covers, whatever its colour.
        over : bool
            True: lay the drawing over the contents of `out`.  This needs a style with transparent paper.
        linear_light : bool
            True: blend in linear light (sRGB decoded); False: blend encoded values.
        host_depth : array of float32, shape (height, width), optional
            The depth buffer of another scene, in the camera's depth convention.  Ink behind that scene is not drawn.
        depth : array of float32, shape (height, width), optional
            An array to fill with the depth of the nearest surface.
        id : array of uint32, shape (height, width), optional
            An array to fill with the identity of the nearest drawn mark; 0 = none (see `identify`).
        class_ : array of uint8 or uint32, shape (height, width), optional
            An array to fill with the class of that mark, a number of `hrbfnpr.CLASSES`.

        Returns
        -------
        array
            `out`, or the new array.

        Raises
        ------
        ValueError
            If an array has another shape, layout or type than needed.
        """
        if (width is None) != (height is None):
            raise TypeError("give both width and height, or neither")
        size = None if width is None or height is None else (width, height)
        pixels, image = _images.image_for(format, out, size, self._size)
        shape = tuple(pixels.shape[:2])
        desc = new_struct("hrbfnpr_raster_desc")
        for flag, wanted in (("OVER", over), ("LINEAR_LIGHT", linear_light)):
            if wanted:
                desc.flags |= ffi.integer_const(f"HRBFNPR_RASTER_{flag}")
        keep: List[Any] = []
        if host_depth is not None:
            block = block_in("host_depth", host_depth, 1, "f")
            if block.shape != shape:
                raise ValueError(f"host_depth must have the shape {shape}, not {block.shape}")
            keep.append(block.fill(desc.host_depth))
        for name, field, target, codes in (
            ("depth", "depth", depth, "f"), ("id", "id", id, "I"), ("class_", "mark_class", class_, "BI"),
        ):  # fmt: skip
            if target is not None:
                _, view = output(name, target, shape, 1, codes)
                keep.append(view)
                setattr(desc, field, view[0])
        error = new_error()
        check(lib.hrbfnpr_drawing_rasterize(self._handle, image, desc, error), error)
        del keep
        return pixels if out is None else out

    def raster(
        self,
        width: Optional[int] = None,
        height: Optional[int] = None,
        *,
        depth: bool = True,
        id: bool = True,
        class_: bool = True,
        **options: Any,
    ) -> Raster:
        """Draw the image, and the depth, identity and class of each pixel, as new arrays.

        Parameters
        ----------
        width, height : int, optional
            As in `image`.
        depth, id, class_ : bool
            Which arrays to make besides the image.
        **options
            `format`, `out`, `over`, `linear_light` and `host_depth`, as in `image`.
        """
        out = options.get("out")
        if out is not None:
            shape: Tuple[int, ...] = tuple(out.shape[:2])
        else:
            shape = self._size[::-1] if width is None or height is None else (height, width)
        wanted = (("depth", depth, "f"), ("id", id, "I"), ("class_", class_, "B"))
        arrays = {name: new_array(shape, code) if want else None for name, want, code in wanted}
        return Raster(self.image(width, height, **arrays, **options), **arrays)

    def vertices(
        self,
        primitive: str = "points",
        attributes: Sequence[str] = ("position", "radius", "color", "is_paper"),
    ) -> Vertices:
        """Write the dots or the strokes as vertices for a graphics card, from far to near.

        Points, painted in this order as round points with "source over" blending, give the dots of `image`.

        Parameters
        ----------
        primitive : {"points", "line_strips", "triangle_strips"}
            "points": the dots of paper and of ink, one vertex each.  "line_strips": the strokes, one vertex for each of
            their points.  "triangle_strips": the strokes, two vertices for each point, on its left and right side.
        attributes : sequence of str
            The fields of a vertex: "position" (in the world, 3 float32), "window" (pixel x, y and depth, 3 float32),
            "radius" (of a dot, or half the width of a stroke, in pixels, float32), "color" (straight RGBA, 4 uint8),
            "normal" and "direction" (in the world, 3 float32), "id" (of the mark, uint32), "class" and "is_paper" (uint8),
            "layer" (number of the layer in the drawing, uint32), "length" (along the stroke, in pixels, float32),
            "hidden_layers" (number of layers of surface in front of this part of a line; 0 = visible; uint32),
            "hidden_by" (number of the item whose surface is the nearest of these; 0xFFFFFFFF = none; uint32) and "line"
            (number of the line, as in `polylines`; uint32).

        Returns
        -------
        Vertices
            `vertices`, a structured array of shape (n,) with the attributes as fields (without NumPy, a memoryview of
            bytes, shape (n, stride)), and `indices`, the numbers of the vertices, uint32, where 0xFFFFFFFF ends a strip.
        """
        number = number_of("primitive", PRIMITIVES, primitive)
        layout, fields, keep = layout_of(number, attributes)
        error, counts = new_error(), ffi.new("int64_t[2]")
        handle = self._handle
        check(lib.hrbfnpr_drawing_vertex_bound(handle, number, counts, counts + 1, error), error)
        array, address = vertex_array(counts[0], layout, fields)
        indices, view = output("indices", None, (counts[1],), 1, "I")
        status = lib.hrbfnpr_drawing_write_vertices(
            handle, layout, address, counts[0], counts, ffi.cast("uint32_t *", view.data), counts[1], counts + 1, error
        )
        check(status, error)
        del keep
        return Vertices(array[: counts[0]], indices[: counts[1]])

    def polylines(self, layer: Optional[int] = None) -> List[Array]:
        """Return the strokes as structured arrays, from far to near.  Needs NumPy.

        Each stroke is an array with a row for each of its points.  The fields are "window" (pixel x, y and depth),
        "position" (in the world), "radius" (half the width, in pixels), "color" (straight RGBA, uint8), "length" (along the
        stroke, in pixels), "layer" (number of the layer in the drawing), "hidden_layers" (number of layers of surface in
        front of the stroke; 0 = visible), "hidden_by" (number of the item whose surface is the nearest of these;
        0xFFFFFFFF = none) and "line" (number of the line; 0 for strokes of marks).  A line keeps its number from one drawing
        of a renderer to the next if the camera moves little.  The last four are the same along a stroke.

        Parameters
        ----------
        layer : int, optional
            Number of a layer in `layers`; None: the strokes of all layers.
        """
        fields = ("window", "position", "radius", "color", "length", "layer", "hidden_layers", "hidden_by", "line")
        vertices, indices = self.vertices("line_strips", fields)
        ends = np.flatnonzero(indices == 0xFFFFFFFF)
        strips = np.split(indices, ends)
        lines = [vertices[strip[strip != 0xFFFFFFFF]] for strip in strips if len(strip) > 1]
        return [line for line in lines if layer is None or line["layer"][0] == layer]

    def _layer(self, item: int, layer: Union[int, str]) -> MarkLayer:
        """The layer of marks with a number or a name."""
        if not 0 <= item < len(self._marks):
            raise IndexError(f"item must be 0 to {len(self._marks) - 1}, not {item}")
        layers = self._marks[item]
        if isinstance(layer, str):
            found = next((one for one in layers if one.name == layer), None)
            if found is None:
                raise KeyError(f"there is no layer {layer!r}; there are {', '.join(repr(one.name) for one in layers)}")
            return found
        if not 0 <= layer < len(layers):
            raise IndexError(f"layer must be 0 to {len(layers) - 1}, not {layer}")
        return layers[layer]

    def mark_results(self, item: int = 0, layer: Union[int, str] = 0) -> MarkResults:
        """Tell how each mark of a layer is drawn, in the order of the point set.

        A program that keeps the marks on a graphics card uploads only these numbers for each frame.

        Parameters
        ----------
        item : int
            Number of the item, in the order of `Renderer.draw`, from 0.
        layer : int or str
            Number or name of a layer of the item's point set.  It need not be drawn.

        Returns
        -------
        MarkResults
            `shown` (n,), uint8: the class as which the mark is drawn, 0 = it is not drawn.  `radius` (n,), float32: in
            pixels.  `opacity` (n,), float32: the ink's alpha times the transmittance of the surface in front.
        """
        marks = self._layer(item, layer)
        results, error, shape = new_struct("hrbfnpr_mark_results"), new_error(), (len(marks),)
        shown = output_field(results, "shown", shape, 1, "B")
        radius = output_field(results, "radius", shape, 1, "f")
        opacity = output_field(results, "opacity", shape, 1, "f")
        check(lib.hrbfnpr_drawing_mark_results(self._handle, item, marks.number, results, error), error)
        return MarkResults(shown, radius, opacity)

    def mark_indices(
        self,
        item: int = 0,
        layer: Union[int, str] = 0,
        class_: str = "front",
        primitive: str = "points",
    ) -> Array:
        """Return the numbers of the marks of a layer that are drawn, uint32.

        Parameters
        ----------
        item, layer
            As in `mark_results`.
        class_ : {"front", "silhouette"}
            The class of the marks.
        primitive : {"points", "line_strips", "triangle_strips"}
            "points": the marks from far to near.  "line_strips": runs of shown marks along strokes, each ended by
            0xFFFFFFFF.  "triangle_strips": the same runs, with 2 * number and 2 * number + 1 for each mark.
        """
        marks = self._layer(item, layer)
        handle, error, count = self._handle, new_error(), ffi.new("int64_t *")
        numbers = number_of("class_", CLASSES, class_), number_of("primitive", PRIMITIVES, primitive)
        place = handle, item, marks.number, *numbers
        status = lib.hrbfnpr_drawing_write_mark_indices(*place, ffi.NULL, 0, count, error)
        if status != ffi.integer_const("HRBFNPR_STATUS_BUFFER_TOO_SMALL"):
            check(status, error)
        indices, view = output("indices", None, (count[0],), 1, "I")
        target = ffi.cast("uint32_t *", view.data) if count[0] else ffi.NULL
        check(lib.hrbfnpr_drawing_write_mark_indices(*place, target, count[0], count, error), error)
        return indices

    def identify(self, id: int) -> MarkIdentity:
        """Find the mark that an identity of a pixel or of a vertex refers to.

        Raises
        ------
        InvalidArgumentError
            If no mark has this identity.
        """
        return get(_records.MarkIdentity, lib.hrbfnpr_drawing_identify, self._handle, int(id))

    def to_pil(self) -> Any:
        """Return the drawing as a PIL.Image.  Needs Pillow."""
        return _pictures.to_pil(self.image())

    def save(
        self, target: Union[str, "os.PathLike[str]", BinaryIO], format: Optional[str] = None, **options: Any
    ) -> Optional[PageInfo]:
        """Write the drawing to a path or to a binary file object, as a picture or as vectors.

        A file is written whole or not at all.  Pictures need Pillow; vectors do not.

        Parameters
        ----------
        target : path or file object
            Where to write.
        format : str, optional
            "svg", "pdf", "hpgl", "gcode" or "dxf" for vectors, or a format of Pillow, such as "PNG".  By default the
            path's ending chooses it, and PNG is used for file objects.
        **options
            For vectors: `scale`, the size of a pixel in mm (default 25.4 / 96), and the options of `write_page`.

        Returns
        -------
        PageInfo, optional
            For vectors, counts of the written shapes; else None.
        """
        as_page = format.lower() if format is not None else _page.format_of(target)
        if as_page in PAGE_FORMATS:
            item = _records.PageItem(self, scale=options.pop("scale", _page.PIXEL))
            return _page.write_page(target, item, format=as_page, **options)
        if options:
            raise TypeError(f"a picture has no option {', '.join(options)}: those are of vectors, as .svg and .pdf")
        _pictures.save(self.to_pil(), target, format)
        return None

    def to_svg(self, **options: Any) -> str:
        """Return the text of an SVG file.  Options are those of `save` for vectors."""
        buffer = io.BytesIO()
        self.save(buffer, "svg", **options)
        return buffer.getvalue().decode()

    def to_png(self) -> bytes:
        """Return the bytes of a PNG file.  Needs Pillow."""
        buffer = io.BytesIO()
        self.save(buffer, "PNG")
        return buffer.getvalue()

    def _repr_png_(self) -> bytes:
        return self.to_png()

    def _repr_svg_(self) -> Optional[str]:
        info = self.info  # a browser takes long for larger drawings
        if info.dots + info.strokes > _MOST_IN_NOTEBOOK:
            return None
        text = self.to_svg()
        return text[text.index("<svg"):]  # nbconvert refuses text that declares its encoding

    def __repr__(self) -> str:
        if self.closed:
            return "<hrbfnpr.Drawing closed>"
        info = self.info
        return f"<hrbfnpr.Drawing {self._size[0]}x{self._size[1]}, {info.dots} dots, {info.strokes} strokes>"
