# SPDX-License-Identifier: MIT
"""Layers of marks to be made, and layers of the caller's own marks."""
from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from ._arrays import FLOATS, Array, block_in, store
from ._callbacks import CallbackState, callback
from ._errors import check
from ._function import points_of
from ._library import ffi, lib
from ._names import (
    DENSITIES,
    DISTRIBUTIONS,
    GUIDES,
    LAYER_KINDS,
    MADE_KINDS,
    MARK_KINDS,
    PRESETS,
    STROKE_KINDS,
    STROKE_STARTS,
    SYMMETRIES,
    name_of,
    number_of,
)

Interval = Tuple[float, float]
Density = Union[str, Callable[[Array, Array], Array]]
Direction = Callable[[Array, Array], Array]


@callback("int32_t(void *, int64_t, const double *, const double *, double *)", failure=1)
def _on_density(user: Any, count: int, positions: Any, normals: Any, density: Any) -> int:
    result = ffi.from_handle(user).function(points_of(positions, count), points_of(normals, count))
    store("the result of density", result, count, 1, "d", density)
    return 0


@callback("int32_t(void *, int64_t, const double *, const double *, double *)", failure=1)
def _on_direction(user: Any, count: int, positions: Any, normals: Any, directions: Any) -> int:
    result = ffi.from_handle(user).function(points_of(positions, count), points_of(normals, count))
    store("the result of direction", result, count, 3, "d", directions)
    return 0


@dataclass
class Layer:
    """How one layer of marks is made; see `PointSet.generate`.

    Attributes
    ----------
    kind : {"stipples", "principal", "combing", "field", "hatch"}
        Scattered marks, or strokes along the principal directions, along Stark's two directions
        [NPAR 5.3], or along `direction` and across it; or evenly spaced, nested lines along one smooth
        field of directions.
    name : str, optional
        As styles and `PointSet.layer` call it; the kind if None.
    budget : int, optional
        The most marks, of both directions together; 0 = no limit, for the distribution "published" and
        strokes with a separation.  None = no limit for these, and 40000 for others.
    tone, second_tone : (begin, end), optional
        The darkness at which the first mark is shown, and that at which all are: of stipples and of
        strokes of the first direction, and of strokes of the second.  None: as `tone_ranges` says.
    with_curvature : bool
        Whether its marks shall know their curvature; those of "principal" always do.
    density : {"uniform", "curvature"} or callable
        Where "blue_noise" stipples are denser: where the surface bends, or as a function says.  It gets
        positions and unit normals, shape (n, 3) each, and returns n numbers from 0 (none) to 1 (densest).
    density_strength : float
        0 to 1: of "curvature".
    separation : float
        Mean distance of neighbouring "blue_noise" strokes of one direction, in the unit of the model; 0 =
        such that all have as many marks as the budget.  Of "hatch": that of all its lines.
    step : float
        Distance of the marks of such a stroke; 0 = a fifth of the separation, of "hatch" 0.4 of it.
    length : float
        The longest such stroke; 0 = no limit.
    direction : callable, optional
        For "field", and for "hatch" in place of curvature.  It gets positions and unit normals, shape (n, 3) each, and
        returns directions of the same shape: their sign and length count nothing, 0 0 0 is none.
    symmetry : {"cross", "line"}
        Whether such strokes go straight on where the two directions change places, or turn.
    start : {"seeds", "stipples"}
        What strokes of the distribution "published" start from.
    start_level : int
        With "stipples", the last stippling level used.
    levels : int, optional
        Refinement steps of the distribution "published", 0 to 12; by default 4 for stipples and 3 for
        strokes, which have 3^levels marks.
    angle : float
        Degrees by which lines of "hatch" are turned in the tangent plane, counter-clockwise from outside.
    smoothing : float
        Over so long a way directions of "hatch" are smoothed; in diagonals of the model, 1 at most.
    axis : (x, y, z)
        Where curvature says little lines of "hatch" run around this.
    axis_weight : float
        How much that counts against curvature.
    tone_smoothing : float, optional
        Over so much of the surface the normals that tone goes by are averaged, so that the grain of a rough one makes
        no islands of light; in diagonals, 0.1 at most, 0 = not; by default 0.006 for "hatch", 0 for others.
    guide : {"curvature", "combing", "sections", "light", "silhouette"}
        What lines of "hatch" follow where no `direction` is given: the direction in which the surface bends
        most, Stark's first one, sections by planes across `axis`, away from a light, or as the silhouette.
    guide_direction : (x, y, z)
        Towards the light of "light", or the eye of "silhouette", in the model's own space.
    guide_weight : float
        0 to 1: of a guide other than "curvature"; what is left of 1 is curvature's.

    Examples
    --------
    >>> lines = hrbfnpr.Layer("field", name="fur", direction=lambda p, n: np.cross(n, (0, 0, 1)), separation=0.02)
    >>> marks = model.generate(["stipples", lines])
    """

    kind: str = "stipples"
    name: Optional[str] = None
    budget: Optional[int] = None
    tone: Optional[Interval] = None
    second_tone: Optional[Interval] = None
    with_curvature: bool = False
    density: Density = "uniform"
    density_strength: float = 0.5
    separation: float = 0.0
    step: float = 0.0
    length: float = 0.0
    direction: Optional[Direction] = None
    symmetry: str = "cross"
    start: str = "seeds"
    start_level: int = 0
    levels: Optional[int] = None
    angle: float = 0.0
    smoothing: float = 0.04
    axis: Tuple[float, float, float] = (0.0, 1.0, 0.0)
    axis_weight: float = 0.06
    tone_smoothing: Optional[float] = None
    guide: str = "curvature"
    guide_direction: Tuple[float, float, float] = (0.0, 0.0, 1.0)
    guide_weight: float = 1.0

    def _budget(self, default: int, distribution: int) -> int:
        if self.budget is not None:
            return self.budget
        unlimited = distribution == DISTRIBUTIONS["published"] or (self.kind in STROKE_KINDS and self.separation > 0)
        return 0 if unlimited else default

    def _fill(self, desc: Any, distribution: int) -> Tuple[List[Optional[CallbackState]], List[Any]]:
        """The states of its functions, and what must be kept alive."""
        kinds = {name: LAYER_KINDS[name] for name in MADE_KINDS}
        desc.kind = number_of("the kind of a layer", kinds, self.kind)
        desc.budget = self._budget(desc.budget, distribution)
        desc.tone_begin, desc.tone_end = self.tone or (0.0, 0.0)
        desc.second_tone_begin, desc.second_tone_end = self.second_tone or (0.0, 0.0)
        if self.with_curvature:
            desc.flags = ffi.integer_const("HRBFNPR_LAYER_WITH_CURVATURE")
        desc.density_strength = self.density_strength
        desc.separation, desc.step, desc.length = self.separation, self.step, self.length
        desc.symmetry = number_of("symmetry", SYMMETRIES, self.symmetry)
        desc.start, desc.start_level = number_of("start", STROKE_STARTS, self.start), self.start_level
        if self.levels is not None:
            desc.levels = self.levels
        desc.angle, desc.smoothing, desc.axis_weight = self.angle, self.smoothing, self.axis_weight
        desc.axis = self.axis
        if self.tone_smoothing is not None:
            desc.tone_smoothing = self.tone_smoothing
        desc.guide, desc.guide_weight = number_of("guide", GUIDES, self.guide), self.guide_weight
        desc.guide_direction = self.guide_direction
        states: List[Optional[CallbackState]] = []
        keep = [c_name(desc, self.name)]

        def user(function: Callable[..., Any]) -> Any:
            states.append(state := CallbackState(function))
            keep.append(handle := state.new_handle())
            return handle

        if callable(self.density):
            desc.density, desc.density_function = DENSITIES["callback"], _on_density
            desc.density_user = user(self.density)
        else:
            plain = {name: number for name, number in DENSITIES.items() if name != "callback"}
            desc.density = number_of("density", plain, self.density)
        if self.direction is not None:
            desc.direction_function, desc.direction_user = _on_direction, user(self.direction)
        return states, keep


LayersToMake = Union[str, Layer, Iterable[Union[str, Layer]]]

_FIELDS = tuple(field.name for field in fields(Layer) if field.name not in ("kind", "name"))
# Fields that mean something to layers of some kinds only.
_OF_KINDS: Dict[str, Tuple[str, ...]] = {
    **{name: ("stipples",) for name in ("density", "density_strength")},
    **{name: STROKE_KINDS for name in ("second_tone", "separation", "step", "length", "symmetry")},
    **{name: STROKE_KINDS for name in ("start", "start_level")},
    "direction": ("field", "hatch"),
    **{name: ("hatch",) for name in ("angle", "smoothing", "axis", "axis_weight")},
    **{name: ("hatch",) for name in ("guide", "guide_direction", "guide_weight")},
}


# What the published recursion has in the place of lines of hatching.
_PUBLISHED = {"hatch": "principal", "cross-hatch": "principal", "combing": "combing", "full": "principal"}


def preset_layers(preset: str, distribution: str = "blue_noise") -> List[Layer]:
    """The layers that a preset draws, to be changed and given to `PointSet.generate`.

    Of the distribution "published" hatch, cross-hatch and full draw strokes of the kind "principal",
    combing those of the kind "combing".
    """
    if preset not in PRESETS:
        raise ValueError(f"preset must be one of {', '.join(map(repr, PRESETS))}, not {preset!r}")
    if distribution == "published" and preset in _PUBLISHED:
        return [Layer("stipples"), Layer(_PUBLISHED[preset])]
    count = ffi.new("int64_t *")
    descs = lib.hrbfnpr_preset_layers(PRESETS.index(preset), count)
    return [_from_struct(descs[i]) for i in range(count[0])]


def _from_struct(desc: Any) -> Layer:
    kind = name_of(LAYER_KINDS, desc.kind)
    name = None if desc.name == ffi.NULL else ffi.string(desc.name).decode()
    fields_of_hatch = {} if kind != "hatch" else {
        "separation": desc.separation, "angle": desc.angle, "smoothing": desc.smoothing,
        "axis": tuple(desc.axis), "axis_weight": desc.axis_weight,
        "guide": name_of(GUIDES, desc.guide), "guide_direction": tuple(desc.guide_direction),
        "guide_weight": desc.guide_weight,
    }  # fmt: skip
    tones = {
        field: (begin, end)
        for field, begin, end in (
            ("tone", desc.tone_begin, desc.tone_end),
            ("second_tone", desc.second_tone_begin, desc.second_tone_end),
        )
        if end > 0
    }
    return Layer(kind, name, **fields_of_hatch, **tones)


def layers_to_make(
    layers: Optional[LayersToMake], preset: Optional[str], distribution: str, shared: Any
) -> List[Layer]:
    """The layers that are meant; `shared` are fields of those that are given by name, or of a preset."""
    for name in shared:
        if name not in _FIELDS:
            raise TypeError(f"unexpected argument {name!r}")
    if preset is not None:
        if layers is not None:
            raise TypeError("give either layers or preset, not both")
        given: List[Union[str, Layer]] = list(preset_layers(preset, distribution.replace("-", "_")))
    elif layers is None or isinstance(layers, (str, Layer)):
        given = ["stipples" if layers is None else layers]
    else:
        given = list(layers)
    if not given:
        raise ValueError("layers must name one layer or more")
    named = [Layer(layer.replace("-", "_").lower()) if isinstance(layer, str) else layer for layer in given]
    by_name = [layer for layer, of in zip(named, given) if preset is not None or isinstance(of, str)]
    kinds = {layer.kind for layer in by_name if isinstance(layer, Layer)}
    for name in shared:
        if not kinds & set(_OF_KINDS.get(name, kinds)):
            raise ValueError(f"{name} means nothing to the layers that are given by name")
    result = []
    for layer in named:
        if not isinstance(layer, Layer):
            raise TypeError(f"layers must be names and hrbfnpr.Layer objects, not {type(layer).__name__}")
        meant = {key: value for key, value in shared.items() if layer.kind in _OF_KINDS.get(key, MADE_KINDS)}
        result.append(replace(layer, **meant) if any(layer is of for of in by_name) else layer)
    return result


def c_name(desc: Any, name: Optional[str]) -> Any:
    """Set the `name` of a descriptor; returns what must be kept alive."""
    if name is None:
        return None
    text = ffi.new("char[]", name.encode())
    desc.name = text
    return text


def new_list(kind: str, count: int) -> Any:
    """A list of structs, each set up by its `_init` function."""
    structs = ffi.new(f"{kind}[]", max(count, 1))
    for i in range(count):
        check(getattr(lib, f"{kind}_init")(ffi.addressof(structs, i), ffi.sizeof(kind)))
    return structs


@dataclass
class OwnLayer:
    """A layer of ready-made marks, for `PointSet.create`; the arrays are copied.

    Attributes
    ----------
    positions : array of float, shape (n, 3)
        Absolute.
    normals : array of float, shape (n, 3)
        Unit, outward.
    name : str, optional
        As styles and `PointSet.layer` call it; the kind if None.
    kind : {"own", "stipples", "principal", "combing", "field"}
    stroke_first : array of int, shape (s + 1,), optional
        Rising from 0 to n: stroke s has the marks stroke_first[s] up to stroke_first[s + 1] - 1, from end
        to end.  None: no strokes.
    stroke_directions : array of int, shape (s,), optional
        0 the first direction, 1 the second; 0 if None.
    directions : array of float, shape (n, 3), optional
        Unit, tangent; along the stroke if None.
    curvatures : array of float, shape (n, 3), optional
        k1, k2, confidence.
    ranks : array of float, shape (n,), optional
        In [0, 1); random, the same for all marks of a stroke, if None.
    levels : array of int, shape (n,), optional
    widths : array of float, shape (n,), optional
        In (0, 1]; 1 if None.
    """

    positions: Array
    normals: Array
    name: Optional[str] = None
    kind: str = "own"
    stroke_first: Optional[Array] = None
    stroke_directions: Optional[Array] = None
    directions: Optional[Array] = None
    curvatures: Optional[Array] = None
    ranks: Optional[Array] = None
    levels: Optional[Array] = None
    widths: Optional[Array] = None

    def _fill(self, arrays: Any) -> List[Any]:
        """What must be kept alive."""
        kinds = {name: LAYER_KINDS[name] for name in MARK_KINDS}
        arrays.kind = number_of("the kind of a layer", kinds, self.kind)
        keep = [c_name(arrays, self.name)]
        for field, target, components, codes in _OWN_ARRAYS:
            value = getattr(self, field)
            if value is not None:
                block = block_in(f"{self.name or self.kind}.{field}", value, components, codes)
                keep.append(block.fill(getattr(arrays, target)))
        return keep


# Field, the library's, components, types that it takes (the last one is what others become).
_OWN_ARRAYS: Sequence[Tuple[str, str, int, str]] = (
    ("positions", "position", 3, FLOATS),
    ("normals", "normal", 3, FLOATS),
    ("stroke_first", "stroke_first", 1, "I"),
    ("stroke_directions", "stroke_direction", 1, "B"),
    ("directions", "direction", 3, FLOATS),
    ("curvatures", "curvature", 3, FLOATS),
    ("ranks", "rank", 1, FLOATS),
    ("levels", "level", 1, "B"),
    ("widths", "width", 1, FLOATS),
)
