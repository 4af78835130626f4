# SPDX-License-Identifier: MIT
"""Point sets: layers of marks on a surface."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _records, _streams
from ._arrays import Array, block_in, matrix_in, output
from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_list, new_struct
from ._handles import Owner, own
from ._layer import LayersToMake, OwnLayer, layers_to_make
from ._library import ffi, lib
from ._marks import MarkLayer
from ._model import Model
from ._names import DISTRIBUTIONS, FIELD_KINDS, SEED_SOURCES, TONE_RANGES, name_of, number_of
from ._operation import Operation, Progress, make, run
from ._records import Vector, get
from ._surface_field import Field, FieldValues

if TYPE_CHECKING:
    from ._records import PlacementInfo, PointSetInfo


class StepPatches(NamedTuple):
    """Result of `PointSet.step_patches`: `corners` (count, 4, 3) and `step`, the initial step."""

    corners: Array
    step: float


def _load(data: bytes) -> PointSet:
    return PointSet.load(data)


def _generate_desc(
    layers: Optional[LayersToMake] = None,
    *,
    preset: Optional[str] = None,
    distribution: str = "blue_noise",
    shared_budget: int = 0,
    tone_ranges: str = "full",
    seed_source: str = "auto",
    seed_points: Optional[Array] = None,
    box_resolution: int = 8,
    box_jitter: float = 0.25,
    initial_step: float = 0.0,
    projection_tolerance: float = 1e-7,
    random_seed: int = 1,
    **fields: Any,
) -> Tuple[Any, List[Optional[CallbackState]], Any]:
    """The library's descriptor, the states of its functions, and the objects to keep alive.

    The arguments are those of `generate`.
    """
    desc = new_struct("hrbfnpr_generate_desc")
    desc.distribution = number_of("distribution", DISTRIBUTIONS, distribution)
    desc.shared_budget = shared_budget
    desc.tone_ranges = number_of("tone_ranges", TONE_RANGES, tone_ranges)
    desc.seed_source = number_of("seed_source", SEED_SOURCES, seed_source)
    desc.box_resolution, desc.box_jitter = box_resolution, box_jitter
    desc.initial_step, desc.projection_tolerance = initial_step, projection_tolerance
    desc.random_seed = random_seed
    keep: List[Any] = []
    if seed_points is not None:
        keep.append(block_in("seed_points", seed_points).fill(desc.seed_points))
        if desc.seed_source == SEED_SOURCES["auto"]:
            desc.seed_source = SEED_SOURCES["points"]
    wanted = layers_to_make(layers, preset, distribution, fields)
    descs = new_list("hrbfnpr_layer_desc", len(wanted))
    states: List[Optional[CallbackState]] = []
    for layer, target in zip(wanted, descs):
        its_states, kept = layer._fill(target, desc.distribution)
        states += its_states
        keep.append(kept)
    desc.layers, desc.layer_count = descs, len(wanted)
    return desc, states, [*keep, descs]


class PointSet(Owner):
    """Layers of marks on a surface: stipples, strokes, and marks of your own [NPAR 5].

    Make one with `generate` (or `Model.generate`), `create` or `load`.  A point set never changes, and several threads may
    use it at the same time.  It can be pickled; it is then loaded in the default context.  ``len`` gives the number of
    marks.
    """

    def __init__(self, handle: Any, context: Context) -> None:
        super().__init__(handle)
        self._context = context._handle
        self._info: Optional[PointSetInfo] = None
        self._layers: Optional[Tuple[MarkLayer, ...]] = None

    def close(self) -> None:
        """Release the handle.  Layers and views that were taken before stay valid."""
        super().close()
        self._layers = None

    @classmethod
    def generate(
        cls,
        model: Model,
        layers: Optional[LayersToMake] = None,
        *,
        preset: Optional[str] = None,
        distribution: str = "blue_noise",
        shared_budget: int = 0,
        tone_ranges: str = "full",
        seed_source: str = "auto",
        seed_points: Optional[Array] = None,
        box_resolution: int = 8,
        box_jitter: float = 0.25,
        initial_step: float = 0.0,
        projection_tolerance: float = 1e-7,
        random_seed: int = 1,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
        **fields: Any,
    ) -> PointSet:
        """Place marks on the surface of a model.

        Parameters
        ----------
        model : Model
            The model.
        layers : str, Layer, or an iterable of these
            The layers to make: "stipples" (default), "hatch", or `Layer` objects.
        preset : str, optional
            A name of `hrbfnpr.PRESETS`, instead of `layers`: make the layers that this named style draws.
        distribution : {"blue_noise", "published"}
            "blue_noise" (default): evenly spread marks in a progressive order.  "published": the published recursion, with
            random ranks.
        shared_budget : int
            Largest number of marks of all layers together, which share it in proportion to their tone ranges; 0 = each
            layer has its own `budget`.
        tone_ranges : {"full", "in_turn"}
            "full": each layer covers all tones.  "in_turn": the layers follow each other from light to dark; with
            "published" strokes, the first direction comes before the second.
        seed_source : {"auto", "samples", "box", "points"}
            Where marks start.  "auto": at the model's samples, or as "box" if it has none.  "samples": at the samples.
            "box": at a jittered grid in the model's bounds.  "points": at `seed_points`.
        seed_points : array of float, shape (n, 3), optional
            The seeds.  If they are given, "auto" takes them.
        box_resolution : int
            For "box": number of cells along the longest side, 1 to 256 [NPAR 4.2].  More cells miss fewer parts.
        box_jitter : float
            For "box": largest random shift of the grid points, in sides of a cell, 0 to 0.5.
        initial_step : float
            rho_0, the first step of the distribution "published", in the model's unit; 0 = estimated.
        projection_tolerance : float
            As `tolerance` of `Model.project`.
        random_seed : int
            Start of the random numbers.  Another number gives other marks.
        progress, operation, context
            As in `Model.fit`.
        **fields
            Fields of `Layer` for the layers that are given by name, such as budget=20000 or separation=0.05.  Each is used
            for the layers for which it has a meaning.

        Returns
        -------
        PointSet
            The marks.

        Raises
        ------
        InvalidArgumentError
            If an argument is out of its range.
        NotConvergedError
            If no seed or no mark could be placed.
        CallbackError
            If a function of the model or of a layer raised an exception.
        OutOfMemoryError, CancelledError
        """
        context = resolve(context)
        desc, states, keep = _generate_desc(
            layers,
            preset=preset,
            distribution=distribution,
            shared_budget=shared_budget,
            tone_ranges=tone_ranges,
            seed_source=seed_source,
            seed_points=seed_points,
            box_resolution=box_resolution,
            box_jitter=box_jitter,
            initial_step=initial_step,
            projection_tolerance=projection_tolerance,
            random_seed=random_seed,
            **fields,
        )
        given = context._handle, model._handle, desc
        made = make("point_set", lib.hrbfnpr_point_set_generate, given, operation, progress, context._handle, context,
                    states=states, shared=model._function)  # fmt: skip
        del keep
        return cls(made, context)

    @classmethod
    def create(
        cls,
        layers: Union[OwnLayer, Iterable[OwnLayer]] = (),
        *,
        base: Optional[PointSet] = None,
        random_seed: int = 1,
        context: Optional[Context] = None,
    ) -> PointSet:
        """Make a point set from ready-made marks, or from the layers of another set followed by ready-made marks.

        Parameters
        ----------
        layers : OwnLayer or iterable of OwnLayer
            The layers of ready-made marks.
        base : PointSet, optional
            A set whose layers come first.  The result keeps its origin.
        random_seed : int
            Start of the random numbers for ranks that are not given.
        context : Context, optional
            As in `Model.fit`.

        Raises
        ------
        InvalidArgumentError
            If there is no mark, or a number is wrong; the message names the layer, the array and the index.

        Examples
        --------
        >>> marks = hrbfnpr.PointSet.create(hrbfnpr.OwnLayer(points, normals), base=marks)
        """
        context = resolve(context)
        given = [layers] if isinstance(layers, OwnLayer) else list(layers)
        desc = new_struct("hrbfnpr_point_set_desc")
        desc.random_seed = random_seed
        if base is not None:
            desc.base = base_handle = base._handle
        arrays = new_list("hrbfnpr_layer_arrays", len(given))
        keep = [layer._fill(target) for layer, target in zip(given, arrays)]
        desc.layers, desc.layer_count = arrays, len(given)
        out, error = ffi.new("hrbfnpr_point_set **"), new_error()
        check(lib.hrbfnpr_point_set_create(context._handle, desc, out, error), error)
        del keep
        if base is not None:
            del base_handle
        return cls(own(out[0], lib.hrbfnpr_point_set_release, context), context)

    def with_fields(
        self,
        fields: Mapping[str, Optional[Field]],
        *,
        transform: Optional[Array] = None,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> PointSet:
        """Return a set with the same marks, which also have values of fields.

        The marks are shared, not copied.  Values of other names stay.  They are saved and loaded with the set.  A style
        refers to fields by their names, see `LayerStyle.tone_field`.

        Parameters
        ----------
        fields : mapping of str to Field or None
            The fields by their names.  None removes the values of a name.
        transform : array of float, shape (4, 4), optional
            The matrix from the marks to the fields' coordinates, affine and invertible.  None: they are the same.
        progress, operation, context
            As in `Model.fit`.

        Raises
        ------
        InvalidArgumentError
            If a name has not 1 to 63 bytes, or the set would have more than 64 fields.
        CallbackError
            If the function of a field raised an exception.

        Examples
        --------
        >>> marks = marks.with_fields({"heat": hrbfnpr.Field.from_points(points, heat, range=(20, 90))})
        """
        context = resolve(context)
        structs = new_list("hrbfnpr_mark_field", len(fields))
        matrix = ffi.NULL if transform is None else ffi.new("double[16]", matrix_in("transform", transform))
        keep: List[Any] = [matrix]
        for target, (name, field) in zip(structs, fields.items()):
            target.name, target.transform = _records.text_in(keep, name), matrix
            if field is not None:
                target.field = field._handle
                keep.append(target.field)
        given = context._handle, self._handle, structs, len(fields), 0
        states = [field._function for field in fields.values() if field is not None]
        made = make("point_set", lib.hrbfnpr_point_set_with_fields, given, operation, progress, context._handle, context,
                    states=states)  # fmt: skip
        del keep
        return PointSet(made, context)

    @property
    def fields(self) -> Dict[str, str]:
        """The kinds of the set's fields ("scalar", "colour" or "direction") by their names."""
        result: Dict[str, str] = {}
        name, kind, error = ffi.new("const char **"), ffi.new("uint32_t *"), new_error()
        for number in range(self.info.field_count):
            check(lib.hrbfnpr_point_set_get_field(self._handle, number, name, kind, error), error)
            result[ffi.string(name[0]).decode()] = name_of(FIELD_KINDS, kind[0])
        return result

    def field(self, name: str) -> Tuple[FieldValues, ...]:
        """Return the values and weights of a field, for each layer; see `MarkLayer.field`."""
        return tuple(layer.field(name) for layer in self.layers)

    @staticmethod
    def step_patches(
        model: Model,
        count: int = 64,
        *,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
        **generate: Any,
    ) -> StepPatches:
        """Make squares that show how long the initial step is on the surface [NPAR 5.1, Figure 5].

        Parameters
        ----------
        model : Model
            The model.
        count : int
            Number of squares.  They have sides of 2 rho_0 and lie in the tangent planes of random seeds.
        progress, operation, context
            As in `Model.fit`.
        **generate
            The arguments of `generate`.

        Returns
        -------
        StepPatches
            `corners` (count, 4, 3), counter-clockwise as seen from outside, and `step`, the step rho_0.
        """
        context = resolve(context)
        desc, _, keep = _generate_desc(**generate)
        corners, view = output("corners", None, (count,), 12, "d")
        step = ffi.new("double *")
        given = context._handle, model._handle, desc, view, step
        run(lib.hrbfnpr_point_set_step_patches, given, operation, progress, context._handle, shared=model._function)
        del keep
        if hasattr(corners, "reshape"):
            corners = corners.reshape(count, 4, 3)
        return StepPatches(corners, step[0])

    @property
    def info(self) -> PointSetInfo:
        """Counts and times of the whole set.  Each layer has its own `info`."""
        if self._info is None:
            self._info = get(_records.PointSetInfo, lib.hrbfnpr_point_set_get_info, self._handle)
        return self._info

    @property
    def seed_placement(self) -> PlacementInfo:
        """What became of the candidates for seeds."""
        return get(_records.PlacementInfo, lib.hrbfnpr_point_set_get_seed_placement, self._handle)

    @property
    def layers(self) -> Tuple[MarkLayer, ...]:
        """The layers, in order."""
        if self._layers is None:
            self._layers = tuple(MarkLayer(self._handle, number) for number in range(self.info.layers))
        return self._layers

    def layer(self, which: Union[int, str]) -> MarkLayer:
        """Return a layer by its number, from 0, or by its name.  Raises KeyError if there is no such name."""
        if not isinstance(which, str):
            return self.layers[which]
        for layer in self.layers:
            if layer.name == which:
                return layer
        names = ", ".join(repr(layer.name) for layer in self.layers)
        raise KeyError(f"there is no layer {which!r}; there are {names}")

    @property
    def origin(self) -> Vector:
        """Add this to the `positions` of a layer to get absolute places."""
        return self.info.origin

    @property
    def bounds(self) -> Tuple[Vector, Vector]:
        """Two corners of the box around all marks."""
        return self.info.bounds_min, self.info.bounds_max

    def __len__(self) -> int:
        return self.info.marks

    def save(self, target: _streams.Target) -> None:
        """Write the marks to a path or to a binary file object, with a version and a checksum.

        A file is written whole or not at all.
        """
        _streams.save(lib.hrbfnpr_point_set_save, self._handle, target)

    def to_bytes(self) -> bytes:
        """Return the bytes that `save` writes."""
        return _streams.to_bytes(lib.hrbfnpr_point_set_save, self._handle)

    @classmethod
    def load(cls, source: _streams.Source, *, context: Optional[Context] = None) -> PointSet:
        """Read a point set from a path, a binary file object or bytes.  Errors are those of `Model.load`."""
        context = resolve(context)
        out = ffi.new("hrbfnpr_point_set **")
        functions = lib.hrbfnpr_point_set_load, lib.hrbfnpr_point_set_load_memory
        _streams.load(*functions, context._handle, out, source)
        return cls(own(out[0], lib.hrbfnpr_point_set_release, context), context)

    def __reduce__(self) -> Any:
        return _load, (self.to_bytes(),)

    def __repr__(self) -> str:
        if self.closed:
            return "<hrbfnpr.PointSet closed>"
        counts = ", ".join(f"{len(layer)} {layer.name}" for layer in self.layers)
        return f"<hrbfnpr.PointSet {counts or 'empty'}>"
