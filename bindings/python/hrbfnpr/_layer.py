# SPDX-License-Identifier: MIT
"""Layers of marks to make, and layers of ready-made marks."""
from __future__ import annotations

from dataclasses import fields, replace
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

from ._arrays import store
from ._callbacks import CallbackState, callback
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
    name_of,
    number_of,
)
from ._records import LayerFields, OwnLayerFields, fill
from ._surface_field import Field


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


class Layer(LayerFields):
    __doc__ = LayerFields.__doc__

    def _budget(self, default: int, distribution: int) -> int:
        if self.budget is not None:
            return self.budget
        unlimited = distribution == DISTRIBUTIONS["published"] or (self.kind == "hatch" and self.separation > 0)
        return 0 if unlimited else default

    def _fill(self, desc: Any, distribution: int) -> Tuple[List[Optional[CallbackState]], List[Any]]:
        """Fill the descriptor.  Returns the states of its functions, and the objects to keep alive."""
        kinds = {name: LAYER_KINDS[name] for name in MADE_KINDS}
        desc.kind = number_of("the kind of a layer", kinds, self.kind)
        desc.budget = self._budget(desc.budget, distribution)
        desc.tone_begin, desc.tone_end = self.tone or (0.0, 0.0)
        desc.second_tone_begin, desc.second_tone_end = self.second_tone or (0.0, 0.0)
        if self.with_curvature:
            desc.flags = ffi.integer_const("HRBFNPR_LAYER_WITH_CURVATURE")
        states: List[Optional[CallbackState]] = []
        keep: List[Any] = []
        fill(desc, self, keep)

        def user(function: Callable[..., Any]) -> Any:
            states.append(state := CallbackState(function))
            keep.append(handle := state.new_handle())
            return handle

        def use(field: Field) -> Any:
            states.append(field._function)
            keep.append(field._handle)
            return field._handle

        if isinstance(self.density, Field):
            desc.density, desc.density_field = DENSITIES["field"], use(self.density)
        elif callable(self.density):
            desc.density, desc.density_function = DENSITIES["callback"], _on_density
            desc.density_user = user(self.density)
        else:
            plain = {name: number for name, number in DENSITIES.items() if name not in ("callback", "field")}
            desc.density = number_of("density", plain, self.density)
        if isinstance(self.direction, Field):
            desc.direction_field = use(self.direction)
        elif self.direction is not None:
            desc.direction_function, desc.direction_user = _on_direction, user(self.direction)
        return states, keep


LayersToMake = Union[str, Layer, Iterable[Union[str, Layer]]]

_FIELDS = tuple(field.name for field in fields(Layer) if field.name not in ("kind", "name"))
# The kinds of layers for which a field has a meaning; fields that are not listed have one for all kinds.
_OF_KINDS: Dict[str, Tuple[str, ...]] = {
    **{name: ("stipples",) for name in ("density", "density_strength")},
    **{name: ("hatch",) for name in ("second_tone", "separation", "step", "start", "start_level", "direction")},
    **{name: ("hatch",) for name in ("angle", "smoothing", "axis", "axis_weight")},
    **{name: ("hatch",) for name in ("guide", "guide_direction", "guide_weight")},
}


# What the strokes of the distribution "published" follow instead of the lines of a preset.
_PUBLISHED = {"hatch": "curvature", "cross-hatch": "curvature", "combing": "combing", "full": "curvature"}


def preset_layers(preset: str, distribution: str = "blue_noise") -> List[Layer]:
    """Return the layers of marks of a named style, for `PointSet.generate`; you may change them first.

    With the distribution "published", the styles "hatch", "cross-hatch" and "full" have strokes along the principal
    directions, and "combing" has strokes along the combing directions.

    Parameters
    ----------
    preset : str
        A name of `hrbfnpr.PRESETS`.
    distribution : {"blue_noise", "published"}
        The distribution with which the layers will be generated.

    Returns
    -------
    list of Layer
        New layers.

    Raises
    ------
    ValueError
        If there is no such style.
    """
    if preset not in PRESETS:
        raise ValueError(f"preset must be one of {', '.join(map(repr, PRESETS))}, not {preset!r}")
    if distribution == "published" and preset in _PUBLISHED:
        return [Layer("stipples"), Layer("hatch", guide=_PUBLISHED[preset])]
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
    tones: Dict[str, Any] = {
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
    """The layers to make.  `shared` are fields of layers that are given by name, or that come from a preset."""
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
        raise ValueError("layers must name at least one layer")
    named = [Layer(layer.replace("-", "_").lower()) if isinstance(layer, str) else layer for layer in given]
    by_name = [layer for layer, of in zip(named, given) if preset is not None or isinstance(of, str)]
    kinds = {layer.kind for layer in by_name if isinstance(layer, Layer)}
    for name in shared:
        if not kinds & set(_OF_KINDS.get(name, kinds)):
            raise ValueError(f"{name} does not apply to any layer that is given by name")
    result = []
    for layer in named:
        if not isinstance(layer, Layer):
            raise TypeError(f"layers must be names and hrbfnpr.Layer objects, not {type(layer).__name__}")
        meant = {key: value for key, value in shared.items() if layer.kind in _OF_KINDS.get(key, MADE_KINDS)}
        result.append(replace(layer, **meant) if any(layer is of for of in by_name) else layer)
    return result


class OwnLayer(OwnLayerFields):
    __doc__ = OwnLayerFields.__doc__

    def _fill(self, arrays: Any) -> List[Any]:
        """Fill the struct.  Returns the objects to keep alive."""
        kinds = {name: LAYER_KINDS[name] for name in MARK_KINDS}
        arrays.kind = number_of("the kind of a layer", kinds, self.kind)
        keep: List[Any] = []
        fill(arrays, self, keep, f"{self.name or self.kind}.")
        return keep
