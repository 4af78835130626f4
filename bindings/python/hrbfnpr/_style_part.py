# SPDX-License-Identifier: MIT
"""The common part of the elements of a style: layer styles, line styles and lights."""
from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Type, TypeVar

from ._errors import new_struct
from ._fields import Attributes, Field
from ._library import ffi
from ._records import text_in

Made = TypeVar("Made", bound="StylePart")


class StylePart(Attributes):
    """An element of a list of a style, with a kind."""

    _c_type: str
    kind: Field[str, str]

    def __init__(self, kind: str, fields: Mapping[str, Any]) -> None:
        self._struct = new_struct(self._c_type)
        self.kind = kind
        for field, value in fields.items():
            setattr(self, field, value)

    @classmethod
    def _from_struct(cls: Type[Made], struct: Any) -> Made:
        made = cls()  # type: ignore[call-arg]
        made._struct[0] = struct
        made._struct.struct_size = ffi.sizeof(cls._c_type)
        return made

    def copy(self: Made, **fields: Any) -> Made:
        """Return a copy with some fields changed."""
        return type(self)(**{**self._values(), **fields})

    def _values(self) -> Dict[str, Any]:
        return {name: getattr(self, name) for name in self.fields()}

    def _fill(self, target: Any) -> Any:
        """Write the C struct.  The result must be kept alive with it."""
        target[0] = self._struct[0]
        return []

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._values() == other._values()  # type: ignore[attr-defined]

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Any:
        return _restore, (type(self), self._values())

    def __repr__(self) -> str:
        base = type(self)()._values()  # type: ignore[call-arg]
        changed = [f"{k}={v!r}" for k, v in self._values().items() if v != base[k] and k != "kind"]
        return f"{type(self).__name__}({', '.join([repr(self.kind), *changed])})"


class KindStyle(StylePart):
    """A style for the layers or lines of one kind and name."""

    def __init__(self, kind: str, name: Optional[str], fields: Mapping[str, Any]) -> None:
        self.name = name
        super().__init__(kind, fields)

    @property
    def name(self) -> Optional[str]:
        """The name of the layers or lines that this style is for; None: any name."""
        return self._name

    @name.setter
    def name(self, value: Optional[str]) -> None:
        self._name = value

    @classmethod
    def _from_struct(cls: Type[Made], struct: Any) -> Made:
        made = super()._from_struct(struct)  # type: ignore[misc]
        made._name = None if struct.name == ffi.NULL else ffi.string(struct.name).decode()
        made._struct.name = ffi.NULL
        return made

    def _values(self) -> Dict[str, Any]:
        return {"name": self.name, **super()._values()}

    def _fill(self, target: Any) -> Any:
        keep: List[Any] = super()._fill(target)
        target.name = text_in(keep, self._name)
        return keep


def _restore(made: Type[Made], values: Mapping[str, Any]) -> Made:
    return made(**values)
