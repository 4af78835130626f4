# SPDX-License-Identifier: MIT
"""Reads the text form of Universal Scene Description (.usda): meshes at their places, at the first time.

Compressed forms (.usdc, .usdz), and parts that a file takes from other files, are not read.
"""
from __future__ import annotations

import re
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._attributes import COLOUR, PointValues, joined
from ._polygons import fans
from ._shape import Floats, Integers, Shape, ShapeError, Vector
from ._table import at

MAGIC = rb"#usda "
_WORD = re.compile(
    r'\s+|\#[^\n]*|"""(?:[^\\]|\\.)*?"""|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|@+[^@\n]*@+|<[^>\n]*>'
    r"|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w])|[-+]?(?:inf|nan)\b|[A-Za-z_][\w:.]*(?:\[\])?|[-+]?[A-Za-z_]\w*|[()\[\]{}=,;:&]",
    re.S,
)
_NUMBERS = re.compile(r"[\[(][-+.\deE\s,()]*(?:(?:nan|inf)[-+.\deE\s,()]*)*\]")
_DEEPEST = 200  # largest depth of prims inside prims
_MOST_PLACED = 100_000  # largest number of placed meshes
_OTHERS = ("Sphere", "Cube", "Cylinder", "Cone", "Capsule", "Points", "BasisCurves", "NurbsPatch", "Plane")
_SHARP = 1.0  # creases of at least this sharpness are sharp edges
_UNITS = {1.0: "metres", 0.01: "centimetres", 0.001: "millimetres"}
_AXES = {"X": 0, "Y": 1, "Z": 2}


class _Prim(NamedTuple):
    kind: str  # "def", "over" or "class"
    type: str
    name: str
    facts: Dict[str, Any]  # what stands in parentheses after the name
    values: Dict[str, Any]
    parts: List["_Prim"]


def read_usda(data: bytes) -> Shape:
    """Read the bytes of a file."""
    text = data.decode("utf-8", errors="replace")
    if not text.startswith("#usda "):
        raise ShapeError("not a .usda file: its first line must begin with #usda; Blender exports other forms of USD as glTF")
    words = _Words(text)
    facts = words.facts() if words.next_is("(") else {}
    prims: List[_Prim] = []
    while words.word is not None:
        prims.append(words.prim(0))
    return _Scene(facts).shape(prims)


class _Words:
    """The words of a text.  `word` is the present one; None at the end."""

    def __init__(self, text: str) -> None:
        self._text, self._at, self._next = text, 0, 0
        self.word: Optional[str] = None
        self.step()

    def step(self) -> Optional[str]:
        """Go to the next word.  Returns the word before."""
        before, self.word = self.word, None
        while self._next < len(self._text):
            found = _WORD.match(self._text, self._next)
            if found is None:
                self._at = self._next
                raise self.wrong(f"{self._text[self._next]!r} cannot stand here")
            self._at, self._next = self._next, found.end()
            if not found[0].isspace() and not found[0].startswith("#"):
                self.word = found[0]
                return before
        self._at = len(self._text)
        return before

    def wrong(self, what: str) -> ShapeError:
        return at(self._text.count("\n", 0, self._at) + 1, 0, f"{what}; the file may be damaged or cut short")

    def next_is(self, word: str) -> bool:
        return self.word == word

    def take(self, word: str) -> None:
        if self.word != word:
            raise self.wrong(f"{word!r} is missing" + (f" before {self.word[:30]!r}" if self.word else " at the end"))
        self.step()

    def name(self) -> str:
        word = self.step()
        if word is None:
            raise self.wrong("the file ends within a part")
        return word

    def facts(self) -> Dict[str, Any]:
        """Assignments in parentheses."""
        found: Dict[str, Any] = {}
        self.take("(")
        while not self.next_is(")"):
            name = self.name()
            if name in ("prepend", "append", "add", "delete", "reorder"):
                name = self.name()
            if self.next_is("="):
                self.step()
                found[name] = self.value(0)
            if self.next_is(";") or self.next_is(","):
                self.step()
        self.step()
        return found

    def value(self, depth: int) -> Any:
        """A number, a text, a list, or a dictionary.  Lists of numbers alone are arrays."""
        if depth > _DEEPEST:
            raise self.wrong("lists are nested too deep")
        word = self.word
        if word is None:
            raise self.wrong("a value is missing at the end")
        if word == "[":
            found = _NUMBERS.match(self._text, self._at)
            if found is not None:
                self._next = found.end()
                self.step()
                return self._array(found[0])
        if word in ("[", "("):
            return self._list("]" if word == "[" else ")", depth)
        if word == "{":
            return self._dictionary(depth)
        self.step()
        if word[0] in "\"'":
            return word[3:-3] if word.startswith('"""') else word[1:-1]
        if word[0] == "@" and self.word is not None and self.word[0] == "<":  # a part of another file
            self.step()
        try:
            return float(word)
        except ValueError:
            return word

    def _array(self, text: str) -> Floats:
        width = text[: text.find(")")].count(",") + 1 if "(" in text else 1
        try:
            numbers = np.array(re.sub(r"[\[\](),]", " ", text).split(), dtype=np.float64)
        except ValueError:
            raise self.wrong("a list holds a word that is not a number") from None
        if len(numbers) % width:
            raise self.wrong(f"a list has {len(numbers)} numbers, which are no groups of {width}")
        return numbers.reshape(-1, width) if "(" in text else numbers

    def _list(self, end: str, depth: int) -> List[Any]:
        self.step()
        found = []
        while not self.next_is(end):
            found.append(self.value(depth + 1))
            if self.next_is("("):  # what stands in parentheses after a reference
                self.facts()
            if self.next_is(","):
                self.step()
        self.step()
        return found

    def _dictionary(self, depth: int) -> Dict[str, Any]:
        """Values by name, or by time: ``type name = value`` or ``0: value``."""
        self.step()
        found: Dict[str, Any] = {}
        while not self.next_is("}"):
            name = self.name()
            while not self.next_is("=") and not self.next_is(":"):
                name = self.name()
            self.step()
            found[name] = self.value(depth + 1)
            if self.next_is(",") or self.next_is(";"):
                self.step()
        self.step()
        return found

    def prim(self, depth: int) -> _Prim:
        kind = self.name()
        if kind not in ("def", "over", "class"):
            raise self.wrong(f"a part begins with def, over or class, not with {kind[:30]!r}")
        if depth > _DEEPEST:
            raise self.wrong("parts are nested too deep")
        type_ = "" if self.word is not None and self.word[0] in "\"'" else self.name()
        made = _Prim(kind, type_, self.name().strip("\"'"), self.facts() if self.next_is("(") else {}, {}, [])
        self.take("{")
        self._inside(made, depth)
        return made

    def _inside(self, prim: _Prim, depth: int) -> None:
        """The values and the parts of a prim, up to the brace at its end."""
        while not self.next_is("}"):
            if self.next_is(";"):
                self.step()
            elif self.word in ("def", "over", "class"):
                prim.parts.append(self.prim(depth + 1))
            elif self.word == "variantSet":
                self._variants(prim, depth)
            else:
                self._property(prim.values)
        self.step()

    def _variants(self, prim: _Prim, depth: int) -> None:
        """The variant that the prim chooses becomes a part of it; others are left out."""
        self.step()
        of = self.name().strip("\"'")
        self.take("=")
        self.take("{")
        chosen = prim.facts.get("variants", {})
        chosen = chosen.get(of) if isinstance(chosen, dict) else None
        while not self.next_is("}"):
            name = self.name().strip("\"'")
            facts = self.facts() if self.next_is("(") else {}
            self.take("{")
            used = chosen is None or name == chosen
            chosen = name if chosen is None else chosen
            self._inside(prim if used else _Prim("over", "", name, facts, {}, []), depth + 1)
        self.step()

    def _property(self, values: Dict[str, Any]) -> None:
        words = [self.name()]
        while not self.next_is("=") and self.word not in ("}", "(", ";", None):
            if words[-1] != "reorder" and len(words) > 1 and self._starts_line():
                break  # a property without a value
            words.append(self.name())
        value: Any = None
        if self.next_is("="):
            self.step()
            value = self.value(0)
            name, _, last = words[-1].rpartition(".")
            if last == "timeSamples" and isinstance(value, dict):
                if value and name not in values:
                    values[name] = next(iter(value.values()))
            elif last != "connect":
                values[words[-1]] = value
        if self.next_is("("):
            facts = self.facts()
            for what in ("interpolation", "elementSize"):
                if what in facts:
                    values[f"{words[-1]}.{what}"] = facts[what]

    def _starts_line(self) -> bool:
        return not self._text[self._text.rfind("\n", 0, self._at) + 1 : self._at].strip()


class _Scene:
    """Gathers the meshes of prims."""

    def __init__(self, facts: Dict[str, Any]) -> None:
        axis = facts.get("upAxis", "Y")
        unit = facts.get("metersPerUnit", 0.01)  # the default of the format
        self._unit = _UNITS.get(unit, f"{unit:g} metres") if isinstance(unit, float) else ""
        self._up = _AXES.get(axis if isinstance(axis, str) else "Y", 1)
        self._points: List[Floats] = []
        self._triangles: List[Integers] = []
        self._sharp: List[Integers] = []
        self._colours: List[Tuple[int, Optional[PointValues]]] = []
        self._count = 0
        self._left_out: Dict[str, int] = {}

    def shape(self, prims: List[_Prim]) -> Shape:
        for prim in prims:
            self._add(prim, np.eye(4), 0)
        if not self._points:
            what = ", ".join(f"{count} {kind}" for kind, count in sorted(self._left_out.items()))
            raise ShapeError("the .usda file has no meshes" + (f"; it has {what}, which are not read" if what else ""))
        up: Vector = tuple(float(i == self._up) for i in range(3))  # type: ignore[assignment]
        notes = tuple(f"{count} {kind} left out" for kind, count in sorted(self._left_out.items()))
        colour = joined(self._colours)
        return Shape(
            np.concatenate(self._points), None, np.concatenate(self._triangles), "USDA", ("x", "y", "z"), up, notes,
            sharp_edges=np.concatenate(self._sharp) if self._sharp else None,
            fields={} if colour is None else {COLOUR: colour}, unit=self._unit,
        )  # fmt: skip

    def _leave_out(self, what: str) -> None:
        self._left_out[what] = self._left_out.get(what, 0) + 1

    def _add(self, prim: _Prim, parent: Floats, depth: int) -> None:
        """Add the meshes of a prim.  Matrices act on row vectors."""
        values = prim.values
        if prim.kind == "class" or prim.facts.get("active") == "false" or values.get("visibility") == "invisible":
            return
        if values.get("purpose") in ("guide", "proxy"):
            return
        for what in ("references", "payload"):
            if what in prim.facts:
                self._leave_out("references to other files or parts")
        if prim.type == "PointInstancer":
            self._leave_out("instancers")
            return
        place = _matrix(prim) if "!resetXformStack!" in str(values.get("xformOpOrder")) else _matrix(prim) @ parent
        if prim.type == "Mesh":
            self._mesh(prim, place)
        elif prim.type in _OTHERS:
            self._leave_out(f"parts of the type {prim.type}")
        for part in prim.parts:
            self._add(part, place, depth + 1)

    def _mesh(self, prim: _Prim, place: Floats) -> None:
        points = _array(prim, "points", 3)
        counts = _array(prim, "faceVertexCounts", 1).astype(np.int64)
        corners = _array(prim, "faceVertexIndices", 1).astype(np.int64)
        if len(self._points) >= _MOST_PLACED:
            raise ShapeError(f"the .usda file has more than {_MOST_PLACED} meshes")
        if not len(points) or not len(counts):
            return
        if counts.min() < 0 or counts.sum() != len(corners):
            raise ShapeError(f"the faces of mesh {prim.name!r} have {counts.sum()} corners, but {len(corners)} are given")
        if len(corners) and not 0 <= int(corners.min()) <= int(corners.max()) < len(points):
            raise ShapeError(f"a face of mesh {prim.name!r} names vertex {corners.max()}, but it has only {len(points)}")
        ends = np.cumsum(counts)
        triangles = fans([corners[end - count : end].tolist() for end, count in zip(ends, counts)], points)
        if (prim.values.get("orientation") == "leftHanded") != (np.linalg.det(place[:3, :3]) < 0.0):
            triangles = triangles[:, ::-1]
        self._points.append(points @ place[:3, :3] + place[3, :3])
        self._triangles.append(triangles + self._count)
        self._add_creases(prim, len(points))
        self._colours.append((len(points), _colour(prim, len(points))))
        self._count += len(points)

    def _add_creases(self, prim: _Prim, count: int) -> None:
        lengths = _array(prim, "creaseLengths", 1).astype(np.int64)
        corners = _array(prim, "creaseIndices", 1).astype(np.int64)
        sharpness = _array(prim, "creaseSharpnesses", 1)
        if not len(lengths) or lengths.min() < 2 or lengths.sum() != len(corners) or corners.min() < 0 or corners.max() >= count:
            return
        ends = np.cumsum(lengths)
        for i, (end, length) in enumerate(zip(ends, lengths)):
            if len(sharpness) != len(lengths) or sharpness[i] >= _SHARP:
                along = corners[end - length : end]
                self._sharp.append(np.column_stack([along[:-1], along[1:]]) + self._count)


def _array(prim: _Prim, name: str, width: int) -> Floats:
    value = prim.values.get(name)
    if value is None or isinstance(value, list) and not value:
        return np.empty((0, width)) if width > 1 else np.empty(0)
    if not isinstance(value, np.ndarray):
        raise ShapeError(f"{name} of mesh {prim.name!r} is not a list of numbers")
    if value.size == 0:
        return np.empty((0, width)) if width > 1 else np.empty(0)
    if (width == 1) != (value.ndim == 1) or width > 1 and value.shape[1] != width:
        raise ShapeError(f"{name} of mesh {prim.name!r} must have {width} numbers for each element")
    return value


def _colour(prim: _Prim, count: int) -> Optional[PointValues]:
    """The displayed colours of the vertices, or of the whole mesh."""
    value = prim.values.get("primvars:displayColor")
    if not isinstance(value, np.ndarray) or value.ndim != 2 or value.shape[1] != 3 or len(value) not in (1, count):
        return None
    linear = np.clip(np.broadcast_to(value, (count, 3)), 0.0, 1.0)
    coded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return PointValues("colour", coded.astype(np.float32))


def _matrix(prim: _Prim) -> Floats:
    """The place of a prim within its parent: the product of its operations, the last of which acts first."""
    order = prim.values.get("xformOpOrder")
    result = np.eye(4)
    for name in reversed(order) if isinstance(order, list) else ():
        if not isinstance(name, str) or name == "!resetXformStack!":
            continue
        inverted, bare = name.startswith("!invert!"), name.replace("!invert!", "")
        one = _operation(bare, prim.values.get(bare), prim.name)
        result = result @ (np.linalg.inv(one) if inverted and abs(np.linalg.det(one)) > 0.0 else one)
    return result


def _operation(name: str, value: Any, prim: str) -> Floats:
    kind = name.split(":")[1] if ":" in name else ""
    result = np.eye(4)
    try:
        given = np.array(value, dtype=np.float64)
        if kind == "transform":
            return given.reshape(4, 4)
        if kind == "translate":
            result[3, :3] = given.reshape(3)
        elif kind == "scale":
            result[:3, :3] = np.diag(given.reshape(3))
        elif kind == "orient":
            w, x, y, z = given.reshape(4) / max(float(np.linalg.norm(given)), 1e-300)
            result[:3, :3] = _turn(np.array([x, y, z]), w).T
        elif kind.startswith("rotate"):
            angles = dict(zip("XYZ", given.reshape(3))) if len(kind) == 9 else {kind[6:]: float(given)}
            for axis in kind[6:]:
                half = np.radians(angles[axis]) / 2
                along = np.eye(3)[_AXES[axis]] * np.sin(half)
                result[:3, :3] = result[:3, :3] @ _turn(along, np.cos(half)).T
        else:
            raise ValueError
    except (ValueError, TypeError, KeyError):
        raise ShapeError(f"the operation {name} of {prim!r} has a value that it cannot have") from None
    return result


def _turn(v: Floats, w: float) -> Floats:
    """The rotation of a unit quaternion, as a matrix that acts on column vectors."""
    x, y, z = v
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


