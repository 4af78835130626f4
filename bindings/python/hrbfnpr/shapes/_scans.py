# SPDX-License-Identifier: MIT
"""Reads points of scanners, with z up: LAS directly, LAZ with laspy, E57 with pye57."""
from __future__ import annotations

import math
import os
import struct
from contextlib import closing
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._attributes import COLOUR, PointValues, colours, scalars
from ._classes import chosen
from ._degrees import NOTE, crs_says, in_metres, points_are_degrees
from ._optional import needed
from ._shape import Floats, Hints, Shape, ShapeError, Vector
from ._table import about_count, records

UP: Vector = (0.0, 0.0, 1.0)
MOST_POINTS = 4_000_000  # largest number of points that are read; of more points, an even part is read
_HEADER = 227  # size of the shortest header, in bytes
_WKT, _KEYS = 2112, 34735  # records of the coordinate system
_MOST_RECORDS = 1000  # largest number of records in which it is looked for
_LONGEST_WKT = 1 << 20  # largest length of its text, in bytes
_COLOURS_AT = {2: 20, 3: 28, 5: 28, 7: 30, 8: 30, 10: 30}  # where the colour begins in the records of a format, in bytes


def read_las(path: Path, hints: Hints = Hints()) -> Shape:
    """Read a LAS file, or a LAZ file with laspy."""
    with open(path, "rb") as file:
        head = file.read(375)
        if head[:4] != b"LASF" or len(head) < _HEADER:
            raise ShapeError("not a LAS file, or its header is cut short")
        said = _says_degrees(file, head)
    offset, form, length, count = struct.unpack_from("<I4xBHI", head, 96)
    scale, shift = struct.unpack_from("<3d", head, 131), struct.unpack_from("<3d", head, 155)
    if head[25] >= 4 and count == 0 and len(head) >= 255:  # version 1.4 has a second, 64-bit count
        count = struct.unpack_from("<Q", head, 247)[0]
    degrees = hints.degrees if said is None else said
    if form & 0xC0:
        points, fields, notes = _by_laspy(path, hints)
        return _shape(points, degrees, "LAZ", notes, fields)
    if length < 20:
        raise ShapeError(f"the LAS file has points of {length} bytes; the least are 20")
    there = _there(path, head, offset, length, count)
    if there == 0:
        raise ShapeError("the LAS file has no points")
    notes, count = about_count(count, there), there
    at = _COLOURS_AT.get(form)
    has_colours = at is not None and at + 6 <= length
    names, kinds, offsets = ["place", "intensity", "flags", "class"], [("<i4", 3), "<u2", "u1", "u1"], [0, 12, 15, 16]
    if has_colours:
        names, kinds, offsets = [*names, "colour"], [*kinds, ("<u2", 3)], [*offsets, at]
    record = np.dtype({"names": names, "formats": kinds, "offsets": offsets, "itemsize": length})
    table: Any = np.memmap(path, record, "r", offset, (count,))
    flags = np.array(table["flags"])
    classes, withheld = (flags & 31, flags & 128) if form < 6 else (np.array(table["class"]), flags & 4)
    kept, about = chosen(classes, withheld != 0, hints.classes)
    step = math.ceil(len(kept) / MOST_POINTS)
    notes = (*notes, *about, *_taken(len(kept), len(kept[::step])))
    table = table[kept[::step]]
    fields = {"intensity": scalars(table["intensity"])}
    if has_colours:
        fields[COLOUR] = _colours(table["colour"])
    return _shape(table["place"].astype(np.float64) * scale + shift, degrees, "LAS", notes, fields)


def _shape(points: Floats, degrees: Optional[bool], form: str, notes: Tuple[str, ...], fields: Dict[str, PointValues]) -> Shape:
    """The shape of points of LAS.  Degrees become metres."""
    if points_are_degrees(points, degrees):
        points, notes = in_metres(points), (*notes, NOTE)
    return Shape(points, None, None, form, ("x", "y", "z"), UP, notes, fields=fields)


def _there(path: Path, head: bytes, offset: int, length: int, said: int) -> int:
    """The number of points in a LAS file."""
    size = path.stat().st_size - offset
    more_follows = head[25] >= 3 and any(head[227:235]) or head[25] >= 4 and any(head[235:247])  # waveforms, or other records
    if size <= said * length or more_follows:
        return max(0, min(said, size // length))
    with open(path, "rb") as file:
        file.seek(offset + said * length)
        return said + records(file.read(), length, 0)


def _says_degrees(file: Any, head: bytes) -> Optional[bool]:
    """What the coordinate system of a LAS file says, in WKT or in keys of GeoTIFF; None if it has none."""
    (size,), (count,) = struct.unpack_from("<H", head, 94), struct.unpack_from("<I", head, 100)
    end = file.seek(0, os.SEEK_END)
    lists = [(size, count, 54, "<20xH")]  # records after the header: an identifier, a length, and the data after a description
    if head[25] >= 4 and len(head) >= 247:
        start, more = struct.unpack_from("<QI", head, 235)
        lists.append((start, more, 60, "<20xQ"))
    for place, number, fixed, layout in lists:
        for _ in range(min(number, _MOST_RECORDS)):
            if place + fixed > end:
                break
            file.seek(place)
            record = file.read(fixed)
            (length,) = struct.unpack_from(layout, record)
            which = struct.unpack_from("<H", record, 18)[0] if record[2:18].startswith(b"LASF_Projection") else 0
            if which in (_WKT, _KEYS):
                data = file.read(min(length, _LONGEST_WKT))
                said = crs_says(data.decode("utf-8", errors="replace")) if which == _WKT else _keys_say(data)
                if said is not None:
                    return said
            place += fixed + length
    return None


def _keys_say(data: bytes) -> Optional[bool]:
    """Whether keys of GeoTIFF are of a geographic system: the kind of model is 1, projected, 2, geographic, or 3, geocentric."""
    words = np.frombuffer(data[: len(data) // 8 * 8], "<u2").reshape(-1, 4)[1:]
    return next((bool(value == 2) for key, place, _, value in words.tolist() if (key, place) == (1024, 0)), None)


def _colours(values: Any) -> PointValues:
    """Colours of LAS, whose numbers reach to 65535, or to 255 in files of some programs."""
    return colours(values.astype(np.float64))


def _taken(count: int, used: int) -> Tuple[str, ...]:
    return (f"{used} of its {count} points are read",) if used < count else ()


def _by_laspy(path: Path, hints: Hints) -> Tuple[Floats, Dict[str, PointValues], Tuple[str, ...]]:
    laspy = needed("laspy", "LAZ", "pip install laspy[lazrs], or Debian 13's python3-laspy and python3-laszip", "pdal translate or las2las turns it into LAS")
    try:
        with laspy.open(path) as file:
            count = int(file.header.point_count)
            step = math.ceil(count / MOST_POINTS)
            more = [name for name in ("intensity", "red", "green", "blue", "classification", "withheld") if name in file.header.point_format.dimension_names]
            parts: List[Any] = []
            values: List[Any] = []
            for chunk in file.chunk_iterator(1_000_000):
                parts.append(np.column_stack([chunk.x, chunk.y, chunk.z])[::step])
                values.append(np.array([np.array(chunk[name])[::step] for name in more]))
    except Exception as error:  # laspy's decompressors raise various errors
        raise ShapeError(f"laspy cannot read it: {error}") from None
    points: Floats = np.concatenate(parts).astype(np.float64)
    if len(points) == 0:
        raise ShapeError("the LAZ file has no points")
    table = dict(zip(more, np.concatenate(values, axis=1)))
    taken, none = _taken(count, len(points)), np.zeros(len(points))
    kept, notes = chosen(table.pop("classification", none), table.pop("withheld", none) != 0, hints.classes)
    points, table = points[kept], {name: column[kept] for name, column in table.items()}
    fields = {"intensity": scalars(table["intensity"])} if "intensity" in table else {}
    if {"red", "green", "blue"} <= table.keys():
        fields[COLOUR] = _colours(np.column_stack([table[name] for name in ("red", "green", "blue")]))
    return points, fields, (*taken, *notes)


def read_e57(path: Path) -> Shape:
    """Read all scans of an E57 file, in their common frame, with pye57."""
    pye57 = needed("pye57", "E57", "pip install pye57", "CloudCompare saves it as PLY, with normals")
    points: List[Floats] = []
    normals: List[Optional[Floats]] = []
    parts: List[Dict[str, Any]] = []
    try:
        with closing(pye57.E57(str(path))) as file:
            for scan in range(file.scan_count):
                data = file.read_scan(scan, intensity=True, colors=True, ignore_missing_fields=True, transform=True)
                parts.append(data)
                points.append(np.column_stack([data[f"cartesian{axis}"] for axis in "XYZ"]))
                normals.append(_e57_normals(pye57, file, file.get_header(scan)))
    except Exception as error:  # pye57's library raises various errors
        raise ShapeError(f"pye57 cannot read it: {error}") from None
    if not sum(map(len, points)):
        raise ShapeError("the E57 file has no points")
    given = [part for part in normals if part is not None]
    whole = len(given) == len(normals)
    notes = () if whole or not given else (f"only {len(given)} of its {len(normals)} scans have normals: these are not used",)
    columns = ("x", "y", "z", "nx", "ny", "nz") if whole else ("x", "y", "z")
    fields = _e57_fields(parts)
    return Shape(np.concatenate(points), np.concatenate(given) if whole else None, None, "E57", columns, UP, notes, fields=fields)


def _e57_fields(scans: List[Dict[str, Any]]) -> Dict[str, PointValues]:
    """The intensities and colours of scans.  Points of scans without them have NaN."""

    def column(name: str) -> Floats:
        return np.concatenate([np.asarray(scan.get(name, np.full(len(scan["cartesianX"]), np.nan)), dtype=np.float64) for scan in scans])

    there = set().union(*scans)
    fields = {"intensity": scalars(column("intensity"))} if "intensity" in there else {}
    names = [f"color{part}" for part in ("Red", "Green", "Blue")]
    if there.issuperset(names):
        fields[COLOUR] = colours(np.column_stack([column(name) for name in names]))
    return fields


def _e57_normals(pye57: Any, file: Any, header: Any) -> Optional[Floats]:
    """The normals of a scan's valid points, turned by its pose.  They are an extension of E57, which pye57 does not read."""
    names = [f"nor:normal{axis}" for axis in "XYZ"]
    if not set(names) <= set(header.point_fields):
        return None
    names += [name for name in ("cartesianInvalidState", "sphericalInvalidState") if name in header.point_fields]
    columns = np.empty((len(names), header.point_count))
    buffers = pye57.libe57.VectorSourceDestBuffer()
    for name, column in zip(names, columns):
        buffers.append(pye57.libe57.SourceDestBuffer(file.image_file, name, column, len(column), True, True))
    header.points.reader(buffers).read()
    valid = (columns[3:] == 0).all(axis=0)
    turned: Floats = columns[:3, valid].T @ np.asarray(header.rotation_matrix, dtype=np.float64).T
    return turned
