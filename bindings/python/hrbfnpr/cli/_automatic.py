"""Good choices for what the user leaves open, from the picture that is asked for."""
from __future__ import annotations

import math
from typing import Any, Dict, Sequence, Tuple, Union

import numpy as np

from .._camera import Camera
from .._context import Context
from .._model import Model
from .._point_set import PointSet
from .._style import Style

LONG_SIDE = 1600
STROKE_SPACING = 1.25  # of marks along a stroke, in radii: near enough to make a line
MOST_MARKS = {"stipple": 300_000, "curvature": 800_000, "combing": 800_000}

# Ink over area at the darkest tone; of strokes that of one set, which leaves some paper between its lines.
_COVERAGE = {"stipple": 0.8, "curvature": 0.55, "combing": 0.55}


def _unit(v: Any) -> Any:
    return v / np.linalg.norm(v)


def view_direction(up: Sequence[float], azimuth: float, elevation: float) -> Tuple[float, float, float]:
    """From the eye into the scene.  Azimuth 0 looks from the front: +z, or -y where z is up."""
    upward = _unit(np.asarray(up, dtype=float))
    front = np.array([0.0, 0.0, 1.0]) if abs(upward[2]) < 0.9 else np.array([0.0, -1.0, 0.0])
    front = _unit(front - (front @ upward) * upward)
    right = np.cross(upward, front)
    around, above = math.radians(azimuth), math.radians(elevation)
    eye = math.cos(above) * (math.cos(around) * front + math.sin(around) * right) + math.sin(above) * upward
    x, y, z = -eye
    return float(x), float(y), float(z)


def frame(camera: Camera, points: Any, size: Union[int, Tuple[int, int]], margin: float) -> Camera:
    """The camera with its picture cut to where the points are.

    `size` is that of the picture, or its longer side alone: the shorter one is then as the points
    need it.  The eye stays where it is.
    """
    view, projection = np.asarray(camera.view), np.asarray(camera.projection)
    clip = np.column_stack([points, np.ones(len(points))]) @ (projection @ view).T
    seen = clip[:, :2] / clip[:, 3:]
    low, high = seen.min(axis=0), seen.max(axis=0)
    old = np.asarray(camera.viewport[2:])
    extent = np.maximum((high - low) / 2 * old, 1e-6)  # in the old picture's pixels
    if isinstance(size, int):
        sides = size * extent / extent.max()
        width, height = (max(round(side), size // 4, 1) for side in sides)
    else:
        width, height = size
    new = np.array([width, height])
    scale = float(((1 - 2 * margin) * new / extent).min())
    cut = np.eye(4)
    for axis in range(2):
        cut[axis, axis] = scale * old[axis] / new[axis]
        cut[axis, 3] = -cut[axis, axis] * (low[axis] + high[axis]) / 2
    return Camera(view, cut @ projection, (0, 0, width, height))


def pixels_per_unit(camera: Camera, place: Any) -> float:
    """Of the picture, for a length across the view at a place."""
    view, projection = np.asarray(camera.view), np.asarray(camera.projection)
    clip = projection @ view @ np.append(np.asarray(place, dtype=float), 1.0)
    return float(camera.viewport[3] / 2 * abs(projection[1, 1]) / abs(clip[3]))


def pen_radius(size: Tuple[int, int]) -> float:
    """Radius of the pen for a picture, in pixels."""
    return max(1.0, max(size) / 800)


def probe(model: Model, context: Context) -> PointSet:
    """A few marks spread evenly over the model, to learn its area and where it is."""
    return PointSet.generate(model, "stipple", budget=2000, context=context)


def positions(marks: PointSet) -> Any:
    """Absolute positions of all marks."""
    parts = [np.asarray(marks.positions(group), dtype=float) for group in marks.groups]
    return np.concatenate(parts) + np.asarray(marks.origin)


def marks(
    groups: Sequence[str], style: Style, area: float, pixels: float, options: Dict[str, Any], centres: int
) -> Dict[str, Any]:
    """Arguments of `PointSet.generate` that fill the darkest tone; `options` are those given."""
    if options.get("distribution") == "paper":
        return _paper_levels(groups, style, area * pixels**2, options, centres)
    chosen: Dict[str, Any] = {}
    budget: Dict[str, int] = {}
    for name in groups:
        radius = getattr(style, name).radius
        if name == "stipple":
            wanted = _COVERAGE[name] * area * pixels**2 / (math.pi * radius**2)
        else:
            # Both sets have area / separation of length each.
            step = STROKE_SPACING * radius / pixels
            chosen["stroke_step"] = min(step, chosen.get("stroke_step", step))
            wanted = 2 * area * pixels * _COVERAGE[name] / (2 * radius) / step
            if options.get("stroke_separation"):
                continue  # as many as there are
        budget[name] = max(1, min(MOST_MARKS[name], round(wanted)))
    return {**chosen, "budget": {**budget, **options.get("budget", {})}}


def layers(groups: Sequence[str], style: Style) -> Dict[str, Tuple[float, float]]:
    """Equal parts of the tones for the layers that the style draws; some groups are only there for paper."""
    drawn = []
    for name in ("stipple", "curvature", "combing"):
        if name not in groups or not getattr(style, name).shown:
            continue
        if name == "stipple":
            drawn.append(name)
        else:
            sets = getattr(style, name).sets
            drawn += [f"{name}_{which}" for bit, which in enumerate(("first", "second")) if sets >> bit & 1]
    return {layer: (k / len(drawn), (k + 1) / len(drawn)) for k, layer in enumerate(drawn)}


def _paper_levels(
    groups: Sequence[str], style: Style, area_in_pixels: float, options: Dict[str, Any], centres: int
) -> Dict[str, Any]:
    """As many refinement steps as do not overfill the picture."""
    levels = {}
    for name in groups:
        wanted = area_in_pixels / (math.pi * getattr(style, name).radius ** 2)
        seeds, factor = (centres, 5) if name == "stipple" else (2 * centres, 3)
        steps = math.log(max(wanted, 1) / max(seeds, 1), factor)
        levels[name] = min(max(round(steps), 1), 6)
    return {"levels": {**levels, **options.get("levels", {})}}
