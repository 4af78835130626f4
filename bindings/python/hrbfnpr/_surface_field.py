# SPDX-License-Identifier: MIT
"""Fields: values on a surface."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Iterable, NamedTuple, Optional, Sequence, Tuple, Union

from ._arrays import FLOATS, INDICES, Array, block_in, output, store, vector
from ._callbacks import CallbackState, callback
from ._camera import Camera
from ._context import Context, resolve
from ._errors import new_list, new_struct
from ._function import points_of
from ._handles import Owner
from ._library import ffi, lib
from ._names import FIELD_KINDS, FORMATS, number_of
from ._operation import Operation, Progress, make, run

if TYPE_CHECKING:
    from ._shading import Occluders

FieldFunction = Callable[[Array, Array], Any]


class FieldValues(NamedTuple):
    """What a field gives: `values`, (n,) or (n, 3), and `weights` (n,), from 0 where it says nothing to 1."""

    values: Array
    weights: Array


@dataclass
class Dab:
    """A dab of a brush: a ball in which a field moves towards a value.

    Parameters
    ----------
    position : sequence of float
        Middle of the ball.
    normal : sequence of float
        Normal of the surface there.  Surface that faces away from it is not painted.
    radius : float
        Radius of the ball, above 0.
    value : float or sequence of 3 floats
        The value: a number, or the r, g, b of a colour, or a direction.
    strength : float
        Strength in the middle, 0 to 1.  It falls to 0 at the radius.
    """

    position: Sequence[float]
    normal: Sequence[float]
    radius: float
    value: Union[float, Sequence[float]] = 0.0
    strength: float = 1.0

    def _fill(self, target: Any, kind: str) -> None:
        target.position, target.normal = vector("position", self.position), vector("normal", self.normal)
        target.radius, target.strength = self.radius, self.strength
        if kind == "scalar":
            target.value = self.value
        else:
            target.direction = vector("value", self.value)


@callback("int32_t(void *, int64_t, const double *, const double *, double *, double *)", failure=1)
def _on_field(user: Any, count: int, positions: Any, normals: Any, values: Any, weights: Any) -> int:
    state = ffi.from_handle(user)
    result = state.function(points_of(positions, count), points_of(normals, count))
    if isinstance(result, tuple):
        result, its_weights = result
        store("the weights of a field", its_weights, count, 1, "d", weights)
    store("the values of a field", result, count, state.components, "d", values)
    return 0


class _FieldState(CallbackState):
    def __init__(self, function: FieldFunction, components: int) -> None:
        super().__init__(function)
        self.components = components


def _components(kind: str) -> int:
    return 1 if kind == "scalar" else 3


def _kind_of(kind: Optional[str], values: Any) -> str:
    """The kind, or that of the values if None: a row of 3 numbers is a colour."""
    if kind is None:
        shape = getattr(values, "shape", None)
        first = values[0] if shape is None and len(values) else None
        has_rows = len(shape) > 1 and shape[1] == 3 if shape is not None else hasattr(first, "__len__")
        kind = "colour" if has_rows else "scalar"
    number_of("kind", FIELD_KINDS, kind)
    return kind


class Field(Owner):
    """Values on a surface: a number, a colour or a direction at each place, and a weight.

    Make one with `from_points`, `from_function`, `from_dabs` or `from_image`.  Give it to `PointSet.with_fields`, or to
    `Layer.density` and `Layer.direction`.  A field never changes, and several threads may use it at the same time.

    Examples
    --------
    >>> field = hrbfnpr.Field.from_points(points, heat, triangles, range=(20, 90))
    >>> marks = marks.with_fields({"heat": field})
    >>> style.layer("stipples").tone_field = "heat"
    """

    def __init__(self, handle: Any, kind: str, function: Optional[CallbackState] = None) -> None:
        super().__init__(handle)
        self._kind, self._function = kind, function

    @classmethod
    def _make(
        cls, desc: Any, kind: str, range: Optional[Tuple[float, float]], progress: Optional[Progress],
        operation: Optional[Operation], context: Optional[Context], function: Optional[CallbackState] = None, user: Any = None,
    ) -> Field:  # fmt: skip
        context = resolve(context)
        desc.kind = number_of("kind", FIELD_KINDS, kind)
        if range is not None:
            desc.range = vector("range", range, 2)
        given = context._handle, desc
        made = make("field", lib.hrbfnpr_field_create, given, operation, progress, context._handle, (context, user))
        return cls(made, kind, function)

    @classmethod
    def from_points(
        cls, points: Array, values: Array, triangles: Optional[Array] = None, *, kind: Optional[str] = None,
        range: Optional[Tuple[float, float]] = None, reach: float = 0.0, progress: Optional[Progress] = None,
        operation: Optional[Operation] = None, context: Optional[Context] = None,
    ) -> Field:  # fmt: skip
        """Make a field from values at points, or at the vertices of a mesh.

        Parameters
        ----------
        points : array of float, shape (n, 3)
            The points.
        values : array, shape (n,) or (n, 3)
            The values.  Colours are sRGB-encoded, 0 to 1, or uint8 from 0 to 255.
        triangles : array of int, shape (m, 3), optional
            Numbers of points.  With triangles, values are interpolated on the nearest one.  Without, a place has the value
            of the nearest point.
        kind : {"scalar", "colour", "direction"}, optional
            The kind of values.  None: "colour" for rows of 3 numbers, else "scalar".
        range : (float, float), optional
            For "scalar": the first number becomes 0, the second 1, and values are clamped.  None: values stay as they are.
        reach : float
            Distance from the points or triangles beyond which a place has no value; 0: there is no such distance.
        progress, operation, context
            As in `Model.fit`.

        Raises
        ------
        InvalidArgumentError
            If an array has a wrong shape, or a triangle a corner that does not exist.
        """
        desc, kind = new_struct("hrbfnpr_field_desc"), _kind_of(kind, values)
        codes = "B" + FLOATS
        keep = [block_in("points", points).fill(desc.points), block_in("values", values, _components(kind), codes).fill(desc.values)]
        if triangles is not None:
            keep.append(block_in("triangles", triangles, 3, INDICES).fill(desc.triangles))
        desc.reach = reach
        made = cls._make(desc, kind, range, progress, operation, context)
        del keep
        return made

    @classmethod
    def from_function(
        cls, function: FieldFunction, kind: str = "scalar", *, range: Optional[Tuple[float, float]] = None,
        context: Optional[Context] = None,
    ) -> Field:  # fmt: skip
        """Make a field from a function.

        Parameters
        ----------
        function : callable
            It gets positions and unit normals, shape (n, 3) each.  It returns n values, or a tuple of n values and n weights
            from 0 to 1.  It is called when the field is used.
        kind, range, context
            As in `from_points`.
        """
        desc = new_struct("hrbfnpr_field_desc")
        desc.source = ffi.integer_const("HRBFNPR_FIELD_SOURCE_FUNCTION")
        state = _FieldState(function, _components(kind))
        desc.function, desc.user = _on_field, (user := state.new_handle())
        return cls._make(desc, kind, range, None, None, context, state, user)

    @classmethod
    def from_dabs(
        cls, dabs: Iterable[Dab], kind: str = "scalar", *, range: Optional[Tuple[float, float]] = None,
        context: Optional[Context] = None,
    ) -> Field:  # fmt: skip
        """Make a field from dabs of a brush, which act one after the other.

        Parameters
        ----------
        dabs : iterable of Dab
            The dabs.
        kind, range, context
            As in `from_points`.
        """
        desc, given = new_struct("hrbfnpr_field_desc"), list(dabs)
        desc.source = ffi.integer_const("HRBFNPR_FIELD_SOURCE_DABS")
        structs = new_list("hrbfnpr_dab", len(given))
        for dab, target in zip(given, structs):
            dab._fill(target, kind)
        desc.dabs, desc.dab_count = structs, len(given)
        return cls._make(desc, kind, range, None, None, context)

    @classmethod
    def from_image(
        cls, image: Array, camera: Camera, *, kind: str = "colour", occluders: Optional[Occluders] = None,
        range: Optional[Tuple[float, float]] = None, context: Optional[Context] = None,
    ) -> Field:  # fmt: skip
        """Make a field from an image that is projected onto the surface along a camera.

        Places that the camera does not see have no value: those outside the image, those that face away, and those that
        `occluders` hide.

        Parameters
        ----------
        image : array of uint8 or float32, shape (height, width, 4)
            The pixels, straight RGBA, sRGB-encoded.  Alpha is the weight.
        camera : Camera
            The camera.  The image fills its viewport.
        kind : {"colour", "scalar"}
            "colour" takes the colour, "scalar" its luminance.
        occluders : Occluders, optional
            The surfaces that hide places from the camera.
        range, context
            As in `from_points`.
        """
        desc, pixels = new_struct("hrbfnpr_field_desc"), new_struct("hrbfnpr_image")
        desc.source = ffi.integer_const("HRBFNPR_FIELD_SOURCE_IMAGE")
        block = block_in("image", image, 4, "Bf")
        if len(block.shape) != 2:
            raise ValueError(f"image must have the shape (height, width, 4), not {(*block.shape, 4)}")
        if block.stride != 4 * (1 if block.code == "B" else 4):
            raise ValueError("image must be packed; give a copy of it")
        pixels.height, pixels.width = block.shape
        pixels.format = FORMATS["rgba8" if block.code == "B" else "rgba32f"]
        pixels.pixels = ffi.cast("void *", block.address)
        desc.image, desc.camera = pixels, camera._struct
        desc.occluders = ffi.NULL if occluders is None else occluders._handle
        made = cls._make(desc, kind, range, None, None, context)
        del block
        return made

    @property
    def kind(self) -> str:
        """The kind of values: "scalar", "colour" or "direction"."""
        return self._kind

    def evaluate(
        self, positions: Array, normals: Optional[Array] = None, *, progress: Optional[Progress] = None,
        operation: Optional[Operation] = None, context: Optional[Context] = None,
    ) -> FieldValues:  # fmt: skip
        """Return the values and weights at places.

        Parameters
        ----------
        positions : array of float, shape (n, 3)
            The places.
        normals : array of float, shape (n, 3), optional
            The unit normals of the surface there.  Fields of points do not need them.
        progress, operation, context
            As in `Model.fit`.
        """
        at = block_in("positions", positions)
        facing = None if normals is None else block_in("normals", normals)
        values, value_view = output("values", None, (at.count,), _components(self._kind), "d")
        weights, weight_view = output("weights", None, (at.count,), 1, "d")
        given = self._handle, at.view(), ffi.NULL if facing is None else facing.view(), value_view, weight_view
        run(lib.hrbfnpr_field_evaluate, given, operation, progress, resolve(context)._handle, shared=self._function)
        return FieldValues(values, weights)

    def __repr__(self) -> str:
        return f"<hrbfnpr.Field {'closed' if self.closed else self._kind}>"
