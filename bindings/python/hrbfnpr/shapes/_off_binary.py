# SPDX-License-Identifier: MIT
"""Reads OFF meshes in binary form [Geomview's manual, OFF files]: counts, vertices, and faces with their number of corners."""
from __future__ import annotations

from typing import Any, List

import numpy as np

from ._polygons import fans
from ._shape import Floats, Shape, ShapeError
from ._table import out_of_range


def read(kind: str, data: bytes) -> Shape:
    """Read what follows the line OFF BINARY.  Geomview writes big-endian numbers, and colours after faces; others do not."""
    width = {"OFF": 3, "NOFF": 6}.get(kind)
    if width is None:
        raise ShapeError(f"binary OFF files of the kind {kind!r} are not read: save it as text, or as PLY")
    if len(data) < 12:
        raise ShapeError("the OFF file lacks its counts")
    for order in ("<", ">"):
        counts = np.frombuffer(data, order + "i4", 3)
        vertices, faces = int(counts[0]), int(counts[1])
        if vertices < 0 or faces < 0 or 12 + 4 * width * vertices + 4 * faces > len(data):
            continue
        begin = 12 + 4 * width * vertices
        words = np.frombuffer(data[begin : begin + (len(data) - begin) // 4 * 4], order + "i4").astype(np.int64)
        table = np.frombuffer(data, order + "f4", width * vertices, 12).reshape(-1, width).astype(np.float64)
        for coloured in (False, True):
            polygons = _polygons(words, faces, coloured)
            if polygons is not None:
                return _shape(table, polygons)
    raise ShapeError("the OFF file is damaged: it is too short or too long for its vertices and faces")


def _polygons(words: Any, faces: int, coloured: bool) -> Any:
    """The corners of each face, or None if the words are not exactly this number of faces."""
    each = 5 if coloured else 4
    if len(words) == each * faces and (words[0::each] == 3).all() and (not coloured or not words[4::each].any()):
        return words.reshape(-1, each)[:, 1:4]  # only triangles, without colours: one array
    found: List[Any] = []
    at = 0
    while len(found) < faces:
        if at >= len(words) or not 0 <= words[at] < len(words) - at:
            return None
        end = at + 1 + int(words[at])
        found.append(words[at + 1 : end])
        if coloured:
            if end >= len(words) or not 0 <= words[end] <= 4:
                return None
            end += 1 + int(words[end])
        at = end
    return found if at == len(words) else None


def _shape(table: Floats, polygons: Any) -> Shape:
    corners = np.concatenate([np.zeros(0, np.int64), *polygons]) if isinstance(polygons, list) else polygons.reshape(-1)
    wrong = corners[(corners < 0) | (corners >= len(table))]
    if len(wrong):
        raise ShapeError(out_of_range(int(wrong[0]), len(table), 0))
    points, normals = table[:, :3], table[:, 3:] if table.shape[1] == 6 else None
    triangles = fans(polygons, points) if isinstance(polygons, list) else polygons
    columns = ("x", "y", "z", "nx", "ny", "nz")[: table.shape[1]]
    return Shape(points, normals, triangles if len(triangles) else None, "OFF", columns)
