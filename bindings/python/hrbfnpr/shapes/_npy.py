# SPDX-License-Identifier: MIT
"""Reads files of NumPy: an array of points, or several arrays by name."""
from __future__ import annotations

import io
import tokenize
import zipfile
import zlib
from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _heights
from ._attributes import COLOUR, PointValues, attributes, colours, scalars
from ._columns import Columns, by_content, by_heading
from ._degrees import NOTE, in_metres, points_are_degrees
from ._heights import LEAST_ROWS, MOST_COLUMNS
from ._shape import Floats, Shape, ShapeError
from ._xyz import UP, fields_of

_HINT = "give points as an array of n x 3 numbers; an .npz file may also hold arrays normals and triangles"
_POINTS = ("points", "point", "vertices", "verts", "vertex", "positions", "position", "pos", "xyz", "coords", "v", "arr_0")
_NORMALS = ("normals", "normal", "vertex_normals", "n", "vn")
_HEIGHTS = ("heights", "height", "elevation", "elevations", "dem", "dsm", "dtm", "z", "zz")
_EAST = ("x", "xx", "lon", "lons", "longitude", "easting")
_NORTH = ("y", "yy", "lat", "lats", "latitude", "northing")
_FACES = ("triangles", "faces", "face", "tri", "cells", "f")
_COLOURS = ("rgb", "colors", "colours", "color", "colour", "vertex_colors")


def read_npy(data: bytes) -> Shape:
    """Read one array with a point in each row; its columns are found like those of a table, or by field names."""
    return _points(_loaded(data), "NPY")


def read_npz(data: bytes) -> Shape:
    """Read several arrays by name."""
    archive = _loaded(data)
    try:
        arrays: Dict[str, Any] = {name.lower(): archive[name] for name in archive.files}
    except (ValueError, OSError, EOFError, RuntimeError, zipfile.BadZipFile, zlib.error) as error:
        raise ShapeError(f"not a usable NPZ file: {_first_line(error)}") from None
    place, normal, face = (_first(arrays, names) for names in (_POINTS, _NORMALS, _FACES))
    heights = _first(arrays, _HEIGHTS)
    if place is None and heights is not None and arrays[heights].ndim == 2 and arrays[heights].dtype.kind in "fiu":
        return _heights.of_axes(arrays[heights], *(arrays.get(_first(arrays, names) or "") for names in (_EAST, _NORTH)))
    if place is None:
        raise ShapeError(f"there is no array of points among {', '.join(sorted(arrays)) or 'none'}; {_HINT}")
    shape = _points(arrays[place], "NPZ")
    if shape.is_mesh:
        return shape  # a height map
    normals = _rows(arrays[normal], normal) if normal is not None else shape.normals
    if normals is not None and normals.shape != shape.points.shape:
        raise ShapeError(f"{normal} is {_shape(normals)}, but {place} is {_shape(shape.points)}")
    triangles = _triangles(arrays[face], face) if face is not None else None
    used = {place, normal, face}
    fields = {**shape.fields, **_fields({name: array for name, array in arrays.items() if name not in used}, len(shape.points))}
    return Shape(shape.points, normals, triangles, "NPZ", shape.columns, notes=shape.notes, fields=fields)


def _fields(arrays: Dict[str, Any], count: int) -> Dict[str, PointValues]:
    """The arrays with one number, or three, for each point: numbers, colours by their name, else directions."""
    fields: Dict[str, PointValues] = {}
    for name, array in arrays.items():
        if array.dtype.kind not in "fiub" or array.ndim == 0 or array.shape[0] != count:
            continue
        if array.ndim == 1 or array.shape[1:] == (1,):
            fields[name] = scalars(array)
        elif array.ndim == 2 and name in _COLOURS and array.shape[1] in (3, 4):
            fields[COLOUR] = colours(array)
        elif array.ndim == 2 and array.shape[1] == 3:
            fields[name] = PointValues("direction", array.astype(np.float32))
    return fields


def _loaded(data: bytes) -> Any:
    try:
        return np.load(io.BytesIO(data), allow_pickle=False)
    except (ValueError, OSError, EOFError, zipfile.BadZipFile, RuntimeError, MemoryError, SyntaxError,
            tokenize.TokenError) as error:  # fmt: skip
        raise ShapeError(f"not a usable NumPy file: {_first_line(error)}") from None


def _first_line(error: Exception) -> str:
    text = str(error)
    return "it holds Python objects; save numbers" if "allow_pickle" in text else text.split("\n")[0][:200]


def _first(arrays: Dict[str, Any], names: Tuple[str, ...]) -> Optional[str]:
    return next((name for name in names if name in arrays), None)


def _shape(array: Any) -> str:
    return " x ".join(map(str, array.shape)) or "a single number"


def _points(array: Any, form: str) -> Shape:
    if array.dtype.names:
        return _named(array, form)
    notes: Tuple[str, ...] = ()
    if array.ndim == 3 and 1 in (array.shape[0], array.shape[2]):  # one band of a picture
        array = array.reshape([side for k, side in enumerate(array.shape) if k == 1 or side != 1])
    if array.ndim == 2 and 3 <= array.shape[0] < LEAST_ROWS and array.shape[1] > MOST_COLUMNS:
        notes = (f"the array is {_shape(array)}: its columns are read as points",)
        array = array.T
    if array.ndim == 2 and array.dtype.kind in "fiu" and _heights.is_map(array):
        return _heights.of_array(array, form)
    table = _rows(array, "the array")
    columns = by_content(table)
    normals = columns.triple(("nx", "ny", "nz"))
    at = columns.triple("xyz")
    assert at is not None
    notes = (*notes, *columns.notes)
    return Shape(
        table[:, at], None if normals is None else table[:, normals], format=form, columns=columns.names, notes=notes,
        fields=fields_of(table, columns.names),
    )  # fmt: skip


def _named(array: Any, form: str) -> Shape:
    """A shape from an array with named fields."""
    columns: Optional[Columns] = by_heading(array.dtype.names)
    if columns is None:
        raise ShapeError(f"its records have no fields x, y and z; they have {', '.join(array.dtype.names)[:200]}")
    record = array.reshape(-1)

    def triple(names: Any) -> Optional[Floats]:
        assert columns is not None
        found = columns.triple(names)
        if found is None:
            return None
        return np.column_stack([_numbers(record[array.dtype.names[k]], array.dtype.names[k]) for k in found])

    points = triple("xyz")
    assert points is not None
    named = {name: record[own] for name, own in zip(columns.names, array.dtype.names)}
    fields = attributes({name: column for name, column in named.items() if column.dtype.kind in "fiub" and column.ndim == 1})
    degrees = columns.degrees and points_are_degrees(points, True)
    return Shape(
        in_metres(points) if degrees else points, triple(("nx", "ny", "nz")), format=f"map, {form}" if columns.on_map else form,
        columns=columns.names, up=UP if columns.on_map else None, notes=(NOTE,) if degrees else (), fields=fields,
    )  # fmt: skip


def _numbers(array: Any, name: str) -> Floats:
    if array.dtype.kind not in "fiu":
        raise ShapeError(f"{name} holds {array.dtype}, not numbers; {_HINT}")
    return np.asarray(array, dtype=np.float64)


def _rows(array: Any, name: str) -> Floats:
    """The rows of an array n x 3 or wider, or the pixels of a picture h x w x 3, row by row."""
    if array.ndim < 2 or array.shape[-1] < 3:
        raise ShapeError(f"{name} is {_shape(array)}; {_HINT}")
    return _numbers(array, name).reshape(-1, array.shape[-1])


def _triangles(array: Any, name: str) -> Any:
    if array.dtype.kind not in "iu" or array.ndim != 2 or array.shape[1] not in (3, 4):
        raise ShapeError(f"{name} is {_shape(array)} and holds {array.dtype}; faces are n x 3 whole numbers, from 0")
    corners = array.astype(np.int64)
    return corners if corners.shape[1] == 3 else np.vstack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
