# SPDX-License-Identifier: MIT
"""Reads scans in Leica's PTX: for each scanner position a header, then a grid of points in the scanner's frame."""
from __future__ import annotations

from typing import Dict, List, Optional, Tuple

import numpy as np

from ._attributes import COLOUR, PointValues, colours, joined, scalars
from ._scans import UP
from ._shape import Floats, Integers, Shape, ShapeError, Vector
from ._table import Rows, at, numbers, plain

# The numbers on each line of a header: columns and rows of the grid; the scanner's place and its axes, which the matrix
# repeats; and the matrix that maps points of the grid, as rows (x, y, z, 1), to the common frame.
_HEADER = (1, 1, 3, 3, 3, 3, 4, 4, 4, 4)
MAGIC = (
    rb"\s*\d+[ \t]*\r?\n\s*\d+[ \t]*\r?\n"
    rb"(?:[ \t]*(?:[-+.\deE]+[ \t]+){2}[-+.\deE]+[ \t]*\r?\n){4}"
    rb"[ \t]*(?:[-+.\deE]+[ \t]+){3}[-+.\deE]+[ \t]*\r?\n"
)


def read_ptx(data: bytes) -> Shape:
    """Read all scans of a file, in their common frame.

    0 0 0 in the grid means that nothing was measured, and is left out.  A file with one scan gives the scanner's place.
    """
    rows = numbers(plain(data))
    starts = rows.starts
    scans: List[Floats] = []
    values: List[Optional[Floats]] = []  # intensities and colours of each scan; None if its lines have none
    stood: Vector = (0.0, 0.0, 0.0)
    line, empty, missing = 0, 0, 0
    while line < len(rows.counts):
        columns, height, matrix = _header(rows, starts, line)
        line += len(_HEADER)
        count = _there(rows, line, columns * height)
        missing += columns * height - count
        points = _grid(rows, starts, line, count)
        more = _more(rows, starts, line, count)
        line += count
        if count < columns * height and line + 1 == len(rows.counts):
            line += 1  # the file ends within this line
        there = (points != 0.0).any(axis=1)
        empty += int((~there).sum())
        stood = (float(matrix[3, 0]), float(matrix[3, 1]), float(matrix[3, 2]))
        scans.append(np.column_stack([points[there], np.ones(int(there.sum()))]) @ matrix[:, :3])
        values.append(None if more is None else more[there])
    places: Floats = np.concatenate(scans) if scans else np.empty((0, 3))
    if len(places) == 0:
        raise ShapeError("the PTX file has no points: all places of its grids are empty")
    notes = [f"{len(scans)} scans are joined"] if len(scans) > 1 else []
    if missing:
        notes.append(f"the file lacks {missing} point{'' if missing == 1 else 's'} that its headers announce")
    if empty:
        notes.append(f"{empty} places of {'its grids' if len(scans) > 1 else 'its grid'} are empty")
    viewpoint = stood if len(scans) == 1 else None
    return Shape(places, None, None, "PTX", ("x", "y", "z"), UP, tuple(notes), viewpoint, fields=_fields(scans, values))


def _fields(scans: List[Floats], values: List[Optional[Floats]]) -> Dict[str, PointValues]:
    """The intensities and the colours of all scans."""
    intensity = joined([(len(scan), None if more is None else scalars(more[:, 0])) for scan, more in zip(scans, values)])
    colour = joined([(len(scan), None if more is None or more.shape[1] < 4 else colours(more[:, 1:]))
                     for scan, more in zip(scans, values)])  # fmt: skip
    return {name: one for name, one in (("intensity", intensity), (COLOUR, colour)) if one is not None}


def _header(rows: Rows, starts: Integers, line: int) -> Tuple[int, int, Floats]:
    """The columns, the rows and the matrix of the scan that begins at a line of numbers."""
    counts = rows.counts[line : line + len(_HEADER)]
    if len(counts) < len(_HEADER):
        raise ShapeError("the PTX file ends in the middle of a header")
    for i, (count, wanted) in enumerate(zip(counts, _HEADER)):
        if count != wanted:
            what = f"line {i + 1} of a scan's header needs {wanted} number{'' if wanted == 1 else 's'}, not {count}"
            raise at(int(rows.lines[line + i]), 0, what)
    sides: List[int] = []
    for i in range(2):
        side = rows.values[starts[line + i]]
        if not (0 < side <= 1e9 and side == int(side)):
            raise at(int(rows.lines[line + i]), 1, f"a grid has 1 to 1000000000 {('columns', 'rows')[i]}; not {side:g}")
        sides.append(int(side))
    begin = starts[line + 6]
    matrix = rows.values[begin : begin + 16].reshape(4, 4)
    if not np.isfinite(matrix).all() or (matrix[:, 3] != (0.0, 0.0, 0.0, 1.0)).any():
        what = "the matrix of a scan needs finite numbers, and 0 0 0 1 as its last column"
        raise at(int(rows.lines[line + 6]), 0, what)
    return sides[0], sides[1], matrix


def _there(rows: Rows, line: int, count: int) -> int:
    """The number of a grid's points that are there: the file, or the last line, may be cut short, or the next scan begins."""
    counts = rows.counts[line : line + count]
    for start in np.flatnonzero(counts == 1):
        if tuple(rows.counts[line + start : line + start + len(_HEADER)]) == _HEADER:
            return int(start)
    is_cut = len(counts) > 0 and line + count >= len(rows.counts) and counts[-1] < counts[0] and len(counts) > 1
    return len(counts) - int(is_cut)


def _grid(rows: Rows, starts: Integers, line: int, count: int) -> Floats:
    """The places of a grid's points.  Their lines may continue with intensities and colours."""
    short = np.flatnonzero(rows.counts[line : line + count] < 3)
    if len(short):
        i = line + int(short[0])
        what = f"a point needs three numbers or more, not {rows.counts[i]}: is the size of the grid wrong?"
        raise at(int(rows.lines[i]), 0, what)
    points: Floats = rows.values[starts[line : line + count, None] + np.arange(3)]
    return points


def _more(rows: Rows, starts: Integers, line: int, count: int) -> Optional[Floats]:
    """What all lines of a grid have after the places: an intensity, and perhaps a colour; None if a line has nothing."""
    if count == 0 or int(rows.counts[line : line + count].min()) < 4:
        return None
    width = 4 if int(rows.counts[line : line + count].min()) >= 7 else 1
    more: Floats = rows.values[starts[line : line + count, None] + 3 + np.arange(width)]
    return more
