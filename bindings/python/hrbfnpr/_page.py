# SPDX-License-Identifier: MIT
"""Pages: drawings as SVG, PDF, HPGL or G-code."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, BinaryIO, Optional, Sequence, Union

from . import _streams
from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._library import ffi, lib
from ._names import DOT_SHAPES, PAGE_FORMATS, WIDTHS, number_of
from ._operation import Operation, Progress, running
from ._records import Annotation, PageInfo, PageItem, Pen, fill_list, read, text_in

if TYPE_CHECKING:
    from ._drawing import Drawing

Target = Union[str, "os.PathLike[str]", BinaryIO]
PIXEL = 25.4 / 96  # mm, as in CSS
# Formats by the ending of a file's name.
ENDINGS = {
    ".svg": "svg", ".pdf": "pdf", ".hpgl": "hpgl", ".plt": "hpgl", ".gcode": "gcode", ".nc": "gcode", ".ngc": "gcode",
}  # fmt: skip
_STRINGS = ("title", "description", "metadata", "pen_down", "pen_up")


def format_of(target: Target) -> Optional[str]:
    """The format that a file's ending stands for; None if that is none of a page's."""
    if not isinstance(target, (str, os.PathLike)):
        return None
    return ENDINGS.get(os.path.splitext(os.fspath(target))[1].lower())


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
    for name, kind, given in (("item", PageItem, items), ("pen", Pen, pens), ("annotation", Annotation, annotations)):
        fill_list(desc, name, kind, given, keep)
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
    return read(PageInfo, info)


_OPTIONS = (
    "width", "height", "tolerance", "width_step", "join", "shortest", "dot_distance", "draw_speed", "travel_speed",
    "pen_seconds", *_STRINGS,
)  # fmt: skip
