# SPDX-License-Identifier: MIT
"""Styles of lines: contours and feature lines as curves."""
from __future__ import annotations

from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

from ._arrays import block_in
from ._errors import new_struct
from ._fields import Attributes, choice, color_field, number
from ._layer import c_name
from ._library import ffi
from ._names import CAPS, HIDDEN_PARTS, LINE_KINDS


class LineStyle(Attributes):
    """How the lines of one kind are drawn, of items that have a `LineSet`; an element of `Style.lines`.

    Parameters
    ----------
    kind : {"contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section", \
            "border", "own"}
    name : str, optional
        Of lines that are found once: those that are called so; None: whatever they are called.
    levels : sequence of float, optional
        Of isophotes: n . l, from -1 to 1.
    **fields
        Other fields to change.  Lengths are in pixels.
    """

    kind = choice(LINE_KINDS, "The lines that this is for.")
    hidden = choice(HIDDEN_PARTS, 'Parts that surface hides: "none", "attenuated", "dashed" or "shown".')
    cap = choice(CAPS, 'Of free ends, where a line turns behind its own surface: "round", "flat" or "pointed".')
    width = number("Pixels.")
    taper = number("Pixels over which a line narrows to a free end; 0 = not at all.")
    hidden_width = number('Of "attenuated" and "dashed".')
    hidden_opacity = number('Of "attenuated", for each layer of surface before it, 0 to 1.')
    dash = number('Of "dashed", in hidden_widths; the more layers lie before it, the shorter.')
    gap = number("Between dashes, in hidden_widths.")
    shortest = number("Parts with a free end, and hidden ones, that are shorter are not drawn.")
    fade = number("0 to 1: how much paler a line is where its strength is `lower` than where it is `upper`.")
    lower = number("A line goes on while its strength is at least this; 0 with `upper` 0 = that of the kind.")
    upper = number("... and is drawn if it is this somewhere.")
    ink = color_field("Straight RGBA in [0, 1], or '#rrggbb'.")

    def __init__(
        self, kind: str = "contour", name: Optional[str] = None, levels: Sequence[float] = (), **fields: Any
    ) -> None:
        self._struct = new_struct("hrbfnpr_line_style")
        self.kind = kind
        self.name = name
        self.levels = tuple(levels)
        for field, value in fields.items():
            setattr(self, field, value)

    @property
    def name(self) -> Optional[str]:
        """Of lines that are found once: those that are called so; None: whatever they are called."""
        return self._name

    @name.setter
    def name(self, value: Optional[str]) -> None:
        self._name = value

    @property
    def levels(self) -> Tuple[float, ...]:
        """Of isophotes: n . l, from -1 to 1."""
        return self._levels

    @levels.setter
    def levels(self, value: Sequence[float]) -> None:
        self._levels = tuple(float(level) for level in value)

    @classmethod
    def _from_struct(cls, struct: Any) -> LineStyle:
        made = cls()
        made._struct[0] = struct
        made._struct.struct_size = ffi.sizeof("hrbfnpr_line_style")
        made._name = None if struct.name == ffi.NULL else ffi.string(struct.name).decode()
        made._struct.name = ffi.NULL
        return made

    def copy(self, **fields: Any) -> LineStyle:
        """Another one like this, with some fields changed."""
        return LineStyle(**{**self._values(), **fields})

    def _values(self) -> Dict[str, Any]:
        fields = {name: getattr(self, name) for name in self.fields()}
        return {"name": self.name, "levels": self.levels, **fields}

    def _fill(self, target: Any) -> Any:
        """Write a hrbfnpr_line_style; returns what must be kept alive."""
        target[0] = self._struct[0]
        keep = [c_name(target, self._name)]
        if self._levels:
            keep.append(block_in("levels", self._levels, 1, "d").fill(target.levels))
        return keep

    def __eq__(self, other: object) -> bool:
        return isinstance(other, LineStyle) and self._values() == other._values()

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Any:
        return _restore, (self._values(),)

    def __repr__(self) -> str:
        base = LineStyle()._values()
        changed = [f"{k}={v!r}" for k, v in self._values().items() if v != base[k] and k != "kind"]
        return f"LineStyle({', '.join([repr(self.kind), *changed])})"


def _restore(values: Mapping[str, Any]) -> LineStyle:
    return LineStyle(**values)
