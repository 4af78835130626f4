# SPDX-License-Identifier: MIT
"""Reads 3MF, a format for 3D printers: meshes and their places, as XML in a ZIP archive.

3D Manufacturing Format, core specification 1.3; ``p:path`` refers to other parts of the file (production extension 1.1).
"""
from __future__ import annotations

import lzma
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib
from pathlib import Path, PurePosixPath
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._shape import Floats, Integers, Shape, ShapeError, Vector

UP: Vector = (0.0, 0.0, 1.0)  # the convention of printers
_RELATIONS = "_rels/.rels"
_MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
_PATH = "{http://schemas.microsoft.com/3dmanufacturing/production/2015/06}path"
_LARGEST_PART = 1 << 31  # largest unpacked size of a part, in bytes
_MOST_PLACED = 100_000  # largest number of placed objects
_DEEPEST = 64  # largest depth of components inside components
# Errors of the standard library for archives that are damaged, encrypted or packed with an unknown method.
UNPACKING = (zlib.error, lzma.LZMAError, struct.error, EOFError, LookupError, OSError, RuntimeError, ValueError)
_NO_PARTS = ("support", "other")  # supports for printing, and notes: not parts of the model


class _Placed(NamedTuple):
    part: str
    number: str
    place: Floats  # 4 x 4 matrix that acts on row vectors


def is_3mf(path: Path) -> bool:
    """Whether a ZIP archive contains a 3MF model."""
    try:
        with zipfile.ZipFile(path) as archive:
            return any(name.lower().endswith(".model") for name in archive.namelist())
    except (zipfile.BadZipFile, *UNPACKING):
        return False


def read_3mf(path: Path) -> Shape:
    """Read a 3MF file."""
    try:
        with zipfile.ZipFile(path) as archive:
            return _Reader(archive).shape()
    except zipfile.BadZipFile as error:
        raise ShapeError(f"the 3MF file is not a whole ZIP archive: {error}") from None
    except ShapeError:
        raise
    except UNPACKING as error:
        raise ShapeError(f"a part of the 3MF file cannot be unpacked: {error}") from None


class _Reader:
    """Reads one archive."""

    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive
        self._objects: Dict[str, Dict[str, Any]] = {}  # the objects of each part that was read
        self._meshes: Dict[Tuple[str, str], Tuple[Floats, Integers]] = {}
        self._left_out = 0
        self._points: List[Floats] = []
        self._triangles: List[Integers] = []
        self._count = 0
        self._placed = 0

    def shape(self) -> Shape:
        main = self._main_part()
        root = self._root(main)
        items = root.findall(f"{_CORE}build/{_CORE}item")
        for item in items:
            self._place(_placed(item, main, np.eye(4)), 0)
        if not self._triangles:
            what = "places nothing" if not items else "places no triangles"
            raise ShapeError(f"the 3MF file {what}: its build has no object with a mesh")
        objects = f"{self._left_out} support object{'' if self._left_out == 1 else 's'}"
        notes = (f"{objects} of the print left out",) if self._left_out else ()
        points, triangles = np.concatenate(self._points), np.concatenate(self._triangles)
        return Shape(points, None, triangles, "3MF", ("x", "y", "z"), UP, notes)

    def _main_part(self) -> str:
        if _RELATIONS in self._archive.namelist():
            for relation in self._parsed(_RELATIONS):
                if relation.get("Type") == _MODEL_TYPE:
                    return _name(relation.get("Target", ""))
        for name in self._archive.namelist():
            if name.lower().endswith(".model"):
                return name
        raise ShapeError("not a 3MF file: there is no model in it")

    def _parsed(self, part: str) -> ElementTree.Element:
        try:
            info = self._archive.getinfo(part)
        except KeyError:
            raise ShapeError(f"the 3MF file refers to {part}, which is not in it") from None
        if info.file_size > _LARGEST_PART:
            raise ShapeError(f"{part} of the 3MF file is larger than {_LARGEST_PART >> 30} GiB")
        try:
            return ElementTree.fromstring(self._archive.read(info))
        except ElementTree.ParseError as error:
            raise ShapeError(f"{part} of the 3MF file is not XML: {error}") from None
        except (LookupError, ValueError) as error:  # an unknown encoding
            raise ShapeError(f"{part} of the 3MF file cannot be read: {error}") from None

    def _root(self, part: str) -> ElementTree.Element:
        root = self._parsed(part)
        found = root.findall(f"{_CORE}resources/{_CORE}object")
        self._objects[part] = {one.get("id", ""): one for one in found}
        return root

    def _object(self, placed: _Placed) -> ElementTree.Element:
        if placed.part not in self._objects:
            self._root(placed.part)
        found: Optional[ElementTree.Element] = self._objects[placed.part].get(placed.number)
        if found is None:
            raise ShapeError(f"the 3MF file places object {placed.number!r}, which {placed.part} does not have")
        return found

    def _place(self, placed: _Placed, depth: int) -> None:
        self._placed += 1
        if depth > _DEEPEST:
            raise ShapeError("the components of the 3MF file contain each other")
        if self._placed > _MOST_PLACED:
            raise ShapeError(f"the 3MF file places more than {_MOST_PLACED} objects")
        one = self._object(placed)
        if one.get("type") in _NO_PARTS:
            self._left_out += 1
            return
        for component in one.findall(f"{_CORE}components/{_CORE}component"):
            self._place(_placed(component, placed.part, placed.place), depth + 1)
        mesh = one.find(f"{_CORE}mesh")
        if mesh is not None:
            self._add(placed, mesh)

    def _add(self, placed: _Placed, mesh: ElementTree.Element) -> None:
        key = (placed.part, placed.number)
        if key not in self._meshes:
            self._meshes[key] = _mesh(mesh, placed.number)
        points, triangles = self._meshes[key]
        if len(triangles) == 0:
            return
        if np.linalg.det(placed.place[:3, :3]) < 0:
            triangles = triangles[:, ::-1]
        self._points.append(points @ placed.place[:3, :3] + placed.place[3, :3])
        self._triangles.append(triangles + self._count)
        self._count += len(points)


def _name(target: str) -> str:
    """The name of a part in the archive."""
    return str(PurePosixPath("/", target).relative_to("/"))


def _placed(element: ElementTree.Element, part: str, outer: Floats) -> _Placed:
    """The object that an item of the build or a component places, and its place in the whole."""
    path = element.get(_PATH)
    place = np.eye(4)
    said = element.get("transform")
    if said is not None:
        try:
            place[:, :3] = np.array(said.split(), dtype=np.float64).reshape(4, 3)
        except ValueError:
            raise ShapeError(f"the 3MF file has a transform that is not 12 numbers: {said[:80]!r}") from None
    return _Placed(part if path is None else _name(path), element.get("objectid", ""), place @ outer)


def _numbers(elements: List[ElementTree.Element], names: Tuple[str, ...], kind: Any, number: str) -> Any:
    try:
        return np.array([[one.attrib[name] for name in names] for one in elements]).astype(kind).reshape(-1, 3)
    except (KeyError, ValueError, OverflowError):
        raise ShapeError(
            f"object {number!r} of the 3MF file has a {elements[0].tag.rpartition('}')[2]} without {', '.join(names)}"
        ) from None


def _mesh(mesh: ElementTree.Element, number: str) -> Tuple[Floats, Integers]:
    points = _numbers(mesh.findall(f"{_CORE}vertices/{_CORE}vertex"), ("x", "y", "z"), np.float64, number)
    faces = _numbers(mesh.findall(f"{_CORE}triangles/{_CORE}triangle"), ("v1", "v2", "v3"), np.int64, number)
    if len(faces) and not (0 <= faces.min() and faces.max() < len(points)):
        wrong = int(faces.min() if faces.min() < 0 else faces.max())
        raise ShapeError(
            f"a face of object {number!r} of the 3MF file names vertex {wrong}, but there are only {len(points)}"
        )
    return points, faces
