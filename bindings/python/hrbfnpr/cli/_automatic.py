# SPDX-License-Identifier: MIT
"""Good choices for what the user leaves open, from the picture that is asked for."""
from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from .._camera import Camera
from .._context import Context
from .._layer import Layer
from .._model import Model
from .._point_set import PointSet
from .._style import Style

LONG_SIDE = 1600
STROKE_SPACING = 1.25  # of marks along a stroke, in radii: near enough to make a line
HATCH_LINES = 300  # of hatching, all levels, in the root of the area
MOST_MARKS = 2_000_000  # of a layer, unless --marks says more: some 500 bytes each while they are placed and drawn
MOST_LEVELS = 6  # the same of the published recursion
AZIMUTH, ELEVATION = 30.0, 20.0  # of a camera of which nothing is said
_LOOKS_ONE_WAY = 0.25  # length of the mean normal: half of a sphere has 0.5, a box without one side 0.17
_UNSEEN = 4000  # of a layer of which nothing is drawn: what lines hide, they know by themselves

# Ink over area at the darkest tone; of strokes that of one direction, which leaves some paper between its lines.
_COVERAGE = {"stipples": 0.8, "principal": 0.55, "combing": 0.55}


def _unit(v: Any) -> Any:
    return v / np.linalg.norm(v)


def _axes(up: Sequence[float]) -> Any:
    """Unit vectors up, to the front and to its right."""
    upward = _unit(np.asarray(up, dtype=float))
    front = np.array([0.0, 0.0, 1.0]) if abs(upward[2]) < 0.9 else np.array([0.0, -1.0, 0.0])
    front = _unit(front - (front @ upward) * upward)
    return upward, front, np.cross(upward, front)


def view_direction(up: Sequence[float], azimuth: float, elevation: float) -> Tuple[float, float, float]:
    """From the eye into the scene.  Azimuth 0 looks from the front: +z, or -y where z is up."""
    upward, front, right = _axes(up)
    around, above = math.radians(azimuth), math.radians(elevation)
    eye = math.cos(above) * (math.cos(around) * front + math.sin(around) * right) + math.sin(above) * upward
    x, y, z = -eye
    return float(x), float(y), float(z)


def front_azimuth(up: Sequence[float], normal: Any) -> Optional[float]:
    """From where an open surface of this mean normal shows its front, if the usual camera sees its back; degrees."""
    usual = -np.array(view_direction(up, AZIMUTH, ELEVATION))
    upward = _axes(up)[0]
    if normal @ usual >= 0 or np.linalg.norm(normal - (normal @ upward) * upward) < _LOOKS_ONE_WAY:
        return None
    return float(round(azimuth_of(up, normal) + AZIMUTH) % 360)


def azimuth_of(up: Sequence[float], direction: Any) -> float:
    """From where an eye sees what looks in this direction; degrees, 0 to 360."""
    _, front, right = _axes(up)
    return math.degrees(math.atan2(direction @ right, direction @ front)) % 360


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
    """Radius of the pen for a picture, in pixels.  Below 600 pixels nothing gets finer: it would be grey."""
    return max(0.75, max(size) / 800)


def probe(model: Model, context: Context) -> PointSet:
    """A few marks spread evenly over the model, to learn its area and where it is."""
    return PointSet.generate(model, budget=2000, context=context)


def positions(marks: PointSet) -> Any:
    """Absolute positions of all marks."""
    parts = [np.asarray(layer.positions, dtype=float) for layer in marks.layers]
    return np.concatenate(parts) + np.asarray(marks.origin)


Note = Callable[[str], None]


def marks(
    layers: Sequence[Layer], style: Style, area: float, pixels: float, published: bool, seeds: int, note: Note
) -> List[Layer]:
    """The layers with what fills the darkest tone, where they do not say themselves; `note` is told what is cut."""
    fill = _published if published else _even
    return [fill(layer, style.style_of(layer.kind, layer.name).radius, area, pixels, seeds, note) for layer in layers]


def few_of_unseen(layers: Sequence[Layer], style: Style) -> List[Layer]:
    """The layers with few marks where a style draws lines alone, and they do not say themselves."""
    if not style.lines or any(one.shown for one in style.layers):
        return list(layers)
    return [layer if _says_itself(layer) else replace(layer, budget=_UNSEEN) for layer in layers]


def _says_itself(layer: Layer) -> bool:
    return layer.budget is not None or (layer.kind != "stipples" and layer.separation > 0)  # as many as there are


def _even(layer: Layer, radius: float, area: float, pixels: float, seeds: int, note: Note) -> Layer:
    if layer.kind == "hatch":
        # The same lines whatever the picture: they are nested, and the finest are not always drawn.
        return layer if layer.budget or layer.separation else replace(layer, separation=math.sqrt(area) / HATCH_LINES)
    if layer.kind == "stipples":
        wanted = _COVERAGE[layer.kind] * area * pixels**2 / (math.pi * radius**2)
    else:
        # Both directions have area / separation of length each.
        step = STROKE_SPACING * radius / pixels
        wanted = 2 * area * pixels * _COVERAGE[layer.kind] / (2 * radius) / step
        layer = replace(layer, step=layer.step or step)
    if _says_itself(layer):
        return layer
    if wanted > MOST_MARKS:
        name = layer.name or layer.kind
        note(
            f"{name}: {wanted:.0f} marks would fill the darkest tone, {MOST_MARKS} are made, so that it gets "
            f"{MOST_MARKS / wanted:.0%} of its ink: --marks {layer.kind}={wanted:.0f} makes all, and with a larger "
            "--mark-radius fewer are needed"
        )
    return replace(layer, budget=max(1, min(MOST_MARKS, round(wanted))))


def _published(layer: Layer, radius: float, area: float, pixels: float, seeds: int, note: Note) -> Layer:
    """As many refinement steps as do not overfill the picture."""
    if layer.levels is not None:
        return layer
    wanted = area * pixels**2 / (math.pi * radius**2)
    start, factor = (seeds, 5) if layer.kind == "stipples" else (2 * seeds, 3)
    steps = round(math.log(max(wanted, 1) / max(start, 1), factor))
    if steps > MOST_LEVELS:
        name = layer.name or layer.kind
        note(
            f"{name}: {steps} refinement steps would fill the picture, {MOST_LEVELS} are taken, so that dark tones are "
            f"pale: --levels {layer.kind}={steps} takes all"
        )
    return replace(layer, levels=min(max(steps, 1), MOST_LEVELS))


def in_turn(layers: Sequence[Layer], style: Style) -> List[Layer]:
    """Equal parts of the tones for what the style draws; some layers are only there for contours."""
    styles = [style.style_of(layer.kind, layer.name) for layer in layers]
    drawn: List[Tuple[int, str]] = []
    for i, (layer, how) in enumerate(zip(layers, styles)):
        if layer.kind == "hatch":
            continue  # its style says at which tones there are lines
        if how.shown and layer.kind == "stipples":
            drawn.append((i, "tone"))
        elif how.shown:
            drawn += [(i, {"first": "tone", "second": "second_tone"}[name]) for name in how.directions]
    result = list(layers)
    for k, (i, field) in enumerate(drawn):
        changes: Dict[str, Any] = {field: (k / len(drawn), (k + 1) / len(drawn))}
        result[i] = replace(result[i], **changes)
    return result
