# SPDX-License-Identifier: MIT
"""Solids that are built from other models."""
from __future__ import annotations

import math
import numbers
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from . import _records
from ._arrays import vector
from ._callbacks import check
from ._errors import new_error, new_struct
from ._handles import Owner, own
from ._library import ffi, lib
from ._names import CSG_KINDS
from ._records import get

if TYPE_CHECKING:
    from ._records import CsgInfo

Self = TypeVar("Self", bound="Combining")
Triple = Sequence[float]
Matrix = List[List[float]]
Box = Optional[Tuple[Triple, Triple]]


class SharedFunctions:
    """The functions of several models, and the exception of the call that failed."""

    def __init__(self, states: Sequence[Any]) -> None:
        self._states = states

    @property
    def exception(self) -> Optional[BaseException]:
        return next((state.exception for state in self._states if state.exception is not None), None)

    @exception.setter
    def exception(self, value: Optional[BaseException]) -> None:
        for state in self._states:
            state.exception = value


def _functions_of(models: Sequence[Combining]) -> Any:
    states: List[Any] = []
    for model in models:
        if model._function is not None and model._function not in states:
            states.append(model._function)
    return states[0] if len(states) == 1 else SharedFunctions(states) if states else None


def affine(matrix: Any) -> Matrix:
    """The four rows of an affine map, from rows of 3 x 4 or 4 x 4 numbers."""
    rows = [vector("matrix", row, 4) for row in matrix]
    if len(rows) == 3:
        rows.append([0.0, 0.0, 0.0, 1.0])
    if len(rows) != 4:
        raise ValueError(f"matrix must have 3 or 4 rows of 4 numbers, not {len(rows)}")
    return rows


def frame(center: Triple, axis: Triple) -> Matrix:
    """The map that puts the origin at the centre and turns the z axis to the axis by the smallest angle."""
    at, along = vector("center", center), vector("axis", axis)
    length = math.sqrt(sum(c * c for c in along))
    if not 0.0 < length < math.inf:
        raise ValueError("axis must have a length")
    x, y, z = (c / length for c in along)
    if z < 0.0:  # first a half turn about the x axis; the rest of the turn is then at most a quarter turn
        k = 1.0 / (1.0 - z)
        turn = [[1.0 - k * x * x, k * x * y, x], [-k * x * y, k * y * y - 1.0, y], [x, -y, z]]
    else:
        k = 1.0 / (1.0 + z)
        turn = [[1.0 - k * x * x, -k * x * y, x], [-k * x * y, 1.0 - k * y * y, y], [-x, -y, z]]
    return [[*row, c] for row, c in zip(turn, at)] + [[0.0, 0.0, 0.0, 1.0]]


def node(kind: str, parent: int = -1, matrix: Optional[Matrix] = None, **numbers: Any) -> Dict[str, Any]:
    """The fields of a node of the tree."""
    fields: Dict[str, Any] = {"kind": CSG_KINDS[kind], "parent": parent, **numbers}
    if matrix is not None:
        fields["transform"] = [matrix[row][column] for column in range(4) for row in range(4)]
    return fields


def create(cls: Type[Self], context: Any, nodes: List[Dict[str, Any]], leaves: Sequence[Combining], box: Box) -> Self:
    """A solid of class `cls`, made from nodes in the context (a handle).  `leaves` are the models of the nodes."""
    array = ffi.new("hrbfnpr_csg_node[]", len(nodes))
    for struct, fields in zip(array, nodes):
        lib.hrbfnpr_csg_node_init(ffi.addressof(struct), ffi.sizeof("hrbfnpr_csg_node"))
        for name, value in fields.items():
            setattr(struct, name, value)
    desc = new_struct("hrbfnpr_csg_desc")
    desc.nodes, desc.node_count = array, len(nodes)
    if box is not None:
        desc.bounds_min, desc.bounds_max = (vector("bounds", corner) for corner in box)
    out, error = ffi.new("hrbfnpr_model **"), new_error()
    check(lib.hrbfnpr_model_create_csg(context, desc, out, error), error)
    model = cls.__new__(cls)
    Owner.__init__(model, own(out[0], lib.hrbfnpr_model_release, context))
    model._context, model._function = context, _functions_of(leaves)
    return model


def union_of_balls(cls: Type[Self], context: Any, centers: Any, radii: Any) -> Self:
    """The union of balls, with creases where they meet."""
    balls = [node("sphere", 0, frame(center, (0.0, 0.0, 1.0)), radius=radius) for center, radius in zip(centers, radii)]
    return create(cls, context, [node("union"), *balls], (), None)


class Combining(Owner):
    """The part of `Model` that makes solids from models."""

    _context: Any
    _function: Any

    def _combined(self: Self, root: Dict[str, Any], others: Sequence[Combining], bounds: Box) -> Self:
        leaves: List[Combining] = [self, *others]
        nodes = [root, *(node("model", 0, model=leaf._handle) for leaf in leaves)]
        return create(type(self), self._context, nodes, leaves, bounds)

    def _several(
        self: Self, kind: str, others: Sequence[Combining], radius: float, exponent: float, bounds: Box
    ) -> Self:
        for other in others:
            if not isinstance(other, Combining):
                raise TypeError(f"solids combine with models, not with {type(other).__name__}")
        return self._combined(node(kind, blend=radius, exponent=exponent), others, bounds)

    def union(
        self: Self, *others: Combining, radius: float = 0.0, exponent: float = 0.0, bounds: Box = None
    ) -> Self:
        """Make the union: everything inside this model or another one; also ``a | b``.

        Models of any kind may be combined, except trimmed ones: fit those with ``trim="never"``.  A fitted model ends at
        its search box.  Without a blend, the surfaces meet in creases.

        Parameters
        ----------
        *others : Model
            The other models.
        radius : float
            Radius of the blend that rounds the places where the models meet, in the model's unit, 0 or more; 0 = a
            crease.  A larger radius rounds more.
        exponent : float
            Shape of the blend.  0: twice continuously differentiable everywhere; at a right angle it begins at the
            distance `radius` from the edge.  2 to 64: a super-ellipse; 2 gives an arc of the radius at a right angle, and
            larger exponents are sharper.
        bounds : (minimum, maximum), optional
            Two corners of the box in which the surface is looked for; None: found from the models.

        Raises
        ------
        InvalidArgumentError
            If the surface may have no end (give bounds), or nothing is left of the solid.
        """
        return self._several("union", others, radius, exponent, bounds)

    def intersection(
        self: Self, *others: Combining, radius: float = 0.0, exponent: float = 0.0, bounds: Box = None
    ) -> Self:
        """Make the intersection: everything inside all models; also ``a & b``.  Parameters are those of `union`."""
        return self._several("intersection", others, radius, exponent, bounds)

    def difference(
        self: Self, *others: Combining, radius: float = 0.0, exponent: float = 0.0, bounds: Box = None
    ) -> Self:
        """Make the difference: this model without the others; also ``a - b``.  Parameters are those of `union`."""
        return self._several("difference", others, radius, exponent, bounds)

    def blend(self: Self, other: Combining, radius: float, exponent: float = 0.0) -> Self:
        """Make the union of two models with a blend of this radius where they meet.  Parameters are those of `union`."""
        return self.union(other, radius=radius, exponent=exponent)

    def __or__(self: Self, other: Any) -> Self:
        if isinstance(other, Combining):
            return self.union(other)
        return NotImplemented

    def __and__(self: Self, other: Any) -> Self:
        if isinstance(other, Combining):
            return self.intersection(other)
        return NotImplemented

    def __sub__(self: Self, other: Any) -> Self:
        if isinstance(other, Combining):
            return self.difference(other)
        return NotImplemented

    def __invert__(self: Self) -> Self:
        """Exchange inside and outside; the surface stays the same."""
        return self._combined(node("complement"), (), None)

    def offset(self: Self, distance: float, *, bounds: Box = None) -> Self:
        """Move the surface outward by a distance, or inward if it is negative.

        The new surface is where f equals `distance`, in the model's unit.  It is exact where f is the distance from the
        old surface.  `bounds` is that of `union`.
        """
        return self._combined(node("offset", distance=distance), (), bounds)

    def shell(self: Self, thickness: float, *, bounds: Box = None) -> Self:
        """Make a hollow body: a wall of this thickness (above 0, in the model's unit) inside the surface, which stays."""
        return self._combined(node("shell", distance=thickness), (), bounds)

    def transformed(self: Self, matrix: Any) -> Self:
        """Move the model by an affine map.

        The map may turn, mirror and stretch.  Its largest stretch may be 1e4 times its least.  If it stretches unevenly, f
        is measured by the least stretch, so that the length of grad f does not grow.

        Parameters
        ----------
        matrix : array of float, shape (3, 4) or (4, 4)
            The rows of the matrix, which acts on column vectors.
        """
        return self._moved(affine(matrix))

    def translated(self: Self, x: float, y: float, z: float) -> Self:
        """Move the model by the vector (x, y, z)."""
        return self._moved([[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]])

    def rotated(self: Self, angle: float, axis: Triple = (0.0, 0.0, 1.0)) -> Self:
        """Turn the model about an axis through the origin, by an angle in degrees, by the right-hand rule."""
        direction = vector("axis", axis)
        length = math.sqrt(sum(c * c for c in direction))
        if not 0.0 < length < math.inf:
            raise ValueError("axis must have a length")
        x, y, z = (c / length for c in direction)
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        t = 1.0 - c
        return self._moved(
            [
                [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0],
                [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0],
                [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )

    def scaled(self: Self, factor: Union[float, Triple]) -> Self:
        """Scale the model about the origin, by one factor or by one for each axis.

        Factors may be negative, which mirrors, but not 0.  For unequal factors, see `transformed`.
        """
        if isinstance(factor, numbers.Real):
            factor = [float(factor)] * 3
        x, y, z = vector("factor", factor)
        return self._moved([[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, z, 0.0], [0.0, 0.0, 0.0, 1.0]])

    def _moved(self: Self, matrix: Matrix) -> Self:
        return self._combined(node("union", matrix=matrix), (), None)

    @property
    def csg_info(self) -> CsgInfo:
        """What the solid consists of, as `CsgInfo`."""
        return get(_records.CsgInfo, lib.hrbfnpr_model_get_csg_info, self._handle)
