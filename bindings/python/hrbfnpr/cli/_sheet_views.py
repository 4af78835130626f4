# SPDX-License-Identifier: MIT
"""A technical drawing: orthographic views and sections of a model on a sheet, to scale."""
from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any, List, Tuple

import numpy as np

from .. import __version__
from .._context import Context
from .._line_set import Lines as LinesToFind
from .._line_set import LineSet
from .._model import Model
from .._page import PageInfo, format_of, write_page
from .._point_set import PointSet
from .._renderer import Renderer
from ..shapes._shape import Floats
from . import _automatic, _cut_faces, _lines, _nearness, _view_axes, _view_layout, _view_lines, _view_marks, _view_order
from ._inputs import Loaded
from ._progress import Reporter
from ._values import number, up
from ._view_axes import Plane, View

_SMOOTH = {"ridges": "ridge", "valleys": "valley", "suggestive": "suggestive_contour"}
_METRE = 1000.0
_LEAST_OUTLINE = 2.0  # mm
_SYMMETRIC = 0.004  # of the diagonal: how far nine of ten mirrored samples may be from the surface, at most


def smooth_of(text: str) -> Tuple[str, ...]:
    """Kinds of lines, or none."""
    if text == "none":
        return ()
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in _SMOOTH:
            raise argparse.ArgumentTypeError(f"there are no edges {name!r}; there are {', '.join(_SMOOTH)} and none")
    return tuple(_SMOOTH[name] for name in names)


def positive(text: str) -> float:
    """A number above 0."""
    value = number(text)
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"must be above 0, not {text}")
    return value


def add_options(parser: Any) -> None:
    """Those of the command line."""
    group = parser.add_argument_group("sheet")
    add = group.add_argument
    add("--views", type=_view_axes.views, metavar="NAMES", help="with commas between: "
        f"{', '.join(_view_axes.NAMES)}; front, top, iso and the side that is on the right by default")  # fmt: skip
    add("--section", type=_view_axes.cut, action="append", default=[], metavar="AXIS:PLACE", help="a section by "
        "the plane, such as z:20; -z:20 is seen from below, z is through the middle, 1:1:0:5 is x + y = 5; may be "
        "repeated")  # fmt: skip
    add("--projection", choices=("first", "third"), default="first", metavar="NAME", help="where views are: first "
        "angle (default), the left view at the right, or third angle")  # fmt: skip
    add("--page", type=_view_layout.page_of, metavar="PAPER", help="a4, a3, ... lying, WIDTHxHEIGHT in mm, or auto "
        "(default): the smallest of a4 to a0 that holds the views; a3 where the scale is auto, too")  # fmt: skip
    add("--scale", type=_view_layout.scale_of, metavar="N:M", help="such as 1:2, or auto (default): the largest of "
        "1, 2, 5, 10, ... that fits the page")  # fmt: skip
    add("--unit-mm", type=positive, metavar="MM", help="millimetres of a unit of the model; 1, of glTF 1000")
    add("--hidden", choices=("dashed", "none", "shown"), default="dashed", metavar="NAME", help="hidden edges: dashed "
        "(default), none or shown")  # fmt: skip
    add("--smooth", type=smooth_of, default=(), metavar="KINDS", help="edges that are not sharp, as thin lines: "
        f"{', '.join(_SMOOTH)}; none by default")  # fmt: skip
    add("--crease-angle", type=positive, default=30.0, metavar="DEGREES", help="edges of a mesh are sharp if its faces "
        "meet at more than this; 30")  # fmt: skip
    add("--line-width", type=positive, default=0.5, metavar="MM", help="of outlines; thin lines are half as wide; 0.5")
    add("--hatch-spacing", type=positive, default=3.0, metavar="MM", help="of lines in cut faces; 3")
    add("--spacing", type=positive, default=15.0, metavar="MM", help="between views; 15")
    add("--centre-lines", action="store_true", help="of planes of symmetry")
    add("--labels", action="store_true", help="write the views' names above them; sections have theirs always")
    add("--title", metavar="TEXT", help="in the title block; the file's name without its ending by default")
    add("--up", type=up, metavar="AXIS", help="x, y, z, -y, ... or X,Y,Z; auto (default): by the kind of file "
        "and the shape, y where neither tells")  # fmt: skip


def output_of(arguments: Any) -> Path:
    """Where the sheet goes; an error if it is no file of vectors."""
    path = Path(arguments.output_option or arguments.output or Path(arguments.input).stem + "-views.svg")
    if format_of(path) is None:
        raise ValueError(f"{path}: a sheet of views is drawn as vectors: use .svg, .pdf, .hpgl or .gcode")
    return path


@dataclass
class _Sheet:
    """What is known of a sheet before its lines are drawn."""

    cells: List[_view_layout.Cell]
    planes: List[Plane]
    layout: _view_layout.Layout
    scale: _view_layout.Scale
    middle: Floats
    diagonal: float
    axes: Tuple[Floats, Floats, Floats]


def _unit(arguments: Any, loaded: Loaded, report: Reporter) -> float:
    if arguments.unit_mm is not None:
        return float(arguments.unit_mm)
    if loaded.shape is not None and loaded.shape.format.startswith(("glTF", "GLB")):
        report.note("glTF is in metres: a unit is 1000 mm; --unit-mm sets another")
        return _METRE
    return 1.0


def _names(arguments: Any) -> Tuple[str, ...]:
    side = "left" if arguments.projection == "first" else "right"
    names: Tuple[str, ...] = arguments.views or ("front", side, "top", "iso")
    return names


def _plan(arguments: Any, loaded: Loaded, points: Floats, unit: float) -> _Sheet:
    """Views, page and scale."""
    names, axes = _names(arguments), _view_axes.frame(loaded.up)
    middle = _view_layout.middle_of(points, axes)
    planes = _view_axes.planes(arguments.section, names, loaded.up, middle)
    for plane, cut in zip(planes, arguments.section):
        _require_cut(plane, cut, points)
    views = _view_axes.standard(names, loaded.up)
    sections = [_view_axes.section(plane, loaded.up) for plane in planes]
    cells = _view_layout.cells([*views, *sections], points, middle, arguments.projection, axes[1], arguments.labels)
    for plane in planes:
        shown = _view_marks.first_edge_on(views, plane)
        for cell in cells:
            if cell.view is shown:
                cell.cuts.append(plane)
    layout, scale = _view_layout.choose(cells, arguments.page, arguments.scale, unit, arguments.spacing, axes[1])
    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    return _Sheet(cells, planes, layout, scale, middle, diagonal, axes)


def _require_cut(plane: Plane, cut: _view_axes.Cut, points: Floats) -> None:
    away = points @ plane.normal
    if not away.min() < plane.place < away.max():
        low, high = sorted(float(np.linalg.norm(cut.normal) * end) for end in (away.min(), away.max()))
        given = plane.place if plane.normal @ cut.normal > 0 else -plane.place
        raise ValueError(f"--section: the plane at {given * np.linalg.norm(cut.normal):g} misses the model, which is "
                         f"between {low:g} and {high:g} there")  # fmt: skip


def _solid(
    arguments: Any, loaded: Loaded, model: Model, sheet: _Sheet, context: Context, report: Reporter
) -> _view_lines.Solid:
    """The model with all lines that the views want."""
    smooth = arguments.smooth
    once: List[LinesToFind] = [LinesToFind(kind) for kind in smooth if kind != "suggestive_contour"]
    once += [LinesToFind("section", plane.name, plane=tuple(plane.normal), levels=[plane.place], shortest=0.0)
             for plane in sheet.planes]  # fmt: skip
    is_mesh = loaded.shape is not None and loaded.shape.is_mesh
    creases = _lines.creases(loaded.shape, arguments.crease_angle) if is_mesh else []
    creases = _view_lines.edges_of(creases, sheet.diagonal)
    with report.stage("trace lines", "looking for lines") as stage:
        lines = LineSet(model, once, with_curvature="suggestive_contour" in smooth, progress=stage.bar, context=context)
        if lines.info.creases:
            creases = []  # the model's own are among the lines
        stage.says = f"on {lines.info.triangles} triangles; {len(creases)} sharp edges of the mesh"
    marks = PointSet.generate(model, budget=20, context=context)  # none is drawn
    return _view_lines.Solid(model, lines, creases, smooth, sheet.middle, sheet.diagonal, marks)


def _is_long(line: Floats) -> bool:
    """More than a ripple that the tracing of a section has left."""
    return bool(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() > _LEAST_OUTLINE)


def _draw_view(
    cell: _view_layout.Cell, centre: Tuple[float, float], sheet: _Sheet, solid: _view_lines.Solid, renderer: Renderer,
    arguments: Any, lines: _view_marks.Lines, report: Reporter,
) -> None:  # fmt: skip
    view = cell.view
    curves, outlines = _view_lines.curves(view, solid, sheet.layout.scale, renderer)
    wanted = [_view_order.VISIBLE, _view_order.HIDDEN, _view_order.SMOOTH]
    if arguments.hidden == "none" or view.plane is not None:  # sections show what is seen alone [ISO 128-3]
        wanted.remove(_view_order.HIDDEN)
    for kind, pieces in _view_order.in_order(curves, wanted).items():
        for piece in pieces:
            lines.add(kind, piece + centre, view.name)
    closed = [outline for outline in outlines if np.array_equal(outline[0], outline[-1])]
    count = sum(1 for outline in outlines if not np.array_equal(outline[0], outline[-1]) and _is_long(outline))
    if count:
        report.warn(f"section {view.name}: {_nearness.of(count, 'outline')} of the cut not closed, and not hatched: "
                    "the model is open there, or the plane lies in a face")  # fmt: skip
    for segment in _cut_faces.hatched(closed, arguments.hatch_spacing):
        lines.add("hatching", segment + centre, view.name)


def _mark_view(
    cell: _view_layout.Cell, centre: Tuple[float, float], sheet: _Sheet, symmetric: List[Floats],
    lines: _view_marks.Lines,
) -> None:  # fmt: skip
    scale, box = sheet.layout.scale, cell.seen(sheet.layout.scale).moved(*centre)
    for plane in cell.cuts:
        _view_marks.cutting_plane(lines, cell.view, plane, sheet.middle, scale, centre, box)
    near = 1e-6 * sheet.diagonal
    cut = [plane.normal for plane in cell.cuts if abs(plane.place - plane.normal @ sheet.middle) < near]
    for normal in symmetric:
        if cell.view.edge_on(normal) and not any(abs(normal @ one) > 1 - 1e-6 for one in cut):
            _view_marks.centre_line(lines, cell.view, normal, scale, centre, box)
    if cell.label:
        _view_marks.name_of(lines, cell.view, cell.box(scale).moved(*centre))


def _on_surface(model: Model) -> Floats:
    """Points of the surface: the centres of a fit; stipples of what has none, as a solid put together from others."""
    points = np.asarray(model.points, dtype=float)
    if len(points) > 0:
        return points
    stipples = model.generate("stipples", budget=1000)
    return np.asarray(stipples.layers[0].positions, dtype=float) + np.asarray(stipples.origin)


def _symmetric(model: Model, sheet: _Sheet) -> List[Floats]:
    """Normals of the planes through the middle that the surface is symmetric to."""
    points = _on_surface(model)
    points = points[:: max(1, len(points) // 1000)]
    found = []
    for normal in sheet.axes:
        mirrored = points - 2 * np.outer((points - sheet.middle) @ normal, normal)
        there = model.evaluate(mirrored, gradient=True)
        away = np.abs(there.value) / np.maximum(np.linalg.norm(np.asarray(there.gradient), axis=1), 1e-300)
        if np.percentile(away, 90) < _SYMMETRIC * sheet.diagonal:
            found.append(normal)
    return found


def _write(
    path: Path, arguments: Any, sheet: _Sheet, lines: _view_marks.Lines, unit: float, report: Reporter
) -> PageInfo:
    page, model = sheet.layout.page, Path(arguments.input)
    title = arguments.title or model.stem
    facts = {"Title": title, "Model": model.name, "Scale": sheet.scale.text, "Page, unit": f"{page.name.upper()}, mm"}
    _view_marks.frame(lines, page)
    _view_marks.title_block(lines, page, facts, arguments.projection)
    _view_marks.scale_bar(lines, page, sheet.layout.scale / unit)
    with report.stage("write", "writing") as stage:
        info = write_page(
            path, [], pens=lines.pens(), annotations=lines.annotations(), width=page.width, height=page.height,
            tolerance=0.02, title=title, description=f"Drawn by hrbfnpr {__version__}",
        )  # fmt: skip
        stage.says = str(path)
    return info


def _places(loaded: Loaded, model: Model, context: Context) -> Floats:
    """Where the model is."""
    places = _automatic.positions(_automatic.probe(model, context))
    if loaded.shape is not None and not model.trim_info.is_trimmed:
        places = np.concatenate((places, np.asarray(model.points, dtype=float)))
    return np.asarray(places, dtype=float)


def draw_views(arguments: Any, output: Path, loaded: Loaded, model: Model, context: Context, report: Reporter) -> None:
    """Draw all views and write the sheet."""
    unit = _unit(arguments, loaded, report)
    sheet = _plan(arguments, loaded, _places(loaded, model, context), unit)
    solid = _solid(arguments, loaded, model, sheet, context, report)
    lines = _view_marks.Lines(arguments.line_width, arguments.hidden)
    symmetric = _symmetric(model, sheet) if arguments.centre_lines else []
    if arguments.centre_lines and not symmetric:
        report.note("--centre-lines: no plane of symmetry through the middle is found")
    renderer = Renderer(context=context)
    with report.stage("views", "drawing views") as stage:
        for cell, centre in zip(sheet.cells, sheet.layout.centres):
            _draw_view(cell, centre, sheet, solid, renderer, arguments, lines, report)
            _mark_view(cell, centre, sheet, symmetric, lines)
            if stage.bar is not None:
                stage.bar.update(1 / len(sheet.cells))
        stage.says = ", ".join(cell.view.name for cell in sheet.cells)
    _write(output, arguments, sheet, lines, unit, report)
    page = sheet.layout.page
    report.summary(f"{output}: {len(sheet.cells)} views at {sheet.scale.text} on {page.name}, "
                   f"{page.width:g} x {page.height:g} mm, {arguments.projection} angle")  # fmt: skip
