# SPDX-License-Identifier: MIT
"""From a model to a picture."""
from __future__ import annotations

import json
import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from .. import shapes
from .._camera import Camera, corners
from .._context import Context
from .._drawing import Drawing
from .._layer import Layer, preset_layers
from .._line_set import Lines, LineSet
from .._model import Model
from .._names import MADE_KINDS
from .._page import PageItem
from .._pictures import save as save_picture
from .._point_set import PointSet
from .._renderer import Item, Renderer
from .._style import Style
from . import _automatic, _blank, _lines, _plate, _vectors
from . import _values as values
from ._inputs import Loaded, given
from ._progress import Reporter

_GENERATE = (
    "distribution", "initial_step", "seed_source", "box_resolution", "box_jitter", "tone_ranges", "shared_budget",
    "projection_tolerance", "random_seed",
)  # fmt: skip
_STROKES = ("separation", "step", "length", "symmetry", "start", "start_level")
_HATCH = ("separation", "step", "guide", "guide_direction", "guide_weight")
_HATCH_PIXELS = ("hatch_spacing", "hatch_pen", "hatch_white", "hatch_taper", "hatch_shortest", "hatch_overshoot")
_STYLE = (
    "paper", "hidden_lines", "visibility", "silhouette_threshold", "silhouette_law", "silhouette_width",
    "attenuation_front", "attenuation_back", "splat_radius", "splat_overlap", "halo_width", "tone", "tone_rule",
    "tone_curve", "tone_fade", "tone_exponent", "fill_light", "light", "light_space", "zoom_reference", "zoom_exponent",
    "ink",
)  # fmt: skip


def make_style(arguments: Any, size: Tuple[int, int]) -> Style:
    """The named style with what was given on the command line, marks sized for the picture."""
    style = Style(arguments.style)
    if arguments.distribution == "published":
        _draw_as_published(style)
    style.layer("any")
    # The named styles are made for a pen of one pixel.
    pen = arguments.mark_radius or _automatic.pen_radius(size)
    for layer in style.layers:
        layer.radius *= pen
        for field in _HATCH_PIXELS:
            setattr(layer, field, pen * getattr(layer, field))
        if arguments.share is not None:
            layer.share *= arguments.share
        if arguments.shape is not None:
            layer.shape = arguments.shape
    style.silhouette_radius *= pen
    style.halo_width *= pen
    if arguments.contours_of is not None:
        for kind in MADE_KINDS:
            style.layer(kind).contours = kind in arguments.contours_of
        style.layer("any").contours = False
    _lines.style_lines(arguments, style, pen)
    style.update(**given(arguments, _STYLE))
    style.update(**given(arguments, ("silhouette_ink", "silhouette_radius")))
    if arguments.silhouette_ink is not None:
        for line in style.lines:
            line.ink = arguments.silhouette_ink
    if arguments.transparent:
        red, green, blue, _ = style.paper
        style.paper = (red, green, blue, 0.0)
    if arguments.depth_range is not None:
        style.depth_min, style.depth_max = arguments.depth_range
    for owner, field, text in arguments.assignments:
        values.assign(style, owner, field, text)
    return style


def _draw_as_published(style: Style) -> None:
    """Marks of the recursion are dots of one size."""
    for layer in style.layers:
        if layer.kind == "combing" and layer.shown:
            layer.shape, layer.radius, layer.share = "dots", 1.1, 1.0
        if layer.kind == "stipples" and style.preset == "full":
            layer.radius = layer.share = 1.0


def make_camera(arguments: Any, source: Union[Model, PointSet], points: Any) -> Camera:
    """The camera asked for; without --eye one that sees all of the points."""
    up = arguments.up
    # Finds are drawn as they are measured.
    fov = 0.0 if _is_find(arguments) else 30.0
    angle = math.radians(fov if arguments.fov is None else arguments.fov)
    size = arguments.size or _automatic.LONG_SIDE
    if arguments.eye is not None:
        return _camera_at(arguments, source, up, angle, (size, size) if isinstance(size, int) else size)
    azimuth = 30.0 if arguments.azimuth is None else arguments.azimuth
    elevation = 20.0 if arguments.elevation is None else arguments.elevation
    direction = arguments.direction or _automatic.view_direction(up, azimuth, elevation)
    margin = 0.05 if arguments.margin is None else arguments.margin
    camera = Camera.fit(source, direction, up, vertical_angle=angle, margin=margin)
    return _automatic.frame(camera, points, size, margin)


def _camera_at(arguments: Any, source: Any, up: Any, angle: float, size: Tuple[int, int]) -> Camera:
    """From --eye towards --target or the middle of the model."""
    low, high = (np.asarray(corner) for corner in corners(source))
    target = (low + high) / 2 if arguments.target is None else arguments.target
    distance = float(np.linalg.norm(np.subtract(target, arguments.eye)))
    radius = float(np.linalg.norm(high - low))
    camera = Camera.look_at(arguments.eye, target, up)
    if angle == 0:
        return camera.orthographic(radius, size, -distance - radius, distance + radius)
    return camera.perspective(angle, size, max(distance - 2 * radius, distance / 1000), distance + 2 * radius)


def _is_find(arguments: Any) -> bool:
    return bool(arguments.style == "archaeological")


def make_layers(arguments: Any, wanted: Sequence[Layer]) -> List[Layer]:
    """These layers with what was given on the command line."""
    layers = []
    for layer in wanted:
        kind = layer.kind
        fields = {"stipples": ("density", "density_strength"), "hatch": _HATCH}.get(kind, _STROKES)
        layer = replace(layer, **given(arguments, (*fields, "tone_smoothing")))
        for field, numbers in (("budget", arguments.budget), ("levels", arguments.levels)):
            if numbers is not None and kind in numbers:
                layer = replace(layer, **{field: numbers[kind]})
        if kind == "hatch" and arguments.hatch_angle is not None:
            layer = replace(layer, angle=layer.angle + arguments.hatch_angle)
        layers.append(replace(layer, with_curvature=kind in (arguments.curvature_of or ())))
    return layers


def _wanted_layers(arguments: Any) -> List[Layer]:
    """Those asked for, or those of the style, whose strokes follow each other from light to dark unless told not to."""
    if arguments.layers:
        return [Layer(kind) for kind in arguments.layers]
    layers = preset_layers(arguments.style, arguments.distribution or "blue_noise")
    return layers if arguments.tone_ranges is None else [replace(one, tone=None, second_tone=None) for one in layers]


def generate(arguments: Any, model: Model, layers: Sequence[Layer], context: Context, report: Reporter) -> PointSet:
    """Place the marks."""
    options = given(arguments, _GENERATE)
    if arguments.seed_points is not None:
        options["seed_points"] = shapes.read(arguments.seed_points).points
    with report.stage("place marks", "placing marks") as stage:
        marks = PointSet.generate(model, layers, progress=stage.bar, context=context, **options)
        stage.says = f"{len(marks)} marks: {', '.join(layer.name or layer.kind for layer in marks.layers)}"
    return marks


def plan(
    arguments: Any, model: Model, known: PointSet, camera: Camera, report: Reporter
) -> Tuple[Style, List[Layer]]:
    """The style for a camera, and the layers that it wants with what fills the darkest tone."""
    style = make_style(arguments, camera.size)
    low, high = model.bounds
    pixels = _automatic.pixels_per_unit(camera, np.add(low, high) / 2)
    area = known.info.spacing**2 * len(known)
    published, seeds = arguments.distribution == "published", max(model.info.centres, 1)
    layers = make_layers(arguments, _wanted_layers(arguments))
    layers = _automatic.marks(layers, style, area, pixels, published, seeds, report.note)
    if arguments.tone_ranges == "in-turn":
        layers = _automatic.in_turn(layers, style)
    return style, layers


def _has_section(arguments: Any) -> bool:
    return _is_find(arguments) if arguments.profile is None else bool(arguments.profile == "yes")


def _unit_of_bar(arguments: Any) -> str:
    unit = arguments.scale_bar or ("units" if _is_find(arguments) else "none")
    return "" if unit == "none" else str(unit)


def is_plate(arguments: Any) -> bool:
    """Whether there is more on the paper than the drawing."""
    return _has_section(arguments) or _unit_of_bar(arguments) != ""


def section_lines(arguments: Any, model: Model, camera: Camera) -> List[Lines]:
    """What a section beside the drawing needs of the line set."""
    return [_plate.section(model, camera)] if _has_section(arguments) else []


def plate(
    arguments: Any,
    drawing: Drawing,
    model: Model,
    marks: PointSet,
    line_set: Optional[LineSet],
    camera: Camera,
    style: Style,
    context: Context,
) -> Any:
    """A PIL.Image: the drawing with a section beside it and a scale bar."""
    section = line_set if _has_section(arguments) else None
    unit = _unit_of_bar(arguments)
    return _plate.compose(drawing.to_pil(), model, marks, section, camera, style, unit, context)


def outputs_of(arguments: Any) -> List[Path]:
    """Where the drawing goes, in one format or several."""
    return [Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".png"),
            *(Path(path) for path in arguments.also)]  # fmt: skip


def draw(arguments: Any, loaded: Loaded, context: Context, report: Reporter) -> None:
    """Draw a model or a point set and write the picture."""
    source, output = loaded.content, outputs_of(arguments)[0]
    arguments.up, arguments.input_shape = loaded.up, loaded.shape
    arguments.has_end = isinstance(source, Model) and source.trim_info.is_trimmed
    known = _automatic.probe(source, context) if isinstance(source, Model) else source
    camera = make_camera(arguments, source, _automatic.positions(known))
    if isinstance(source, Model):
        style, layers = plan(arguments, source, known, camera, report)
        marks = generate(arguments, source, layers, context, report)
        line_set = _lines.make(arguments, source, style, context, report, section_lines(arguments, source, camera))
    else:
        style = make_style(arguments, camera.size)
        marks = source
        line_set = None
        if arguments.lines:
            report.note("lines are drawn of a model, not of saved points: contours come from marks")
    with report.stage("frame", "drawing") as stage:
        drawing = Renderer(context=context).draw(Item(marks, style, line_set=line_set), camera)
        stage.says = f"{drawing.info.shown} of {len(marks)} marks shown, {drawing.info.line_curves} curves"
        if not arguments.allow_blank:
            _blank.check(drawing, source, camera, style, arguments.flip)
    write = _Writer(arguments, source, marks, line_set, drawing, camera, style, context, report)
    with report.stage("write", "writing") as stage:
        stage.says = ", ".join(write(path) for path in outputs_of(arguments)) + write.saved()
    for doubt in _lines.doubts(drawing.info):
        report.warn(doubt)
    width, height = camera.size
    report.summary(f"{output}: {width} x {height} pixels, {len(marks)} marks")


@dataclass
class _Writer:
    """Writes a drawing, and what belongs to it, in any format."""

    arguments: Any
    source: Union[Model, PointSet]
    marks: PointSet
    line_set: Optional[LineSet]
    drawing: Drawing
    camera: Camera
    style: Style
    context: Context
    report: Reporter

    def __call__(self, path: Path) -> str:
        if _vectors.is_vector(path):
            self._vectors(path)
        elif isinstance(self.source, Model) and is_plate(self.arguments):
            picture = plate(
                self.arguments, self.drawing, self.source, self.marks, self.line_set, self.camera, self.style,
                self.context,
            )  # fmt: skip
            save_picture(picture, path, None)
        else:
            self.drawing.save(path)
        return str(path)

    def saved(self) -> str:
        """The other files that are wanted."""
        model, points = self.arguments.save_model, self.arguments.save_points
        if isinstance(self.source, Model) and model:
            self.source.save(model)
        if points:
            self.marks.save(points)
        return "".join(f", {path}" for path in (model, points) if path)

    def _vectors(self, path: Path) -> None:
        items, notes, size = [PageItem(self.drawing)], [], self.drawing.size
        if isinstance(self.source, Model) and is_plate(self.arguments):
            section = self.line_set if _has_section(self.arguments) else None
            items, notes, size = _plate.vectors(
                self.drawing, self.source, self.marks, section, self.camera, self.style, _unit_of_bar(self.arguments),
                self.context,
            )  # fmt: skip
        _vectors.write(self.arguments, items, size, path, notes, self._metadata(), self.report)

    def _metadata(self) -> str:
        """What the drawing is of, as JSON."""
        facts: Dict[str, Any] = {"input": Path(self.arguments.input).name, "style": self.arguments.style}
        if isinstance(self.source, Model):
            info = self.source.info
            facts["model"] = {"centres": info.centres, "kernel": info.kernel, "samples": info.samples}
        facts["marks"] = len(self.marks)
        facts["camera"] = {
            "view": np.asarray(self.camera.view).tolist(), "projection": np.asarray(self.camera.projection).tolist(),
            "viewport": list(self.camera.viewport),
        }  # fmt: skip
        return json.dumps(facts)
