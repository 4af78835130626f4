# SPDX-License-Identifier: MIT
"""What a file of points or a mesh holds."""
from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]
Vector = Tuple[float, float, float]


class ShapeError(ValueError):
    """A file cannot be used; the message says why."""


@dataclass(frozen=True)
class Shape:
    """Points, perhaps with normals, perhaps joined to triangles.

    Attributes
    ----------
    points : array of float64, shape (n, 3)
    normals : array of float64, shape (n, 3), or None
    triangles : array of int64, shape (m, 3), or None
    format : str
        What it was read from, such as ``"PLY, ascii"``; empty if it was not read.
    columns : tuple of str
        What the file has for each point, in its order, such as ``("x", "y", "z", "red", "green", "blue")``.
    up : tuple of float, or None
        The direction that is up by the convention of the format, if it has one, or by what the file is.
    is_picture : bool
        Whether the points are one picture of a depth camera, which stood at `viewpoint`.
    image_shape : tuple of int, or None
        Rows and columns of that picture, where there is a point for each pixel, row by row: what
        `hrbfnpr.smooth_depth_image` takes as ``points.reshape(*image_shape, 3)``.
    viewpoint : tuple of float, or None
        Where the scanner stood, of points that it saw from one place, if the file tells.
    sharp_edges : array of int64, shape (k, 2), or None
        Of a mesh whose file gives its corners normals: edges, as numbers of vertices, along which faces have normals of
        their own; along others they share them. None where there are no normals, or more than 50 000 faces.
    notes : tuple of str
        What was left out or taken for something while it was read.
    """

    points: Floats
    normals: Optional[Floats] = None
    triangles: Optional[Integers] = None
    format: str = ""
    columns: Tuple[str, ...] = ()
    up: Optional[Vector] = None
    notes: Tuple[str, ...] = ()
    viewpoint: Optional[Vector] = None
    is_picture: bool = False
    image_shape: Optional[Tuple[int, int]] = None
    sharp_edges: Optional[Integers] = None

    def __post_init__(self) -> None:
        if len(self.points) == 0:
            raise ShapeError("there are no points")
        if self.triangles is not None and len(self.triangles) > 0:
            low, high = int(self.triangles.min()), int(self.triangles.max())
            if low < 0 or high >= len(self.points):
                wrong = low if low < 0 else high
                raise ShapeError(f"a face names vertex {wrong}, but there are only {len(self.points)} vertices")

    @property
    def is_mesh(self) -> bool:
        """Whether there are faces."""
        return self.triangles is not None and len(self.triangles) > 0


def strips(indices: Sequence[int]) -> Integers:
    """Triangles of strips: every second one turned; -1 ends a strip."""
    result: List[Tuple[int, int, int]] = []
    strip: List[int] = []
    for index in [*indices, -1]:
        if index >= 0:
            strip.append(index)
            continue
        for i in range(len(strip) - 2):
            a, b, c = strip[i : i + 3]
            if a != b and b != c and a != c:
                result.append((a, b, c) if i % 2 == 0 else (b, a, c))
        strip = []
    return np.array(result, dtype=np.int64).reshape(-1, 3)
