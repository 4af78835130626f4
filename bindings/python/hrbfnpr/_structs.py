# SPDX-License-Identifier: MIT
"""Output structs of the library as frozen dataclasses of the same field names."""
from __future__ import annotations

from dataclasses import fields
from math import isnan
from typing import Any, Callable, Mapping, Optional, Type, TypeVar

from ._library import ffi

T = TypeVar("T")
Convert = Callable[[Any], Any]


def read_struct(kind: Type[T], struct: Any, convert: Optional[Mapping[str, Convert]] = None) -> T:
    """Fill a dataclass from the struct's fields; arrays of numbers become tuples, NaN of an Optional becomes None."""
    values = {}
    for field in fields(kind):
        value = getattr(struct, field.name)
        if convert and field.name in convert:
            value = convert[field.name](value)
        elif isinstance(value, ffi.CData):
            value = tuple(value)
        elif str(field.type).startswith("Optional") and isnan(value):
            value = None
        values[field.name] = value
    return kind(**values)
