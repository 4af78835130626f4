# SPDX-License-Identifier: MIT
"""A drawing by a file of settings, and a file of settings of a drawing: options --settings and --save-settings."""
from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .._camera import Camera
from .._kind_style import KindStyle
from .._layer import Layer
from .._line_style import LineStyle
from .._style import LayerStyle, Style
from ..shapes._shape import Floats
from . import _settings
from ._settings import MAGIC, VERSION

_CAMERA = ("up", "azimuth", "elevation", "direction", "eye", "target", "fov", "margin")
_OF_MESH = ("tolerance", "maximum_centres")  # of both fits, which mean other things by them
# What settings do not hold, though it changes the surface.
_NOT_HELD = ("samples", "crease", "parts", "viewpoint", "depth_smoothing", "flip", "seed_points")

Dabs = Sequence[Dict[str, Any]]


def apply(arguments: Any) -> None:
    """Fill what was not given on the command line from --settings; what was given wins."""
    found = _settings.read(Path(arguments.settings))
    if arguments.style is None:
        arguments.style, arguments.own_style = found.preset, found.style
        arguments.own_layers, arguments.own_pen = found.layers, found.pen
    arguments.own_generate, arguments.own_paint = found.generate, found.paint
    arguments.distribution = arguments.distribution or found.generate.get("distribution")
    arguments.own_line_set, arguments.own_lines = found.line_set, found.lines
    arguments.profile, arguments.scale_bar = arguments.profile or "no", arguments.scale_bar or "none"
    arguments.size = _size(arguments.size, found.size)
    if found.camera is not None and all(getattr(arguments, name) is None for name in _CAMERA):
        arguments.own_camera = found.camera(arguments.size or (1600, 1600))
    _use_fit(arguments, dict(found.fit), found.mesh_fit)


def _size(wanted: Any, of_file: Optional[Tuple[int, int]]) -> Any:
    """The size asked for; of a longer side alone, and with none, as the file's."""
    if wanted is None or of_file is None:
        return wanted or of_file
    if not isinstance(wanted, int):
        return wanted
    scale = wanted / max(of_file)
    return tuple(max(1, round(scale * side)) for side in of_file)


def _use_fit(arguments: Any, fit: Dict[str, Any], mesh_fit: Dict[str, Any]) -> None:
    mode = fit.pop("normal_mode", "auto")
    arguments.normals = arguments.normals or {"given": "keep"}.get(mode, mode)
    arguments.close = arguments.close or fit.pop("trim", "auto") == "never"
    if fit.pop("regularization_mode", "given") == "auto":
        fit["regularization"] = "auto"
    arguments.own_fit = fit
    of_both = ("kernel", "kernel_radius", "polynomial_degree", "regularization", "solver")
    arguments.own_mesh_fit = {**{name: fit[name] for name in of_both if name in fit}, **mesh_fit}


def paint(arguments: Any, style: Style, layers: List[Layer], camera: Camera) -> List[Layer]:
    """Put the painted maps of settings into a style and the layers that marks are made by."""
    dabs: Dict[str, Dabs] = {
        name: [dab for dab in getattr(arguments, "own_paint", None) or () if dab["map"] == name]
        for name in ("tone", "density", "direction")
    }
    if dabs["tone"]:
        style.tone = _painted_tone(style, camera, dabs["tone"])
    if dabs["density"]:
        layers = [_with(layer, "stipples", density=_density(dabs["density"])) for layer in layers]
    if dabs["direction"]:
        layers = [_with(layer, "hatch", direction=_direction(dabs["direction"])) for layer in layers]
    return layers


def _with(layer: Layer, kind: str, **changes: Any) -> Layer:
    return replace(layer, **changes) if layer.kind == kind else layer


def _along(vectors: Floats, direction: Any) -> Floats:
    """Dot products, summed in the viewer's order: BLAS has others."""
    x, y, z = (float(number) for number in direction)
    return vectors[:, 0] * x + vectors[:, 1] * y + vectors[:, 2] * z


def _weights(dab: Dict[str, Any], places: Floats, normals: Floats) -> Floats:
    """1 in the middle of a dab, 0 at its edge and on what faces away from it; as the viewer's paint.cpp has it."""
    away = places - np.array(dab["position"])
    share = (away[:, 0] ** 2 + away[:, 1] ** 2 + away[:, 2] ** 2) / dab["radius"] ** 2
    faces = _along(normals, dab["normal"]) > 0
    weights: Floats = np.where((share < 1) & faces, dab["strength"] * (1 - share) * (1 - share), 0.0)
    return weights


def _pulled(values: Floats, dabs: Dabs, places: Any, normals: Any) -> Floats:
    places, normals = np.asarray(places, dtype=float), np.asarray(normals, dtype=float)
    for dab in dabs:
        values = values + _weights(dab, places, normals) * (dab["value"] - values)
    return values


def _painted_tone(style: Style, camera: Camera, dabs: Dabs) -> Any:
    light = np.array(style.light, dtype=float)
    if style.light_space == "camera":
        light = _along(np.asarray(camera.view)[:3, :3].T, light)
    light = (1 / np.sqrt(_along(light[None], light))) * light
    exponent, fill, is_lit = style.tone_exponent, style.fill_light, style.tone == "light"

    def tone(places: Any, normals: Any) -> Floats:
        facing = _along(np.asarray(normals, dtype=float), light)
        lit = np.where(facing >= 0, np.maximum(facing, 0) ** exponent, fill * facing * facing)
        return _pulled(lit if is_lit else 0 * facing, dabs, places, normals)

    return tone


def _density(dabs: Dabs) -> Any:
    return lambda places, normals: np.clip(_pulled(np.ones(len(places)), dabs, places, normals), 0, 1)


def _direction(dabs: Dabs) -> Any:
    def direction(places: Any, normals: Any) -> Floats:
        total = np.zeros((len(places), 3))
        for dab in dabs:
            along = np.array(dab["direction"], dtype=float)
            sign = np.where(_along(total, along) < 0, -1.0, 1.0)  # lines have no sign
            weight = _weights(dab, np.asarray(places, dtype=float), np.asarray(normals, dtype=float))
            total = (1 - weight)[:, None] * total + (weight * sign)[:, None] * along
        return total

    return direction


# ---- Writing


def save(path: Path, arguments: Any, scene: Any) -> List[str]:
    """Write what a drawing was made with; returns what of the command line it cannot hold."""
    style, camera = scene.style.copy(), scene.camera
    own: Optional[Style] = getattr(arguments, "own_style", None)
    if callable(style.tone):
        style.tone = own.tone if own is not None else "light"  # below what is painted
    found: Dict[str, Any] = {
        MAGIC: VERSION, "preset": arguments.style, "size": list(camera.size), "pen": 1.0,
        "camera": {name: np.asarray(getattr(camera, name)).T.ravel().tolist() for name in ("view", "projection")},
        "style": {
            **_changed(style, Style(arguments.style)),
            "layers": [_of_kind(layer, LayerStyle(layer.kind)) for layer in style.layers],
            "lines": [_of_kind(line, LineStyle(line.kind)) for line in style.lines],
        },
    }  # fmt: skip
    made = getattr(arguments, "made", None)
    if made is not None:
        layers, generate = made
        found["marks"] = {**generate, "layers": [_of_layer(layer) for layer in layers]}
    found.update(_of_fit(arguments))
    if getattr(arguments, "own_paint", None):
        found["paint"] = arguments.own_paint
    _settings.parse(found)  # what is written can be read
    path.write_text(_text(found) + "\n", encoding="utf-8")
    return [f"--{name.replace('_', '-')}" for name in _NOT_HELD if getattr(arguments, name, None)]


def _text(value: Any, indent: str = "") -> str:
    """JSON: what holds no lists or objects is on one line."""
    parts = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    if not any(isinstance(part, (dict, list)) for part in parts) or len(indent) > 4:
        return json.dumps(value)
    inner = indent + "  "
    if isinstance(value, dict):
        lines = [f"{json.dumps(key)}: {_text(part, inner)}" for key, part in value.items()]
    else:
        lines = [_text(part, inner) for part in value]
    first, last = "{}" if isinstance(value, dict) else "[]"
    return f"{first}\n{inner}" + f",\n{inner}".join(lines) + f"\n{indent}{last}"


def _plain(value: Any) -> Any:
    if isinstance(value, (tuple, list)):
        return [_plain(one) for one in value]
    return _shortest(value) if isinstance(value, float) else value


def _shortest(value: float) -> float:
    """The shortest decimal that a 32-bit float reads as the same: fields are of that type, or doubles."""
    short = float(str(np.float32(value)))
    return short if float(np.float32(value)) == value else value


def _changed(style: Style, base: Style) -> Dict[str, Any]:
    result = {}
    for name in style.fields():
        if getattr(style, name) != getattr(base, name):
            result[name] = _plain(getattr(style, name))
    return {**result, **({"tone": style.tone} if style.tone != base.tone else {})}


def _of_kind(one: KindStyle, base: KindStyle) -> Dict[str, Any]:
    """The fields of a style of layers or lines that are not the defaults."""
    result: Dict[str, Any] = {"kind": one.kind}
    for name in one.fields():
        value = getattr(one, name)
        if name != "kind" and value != getattr(base, name):
            result[name] = _plain(value)
    if one.name is not None:
        result["name"] = one.name
    if "directions" in result:
        result["directions"] = sum(1 << ("first", "second").index(name) for name in result["directions"])
    if getattr(one, "levels", None):
        result["levels"] = list(one.levels)
    return result


_LAYER = (
    "name", "density_strength", "separation", "step", "length", "symmetry", "start", "start_level", "angle",
    "smoothing", "axis_weight", "guide", "guide_weight",
)  # fmt: skip


def _of_layer(layer: Layer) -> Dict[str, Any]:
    base = Layer(layer.kind)
    result: Dict[str, Any] = {"kind": layer.kind}
    if layer.budget is not None:
        result["budget"] = layer.budget
    elif layer.separation > 0 or layer.levels is not None:
        result["budget"] = 0
    result.update({name: getattr(layer, name) for name in _LAYER if getattr(layer, name) != getattr(base, name)})
    result.update({name: list(getattr(layer, name)) for name in ("axis", "guide_direction")
                   if tuple(getattr(layer, name)) != getattr(base, name)})  # fmt: skip
    if isinstance(layer.density, str) and layer.density != base.density:
        result["density"] = layer.density
    for name in ("levels", "tone_smoothing"):
        if getattr(layer, name) is not None:
            result[name] = getattr(layer, name)
    for name, begin, end in (("tone", "tone_begin", "tone_end"), ("second_tone", "second_tone_begin", "second_tone_end")):
        if getattr(layer, name) is not None:
            result[begin], result[end] = getattr(layer, name)
    return result


def _of_fit(arguments: Any) -> Dict[str, Any]:
    """The sections of the fit and of lines, of options and of settings that were read."""
    names = ("kernel", "kernel_radius", "polynomial_degree", "regularization", "solver", "refinement_steps", "outliers",
             "flipped_normals", *_OF_MESH)  # fmt: skip
    options = {name: value for name in names if (value := getattr(arguments, name, None)) is not None}
    fit = {**(getattr(arguments, "own_fit", None) or {}), **options}
    if fit.get("regularization") == "auto":
        fit["regularization_mode"] = fit.pop("regularization")
    if arguments.normals not in (None, "auto"):
        fit["normal_mode"] = {"keep": "given"}.get(arguments.normals, arguments.normals)
    if arguments.close:
        fit["trim"] = "never"
    known = _settings.plain_fields("hrbfnpr_mesh_fit_desc")
    mesh_fit = {name: value for name, value in (getattr(arguments, "own_mesh_fit", None) or {}).items() if name in known}
    mesh_fit.update({name: options[name] for name in _OF_MESH if name in options})
    if arguments.edges is not None:
        mesh_fit["edges"], mesh_fit["crease_angle"] = arguments.edges
    line_set = dict(getattr(arguments, "own_line_set", None) or {})
    if arguments.support is not None:
        line_set["support"] = arguments.support
    once = [_of_lines(one) for one in getattr(arguments, "made_lines", ()) if one.kind != "own"]
    if once:
        line_set["lines"] = once
    return {name: part for name, part in (("fit", fit), ("mesh_fit", mesh_fit), ("line_set", line_set)) if part}


def _of_lines(one: Any) -> Dict[str, Any]:
    found = {"kind": one.kind, "name": one.name, "lower": one.lower, "upper": one.upper, "shortest": one.shortest}
    found["plane"] = [float(x) for x in one.plane]
    if len(one.levels):
        found["levels"] = [float(x) for x in one.levels]
    return found
