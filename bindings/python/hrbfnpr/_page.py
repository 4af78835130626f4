# SPDX-License-Identifier: MIT
"""Pages: drawings as SVG, PDF, HPGL or G-code."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, BinaryIO, List, Optional, Sequence, Tuple, Union

from . import _streams
from ._arrays import Array, block_in
from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._layer import new_list
from ._library import ffi, lib
from ._names import DOT_SHAPES, LINE_TYPES, PAGE_FORMATS, WIDTHS, number_of
from ._operation import Operation, Progress, running
from ._structs import read_struct

if TYPE_CHECKING:
    from ._drawing import Drawing

Target = Union[str, "os.PathLike[str]", BinaryIO]
PIXEL = 25.4 / 96  # mm, as in CSS
# Formats by the ending of a file's name.
ENDINGS = {
    ".svg": "svg", ".pdf": "pdf", ".hpgl": "hpgl", ".plt": "hpgl", ".gcode": "gcode", ".nc": "gcode", ".ngc": "gcode",
}  # fmt: skip
_STRINGS = ("title", "description", "metadata", "pen_down", "pen_up")


@dataclass
class PageItem:
    """A drawing on a page.

    Attributes
    ----------
    drawing : Drawing
        What lies beyond its viewport is cut off.
    x, y : float
        Millimetres from the page's top-left corner to the viewport's.
    scale : float
        Millimetres of a pixel.
    name : str, optional
        Of the group around it.
    """

    drawing: "Drawing"
    x: float = 0.0
    y: float = 0.0
    scale: float = PIXEL
    name: Optional[str] = None


@dataclass
class Pen:
    """What some groups of a page are drawn with.

    Attributes
    ----------
    groups : str
        A group's name, or the beginning of names and a "*"; of pens that fit a group the last one is taken.
    width : float
        Millimetres; 0 = as drawn, of plotters 0.3.
    ink : tuple of float, optional
        Red, green, blue and alpha, from 0 to 1; None = as drawn.
    number : int
        Of a plotter's pen, from 1 to 255.
    line_type : str
        "as_drawn", or a type of ISO 128-2: "continuous", "dashed", "dashed_spaced", "long_dashed_dotted",
        "long_dashed_double_dotted", "long_dashed_triple_dotted", "dotted", "long_dashed_short_dashed",
        "long_dashed_double_short_dashed", "dashed_dotted", "double_dashed_dotted", "dashed_double_dotted",
        "double_dashed_double_dotted", "dashed_triple_dotted", "double_dashed_triple_dotted".
    """

    groups: str = "*"
    width: float = 0.0
    ink: Optional[Tuple[float, ...]] = None
    number: int = 1
    line_type: str = "as_drawn"


@dataclass
class Annotation:
    """A line or a text beside the drawings of a page.

    Attributes
    ----------
    points : array of float, shape (n, 2)
        Millimetres: the line, or in its first row where the text's baseline begins.
    text : str, optional
    group : str
        Annotations of one group that follow each other are one layer, in the ink and line type of the first.
    width : float
        Millimetres: of the line, or the height of the text's capitals.
    ink : tuple of float
        Red, green, blue and alpha, from 0 to 1.
    line_type : str
        As of `Pen`.
    """

    points: Array
    text: Optional[str] = None
    group: str = "annotations"
    width: float = 0.35
    ink: Tuple[float, ...] = (0.0, 0.0, 0.0, 1.0)
    line_type: str = "continuous"


@dataclass(frozen=True)
class PageInfo:
    """What was written.

    Attributes
    ----------
    bytes, groups, paths, segments, dots : int
        Segments are curves or straight lines of all paths.
    joined, dropped_paths, dropped_dots : int
        In plot order: pairs of ends that became one line; lines too short for the pen, dots too near to others.
    width, height : float
        Millimetres, of the page.
    drawn, travelled : float
        In plot order: millimetres that a pen draws, and goes between.
    seconds : float
        That a plotter takes at the given speeds.
    filled_paths : int
        In plot order: lines wider than their pen, drawn in several passes.
    """

    bytes: int
    groups: int
    paths: int
    segments: int
    dots: int
    joined: int
    dropped_paths: int
    dropped_dots: int
    width: float
    height: float
    drawn: float
    travelled: float
    seconds: float
    filled_paths: int


def format_of(target: Target) -> Optional[str]:
    """The format that a file's ending stands for; None if that is none of a page's."""
    if not isinstance(target, (str, os.PathLike)):
        return None
    return ENDINGS.get(os.path.splitext(os.fspath(target))[1].lower())


def _rgba(ink: Sequence[float]) -> List[float]:
    if len(ink) not in (3, 4):
        raise ValueError(f"ink must be (red, green, blue) or (red, green, blue, alpha), not {ink!r}")
    return [*ink] if len(ink) == 4 else [*ink, 1.0]


def text_in(keep: List[Any], text: Optional[str]) -> Any:
    if text is None:
        return ffi.NULL
    encoded = ffi.new("char[]", text.encode())
    keep.append(encoded)
    return encoded


def _fill_items(desc: Any, items: Sequence[PageItem], keep: List[Any]) -> None:
    structs = new_list("hrbfnpr_page_item", len(items))
    for struct, item in zip(structs, items):
        struct.drawing = item.drawing._handle
        struct.x, struct.y, struct.scale = item.x, item.y, item.scale
        struct.name = text_in(keep, item.name)
    desc.items, desc.item_count = structs, len(items)
    keep.append(structs)


def fill_pens(desc: Any, pens: Sequence[Pen], keep: List[Any]) -> None:
    structs = new_list("hrbfnpr_pen", len(pens))
    for struct, pen in zip(structs, pens):
        struct.groups = text_in(keep, pen.groups)
        struct.width, struct.number = pen.width, pen.number
        struct.line_type = number_of("line_type", LINE_TYPES, pen.line_type)
        if pen.ink is not None:
            struct.ink = _rgba(pen.ink)
    desc.pens, desc.pen_count = structs, len(pens)
    keep.append(structs)


def _fill_annotations(desc: Any, annotations: Sequence[Annotation], keep: List[Any]) -> None:
    structs = new_list("hrbfnpr_annotation", len(annotations))
    for struct, annotation in zip(structs, annotations):
        keep.append(block_in("points", annotation.points, 2).fill(struct.points))
        struct.text, struct.group = text_in(keep, annotation.text), text_in(keep, annotation.group)
        struct.width, struct.ink = annotation.width, _rgba(annotation.ink)
        struct.line_type = number_of("line_type", LINE_TYPES, annotation.line_type)
    desc.annotations, desc.annotation_count = structs, len(annotations)
    keep.append(structs)


def write_page(
    target: Target,
    items: Union["Drawing", PageItem, Sequence[PageItem]],
    *,
    format: Optional[str] = None,
    pens: Sequence[Pen] = (),
    annotations: Sequence[Annotation] = (),
    widths: str = "outlines",
    dots: str = "circles",
    plot_order: bool = False,
    single_pass: bool = False,
    paper: bool = True,
    progress: Optional[Progress] = None,
    operation: Optional[Operation] = None,
    context: Optional[Context] = None,
    **options: Any,
) -> PageInfo:
    """Write drawings as vectors, to a path (atomically) or a binary file object.

    Parameters
    ----------
    target : path or file object
    items : Drawing, PageItem or sequence of PageItem
        Where each drawing is; one alone has pixels of 1/96 inch.
    format : {"svg", "pdf", "hpgl", "gcode"}, optional
        By default as the path's ending says: .svg, .pdf, .hpgl or .plt, .gcode, .nc or .ngc; else "svg".
    pens : sequence of Pen
        Of plotters too, which draw with a pen of 0.3 mm where none is given.
    annotations : sequence of Annotation
    widths : {"outlines", "classes"}
        Strokes of varying width: as filled outlines, or as lines of even widths `width_step` apart.
    dots : {"circles", "lines", "spirals"}
        Circles, which a pen fills too, unless `single_pass`; lines of no length with round ends, which a pen touches
        the paper with; spirals that a pen fills the disc with.
    plot_order : bool
        Sort each group so that a pen travels little, and leave out what it cannot resolve; plotters' formats do.
    single_pass : bool
        Draw a line that is wider than its pen once, along its centre, and circles as circles; else plotters, and pens in
        plot order, fill them: several passes side by side, so that tone that widths carry is on paper.
    paper : bool
        Fill the page with the paper of the first drawing's style, and viewports with another.
    **options
        width, height (mm of the page; 0 = as far as the drawings reach), tolerance (mm, 0.05), width_step (1.25),
        join, shortest, dot_distance (mm; 0 = by the pen's width), draw_speed, travel_speed (mm/s), pen_seconds,
        pen_down, pen_up (G-code), title, description, metadata (str).

    Returns
    -------
    PageInfo
    """
    if not isinstance(items, (list, tuple)):
        items = [items if isinstance(items, PageItem) else PageItem(items)]
    desc, info, error, keep = new_struct("hrbfnpr_page_desc"), new_struct("hrbfnpr_page_info"), new_error(), []
    desc.format = number_of("format", PAGE_FORMATS, format or format_of(target) or "svg")
    desc.widths, desc.dots = number_of("widths", WIDTHS, widths), number_of("dots", DOT_SHAPES, dots)
    flags = (("IN_PLOT_ORDER", plot_order), ("SINGLE_PASS", single_pass), ("WITHOUT_PAPER", not paper))
    for flag, wanted in flags:
        if wanted:
            desc.flags |= ffi.integer_const(f"HRBFNPR_PAGE_{flag}")
    for name, value in options.items():
        if name not in _OPTIONS:
            raise TypeError(f"write_page() has no option {name!r}; it has {', '.join(_OPTIONS)}")
        setattr(desc, name, text_in(keep, value) if name in _STRINGS else value)
    _fill_items(desc, items, keep)
    fill_pens(desc, pens, keep)
    _fill_annotations(desc, annotations, keep)
    handle = resolve(context)._handle

    def to_file(file: BinaryIO) -> None:
        state = CallbackState(file.write)
        with running(operation, progress, handle) as (running_handle, running_state):
            user = state.new_handle()
            status = lib.hrbfnpr_page_write(handle, desc, _streams._on_write, user, info, running_handle, error)
            check(status, error, running_state, state)

    if isinstance(target, (str, os.PathLike)):
        _streams.write_atomically(target, to_file)
    else:
        to_file(target)
    del keep
    return read_struct(PageInfo, info)


_OPTIONS = (
    "width", "height", "tolerance", "width_step", "join", "shortest", "dot_distance", "draw_speed", "travel_speed",
    "pen_seconds", *_STRINGS,
)  # fmt: skip
