# SPDX-License-Identifier: MIT
"""Which edges of a mesh are meant to be sharp: those whose faces have normals of their own in the file.

Programs that make models shade them so: faces share normals along edges that bend by up to some angle ("auto smooth",
"smoothing groups"), and have their own along others.
"""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._shape import Floats, Integers

MOST_FACES = 50_000  # edges of finer meshes are told from their faces
_OWN = np.cos(np.radians(1.0))  # of normals that are not shared


def sharp_edges(points: Floats, triangles: Integers, normals: Floats) -> Optional[Integers]:
    """Edges of two faces that have normals of their own there, as numbers of vertices, shape (k, 2).

    Vertices at one place are one. `normals` are those at the corners of each triangle, shape (m, 3, 3). None of meshes
    that are too fine to need it.
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
    """The same of vertices with normals: there are several at a place where a face has its own."""
    if not 0 < len(triangles) <= MOST_FACES or triangles.min() < 0 or triangles.max() >= len(points):
        return None
    return sharp_edges(points, triangles, normals[triangles])


class _Sides:
    """The sides of triangles, all 0-1 first; `one` and `other` are those of edges of two faces."""

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
        return np.minimum(begin, end) * (int(self._vertex.max()) + 1) + np.maximum(begin, end)


def _unit(vectors: Floats) -> Floats:
    """Zeros and what is not finite become NaN."""
    with np.errstate(invalid="ignore", divide="ignore"):
        units: Floats = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return units
