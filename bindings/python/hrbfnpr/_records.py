# SPDX-License-Identifier: MIT
"""Makes the classes with the fields of structs from `_records.json`, which bindings/generate makes from the header.

A class is made when it is first used.  Other modules therefore write `_records.ModelInfo` where they use one, and import
names for annotations only.  `_records.pyi` describes the classes to type checkers and editors.
"""
from __future__ import annotations

from dataclasses import make_dataclass
from math import isnan
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from ._arrays import Array, block_in
from ._callbacks import check
from ._errors import new_error, new_list, new_struct
from ._fields import Attributes, field_of
from ._library import ffi
from ._names import NAMES, TABLE, name_of, number_of

T = TypeVar("T")
Vector = Tuple[float, float, float]
Interval = Tuple[float, float]
Density = Union[str, "SurfaceField", Callable[[Array, Array], Array]]
Direction = Union["SurfaceField", Callable[[Array, Array], Array]]

# For each kind of field: its type, and the function that converts its value.  Other kinds are prefixes of constants.
_KINDS: Dict[Any, Tuple[str, Callable[[Any], Any]]] = {
    "count": ("int", int),
    "number": ("float", float),
    "number?": ("Optional[float]", lambda value: None if isnan(value) else value),
    "flag": ("bool", bool),
    "text": ("str", lambda characters: ffi.string(characters).decode()),
    3: ("Vector", tuple),
    4: ("Tuple[float, float, float, float]", tuple),
}


def _named(prefix: str) -> Tuple[str, Callable[[Any], Any]]:
    names = NAMES[prefix]
    if prefix == "LAYER_KIND":  # the header says to treat an unknown kind like "own"
        return "str", lambda number: name_of(names, number) if number in names.values() else "own"
    return "str", lambda number: name_of(names, number)


def _record(name: str, struct: str, doc: str, fields: List[Any]) -> type:
    kinds = {field: _KINDS.get(kind) or _named(kind) for field, _, kind in fields}
    reads = [(field, source, kinds[field][1]) for field, source, _ in fields]
    namespace = {"__doc__": doc, "__module__": __name__, "_struct": f"hrbfnpr_{struct}", "_reads": reads}
    types = [(field, kind) for field, (kind, _) in kinds.items()]
    return make_dataclass(name, types, namespace=namespace, frozen=True)


def read(kind: Type[T], struct: Any, /, **known: Any) -> T:
    """Make a record from its struct.  `known` fields get these values instead."""
    values = {field: convert(getattr(struct, source)) for field, source, convert in kind._reads}
    return kind(**{**values, **known})


def get(kind: Type[T], function: Callable[..., int], *arguments: Any) -> T:
    """Make a record from the struct that a function of the library fills."""
    struct, error = new_struct(kind._struct), new_error()
    check(function(*arguments, struct, error), error)
    return read(kind, struct)


# ---- Classes that the caller fills


def _described(name: str, struct: str, doc: str, fields: List[Any], required: List[str], defaults: Dict[str, Any]) -> type:
    """Make a dataclass.  A field without a default in Python gets the default of the library."""
    initial, types = new_struct(f"hrbfnpr_{struct}"), []
    for field, source, kind, of_python in fields:
        if field in required:
            types.append((field, of_python))
            continue
        if field in defaults:
            value = defaults[field]
        else:
            value = getattr(initial, source)
            value = name_of(NAMES[kind], value) if kind in NAMES else tuple(value) if kind in ("ink", "vector") else value
        types.append((field, of_python, tuple(value) if isinstance(value, list) else value))
    fills = [(field, source, kind, of_python.startswith("Optional")) for field, source, kind, of_python in fields if source]
    namespace = {"__doc__": doc, "__module__": __name__, "_struct": f"hrbfnpr_{struct}", "_fills": fills}
    return make_dataclass(name, types, namespace=namespace)


def text_in(keep: List[Any], text: Optional[str]) -> Any:
    """A text for the library; NULL for None.  Whatever must be kept alive is added to `keep`."""
    if text is None:
        return ffi.NULL
    keep.append(ffi.new("char[]", text.encode()))
    return keep[-1]


def _rgba(ink: Sequence[float]) -> List[float]:
    if len(ink) not in (3, 4):
        raise ValueError(f"ink must be (red, green, blue) or (red, green, blue, alpha), not {ink!r}")
    return [*ink] if len(ink) == 4 else [*ink, 1.0]


def fill(target: Any, described: Any, keep: List[Any], about: str = "") -> None:
    """Copy an object that the caller filled into its struct.  An optional field that is None keeps the library's default.

    `about` is put before names in messages.
    """
    for field, source, kind, optional in described._fills:
        value = getattr(described, field)
        if value is None and optional:
            continue
        if kind.startswith("array"):
            _, components, codes = kind.split()
            keep.append(block_in(about + field, value, int(components), codes).fill(getattr(target, source)))
        elif kind in NAMES:
            setattr(target, source, number_of(field, NAMES[kind], value))
        else:
            setattr(target, source, _rgba(value) if kind == "ink" else text_in(keep, value) if kind == "text"
                    else value._handle if kind == "handle" else value)  # fmt: skip


def fill_list(desc: Any, name: str, kind: Any, given: Sequence[Any], keep: List[Any]) -> None:
    """Fill the list (name)s and (name)_count of a descriptor from objects that the caller filled."""
    structs = new_list(kind._struct, len(given))
    for struct, one in zip(structs, given):
        fill(struct, one, keep)
    setattr(desc, f"{name}s", structs)
    setattr(desc, f"{name}_count", len(given))
    keep.append(structs)


def _attributes(name: str, rows: List[Any]) -> type:
    return type(name, (Attributes,), {"__module__": __name__, **{row[0]: field_of(*row[1:]) for row in rows}})


def __getattr__(name: str) -> Any:
    """Make a class when it is first used.  Making all of them would take longer than the rest of the import."""
    if name in TABLE["records"]:
        made = _record(name, **TABLE["records"][name])
    elif name in TABLE["described"]:
        made = _described(name, **TABLE["described"][name])
    elif name in TABLE["styles"]:
        made = _attributes(name, TABLE["styles"][name])
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = made
    return made
