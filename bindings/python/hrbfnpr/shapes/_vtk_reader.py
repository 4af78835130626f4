# SPDX-License-Identifier: MIT
"""Reads a file with VTK in a separate process, which a damaged file may crash: `python _vtk_reader.py READER FILE RESULT`.

The result is a file of NumPy: points, triangles, normals (empty if there are none), the number of lines, and whether cells
fill a volume.  If VTK finds no points, nothing is written.  This file imports nothing from the package.
"""
import sys
from typing import Any

import numpy as np


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
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    faces = triangles.GetOutput().GetPolys()
    corners = vtk_to_numpy(faces.GetData()).reshape(-1, 4)[:, 1:] if faces.GetNumberOfCells() else np.empty((0, 3))
    normals = data.GetPointData().GetNormals()
    np.savez(
        result,
        points=vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64),
        triangles=corners.astype(np.int64),
        normals=np.empty((0, 3)) if normals is None else vtk_to_numpy(normals).astype(np.float64),
        lines=data.GetNumberOfLines(),
        volume=volume,
    )


if __name__ == "__main__":
    read(*sys.argv[1:])
