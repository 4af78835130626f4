# SPDX-License-Identifier: MIT
"""Values of command-line options."""
from __future__ import annotations

import argparse
import math
import os
from typing import Callable, Dict, List, Optional, Tuple, Union

from .._fields import color
from .._names import LAYER_KINDS, PRESETS, STROKE_KINDS
from .._style import LayerStyle, Style

Vector = Tuple[float, float, float]


def words_of(error: BaseException) -> str:
    """An error in a line, with the file that it is about."""
    if isinstance(error, OSError) and error.filename is not None:
        return f"{os.fsdecode(error.filename)}: {error.strerror}"
    return " ".join(str(error).split())


def _numbers(text: str, length: int) -> List[float]:
    parts = text.split(",")
    if len(parts) != length:
        raise argparse.ArgumentTypeError(f"{length} numbers with commas between them are needed, not {text!r}")
    return [number(part) for part in parts]


def number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"a number is needed, not {text!r}") from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"a finite number is needed, not {text!r}")
    return value


def edges(text: str) -> Tuple[str, float]:
    """What becomes of the edges of a mesh, and from which angle on they are some."""
    if text in ("auto", "smooth"):
        return text, 30.0
    try:
        angle = float(text)
    except ValueError:
        angle = math.nan
    if not 5.0 <= angle <= 175.0:
        raise argparse.ArgumentTypeError(f"auto, smooth, or degrees from 5 to 175 are needed, not {text!r}")
    return "sharp", angle


def number_or_auto(text: str) -> Union[float, str]:
    return text if text == "auto" else number(text)


def count(low: int = 0, high: Optional[int] = None) -> Callable[[str], int]:
    """A whole number in a range."""

    def parse(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"a whole number is needed, not {text!r}") from None
        if value < low or (high is not None and value > high):
            bounds = f"at least {low}" if high is None else f"{low} to {high}"
            raise argparse.ArgumentTypeError(f"the number must be {bounds}, not {value}")
        return value

    return parse


def count_or_auto(low: int, high: int) -> Callable[[str], Optional[int]]:
    """A whole number in a range; None for auto."""
    return lambda text: None if text == "auto" else count(low, high)(text)


def vector(text: str) -> Vector:
    x, y, z = _numbers(text, 3)
    return x, y, z


def up(text: str) -> Optional[Vector]:
    """A direction; None for auto."""
    return None if text == "auto" else direction(text)


def direction(text: str) -> Vector:
    """x, y or z, with a sign or not, or three numbers."""
    axis, sign = text.lstrip("+-"), -1.0 if text.startswith("-") else 1.0
    if axis in ("x", "y", "z"):
        x, y, z = (sign if name == axis else 0.0 for name in "xyz")
        return x, y, z
    result = vector(text)
    if not any(result):
        raise argparse.ArgumentTypeError("a direction must not be 0,0,0")
    return result


def interval(text: str) -> Tuple[float, float]:
    low, high = _numbers(text, 2)
    if not 0 < low < high:
        raise argparse.ArgumentTypeError(f"0 < MIN < MAX is needed, not {text!r}")
    return low, high


def size(text: str) -> Union[int, Tuple[int, int]]:
    """WxH, or the longer side alone."""
    parts = text.lower().split("x")
    if len(parts) > 2:
        raise argparse.ArgumentTypeError(f"WIDTHxHEIGHT or one number is needed, not {text!r}")
    pixels = [count(1, 32768)(part) for part in parts]
    return pixels[0] if len(pixels) == 1 else (pixels[0], pixels[1])


def paint(text: str) -> Tuple[float, float, float, float]:
    """#rrggbb, #rrggbbaa, or numbers in [0, 1] with commas between them."""
    try:
        return color("colour", tuple(number(part) for part in text.split(",")) if "," in text else text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


MADE = ("stipples", *(kind for kind in STROKE_KINDS if kind != "field"))  # a field is a function


def layers(text: str) -> Tuple[str, ...]:
    """Kinds of layers that the command line can make."""
    names = tuple(name for name in text.split(",") if name)
    for name in names:
        if name not in MADE:
            raise argparse.ArgumentTypeError(f"layers must be of {', '.join(MADE)}, not {name!r}")
    return names


def styles(text: str) -> Tuple[str, ...]:
    """Named styles, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in PRESETS:
            raise argparse.ArgumentTypeError(f"there is no style {name!r}; there are {', '.join(PRESETS)}")
    return names


VIEWS = {
    "front": (0.0, 0.0), "right": (90.0, 0.0), "back": (180.0, 0.0), "left": (-90.0, 0.0),
    "top": (0.0, 89.0), "bottom": (0.0, -89.0),
}  # fmt: skip


def views(text: str) -> Tuple[str, ...]:
    """Names of views, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in VIEWS:
            raise argparse.ArgumentTypeError(f"there is no view {name!r}; there are {', '.join(VIEWS)}")
    return names


def per_layer(text: str) -> Dict[str, int]:
    """One number for all layers, or LAYER=NUMBER with commas between them."""
    if "=" not in text:
        return {name: count()(text) for name in MADE}
    result = {}
    for part in text.split(","):
        name, _, value = part.partition("=")
        layers(name)
        result[name] = count()(value)
    return result


def assignment(text: str) -> Tuple[str, str, str]:
    """FIELD=VALUE or LAYER.FIELD=VALUE, as layer (or ""), field and value."""
    name, equals, value = text.partition("=")
    layer, _, field = name.rpartition(".")
    if not equals or (layer and layer not in LAYER_KINDS):
        raise argparse.ArgumentTypeError(f"FIELD=VALUE or LAYER.FIELD=VALUE is needed, not {text!r}")
    fields = LayerStyle.fields() if layer else Style.fields()
    fields = tuple(field for field in fields if field != "kind")
    if field not in fields:
        raise argparse.ArgumentTypeError(f"there is no field {name!r}; there are {', '.join(fields)}")
    try:
        assign(Style(), layer, field, value)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return layer, field, value


def assign(style: Style, layer: str, field: str, text: str) -> None:
    """Set a field of a style from text, by the type of its present value."""
    owner: Union[Style, LayerStyle] = style.layer(layer) if layer else style
    present = getattr(owner, field)
    if isinstance(present, bool):
        if text.lower() not in ("0", "1", "true", "false"):
            raise ValueError(f"{field} must be true or false, not {text!r}")
        setattr(owner, field, text.lower() in ("1", "true"))
    elif isinstance(present, (int, float)):
        setattr(owner, field, type(present)(number(text)))
    elif field == "directions":
        setattr(owner, field, text.split(","))
    elif field == "light":
        setattr(owner, field, direction(text))
    elif isinstance(present, tuple):
        setattr(owner, field, paint(text))
    else:
        setattr(owner, field, text)
