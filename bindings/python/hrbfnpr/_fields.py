# SPDX-License-Identifier: MIT
"""Attributes that are fields of a C struct."""
from __future__ import annotations

from typing import Any, Callable, Dict, Generic, Tuple, TypeVar, Union

from ._arrays import vector
from ._names import NAMES, name_of, number_of

Get = TypeVar("Get")
Set = TypeVar("Set")
Color = Union[str, Tuple[float, ...]]


def color(argument: str, value: Color) -> Tuple[float, float, float, float]:
    """Straight RGBA in [0, 1] from "#rrggbb", "#rrggbbaa", or 3 or 4 numbers."""
    if isinstance(value, str):
        digits = value.lstrip("#")
        if value[:1] != "#" or len(digits) not in (6, 8) or set(digits.lower()) - set("0123456789abcdef"):
            raise ValueError(f"{argument} must be '#rrggbb' or '#rrggbbaa', not {value!r}")
        value = tuple(byte / 255 for byte in bytes.fromhex(digits))
    numbers = [float(number) for number in value]
    if len(numbers) == 3:
        numbers.append(1.0)
    if len(numbers) != 4:
        raise ValueError(f"{argument} must be 3 or 4 numbers, or '#rrggbb'")
    return numbers[0], numbers[1], numbers[2], numbers[3]


class Field(Generic[Get, Set]):
    """An attribute that is a field of the object's struct."""

    def __init__(self, write: Callable[[str, Set], Any], read: Callable[[Any], Get], doc: str) -> None:
        self._write, self._read = write, read
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, instance: Any, owner: Any = None) -> Get:
        if instance is None:
            return self  # type: ignore[return-value]
        return self._read(getattr(instance._struct, self._name))

    def __set__(self, instance: Any, value: Set) -> None:
        setattr(instance._struct, self._name, self._write(self._name, value))


def choice(numbers: Dict[str, int], doc: str) -> Field[str, str]:
    return Field(lambda name, value: number_of(name, numbers, value), lambda n: name_of(numbers, n), doc)


def field_of(kind: str, doc: str) -> Field[Any, Any]:
    """An attribute for a kind of field in `_records.json`."""
    if kind in NAMES:
        return choice(NAMES[kind], doc)
    return Field(*_KINDS[kind], doc)


_KINDS: Dict[str, Tuple[Callable[[str, Any], Any], Callable[[Any], Any]]] = {
    "number": (lambda name, value: float(value), float),
    "count": (lambda name, value: int(value), int),
    "flag": (lambda name, value: int(bool(value)), bool),
    "color": (color, tuple),
    "vector": (vector, tuple),
}


class Attributes:
    """Base class that refuses attributes that are not fields, so that a misspelt name is an error."""

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and not hasattr(type(self), name):
            raise AttributeError(f"{type(self).__name__} has no field {name!r}")
        object.__setattr__(self, name, value)

    @classmethod
    def fields(cls) -> Tuple[str, ...]:
        """Return the names of all fields."""
        own = {name: None for kind in reversed(cls.__mro__) for name, value in vars(kind).items() if isinstance(value, Field)}
        return tuple(own)

