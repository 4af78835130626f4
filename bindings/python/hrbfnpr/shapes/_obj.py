# SPDX-License-Identifier: MIT
"""Reads OBJ and OFF meshes."""
from __future__ import annotations

import re
from typing import Dict, List, Optional, Tuple

import numpy as np

from . import _off_binary
from ._attributes import COLOUR, PointValues, colours
from ._shape import Floats, Integers, Shape, ShapeError
from ._sharp_edges import MOST_FACES, sharp_edges
from ._table import (
    Rows,
    at,
    check_indices,
    number_at,
    numbers,
    out_of_range,
    plain,
    polygons,
    shown,
    whole,
    without_comments,
)

_CORNER = re.compile(rb"[+-]?\d+(?:/[+-]?\d*){0,2}")
_ALONG_LINES = 4000  # approximate number of points that are placed along all lines


def read_obj(data: bytes) -> Shape:
    """Read vertices and faces.

    Normals are used as such only if there are no faces and one normal for each vertex.  If there are only lines, as in a
    wire frame or cross sections, points along them are returned.
    """
    text = without_comments(plain(data))
    if b"\\\n" in text:
        text = re.sub(rb"((?:[^\n]*\\\n)+)([^\n]*)", _joined, text)
    found: Dict[bytes, Tuple[List[bytes], List[int]]] = {b"v": ([], []), b"vn": ([], []), b"f": ([], []), b"l": ([], [])}
    for number, line in enumerate(text.split(b"\n"), 1):
        words = line.split(None, 1)
        if words and words[0] in found:
            lines, where = found[words[0]]
            lines.append(words[1] if len(words) == 2 else b"")
            where.append(number)
    vertices, wide = _vectors(*found[b"v"], "a vertex")
    columns = ("x", "y", "z", "red", "green", "blue") if wide >= 6 else ("x", "y", "z")
    fields = _colours_of(found[b"v"][0]) if wide >= 6 else {}
    if found[b"f"][0]:
        triangles, sharp = _faces(*found[b"f"], np.array(found[b"v"][1]), vertices, *found[b"vn"])
        return Shape(vertices, None, triangles, "OBJ", columns, sharp_edges=sharp, fields=fields)
    normals, _ = _vectors(*found[b"vn"], "a normal")
    if len(vertices) == 0:
        raise ShapeError("there are no points: no line begins with v")
    matched = len(normals) == len(vertices)
    if found[b"l"][0] and not matched:
        rows, index = _corners(*found[b"l"], np.array(found[b"v"][1]), "line")
        loose = len(vertices) - len(np.unique(index))
        if 2 * loose <= len(vertices):
            return _wires(rows, vertices[index], loose)
    if matched:
        columns = (*columns, "nx", "ny", "nz")
    count = len(found[b"l"][0])
    notes = (f"{count} line{'s' if count > 1 else ''} left out: the file is drawn as points",) if count else ()
    return Shape(vertices, normals if matched else None, None, "OBJ", columns, notes=notes, fields=fields)


def _joined(found: "re.Match[bytes]") -> bytes:
    """Join continued lines into one, and add as many empty lines after it, so that line numbers stay right."""
    return found.group(1).replace(b"\\\n", b" ") + found.group(2) + b"\n" * found.group(1).count(b"\n")


def _placed(lines: List[bytes], where: List[int]) -> Rows:
    """The numbers of some lines of a file, without their first words."""
    try:
        rows = numbers(b"\n".join(lines))
    except ShapeError:
        for line, number in zip(lines, where):
            for column, word in enumerate(line.split(), 2):
                number_at(word, number, column)
        raise
    return rows._replace(lines=np.array(where, dtype=np.int64)[rows.lines - 1])


def _vectors(lines: List[bytes], where: List[int], what: str) -> Tuple[Floats, int]:
    """The first three numbers of each line, and how many numbers the first line has."""
    rows = _placed(lines, where)
    if len(rows.counts) != len(lines):
        empty = next(i for i, line in enumerate(lines) if not line.strip())
        raise at(where[empty], 0, f"{what} needs 3 numbers, and there are 0")
    return rows.table(3, what).reshape(-1, 3), int(rows.counts[0]) if len(lines) else 0


def _colours_of(lines: List[bytes]) -> Dict[str, PointValues]:
    """The colours after the places of vertices, if all have them."""
    rows = numbers(b"\n".join(lines))
    if not (rows.counts >= 6).all():
        return {}
    return {COLOUR: colours(rows.table(6, "a vertex")[:, 3:])}


def _faces(
    lines: List[bytes], where: List[int], vertex_lines: Integers, points: Floats, normals: List[bytes], placed: List[int]
) -> Tuple[Integers, Optional[Integers]]:
    """The triangles, and the edges that are sharp by the normals of their corners (None without normals)."""
    rows, index = _corners(lines, where, vertex_lines, "face")
    if not normals or len(lines) > MOST_FACES or not (given := _normals_of(lines, where, normals, placed)):
        return polygons(rows, rows.counts, rows.starts, index, points)[0], None
    corners = polygons(rows, rows.counts, rows.starts, np.arange(len(index)), points[index])[0]
    return index[corners], sharp_edges(points, index[corners], given[0][corners])


def _normals_of(lines: List[bytes], where: List[int], normals: List[bytes], placed: List[int]) -> List[Floats]:
    """The normals of all corners such as 7/1/3 and 7//3; empty if a corner has none.  They are a hint: errors are ignored."""
    try:
        names = np.array([int(corner.split(b"/")[2]) for line in lines for corner in line.split()], dtype=np.int64)
        unit = _vectors(normals, placed, "a normal")[0]
    except (IndexError, ValueError):
        return []
    if (names < 0).any():  # counted back from the last normal before the line
        seen = np.searchsorted(np.array(placed), np.repeat(where, [len(line.split()) for line in lines]))
        names = np.where(names < 0, seen + names + 1, names)
    return [unit[names - 1]] if ((names >= 1) & (names <= len(unit))).all() else []


def _wires(rows: Rows, corners: Floats, loose: int) -> Shape:
    """Evenly spaced points along lines, which are rows of corners.  `loose` is the number of vertices on no line."""
    following = np.ones(len(corners), dtype=bool)
    following[rows.starts + rows.counts - 1] = False  # the last corner of each line
    first = np.flatnonzero(following)
    start, end = corners[first], corners[first + 1]
    length = np.linalg.norm(end - start, axis=1)
    usable = np.isfinite(length)
    start, end, length = start[usable], end[usable], length[usable]
    if not 0 < length.sum() < np.inf:
        raise ShapeError("there are no faces, and its lines have no length")
    parts = np.maximum(1, np.ceil(length / (length.sum() / _ALONG_LINES))).astype(np.int64)
    part = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
    share = (part / np.repeat(parts, parts))[:, None]
    along = np.repeat(start, parts, axis=0) * (1 - share) + np.repeat(end, parts, axis=0) * share
    along = np.concatenate([along, corners[~following & np.isfinite(corners).all(axis=1)]])
    along = along[np.sort(np.unique(along, axis=0, return_index=True)[1])]
    notes = [f"there are no faces: points along its {len(rows.counts)} lines are used"]
    notes += [f"vertices left out, as they are on no line: {loose}"] if loose else []
    notes += [f"pieces of lines left out, as a corner is not finite: {(~usable).sum()}"] if not usable.all() else []
    return Shape(along, None, None, "OBJ", ("x", "y", "z"), notes=tuple(notes))


def _corners(lines: List[bytes], where: List[int], vertex_lines: Integers, what: str) -> Tuple[Rows, Integers]:
    """The vertices of corners such as 7, 7/1, 7//3 or -1: counted from 1, or back from the last vertex before the line."""
    try:
        rows = _placed(re.sub(rb"/\S*", b"", b"\n".join(lines)).split(b"\n"), where)
        corners = whole(rows, "a corner", 1)
    except ShapeError:
        for line, number in zip(lines, where):
            for column, word in enumerate(line.split(), 2):
                if not _CORNER.fullmatch(word):
                    raise at(number, column, f"a {what} has the corner {shown(word)}; write it as 7, 7/1 or 7//3") from None
        raise
    count = len(vertex_lines)
    line_of = np.repeat(rows.lines, rows.counts)
    seen = np.searchsorted(vertex_lines, line_of)
    index = np.where(corners < 0, seen + corners, corners - 1)
    wrong = np.flatnonzero((index < 0) | (index >= count))
    if len(wrong):
        i = int(wrong[0])
        column = i - int(rows.starts[np.searchsorted(rows.starts, i, side="right") - 1]) + 2
        raise at(int(line_of[i]), column, out_of_range(int(corners[i]), count, 1, what))
    return rows, index


def read_off(data: bytes) -> Shape:
    """Read OFF, and its variants with normals (NOFF) or colours (COFF)."""
    binary = re.match(rb"\s*(\w*OFF)\s+BINARY[^\n]*\n", data[:100])
    if binary is not None:
        return _off_binary.read(binary.group(1).decode(), data[binary.end() :])
    text = without_comments(plain(data))
    head = re.match(rb"\s*(\w*?OFF)(?=\d|\b)", text)
    if head is None:
        raise ShapeError("not an OFF file in text form: it does not begin with OFF")
    kind = head.group(1).decode()
    if "4" in kind or "n" in kind:
        raise ShapeError(f"OFF files with the dimension of {kind!r} are not read")
    rest, first = text[head.end() :], 1 + text.count(b"\n", 0, head.end())
    start = re.search(rb"\S", rest)
    if start is None:
        raise ShapeError("the OFF file lacks its counts")
    counts, begin = _counts(rest, start.start(), first)
    first += rest.count(b"\n", 0, begin)
    rows = numbers(rest[begin:], first) if counts[0] or counts[1] else numbers(b"")
    # Vertices and faces are usually on a line each, but the format is a stream of numbers.
    usual = len(rows.counts) == counts[0] + counts[1]
    stream = None if usual else _regrouped(rows, counts, kind)
    try:
        return _off_shape(rows if stream is None else stream, counts, kind)
    except ShapeError:
        stream = _regrouped(rows, counts, kind) if usual else None
        if stream is None:
            raise
        return _off_shape(stream, counts, kind)


def _off_shape(rows: Rows, counts: List[int], kind: str) -> Shape:
    """The mesh of rows that are vertices, then faces."""
    if len(rows.counts) < counts[0] + counts[1]:
        raise ShapeError(
            f"the OFF file ends before its {counts[0]} vertices and {counts[1]} faces do: "
            f"{len(rows.counts)} lines follow the counts"
        )
    width = 6 if "N" in kind else 3
    cut = [counts[0], counts[0] + counts[1]]
    table = _part(rows, 0, cut[0]).table(width, "a vertex").reshape(-1, width)
    triangles = _off_faces(_part(rows, *cut), table[:, :3]) if counts[1] else None
    columns = ("x", "y", "z", "nx", "ny", "nz")[:width]
    fields = _off_colours(_part(rows, 0, cut[0]), width) if "C" in kind and counts[0] else {}
    return Shape(table[:, :3], table[:, 3:] if width == 6 else None, triangles, "OFF", columns, fields=fields)


def _regrouped(rows: Rows, counts: List[int], kind: str) -> Optional[Rows]:
    """The same numbers with a row for each vertex and each face; None if they are too few, or no faces.

    A face may end with up to four numbers of a colour, which are on the line of its last corner.
    """
    lines, width = np.repeat(rows.lines, rows.counts), 6 if "N" in kind else 3
    line_of, values = lines.tolist(), rows.values.tolist()
    for coloured in (False, True):
        for colour in (4, 3) if "C" in kind else (0,):
            sizes, start = [width + colour] * counts[0], counts[0] * (width + colour)
            for _ in range(counts[1]):
                corners = values[start] if start < len(values) else -1.0
                if not (0 <= corners < len(values) - start and corners == int(corners)):
                    break
                end = start + 1 + int(corners)
                if not all(corner.is_integer() and 0 <= corner < counts[0] for corner in values[start + 1 : end]):
                    break
                while coloured and end < len(values) and line_of[end] == line_of[end - 1] and end - start - 1 < corners + 4:
                    end += 1
                sizes.append(end - start)
                start = end
            if len(sizes) == sum(counts[:2]) and start == len(values):
                wide = np.array(sizes, dtype=np.int64)
                return Rows(rows.values, wide, lines[np.cumsum(wide) - wide])
    return None


def _off_colours(rows: Rows, width: int) -> Dict[str, PointValues]:
    """The colours after `width` numbers of each vertex, if all vertices have them: from 0 to 1, or to 255."""
    if not (rows.counts >= width + 3).all():
        return {}
    return {COLOUR: colours(rows.table(width + 3, "a vertex")[:, width:])}


def _counts(text: bytes, start: int, first_line: int) -> Tuple[List[int], int]:
    """The numbers of vertices and faces, and the end of the counts, which are usually on one line."""
    end = text.find(b"\n", start)
    end = len(text) if end < 0 else end
    line = first_line + text.count(b"\n", 0, start)
    words = text[start:end].split()
    three = re.match(rb"\s*\d+\s+\d+\s+\d+(?!\S)", text[start:])
    if three is not None and len(words) not in (2, 3):
        end = start + three.end()
        words = text[start:end].split()
    for column, word in enumerate(words, 1):
        if not word.isdigit() or len(word) > 18:
            raise at(line, column, f"a count was expected, not {shown(word)}")
    if len(words) < 2:
        raise at(line, 0, "the OFF file lacks its counts: vertices and faces, as in 8 6 0")
    return [int(word) for word in words], end


def _part(rows: Rows, first: int, last: int) -> Rows:
    """Some of the rows."""
    ends = np.concatenate([[0], np.cumsum(rows.counts)])
    return Rows(rows.values[ends[first] : ends[last]], rows.counts[first:last], rows.lines[first:last])


def _off_faces(rows: Rows, points: Floats) -> Integers:
    """The triangles of faces: a number of corners, the corners, and perhaps a colour, which need not be whole numbers."""
    sizes = rows.values[rows.starts]
    for i in np.flatnonzero((sizes != np.round(sizes)) | (sizes < 0)):
        raise at(int(rows.lines[i]), 1, f"a face begins with the number of its corners, not with {sizes[i]:g}")
    corners = sizes.astype(np.int64)
    for i in np.flatnonzero(rows.counts < corners + 1):
        raise at(int(rows.lines[i]), 0, f"a face has fewer than its {corners[i]} corners")
    triangles, lines = polygons(rows, corners, rows.starts + 1, rows.values.astype(np.int64), points)
    check_indices(triangles, lines, len(points))
    return triangles
