# SPDX-License-Identifier: MIT
"""Reads VTK's formats and others, with VTK or meshio."""
from __future__ import annotations

import contextlib
import io
import re
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._attributes import values_of
from ._optional import is_here, needed, run
from ._polygons import fans, fans_of_block, fans_of_row
from ._shape import Floats, Integers, Shape, ShapeError
from ._vtk_reader import FIELD, OF_FACES

# The faces of cells, as seen from outside, and the cells with an additional node in the middle of each edge, which is ignored.
_FACES = {
    "tetra": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    "hexahedron": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    "wedge": [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]],
    "pyramid": [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
}
_CORNERS = {
    "triangle": 3, "triangle6": 3, "triangle7": 3, "quad": 4, "quad8": 4, "quad9": 4,
    "tetra": 4, "tetra10": 4, "hexahedron": 8, "hexahedron20": 8, "hexahedron24": 8, "hexahedron27": 8,
    "wedge": 6, "wedge15": 6, "wedge18": 6, "pyramid": 5, "pyramid13": 5, "pyramid14": 5,
}  # fmt: skip
_NO_SURFACE = ("vertex", "line")  # and their variants with more nodes
_VOLUME = "its cells fill a volume: their outer faces are used"
_OTHERWISE = "ParaView or MeshLab saves it as PLY"




def read_vtp(path: Path) -> Shape:
    """Read polygons from VTK's XML files."""
    _need_vtk("VTP")
    return _by_vtk("vtkXMLPolyDataReader", path, "VTP")


def read_mni(path: Path) -> Shape:
    """Read surfaces of the tools of the Montreal Neurological Institute, whose files end in .obj, too."""
    _need_vtk("MNI objects")
    return _by_vtk("vtkMNIObjectReader", path, "MNI object")


def read_vrml(path: Path) -> Shape:
    """Read scenes of VRML 97 (version 2)."""
    with open(path, "rb") as file:
        if file.read(8) == b"#VRML V1":
            raise ShapeError("it is VRML of version 1, which is not read; MeshLab saves it as PLY")
    _need_vtk("VRML")
    return _by_vtk("vtkVRMLImporter", path, "VRML")


def read_vtk(path: Path) -> Shape:
    """Read VTK's legacy files: polygons with VTK, other kinds with VTK or meshio."""
    with open(path, "rb") as file:
        head = file.read(1000).upper()
    if b"POLYDATA" in head:
        _need_vtk("polygons of VTK")
        return _by_vtk("vtkPolyDataReader", path, "VTK")
    if b"STRUCTURED_POINTS" in head:
        raise ShapeError("it holds a volume: make a surface with ParaView's Contour and save it as PLY")
    return _cells("vtkDataSetReader", path, "VTK")


def read_vtu(path: Path) -> Shape:
    """Read cells from VTK's XML files."""
    return _cells("vtkXMLUnstructuredGridReader", path, "VTU")


def _cells(reader: str, path: Path, form: str) -> Shape:
    """Read cells with VTK if it is installed, because it reads all that it writes; else with meshio."""
    return _by_vtk(reader, path, form) if is_here("vtk") and sys.executable else read_meshio(path, form)


def _need_vtk(what: str) -> None:
    if not is_here("vtk"):
        needed("vtk", what, "python3-vtk9", _OTHERWISE)
    if not sys.executable:
        raise ShapeError(f"reading {what} needs a Python interpreter, and this program does not know one: {_OTHERWISE}")


def _by_vtk(reader: str, path: Path, form: str) -> Shape:
    """Read a file with VTK in a separate process, which a damaged file may crash."""
    path.stat()  # so that a missing file is an OSError, as in all readers
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result.npz"
        script = Path(__file__).with_name("_vtk_reader.py")
        command = [sys.executable, str(script), reader, str(path.resolve()), str(result)]
        done = run("VTK", command, _OTHERWISE)
        if done.returncode:
            raise ShapeError(f"VTK crashed on it: it is damaged; {_OTHERWISE}")
        stopped = re.search(rb"near line (\d+): parse error", done.stdout + done.stderr)
        where = f"VTK cannot read on from line {int(stopped[1]) + 1}" if stopped else ""
        if not result.exists():
            raise ShapeError(f"VTK finds no points in it: {where or 'it is damaged, or empty'}")
        with np.load(result) as found:
            shape = _shape_of(found, form)
    return replace(shape, notes=(*shape.notes, f"{where}: the rest may be missing; {_OTHERWISE}")) if where else shape


def _shape_of(found: Any, form: str) -> Shape:
    if has_faces(found):
        return shape_of_arrays(found, form, (_VOLUME,) if found["volume"] else ())
    count = int(found["lines"])
    return shape_of_arrays(found, form, (f"it has {count} lines and no faces: their points are used",) if count else ())


def has_faces(found: Any) -> bool:
    """Whether arrays that `_vtk_reader.arrays_of` made have faces."""
    return bool((np.asarray(found["corners"]) > 2).any())


def shape_of_arrays(found: Any, form: str, notes: Tuple[str, ...] = ()) -> Shape:
    """The shape of the arrays that `_vtk_reader.arrays_of` makes.  Three floats for each point are a direction.

    If faces have values, each triangle gets points of its own.
    """
    points, normals = found["points"], found["normals"]
    triangles = np.concatenate([fans_of_row(found[name], points) for name in ("polygons", "strips")])
    given: Optional[Floats] = normals if len(normals) == len(points) and not len(triangles) else None
    columns = ("x", "y", "z") if given is None else ("x", "y", "z", "nx", "ny", "nz")
    values = {name[len(FIELD) :]: found[name] for name in found if name.startswith(FIELD)}
    values = {name: array for name, array in values.items() if len(array) == len(points)}
    corners = np.asarray(found["corners"], dtype=np.int64)
    of_faces = {name[len(OF_FACES) :]: found[name] for name in found if name.startswith(OF_FACES)}
    of_faces = {name: array for name, array in of_faces.items() if len(array) == len(corners)}
    if of_faces and len(triangles):
        at = triangles.reshape(-1)
        points, triangles = points[at], np.arange(len(at)).reshape(-1, 3)
        values = {name: array[at] for name, array in values.items()}
        copies = 3 * np.maximum(corners - 2, 0)
        values.update({name: np.repeat(array, copies, axis=0) for name, array in of_faces.items()})
    fields = {}
    for name, array in values.items():
        if array.dtype.kind in "fiub":
            is_direction = array.shape[1:] == (3,) and array.dtype.kind == "f"
            fields[name] = values_of(name, array, len(points), is_direction)
    return Shape(points, given, triangles if len(triangles) else None, form, columns, notes=notes, fields=fields)


def read_meshio(path: Path, form: str = "") -> Shape:
    """Read any other format of meshio: triangles and polygons, or the outer faces of cells."""
    path.stat()  # so that a missing file is an OSError, as in all readers
    meshio = needed("meshio", form or f"{path.suffix} files", "python3-meshio", _OTHERWISE)
    try:
        # meshio prints some failures and ends the process.
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            mesh = meshio.read(path)
    except (Exception, SystemExit) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        other = "VTK itself, if it is installed (python3-vtk9), may, and " if form else ""
        raise ShapeError(f"meshio cannot read it, so it may be damaged or empty: {reason}; {other}{_OTHERWISE}") from error
    points = np.asarray(mesh.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ShapeError("its points are not in three dimensions")
    parts: List[Integers] = [
        fans_of_block(_corners(block), points).reshape(-1, 3)
        for block in mesh.cells
        if block.type.startswith(("triangle", "quad", "polygon"))
    ]
    notes: Tuple[str, ...] = ()
    if not parts:
        outer, notes = _outer(mesh.cells)
        parts = [outer] if len(outer) else []
    notes += _left_out(mesh.cells)
    normals = mesh.point_data.get("Normals", mesh.point_data.get("normals"))
    given = None if parts or normals is None else np.asarray(normals, dtype=np.float64)
    columns = ("x", "y", "z") if given is None else ("x", "y", "z", "nx", "ny", "nz")
    triangles = np.concatenate(parts) if parts else None
    return Shape(points, given, triangles, form or path.suffix[1:].upper(), columns, notes=notes)


def _corners(block: Any) -> Any:
    """The corners of each cell."""
    data = np.asarray(block.data)
    return data[:, : _CORNERS.get(block.type, data.shape[1])]


def _outer(blocks: Any) -> Tuple[Integers, Tuple[str, ...]]:
    """Triangles of the faces that belong to only one cell, and notes."""
    faces: Dict[Tuple[int, ...], List[int]] = {}
    count = all_faces = 0
    for block in blocks:
        kind = block.type.rstrip("0123456789")
        for cell in _corners(block).tolist() if kind in _FACES and block.type in _CORNERS else ():
            count, all_faces = count + 1, all_faces + len(_FACES[kind])
            for corners in _FACES[kind]:
                face = [cell[i] for i in corners]
                key = tuple(sorted(face))
                if faces.pop(key, None) is None:
                    faces[key] = face
    notes: Tuple[str, ...] = (_VOLUME,) if faces else ()
    if count > 1 and len(faces) == all_faces:
        notes += (
            f"no two of its {count} cells share a face: meshio may misread it; install VTK (python3-vtk9)",
        )
    return fans(faces.values()), notes


def _left_out(blocks: Any) -> Tuple[str, ...]:
    """Notes on cells that are not faces, and whose faces are not known."""
    unknown = {
        block.type: len(block.data)
        for block in blocks
        if block.type not in _CORNERS and not block.type.startswith((*_NO_SURFACE, "polygon"))
    }
    return tuple(f"{count} cells of the kind {kind} left out" for kind, count in sorted(unknown.items()))
