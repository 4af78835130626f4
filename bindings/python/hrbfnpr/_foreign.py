# SPDX-License-Identifier: MIT
"""Meshes and point clouds of other packages, recognized by their documented attributes.  The packages are not imported.

PyVista: `points`; `faces`, one row in which each face is its number of corners and then the corners;
`point_data["Normals"]`; `extract_surface()` of grids.
trimesh: `vertices`; `faces` (m, 3) of a mesh, which a cloud does not have; `to_geometry()` or `dump(concatenate=True)` of a
scene.
Open3D: `vertices` and `triangles`, or `points` and `normals`; `to_legacy()` of its tensor geometry.
"""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .shapes import Shape, ShapeError
from .shapes._polygons import fans_of_row
from .shapes._shape import Floats, Integers


def shape_of(thing: Any) -> Shape:
    """The points, normals and triangles of arrays, or of a mesh or point cloud.

    Raises
    ------
    TypeError
        If the object is neither.
    """
    if isinstance(thing, Shape):
        return thing
    found = _of_scene(thing) or _of_tensors(thing) or _of_pyvista(thing) or _of_vertices(thing) or _of_points(thing)
    if found is not None:
        return found
    if isinstance(thing, (tuple, list, np.ndarray)):
        return _of_arrays(thing)
    raise TypeError(
        "draw a path, arrays as (points, normals) or (points, triangles), a Shape, Mesh, Model or PointSet, or a mesh, "
        f"cloud or scene of VTK, PyVista, trimesh or Open3D, not {type(thing).__name__}"
    )


def _floats(name: str, values: Any) -> Floats:
    array = np.array(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} must have the shape (n, 3), not {array.shape}")
    return array


def _normals_for(points: Floats, values: Any) -> Optional[Floats]:
    """The normals, or None if the array is empty: some packages have empty arrays instead of None."""
    if values is None or np.size(values) == 0:
        return None
    normals = _floats("normals", values)
    if len(normals) != len(points):
        raise ValueError(f"there are {len(points)} points and {len(normals)} normals")
    return normals


def _of_arrays(thing: Any) -> Shape:
    if isinstance(thing, np.ndarray) or len(thing) not in (1, 2) or np.ndim(thing[0]) != 2:
        return Shape(_floats("points", thing))
    points = _floats("points", thing[0])
    if len(thing) == 1 or thing[1] is None:
        return Shape(points)
    second = np.asarray(thing[1])
    if second.ndim == 2 and np.issubdtype(second.dtype, np.integer):
        return Shape(points, None, _corners(second))
    return Shape(points, _normals_for(points, second))


def _corners(faces: Any) -> Integers:
    array: Integers = np.array(faces, dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"triangles must have the shape (m, 3), not {array.shape}")
    if len(array) and array.min() < 0:
        raise ShapeError("arrays of integers are triangles, and this has a negative corner: give normals as floats")
    return array


def _of_scene(thing: Any) -> Optional[Shape]:
    """A scene of trimesh, as one mesh."""
    if not isinstance(getattr(thing, "geometry", None), dict):
        return None
    if hasattr(thing, "to_geometry"):
        return shape_of(thing.to_geometry())
    return shape_of(thing.dump(concatenate=True)) if hasattr(thing, "dump") else None


def _of_tensors(thing: Any) -> Optional[Shape]:
    """A tensor geometry of Open3D, converted to its legacy geometry."""
    return shape_of(thing.to_legacy()) if callable(getattr(thing, "to_legacy", None)) else None


def _of_pyvista(thing: Any) -> Optional[Shape]:
    if not hasattr(thing, "points") or not hasattr(thing, "point_data"):
        return None
    if not hasattr(thing, "faces"):
        if not callable(getattr(thing, "extract_surface", None)):
            return None
        return shape_of(thing.extract_surface())
    points, row = _floats("points", thing.points), np.asarray(thing.faces).reshape(-1)
    triangles = _unpacked(row, points)
    if triangles is not None:
        return Shape(points, None, triangles, "PyVista")
    data = thing.point_data
    return Shape(points, _normals_for(points, data["Normals"] if "Normals" in data else None), None, "PyVista")


def _unpacked(row: Any, points: Floats) -> Optional[Integers]:
    """Triangles from a row in which each polygon is its number of corners and then the corners."""
    if len(row) == 0:
        return None
    found = fans_of_row(row, points)
    return found if len(found) else None


def _of_vertices(thing: Any) -> Optional[Shape]:
    """A mesh of trimesh (`faces`) or Open3D (`triangles`), or a cloud of trimesh."""
    if not hasattr(thing, "vertices"):
        return None
    points = _floats("vertices", thing.vertices)
    faces = getattr(thing, "triangles" if hasattr(thing, "triangles") and not hasattr(thing, "faces") else "faces", None)
    if faces is None or np.size(faces) == 0:
        return Shape(points)
    return Shape(points, None, _corners(faces))


def _of_points(thing: Any) -> Optional[Shape]:
    """A cloud of Open3D."""
    if not hasattr(thing, "points") or isinstance(thing, np.ndarray):
        return None
    points = _floats("points", thing.points)
    return Shape(points, _normals_for(points, getattr(thing, "normals", None)))


def name_of(thing: Any) -> str:
    """The name of an object in messages and metadata."""
    return type(thing).__name__ if not isinstance(thing, (tuple, list, np.ndarray)) else "arrays"
