# SPDX-License-Identifier: MIT
"""From a model or marks and options to a picture: what the command line and `hrbfnpr.draw` have in common.

Options are the attributes of a namespace as the command line's grammar makes it (`cli/_options.py`); two more come from
programs only: `own_style`, a Style that is used as it is, and `own_camera`.
"""
from __future__ import annotations

import json
import math
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import shapes
from ._camera import Camera, corners
from ._context import Context
from ._drawing import Drawing
from ._layer import Layer, preset_layers
from ._line_set import Lines, LineSet
from ._model import Model
from ._names import MADE_KINDS
from ._page import PageItem
from ._pictures import save as save_picture
from ._point_set import PointSet
from ._renderer import Item, Renderer
from ._style import Style
from .cli import _automatic, _blank, _lines, _plate, _settings_use, _vectors
from .cli import _values as values
from .cli._inputs import Loaded, given
from .cli._progress import Reporter

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
    own: Optional[Style] = getattr(arguments, "own_style", None)
    style = Style(arguments.style) if own is None else own.copy()
    by_settings = own is not None and bool(getattr(arguments, "settings", None))
    if arguments.distribution == "published" and not by_settings:
        _draw_as_published(style)
    if not by_settings:
        style.layer("any")
    # The named styles are made for a pen of one pixel, and so are those of settings.
    pen = arguments.mark_radius or getattr(arguments, "own_pen", None) or _automatic.pen_radius(size)
    if own is not None and not by_settings:
        pen = 1.0
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


def make_camera(arguments: Any, source: Any, points: Any) -> Camera:
    """The camera asked for; without --eye one that sees all of the points, of a source or a box."""
    own: Optional[Camera] = getattr(arguments, "own_camera", None)
    if own is not None:
        return own
    up = arguments.up
    # Finds are drawn as they are measured.
    fov = 0.0 if _is_find(arguments) else 30.0
    angle = math.radians(fov if arguments.fov is None else arguments.fov)
    size = arguments.size or _automatic.LONG_SIDE
    if arguments.eye is not None:
        return _camera_at(arguments, source, up, angle, (size, size) if isinstance(size, int) else size)
    azimuth = _automatic.AZIMUTH if arguments.azimuth is None else arguments.azimuth
    elevation = _automatic.ELEVATION if arguments.elevation is None else arguments.elevation
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
    options = {**(getattr(arguments, "own_generate", None) or {}), **given(arguments, _GENERATE)}
    arguments.made = list(layers), dict(options)
    if arguments.seed_points is not None:
        options["seed_points"] = shapes.read(arguments.seed_points).points
    with report.stage("place marks", "placing marks") as stage:
        marks = PointSet.generate(model, layers, progress=stage.bar, context=context, **options)
        stage.says = f"{len(marks)} marks: {', '.join(layer.name or layer.kind for layer in marks.layers)}"
    return marks


def area_of(known: PointSet) -> float:
    """Of a surface, from even marks on it."""
    return float(known.info.spacing**2 * len(known))


def plan(
    arguments: Any, model: Model, area: float, camera: Camera, report: Reporter
) -> Tuple[Style, List[Layer]]:
    """The style for a camera, and the layers that it wants with what fills the darkest tone of an area."""
    style = make_style(arguments, camera.size)
    low, high = model.bounds
    pixels = _automatic.pixels_per_unit(camera, np.add(low, high) / 2)
    published, seeds = arguments.distribution == "published", max(model.info.centres, 1)
    own: Optional[List[Layer]] = getattr(arguments, "own_layers", None)
    if own is not None and arguments.layers is None:
        return style, _settings_use.paint(arguments, style, make_layers(arguments, own), camera)
    layers = make_layers(arguments, _wanted_layers(arguments))
    if not published and not getattr(arguments, "save_points", None):  # what is saved may be drawn in another style
        layers = _automatic.few_of_unseen(layers, style)
    layers = _automatic.marks(layers, style, area, pixels, published, seeds, report.note)
    if arguments.tone_ranges == "in-turn":
        layers = _automatic.in_turn(layers, style)
    return style, _settings_use.paint(arguments, style, layers, camera)


def sides_of(arguments: Any, source: Union[Model, PointSet]) -> str:
    """On which sides of the surface marks are drawn: of one that ends the inside is seen, too."""
    wanted = getattr(arguments, "sides", None) or "auto"
    if wanted != "auto":
        return str(wanted)
    return "both" if isinstance(source, Model) and source.trim_info.is_trimmed else "front"


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


@dataclass(frozen=True)
class Part:
    """A surface that is drawn beside others, with its marks and lines, and what it comes from."""

    model: Model
    shape: Optional[shapes.Shape]
    marks: PointSet
    line_set: Optional[LineSet]


@dataclass
class Scene:
    """What is drawn, by any number of cameras: one model, its marks and lines, and a renderer.

    Lines keep their numbers, and wobble the same, from one drawing to the next.  `places` are points spread over the
    surface, shape (n, 3), which cameras are fitted to.  `rest` is what a mesh has beside it whose parts are no surface
    together.
    """

    arguments: Any
    source: Union[Model, PointSet]
    marks: PointSet
    line_set: Optional[LineSet]
    style: Style
    camera: Camera
    places: Any
    context: Context
    rest: Tuple[Part, ...] = ()
    renderer: Renderer = field(init=False)

    def __post_init__(self) -> None:
        self.renderer = Renderer(context=self.context)

    def draw(self, camera: Camera) -> Drawing:
        """The drawing alone, without what a plate adds."""
        items = [self._item(self.source, self.marks, self.line_set)]
        items += [self._item(part.model, part.marks, part.line_set) for part in self.rest]
        return self.renderer.draw(items, camera)

    def _item(self, source: Union[Model, PointSet], marks: PointSet, line_set: Optional[LineSet]) -> Item:
        return Item(marks, self.style, line_set=line_set, sides=sides_of(self.arguments, source))

    @property
    def bounds(self) -> Any:
        """What cameras see all of: the source, or the corners of the box of several."""
        return _bounds(self.source, [part.model for part in self.rest])

    @property
    def mark_count(self) -> int:
        """Of all surfaces."""
        return len(self.marks) + sum(len(part.marks) for part in self.rest)

    @property
    def is_plate(self) -> bool:
        """Whether there is more on the paper than the drawing."""
        return isinstance(self.source, Model) and is_plate(self.arguments)

    def picture(self, drawing: Drawing, camera: Camera) -> Any:
        """A PIL.Image of a drawing, with a section beside it and a scale bar where they are wanted."""
        if not (isinstance(self.source, Model) and is_plate(self.arguments)):
            return drawing.to_pil()
        return plate(
            self.arguments, drawing, self.source, self.marks, self.line_set, camera, self.style, self.context
        )

    def check(self, drawing: Drawing, camera: Camera) -> None:
        """Raise a ValueError if hardly anything can be seen, unless that is allowed."""
        if not self.arguments.allow_blank:
            _blank.check(drawing, self.bounds, camera, self.style, self.arguments.flip)

    def write(self, path: Path, drawing: Drawing, camera: Camera, report: Reporter) -> None:
        """A drawing in the format that the path's ending says."""
        if _vectors.is_vector(path):
            self._vectors(path, drawing, camera, report)
        else:
            save_picture(self.picture(drawing, camera), path, None)

    def _vectors(self, path: Path, drawing: Drawing, camera: Camera, report: Reporter) -> None:
        items: List[PageItem] = [PageItem(drawing)]
        notes: List[Any] = []
        size: Tuple[float, float] = drawing.size
        if isinstance(self.source, Model) and is_plate(self.arguments):
            section = self.line_set if _has_section(self.arguments) else None
            items, notes, size = _plate.vectors(
                drawing, self.source, self.marks, section, camera, self.style, _unit_of_bar(self.arguments), self.context
            )
        _vectors.write(self.arguments, items, size, path, notes, self._metadata(camera), report)

    def _metadata(self, camera: Camera) -> str:
        """What the drawing is of, as JSON."""
        facts: Dict[str, Any] = {"input": Path(self.arguments.input).name, "style": self.arguments.style}
        if isinstance(self.source, Model):
            infos = [self.source.info, *(part.model.info for part in self.rest)]
            facts["model"] = {
                "centres": sum(info.centres for info in infos), "kernel": infos[0].kernel,
                "samples": sum(info.samples for info in infos),
            }  # fmt: skip
        facts["marks"] = self.mark_count
        facts["camera"] = {
            "view": np.asarray(camera.view).tolist(), "projection": np.asarray(camera.projection).tolist(),
            "viewport": list(camera.viewport),
        }  # fmt: skip
        return json.dumps(facts)


Look = Callable[[Any, Any, Any], Camera]
"""From options, a model or a point set, and points spread over it, to a camera."""


def set_scene(
    arguments: Any, loaded: Loaded, context: Context, report: Reporter, look: Look = make_camera
) -> Scene:
    """The camera, the marks and the lines of a model; saved marks are used as they are."""
    arguments.up = loaded.up
    if isinstance(loaded.content, Model):
        return _scene_of_models(arguments, loaded, context, report, look)
    source = loaded.content
    arguments.input_shape, arguments.has_end = loaded.shape, False
    places = _automatic.positions(source)
    camera = look(arguments, source, places)
    if arguments.lines:
        report.note("lines are drawn of a model, not of saved points: contours come from marks")
    return Scene(arguments, source, source, None, make_style(arguments, camera.size), camera, places, context)


def _scene_of_models(arguments: Any, loaded: Loaded, context: Context, report: Reporter, look: Look) -> Scene:
    """Marks are as dense on all surfaces, and lines of hatching as far from each other."""
    sources = [loaded, *loaded.rest]
    models = [each.content for each in sources if isinstance(each.content, Model)]
    known = [_automatic.probe(model, context) for model in models]
    areas = [area_of(marks) for marks in known]
    places = np.concatenate([_automatic.positions(marks) for marks in known])
    arguments.has_end = any(model.trim_info.is_trimmed for model in models)
    if arguments.has_end:
        _look_at_front(arguments, loaded.shape, known, areas, report)
    camera = look(arguments, _bounds(models[0], models[1:]), places)
    style, layers = plan(arguments, models[0], sum(areas), camera, report)
    parts = []
    for each, model, area in zip(sources, models, areas):
        arguments.input_shape = each.shape
        own = layers if len(models) == 1 else _share_of(layers, area / sum(areas))
        marks = generate(arguments, model, own, context, report)
        line_set = _lines.make(arguments, model, style, context, report, section_lines(arguments, model, camera))
        parts.append(Part(model, each.shape, marks, line_set))
    arguments.input_shape = loaded.shape
    first, rest = parts[0], tuple(parts[1:])
    return Scene(arguments, first.model, first.marks, first.line_set, style, camera, places, context, rest)


def _look_at_front(
    arguments: Any, shape: Optional[shapes.Shape], known: Sequence[PointSet], areas: Sequence[float], report: Reporter
) -> None:
    """From the side that an open surface looks to, where nothing is said of the camera."""
    if any(getattr(arguments, name, None) is not None for name in ("own_camera", "eye", "direction", "azimuth")):
        return
    if shape is not None and shape.is_picture and shape.viewpoint is not None:
        places = np.concatenate([_automatic.positions(marks) for marks in known])
        towards = np.asarray(shape.viewpoint) - places.mean(axis=0)
        arguments.azimuth = float(round(_automatic.azimuth_of(arguments.up, towards)) % 360)
        arguments.elevation = 0.0 if arguments.elevation is None else arguments.elevation
        report.note(
            f"the points are a picture of a depth camera: seen from where it stood, azimuth {arguments.azimuth:g}; what "
            "it did not see is missing"
        )
        return
    means = [np.concatenate([layer.normals for layer in marks.layers]).mean(axis=0) for marks in known]
    azimuth = _automatic.front_azimuth(arguments.up, np.average(means, axis=0, weights=areas))
    if azimuth is None:
        return
    arguments.azimuth = azimuth
    report.note(
        f"the surface looks away from the usual side: seen from azimuth {azimuth:g} (--azimuth {_automatic.AZIMUTH:g} "
        "sees its back)"
    )


def _share_of(layers: Sequence[Layer], share: float) -> List[Layer]:
    """As many of a budget's marks as a part of the area gets."""
    return [one if one.budget is None else replace(one, budget=max(1, round(share * one.budget))) for one in layers]


def _bounds(source: Any, rest: Sequence[Model]) -> Any:
    """The source itself where it is alone."""
    if not rest:
        return source
    boxes = np.array([corners(each) for each in (source, *rest)], dtype=float)
    return boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)


def draw_scene(scene: Scene, report: Reporter) -> Drawing:
    """By its own camera; a picture that would be blank is an error."""
    with report.stage("frame", "drawing") as stage:
        drawing = scene.draw(scene.camera)
        stage.says = f"{drawing.info.shown} of {scene.mark_count} marks shown, {drawing.info.line_curves} curves"
        scene.check(drawing, scene.camera)
    return drawing
