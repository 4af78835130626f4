# SPDX-License-Identifier: MIT
"""Reads PCD, the point clouds of PCL: ascii, binary and compressed."""
from __future__ import annotations

import struct
from dataclasses import replace
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._attributes import COLOUR, PointValues, attributes, colours
from ._shape import Floats, Shape, ShapeError, Vector
from ._table import about_count, at, numbers, records

_TYPES = {"F": "f", "I": "i", "U": "u"}
_LEAST_PICTURE = 16  # least number of rows and columns of a picture
_LIKE_A_PICTURE = 0.99  # least correlation between places in space and pixels


def read_pcd(data: bytes) -> Shape:
    """Read the bytes of a PCD file."""
    head, offset, line = _header(data)
    try:
        names = [name.lower() for name in head["FIELDS"]]
        sizes, types = [int(word) for word in head["SIZE"]], head["TYPE"]
        counts = [int(word) for word in head.get("COUNT", ["1"] * len(names))]
        points = int(head["POINTS"][0]) if "POINTS" in head else int(head["WIDTH"][0]) * int(head["HEIGHT"][0])
        form = head["DATA"][0].lower()
        fields = [(f"{name} {i}", f"<{_TYPES[kind.upper()]}{size}", (count,))
                  for i, (name, kind, size, count) in enumerate(zip(names, types, sizes, counts))]  # fmt: skip
        np.dtype(fields)
    except (KeyError, ValueError, IndexError, TypeError) as error:
        raise ShapeError(f"the PCD header lacks {error.args[0]}, or is not valid") from None
    if not len(names) == len(sizes) == len(types) == len(counts) or points < 0 or min(counts, default=0) < 1:
        raise ShapeError("the PCD header has lists that differ in length, or a count that is too small")
    if form == "ascii":
        columns = _ascii(data[offset:], line, names, counts)
    elif form == "binary":
        columns = _packed(data[offset:], np.dtype(fields), points)
    elif form == "binary_compressed":
        columns = _compressed(data[offset:], fields)
    else:
        raise ShapeError(f"PCD files with data in the form {form!r} are not read")
    notes = about_count(points, len(columns[names[0]]))
    shape = replace(_shape(columns, tuple(names), form), viewpoint=_viewpoint(head.get("VIEWPOINT", [])), notes=notes)
    up = _up_of_picture(shape.points, head)
    if up is None:
        return shape
    height, width = int(head["HEIGHT"][0]), int(head["WIDTH"][0])
    return replace(shape, up=up, is_picture=True, image_shape=(height, width), viewpoint=(0.0, 0.0, 0.0))


def _viewpoint(words: List[str]) -> Optional[Vector]:
    """The place of the scanner; None for the origin, which programs write if they do not know it."""
    try:
        x, y, z = (float(word) for word in words[:3])
    except ValueError:
        return None
    return (x, y, z) if np.isfinite((x, y, z)).all() and (x, y, z) != (0.0, 0.0, 0.0) else None


def _up_of_picture(points: Floats, head: Dict[str, List[str]]) -> Optional[Vector]:
    """The up direction for the picture of a camera at the origin that looks along z; None if the points are no picture.

    In a picture, x / z changes with the column and y / z with the row.  Most pictures have y downward, as cameras do.  The
    camera's rotation in the header does not help: programs store what turns the picture for their own viewer.
    """
    try:
        columns, rows = int(head["WIDTH"][0]), int(head["HEIGHT"][0])
    except (KeyError, ValueError, IndexError):
        return None
    if min(columns, rows) < _LEAST_PICTURE or columns * rows != len(points):
        return None
    row, column = np.divmod(np.arange(len(points)), columns)
    known = np.isfinite(points).all(axis=1) & (points[:, 2] != 0)
    x, y, z = points[known].T
    if known.sum() < _LEAST_PICTURE**2 or not ((z > 0).all() or (z < 0).all()):
        return None
    with np.errstate(all="ignore"):  # points that are no picture may be constant, or overflow
        across, down = np.corrcoef(x / z, column[known])[0, 1], np.corrcoef(y / z, row[known])[0, 1]
    if not min(abs(across), abs(down)) > _LIKE_A_PICTURE:
        return None
    return (0.0, -1.0 if (down > 0) == (z[0] > 0) else 1.0, 0.0)


def _shape(columns: Dict[str, Any], names: Tuple[str, ...], form: str) -> Shape:
    if not all(axis in columns for axis in "xyz"):
        raise ShapeError(f"the PCD file has no x, y and z; it has {', '.join(names)}")
    points = np.column_stack([columns[axis] for axis in "xyz"]).astype(np.float64)
    normals = None
    for three in (("normal_x", "normal_y", "normal_z"), ("nx", "ny", "nz")):
        if all(name in columns for name in three):
            normals = np.column_stack([columns[name] for name in three]).astype(np.float64)
    return Shape(points, normals, None, f"PCD, {form}", names, fields=_fields(columns))


def _fields(columns: Dict[str, Any]) -> Dict[str, PointValues]:
    """The values of the points.  PCL packs a colour into the bytes of one number: blue, green, red."""
    packed = next((columns[name] for name in ("rgb", "rgba") if name in columns), None)
    fields = attributes({name: column for name, column in columns.items() if name not in ("rgb", "rgba")})
    if packed is not None and COLOUR not in fields:
        bits = np.ascontiguousarray(packed, np.float32).view(np.uint32) if packed.dtype.kind == "f" else packed
        bits = bits.astype(np.uint32)
        fields[COLOUR] = colours(np.column_stack([bits >> 16 & 255, bits >> 8 & 255, bits & 255]).astype(np.uint8))
    return fields


def _header(data: bytes) -> Tuple[Dict[str, List[str]], int, int]:
    """The words after each keyword, the place where the data begins, and the line number of that place."""
    head: Dict[str, List[str]] = {}
    start, number = 0, 0
    while start < len(data):
        end = data.find(b"\n", start)
        end = len(data) if end < 0 else end
        words = data[start:end].decode("latin-1").split()
        start, number = end + 1, number + 1
        if words and not words[0].startswith("#"):
            head[words[0].upper()] = words[1:]
            if words[0].upper() == "DATA":
                return head, start, number + 1
            if number > 100:
                break
    raise ShapeError("not a PCD file, or its header is cut short: there is no DATA line")


def _ascii(data: bytes, line: int, names: List[str], counts: List[int]) -> Dict[str, Any]:
    rows = numbers(data, line)
    width, points = sum(counts), len(rows.counts)
    if points and rows.counts[-1] < width:
        points -= 1  # the file ends within a line
    for i in np.flatnonzero(rows.counts[:points] != width):
        raise at(int(rows.lines[i]), 0, f"{rows.counts[i]} numbers, where the header has {width}")
    table = rows.values[: width * points].reshape(points, width)
    starts = np.cumsum([0, *counts])
    return {name: table[:, starts[i]] for i, name in enumerate(names)}


def _packed(data: bytes, dtype: Any, points: int) -> Dict[str, Any]:
    table = np.frombuffer(data, dtype, records(data, dtype.itemsize, points))
    return {name.rsplit(" ", 1)[0]: table[name][:, 0] for name in dtype.names}


def _compressed(data: bytes, fields: List[Any]) -> Dict[str, Any]:
    """Unpack all numbers of the first field, then those of the second, and so on; they are compressed with LZF."""
    if len(data) < 8:
        raise ShapeError("the PCD file ends before its points")
    packed, size = struct.unpack_from("<II", data)
    if len(data) < 8 + packed:
        raise ShapeError(f"the PCD file ends in the middle of its {packed} compressed bytes, after {len(data) - 8}")
    raw, at_byte, columns = _unpack(data[8 : 8 + packed], size), 0, {}
    points = size // np.dtype(fields).itemsize
    for name, kind, (count,) in fields:
        numbers_ = np.frombuffer(raw, kind, points * count, at_byte)
        columns[name.rsplit(" ", 1)[0]] = numbers_.reshape(points, count)[:, 0]
        at_byte += numbers_.nbytes
    return columns


def _unpack(data: bytes, size: int) -> bytes:
    """Unpack LZF: runs of plain bytes, and copies of bytes before."""
    out = bytearray()
    i = 0
    try:
        while i < len(data):
            control = data[i]
            i += 1
            if control < 32:
                out += data[i : i + control + 1]
                i += control + 1
                continue
            length = control >> 5
            if length == 7:
                length += data[i]
                i += 1
            back = ((control & 31) << 8) + data[i] + 1
            i += 1
            length += 2
            start = len(out) - back
            if start < 0:
                raise IndexError
            piece = out[start : start + length]
            while len(piece) < length:  # a copy that overlaps itself
                piece += piece[: length - len(piece)]
            out += piece
    except IndexError:
        raise ShapeError("the compressed points of the PCD file are damaged") from None
    if len(out) != size:
        raise ShapeError("the compressed points of the PCD file are damaged")
    return bytes(out)
