# SPDX-License-Identifier: MIT
"""Cameras that go around a model.  Needs NumPy."""
from __future__ import annotations

import math
from typing import Any, List

import numpy as np

from ._camera import Camera, corners
from ._scene import Scene, make_camera

_SIDES = 24  # of a turn, from which a picture is large enough for all of it


def about(axis: Any, centre: Any, degrees: float) -> Any:
    """The rotation about an axis through a point, a matrix of shape (4, 4)."""
    x, y, z = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    angle = math.radians(degrees)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    result = np.eye(4)
    result[:3, :3] += math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    result[:3, 3] = np.asarray(centre) - result[:3, :3] @ np.asarray(centre)
    return result


def _angles(frames: int, turn: float) -> List[float]:
    """Of the frames, from 0: a whole turn comes back to its first frame behind its last, a part ends at its end."""
    whole = math.isclose(abs(turn) % 360, 0, abs_tol=1e-9) and turn != 0
    return [turn * i / (frames if whole else max(frames - 1, 1)) for i in range(frames)]


def _centre(arguments: Any, source: Any) -> Any:
    low, high = (np.asarray(corner, dtype=float) for corner in corners(source))
    return (low + high) / 2 if arguments.eye is None or arguments.target is None else np.asarray(arguments.target)


def first_camera(arguments: Any, source: Any, places: Any, *, frames: int, turn: float) -> Camera:
    """The camera of the first frame: the picture has room for all others."""
    centre = _centre(arguments, source)
    angles = np.linspace(0, turn, min(_SIDES, frames) + 1)
    turned = [places @ (m := about(arguments.up, centre, -angle))[:3, :3].T + m[:3, 3] for angle in angles]
    swept = np.concatenate(turned)
    return make_camera(arguments, (swept.min(axis=0), swept.max(axis=0)), swept)


def cameras_of(scene: Scene, frames: int, turn: float) -> List[Camera]:
    """Those of an orbit about the up axis through the middle of the model, from the scene's own camera on."""
    centre, first = _centre(scene.arguments, scene.bounds), scene.camera
    view = np.asarray(first.view)
    return [
        Camera(view @ about(scene.arguments.up, centre, -angle), first.projection, first.viewport, first.depth_convention)
        for angle in _angles(frames, turn)
    ]
