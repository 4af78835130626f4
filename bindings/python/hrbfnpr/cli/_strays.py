# SPDX-License-Identifier: MIT
"""Points that lie far from all others: of a scanner's dust they make sheets, and nobody can give them normals."""
from __future__ import annotations

from typing import Any

import numpy as np

FEWEST = 200  # of fewer points none is told from others
CROWD = 24  # points in the cell of half of all points
ALONE = 3  # as many in a cell and those around it: half of all have a hundred and more
MOST = 0.1  # share of all: if there are more, points lie as unevenly as that
_BITS = 21
_AROUND = (-1, 0, 1)


def find(points: Any) -> Any:
    """Which of the finite points, shape (n, 3), are strays: bool of shape (n,)."""
    none = np.zeros(len(points), dtype=bool)
    if len(points) < FEWEST:
        return none
    low = points.min(axis=0)
    diagonal = float(np.linalg.norm(points.max(axis=0) - low))
    side = diagonal / len(points) ** 0.5
    while side > 0:
        keys = _keys((points - low) / side)
        cells, cell_of, counts = np.unique(keys, return_inverse=True, return_counts=True)
        if np.median(counts[cell_of]) >= CROWD:
            break
        side *= 1.3
    else:
        return none
    around = np.zeros(len(cells), dtype=np.int64)
    for x in _AROUND:
        for y in _AROUND:
            for z in _AROUND:
                wanted = cells + ((x << 2 * _BITS) + (y << _BITS) + z)
                place = np.minimum(np.searchsorted(cells, wanted), len(cells) - 1)
                around += np.where(cells[place] == wanted, counts[place], 0)
    alone = around[cell_of.reshape(-1)] <= ALONE
    return alone if alone.sum() <= MOST * len(points) else none


def _keys(places: Any) -> Any:
    """Of the cells that hold places >= 0, in the order x, y, z; cells beside each other have numbers beside."""
    x, y, z = np.minimum(places, 2.0**_BITS - 3).astype(np.int64).T + 1
    return (x << 2 * _BITS) + (y << _BITS) + z
