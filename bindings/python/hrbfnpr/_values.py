# SPDX-License-Identifier: MIT
"""Reads the values of a drawing's options from text, as the command line gives them, and as `hrbfnpr.draw` writes them."""
from __future__ import annotations

import argparse
import math
import os
import re
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple, Union

from . import _records
from ._fields import color
from ._names import LAYER_KINDS, LIGHT_SPACES, LINE_KINDS, LINE_TYPES, MADE_KINDS, PRESETS, number_of
from ._style import LayerStyle, Style

if TYPE_CHECKING:
    from ._records import Pen

Vector = Tuple[float, float, float]
MADE = MADE_KINDS
PAPERS = ("a0", "a1", "a2", "a3", "a4", "a5", "a6", "letter", "legal", "tabloid")
LINES = (
    "contour", "suggestive", "ridges", "valleys", "apparent", "parabolic", "isophotes", "section", "border", "crease",
    "intersection", "shadow", "terminator", "soft", "tangent",
)  # fmt: skip
_ALSO_LINES = ("ridge", "valley", "contours", "isophote", "sections", "borders", "creases", "intersections", "shadows",
               "terminators", "soft_edge", "soft_edges", "tangent_edge", "tangent_edges")


def words_of(error: BaseException) -> str:
    """An error on one line, with the file that it is about."""
    if isinstance(error, OSError) and error.filename is not None:
        return f"{os.fsdecode(error.filename)}: {error.strerror}"
    return " ".join(str(error).split())


def wrong(text: str) -> argparse.ArgumentTypeError:
    """The error for a wrong value.  Both callers add the name of the option."""
    return argparse.ArgumentTypeError(text)


def _numbers(text: str, length: int) -> List[float]:
    parts = text.split(",")
    if len(parts) != length:
        raise wrong(f"{length} numbers with commas between are needed, not {text!r}")
    return [number(part) for part in parts]


def number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise wrong(f"a number is needed, not {text!r}") from None
    if not math.isfinite(value):
        raise wrong(f"a finite number is needed, not {text!r}")
    return value


def positive(text: str) -> float:
    """A number above 0."""
    value = number(text)
    if not 0 < value < 1e9:
        raise wrong(f"must be above 0, not {text}")
    return value


def count(low: int = 0, high: Optional[int] = None) -> Callable[[str], int]:
    """A whole number in a range."""

    def parse(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            raise wrong(f"a whole number is needed, not {text!r}") from None
        if value < low or (high is not None and value > high):
            bounds = f"at least {low}" if high is None else f"{low} to {high}"
            raise wrong(f"the number must be {bounds}, not {value}")
        return value

    return parse


def vector(text: str) -> Vector:
    x, y, z = _numbers(text, 3)
    return x, y, z


def direction(text: str) -> Vector:
    """x, y or z, with or without a sign, or three numbers."""
    axis, sign = text.lstrip("+-"), -1.0 if text.startswith("-") else 1.0
    if axis in ("x", "y", "z"):
        x, y, z = (sign if name == axis else 0.0 for name in "xyz")
        return x, y, z
    result = vector(text)
    if not any(result):
        raise wrong("a direction must not be 0,0,0")
    return result


LIGHT_FIELDS = ("intensity", "shadow", "softness", "space")


def light(text: str) -> str:
    """A light, as X,Y,Z or X,Y,Z:intensity=N,shadow=N,softness=N,space=NAME,place."""
    place, colon, rest = text.partition(":")
    parts = rest.split(",") if rest else []
    towards = vector(place) if "place" in parts else direction(place)
    for part in parts:
        name, _, value = part.partition("=")
        if part == "place":
            continue
        if name not in LIGHT_FIELDS:
            raise wrong(f"a light has no {part!r}; it has {', '.join(LIGHT_FIELDS)} and place, such as 1,1,0:shadow=1")
        if name == "space":
            if value not in LIGHT_SPACES:
                raise wrong(f"the space of a light is {', '.join(LIGHT_SPACES)}, not {value!r}")
        else:
            number(value)
    return ",".join(map(repr, towards)) + colon + rest


def lights(text: str) -> str:
    """Lights with semicolons between them."""
    return ";".join(light(part) for part in text.split(";"))


def or_auto(parse: Callable[[str], Any], of_auto: Any = None) -> Callable[[str], Any]:
    """A parser that takes "auto", too."""
    return lambda text: of_auto if text == "auto" else parse(text)


up = or_auto(direction)


def edges(text: str) -> Tuple[str, float]:
    """What to do with the edges of a mesh, and the angle above which they are sharp."""
    if text in ("auto", "smooth"):
        return text, 30.0
    try:
        angle = float(text)
    except ValueError:
        angle = math.nan
    if not 5.0 <= angle <= 175.0:
        raise wrong(f"auto, smooth or a number of degrees from 5 to 175 is needed, not {text!r}")
    return "sharp", angle


def interval(text: str) -> Tuple[float, float]:
    low, high = _numbers(text, 2)
    if not 0 < low < high:
        raise wrong(f"MIN,MAX with 0 < MIN < MAX is needed, not {text!r}")
    return low, high


def ground(text: str) -> Union[str, float, None]:
    """Where the ground is: "lowest", or its height; None: nowhere."""
    if text.lower() in ("lowest", "true", "false", "none"):
        return "lowest" if text.lower() in ("lowest", "true") else None
    try:
        return number(text)
    except argparse.ArgumentTypeError:
        raise wrong(f"lowest or the height of the ground is needed, not {text!r}") from None


def size(text: str) -> Union[int, Tuple[int, int]]:
    """WIDTHxHEIGHT, or the longer side alone."""
    parts = text.lower().split("x")
    if len(parts) > 2:
        raise wrong(f"WIDTHxHEIGHT or one number is needed, not {text!r}")
    pixels = [count(1, 32768)(part) for part in parts]
    return pixels[0] if len(pixels) == 1 else (pixels[0], pixels[1])


def paint(text: str) -> Tuple[float, float, float, float]:
    """#rrggbb, #rrggbbaa, or numbers in [0, 1] with commas between them."""
    try:
        return color("colour", tuple(number(part) for part in text.split(",")) if "," in text else text)
    except ValueError as error:
        raise wrong(str(error)) from None


def layers(text: str) -> Tuple[str, ...]:
    """Kinds of layers that can be made without a function."""
    names = tuple(name for name in text.split(",") if name)
    for name in names:
        if name not in MADE:
            raise wrong(f"there is no layer {name!r}; there are {', '.join(MADE)}")
    return names


def one_of(what: str, known: Any, several: bool = True) -> Callable[[str], Tuple[str, ...]]:
    """Names with commas between them, each once."""

    def parse(text: str) -> Tuple[str, ...]:
        names = tuple(dict.fromkeys(text.split(",")))
        for name in names:
            if name not in known:
                raise wrong(f"there is no {what} {name!r}; there are {', '.join(known)}")
        return names

    return parse


styles = one_of("style", PRESETS)


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


def lines(text: str) -> str:
    """Kinds of lines with commas between them, such as contour,suggestive,section=z:20,isophotes=0.3:0.6; or none."""
    for part in () if text == "none" else text.split(","):
        name, _, value = part.partition("=")
        kind = name.replace("-", "_")
        if kind not in (*LINES, *_ALSO_LINES) and (kind not in LINE_KINDS or kind == "own"):
            raise wrong(f"there are no lines {name!r}; there are {', '.join(LINES)} and none")
        if value and not (re.fullmatch(r"[xyz]:0*[1-9]\d*", value) if kind.startswith("section") else
                          kind.startswith("isophote") and _are_numbers(value.split(":"))):  # fmt: skip
            raise wrong(f"{part!r} is not understood: write section=z:20 or isophotes=0.3:0.6")
    return text


def _are_numbers(texts: List[str]) -> bool:
    try:
        return all(math.isfinite(float(text)) for text in texts)
    except ValueError:
        return False


# ---- Fields of a source

FIELD_USES = ("tone", "density", "width", "ink", "mask", "direction")
MOST_INKS = 8


def fields(text: str) -> str:
    """Uses of fields, as USE=NAME with commas between.  An empty NAME ends a use."""
    for part in text.split(","):
        use, equals, _ = part.partition("=")
        if not equals or use not in FIELD_USES:
            raise wrong(f"{part!r} must be USE=NAME, such as tone=quality; USE is one of {', '.join(FIELD_USES)}")
    return text


def palette(text: str) -> str:
    """Colours of inks, with commas between."""
    inks = text.split(",")
    if len(inks) > MOST_INKS:
        raise wrong(f"a palette has at most {MOST_INKS} inks, not {len(inks)}")
    for ink in inks:
        if not re.fullmatch(r"#(?:[0-9a-fA-F]{2}){3,4}", ink):
            raise wrong(f"colours such as #203040 with commas between are needed, not {ink!r}")
    return text


# ---- Fields of a style


def assignment(text: str) -> Tuple[str, str]:
    """FIELD=VALUE or LAYER.FIELD=VALUE, as the path of a change and its value."""
    name, equals, value = text.partition("=")
    layer, _, field = name.rpartition(".")
    if not equals or (layer and layer not in (*LAYER_KINDS, "ground")):
        raise wrong(f"FIELD=VALUE or LAYER.FIELD=VALUE is needed, not {text!r}")
    fields = tuple(one for one in (LayerStyle.fields() if layer else Style.fields()) if one != "kind")
    if field not in fields:
        raise wrong(f"there is no field {name!r}; there are {', '.join(fields)}")
    owner: Union[Style, LayerStyle] = LayerStyle() if layer else Style()
    try:
        _set(owner, field, value)
    except ValueError as error:
        raise wrong(str(error)) from None
    return f"style.{name}", value


def _set(owner: Union[Style, LayerStyle], field: str, text: str) -> None:
    """Set a field from text, by the type of its present value.  An error names the allowed values."""
    present = getattr(owner, field)
    if isinstance(present, bool):
        if text.lower() not in ("0", "1", "true", "false"):
            raise ValueError(f"{field} must be true or false, not {text!r}")
    elif isinstance(present, (int, float)):
        setattr(owner, field, type(present)(number(text)))
    elif field == "directions":
        setattr(owner, field, text.split(","))
    elif field in ("light", "ambient_up"):
        setattr(owner, field, direction(text))
    else:
        setattr(owner, field, paint(text) if isinstance(present, tuple) else text)


# ---- Readers


def classes(text: str) -> Tuple[int, ...]:
    """Classes of points, with commas between; () for all."""
    found = () if text == "all" else tuple(count(0, 255)(part) for part in text.split(","))
    return tuple(dict.fromkeys(found))


# ---- Pages


def page(text: str) -> str:
    """A paper's name, or WIDTHxHEIGHT in millimetres."""
    width, _, height = text.lower().partition("x")
    try:
        sides = float(width), float(height)
    except ValueError:
        sides = 0.0, 0.0
    if text.lower() not in PAPERS and not (0 < sides[0] < 1e6 and 0 < sides[1] < 1e6):
        names = ", ".join(PAPERS)
        raise wrong(f"must be one of {names}, or WIDTHxHEIGHT in mm, such as 210x297, not {text!r}")
    return text.lower()


def pens(text: str) -> List[Pen]:
    """GROUP=COLOUR[:WIDTH[:TYPE]] with commas between them.  A colour or a width that is left out is as drawn."""
    found = []
    for i, part in enumerate(filter(None, text.split(","))):
        groups, equals, rest = part.partition("=")
        ink, width, kind, *more = [*rest.split(":"), "", "", ""]
        if not equals or not groups or any(more):
            raise wrong(
                f"{part!r} must be GROUP=COLOUR:WIDTH or GROUP=COLOUR:WIDTH:TYPE, such as contour=#000000:0.5 or "
                "hatch*=:0.3:dashed"
            )
        try:
            line_type = kind or "as_drawn"
            number_of("type", LINE_TYPES, line_type)
            found.append(_records.Pen(groups, _width(width), color("colour", ink) if ink else None, i + 1, line_type))
        except ValueError as error:
            raise wrong(f"{part!r}: {error}") from None
    return found


def _width(text: str) -> float:
    width = number(text) if text else 0.0
    if not 0 <= width < 1e3:
        raise ValueError(f"a width must be from 0 to 1000 mm, not {text}")
    return width


def pen_widths(text: str) -> List[float]:
    """The widths of the available pens, in mm."""
    widths = sorted(number(part) for part in text.split(",") if part)
    if not widths or not 0 < widths[0] <= widths[-1] < 1e3:
        raise wrong(f"widths in mm above 0, with commas between, are needed, not {text!r}")
    return widths


# ---- Parsers for the kinds of the table

_PARSERS: Dict[str, Callable[[str], Any]] = {
    "number": number, "vector": vector, "direction": direction, "up": up, "paint": paint, "size": size, "layers": layers,
    "per_layer": per_layer, "lines": lines, "interval": interval, "edges": edges, "text": str, "file": str,
    "number_or_auto": or_auto(number, "auto"), "assignment": assignment, "ground": ground, "page": page, "pens": pens,
    "pen_widths": pen_widths, "fields": fields, "palette": palette, "lights": lights,
    "classes": classes,
}  # fmt: skip


def parser_of(kind: str) -> Callable[[str], Any]:
    """The parser for a kind of the table, such as "number" or "count 0 6"."""
    name, *bounds = kind.split()
    if name in ("count", "count_or_auto"):
        parse = count(*(int(bound) for bound in bounds))
        return parse if name == "count" else or_auto(parse)
    return _PARSERS[name]
