# SPDX-License-Identifier: MIT
"""Turns options, given by name, into descriptors of the library, as the table in `_options.py` says."""
from __future__ import annotations

import argparse
import difflib
import re
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _records, _values
from ._arrays import block_in
from ._errors import new_list, new_struct
from ._fields import color
from ._library import ffi, lib
from ._light import Light
from ._model import Model
from ._names import NORMALS
from ._options import OPTIONS, Option
from ._point_set import PointSet
from ._records import fill_list, text_in

Options = Dict[str, Any]
"""Values by option name, as `_values.py` reads them.  Options that are not given are missing."""

BY_NAME: Dict[str, Option] = {row.alias: row for row in OPTIONS if row.alias}
BY_NAME.update({row.name: row for row in OPTIONS})
_WIDTH_BY_HEIGHT = ("size", "page")  # written as WIDTHxHEIGHT
_PREFIXES = {"profile": "PROFILE", "parts": "PARTS", "sides": "PICTURE_SIDES"}
_CHOICES = {"dots": "DOT_SHAPE", "widths": "WIDTHS", "curves": "CURVES"}  # options of a page
_PLOTTERS = ("hpgl", "gcode")


# ---- Values of Python


def option_of(name: str) -> Option:
    """The row of an option, by its name or its alias."""
    found = BY_NAME.get(name)
    if found is None:
        near = difflib.get_close_matches(name, BY_NAME, 3)
        hint = f"did you mean {' or '.join(near)}?" if near else "help(hrbfnpr.draw) lists them"
        raise TypeError(f"a drawing has no option {name!r}: {hint}")
    return found


def options_of(given: Mapping[str, Any]) -> Options:
    """Convert values of Python to those that the command line reads.  None means the default.

    Raises
    ------
    TypeError
        If there is no such option.
    ValueError
        If an option cannot have its value.
    """
    options: Options = {}
    for name, value in given.items():
        row = option_of(name)
        if row.kind == "assignment" and value is not None:
            options[row.name] = _assignments(value)
        elif value is not None:
            options[row.name] = parsed(name, row, value)
    return {name: value for name, value in options.items() if value is not False and value is not None}


def parsed(name: str, row: Option, value: Any) -> Any:
    """The value of one option.  `name` is for messages."""
    if row.kind == "flag":
        if not isinstance(value, (bool, np.bool_)):
            raise ValueError(f"{name} must be True or False, not {value!r}")
        return bool(value)
    if row.kind == "palette" and not isinstance(value, str):
        value = [_hex(one) for one in value]
    if row.kind == "lights":
        value = _lights(value)
    text = _words(value, "x" if row.kind in _WIDTH_BY_HEIGHT else ",")
    if row.kind == "lines" and not text:
        text = "none"
    if row.choices:
        return chosen(name, text, row.choices)
    try:
        return _values.parser_of(row.kind)(text)
    except (argparse.ArgumentTypeError, ValueError) as error:
        raise ValueError(f"{name}: {error}") from None


def chosen(name: str, text: str, choices: Sequence[str]) -> str:
    """The choice that a text names.  Hyphens and underscores are equivalent."""
    names = {choice.replace("_", "-"): choice for choice in choices}
    if text.replace("_", "-") not in names:
        raise ValueError(f"{name} must be one of {', '.join(names)}, not {text!r}")
    return names[text.replace("_", "-")]


def _words(value: Any, between: str) -> str:
    """A value as the command line writes it."""
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping):
        return ",".join(f"{name}={_words(part, between)}" for name, part in value.items())
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)):
        return between.join(_words(part, between) for part in value)
    return str(value)


def _hex(value: Any) -> str:
    """A colour as #rrggbb or #rrggbbaa."""
    if isinstance(value, str):
        return value
    return "#" + "".join(f"{round(255 * part):02x}" for part in color("palette", tuple(value)))


def _lights(value: Any) -> Any:
    """One light, or several as a text: directions, texts, or `Light` objects."""
    if isinstance(value, Light):
        value = [value]
    if not isinstance(value, (list, tuple)) or not any(isinstance(one, (str, Light, list, tuple)) for one in value):
        return value
    return ";".join(_light_in_words(one) if isinstance(one, Light) else _words(one, ",") for one in value)


def _light_in_words(light: Light) -> str:
    more = [f"{name}={getattr(light, name)}" for name in _values.LIGHT_FIELDS]
    return f"{_words(light.place, ',')}:{','.join(more + ['place'] * (light.kind == 'place'))}"


def _assignments(value: Any) -> Any:
    if not isinstance(value, Mapping):
        raise TypeError("set must be a mapping of fields to values, such as {'hatch.ink': '#800000'}")
    try:
        return [_values.assignment(f"{name}={_words(part, ',')}") for name, part in value.items()]
    except argparse.ArgumentTypeError as error:
        raise ValueError(f"set: {error}") from None


# ---- The descriptor of a picture


def constant(name: str) -> int:
    """The value of HRBFNPR_(name)."""
    number: int = ffi.integer_const(f"HRBFNPR_{name.replace('-', '_').upper()}")
    return number


def describe(options: Options, flags: Sequence[str] = ()) -> Tuple[Any, List[Any]]:
    """A hrbfnpr_picture_desc with these options, and the objects to keep alive with it."""
    desc = new_struct("hrbfnpr_picture_desc")
    keep: List[Any] = []
    for flag in flags:
        desc.flags |= constant(f"PICTURE_{flag}")
    changes: List[Tuple[str, str]] = []
    for row in OPTIONS:
        if row.name in options:
            changes += _set(desc, row, options[row.name], keep)
    structs = new_list("hrbfnpr_change", len(changes))
    for struct, (field, value) in zip(structs, changes):
        struct.field, struct.value = text_in(keep, field), text_in(keep, value)
    desc.changes, desc.change_count = structs, len(changes)
    keep.append(structs)
    return desc, keep


def _set(desc: Any, row: Option, value: Any, keep: List[Any]) -> List[Tuple[str, str]]:
    """Set the field of an option.  Returns the changes for an option that is written as changes."""
    section, _, field = row.target.rpartition(".")
    if section == "flags":
        desc.flags |= constant(f"PICTURE_{field}")
    elif row.target.startswith("marks.*."):
        return [(f"marks.{kind}.{field}", str(number)) for kind, number in value.items()]
    elif section == "page":
        pass  # describe_page sets these
    elif section:
        return [(row.target, _text(value))]
    elif row.name in _SPECIAL:
        return _SPECIAL[row.name](desc, value, keep) or []
    elif row.choices:
        setattr(desc, field, constant(f"{_PREFIXES[field]}_{value}"))
    elif isinstance(value, str) or row.kind == "layers":
        if value:
            setattr(desc, field, text_in(keep, _text(value)))
    else:
        setattr(desc, field, list(value) if isinstance(value, tuple) else value)
    return []


def _text(value: Any) -> str:
    """A value as a change writes it."""
    if isinstance(value, (tuple, list)):
        return ",".join(map(_text, value))
    return repr(value) if isinstance(value, float) else str(value)


def _set_size(desc: Any, value: Any, keep: List[Any]) -> None:
    if isinstance(value, int):
        desc.size = value
    else:
        desc.width, desc.height = value


def _set_edges(desc: Any, value: Any, keep: List[Any]) -> None:
    desc.edges, desc.edge_angle = constant(f"PICTURE_EDGES_{value[0]}"), value[1]


def _set_normals(desc: Any, value: Any, keep: List[Any]) -> None:
    desc.normals = NORMALS["given" if value == "keep" else value]


def _set_seed_points(desc: Any, value: Any, keep: List[Any]) -> None:
    from . import shapes

    points = value if isinstance(value, np.ndarray) else shapes.read(value).points
    keep.append(block_in("seed_points", points).fill(desc.seed_points))


def _set_random_seed(desc: Any, value: int, keep: List[Any]) -> List[Tuple[str, str]]:
    desc.random_seed = value
    return [("marks.random_seed", str(value))]


def _set_ground(desc: Any, value: Any, keep: List[Any]) -> None:
    desc.ground = constant("PICTURE_GROUND_LOWEST" if value == "lowest" else "PICTURE_GROUND_HEIGHT")
    desc.ground_height = 0.0 if value == "lowest" else value


_SPECIAL: Dict[str, Any] = {
    "size": _set_size, "edges": _set_edges, "ground": _set_ground, "normals": _set_normals, "seed_points": _set_seed_points,
    "random_seed": _set_random_seed,
    "depth_range": lambda desc, value, keep: [("style.depth_min", repr(value[0])), ("style.depth_max", repr(value[1]))],
    "set": lambda desc, value, keep: list(value),
    "classes": lambda desc, value, keep: [],  # for the reader of a file
    "curvature_of": lambda desc, value, keep: [(f"marks.{kind}.flags", "1") for kind in value],
}  # fmt: skip


def in_names(text: str, as_option: bool) -> str:
    """The library's error about a descriptor, in the caller's words: picture_desc.pen becomes mark_radius."""

    def named(found: "re.Match[str]") -> str:
        target = found.group(1) or found.group(2)
        row = next((row for row in OPTIONS if row.target == target or (not row.target and row.name == target)), None)
        if row is None:
            return found.group(0)
        return f"--{row.name.replace('_', '-')}" if as_option else row.name

    return re.sub(r"^(?:picture_desc\.(\w+)|changes\[\d+\]\.value of ([\w.]+))", named, text)


# ---- Sources


def fill_source(struct: Any, thing: Any, name: Optional[str], with_fields: bool = False) -> List[Any]:
    """Write a hrbfnpr_picture_source of a Shape, a Model, a PointSet, or a model with its marks.  Keep the result alive.

    `with_fields`: whether the values of a Shape's points are passed, too.
    """
    keep: List[Any] = []
    if name is not None:
        struct.name = text_in(keep, name)
    for part in thing if isinstance(thing, tuple) else (thing,):
        if isinstance(part, (Model, PointSet)):
            setattr(struct, "model" if isinstance(part, Model) else "point_set", part._handle)
            keep.append(part)
        else:
            _fill_shape(struct, part, keep)
            if with_fields:
                _fill_fields(struct, part, keep)
    return keep


def _fill_fields(struct: Any, shape: Any, keep: List[Any]) -> None:
    """Write the values of the points."""
    structs = new_list("hrbfnpr_source_field", len(shape.fields))
    for one, (name, given) in zip(structs, shape.fields.items()):
        one.name, one.kind = text_in(keep, name), constant(f"FIELD_KIND_{given.kind}")
        components = 1 if given.kind == "scalar" else 3
        keep.append(block_in(f"fields[{name!r}]", given.values, components, "f").fill(one.values))
    struct.fields, struct.field_count = structs, len(shape.fields)
    keep.append(structs)


def _fill_shape(struct: Any, shape: Any, keep: List[Any]) -> None:
    keep.append(block_in("points", shape.points).fill(struct.points))
    if shape.normals is not None and not shape.is_mesh:
        keep.append(block_in("normals", shape.normals).fill(struct.normals))
    if shape.is_mesh:
        keep.append(block_in("triangles", shape.triangles, 3, "q").fill(struct.triangles))
    if shape.sharp_edges is not None and shape.is_mesh:
        struct.flags |= lib.HRBFNPR_SOURCE_HAS_SHARP_EDGES
        keep.append(block_in("sharp_edges", shape.sharp_edges, 2, "q").fill(struct.sharp_edges))
    if shape.up is not None:
        of = "pictures of a depth camera" if shape.is_picture else f"{shape.format.split(',')[0]} files"
        struct.up, struct.up_by = list(shape.up), text_in(keep, of)
    if shape.viewpoint is not None:
        struct.flags |= lib.HRBFNPR_SOURCE_HAS_VIEWPOINT
        struct.viewpoint = list(shape.viewpoint)
    if shape.is_picture:
        struct.flags |= lib.HRBFNPR_SOURCE_IS_PHOTO
    if shape.image_shape is not None:
        struct.rows, struct.columns = shape.image_shape


# ---- Pages


def describe_page(options: Options, format: str) -> Tuple[Any, List[Any]]:
    """A hrbfnpr_picture_page_desc with these options, and the objects to keep alive with it."""
    whole, page = new_struct("hrbfnpr_picture_page_desc"), new_struct("hrbfnpr_page_desc")
    whole.page, page.format = page, constant(f"PAGE_FORMAT_{format}")
    keep: List[Any] = [page]
    if format in _PLOTTERS and options.get("single_pass"):
        page.dots = constant("DOT_SHAPE_LINES")
    for row in OPTIONS:
        if not row.target.startswith("page.") or row.name not in options:
            continue
        value, field = options[row.name], row.target[5:]
        if row.kind == "flag":
            page.flags |= constant(f"PAGE_{field}")
        elif row.choices:
            setattr(page, field, constant(f"{_CHOICES[field]}_{value}"))
        elif field == "pens":
            fill_list(page, "pen", _records.Pen, value, keep)
        elif field == "pen_widths":
            keep.append(block_in(field, np.array(value, dtype=float), 1, "d").fill(whole.pen_widths))
        elif field in ("paper", "paper_margin"):
            setattr(whole, field, text_in(keep, value) if field == "paper" else value)
        else:
            setattr(page, field, text_in(keep, value) if isinstance(value, str) else value)
    return whole, keep


# ---- Documentation

_IN_WORDS = {
    "flag": "bool", "number": "float", "count": "int", "text": "str", "vector": "(x, y, z)", "direction": "(x, y, z) or str",
    "up": "(x, y, z) or str", "paint": "(r, g, b, a) or str", "size": "(width, height) or int", "layers": "str or sequence of str",
    "lines": "str or sequence of str", "per_layer": "int, or mapping of str to int", "interval": "(low, high)",
    "edges": "str or float", "ground": "bool or float",
    "lights": "(x, y, z), str, Light, or a sequence of these", "number_or_auto": "float or str", "count_or_auto": "int or str",
    "assignment": "mapping of str", "file": "path", "page": "(width, height) or str", "pens": "str",
    "pen_widths": "sequence of float", "fields": "str, sequence of str, or mapping of str to str",
    "palette": "str or sequence of colours", "classes": "str, int or sequence of int",
}  # fmt: skip


def in_documentation(indent: str) -> str:
    """The options as the text of parameters in a docstring."""
    lines = []
    for row in OPTIONS:
        kind = row.kind.split()[0]
        what = "{" + ", ".join(f'"{name}"' for name in row.choices) + "}" if row.choices else _IN_WORDS[kind]
        lines += [f"{row.name} : {what}", f"    {row.words[0].upper()}{row.words[1:]}."]
    return f"\n{indent}".join(lines)
