# SPDX-License-Identifier: MIT
"""Settings of a drawing in a file, as `hrbfnpr-view` has them too: docs/settings.md."""
from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .._camera import Camera
from .._errors import new_struct
from .._layer import Layer
from .._library import ffi
from .._line_set import Lines
from .._line_style import LineStyle
from .._names import (
    CAPS,
    CREASES,
    DENSITIES,
    DISTRIBUTIONS,
    EDGES,
    GUIDES,
    HIDDEN_LINES,
    HIDDEN_PARTS,
    KERNELS,
    LAYER_KINDS,
    LIGHT_SPACES,
    LINE_KINDS,
    NORMALS,
    PRESETS,
    REPAIRS,
    SEED_SOURCES,
    SHAPES,
    SILHOUETTE_LAWS,
    SOLVERS,
    STROKE_STARTS,
    SYMMETRIES,
    TONE_CURVES,
    TONE_RANGES,
    TONE_RULES,
    TONES,
    TRIMS,
    VISIBILITIES,
)
from .._style import LayerStyle, Style

MAGIC, VERSION = "hrbfnpr-settings", 1
_KEYS = (MAGIC, "preset", "size", "pen", "camera", "style", "marks", "fit", "mesh_fit", "line_set", "paint")
_VIEW = ("eye", "target", "up", "vertical_angle", "view_height", "near_plane", "far_plane")
_MAPS = ("tone", "density", "direction")
_REGULARIZATIONS = {"given": 0, "auto": 1}


def _without(names: Mapping[str, int], *left_out: str) -> Tuple[str, ...]:
    return tuple(name for name in names if name not in left_out)


_OUTLIERS = _without(REPAIRS, "reorient")
_ONCE = ("ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section")


class Section(NamedTuple):
    """A part of the file: the fields of a C struct, those that are words, and keys that are no plain field."""

    c_type: str
    words: Dict[str, Sequence[str]]
    more: Tuple[str, ...] = ()


SECTIONS: Dict[str, Section] = {
    "style": Section("hrbfnpr_style", {
        "tone": _without(TONES, "callback"), "tone_rule": tuple(TONE_RULES), "tone_curve": tuple(TONE_CURVES),
        "light_space": tuple(LIGHT_SPACES), "silhouette_law": tuple(SILHOUETTE_LAWS),
        "visibility": tuple(VISIBILITIES), "hidden_lines": tuple(HIDDEN_LINES),
    }, ("layers", "lines")),
    "style.layers": Section("hrbfnpr_layer_style", {"kind": tuple(LAYER_KINDS), "shape": tuple(SHAPES)}),
    "style.lines": Section("hrbfnpr_line_style", {
        "kind": tuple(LINE_KINDS), "hidden": tuple(HIDDEN_PARTS), "cap": tuple(CAPS), "creases": tuple(CREASES),
    }, ("levels",)),
    "marks": Section("hrbfnpr_generate_desc", {
        "distribution": tuple(DISTRIBUTIONS), "tone_ranges": tuple(TONE_RANGES),
        "seed_source": _without(SEED_SOURCES, "points"),
    }, ("layers",)),
    "marks.layers": Section("hrbfnpr_layer_desc", {
        "kind": _without(LAYER_KINDS, "any"), "density": _without(DENSITIES, "callback"),
        "symmetry": tuple(SYMMETRIES), "start": tuple(STROKE_STARTS), "guide": tuple(GUIDES),
    }),
    "fit": Section("hrbfnpr_fit_desc", {
        "kernel": _without(KERNELS, "custom", "csg"), "regularization_mode": tuple(_REGULARIZATIONS),
        "outliers": _OUTLIERS, "flipped_normals": tuple(REPAIRS), "solver": tuple(SOLVERS),
        "normal_mode": tuple(NORMALS), "trim": tuple(TRIMS),
    }),
    "mesh_fit": Section("hrbfnpr_mesh_fit_desc", {"edges": tuple(EDGES)}),
    "line_set": Section("hrbfnpr_line_set_desc", {}, ("lines",)),
    "line_set.lines": Section("hrbfnpr_line_desc", {"kind": _ONCE}, ("levels",)),
}  # fmt: skip
_NOT_SETTINGS = ("struct_size", "flags", "layer_count", "layer_stride", "line_count", "line_stride")


def plain_fields(c_type: str) -> Dict[str, Tuple[str, int]]:
    """The fields of a struct that are numbers, vectors or texts, with the type of an element and how many there are."""
    result = {}
    for name, field in ffi.typeof(c_type).fields:
        kind, count = field.type, 1
        if kind.kind == "array":
            kind, count = kind.item, kind.length
        text = "const char*" if kind.cname == "char *" else kind.cname
        if name not in _NOT_SETTINGS and not name.startswith("reserved") and (kind.kind == "primitive" or text != kind.cname):
            result[name] = (text, count)
    return result


def schema() -> Dict[str, Any]:
    """Every section, its fields, and the words that they can be; as `hrbfnpr-view --print-schema` prints it."""
    result: Dict[str, Any] = {}
    for name, section in SECTIONS.items():
        result[name] = {}
        for field, (kind, count) in plain_fields(section.c_type).items():
            words: Any = list(section.words[field]) if field in section.words else kind
            result[name][field] = words if count == 1 else [words, count]
    return result


class SettingsError(ValueError):
    """What is wrong in a file of settings, by its key."""


def _refuse(where: str, wanted: str, value: Any) -> None:
    raise SettingsError(f"{where}: {wanted} is needed, not {json.dumps(value)[:60]}")


def _object(value: Any, where: str, keys: Sequence[str]) -> Dict[str, Any]:
    if not isinstance(value, dict):
        _refuse(where, "an object", value)
    for key in value:
        if key not in keys:
            path = key if not where else f"{where}.{key}"
            raise SettingsError(f"{path}: there is no such field; there are {', '.join(keys)}")
    return dict(value)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _number(value: Any, where: str, low: float = -math.inf, high: float = math.inf) -> float:
    if not _is_number(value) or not low <= value <= high:
        limits = "a number" if low == -math.inf else f"a number from {low:g} to {high:g}"
        _refuse(where, limits, value)
    return float(value)


def _numbers(value: Any, where: str, count: Optional[int] = None) -> List[float]:
    if not isinstance(value, list) or not all(map(_is_number, value)) or count not in (None, len(value)):
        _refuse(where, "a list of numbers" if count is None else f"a list of {count} numbers", value)
    return [float(one) for one in value]


def _value(value: Any, kind: str, where: str) -> Any:
    if kind == "const char*":
        if value is not None and not isinstance(value, str):
            _refuse(where, "a text or null", value)
        return value
    if kind in ("float", "double"):
        return _number(value, where)
    if not isinstance(value, int):
        _refuse(where, "a whole number", value)
    try:
        ffi.new(f"{kind} *", int(value))
    except OverflowError:
        _refuse(where, f"a number that fits a {kind}", value)
    return int(value)


def _fields(value: Any, name: str, where: str) -> Dict[str, Any]:
    """The fields of a section as Python's values, words by their names."""
    section = SECTIONS[name]
    known = plain_fields(section.c_type)
    result = _object(value, where, (*known, *section.more))
    for field, given in result.items():
        path = f"{where}.{field}"
        if field in section.words:
            word = given.replace("-", "_") if isinstance(given, str) else given
            if word not in section.words[field]:
                _refuse(path, f"one of {', '.join(section.words[field])}", given)
            result[field] = word
        elif field in known:
            kind, count = known[field]
            result[field] = _value(given, kind, path) if count == 1 else tuple(_numbers(given, path, count))
        elif field == "levels":
            result[field] = _numbers(given, path)
    return result


def _list(value: Any, name: str, where: str) -> List[Dict[str, Any]]:
    if not isinstance(value, list):
        _refuse(where, "a list of objects", value)
    return [_fields(one, name, f"{where}[{i}]") for i, one in enumerate(value)]


@dataclass
class Settings:
    """A file of settings that was read."""

    preset: str
    size: Optional[Tuple[int, int]]
    pen: Optional[float]
    camera: Optional[Callable[[Tuple[int, int]], Camera]]
    style: Style
    generate: Dict[str, Any]
    layers: Optional[List[Layer]]
    fit: Dict[str, Any]
    mesh_fit: Dict[str, Any]
    line_set: Dict[str, Any]
    lines: Optional[List[Lines]]
    paint: List[Dict[str, Any]]


def read(path: Path) -> Settings:
    """A file of settings.

    Raises
    ------
    ValueError
        If it is none, naming the key and what would be right.
    """
    try:
        return parse(json.loads(path.read_text(encoding="utf-8")))
    except SettingsError as error:
        raise ValueError(f"{path}: {error}") from None
    except ValueError as error:
        raise ValueError(f"{path}: this is no JSON: {error}") from None


def parse(found: Any) -> Settings:
    """What a file holds, as settings."""
    if not isinstance(found, dict) or MAGIC not in found:
        raise SettingsError(f'these are no settings: they begin with {{"{MAGIC}": {VERSION}}}')
    if found[MAGIC] != VERSION:
        raise SettingsError(f"{MAGIC}: version {VERSION} is known here, not {json.dumps(found[MAGIC])}")
    _object(found, "", _KEYS)
    preset = found.get("preset", "contour-and-stipple")
    if preset not in PRESETS:
        raise SettingsError(f"preset: there is no style {json.dumps(preset)}; there are {', '.join(PRESETS)}")
    size = _size(found["size"]) if "size" in found else None
    pen = _number(found.get("pen", 0), "pen", 0, 100)
    marks = _fields(found.get("marks", {}), "marks", "marks")
    layers = marks.pop("layers", None)
    line_set = _fields(found.get("line_set", {}), "line_set", "line_set")
    lines = line_set.pop("lines", None)
    return Settings(
        preset, size, pen or None, _camera(found["camera"], size) if "camera" in found else None,
        _style(found.get("style", {}), preset), marks,
        None if layers is None else [_layer(one) for one in _list(layers, "marks.layers", "marks.layers")],
        _fields(found.get("fit", {}), "fit", "fit"), _fields(found.get("mesh_fit", {}), "mesh_fit", "mesh_fit"), line_set,
        None if lines is None else [_lines(one) for one in _list(lines, "line_set.lines", "line_set.lines")],
        _paint(found.get("paint", [])),
    )  # fmt: skip


def _size(value: Any) -> Tuple[int, int]:
    width, height = _numbers(value, "size", 2)
    if not all(1 <= side <= 32768 and side == int(side) for side in (width, height)):
        _refuse("size", "a pair of whole numbers from 1 to 32768", value)
    return int(width), int(height)


def _camera(value: Any, size: Optional[Tuple[int, int]]) -> Callable[[Tuple[int, int]], Camera]:
    """Of a picture's size: that of the file, or another."""
    if isinstance(value, dict) and "view" in value:
        return _by_matrices(_object(value, "camera", ("view", "projection")), size)
    found = _object(value, "camera", _VIEW)
    for key in _VIEW:
        if key not in found and (key != "view_height" or found.get("vertical_angle") == 0):
            raise SettingsError(f"camera.{key}: it is missing, and needed")
    eye, target, up = (_numbers(found[key], f"camera.{key}", 3) for key in ("eye", "target", "up"))
    angle = _number(found["vertical_angle"], "camera.vertical_angle", 0, 3.14)
    near, far = (_number(found[key], f"camera.{key}") for key in ("near_plane", "far_plane"))
    height = 0.0 if angle > 0 else _number(found["view_height"], "camera.view_height")

    def camera(wanted: Tuple[int, int]) -> Camera:
        looking = Camera.look_at(eye, target, up)
        if angle > 0:
            return looking.perspective(angle, wanted, near, far)
        return looking.orthographic(height, wanted, near, far)

    return camera


def _by_matrices(found: Dict[str, Any], size: Optional[Tuple[int, int]]) -> Callable[[Tuple[int, int]], Camera]:
    if size is None:
        raise SettingsError("size: it is missing, and the matrices of a camera need it")
    # Column by column in the file, as the library has them.
    view, projection = (
        np.array(_numbers(found.get(name), f"camera.{name}", 16)).reshape(4, 4).T for name in ("view", "projection")
    )

    def camera(wanted: Tuple[int, int]) -> Camera:
        scaled = projection.copy()
        if wanted != size:  # the picture as it was, as large as fits in
            scale = min(wanted[0] / size[0], wanted[1] / size[1])
            for axis in range(2):
                scaled[axis] *= scale * size[axis] / wanted[axis]
        return Camera(view, scaled, (0, 0, *wanted))

    return camera


def _style(value: Any, preset: str) -> Style:
    style = Style(preset)
    found = _fields(value, "style", "style")
    if "layers" in found:
        layers = _list(found.pop("layers"), "style.layers", "style.layers")
        style.layers = [LayerStyle(**_of_layer_style(one)) for one in layers]
    if "lines" in found:
        style.lines = [LineStyle(**{"kind": "contour", **one}) for one in _list(found.pop("lines"), "style.lines", "style.lines")]
    style.update(**found)
    return style


def _of_layer_style(found: Dict[str, Any]) -> Dict[str, Any]:
    if "directions" in found:
        bits = found["directions"]
        found["directions"] = tuple(name for bit, name in enumerate(("first", "second")) if bits >> bit & 1)
    return {**found, **{name: bool(found[name]) for name in ("shown", "contours") if name in found}}


_TONES = (("tone", "tone_begin", "tone_end"), ("second_tone", "second_tone_begin", "second_tone_end"))


def _layer(found: Dict[str, Any]) -> Layer:
    base = new_struct("hrbfnpr_layer_desc")
    for name, begin, end in _TONES:
        ends = found.pop(begin, 0.0), found.pop(end, 0.0)
        if ends[1] > 0:
            found[name] = ends
    found.setdefault("budget", base.budget)
    if found.get("levels") == -1:
        found["levels"] = None
    if found.get("tone_smoothing", -1.0) < 0:
        found["tone_smoothing"] = None
    return Layer(**found)


def _lines(found: Dict[str, Any]) -> Lines:
    found["name"] = found.get("name") or ""
    return Lines(**found)


def _paint(value: Any) -> List[Dict[str, Any]]:
    if not isinstance(value, list):
        _refuse("paint", "a list of objects", value)
    result = []
    for i, one in enumerate(value):
        where = f"paint[{i}]"
        dab = _object(one, where, ("map", "position", "normal", "radius", "strength", "value", "direction"))
        of = dab.get("map")
        if of not in _MAPS:
            _refuse(f"{where}.map", f"one of {', '.join(_MAPS)}", of)
        vectors = ("position", "normal", *(("direction",) if of == "direction" else ()))
        for key in (*vectors, "radius", "strength", *(("value",) if of != "direction" else ())):
            if key not in dab:
                raise SettingsError(f"{where}.{key}: it is missing, and needed")
        for key in vectors:
            dab[key] = _numbers(dab[key], f"{where}.{key}", 3)
        if _number(dab["radius"], f"{where}.radius") <= 0:
            _refuse(f"{where}.radius", "a number above 0", dab["radius"])
        _number(dab["strength"], f"{where}.strength", 0, 1)
        _number(dab.get("value", 0), f"{where}.value")
        result.append(dab)
    return result
