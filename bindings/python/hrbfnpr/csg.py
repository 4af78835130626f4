# SPDX-License-Identifier: MIT
"""Primitive solids, to combine with each other and with other models.

>>> from hrbfnpr import csg
>>> plate = csg.box((4, 3, 0.5)) - csg.cylinder(0.5, 2) - csg.half_space((2, 0, 0), (-1, 0, -1))
>>> part = plate.blend(csg.cylinder(0.4, 2, center=(1.2, 0.8, 0.5)), 0.3)

Each solid is a `Model`.  It can be drawn, and combined with any other model, such as a fit or a function: ``a | b``,
``a & b``, ``a - b``, ``~a``, `Model.blend`, `Model.offset`, `Model.shell`, `Model.transformed`.

For half-spaces, spheres and tori, f is the signed distance to the surface.  For boxes, cylinders and cones it is the
largest of the distances from their sides: exact inside, and outside where one side is nearest; less beside edges and
corners.  Lengths are in any unit.
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
    """Make a box with sides along the axes.

    Parameters
    ----------
    size : (x, y, z)
        Lengths of the sides, above 0.
    center : (x, y, z)
        The middle of the box.
    context : Context, optional
        As in `Model.fit`.
    """
    return _primitive("box", center, _UP, context, size=vector("size", size))


def sphere(radius: float, center: Triple = _ORIGIN, *, context: Optional[Context] = None) -> Model:
    """Make a ball of this radius, above 0, around `center`."""
    return _primitive("sphere", center, _UP, context, radius=radius)


def cylinder(
    radius: float, height: float, center: Triple = _ORIGIN, axis: Triple = _UP, *, context: Optional[Context] = None
) -> Model:
    """Make a cylinder with flat ends.

    Parameters
    ----------
    radius, height : float
        Radius and height, above 0.
    center : (x, y, z)
        The middle of the axis.
    axis : (x, y, z)
        The direction of the axis, of any length except 0.
    context : Context, optional
        As in `Model.fit`.
    """
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
    """Make a cone with flat ends; an end with the radius 0 is a tip.

    Parameters
    ----------
    radius : float
        Radius of the lower end, 0 or more.
    height : float
        Height, above 0.
    center : (x, y, z)
        The middle of the axis.
    axis : (x, y, z)
        The direction from the lower end to the upper end, of any length except 0.
    top_radius : float
        Radius of the upper end, 0 or more; one of the radii must be above 0.
    context : Context, optional
        As in `Model.fit`.
    """
    return _primitive("cone", center, axis, context, radius=radius, height=height, second_radius=top_radius)


def torus(
    radius: float,
    tube_radius: float,
    center: Triple = _ORIGIN,
    axis: Triple = _UP,
    *,
    context: Optional[Context] = None,
) -> Model:
    """Make a torus: a tube around a circle.

    Parameters
    ----------
    radius : float
        Radius of the circle.
    tube_radius : float
        Radius of the tube, above 0 and below `radius`.
    center : (x, y, z)
        The middle of the circle.
    axis : (x, y, z)
        The direction perpendicular to the circle, of any length except 0.
    context : Context, optional
        As in `Model.fit`.
    """
    return _primitive("torus", center, axis, context, radius=radius, second_radius=tube_radius)


def half_space(
    point: Triple = _ORIGIN,
    normal: Triple = _UP,
    *,
    bounds: Optional[Tuple[Triple, Triple]] = None,
    context: Optional[Context] = None,
) -> Model:
    """Make a half-space: everything on one side of a plane.  Use it to cut other solids.

    Parameters
    ----------
    point : (x, y, z)
        A point of the plane.
    normal : (x, y, z)
        The normal of the plane, of any length except 0; it points out of the half-space.
    bounds : (minimum, maximum), optional
        Two corners of the box at which the half-space ends when it is drawn alone; None: a cube from -1 to 1 around the
        point.  In a solid, the bounds are those of the solid.
    context : Context, optional
        As in `Model.fit`.
    """
    at = vector("point", point)
    around = bounds or ([c - 1.0 for c in at], [c + 1.0 for c in at])
    return _primitive("half_space", point, normal, context, around)
