# SPDX-License-Identifier: MIT
"""Views of a technical drawing: which way each one looks, and planes that cut."""
from __future__ import annotations

import argparse
import math
from dataclasses import dataclass
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..shapes._shape import Floats
from . import _automatic
from ._values import number

NAMES = ("front", "back", "left", "right", "top", "bottom", "iso")
# Axes of the model are drawn at the scale in an isometric view, not shorter by this as they are seen [ISO 5456-3].
ISOMETRIC = math.sqrt(1.5)
_ALONG = 1e-6  # cosine of directions that are at right angles


class Cut(NamedTuple):
    """A plane as it was asked for: where `normal` . x is `place`, which None puts through the middle."""

    normal: Tuple[float, float, float]
    place: Optional[float]
    is_signed: bool  # whether the normal says from which side it is seen


@dataclass(frozen=True)
class Plane:
    """Where `normal` . x is `place`; the normal, of unit length, goes to the eye of the section."""

    name: str
    normal: Floats
    place: float


@dataclass(frozen=True)
class View:
    """Unit vectors to the right, upward and towards the eye, and how much larger than the scale it is drawn."""

    name: str
    right: Floats
    up: Floats
    eye: Floats
    factor: float = 1.0
    plane: Optional[Plane] = None

    def flat(self, points: Floats, middle: Floats) -> Floats:
        """Where points are seen, from the middle: to the right and downward, in units of the model."""
        away = np.asarray(points, dtype=float) - middle
        return np.asarray(self.factor * np.stack((away @ self.right, -(away @ self.up)), axis=-1), dtype=float)

    def edge_on(self, normal: Floats) -> bool:
        """Whether a plane is seen as a line."""
        return bool(self.name != "iso" and abs(float(normal @ self.eye)) < _ALONG)


def views(text: str) -> Tuple[str, ...]:
    """Names of views, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in NAMES:
            raise argparse.ArgumentTypeError(f"there is no view {name!r}; there are {', '.join(NAMES)}")
    return names


def cut(text: str) -> Cut:
    """AXIS, AXIS:PLACE or A:B:C:D, where A x + B y + C z = D."""
    parts = text.split(":")
    axis = parts[0].lstrip("+-")
    if axis in ("x", "y", "z") and len(parts) <= 2:
        sign = -1.0 if parts[0].startswith("-") else 1.0
        x, y, z = (sign if one == axis else 0.0 for one in "xyz")
        place = sign * number(parts[1]) if len(parts) == 2 else None
        return Cut((x, y, z), place, parts[0] != axis)
    if len(parts) == 4:
        a, b, c, d = (number(part) for part in parts)
        if any((a, b, c)):
            return Cut((a, b, c), d, True)
    raise argparse.ArgumentTypeError(f"{text!r} must be AXIS:PLACE, such as z:20, AXIS alone for the middle, or the "
                                     "plane A:B:C:D, where Ax + By + Cz = D")  # fmt: skip


def frame(up: Sequence[float]) -> Tuple[Floats, Floats, Floats]:
    """To the right, upward and to the front, of the model as it stands."""
    upward = np.asarray(up, dtype=float)
    upward /= np.linalg.norm(upward)
    front = -np.asarray(_automatic.view_direction(up, 0.0, 0.0))
    return np.cross(upward, front), upward, front


def _towards(name: str, eye: Floats, axes: Tuple[Floats, Floats, Floats], **more: Any) -> View:
    """Seen from there, upright; from above or below the front is at the bottom or at the top."""
    _, upward, front = axes
    along = float(eye @ upward)
    up = -math.copysign(1.0, along) * front if abs(along) > 1 - _ALONG else upward - along * eye
    up = up / np.linalg.norm(up)
    return View(name, np.cross(up, eye), up, eye, **more)


def standard(names: Sequence[str], up: Sequence[float]) -> List[View]:
    """The views of these names."""
    axes = right, upward, front = frame(up)
    side = -right if "left" in names and "right" not in names else right
    eyes: Dict[str, Floats] = {
        "front": front, "back": -front, "left": -right, "right": right, "top": upward, "bottom": -upward,
        "iso": (front + upward + side) / math.sqrt(3.0),
    }  # fmt: skip
    return [_towards(name, eyes[name], axes, factor=ISOMETRIC if name == "iso" else 1.0) for name in names]


def planes(cuts: Sequence[Cut], names: Sequence[str], up: Sequence[float], middle: Floats) -> List[Plane]:
    """Named A, B, ..., each seen from the front, from above or from the side that is drawn, unless it has a sign."""
    right, upward, front = frame(up)
    towards = front + upward + (-right if "left" in names and "right" not in names else right)
    found = []
    for i, one in enumerate(cuts):
        length = float(np.linalg.norm(one.normal))
        normal = np.asarray(one.normal, dtype=float) / length
        place = float(normal @ middle) if one.place is None else one.place / length
        turn = 1.0 if one.is_signed or normal @ towards >= 0 else -1.0
        found.append(Plane("ABCDEFGHJKLMNPQRSTUVWXYZ"[i % 24] * (1 + i // 24), turn * normal, turn * place))
    return found


def section(plane: Plane, up: Sequence[float]) -> View:
    """The view of what is behind a plane."""
    return _towards(f"{plane.name}-{plane.name}", plane.normal, frame(up), plane=plane)
