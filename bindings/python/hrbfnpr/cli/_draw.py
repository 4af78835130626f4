"""From a model to a picture."""
from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any, Dict, Sequence, Tuple, Union

import numpy as np

from .. import shapes
from .._camera import Camera, corners
from .._context import Context
from .._model import Model
from .._names import GROUPS
from .._point_set import PointSet
from .._renderer import Renderer
from .._style import Style
from . import _automatic
from . import _values as values
from ._inputs import given
from ._progress import Reporter

_GENERATE = (
    "distribution", "budget", "levels", "initial_step", "seed_source", "box_resolution", "box_jitter",
    "stroke_seeds", "seed_level", "stroke_separation", "stroke_step", "stroke_length", "stroke_field", "density",
    "density_strength", "order", "shared_budget", "projection_tolerance", "curvature_of", "random_seed",
)  # fmt: skip
_STYLE = (
    "paper", "hidden_lines", "visibility", "silhouette_threshold", "silhouette_law", "silhouette_width",
    "attenuation_front", "attenuation_back", "cover_radius", "cover_layers", "halo_width", "tone", "tone_rule",
    "tone_curve", "tone_fade", "tone_exponent", "light", "light_space", "zoom_reference", "zoom_exponent",
    "silhouette_groups", "ink",
)  # fmt: skip


def make_style(arguments: Any, size: Tuple[int, int]) -> Style:
    """The named style with what was given on the command line, marks sized for the picture."""
    style = Style(arguments.style)
    # The named styles are made for a pen of one pixel.
    pen = arguments.mark_radius or _automatic.pen_radius(size)
    for name in GROUPS:
        getattr(style, name).radius *= pen
        if arguments.share is not None:
            getattr(style, name).share *= arguments.share
    style.silhouette_radius *= pen
    style.update(**given(arguments, _STYLE))
    style.update(**given(arguments, ("silhouette_ink", "silhouette_radius")))
    if arguments.transparent:
        red, green, blue, _ = style.paper
        style.paper = (red, green, blue, 0.0)
    if arguments.depth_range is not None:
        style.depth_min, style.depth_max = arguments.depth_range
    for group, field, text in arguments.assignments:
        values.assign(style, group, field, text)
    return style


def make_camera(arguments: Any, source: Union[Model, PointSet], points: Any) -> Camera:
    """The camera asked for; without --eye one that sees all of the points."""
    up = arguments.up or (0.0, 1.0, 0.0)
    angle = math.radians(30.0 if arguments.fov is None else arguments.fov)
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


def generate(
    arguments: Any,
    model: Model,
    groups: Sequence[str],
    automatic: Dict[str, Any],
    context: Context,
    report: Reporter,
) -> PointSet:
    """Place the marks; what was given on the command line goes before `automatic`."""
    options = {**automatic, **given(arguments, _GENERATE)}
    for name in ("budget", "levels"):  # what was given for some groups leaves the others
        if isinstance(options.get(name), dict):
            options[name] = {**automatic.get(name, {}), **options[name]}
    if options.get("shared_budget"):
        options.pop("budget", None)
    if arguments.seed_points is not None:
        options["seed_points"] = shapes.read(arguments.seed_points).points
    with report.stage("placing marks") as bar:
        return PointSet.generate(model, groups, progress=bar, context=context, **options)


def draw(arguments: Any, source: Union[Model, PointSet], context: Context, report: Reporter) -> None:
    """Draw a model or a point set and write the picture."""
    start = time.monotonic()
    output = Path(arguments.output_option or arguments.output or Path(arguments.input).stem + ".png")
    known = _automatic.probe(source, context) if isinstance(source, Model) else source
    camera = make_camera(arguments, source, _automatic.positions(known))
    style = make_style(arguments, camera.size)
    if isinstance(source, Model):
        if arguments.save_model:
            source.save(arguments.save_model)
        groups = arguments.groups or style.groups
        low, high = source.bounds
        pixels = _automatic.pixels_per_unit(camera, np.add(low, high) / 2)
        area = known.info.spacing**2 * len(known)
        options = given(arguments, _GENERATE)
        automatic = _automatic.marks(groups, style, area, pixels, options, max(source.info.centres, 1))
        if options.get("order") == "layered":
            automatic["layers"] = _automatic.layers(groups, style)
        marks = generate(arguments, source, groups, automatic, context, report)
    else:
        marks = source
    if arguments.save_points:
        marks.save(arguments.save_points)
    with report.stage("drawing"):
        drawing = Renderer(context=context).drawing((marks, style), camera)
        drawing.save(output)
    if not report.quiet:
        width, height = camera.size
        seconds = time.monotonic() - start
        print(f"{output}: {width} x {height} pixels, {len(marks)} marks, {seconds:.1f} s")
