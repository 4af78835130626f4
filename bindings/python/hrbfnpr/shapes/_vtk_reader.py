# SPDX-License-Identifier: MIT
"""Turns data of VTK into arrays; as a program it reads a file with VTK: `python _vtk_reader.py READER FILE RESULT`.

The program is a separate process, which a damaged file may crash.  Its result is a file of NumPy with the arrays of
`arrays_of`, and `volume`, which says whether cells fill a volume.  If VTK finds no points, nothing is written.  This file
imports nothing from the package.
"""
import sys
from typing import Any, Dict

import numpy as np

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


def values_of(to_numpy: Any, attributes: Any) -> Dict[str, Any]:
    """The arrays of points or cells that hold one number, or three or four, for each."""
    found: Dict[str, Any] = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        name = attributes.GetArrayName(i)
        if array is None or not name or name.startswith("vtk") or array is attributes.GetNormals():
            continue
        if array.GetNumberOfComponents() in (1, 3, 4) and array.GetNumberOfTuples():
            found[name] = to_numpy(array)
    return found


def arrays_of(vtk: Any, to_numpy: Any, polygons: Any) -> Dict[str, Any]:
    """The points, triangles and normals of polygons, the number of lines, and the values of the points by name.

    Triangles and normals are empty if there are none.  If cells have values, each triangle gets points of its own.
    """
    normals = polygons.GetPointData().GetNormals()
    points = polygons.GetPoints()
    arrays = {
        "points": np.empty((0, 3)) if points is None else to_numpy(points.GetData()).astype(np.float64),
        "triangles": np.empty((0, 3), np.int64),
        "normals": np.empty((0, 3)) if normals is None else to_numpy(normals).astype(np.float64),
        "lines": polygons.GetNumberOfLines(),
    }
    if polygons.GetNumberOfPolys() or polygons.GetNumberOfStrips():
        cut = vtk.vtkTriangleFilter()
        cut.SetInputData(polygons)
        cut.PassVertsOff()
        cut.PassLinesOff()
        cut.Update()
        polygons = cut.GetOutput()
        faces = polygons.GetPolys()
        if faces.GetNumberOfCells():
            arrays["triangles"] = to_numpy(faces.GetData()).reshape(-1, 4)[:, 1:].astype(np.int64)
    corners, values = arrays["triangles"], values_of(to_numpy, polygons.GetPointData())
    of_cells = values_of(to_numpy, polygons.GetCellData()) if len(corners) else {}
    of_cells = {name: array for name, array in of_cells.items() if len(array) == len(corners) and name not in values}
    if of_cells:
        at = corners.reshape(-1)
        arrays["points"], arrays["triangles"] = arrays["points"][at], np.arange(len(at)).reshape(-1, 3)
        arrays["normals"] = np.empty((0, 3))
        values = {name: array[at] for name, array in values.items()}
        values.update({name: np.repeat(array, 3, axis=0) for name, array in of_cells.items()})
    arrays.update({FIELD + name: array for name, array in values.items()})
    return arrays


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
