# SPDX-License-Identifier: MIT
"""Reads STL, text and binary: triangles that do not share their corners."""
from __future__ import annotations

import re

import numpy as np

from ._shape import Shape, ShapeError, Vector
from ._table import at, is_number, number_at, plain, without_comments

UP: Vector = (0.0, 0.0, 1.0)  # the convention of printers and workshops
_HEADER = 84  # size of a binary file's header, in bytes
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_LOOKED_AT = 4096  # number of bytes in which a text must begin, after comments
_BEGINS = re.compile(rb"(\s*#[^\r\n]*[\r\n])*\s*solid", re.I)
_VERTEX = re.compile(rb"^[ \t]*vertex[ \t]+(\S+)[ \t]+(\S+)[ \t]+(\S+)[ \t]*$", re.M | re.I)


def is_binary(data: bytes) -> bool:
    """Whether the file has the length that the count in a binary header gives."""
    return len(data) >= _HEADER and len(data) == _HEADER + _TRIANGLE.itemsize * _count(data)


def _count(data: bytes) -> int:
    return int.from_bytes(data[80:84], "little")


def read_stl(data: bytes) -> Shape:
    """Read the bytes of an STL file.  Its normals are not used, because they only repeat those of the faces."""
    if not data:
        raise ShapeError("the file is empty")
    if not is_binary(data) and _BEGINS.match(data[:_LOOKED_AT]) and b"\0" not in data[:512]:
        return _text(data)
    return _binary(data)


def _binary(data: bytes) -> Shape:
    if len(data) < _HEADER:
        raise ShapeError("not an STL file: it is too short to be a binary one, and does not begin with solid")
    count, there = _count(data), (len(data) - _HEADER) // _TRIANGLE.itemsize
    if there < count:
        raise ShapeError(f"the STL file ends in the middle of its {count} triangles, after {there} of them")
    if count == 0:
        raise ShapeError("the STL file has no triangles")
    corners = np.frombuffer(data, _TRIANGLE, count, _HEADER)["corners"].reshape(-1, 3).astype(np.float64)
    return Shape(corners, None, np.arange(len(corners)).reshape(-1, 3), "STL, binary", ("x", "y", "z"), UP)


def _text(data: bytes) -> Shape:
    text = without_comments(plain(data))
    words = [word for vertex in _VERTEX.findall(text) for word in vertex]
    count = len(re.findall(rb"\bvertex\b", text, re.I))
    if 3 * count != len(words) or count % 3 or not all(is_number(word) for word in words):
        _say_what_is_wrong(text, count)
    if count == 0:
        raise ShapeError("the STL file has no triangles")
    if b"endsolid" not in text.lower():
        raise ShapeError(f"the STL file ends in the middle, after {count // 3} triangles: there is no endsolid")
    corners = np.array(words, dtype=np.float64).reshape(-1, 3)
    return Shape(corners, None, np.arange(count).reshape(-1, 3), "STL, ascii", ("x", "y", "z"), UP)


def _say_what_is_wrong(text: bytes, count: int) -> None:
    corners = 0
    for number, line in enumerate(text.split(b"\n"), 1):
        words = line.split()
        first = words[0].lower() if words else b""
        if first == b"vertex":
            corners += 1
            for column, word in enumerate(words[1:], 2):
                number_at(word, number, column)
            if len(words) != 4:
                raise at(number, 0, f"a vertex needs 3 numbers, and there are {len(words) - 1}")
        if first == b"endloop":
            if corners != 3:
                raise at(number, 0, f"a facet has {corners} corners; STL has triangles only")
            corners = 0
    raise ShapeError(f"the STL file ends in the middle of a facet, after {count // 3} triangles")
