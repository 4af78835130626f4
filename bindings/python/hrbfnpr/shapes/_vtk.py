# SPDX-License-Identifier: MIT
"""VTK's own files and others that meshio, or VTK itself, reads."""
from __future__ import annotations

import contextlib
import io
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._optional import needed
from ._polygons import fans, fans_of_block
from ._shape import Floats, Integers, Shape, ShapeError

# Faces of cells, seen from outside.
_FACES = {
    "tetra": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    "hexahedron": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    "wedge": [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]],
    "pyramid": [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
}
_OTHERWISE = "ParaView or MeshLab saves it as PLY"


def read_vtp(path: Path) -> Shape:
    """Polygons of VTK's XML files."""
    vtk = needed("vtk", "VTP", "python3-vtk9", _OTHERWISE)
    return _polydata(vtk, vtk.vtkXMLPolyDataReader(), path, "VTP")


def read_vtk(path: Path) -> Shape:
    """VTK's older files: polygons by VTK, other kinds by meshio."""
    with open(path, "rb") as file:
        head = file.read(1000).upper()
    if b"POLYDATA" in head:
        vtk = needed("vtk", "polygons of VTK", "python3-vtk9", _OTHERWISE)
        return _polydata(vtk, vtk.vtkPolyDataReader(), path, "VTK")
    return read_meshio(path, "VTK")


def _polydata(vtk: Any, reader: Any, path: Path, form: str) -> Shape:
    from importlib import import_module

    to_numpy = import_module("vtk.util.numpy_support").vtk_to_numpy
    vtk.vtkObject.GlobalWarningDisplayOff()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    if data is None or data.GetNumberOfPoints() == 0:
        raise ShapeError("VTK finds no points in it: it is damaged, or empty")
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    faces = triangles.GetOutput().GetPolys()
    count = faces.GetNumberOfCells()
    points: Floats = to_numpy(data.GetPoints().GetData()).astype(np.float64)
    if count:
        index: Integers = to_numpy(faces.GetData()).reshape(count, 4)[:, 1:].astype(np.int64)
        return Shape(points, None, index, form, ("x", "y", "z"))
    normals = data.GetPointData().GetNormals()
    given: Optional[Floats] = None if normals is None else to_numpy(normals).astype(np.float64)
    return Shape(points, given, None, form, ("x", "y", "z") if given is None else ("x", "y", "z", "nx", "ny", "nz"))


def read_meshio(path: Path, form: str = "") -> Shape:
    """Whatever else meshio knows: triangles and polygons, or the outer faces of cells."""
    path.stat()  # a missing file is an OSError like everywhere, whatever meshio makes of it
    meshio = needed("meshio", form or f"{path.suffix} files", "python3-meshio", _OTHERWISE)
    try:
        # meshio reports some failures on stdout and ends the process.
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            mesh = meshio.read(path)
    except (Exception, SystemExit) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ShapeError(f"meshio cannot read it: {reason}; {_OTHERWISE}") from error
    points = np.asarray(mesh.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ShapeError("its points are not in three dimensions")
    parts: List[Integers] = [
        fans_of_block(block.data, points).reshape(-1, 3)
        for block in mesh.cells
        if block.type in ("triangle", "quad") or block.type.startswith("polygon")
    ]
    notes: Tuple[str, ...] = ()
    if not parts:
        outer = _outer(mesh.cells)
        parts = [outer] if len(outer) else []
        notes = ("its cells fill a volume: their outer faces are used",) if parts else ()
    normals = mesh.point_data.get("Normals", mesh.point_data.get("normals"))
    given = None if parts or normals is None else np.asarray(normals, dtype=np.float64)
    columns = ("x", "y", "z") if given is None else ("x", "y", "z", "nx", "ny", "nz")
    triangles = np.concatenate(parts) if parts else None
    return Shape(points, given, triangles, form or path.suffix[1:].upper(), columns, notes=notes)


def _outer(blocks: Any) -> Integers:
    """Triangles of the faces that one cell only has."""
    faces: Dict[Tuple[int, ...], List[int]] = {}
    for block in blocks:
        for cell in np.asarray(block.data).tolist() if block.type in _FACES else ():
            for corners in _FACES[block.type]:
                face = [cell[i] for i in corners]
                key = tuple(sorted(face))
                if faces.pop(key, None) is None:
                    faces[key] = face
    return fans(faces.values())
