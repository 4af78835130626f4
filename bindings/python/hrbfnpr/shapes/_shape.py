# SPDX-License-Identifier: MIT
"""The contents of a file with points or a mesh."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._attributes import PointValues

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Integers = NDArray[np.int64]
else:  # NumPy before 1.20 has no numpy.typing
    Floats = Integers = np.ndarray
Vector = Tuple[float, float, float]


class Hints(NamedTuple):
    """What the caller of a reader knows about a file besides its contents.

    `normals`: whether the ending promises normals.  `degrees`: whether x and y are degrees, by a file beside it; None if
    there is none.  `classes`: the classes of the points to keep, () for all, None for the reader's choice.
    """

    normals: bool = False
    degrees: Optional[bool] = None
    classes: Optional[Tuple[int, ...]] = None


class ShapeError(ValueError):
    """A file cannot be used.  The message says why."""


@dataclass(frozen=True)
class Shape:
    """Points, with normals or triangles if they are known.

    Attributes
    ----------
    points : array of float64, shape (n, 3)
        The points, or the vertices of a mesh.
    normals : array of float64, shape (n, 3), or None
        The normals of the points.
    triangles : array of int64, shape (m, 3), or None
        The numbers of the vertices of each face, from 0.
    format : str
        The format of the file, such as ``"PLY, ascii"``; empty if the shape does not come from a file.
    columns : tuple of str
        What the file holds for each point, in order, such as ``("x", "y", "z", "red", "green", "blue")``.
    up : tuple of float, or None
        The up direction, by the convention of the format or by the kind of file.
    is_picture : bool
        Whether the points are one picture of a depth camera at `viewpoint`.
    image_shape : tuple of int, or None
        Rows and columns of that picture, if there is a point for each pixel, row by row.  Then
        ``points.reshape(*image_shape, 3)`` is the argument of `hrbfnpr.smooth_depth_image`.
    viewpoint : tuple of float, or None
        The place of the scanner, if the points were seen from one place and the file tells it.
    sharp_edges : array of int64, shape (k, 2), or None
        For a mesh with normals at its corners: the edges, as numbers of two vertices, at which the two faces have different
        normals.  None without such normals, and for more than 50 000 faces.
    notes : tuple of str
        What the reader left out or assumed.
    fields : mapping of str to PointValues
        Values of the points by name, such as "rgb", "quality" and "intensity", which the option `field` of a drawing names.
    radii : array of float64, shape (n,), or None
        Radii of balls around the points, such as the atoms of a molecule.  The union of the balls is drawn.
    unit : str
        The unit of lengths, such as "angstroms", if the file or its format says it; else empty.  Points keep this unit.
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
    fields: Mapping[str, PointValues] = field(default_factory=dict)
    radii: Optional[Floats] = None
    unit: str = ""

    def __post_init__(self) -> None:
        if len(self.points) == 0:
            raise ShapeError("there are no points")
        if self.triangles is not None and len(self.triangles) > 0:
            low, high = int(self.triangles.min()), int(self.triangles.max())
            if low < 0 or high >= len(self.points):
                wrong = low if low < 0 else high
                raise ShapeError(f"a face names vertex {wrong}, but there are only {len(self.points)} vertices")

        for name, one in self.fields.items():
            if len(one.values) != len(self.points):
                raise ShapeError(f"there are {len(self.points)} points and {len(one.values)} values of {name}")

    @property
    def is_mesh(self) -> bool:
        """Whether there are faces."""
        return self.triangles is not None and len(self.triangles) > 0


def strips(indices: Sequence[int]) -> Integers:
    """Triangles of strips.  Every second triangle is turned; -1 ends a strip."""
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
