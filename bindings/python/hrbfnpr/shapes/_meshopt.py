# SPDX-License-Identifier: MIT
"""Unpacks EXT_meshopt_compression [Khronos 2022]: views of glTF buffers, as gltfpack writes them."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from ._shape import ShapeError

_BLOCK = 8192  # largest number of bytes of vertices in a block
_MOST_IN_BLOCK = 256
_GROUP = 16  # number of bytes that are packed with the same width
_TAIL = 32  # least number of bytes after the vertices
_DAMAGED = "a compressed part of the glTF file is damaged"


def unpack(extension: Dict[str, Any], data: bytes) -> bytes:
    """The bytes of a view: its elements one after the other, byteStride apart."""
    count, stride, mode = int(extension["count"]), int(extension["byteStride"]), extension["mode"]
    if not 0 <= count <= 1 << 28 or not 0 < stride <= 256 or not data:
        raise ShapeError(_DAMAGED)
    try:
        if mode == "ATTRIBUTES":
            return _filtered(_attributes(data, count, stride), extension.get("filter", "NONE"))
        if mode in ("TRIANGLES", "INDICES") and stride in (2, 4):
            indices = np.array((_triangles if mode == "TRIANGLES" else _sequence)(data, count), np.int64)
            if len(indices) and not 0 <= indices.min() <= indices.max() < 1 << 8 * stride:
                raise ValueError
            return indices.astype(f"<u{stride}").tobytes()
    except ShapeError:
        raise
    except (IndexError, ValueError, OverflowError):
        raise ShapeError(_DAMAGED) from None
    raise ShapeError(f"a part of the glTF file is compressed in the unknown mode {mode!r} with a stride of {stride} bytes")


# --- attributes --------------------------------------------------------------------------------


def _attributes(data: bytes, count: int, stride: int) -> Any:
    """The bytes of vertices, shape (count, stride).  They are stored as differences from vertex to vertex, column by column."""
    if data[0] != 0xA0 or stride % 4:
        raise ShapeError(f"a part of the glTF file is compressed in the unknown version {data[0] & 15}")
    if count * stride > 64 * len(data):  # a byte of data holds 64 bytes at most
        raise ValueError
    tail = max(stride, _TAIL)
    before = np.frombuffer(data, np.uint8, stride, len(data) - stride)
    result = np.empty((count, stride), np.uint8)
    source, at = np.frombuffer(data, np.uint8, len(data) - tail), 1
    most = min(_BLOCK // stride // _GROUP * _GROUP, _MOST_IN_BLOCK)
    for first in range(0, count, most):
        block = result[first : first + most]
        for k in range(stride):
            differences, at = _bytes(source, at, len(block))
            turned = (differences >> 1) ^ -(differences & 1)
            block[:, k] = (np.cumsum(turned, dtype=np.int64) + int(before[k])) & 0xFF
        before = block[-1]
    return result


def _bytes(source: Any, at: int, count: int) -> Tuple[Any, int]:
    """Unpack `count` bytes.  Groups of 16 have 0, 2, 4 or 8 bits for each byte.

    If all bits are set, the byte is stored after the group.
    """
    groups = -(-count // _GROUP)
    widths = source[at : at + -(-groups // 4)]
    at += len(widths)
    result = np.zeros(groups * _GROUP, np.int64)
    for group in range(groups):
        width = (int(widths[group // 4]) >> (group % 4 * 2)) & 3
        if width == 0:
            continue
        into = result[group * _GROUP : (group + 1) * _GROUP]
        size = (0, 4, 8, 16)[width]
        packed = source[at : at + size]
        at += size
        if width == 3:
            into[:] = packed
            continue
        shifts, largest = ((6, 4, 2, 0), 3) if width == 1 else ((4, 0), 15)
        into[:] = ((packed[:, None] >> np.array(shifts, np.uint8)) & largest).reshape(-1)
        behind = np.flatnonzero(into == largest)
        into[behind] = source[at : at + len(behind)]
        at += len(behind)
    return result[:count], at


def _filtered(elements: Any, name: str) -> bytes:
    if name == "EXPONENTIAL":  # 24 bits of mantissa and 8 bits of exponent
        words = np.ascontiguousarray(elements).view("<i4")
        return np.ldexp(((words << 8) >> 8).astype(np.float64), words >> 24).astype("<f4").tobytes()
    return bytes(elements.tobytes())  # the filters of normals and rotations are not needed


# --- indices -----------------------------------------------------------------------------------


class _Source:
    """Bytes that are read one after the other."""

    def __init__(self, data: bytes, at: int) -> None:
        self._data, self._at = data, at

    def byte(self) -> int:
        self._at += 1
        return self._data[self._at - 1]

    def number(self) -> int:
        """A number with 7 bits in each byte, the lowest first."""
        result = shift = 0
        while True:
            byte = self.byte()
            result |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80 or shift > 28:
                return result

    def difference(self) -> int:
        number = self.number()
        return (number >> 1) ^ -(number & 1)


class _Recent:
    """The last 16 items of a sequence."""

    def __init__(self, none: Any) -> None:
        self._items, self._next = [none] * 16, 0

    def __getitem__(self, back: int) -> Any:
        return self._items[(self._next - 1 - back) & 15]

    def push(self, item: Any) -> None:
        self._items[self._next] = item
        self._next = (self._next + 1) & 15


class _Triangles:
    """Unpacks triangles.  A corner is new, one of the last 16, or given by a difference.  An edge may be one of the last 16."""

    def __init__(self, data: bytes, count: int) -> None:
        version = data[0] & 15
        if data[0] & 0xF0 != 0xE0 or version > 1:
            raise ShapeError(f"a part of the glTF file is compressed in the unknown version {version}")
        self._recent_below = 13 if version else 15
        self._codes, self._source, self._both = data[1 : 1 + count], _Source(data, 1 + count), data[-16:]
        self._edges, self._vertices = _Recent((0, 0)), _Recent(0)
        self._new = self._last = 0
        self.corners: List[int] = []

    def run(self) -> List[int]:
        for code in self._codes:
            if code < 0xF0:
                self._beside_edge(code >> 4, code & 15)
            else:
                self._alone(code)
        return self.corners

    def _take_new(self) -> int:
        self._new += 1
        return self._new - 1

    def _take_far(self, step: int) -> int:
        self._last += step
        return self._last

    def _beside_edge(self, edge: int, third: int) -> None:
        a, b = self._edges[edge]
        if third == 0:
            c = self._take_new()
        elif third < self._recent_below:
            c = self._vertices[third]
        else:
            c = self._take_far(self._source.difference() if third == 15 else 2 * third - 27)  # 13: -1, 14: +1
        if third == 0 or third >= self._recent_below:
            self._vertices.push(c)
        self._add(a, b, c, ((c, b), (a, c)))

    def _alone(self, code: int) -> None:
        in_table = code < 0xFE
        both = self._both[code & 15] if in_table else self._source.byte()
        if both == 0 and not in_table:
            self._new = 0
        kinds = [0 if code != 0xFF else 15, both >> 4, both & 15]
        corners = [0, 0, 0]
        for k, kind in enumerate(kinds):  # corners of this triangle are not yet among the last 16
            if kind == 0:
                corners[k] = self._take_new()
            elif kind < 15 or in_table:
                corners[k] = self._vertices[kind - 1]
        for k, kind in enumerate(kinds):
            if kind == 15 and not in_table:
                corners[k] = self._take_far(self._source.difference())
        for corner, kind in zip(corners, kinds):
            if kind == 0 or (kind == 15 and not in_table):
                self._vertices.push(corner)
        a, b, c = corners
        self._add(a, b, c, ((b, a), (c, b), (a, c)))

    def _add(self, a: int, b: int, c: int, edges: Tuple[Tuple[int, int], ...]) -> None:
        self.corners += (a, b, c)
        for edge in edges:
            self._edges.push(edge)


def _triangles(data: bytes, count: int) -> List[int]:
    if len(data) < 1 + count // 3 + 16:
        raise ValueError
    return _Triangles(data, count // 3).run()


def _sequence(data: bytes, count: int) -> List[int]:
    """Unpack a sequence.  Each number is a difference from the last number of one of two series."""
    if data[0] & 0xF0 != 0xD0 or data[0] & 15 > 1:
        raise ShapeError(f"a part of the glTF file is compressed in the unknown version {data[0] & 15}")
    source, last, result = _Source(data, 1), [0, 0], []
    for _ in range(count):
        number = source.number()
        kind, number = number & 1, number >> 1
        last[kind] += (number >> 1) ^ -(number & 1)
        result.append(last[kind])
    return result
