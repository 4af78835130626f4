# SPDX-License-Identifier: MIT
"""Reads tables of points: XYZ and similar formats (.xyz .xyzn .pwn .txt .asc .csv .pts)."""
from __future__ import annotations

import re
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from . import _heights
from ._attributes import PointValues, attributes
from ._columns import Columns, by_content, by_heading
from ._degrees import NOTE, in_metres, points_are_degrees
from ._shape import Floats, Hints, Shape, ShapeError, Vector
from ._table import Rows, about_count, at, is_number, number_at, numbers, plain, shown, without_comments

_HINT = "a line holds x y z, or x y z nx ny nz, and a first line may name these columns"
_COMMENTS = (b"#", b"//", b"%")
_LISTED = re.compile(rb"(?:col(?:umn)?|field)?\W*(\d+)[\W_]+(\w.*)", re.I)  # a comment about one column, such as 1: x [m]
UP: Vector = (0.0, 0.0, 1.0)  # the convention of maps
_DECIMAL = re.compile(rb"[+-]?\d+,\d+(?:[eE][+-]?\d+)?")
_TO_SPACES = bytes.maketrans(b",;\t", b"   ")


class _Head(NamedTuple):
    """What comes before the numbers."""

    columns: Optional[Columns]
    sure: bool  # whether the names are on a line of headings, not in a comment
    points: Optional[int]  # the number of points that the file announces
    at: int  # where the numbers begin, in bytes
    line: int  # number of the line on which they begin
    first: bytes  # that line


def read_xyz(data: bytes, hints: Hints = Hints()) -> Shape:
    """Read a table with three or more numbers on each line.  A heading, or their numbers, tell what the columns are.

    The first line may hold the number of points.  PWN has two dialects: six numbers on each line, or all points and then
    all normals.  A table with more columns than a point can have is a height map.
    """
    text = plain(data)
    head = _head(text)
    separator, decimal_comma = _separator(head.first)
    if head.columns and not head.sure and len(_words(head.first, separator)) != len(head.columns.names):
        head = head._replace(columns=None)  # a comment that names x, y and z by chance
    body = without_comments(text[head.at :], _COMMENTS)
    notes: Tuple[str, ...] = ()
    if decimal_comma:
        body, notes = body.replace(b",", b"."), ("commas are read as decimal marks",)
    body, cut = _without_cut_line(body.rstrip(), data, len(_words(head.first, separator)), separator)
    notes = (*notes, *cut)
    if head.columns is not None or _has_gaps(body, separator):
        names = head.columns.names if head.columns else None
        table, names = _split(body, head.line, separator, names)
    else:
        rows, head = _joined_blocks(numbers(body.translate(_TO_SPACES), head.line, _HINT), head)
        twice = _points_then_normals(rows, head.points)
        if twice is not None:
            return twice
        table, names = _even(rows), None
    about = about_count(head.points, len(table))
    if about and hints.normals and table.shape[1] == 3:  # half of the lines are normals, but which?
        raise ShapeError(f"the first line says {head.points} points, but {len(table)} lines of 3 numbers follow")
    notes = (*notes, *about)
    if names is None and head.points is None and _heights.is_map(table):
        return _heights.of_array(table, "text", notes)
    columns = Columns(names) if names else by_content(table, hints.normals)
    if table.shape[1] < 3:
        raise at(head.line, 0, f"{_HINT}; this line holds {table.shape[1]} numbers")
    places, normals = columns.triple("xyz"), columns.triple(("nx", "ny", "nz"))
    assert places is not None
    points, notes = table[:, places], (*notes, *columns.notes)
    on_map = head.columns is not None and head.columns.on_map
    if points_are_degrees(points, True if head.columns and head.columns.degrees else hints.degrees):
        points, notes, on_map = in_metres(points), (*notes, NOTE), True
    return Shape(
        points, None if normals is None else table[:, normals], format="map, text" if on_map else "text", columns=columns.names,
        notes=notes, up=UP if on_map else None, fields=fields_of(table, columns.names),
    )  # fmt: skip


def fields_of(table: Floats, names: Tuple[str, ...]) -> Dict[str, PointValues]:
    """The values in the columns of a table.  A column of unknown meaning is an intensity if it is the only one."""
    unknown = [i for i, name in enumerate(names) if name == "other"]
    named = {i: "intensity" if len(unknown) == 1 else f"column{i + 1}" for i in unknown}
    return attributes({named.get(i, name): table[:, i] for i, name in enumerate(names)})


def _head(text: bytes) -> _Head:
    columns: Optional[Columns] = None
    sure = False
    count: Optional[int] = None
    listed: List[str] = []
    start, number = 0, 0
    while start < len(text):
        end = text.find(b"\n", start)
        end = len(text) if end < 0 else end
        line, number = text[start:end].strip(), number + 1
        bare = line.lstrip(b"#/;%! ")
        heading = by_heading(_headings(bare)) if columns is None and count is None or bare != line else None
        if heading is not None:
            columns, sure = heading, bare == line
        elif line and bare == line:
            words = line.replace(b";", b" ").split()
            if len(words) == 1 and words[0].isdigit() and len(words[0]) <= 18 and count is None:
                count = int(words[0])
            else:
                columns = columns or by_heading(listed)
                _check_first(line, number, columns is not None)
                return _Head(columns, sure, count, start, number, line)
        elif line:
            one = _LISTED.fullmatch(bare)
            if one is not None and int(one.group(1)[:9]) in (len(listed), len(listed) + 1):
                listed.append(one.group(2).decode("utf-8", errors="replace"))
        start = end + 1
    if count is not None:
        raise at(number, 0, f"this line says {count} points, but none follow")
    raise ShapeError("there are no points")


def _headings(line: bytes) -> List[str]:
    words = re.sub(r"(?<=\w)[ _]*\((?!\d)[^()]*\)", "", line.decode("utf-8", errors="replace"))  # units in brackets
    words = re.sub(r"^[A-Za-z ]{2,}[:=]\s+", "", words)  # as in "Columns: x y z"
    mark = next((mark for mark in (";", ",", "\t") if mark in words), None)
    return [word.strip() for word in words.split(mark)] if mark else words.split()


def _check_first(line: bytes, number: int, headed: bool) -> None:
    """Raise an error about the first line if it holds no numbers at all."""
    words = re.split(rb"[,;\s]+", line.strip(b",; \t"))
    if len(words) == 1 and re.fullmatch(rb"-\d+", words[0]):
        raise at(number, 1, f"a count was expected, not {shown(words[0])}")
    if not headed and not is_number(words[0]):
        raise at(number, 1, f"{shown(words[0])} is not a number; {_HINT}")


def _separator(line: bytes) -> Tuple[bytes, bool]:
    """The separator of columns, and whether commas are decimal marks."""
    apart = b";" if b";" in line else None
    words = line.split(apart)
    if b"," in line and len(words) >= 3 and b"." not in line:
        if all(_DECIMAL.fullmatch(word.strip()) or is_number(word) for word in words):
            return apart or b"", True
    if apart is None and b"," in line:
        apart = b","
    return apart or b"", False


def _words(line: bytes, separator: bytes) -> List[bytes]:
    """The words of a line of numbers.  A separator at its end adds no word."""
    if not separator:
        return line.split()
    words = [word.strip() for word in line.split(separator)]
    return words if words[-1] else words[:-1]


def _has_gaps(body: bytes, separator: bytes) -> bool:
    """Whether a column may be empty somewhere."""
    if not separator:
        return False
    mark = re.escape(separator)
    return re.search(mark + rb"[ \t]*(?:$|" + mark + rb")", body, re.M) is not None


def _split(body: bytes, first_line: int, separator: bytes, names: Optional[Tuple[str, ...]]) -> Tuple[Floats, Any]:
    """The numbers of a text with headings, and the names of its columns.  Words in other columns than places and normals are NaN."""
    wanted = [i for i, name in enumerate(names or ()) if name in ("x", "y", "z", "nx", "ny", "nz")]
    if not (separator and _has_gaps(body, separator)):
        try:
            rows = numbers(body.translate(_TO_SPACES), first_line)
            if names is None or (rows.counts == len(names)).all():
                return rows.values.reshape(len(rows.counts), -1), names
        except (ShapeError, ValueError):
            pass  # perhaps a column of words that is not wanted
    result: List[List[float]] = []
    width = len(names) if names else 0
    for number, line in enumerate(body.split(b"\n"), first_line):
        if not line.strip():
            continue
        words = [word.strip().strip(b"\"'") for word in (line.split(separator) if separator else line.split())]
        if len(words) > max(width, 1) and not words[-1]:
            words.pop()  # the empty word after a separator at the end of the line
        width = width or len(words)
        if len(words) < width and (not wanted or len(words) <= max(wanted)):
            raise at(number, 0, f"there are {len(words)} columns, but {width} were expected")
        row = [float("nan")] * width
        for i in range(min(width, len(words))):
            if not wanted or i in wanted:
                row[i] = number_at(words[i], number, i + 1, _HINT) if words[i] else float("nan")
            elif is_number(words[i]):
                row[i] = float(words[i])
        result.append(row)
    return np.array(result, dtype=np.float64).reshape(len(result), width), names


def _joined_blocks(rows: Rows, head: _Head) -> Tuple[Rows, _Head]:
    """One table from scans that follow each other, each after its count; the head gets the count of all."""
    if head.points is None or len(rows.counts) == 0 or int(rows.counts[0]) == 1:
        return rows, head
    alone = rows.counts == 1
    announced = rows.values[rows.starts[alone]]
    if not alone.any() or not (announced == np.round(announced)).all() or announced.min() < 1:
        return rows, head
    return _chosen(rows, ~alone), head._replace(points=head.points + int(announced.sum()))


def _chosen(rows: Rows, keep: Any) -> Rows:
    """Some of the rows."""
    return Rows(rows.values[np.repeat(keep, rows.counts)], rows.counts[keep], rows.lines[keep])


def _without_cut_line(body: bytes, data: bytes, width: int, separator: bytes) -> Tuple[bytes, Tuple[str, ...]]:
    """The lines without the last one if the file ends within it, and a note."""
    before, _, last = body.rpartition(b"\n")
    if not before or data[-2:].strip(b"\0")[-1:] in b"\r\n" or len(_words(last, separator)) >= width:
        return body, ()
    return before.rstrip(), ("the file ends within its last line, which is left out",)


def _even(rows: Rows) -> Floats:
    if len(rows.counts) == 0:
        raise ShapeError("there are no points")
    usual = int(rows.counts[0])
    odd = np.flatnonzero(rows.counts != usual)
    if len(odd):
        i = int(odd[0])
        raise at(int(rows.lines[i]), 0, f"there are {rows.counts[i]} numbers, but line {rows.lines[0]} has {usual}")
    return rows.values.reshape(len(rows.counts), usual)


def _points_then_normals(rows: Rows, count: Optional[int]) -> Optional[Shape]:
    if count is None or len(rows.counts) != 2 * count or not (rows.counts == 3).all():
        return None
    table = rows.values.reshape(-1, 3)
    return Shape(table[:count], table[count:], format="PWN", columns=("x", "y", "z", "nx", "ny", "nz"))


