# SPDX-License-Identifier: MIT
"""Turns data of VTK into arrays; as a program it reads a file with VTK: `python _vtk_reader.py READER FILE RESULT`.

The program is a separate process, which a damaged file may crash.  Its result is a file of NumPy with the arrays of
`arrays_of`, and `volume`, which says whether cells fill a volume.  If VTK finds no points, nothing is written.  This file
imports nothing from the package.
"""
import sys
from typing import Any, Dict

import numpy as np

OF_FACES = "face:"  # the names of arrays with values of faces begin with this
FIELD = "field:"  # the beginning of the names of arrays with values of the points


def polygons_of(vtk: Any, data: Any) -> Any:
    """The outer faces.  Faces of cells with nodes between their corners are divided at these nodes."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.SetNonlinearSubdivisionLevel(1)
    surface.Update()
    return surface.GetOutput()


def fills_a_volume(vtk: Any, cells: Any) -> bool:
    kinds, cell = vtk.vtkCellTypes(), vtk.vtkGenericCell()
    cells.GetCellTypes(kinds)
    for i in range(kinds.GetNumberOfTypes()):
        cell.SetCellType(kinds.GetCellType(i))
        if cell.GetCellDimension() == 3:
            return True
    return False


def scene_of(vtk: Any, importer: Any) -> Any:
    """The polygons of a scene, each at its place."""
    importer.Read()
    actors, together = importer.GetRenderer().GetActors(), vtk.vtkAppendPolyData()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        actor.GetMapper().Update()
        place, moved = vtk.vtkTransform(), vtk.vtkTransformPolyDataFilter()
        place.SetMatrix(actor.GetMatrix())
        moved.SetTransform(place)
        moved.SetInputData(actor.GetMapper().GetInput())
        moved.Update()
        together.AddInputData(moved.GetOutput())
    together.Update()
    return together.GetOutput()


def normals_of(attributes: Any) -> Any:
    """The active normals, or those by the name that PyVista and filters of VTK give them; None if there are none."""
    named = attributes.GetArray("Normals")
    given = attributes.GetNormals()
    return given if given is not None else named if named is not None and named.GetNumberOfComponents() == 3 else None


def values_of(to_numpy: Any, attributes: Any) -> Dict[str, Any]:
    """The arrays of points or cells that hold one number, or three or four, for each."""
    found: Dict[str, Any] = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        name = attributes.GetArrayName(i)
        if array is None or not name or name.startswith("vtk") or array is normals_of(attributes):
            continue
        if array.GetNumberOfComponents() in (1, 3, 4) and array.GetNumberOfTuples():
            found[name] = to_numpy(array)
    return found


def arrays_of(vtk: Any, to_numpy: Any, polygons: Any) -> Dict[str, Any]:
    """The points, faces and normals of polygons, the number of lines, and the values of points and faces by name.

    `polygons` and `strips` are rows of integers: for each face or triangle its number of corners, and then the corners.  The
    values of faces are those of all polygons and then of all strips.  Arrays are empty if there is nothing in them.
    """
    normals = normals_of(polygons.GetPointData())
    points = polygons.GetPoints()
    strips = vtk.vtkPolyData()  # only strips are cut here
    strips.SetPoints(points)
    strips.SetStrips(polygons.GetStrips())
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(strips)
    triangles.Update()
    arrays = {
        "points": np.empty((0, 3)) if points is None else to_numpy(points.GetData()).astype(np.float64),
        "normals": np.empty((0, 3)) if normals is None else to_numpy(normals).astype(np.float64),
        "lines": polygons.GetNumberOfLines(),
    }
    for name, faces in (("polygons", polygons.GetPolys()), ("strips", triangles.GetOutput().GetPolys())):
        has_some = faces is not None and faces.GetNumberOfCells() > 0
        arrays[name] = to_numpy(faces.GetData()).astype(np.int64) if has_some else np.empty(0, np.int64)
    of_points = values_of(to_numpy, polygons.GetPointData())
    before = polygons.GetNumberOfVerts() + polygons.GetNumberOfLines()
    of_faces = {name: array[before:] for name, array in values_of(to_numpy, polygons.GetCellData()).items()}
    arrays["corners"] = corners_of(to_numpy, polygons.GetPolys()) + corners_of(to_numpy, polygons.GetStrips())
    arrays.update({FIELD + name: array for name, array in of_points.items()})
    arrays.update({OF_FACES + name: array for name, array in of_faces.items() if len(array) and name not in of_points})
    return arrays


def corners_of(to_numpy: Any, cells: Any) -> Any:
    """The number of corners of each cell."""
    row, counts, at = [] if cells is None else to_numpy(cells.GetData()).tolist(), [], 0
    while at < len(row):
        counts.append(int(row[at]))
        at += counts[-1] + 1
    return counts


def read(kind: str, path: str, result: str) -> None:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    reader = getattr(vtk, kind)()
    reader.SetFileName(path)
    if kind.endswith("Importer"):
        data = scene_of(vtk, reader)
    else:
        reader.Update()
        data = reader.GetOutput()
    if data is None or data.GetNumberOfPoints() == 0:
        return
    volume = not data.IsA("vtkPolyData") and fills_a_volume(vtk, data)
    data = data if data.IsA("vtkPolyData") else polygons_of(vtk, data)
    np.savez(result, volume=volume, **arrays_of(vtk, vtk_to_numpy, data))


if __name__ == "__main__":
    read(*sys.argv[1:])
