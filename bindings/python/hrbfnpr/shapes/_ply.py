# SPDX-License-Identifier: MIT
"""PLY: any elements, any types, ASCII and binary, faces as polygons or triangle strips."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from ._shape import Shape, ShapeError, fans, fans_of_block, strips

_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1",
    "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
_FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_LIST_NAMES = ("vertex_indices", "vertex_index")


@dataclass
class _Element:
    name: str
    count: int
    # Name, type of a number, type of a list's length (None: not a list).
    properties: List[Tuple[str, str, Optional[str]]] = field(default_factory=list)

    @property
    def has_lists(self) -> bool:
        return any(length for _, _, length in self.properties)


def read_ply(data: bytes) -> Shape:
    """Read the bytes of a PLY file."""
    order, elements, offset = _header(data)
    reader: Union[_Ascii, _Binary] = _Ascii(data[offset:]) if order == "" else _Binary(data, offset, order)
    columns: Dict[str, Dict[str, Any]] = {}
    for element in elements:
        columns[element.name] = reader.read(element)
    vertex = columns.get("vertex")
    if vertex is None or not all(axis in vertex for axis in "xyz"):
        raise ShapeError("the PLY file has no vertices with x, y and z")
    normals = None
    if all(name in vertex for name in ("nx", "ny", "nz")):
        normals = np.column_stack([vertex[name] for name in ("nx", "ny", "nz")]).astype(np.float64)
    points = np.column_stack([vertex[axis] for axis in "xyz"]).astype(np.float64)
    return Shape(points, normals, _triangles(columns))


def _triangles(columns: Dict[str, Dict[str, Any]]) -> Any:
    parts = []
    for name, lists in columns.items():
        indices = next((lists[key] for key in _LIST_NAMES if key in lists), None)
        if indices is None:
            continue
        if name == "tristrips":
            parts += [strips([int(i) for i in strip]) for strip in indices]
        elif name == "face":
            parts.append(fans_of_block(indices) if isinstance(indices, np.ndarray) else fans(indices))
    return np.concatenate(parts) if parts else None


def _header(data: bytes) -> Tuple[str, List[_Element], int]:
    """Byte order ("" for ASCII), elements, and where the data starts."""
    start = data.find(b"end_header")
    if not data.startswith(b"ply") or start < 0:
        raise ShapeError("not a PLY file, or its header is cut short")
    end = start + len(b"end_header")
    if data[end : end + 2] == b"\r\n":
        end += 1
    elements: List[_Element] = []
    order = None
    for line in data[:start].decode("latin-1").splitlines():
        words = line.split()
        try:
            if words[:1] == ["format"]:
                order = _FORMATS[words[1]]
            elif words[:1] == ["element"]:
                elements.append(_Element(words[1], int(words[2])))
            elif words[:2] == ["property", "list"]:
                elements[-1].properties.append((words[4], _TYPES[words[3]], _TYPES[words[2]]))
            elif words[:1] == ["property"]:
                elements[-1].properties.append((words[2], _TYPES[words[1]], None))
        except (KeyError, IndexError, ValueError):
            raise ShapeError(f"the PLY header has a line that cannot be understood: {line.strip()!r}") from None
    if order is None:
        raise ShapeError("the PLY header has no format line")
    if any(element.count < 0 for element in elements):
        raise ShapeError("the PLY header has a negative count")
    return order, elements, end + 1


def _cut_short(element: _Element) -> ShapeError:
    return ShapeError(f"the PLY file ends in the middle of its {element.count} elements {element.name!r}")


class _Ascii:
    """Elements are runs of numbers, one element a line."""

    def __init__(self, data: bytes) -> None:
        self._lines = [line for line in data.decode("latin-1").splitlines() if line.strip()]
        self._next = 0

    def read(self, element: _Element) -> Dict[str, Any]:
        lines = self._lines[self._next : self._next + element.count]
        self._next += element.count
        if element.count == 0:
            return {name: [] for name, _, _ in element.properties}
        if len(lines) < element.count:
            raise _cut_short(element)
        try:
            return self._lists(element, lines) if element.has_lists else self._numbers(element, lines)
        except (ValueError, IndexError):
            raise ShapeError(f"the PLY file has a line of element {element.name!r} that is not as declared") from None

    @staticmethod
    def _numbers(element: _Element, lines: List[str]) -> Dict[str, Any]:
        values = np.array(" ".join(lines).split(), dtype=np.float64)
        table = values.reshape(element.count, -1)
        if table.shape[1] != len(element.properties):
            raise ValueError
        return {name: table[:, i] for i, (name, _, _) in enumerate(element.properties)}

    @staticmethod
    def _lists(element: _Element, lines: List[str]) -> Dict[str, Any]:
        columns: Dict[str, Any] = {name: [] for name, _, _ in element.properties}
        for line in lines:
            words = line.split()
            at = 0
            for name, _, length in element.properties:
                count = int(words[at]) if length else 1
                at += 1 if length else 0
                if len(words) < at + count:
                    raise ValueError
                numbers = words[at : at + count]
                columns[name].append([int(n) for n in numbers] if length else float(numbers[0]))
                at += count
        return columns


class _Binary:
    """Elements are packed structs; lists carry their length."""

    def __init__(self, data: bytes, offset: int, order: str) -> None:
        self._data, self._at, self._order = data, offset, order

    def _take(self, dtype: Any, count: int, element: _Element) -> Any:
        if count * dtype.itemsize > len(self._data) - self._at:
            raise _cut_short(element)
        values = np.frombuffer(self._data, dtype, count, self._at)
        self._at += count * dtype.itemsize
        return values

    def _dtype(self, element: _Element, lengths: List[int]) -> Any:
        """Of an element whose lists have these lengths."""
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
        """The usual case, quickly: all lists are as long as the first ones."""
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
            count = int(self._take(np.dtype(self._order + length), 1, element)[0]) if length else 1
            if count < 0:
                raise ShapeError(f"the PLY file has a list of {count} numbers")
            numbers = self._take(np.dtype(self._order + kind), count, element)
            values[name] = [int(n) for n in numbers] if length else numbers[0]
        return values

    def _varying(self, element: _Element) -> Dict[str, Any]:
        columns: Dict[str, Any] = {name: [] for name, _, _ in element.properties}
        for _ in range(element.count):
            for name, value in self._element(element).items():
                columns[name].append(value)
        return columns
