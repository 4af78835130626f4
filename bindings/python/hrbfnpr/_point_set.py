# SPDX-License-Identifier: MIT
"""Point sets: layers of marks on a surface."""
from __future__ import annotations

from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

from . import _streams
from ._arrays import Array, block_in, output
from ._callbacks import CallbackState, check
from ._context import Context, resolve
from ._errors import new_error, new_list, new_struct
from ._handles import Owner, own
from ._layer import LayersToMake, OwnLayer, layers_to_make
from ._library import ffi, lib
from ._marks import MarkLayer
from ._model import Model
from ._names import DISTRIBUTIONS, SEED_SOURCES, TONE_RANGES, number_of
from ._operation import Operation, Progress, make, run
from ._records import PlacementInfo, PointSetInfo, Vector, get


class StepPatches(NamedTuple):
    """Result of `PointSet.step_patches`."""

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
    """The library's descriptor, the states of its functions, and what must be kept alive.

    Arguments as in `generate`.
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

    Immutable: any number of threads may use one set at a time.  Made by `generate` (or `Model.generate`),
    `create` or `load`; can be pickled, and is then loaded in the default context.
    """

    def __init__(self, handle: Any, context: Context) -> None:
        super().__init__(handle)
        self._context = context._handle
        self._info: Optional[PointSetInfo] = None
        self._layers: Optional[Tuple[MarkLayer, ...]] = None

    def close(self) -> None:
        """Let go of the handle.  Layers and views that were taken go on working."""
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
        layers : str, Layer, or an iterable of these
            "stipples" (default), "hatch", or a `Layer` that says more.
        preset : str, optional
            The layers that one of `hrbfnpr.PRESETS` draws, instead.
        **fields
            Fields of `Layer` for the layers that are given by name, such as budget=20000 or
            separation=0.05; each is used for the layers that it means something to.
        distribution : {"blue_noise", "published"}
            Evenly spread in a progressive order (default), or the published recursion.
        shared_budget : int
            The most marks of all layers together, divided by their parts of the tones; 0 = each layer has
            its own `budget`.
        tone_ranges : {"full", "in_turn"}
            Whether the ranks of each layer cover all tones, or one layer appears after the other from
            light to dark, each direction of strokes by itself.
        seed_source : {"auto", "samples", "box", "points"}
            The model's samples; a jittered grid in its box; or `seed_points`.
        seed_points : array of float, shape (n, 3), optional
            Given, they are the seeds unless `seed_source` says otherwise.
        box_resolution, box_jitter : int, float
            Cells along the longest side (1 to 256) and jitter in cell sides (0 to 0.5) [NPAR 4.2].
        initial_step : float
            rho_0 of the "published" distribution, in the unit of the model; 0 = estimated.
        projection_tolerance : float
            As in `Model.project`.
        random_seed : int
        progress, operation, context
            As in `Model.fit`.

        Raises
        ------
        InvalidArgumentError, OutOfMemoryError, CancelledError
        NotConvergedError
            If all seeds were dropped.
        CallbackError
            If a function of the model or of a layer raised.
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
        """Ready-made marks, or another set's layers and then these.

        Parameters
        ----------
        layers : OwnLayer or iterable of OwnLayer
        base : PointSet, optional
            Its layers come first.
        random_seed : int
            For ranks that are not given.

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
        step = ffi.new("double *")
        given = context._handle, model._handle, desc, view, step
        run(lib.hrbfnpr_point_set_step_patches, given, operation, progress, context._handle, shared=model._function)
        del keep
        if hasattr(corners, "reshape"):
            corners = corners.reshape(count, 4, 3)
        return StepPatches(corners, step[0])

    @property
    def info(self) -> PointSetInfo:
        """Counts and seconds; those of a layer are in its own `info`."""
        if self._info is None:
            self._info = get(PointSetInfo, lib.hrbfnpr_point_set_get_info, self._handle)
        return self._info

    @property
    def seed_placement(self) -> PlacementInfo:
        """What became of candidates for seeds."""
        return get(PlacementInfo, lib.hrbfnpr_point_set_get_seed_placement, self._handle)

    @property
    def layers(self) -> Tuple[MarkLayer, ...]:
        """The layers, in order."""
        if self._layers is None:
            self._layers = tuple(MarkLayer(self._handle, number) for number in range(self.info.layers))
        return self._layers

    def layer(self, which: Union[int, str]) -> MarkLayer:
        """A layer by its number or its name."""
        if not isinstance(which, str):
            return self.layers[which]
        for layer in self.layers:
            if layer.name == which:
                return layer
        names = ", ".join(repr(layer.name) for layer in self.layers)
        raise KeyError(f"there is no layer {which!r}; there are {names}")

    @property
    def origin(self) -> Vector:
        """Add it to `positions` of a layer to get absolute coordinates."""
        return self.info.origin

    @property
    def bounds(self) -> Tuple[Vector, Vector]:
        """Two corners of the box of all marks."""
        return self.info.bounds_min, self.info.bounds_max

    def __len__(self) -> int:
        return self.info.marks

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
        counts = ", ".join(f"{len(layer)} {layer.name}" for layer in self.layers)
        return f"<hrbfnpr.PointSet {counts or 'empty'}>"
