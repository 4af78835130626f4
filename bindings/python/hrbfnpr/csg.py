# SPDX-License-Identifier: MIT
"""Primitive solids, to put others together from.

>>> from hrbfnpr import csg
>>> plate = csg.box((4, 3, 0.5)) - csg.cylinder(0.5, 2) - csg.half_space((2, 0, 0), (-1, 0, -1))
>>> part = plate.blend(csg.cylinder(0.4, 2, center=(1.2, 0.8, 0.5)), 0.3)

Each is a `Model`: it can be drawn and asked as any other, and be combined with any other, fits and functions too:
``a | b``, ``a & b``, ``a - b``, ``~a``, `Model.blend`, `Model.offset`, `Model.shell`, `Model.transformed` ...

Half-space, sphere and torus have f exactly as far as it is to the surface; box, cylinder and cone inside, and outside
where a side is nearest: beside edges and corners f is less.
"""
from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

from ._arrays import vector
from ._context import Context, resolve
from ._csg import Box, Triple, create, frame, node
from ._model import Model

__all__ = ["box", "cone", "cylinder", "half_space", "sphere", "torus"]

_ORIGIN = (0.0, 0.0, 0.0)
_UP = (0.0, 0.0, 1.0)


def _primitive(
    kind: str, center: Triple, axis: Triple, context: Optional[Context], bounds: Box = None, **numbers: Any
) -> Model:
    nodes = [node(kind, matrix=frame(center, axis), **numbers)]
    return create(Model, resolve(context)._handle, nodes, (), bounds)


def box(size: Sequence[float], center: Triple = _ORIGIN, *, context: Optional[Context] = None) -> Model:
    """A box with these lengths of its sides, along the axes."""
    return _primitive("box", center, _UP, context, size=vector("size", size))


def sphere(radius: float, center: Triple = _ORIGIN, *, context: Optional[Context] = None) -> Model:
    """A ball."""
    return _primitive("sphere", center, _UP, context, radius=radius)


def cylinder(
    radius: float, height: float, center: Triple = _ORIGIN, axis: Triple = _UP, *, context: Optional[Context] = None
) -> Model:
    """A cylinder with flat ends; `center` is the middle of its axis."""
    return _primitive("cylinder", center, axis, context, radius=radius, height=height)


def cone(
    radius: float,
    height: float,
    center: Triple = _ORIGIN,
    axis: Triple = _UP,
    *,
    top_radius: float = 0.0,
    context: Optional[Context] = None,
) -> Model:
    """A cone with flat ends, or a point if a radius is 0; `center` is the middle of its axis."""
    return _primitive("cone", center, axis, context, radius=radius, height=height, second_radius=top_radius)


def torus(
    radius: float,
    tube_radius: float,
    center: Triple = _ORIGIN,
    axis: Triple = _UP,
    *,
    context: Optional[Context] = None,
) -> Model:
    """A tube around a circle about the axis."""
    return _primitive("torus", center, axis, context, radius=radius, second_radius=tube_radius)


def half_space(
    point: Triple = _ORIGIN,
    normal: Triple = _UP,
    *,
    bounds: Optional[Tuple[Triple, Triple]] = None,
    context: Optional[Context] = None,
) -> Model:
    """All that is behind the plane through a point; the normal points out of it.

    It has no end, and is what others are cut by.  Drawn itself it ends at `bounds`, two corners of a box; by default a
    cube from -1 to 1 about the point.  Solids that it is part of have bounds of their own.
    """
    at = vector("point", point)
    around = bounds or ([c - 1.0 for c in at], [c + 1.0 for c in at])
    return _primitive("half_space", point, normal, context, around)
