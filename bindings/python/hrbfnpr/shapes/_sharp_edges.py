# SPDX-License-Identifier: MIT
"""Finds the edges of a mesh that are meant to be sharp: those whose two faces have different normals in the file.

Modelling programs write normals in this way ("auto smooth", "smoothing groups"): two faces share normals along an edge that
bends by less than some angle, and have different normals along other edges.
"""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._shape import Floats, Integers

MOST_FACES = 50_000  # meshes with more faces do not need the normals: their faces show the sharp edges
_OWN = np.cos(np.radians(1.0))  # normals that differ by more than this angle are not shared


def sharp_edges(points: Floats, triangles: Integers, normals: Floats) -> Optional[Integers]:
    """The edges at which two faces have different normals, as numbers of vertices, shape (k, 2).

    Vertices at the same place count as one.  `normals` are those at the corners of each triangle, shape (m, 3, 3).  None for
    meshes with more than MOST_FACES faces.
    """
    if not 0 < len(triangles) <= MOST_FACES:
        return None
    sides = _Sides(points, triangles)
    given = _unit(np.asarray(normals, dtype=float))
    begin = given.transpose(1, 0, 2).reshape(-1, 3)
    end = np.roll(given, -1, axis=1).transpose(1, 0, 2).reshape(-1, 3)
    low, high = (np.where(sides.turned[:, None], *pair) for pair in ((end, begin), (begin, end)))
    cosine = np.stack([(at[sides.one] * at[sides.other]).sum(axis=1) for at in (low, high)])
    known = np.isfinite(cosine).all(axis=0)
    own: Any = known & (cosine < _OWN).any(axis=0)
    first = triangles.T.reshape(-1)
    second = np.roll(triangles, -1, axis=1).T.reshape(-1)
    return np.column_stack([first, second])[sides.one[own]] if known.any() else None


def of_vertices(points: Floats, triangles: Integers, normals: Floats) -> Optional[Integers]:
    """The same for normals of vertices.  Where faces have different normals, there are several vertices at one place."""
    if not 0 < len(triangles) <= MOST_FACES or triangles.min() < 0 or triangles.max() >= len(points):
        return None
    return sharp_edges(points, triangles, normals[triangles])


class _Sides:
    """The sides of triangles, first all sides from corner 0 to 1.  `one` and `other` are the two sides of an inner edge."""

    def __init__(self, points: Floats, triangles: Integers) -> None:
        self._vertex = np.unique(points, axis=0, return_inverse=True)[1].reshape(-1)
        vertex = self._vertex[triangles]
        begin, end = vertex.T.reshape(-1), np.roll(vertex, -1, axis=1).T.reshape(-1)
        self.turned = begin > end
        self.name = self._name(begin, end)
        order = np.argsort(self.name, kind="stable")
        first = np.flatnonzero(np.diff(self.name[order], prepend=-1))
        first = first[np.diff(first, append=len(order)) == 2]
        self.one, self.other = order[first], order[first + 1]
        edges = begin[self.one] != end[self.one]
        self.one, self.other = self.one[edges], self.other[edges]

    def _name(self, begin: Integers, end: Integers) -> Integers:
        name: Integers = np.minimum(begin, end) * (int(self._vertex.max()) + 1) + np.maximum(begin, end)
        return name


def _unit(vectors: Floats) -> Floats:
    """Unit vectors; NaN for vectors that are 0 or not finite."""
    with np.errstate(invalid="ignore", divide="ignore"):
        units: Floats = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return units
