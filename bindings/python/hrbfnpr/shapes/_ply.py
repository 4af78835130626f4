# SPDX-License-Identifier: MIT
"""Reads PLY: any elements, any types, ASCII and binary, faces as polygons or triangle strips."""
from __future__ import annotations

import struct
from dataclasses import dataclass, field
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np

from ._attributes import PointValues, attributes
from ._polygons import fans, fans_of_block
from ._shape import Floats, Integers, Shape, ShapeError, Vector, strips
from ._sharp_edges import of_vertices
from ._table import Rows, about_count, at, check_indices, numbers, polygons

_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "bool": "u1",
    "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f4": "f", "f8": "d"}  # the codes of `struct`
_FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_LARGEST_INDEX = 2.0**62
_LIST_NAMES = ("vertex_indices", "vertex_index")


@dataclass(frozen=True)
class _Lists:
    """Lists of an ASCII file: runs of `values`, and the line of each."""

    values: Integers
    starts: Integers
    counts: Integers
    lines: Integers

    def __iter__(self) -> Iterator[List[int]]:
        return (self.values[start : start + count].tolist() for start, count in zip(self.starts, self.counts))

    def triangles(self, points: Floats) -> Integers:
        rows = Rows(self.values.astype(float), self.counts, self.lines)
        result, lines = polygons(rows, self.counts, self.starts, self.values, points)
        check_indices(result, lines, len(points))
        return result


@dataclass
class _Element:
    name: str
    count: int
    # Name, type of a number, and type of a list's length (None for a single number).
    properties: List[Tuple[str, str, Optional[str]]] = field(default_factory=list)

    def add(self, name: str, kind: str, length: Optional[str]) -> None:
        """Add a property.  A repeated name is made different from the first one."""
        again = sum(1 for one, _, _ in self.properties if one.split(" ")[0] == name)
        self.properties.append((f"{name} {again}" if again else name, kind, length))

    @property
    def has_lists(self) -> bool:
        return any(length for _, _, length in self.properties)


def read_ply(data: bytes) -> Shape:
    """Read the bytes of a PLY file."""
    order, elements, offset = _header(data)
    first_line = data.count(b"\n", 0, offset) + 1 if b"\n" in data[:offset] else data.count(b"\r", 0, offset) + 1
    reader: Union[_Ascii, _Binary] = _Ascii(data[offset:], first_line) if order == "" else _Binary(data, offset, order)
    columns: Dict[str, Dict[str, Any]] = {}
    notes: Tuple[str, ...] = ()
    last = [element for element in elements if element.count > 0][-1:]
    for element in elements:
        if [element] == last and element.name == "vertex" and not element.has_lists:  # points: those that are there are read
            there = min(element.count, reader.there(element))
            if there > 0:
                notes, element.count = about_count(element.count, there), there
        columns[element.name] = reader.read(element)
    vertex = columns.get("vertex")
    if vertex is None or not all(axis in vertex for axis in "xyz"):
        raise ShapeError("the PLY file has no vertices with x, y and z")
    normals = None
    if all(name in vertex for name in ("nx", "ny", "nz")):
        normals = np.column_stack([vertex[name] for name in ("nx", "ny", "nz")]).astype(np.float64)
    points = np.column_stack([vertex[axis] for axis in "xyz"]).astype(np.float64)
    names = next(tuple(name for name, _, _ in one.properties) for one in elements if one.name == "vertex")
    form = {"": "ascii", "<": "binary, little-endian", ">": "binary, big-endian"}[order]
    seen_from = _scanner(points) if "range_grid" in columns else None
    triangles = _triangles(columns, points)
    sharp = None if triangles is None or normals is None else of_vertices(points, triangles, normals)
    return Shape(points, normals, triangles, f"PLY, {form}", names, viewpoint=seen_from, sharp_edges=sharp,
                 notes=notes, fields=_values_of(vertex, len(points)))  # fmt: skip


def _values_of(vertex: Dict[str, Any], count: int) -> Dict[str, PointValues]:
    """The single numbers of the vertices, which are all properties but lists."""
    return attributes({name: column for name, column in vertex.items() if np.shape(column) == (count,)})


def _scanner(points: Floats) -> Optional[Vector]:
    """The place of the scanner, far away, for a single range image of a Cyberware scanner, whose rays go along -z."""
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) == 0:
        return None
    middle, far = finite.mean(axis=0), 1000 * float(np.linalg.norm(np.ptp(finite, axis=0)))
    return float(middle[0]), float(middle[1]), float(middle[2]) + far


def _triangles(columns: Dict[str, Dict[str, Any]], points: Floats) -> Any:
    parts = []
    for name, lists in columns.items():
        indices = next((lists[key] for key in _LIST_NAMES if key in lists), None)
        if indices is None:
            continue
        if name == "tristrips":
            parts += [strips([int(i) for i in strip]) for strip in indices]
        elif name == "face" and isinstance(indices, _Lists):
            parts.append(indices.triangles(points))
        elif name == "face":
            is_block = isinstance(indices, np.ndarray)
            parts.append(fans_of_block(indices, points).reshape(-1, 3) if is_block else fans(indices, points))
    return np.concatenate(parts) if parts else None


def _header(data: bytes) -> Tuple[str, List[_Element], int]:
    """The byte order ("" for ASCII), the elements, and the place where the data begins."""
    start = data.find(b"end_header")
    if not data.startswith(b"ply"):
        raise ShapeError("not a PLY file: it does not begin with ply" + ("" if data else ", it is empty"))
    if start < 0:
        raise ShapeError("not a PLY file, or its header is cut short: there is no end_header")
    end = start + len(b"end_header")
    if data[end : end + 2] == b"\r\n":
        end += 1
    elements: List[_Element] = []
    order = None
    for number, line in enumerate(data[:start].decode("latin-1").splitlines(), 1):
        words = line.split()
        try:
            if words[:1] == ["format"]:
                order = _FORMATS[words[1]]
            elif words[:1] == ["element"]:
                elements.append(_Element(words[1], int(words[2])))
            elif words[:2] == ["property", "list"]:
                if _TYPES[words[2]][0] == "f":
                    raise at(number, 0, f"the PLY header has lists whose length is a {words[2]}, not a whole number")
                elements[-1].add(words[4], _TYPES[words[3]], _TYPES[words[2]])
            elif words[:1] == ["property"]:
                elements[-1].add(words[2], _TYPES[words[1]], None)
        except ShapeError:
            raise
        except (KeyError, IndexError, ValueError):
            raise at(number, 0, f"the PLY header is not valid: {line.strip()[:80]!r}") from None
    if order is None:
        raise ShapeError("the PLY header has no format line")
    if any(element.count < 0 for element in elements):
        raise ShapeError("the PLY header has a negative count")
    # An element without properties takes no bytes and no words, whatever its count is.
    return order, [element for element in elements if element.properties], end + 1


def _cut_short(element: _Element, found: Optional[int] = None) -> ShapeError:
    there = "" if found is None else f", after {max(found, 0)} of them"
    return ShapeError(f"the PLY file ends in the middle of its {element.count} elements {element.name!r}{there}")


class _Ascii:
    """Reads elements that are runs of numbers, one element on each line."""

    def __init__(self, data: bytes, first_line: int) -> None:
        text = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        self._rows = numbers(text, first_line)
        self._starts = self._rows.starts
        self._next = 0

    def there(self, element: _Element) -> int:
        """The number of whole rows that are left, if all are as wide as the element."""
        left = self._rows.counts[self._next :]
        return len(left) - int(len(left) > 0 and left[-1] < len(element.properties))

    def read(self, element: _Element) -> Dict[str, Any]:
        first, last = self._next, self._next + element.count
        self._next = last
        if element.count == 0:
            return {name: [] for name, _, _ in element.properties}
        if len(self._rows.counts) < last:
            raise _cut_short(element, len(self._rows.counts) - first)
        lists = [i for i, (_, _, length) in enumerate(element.properties) if length]
        if not lists:
            return self._numbers(element, first, last)
        if len(lists) == 1:
            return self._one_list(element, lists[0], first, last)
        return self._lists(element, first, last)

    def _wrong(self, element: _Element, row: int, expected: int) -> ShapeError:
        line, found = int(self._rows.lines[row]), int(self._rows.counts[row])
        return at(line, 0, f"element {element.name!r} is not as declared: {found} numbers instead of {expected}")

    def _numbers(self, element: _Element, first: int, last: int) -> Dict[str, Any]:
        counts, width = self._rows.counts[first:last], len(element.properties)
        wrong = np.flatnonzero(counts != width)
        if len(wrong):
            raise self._wrong(element, first + int(wrong[0]), width)
        start = self._starts[first]
        table = self._rows.values[start : start + width * element.count].reshape(element.count, width)
        return {name: table[:, i] for i, (name, _, _) in enumerate(element.properties)}

    def _one_list(self, element: _Element, place: int, first: int, last: int) -> Dict[str, Any]:
        """Read the usual faces: one list, with single numbers before and after it."""
        values, starts, counts = self._rows.values, self._starts[first:last], self._rows.counts[first:last]
        behind = len(element.properties) - place - 1
        sizes = np.zeros(len(counts))
        long_enough = counts > place
        sizes[long_enough] = np.nan_to_num(values[starts[long_enough] + place], nan=-1.0)
        wrong = np.flatnonzero((place + 1 + sizes + behind != counts) | (sizes < 0))
        if len(wrong):
            i = int(wrong[0])
            raise self._wrong(element, first + i, int(place + 1 + max(sizes[i], 0) + behind))
        whole = sizes.astype(np.int64)
        columns: Dict[str, Any] = {}
        for i, (name, _, _) in enumerate(element.properties):
            if i == place:
                lists = _Lists(values.astype(np.int64), starts + place + 1, whole, self._rows.lines[first:last])
                columns[name] = lists
            else:
                columns[name] = values[starts + i if i < place else starts + whole + i]
        return columns

    def _lists(self, element: _Element, first: int, last: int) -> Dict[str, Any]:
        columns: Dict[str, Any] = {name: [] for name, _, _ in element.properties}
        for row in range(first, last):
            start, count = int(self._starts[row]), int(self._rows.counts[row])
            words = self._rows.values[start : start + count]
            whole = np.clip(np.nan_to_num(words, nan=-1.0), -1.0, 2.0**62).astype(np.int64)
            place = 0
            for name, _, length in element.properties:
                size = int(whole[place]) if length and place < count else 1
                place += 1 if length else 0
                if size < 0 or count < place + size:
                    raise self._wrong(element, row, place + max(size, 1))
                columns[name].append(whole[place : place + size].tolist() if length else float(words[place]))
                place += size
        return columns


class _Binary:
    """Reads elements that are packed structs.  Lists carry their length."""

    def __init__(self, data: bytes, offset: int, order: str) -> None:
        self._data, self._at, self._order = data, offset, order

    def _take(self, dtype: Any, count: int, element: _Element) -> Any:
        if count * dtype.itemsize > len(self._data) - self._at:
            raise _cut_short(element)
        values = np.frombuffer(self._data, dtype, count, self._at)
        self._at += count * dtype.itemsize
        return values

    def there(self, element: _Element) -> int:
        """The number of elements without lists for which bytes are left."""
        return (len(self._data) - self._at) // int(self._dtype(element, []).itemsize)

    def _dtype(self, element: _Element, lengths: List[int]) -> Any:
        """The type of an element whose lists have these lengths."""
        fields: List[Any] = []
        remaining = list(lengths)
        for name, kind, length in element.properties:
            if length:
                fields.append((f"{name} count", self._order + length))
                fields.append((name, self._order + kind, (remaining.pop(0),)))
            else:
                fields.append((name, self._order + kind))
        return np.dtype(fields)

    def read(self, element: _Element) -> Dict[str, Any]:
        if element.count == 0:
            return {name: [] for name, _, _ in element.properties}
        if not element.has_lists:
            table = self._take(self._dtype(element, []), element.count, element)
            return {name: table[name] for name, _, _ in element.properties}
        return self._uniform(element) or self._varying(element)

    def _uniform(self, element: _Element) -> Optional[Dict[str, Any]]:
        """Read the usual case quickly: all lists have the lengths of the first ones."""
        start = self._at
        first = self._element(element)
        self._at = start
        lists = [name for name, _, length in element.properties if length]
        lengths = [len(first[name]) for name in lists]
        dtype = self._dtype(element, lengths)
        if element.count * dtype.itemsize > len(self._data) - start:
            return None
        table = self._take(dtype, element.count, element)
        if any((table[f"{name} count"] != length).any() for name, length in zip(lists, lengths)):
            self._at = start
            return None
        return {name: table[name] for name, _, _ in element.properties}

    def _element(self, element: _Element) -> Dict[str, Any]:
        values: Dict[str, Any] = {}
        for name, kind, length in element.properties:
            count = int(self._unpack(length, 1, element)[0]) if length else 1
            if count < 0:
                raise ShapeError(f"the PLY file has a list of {count} numbers")
            numbers = self._unpack(kind, count, element)
            if length and not all(abs(number) < _LARGEST_INDEX for number in numbers):  # false for NaN, too
                raise ShapeError(f"the PLY file has a list {name!r} with something that is not a number, or too large")
            values[name] = [int(n) for n in numbers] if length else numbers[0]
        return values

    def _unpack(self, kind: str, count: int, element: _Element) -> Tuple[Any, ...]:
        size = int(kind[1]) * count
        if size > len(self._data) - self._at:
            raise _cut_short(element)
        numbers = struct.unpack_from(f"{self._order}{count}{_CODES[kind]}", self._data, self._at)
        self._at += size
        return numbers

    def _varying(self, element: _Element) -> Dict[str, Any]:
        columns: Dict[str, Any] = {name: [] for name, _, _ in element.properties}
        for _ in range(element.count):
            for name, value in self._element(element).items():
                columns[name].append(value)
        return columns
