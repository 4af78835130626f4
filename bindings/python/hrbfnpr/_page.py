# SPDX-License-Identifier: MIT
"""Pages: drawings as SVG, PDF, HPGL, G-code or DXF."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, BinaryIO, List, Optional, Sequence, Union, cast

from . import _records, _streams
from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._library import ffi, lib
from ._names import CURVES, DOT_SHAPES, PAGE_FORMATS, WIDTHS, number_of
from ._operation import Operation, Progress, running
from ._records import fill_list, read, text_in

if TYPE_CHECKING:
    from ._drawing import Drawing
    from ._records import Annotation, PageInfo, PageItem, Pen

Target = Union[str, "os.PathLike[str]", BinaryIO]
PIXEL = 25.4 / 96  # size of a pixel in mm, as in CSS
# The format for each ending of a file's name.
ENDINGS = {
    ".svg": "svg", ".pdf": "pdf", ".hpgl": "hpgl", ".plt": "hpgl", ".gcode": "gcode", ".nc": "gcode", ".ngc": "gcode",
    ".dxf": "dxf",
}  # fmt: skip
_STRINGS = ("title", "description", "metadata", "pen_down", "pen_up")


def format_of(target: Target) -> Optional[str]:
    """The format of a file's ending, or None if it is not that of a page."""
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
    curves: str = "arcs",
    plot_order: bool = False,
    single_pass: bool = False,
    paper: bool = True,
    progress: Optional[Progress] = None,
    operation: Optional[Operation] = None,
    context: Optional[Context] = None,
    **options: Any,
) -> PageInfo:
    """Write drawings as vectors to a path or to a binary file object.

    A file is written whole or not at all.  Memory grows with the largest stroke; in plot order, with the largest group.

    Parameters
    ----------
    target : path or file object
        Where to write.
    items : Drawing, PageItem or sequence of PageItem
        The drawings, with their places on the page.  A single drawing has pixels of 1/96 inch.
    format : {"svg", "pdf", "hpgl", "gcode", "dxf"}, optional
        By default the path's ending chooses it: .svg; .pdf; .hpgl or .plt; .gcode, .nc or .ngc; .dxf.  Otherwise it is
        "svg".
    pens : sequence of Pen
        The pens for groups of lines.  On plotters, a group without a pen is drawn with a pen of 0.3 mm.
    annotations : sequence of Annotation
        Lines and texts beside the drawings.
    widths : {"outlines", "classes"}
        How strokes of varying width are written: as filled outlines, or as lines of even widths that differ by the factor
        `width_step`.
    dots : {"circles", "lines", "spirals"}
        How dots are written.  "circles": circles; plotters fill them, unless `single_pass`.  "lines": lines of no length
        with round ends, at which a pen touches the paper.  "spirals": spirals with which a pen fills the dot.
    curves : {"arcs", "splines", "lines"}
        How the curves of lines of one width are written.  "arcs": arcs of circles where lines consist of them, else
        splines; G-code has arcs and straight lines only.  "splines": cubic Bezier curves.  "lines": straight lines.
    plot_order : bool
        True: sort each group so that a pen travels little, and leave out what the pen cannot resolve.  HPGL and G-code are
        always sorted.
    single_pass : bool
        True: draw a line that is wider than its pen once, along its centre, and circles as circles.  False: plotters, and
        pens in plot order, fill such lines and circles by several passes, so that the paper shows their full width.
    paper : bool
        True: fill the page with the paper of the first drawing's style, and viewports with their paper if it differs.
    progress, operation, context
        As in `Model.fit`.
    **options
        width, height (size of the page in mm; 0 = as far as the drawings reach), tolerance (largest distance between
        drawn and written lines in mm, 0.001 to 10; 0.05), width_step (1.01 to 4; 1.25), join, shortest, dot_distance (in mm;
        0 = from the pen's width), longest (length that a pen draws at most before it is raised, in mm, at least 1; 0 = no
        limit), draw_speed, travel_speed (in mm/s; 30 and 80), pen_seconds (0.15), pen_down, pen_up (G-code; "G1 Z0" and
        "G0 Z5"), title, description, metadata (str).

    Returns
    -------
    PageInfo
        Counts of the written shapes.

    Raises
    ------
    InvalidArgumentError
        If the page is empty, or a drawing with the visibility "published" is written for a plotter or in plot order.
    TypeError
        If an option is unknown.
    OSError
        If the file cannot be created.
    """
    if not isinstance(items, (list, tuple)):
        items = [items if isinstance(items, _records.PageItem) else _records.PageItem(cast("Drawing", items))]
    desc, info, error = new_struct("hrbfnpr_page_desc"), new_struct("hrbfnpr_page_info"), new_error()
    keep: List[Any] = []
    desc.format = number_of("format", PAGE_FORMATS, format or format_of(target) or "svg")
    desc.widths, desc.dots = number_of("widths", WIDTHS, widths), number_of("dots", DOT_SHAPES, dots)
    desc.curves = number_of("curves", CURVES, curves)
    flags = (("IN_PLOT_ORDER", plot_order), ("SINGLE_PASS", single_pass), ("WITHOUT_PAPER", not paper))
    for flag, wanted in flags:
        if wanted:
            desc.flags |= ffi.integer_const(f"HRBFNPR_PAGE_{flag}")
    for name, value in options.items():
        if name not in _OPTIONS:
            raise TypeError(f"write_page() has no option {name!r}; it has {', '.join(_OPTIONS)}")
        setattr(desc, name, text_in(keep, value) if name in _STRINGS else value)
    lists = (
        ("item", _records.PageItem, items), ("pen", _records.Pen, pens), ("annotation", _records.Annotation, annotations),
    )  # fmt: skip
    for name, kind, given in lists:
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
    return read(_records.PageInfo, info)


_OPTIONS = (
    "width", "height", "tolerance", "width_step", "join", "shortest", "dot_distance", "longest", "draw_speed", "travel_speed",
    "pen_seconds", *_STRINGS,
)  # fmt: skip
