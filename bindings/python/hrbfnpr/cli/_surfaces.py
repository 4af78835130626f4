# SPDX-License-Identifier: MIT
"""The commands that need only a fitted surface: fit, points and sheet-views."""
from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List

from .._context import Context
from .._errors import new_struct
from .._layer import Layer
from .._library import ffi
from .._model import Model
from .._options import OPTIONS
from .._page import format_of
from .._point_set import PointSet
from .._records import text_in
from .._report import Reporter as AnyReporter
from .._request import Options
from .._scene import Scene
from .._sources import scene_of
from .._streams import write_atomically
from ._outputs import UsageError, check_drawing, check_saved
from ._progress import Reporter

_HATCH_FIELDS = ("separation", "step", "guide", "guide_direction", "guide_weight", "start", "start_level")
_STIPPLE_FIELDS = ("density", "density_strength")
_NUMBER_FIELDS = ("line_width", "hatch_spacing", "spacing", "crease_angle", "unit_mm")


def surface_of(
    arguments: Any, options: Options, context: Context, report: AnyReporter, otherwise: str, together: bool = True
) -> Scene:
    """A scene with the contents of a file as one surface, or as several if not `together`.

    If the file holds marks only, the error says that it holds `otherwise`.
    """
    scene = scene_of(arguments.input, None, options, None, context, report,
                     flags=("SURFACE_ONLY", "TOGETHER") if together else ("SURFACE_ONLY",))  # fmt: skip
    if scene.model is None:
        raise UsageError(f"{arguments.input} holds {otherwise}")
    return scene


def fit(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Fit a model to the input and save it."""
    check_saved(arguments.output, "model")
    model = surface_of(arguments, options, context, report, "a point set; a fit needs a mesh or points with normals").model
    assert model is not None
    with report.stage("write", "writing") as stage:
        model.save(arguments.output)
        stage.says = arguments.output
    report.summary(f"{arguments.output}: {model.info.centres} centres, {model.info.kernel}")


# ---- Marks


def points(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Place marks on the surface and save them, as .hrbm or .ply."""
    check_saved(arguments.output, "point set", ".ply")
    options = {"parts": "outer", **options}  # marks in cavities are hidden
    model = surface_of(arguments, options, context, report, "a point set, so its marks are placed already").model
    assert model is not None
    with report.stage("place marks", "placing marks") as stage:
        marks = _generate(model, options, stage.bar, context)
        stage.says = f"{len(marks)} marks: {', '.join(layer.name or layer.kind for layer in marks.layers)}"
    with report.stage("write", "writing") as stage:
        if arguments.output.lower().endswith(".ply"):
            from ._ply import write_ply

            write_ply(arguments.output, marks)
        else:
            marks.save(arguments.output)
        stage.says = arguments.output
    report.summary(f"{arguments.output}: {len(marks)} marks")


def _generate(model: Model, options: Options, bar: Any, context: Context) -> PointSet:
    """Generate marks whose layers have only the given options, without those of a style."""
    common: Dict[str, Any] = {}  # arguments for all layers together
    layer_fields: Dict[str, Any] = {}  # fields of each layer
    for row in OPTIONS:
        section, _, field = row.target.rpartition(".")
        if row.name in options and section in ("marks", "marks.layers"):
            (common if section == "marks" else layer_fields)[field] = options[row.name]
    if "random_seed" in options:
        common["random_seed"] = options["random_seed"]
    if "seed_points" in options:
        from .. import shapes

        common["seed_points"] = shapes.read(options["seed_points"]).points
    layers = [_layer(kind, options, layer_fields) for kind in options.get("layers") or ("stipples",)]
    return PointSet.generate(model, layers, progress=bar, context=context, **common)


def _layer(kind: str, options: Options, given: Dict[str, Any]) -> Layer:
    """A layer of a kind, with the given fields that apply to this kind."""
    fields = {"stipples": _STIPPLE_FIELDS, "hatch": _HATCH_FIELDS}[kind]
    layer = Layer(kind, **{name: given[name] for name in (*fields, "tone_smoothing") if name in given})
    for field, numbers in (("budget", options.get("marks", {})), ("levels", options.get("levels", {}))):
        if kind in numbers:
            layer = replace(layer, **{field: numbers[kind]})
    if kind == "hatch":
        layer = replace(layer, angle=layer.angle + options.get("hatch_angle", 0.0))
    return replace(layer, with_curvature=kind in options.get("curvature_of", ()))


# ---- Views on a sheet


def views(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Draw the views and sections and write the sheet."""
    output = Path(arguments.output_option or arguments.output or Path(arguments.input).stem + "-views.svg")
    if format_of(output) is None:
        raise ValueError(f"{output}: a sheet of views is a vector file: use .svg, .pdf, .hpgl, .gcode or .dxf")
    check_drawing(output)
    scene = surface_of(arguments, options, context, report, "a point set; views need a mesh, points or a model", together=False)
    desc, keep = _views_desc(arguments, scene, str(format_of(output)))
    buffer = io.BytesIO()
    info = scene.write_views(buffer, desc, report)
    del keep
    with report.stage("write", "writing") as stage:
        write_atomically(output, lambda file: file.write(buffer.getvalue()))
        stage.says = str(output)
    scale, paper = (ffi.string(text).decode() for text in (info.scale_text, info.paper))
    report.summary(f"{output}: {info.views} views at {scale} on {paper}, {info.width:g} x {info.height:g} mm, "
                   f"{arguments.projection} angle")  # fmt: skip


def _views_desc(arguments: Any, scene: Scene, format: str) -> Any:
    """A hrbfnpr_views_desc, and the objects that it points to, which the caller must keep alive."""
    desc, page = new_struct("hrbfnpr_views_desc"), new_struct("hrbfnpr_page_desc")
    keep: List[Any] = [page]
    for flag, wanted in (("CENTRE_LINES", arguments.centre_lines), ("LABELS", arguments.labels),
                         ("VERIFY", arguments.verify),
                         ("UNIT_IS_METRE", getattr(scene.sources[0], "format", "").startswith(("glTF", "GLB")))):  # fmt: skip
        desc.flags |= ffi.integer_const(f"HRBFNPR_VIEWS_{flag}") if wanted else 0
    desc.projection = ffi.integer_const(f"HRBFNPR_VIEWS_ANGLE_{arguments.projection.upper()}")
    desc.hidden = ffi.integer_const(f"HRBFNPR_VIEWS_HIDDEN_{arguments.hidden.upper()}")
    desc.tangent = ffi.integer_const(f"HRBFNPR_VIEWS_TANGENT_{arguments.tangent.upper()}")
    texts = {"views": ",".join(arguments.views or ()), "sections": ";".join(arguments.section), "paper": arguments.page,
             "scale": arguments.scale, "smooth": arguments.smooth, "title": arguments.title}  # fmt: skip
    for name, text in texts.items():
        setattr(desc, name, text_in(keep, text or None))
    for name in _NUMBER_FIELDS:
        if getattr(arguments, name) is not None:
            setattr(desc, name, getattr(arguments, name))
    page.format, page.tolerance, desc.page = ffi.integer_const(f"HRBFNPR_PAGE_FORMAT_{format.upper()}"), 0.02, page
    return desc, keep
