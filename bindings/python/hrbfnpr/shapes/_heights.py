# SPDX-License-Identifier: MIT
"""Reads height maps as meshes with z up: ESRI ASCII grids, PGM, and, with rasterio, GeoTIFF and digital elevation models."""
from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from ._degrees import NOTE, STEEP_GRID, are_degrees, in_metres, metres
from ._optional import needed
from ._shape import Floats, Hints, Shape, ShapeError, Vector
from ._table import at, number_at, numbers, plain

UP: Vector = (0.0, 0.0, 1.0)
MOST_CELLS = 300_000  # largest number of cells that are used; of a larger map, every second, third, ... row and column
MOST_COLUMNS = 32  # largest number of columns of a point
LEAST_ROWS = 10  # least number of rows of an array of heights.  A place, a normal and a colour are 9 numbers.
_MISSING = -9999.0  # the usual mark for a missing height
_RELIEF = 0.15  # height over width for a picture without a scale
_KEYS = ("ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "nodata_value", "dx", "dy")


def mesh(
    heights: Floats, cell: Tuple[float, float], form: str, notes: List[str], west: float = 0.0, south: float = 0.0
) -> Shape:
    """A mesh with two triangles for each square of four neighbours that have a height.  Row 0 is in the north."""
    rows, columns = heights.shape
    step = max(1, math.ceil(math.sqrt(rows * columns / MOST_CELLS)))
    if step > 1:
        heights = heights[::step, ::step]
        notes.append(f"every {_ordinal(step)} row and column of its {columns} x {rows} heights is used")
    known = np.isfinite(heights)
    if not known.any():
        raise ShapeError("the height map has no heights: every one is marked as missing")
    if not known.all():
        notes.append(f"{int((~known).sum())} of {known.size} heights are missing")
    down, across = np.indices(heights.shape)
    x, y = west + across * cell[0] * step, south + (rows - 1 - down * step) * cell[1]
    number = np.cumsum(known.ravel()).reshape(known.shape) - 1
    points = np.column_stack([x[known], y[known], heights[known]])
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    whole = known[:-1, :-1] & known[1:, :-1] & known[1:, 1:] & known[:-1, 1:]
    triangles = np.concatenate([np.stack([a, b, c], -1)[whole], np.stack([a, c, d], -1)[whole]])
    if len(triangles) == 0:
        raise ShapeError("the height map has no cell with heights at all four corners")
    return Shape(points, None, triangles.astype(np.int64), form, ("z",), UP, tuple(notes))


def _ordinal(number: int) -> str:
    return {2: "second", 3: "third"}.get(number, f"{number}th")


def _placed(
    heights: Floats, cell: Tuple[float, float], form: str, notes: List[str], west: float, south: float, degrees: Optional[bool]
) -> Shape:
    """The mesh of a map.  Cells in degrees become metres, as heights are; without `degrees`, the numbers tell."""
    rows, columns = heights.shape
    known = heights[np.isfinite(heights)]
    if degrees is None and len(known):
        north = south + rows * cell[1]
        degrees = are_degrees((west, south, known.min()), (west + columns * cell[0], north, known.max()), STEEP_GRID)
    if not degrees:
        return mesh(heights, cell, form, notes, west, south)
    across, along = metres(south + rows * cell[1] / 2)
    return mesh(heights, (cell[0] * across, cell[1] * along), form, [*notes, f"cells in {NOTE}"])


def is_map(array: Any) -> bool:
    """Whether an array of two dimensions holds heights: it is wider than a row with a point can be, or is a square."""
    rows, columns = array.shape
    return bool(rows >= LEAST_ROWS and (columns > MOST_COLUMNS or columns == rows))


def of_array(array: Any, form: str, notes: Sequence[str] = ()) -> Shape:
    """The height map of an array without a scale, whose first row is in the north."""
    heights = np.array(array, dtype=np.float64)
    heights[heights == _MISSING] = np.nan
    scale, more = _without_scale(heights)
    return mesh(heights * scale, (1.0, 1.0), f"height map, {form}", [*notes, *more])


def _finite_at(word: bytes, line: int) -> float:
    value = number_at(word, line, 2)
    return value if math.isfinite(value) else 0.0


def of_axes(array: Any, east: Any, north: Any) -> Shape:
    """The height map of an array with the x of its columns and the y of its rows, alone or as grids; None if unknown."""
    heights = np.array(array, dtype=np.float64)
    heights[heights == _MISSING] = np.nan
    axes: List[Floats] = []
    for axis, given in enumerate((east, north)):
        if given is None:
            return of_array(heights, "NPZ")
        line = np.asarray(given, dtype=np.float64)
        line = line[0, :] if line.ndim == 2 and axis == 0 else line[:, 0] if line.ndim == 2 else line
        steps = np.diff(line)
        if line.shape != heights.shape[1 - axis : 2 - axis] or not ((steps > 0).all() or (steps < 0).all()):
            raise ShapeError(f"the {'xy'[axis]} of the heights must be {heights.shape[1 - axis]} numbers that rise or fall")
        if axis == 0 and steps[0] < 0:
            heights = heights[:, ::-1]
        if axis == 1 and steps[0] > 0:
            heights = heights[::-1]
        axes.append(np.sort(line))
    shape = mesh(heights, (1.0, 1.0), "height map, NPZ", [])
    points, notes = shape.points.copy(), shape.notes
    for axis, line in enumerate(axes):
        points[:, axis] = np.interp(points[:, axis], np.arange(len(line)), line)
    if are_degrees(points.min(axis=0), points.max(axis=0), STEEP_GRID):
        points, notes = in_metres(points), (*notes, NOTE)
    return replace(shape, points=points, notes=notes)


def read_grid(data: bytes, hints: Hints = Hints()) -> Shape:
    """Read an ESRI ASCII grid: a header with ncols, nrows and cellsize, then rows of heights from the north."""
    text = plain(data)
    head: Dict[str, float] = {}
    start, number = 0, 1
    while start < len(text):
        end = text.find(b"\n", start)
        end = len(text) if end < 0 else end
        words = text[start:end].split()
        if words and words[0].decode("latin-1").lower() not in _KEYS:
            break
        if len(words) >= 2:
            head[words[0].decode("latin-1").lower()] = _finite_at(words[1], number)
        start, number = end + 1, number + 1
    columns, rows = int(head.get("ncols", 0)), int(head.get("nrows", 0))
    cell = (head.get("cellsize", head.get("dx", 0.0)), head.get("cellsize", head.get("dy", 0.0)))
    if columns < 2 or rows < 2 or min(cell) <= 0:
        raise ShapeError("the height map needs ncols, nrows and cellsize, and at least two columns and rows")
    values = numbers(text[start:], number)
    if len(values.values) != columns * rows:
        last = int(values.lines[-1]) if len(values.lines) else number
        raise at(last, 0, f"the height map has {len(values.values)} heights, but its header says {columns} x {rows}")
    heights = values.values.reshape(rows, columns).copy()
    heights[heights == head.get("nodata_value", _MISSING)] = np.nan
    west, south = head.get("xllcorner", head.get("xllcenter", 0.0)), head.get("yllcorner", head.get("yllcenter", 0.0))
    return _placed(heights, cell, "height map, ESRI grid", [], west, south, hints.degrees)


def read_pgm(data: bytes) -> Shape:
    """Read a grey picture, 8 or 16 bits, as heights.  A comment may give the cell's sides: "cell 24.5 m x 30.8 m"."""
    head = re.match(rb"(P[25])((?:\s+|#[^\n]*\n)+)(\d{1,9})((?:\s+|#[^\n]*\n)+)(\d{1,9})((?:\s+|#[^\n]*\n)+)(\d{1,9})\s", data)
    if head is None:
        raise ShapeError("not a PGM file, or its header is cut short")
    columns, rows, most = (int(head.group(i)) for i in (3, 5, 7))
    if columns < 2 or rows < 2 or not 0 < most < 65536:
        raise ShapeError(f"a height map of {columns} x {rows} heights up to {most} cannot be used")
    count, dtype = columns * rows, np.dtype(">u2" if most > 255 else "u1")
    if head.group(1) == b"P2":
        values = numbers(data[head.end() :], data.count(b"\n", 0, head.end()) + 1).values
    else:
        values = np.frombuffer(data, dtype, min(count, (len(data) - head.end()) // dtype.itemsize), head.end())
    if len(values) < count:
        raise ShapeError(f"the PGM file ends in the middle of its {columns} x {rows} heights, after {len(values)}")
    heights = values[:count].astype(np.float64).reshape(rows, columns)
    comments = b" ".join(head.group(i) for i in (2, 4, 6)).decode("latin-1")
    cell, scale, notes = _scale_of(comments, heights)
    return mesh(heights * scale, cell, "height map, PGM", notes)


def _scale_of(comments: str, heights: Floats) -> Tuple[Tuple[float, float], float, List[str]]:
    """The sides of a cell, the unit of heights relative to that of the sides, and notes."""
    found = re.search(r"cell\D*?(\d+(?:\.\d+)?)\s*m?[^\d#]*(\d+(?:\.\d+)?)?", comments)
    if found and float(found.group(1)) > 0:
        side = float(found.group(1))
        unit = 0.1 if "decimet" in comments else 0.01 if "centimet" in comments else 1.0
        return (side, float(found.group(2) or side)), unit, []
    scale, notes = _without_scale(heights)
    return (1.0, 1.0), scale, notes


def _without_scale(heights: Floats) -> Tuple[float, List[str]]:
    """The factor that makes the relief of heights of unknown unit a share of the longer side, and a note."""
    known = heights[np.isfinite(heights)]
    relief = float(np.ptp(known)) if len(known) else 0.0
    scale = _RELIEF * max(heights.shape) / relief if 0 < relief < math.inf else 1.0
    return scale, [f"the map gives no scale: its heights are set to {_RELIEF:.0%} of its longer side"]


def read_geotiff(path: Path) -> Shape:
    """Read the first band of a GeoTIFF."""
    return _raster(path, "GeoTIFF")


def read_dem(path: Path) -> Shape:
    """Read elevations in another format of rasterio: USGS DEM, SRTM, DTED, and formats with a separate header file."""
    return _raster(path, "DEM")


def _raster(path: Path, form: str) -> Shape:
    rasterio = needed("rasterio", form, "python3-rasterio", "gdal_translate -of AAIGrid makes a grid of it, .asc")
    import warnings

    notes: List[str] = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rasterio warns about pictures without a place on the Earth
        try:
            with rasterio.open(path) as source:
                step = max(1, math.ceil(math.sqrt(source.width * source.height / MOST_CELLS)))
                shape = (max(2, source.height // step), max(2, source.width // step))
                band: Any = source.read(1, out_shape=shape, masked=True)
                place = source.transform
                cell = (abs(place.a) * source.width / shape[1], abs(place.e) * source.height / shape[0])
                bounds, degrees = source.bounds, bool(source.crs.is_geographic) if source.crs else None
                size = (source.width, source.height)
        except Exception as error:  # the types differ between versions of rasterio
            raise ShapeError(f"rasterio cannot read it: {error}") from None
    if step > 1:
        notes.append(f"its {size[0]} x {size[1]} heights are reduced to {shape[1]} x {shape[0]}")
    filled: Any = np.ma.filled  # NumPy gives it no types
    heights = filled(band.astype(np.float64), np.nan)
    return _placed(heights, cell, f"height map, {form}", notes, bounds.left, bounds.bottom, degrees)
