# SPDX-License-Identifier: MIT
"""Whether a picture is mostly blank, and why."""
from __future__ import annotations

from typing import Any, List, Union

import numpy as np

from .._camera import Camera, corners
from .._drawing import Drawing
from .._model import Model
from .._point_set import PointSet
from .._style import Style

SEEN = 16  # of 255, by which a pixel differs from the paper
LEAST_INK = 1e-4  # share of such pixels
LEAST_SHOWN = 0.03  # of the marks that face the eye, where a style shows tone by marks ...
MOST_HIDDEN = 0.4  # ... and more than this of them is behind something


class BlankError(ValueError):
    """The picture would be blank; the message says why."""


def check(drawing: Drawing, source: Union[Model, PointSet], camera: Camera, style: Style, flipped: bool) -> None:
    """Raise BlankError if hardly anything can be seen."""
    info = drawing.info
    ink = _ink(drawing, style)
    facing = info.front + info.silhouette
    few = any(layer.shown for layer in style.layers) and info.shown < LEAST_SHOWN * facing
    if ink >= LEAST_INK and not (few and info.dropped_hidden > MOST_HIDDEN * facing):
        return
    seen = "nothing is drawn"
    if ink > 0:
        seen = f"{info.shown} of {info.marks} marks are visible, and ink is on {ink:.2%} of it"
    raise BlankError(f"the picture would be blank: {seen}. {_why(drawing, source, camera, style, flipped)}")


def _ink(drawing: Drawing, style: Style) -> float:
    """Share of the picture that is not as the paper."""
    pixels = np.asarray(drawing.image(), dtype=float)
    paper = 255 * np.asarray(style.paper, dtype=float)
    colour = np.abs(pixels[..., :3] * pixels[..., 3:] - paper[:3] * paper[3]).max(axis=-1) / 255
    return float((np.maximum(colour, np.abs(pixels[..., 3] - paper[3])) >= SEEN).mean())


def _why(drawing: Drawing, source: Any, camera: Camera, style: Style, flipped: bool) -> str:
    info = drawing.info
    facing = info.front + info.silhouette
    if info.outside == info.marks or _in_view(source, camera) == 0:
        return (
            "The camera looks away from the model, or past it: leave out --eye and --direction, or let --target be in "
            "the model"
        )
    if np.ptp(np.array(corners(source)), axis=0).max() == 0:
        return "All samples are at one point"
    reasons: List[str] = []
    if info.back > 20 * facing:
        turn = "without --flip it is seen" if flipped else "--flip turns it over"
        reasons.append(
            "all that is in view looks away from the eye: another --azimuth shows its front, or --sides both draws its "
            f"back, or {turn}"
        )
    if info.dropped_hidden > MOST_HIDDEN * facing:
        turn = "leave out --flip" if flipped else "--flip turns them"
        reasons.append(
            f"{info.dropped_hidden} of {facing} marks that face the eye are behind something, as "
            f"where normals look inward: {turn}"
        )
    if info.dropped_tone > facing / 2 and not reasons:
        reasons.append("all is so light that no mark is drawn: --tone none draws all marks, --light turns the light")
    if info.dropped_depth > facing / 2:
        reasons.append("marks vanish with the distance: leave out --depth-range")
    if info.dropped_zoom > facing / 2:
        reasons.append("marks vanish with the zoom: leave out --zoom-reference")
    if all(tuple(one.ink[:3]) == tuple(style.paper[:3]) or one.ink[3] == 0 for one in style.layers if one.shown):
        reasons.append("the ink cannot be seen on the paper")
    if not reasons:
        reasons.append(
            "the model is too small in the picture, or the style draws no marks: try --style contour-and-stipple"
        )
    text = "; ".join(reasons)
    return text[0].upper() + text[1:]


def _in_view(source: Any, camera: Camera) -> int:
    """How many corners, middles of edges and of faces, and the middle of the box are in the picture."""
    low, high = (np.asarray(corner, dtype=float) for corner in corners(source))
    steps = np.array([[x, y, z] for x in (0, 0.5, 1) for y in (0, 0.5, 1) for z in (0, 0.5, 1)])
    places = np.column_stack([low + steps * (high - low), np.ones(len(steps))])
    clip = places @ (np.asarray(camera.projection) @ np.asarray(camera.view)).T
    return int((np.abs(clip[:, :3]) <= clip[:, 3:]).all(axis=1).sum())
