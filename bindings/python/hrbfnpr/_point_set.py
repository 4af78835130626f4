"""Point sets: marks on a surface."""
from __future__ import annotations

from typing import Any, Callable, Iterable, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _streams
from ._arrays import FLOATS, Array, block_in, output, store, wrap
from ._callbacks import CallbackState, callback, check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._function import points_of
from ._handles import Owner, own
from ._library import ffi, lib
from ._model import Model
from ._names import (
    DENSITIES,
    DISTRIBUTIONS,
    GROUP_SEEDS,
    GROUPS,
    LAYERS,
    ORDERS,
    SEED_SOURCES,
    STROKE_FIELDS,
    group_bits,
    group_names,
    number_of,
)
from ._operation import Operation, Progress, running
from ._point_set_info import PointSetInfo, Vector, read_info

PerGroup = Union[int, Mapping[str, int]]
Density = Union[str, Callable[[Array, Array], Array]]

# Attribute -> components, types that the library takes (the last one is what others become).
_ATTRIBUTES = {
    "position": (3, FLOATS),
    "normal": (3, FLOATS),
    "direction": (3, FLOATS),
    "curvature": (3, FLOATS),
    "rank": (1, FLOATS),
    "level": (1, "B"),
    "stroke": (2, "I"),
    "width": (1, FLOATS),
}


class StepPatches(NamedTuple):
    """Result of `PointSet.step_patches`."""

    corners: Array
    step: float


def _per_group(argument: str, value: Optional[PerGroup]) -> List[Tuple[int, int]]:
    """(group's number, value) pairs of one number for all groups, or of some by name."""
    if value is None:
        return []
    if isinstance(value, Mapping):
        return [(number_of(argument, GROUPS, name), int(given)) for name, given in value.items()]
    return [(number, int(value)) for number in GROUPS.values()]


@callback("int32_t(void *, int64_t, const double *, const double *, double *)", failure=1)
def _on_density(user: Any, count: int, positions: Any, normals: Any, density: Any) -> int:
    result = ffi.from_handle(user).function(points_of(positions, count), points_of(normals, count))
    store("the result of density", result, count, 1, "d", density)
    return 0


def _fill_density(desc: Any, density: Density) -> Tuple[Optional[CallbackState], Any]:
    """The state of a density function, and what must be kept alive."""
    if not callable(density):
        desc.density = number_of("density", {k: v for k, v in DENSITIES.items() if k != "callback"}, density)
        return None, None
    state = CallbackState(density)
    user = state.new_handle()
    desc.density = DENSITIES["callback"]
    desc.density_function, desc.density_user = _on_density, user
    return state, user


def _load(data: bytes) -> PointSet:
    return PointSet.load(data)


_PLAIN_FIELDS = (
    "box_resolution", "box_jitter", "initial_step", "projection_tolerance", "random_seed",
    "stroke_separation", "stroke_step", "stroke_length", "density_strength", "shared_budget",
)  # fmt: skip


def _generate_desc(
    groups: Union[str, Iterable[str]] = ("stipple",),
    *,
    distribution: str = "blue_noise",
    seed_source: str = "auto",
    seed_points: Optional[Array] = None,
    levels: Optional[PerGroup] = None,
    budget: Optional[PerGroup] = None,
    stroke_seeds: str = "seeds",
    seed_level: int = 0,
    stroke_field: str = "cross",
    density: Density = "uniform",
    order: str = "separate",
    layers: Optional[Mapping[str, Tuple[float, float]]] = None,
    curvature_of: Union[str, Iterable[str]] = (),
    **plain: Any,
) -> Tuple[Any, Optional[CallbackState], Any]:
    """The library's descriptor, the state of its density function, and what must be kept alive.

    Arguments as in `generate`.
    """
    desc = new_struct("hrbfnpr_generate_desc")
    desc.groups = group_bits(groups)
    desc.distribution = number_of("distribution", DISTRIBUTIONS, distribution)
    desc.seed_source = number_of("seed_source", SEED_SOURCES, seed_source)
    desc.stroke_field = number_of("stroke_field", STROKE_FIELDS, stroke_field)
    desc.order = number_of("order", ORDERS, order)
    for layer, (begin, end) in (layers or {}).items():
        part = desc.layer[number_of("layers", LAYERS, layer)]
        part.begin, part.end = begin, end
    state, user = _fill_density(desc, density)
    keep = [user]
    if seed_points is not None:
        keep.append(block_in("seed_points", seed_points).fill(desc.seed_points))
        if desc.seed_source == SEED_SOURCES["auto"]:
            desc.seed_source = SEED_SOURCES["points"]
    for name in group_names(group_bits(curvature_of)):
        flag = {"stipple": "STIPPLES", "combing": "COMBING"}.get(name)  # the third always has it
        desc.flags |= ffi.integer_const(f"HRBFNPR_GENERATE_CURVATURE_OF_{flag}") if flag else 0
    for number, value in _per_group("levels", levels):
        desc.group[number].levels = value
    for number, value in _per_group("budget", budget):
        desc.group[number].budget = value
    for name in ("curvature", "combing"):
        desc.group[GROUPS[name]].seeds = number_of("stroke_seeds", GROUP_SEEDS, stroke_seeds)
        desc.group[GROUPS[name]].seed_level = seed_level
    for name, value in plain.items():
        if name not in _PLAIN_FIELDS:
            raise TypeError(f"unexpected argument {name!r}")
        setattr(desc, name, value)
    return desc, state, keep


class PointSet(Owner):
    """Marks on a surface: stipples, and strokes along principal or combed directions [NPAR 5].

    Immutable: any number of threads may use one set at a time.  Made by `generate`, `from_arrays` or
    `load`; can be pickled, and is then loaded in the default context.

    The attributes of a group (``"stipple"``, ``"curvature"``, ``"combing"``) are read-only arrays on
    the set's own memory: nothing is copied, and they stay valid after the set is gone.
    """

    def __init__(self, handle: Any, context: Context) -> None:
        super().__init__(handle)
        self._context = context._handle
        self._info: Optional[PointSetInfo] = None

    @classmethod
    def generate(
        cls,
        model: Model,
        groups: Union[str, Iterable[str]] = ("stipple",),
        *,
        distribution: str = "blue_noise",
        seed_source: str = "auto",
        box_resolution: int = 8,
        box_jitter: float = 0.25,
        initial_step: float = 0.0,
        projection_tolerance: float = 1e-7,
        random_seed: int = 1,
        seed_points: Optional[Array] = None,
        levels: Optional[PerGroup] = None,
        budget: Optional[PerGroup] = None,
        stroke_seeds: str = "seeds",
        seed_level: int = 0,
        stroke_separation: float = 0.0,
        stroke_step: float = 0.0,
        stroke_length: float = 0.0,
        stroke_field: str = "cross",
        density: Density = "uniform",
        density_strength: float = 0.5,
        order: str = "separate",
        layers: Optional[Mapping[str, Tuple[float, float]]] = None,
        shared_budget: int = 0,
        curvature_of: Union[str, Iterable[str]] = (),
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> PointSet:
        """Place marks on the surface of a model.

        Parameters
        ----------
        model : Model
        groups : str or iterable of str
            Of "stipple", "curvature", "combing"; see also `Style.groups`.
        distribution : {"blue_noise", "paper"}
            Evenly spread in a progressive order (default), or the published recursion.
        seed_source : {"auto", "samples", "box", "points"}
            The model's samples; a jittered grid in its box; or `seed_points`.
        box_resolution, box_jitter : int, float
            Cells along the longest side (1 to 256) and jitter in cell sides (0 to 0.5) [NPAR 4.2].
        initial_step : float
            rho_0 of the "paper" distribution, in the unit of the model; 0 = estimated.
        projection_tolerance : float
            As in `Model.project`.
        random_seed : int
        seed_points : array of float, shape (n, 3), optional
            Given, they are the seeds unless `seed_source` says otherwise.
        levels : int or mapping of group to int, optional
            Refinement steps of the "paper" distribution, 0 to 12; by default 4 for stipples and 3
            for strokes, which have 3^levels marks.
        budget : int or mapping of group to int, optional
            The most marks, of both sets of strokes together; 0 (default) = 40000 with "blue_noise",
            no limit with "paper" or for strokes with a `stroke_separation`.
        stroke_seeds : {"seeds", "stipples"}
            What strokes of the "paper" distribution start from.
        seed_level : int
            With "stipples", the last stippling level used.
        stroke_separation : float
            Mean distance of neighbouring "blue_noise" strokes of one set, in the unit of the model;
            0 = such that they have as many marks as the budget.
        stroke_step : float
            Distance of the marks of such a stroke; 0 = a fifth of the separation.
        stroke_length : float
            The longest such stroke; 0 = no limit.
        stroke_field : {"cross", "line"}
            Whether such strokes go straight on where the two directions change places, or turn.
        density : {"uniform", "curvature"} or callable
            Where "blue_noise" stipples are denser: where the surface bends, or as a function says.
            It gets positions and unit normals, shape (n, 3) each, and returns n numbers from 0
            (none) to 1 (densest).
        density_strength : float
            0 to 1: of "curvature".
        order : {"separate", "layered"}
            Whether the ranks of each layer of marks cover all tones, or one layer appears after
            the other from light to dark: stipples, the two sets of "curvature", those of "combing".
        layers : mapping of str to (float, float), optional
            The darkness at which the first mark of a layer ("stipple", "curvature_first",
            "curvature_second", "combing_first", "combing_second") is shown, and at which all are.
        shared_budget : int
            The most marks of all groups together, divided by the layers' parts of the tones;
            0 = each group has its own `budget`.
        curvature_of : iterable of str
            Groups beside "curvature" whose marks shall know their curvature too.
        progress, operation, context
            As in `Model.fit`.

        Raises
        ------
        InvalidArgumentError, OutOfMemoryError, CancelledError
        NotConvergedError
            If all seeds were dropped.
        CallbackError
            If a function of the model raised.
        """
        context = resolve(context)
        desc, density_state, keep = _generate_desc(
            groups,
            distribution=distribution,
            seed_source=seed_source,
            box_resolution=box_resolution,
            box_jitter=box_jitter,
            initial_step=initial_step,
            projection_tolerance=projection_tolerance,
            random_seed=random_seed,
            seed_points=seed_points,
            levels=levels,
            budget=budget,
            stroke_seeds=stroke_seeds,
            seed_level=seed_level,
            stroke_separation=stroke_separation,
            stroke_step=stroke_step,
            stroke_length=stroke_length,
            stroke_field=stroke_field,
            density=density,
            density_strength=density_strength,
            order=order,
            layers=layers,
            shared_budget=shared_budget,
            curvature_of=curvature_of,
        )
        out, error = ffi.new("hrbfnpr_point_set **"), new_error()
        with running(operation, progress, context._handle) as (handle, state):
            status = lib.hrbfnpr_point_set_generate(context._handle, model._handle, desc, handle, out, error)
            check(status, error, state, density_state, shared=model._function)
        del keep
        return cls(own(out[0], lib.hrbfnpr_point_set_release, context), context)

    @classmethod
    def from_arrays(
        cls,
        groups: Mapping[str, Mapping[str, Array]],
        *,
        random_seed: int = 1,
        context: Optional[Context] = None,
    ) -> PointSet:
        """Ready-made marks; the arrays are copied.

        Parameters
        ----------
        groups : mapping of group to mapping of attribute to array
            Attributes: position (n, 3), absolute, and normal (n, 3) are needed; direction (n, 3),
            curvature (n, 3), rank (n), level (n), stroke (n, 2) and width (n) may be left out.
        random_seed : int
            For ranks that are not given.

        Examples
        --------
        >>> marks = hrbfnpr.PointSet.from_arrays({"stipple": {"position": points, "normal": normals}})
        """
        context = resolve(context)
        desc = new_struct("hrbfnpr_point_set_desc")
        desc.random_seed = random_seed
        keep = []
        for name, arrays in groups.items():
            target = desc.group[number_of("group", GROUPS, name)]
            for attribute, value in arrays.items():
                if attribute not in _ATTRIBUTES:
                    raise ValueError(f"{name} has no attribute {attribute!r}; it may have {', '.join(_ATTRIBUTES)}")
                block = block_in(f"{name}.{attribute}", value, *_ATTRIBUTES[attribute])
                keep.append(block.fill(getattr(target, attribute)))
        out, error = ffi.new("hrbfnpr_point_set **"), new_error()
        check(lib.hrbfnpr_point_set_create_from_arrays(context._handle, desc, out, error), error)
        del keep
        return cls(own(out[0], lib.hrbfnpr_point_set_release, context), context)

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
        """Squares that show how long the initial step is on the surface [NPAR 5.1, Figure 5].

        Parameters
        ----------
        model : Model
        count : int
            How many squares of side 2 rho_0, in tangent planes of randomly chosen seeds.
        **generate
            What `generate` would be called with.

        Returns
        -------
        StepPatches
            corners (count, 4, 3), counter-clockwise seen from outside, and the step rho_0.
        """
        context = resolve(context)
        desc, _, keep = _generate_desc(**generate)
        corners, view = output("corners", None, (count,), 12, "d")
        step, error = ffi.new("double *"), new_error()
        with running(operation, progress, context._handle) as (handle, state):
            status = lib.hrbfnpr_point_set_step_patches(
                context._handle, model._handle, desc, view, step, handle, error
            )
            check(status, error, state, shared=model._function)
        del keep
        if hasattr(corners, "reshape"):
            corners = corners.reshape(count, 4, 3)
        return StepPatches(corners, step[0])

    @property
    def info(self) -> PointSetInfo:
        """Counts, steps and seconds, per group and level."""
        if self._info is None:
            info, error = new_struct("hrbfnpr_point_set_info"), new_error()
            check(lib.hrbfnpr_point_set_get_info(self._handle, info, error), error)
            self._info = read_info(info)
        return self._info

    @property
    def groups(self) -> Tuple[str, ...]:
        """The groups that have marks."""
        return tuple(name for name, group in self.info.group.items() if group.count > 0)

    @property
    def origin(self) -> Vector:
        """Add it to `positions` to get absolute coordinates."""
        return self.info.origin

    @property
    def bounds(self) -> Tuple[Vector, Vector]:
        """Two corners of the box of all marks."""
        return self.info.bounds_min, self.info.bounds_max

    def __len__(self) -> int:
        return sum(group.count for group in self.info.group.values())

    def _view(self, group: str, attribute: str) -> Array:
        view, error = ffi.new("hrbfnpr_array *"), new_error()
        number = number_of("group", GROUPS, group)
        constant = ffi.integer_const(f"HRBFNPR_ATTRIBUTE_{attribute}")
        check(lib.hrbfnpr_point_set_view(self._handle, number, constant, view, error), error)
        return wrap(view, self._handle)

    def positions(self, group: str) -> Array:
        """float32 (n, 3), relative to `origin`."""
        return self._view(group, "POSITION")

    def normals(self, group: str) -> Array:
        """float32 (n, 3), unit, outward."""
        return self._view(group, "NORMAL")

    def directions(self, group: str) -> Array:
        """float32 (n, 3), unit, tangent: along the stroke; for a stipple the u of its basis [NPAR 5.2]."""
        return self._view(group, "DIRECTION")

    def curvatures(self, group: str) -> Array:
        """float32 (n, 3): k1, k2, confidence; empty where not generated (see `curvature_of`)."""
        return self._view(group, "CURVATURE")

    def ranks(self, group: str) -> Array:
        """float32 (n,): the u of [NPAR 6.2] in [0, 1); a mark is shown where u >= tau."""
        return self._view(group, "RANK")

    def levels(self, group: str) -> Array:
        """uint8 (n,): the refinement step, or the pass of strokes, that placed the mark."""
        return self._view(group, "LEVEL")

    def strokes(self, group: str) -> Array:
        """uint32 (n, 2): stroke (2 number + set) and the mark's place along it; a stipple's seed and 0."""
        return self._view(group, "STROKE")

    def widths(self, group: str) -> Array:
        """float32 (n,): of the ink, relative, in (0, 1]; tapered strokes only, else empty."""
        return self._view(group, "WIDTH")

    def save(self, target: _streams.Target) -> None:
        """Write to a path (atomically) or a binary file object; versioned and checksummed."""
        _streams.save(lib.hrbfnpr_point_set_save, self._handle, target)

    def to_bytes(self) -> bytes:
        """What `save` writes."""
        return _streams.to_bytes(lib.hrbfnpr_point_set_save, self._handle)

    @classmethod
    def load(cls, source: _streams.Source, *, context: Optional[Context] = None) -> PointSet:
        """Read from a path, a binary file object or bytes; raises as `Model.load`."""
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
        counts = ", ".join(f"{self.info.group[name].count} {name}" for name in self.groups)
        return f"<hrbfnpr.PointSet {counts or 'empty'}>"
