# SPDX-License-Identifier: MIT
"""Makes meshes of round beams."""
from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np

from ._shape import Floats, Integers

MOST_CAPSULES = 10_000  # largest number of capsules that are made
_MOST_FACES = 400_000  # largest number of faces of all capsules, unless their sides are as few as they may be
_SIDES = (6, 24)  # least and largest number of sides around a beam
_RINGS = 4  # number of rings of corners on each end, besides its tip


def capsules(first: Floats, second: Floats, radii: Floats, flat: Any) -> Tuple[Floats, Integers]:
    """The corners and triangles of closed, round beams: each is the hull of a ball at its first and one at its second end.

    `radii`: of both balls, n x 2.  `flat`: n x 2; an end is a disc where this is true.  A beam without length is a ball.
    """
    count = len(first)
    along = second - first
    length = np.linalg.norm(along, axis=1)
    axis = np.where(length[:, None] > 0, along / np.where(length > 0, length, 1.0)[:, None], [0.0, 0.0, 1.0])
    helper = np.eye(3)[np.abs(axis).argmin(axis=1)]
    right = np.cross(axis, helper)
    right /= np.linalg.norm(right, axis=1)[:, None]
    up = np.cross(axis, right)
    # The cone between the balls touches them at this angle from the plane across the beam.
    slope = (radii[:, 0] - radii[:, 1]) / np.where(length > 0, length, 1.0)
    touch = np.arcsin(np.clip(np.where(length > 0, slope, 0.0), -0.99, 0.99))
    sides = int(np.clip(_MOST_FACES // max(1, 4 * _RINGS * count), *_SIDES))
    turn = 2 * np.pi * np.arange(sides) / sides
    around = np.cos(turn)[:, None] * right[:, None] + np.sin(turn)[:, None] * up[:, None]  # count x sides x 3
    rings: List[Floats] = []
    for end, centre, sign in ((0, first, -1.0), (1, second, 1.0)):
        for step in range(_RINGS) if sign > 0 else range(_RINGS - 1, -1, -1):
            angle = touch + (sign * np.pi / 2 - touch) * step / _RINGS
            radius, off = radii[:, end] * np.cos(angle), radii[:, end] * np.sin(angle)
            ball = centre[:, None] + axis[:, None] * off[:, None, None] + around * radius[:, None, None]
            disc = centre[:, None] + around * (radii[:, end] * (1 - step / _RINGS))[:, None, None]
            rings.append(np.where(flat[:, end][:, None, None], disc, ball))
    tips = [centre + sign * axis * np.where(flat[:, end], 0.0, radii[:, end])[:, None]
            for end, centre, sign in ((0, first, -1.0), (1, second, 1.0))]  # fmt: skip
    corners = np.concatenate([np.stack(rings, 1).reshape(count, -1, 3), np.stack(tips, 1)], axis=1)
    one = _triangles(sides, 2 * _RINGS)
    triangles = one[None] + (np.arange(count) * corners.shape[1])[:, None, None]
    return corners.reshape(-1, 3), triangles.reshape(-1, 3)


def _triangles(sides: int, rings: int) -> Integers:
    """The triangles of one capsule: between its rings, then those at its two tips, which are the last corners."""
    here = np.arange(sides)
    following = (here + 1) % sides
    parts = [np.column_stack([here, following, np.full(sides, rings * sides)])[:, ::-1]]
    for ring in range(rings - 1):
        a, b = ring * sides + here, ring * sides + following
        parts += [np.column_stack([a, b, b + sides]), np.column_stack([a, b + sides, a + sides])]
    last = (rings - 1) * sides
    parts.append(np.column_stack([last + here, last + following, np.full(sides, rings * sides + 1)]))
    result: Integers = np.concatenate(parts).astype(np.int64)
    return result
