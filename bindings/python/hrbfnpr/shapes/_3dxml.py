# SPDX-License-Identifier: MIT
"""Reads 3DXML, a format of CAD programs of Dassault Systemes: triangles and their places, as XML in a ZIP archive.

Parts in binary or encrypted form are refused, because their form is not published.
"""
from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from typing import Dict, List, Optional, Tuple

import numpy as np

from ._3mf import UNPACKING
from ._shape import Floats, Integers, Shape, ShapeError, Vector, strips

UP: Vector = (0.0, 0.0, 1.0)  # the convention of CAD programs
_LARGEST_PART = 1 << 30  # largest unpacked size of a part, in bytes
_MOST_PLACED = 100_000  # largest number of placed products
_DEEPEST = 64  # largest depth of products inside products
_OTHERWISE = "its program exports STEP, or 3DXML with tessellation as XML"
_Mesh = Tuple[Floats, Integers]


def read(path: Path) -> Shape:
    """Read a file."""
    try:
        with zipfile.ZipFile(path) as archive:
            return _Reader(archive).shape()
    except zipfile.BadZipFile as error:
        raise ShapeError(f"the 3DXML file is not a whole ZIP archive: {error}") from None
    except ShapeError:
        raise
    except UNPACKING as error:
        raise ShapeError(f"a part of the 3DXML file cannot be unpacked: {error}") from None


def _local(element: ElementTree.Element) -> str:
    """The name of an element without its namespace."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _child(element: ElementTree.Element, name: str) -> Optional[ElementTree.Element]:
    return next((one for one in element if _local(one) == name), None)


def _text(element: ElementTree.Element, name: str) -> str:
    found = _child(element, name)
    return "" if found is None else (found.text or "").strip()


def _number_of(text: str) -> str:
    """The number at the end of a reference such as urn:3DXML:Reference:loc:4."""
    return re.split(r"[:#]", text)[-1]


class _Reader:
    """Reads one archive."""

    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive
        self._meshes: Dict[str, List[_Mesh]] = {}  # the meshes of each part that was read
        self._files: Dict[str, str] = {}  # the part of each representation
        self._reps: Dict[str, List[str]] = {}  # the representations of each product
        self._within: Dict[str, List[Tuple[str, Floats]]] = {}  # the products inside each product, with their places
        self._placed: List[_Mesh] = []
        self._count = 0

    def shape(self) -> Shape:
        names = self._archive.namelist()
        main = self._main(names)
        root = self._xml(main)
        structure = next((one for one in root.iter() if _local(one) == "ProductStructure"), None)
        if structure is not None:
            self._look(structure)
            inside = {number for some in self._within.values() for number, _ in some}
            tops = [number for number in {**self._within, **self._reps} if number not in inside]
            for top in [structure.get("root", "")] if structure.get("root", "") in tops else tops:
                self._place(top, np.eye(4), 0)
        else:
            self._placed += self._meshes_in(root)
        placed = [mesh for mesh in self._placed if len(mesh[1])]
        if not placed:
            raise ShapeError(f"the 3DXML file has no triangles: {_OTHERWISE}")
        first = np.cumsum([0] + [len(points) for points, _ in placed])
        triangles = np.concatenate([faces + start for (_, faces), start in zip(placed, first)])
        points = np.concatenate([points for points, _ in placed])
        return Shape(points, None, triangles, "3DXML", ("x", "y", "z"), UP, unit="millimetres")

    def _main(self, names: List[str]) -> str:
        """The part with the products."""
        if "Manifest.xml" in names:
            for one in self._xml("Manifest.xml").iter():
                if _local(one) == "Root" and (one.text or "").strip() in names:
                    return (one.text or "").strip()
        found = [name for name in names if name.lower().endswith((".3dxml", ".xml")) and name != "Manifest.xml"]
        if not found:
            raise ShapeError("the 3DXML file has no part with the products: it is damaged")
        return found[0]

    def _xml(self, name: str) -> ElementTree.Element:
        if name not in self._archive.namelist():
            raise ShapeError(f"the 3DXML file lacks its part {name!r}")
        info = self._archive.getinfo(name)
        if info.flag_bits & 1:
            raise ShapeError(f"part {name!r} of the 3DXML file is encrypted: {_OTHERWISE}")
        if info.file_size > _LARGEST_PART:
            raise ShapeError(f"part {name!r} of the 3DXML file has {info.file_size} bytes: it is too large")
        data = self._archive.read(name)
        if data[:3] == b"\xef\xbb\xbf":
            data = data[3:]
        if not data.lstrip()[:1] == b"<" and data[:2] not in (b"\xff\xfe", b"\xfe\xff"):
            raise ShapeError(f"part {name!r} of the 3DXML file is in a binary or encrypted form, which is not read: {_OTHERWISE}")
        try:
            return ElementTree.fromstring(data)
        except (ElementTree.ParseError, LookupError, ValueError) as error:
            raise ShapeError(f"part {name!r} of the 3DXML file is not valid XML: {error}") from None

    def _look(self, structure: ElementTree.Element) -> None:
        """Gather the products, their places and their representations."""
        for one in structure:
            kind, number = _local(one), one.get("id", "")
            owner, of = (_number_of(_text(one, name)) for name in ("IsAggregatedBy", "IsInstanceOf"))
            if kind == "Instance3D":
                self._within.setdefault(owner, []).append((of, _matrix(_text(one, "RelativeMatrix"), number)))
            elif kind == "InstanceRep":
                self._reps.setdefault(owner, []).append(of)
            elif kind == "ReferenceRep":
                self._files[number] = _number_of(one.get("associatedFile", ""))

    def _place(self, number: str, place: Floats, depth: int) -> None:
        self._count += 1
        if depth > _DEEPEST:
            raise ShapeError("the products of the 3DXML file contain each other")
        if self._count > _MOST_PLACED:
            raise ShapeError(f"the 3DXML file places more than {_MOST_PLACED} products")
        for rep in self._reps.get(number, ()):
            for points, faces in self._meshes_of(self._files.get(rep, "")):
                turned = faces[:, ::-1] if np.linalg.det(place[:3, :3]) < 0.0 else faces
                self._placed.append((points @ place[:3, :3].T + place[:3, 3], turned))
        for inner, matrix in self._within.get(number, ()):
            self._place(inner, place @ matrix, depth + 1)

    def _meshes_of(self, name: str) -> List[_Mesh]:
        if not name:
            return []
        if name not in self._meshes:
            self._meshes[name] = self._meshes_in(self._xml(name))
        return self._meshes[name]

    def _meshes_in(self, root: ElementTree.Element) -> List[_Mesh]:
        return [found for rep in root.iter() if _local(rep) in ("Rep", "Root") and (found := _mesh(rep)) is not None]


def _matrix(text: str, number: str) -> Floats:
    """A place: the three axes, then the shift."""
    result = np.eye(4)
    if text:
        try:
            numbers = np.array(text.replace(",", " ").split(), dtype=np.float64).reshape(4, 3)
        except ValueError:
            raise ShapeError(f"the place of instance {number!r} in the 3DXML file is not 12 numbers") from None
        result[:3, :3], result[:3, 3] = numbers[:3].T, numbers[3]
    return result


def _mesh(rep: ElementTree.Element) -> Optional[_Mesh]:
    """The triangles of a representation at its finest; None if it has none of its own."""
    buffer = _child(rep, "VertexBuffer")
    places = None if buffer is None else _child(buffer, "Positions")
    if places is None:
        return None
    points = _numbers(places.text or "", np.float64, "positions").reshape(-1, 3)
    faces = _child(rep, "Faces")
    if faces is None:
        levels = sorted((one for one in rep if _local(one) == "PolygonalLOD"), key=_accuracy)
        faces = _child(levels[0], "Faces") if levels else None
    if faces is None:
        return None
    found: List[Integers] = []
    for face in faces:
        found.append(_numbers(face.get("triangles", ""), np.int64, "triangles").reshape(-1, 3))
        for strip in face.get("strips", "").split(","):
            found.append(strips(_numbers(strip, np.int64, "strips").tolist()))
        for fan in face.get("fans", "").split(","):
            index = _numbers(fan, np.int64, "fans")
            if len(index) > 2:
                found.append(np.column_stack([np.full(len(index) - 2, index[0]), index[1:-1], index[2:]]))
    triangles: Integers = np.concatenate([part.reshape(-1, 3) for part in found]) if found else np.empty((0, 3), np.int64)
    if len(triangles) and not 0 <= int(triangles.min()) <= int(triangles.max()) < len(points):
        raise ShapeError(f"a face of the 3DXML file names vertex {triangles.max()}, but its part has only {len(points)} vertices")
    return points, triangles


def _accuracy(level: ElementTree.Element) -> float:
    try:
        return float(level.get("accuracy", "inf"))
    except ValueError:
        return float("inf")


def _numbers(text: str, kind: type, what: str) -> Floats:
    try:
        found = np.array(text.replace(",", " ").split(), dtype=kind)
    except (ValueError, OverflowError):
        raise ShapeError(f"the {what} of the 3DXML file hold a word that is not a number") from None
    if what in ("positions", "triangles") and len(found) % 3:
        raise ShapeError(f"the {what} of the 3DXML file are {len(found)} numbers, which are no groups of three")
    return found
