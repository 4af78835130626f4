# SPDX-License-Identifier: MIT
"""Reads AMF, a format for 3D printers: meshes, and constellations that place them, as XML, which may be in a ZIP archive.

Additive Manufacturing File Format, ISO/ASTM 52915.  Triangles with curved sides are read as flat ones.
"""
from __future__ import annotations

import io
import xml.etree.ElementTree as ElementTree
import zipfile
from typing import Dict, List, Set, Tuple

import numpy as np

from ._3mf import UNPACKING
from ._shape import Floats, Integers, Shape, ShapeError, Vector
from ._table import is_number, usual_numbers

UP: Vector = (0.0, 0.0, 1.0)  # the convention of printers
MAGIC = rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!--.*?-->\s*)*<(?i:amf)\b"
_LARGEST = 1 << 31  # largest unpacked size, in bytes
_COORDINATES = ("coordinates/x", "coordinates/y", "coordinates/z")
_MOST_PLACED = 100_000  # largest number of placed objects
_DEEPEST = 64  # largest depth of constellations inside constellations
_Mesh = Tuple[Floats, Integers]


def read_amf(data: bytes) -> Shape:
    """Read the bytes of an AMF file.  Objects that no constellation places stay where they are."""
    if data[:4] == b"PK\3\4":
        data = _unpacked(data)
    try:
        root = ElementTree.fromstring(usual_numbers(data))
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise ShapeError(f"the AMF file is not valid XML: {error}") from None
    placed = _Placer(root).placed()
    points = np.concatenate([mesh[0] for mesh in placed])
    first = np.cumsum([0] + [len(mesh[0]) for mesh in placed])
    triangles = np.concatenate([mesh[1] + start for mesh, start in zip(placed, first)])
    return Shape(points, None, triangles, "AMF", ("x", "y", "z"), UP)


def _unpacked(data: bytes) -> bytes:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            infos = [info for info in archive.infolist() if info.filename.lower().endswith((".amf", ".xml"))]
            if infos and infos[0].file_size <= _LARGEST:
                return archive.read(infos[0])
    except (zipfile.BadZipFile, *UNPACKING) as error:
        raise ShapeError(f"the AMF file is packed as a ZIP archive, and damaged: {error}") from None
    what = f"larger than {_LARGEST >> 30} GiB" if infos else "not in it"
    raise ShapeError(f"the AMF file is packed as a ZIP archive, and the model is {what}")


class _Placer:
    """The meshes of all objects, and the places that constellations give them."""

    def __init__(self, root: ElementTree.Element) -> None:
        self._meshes: Dict[str, List[_Mesh]] = {}
        for number, one in enumerate(root.iter("object")):
            name = one.get("id", f"#{number}")
            self._meshes.setdefault(name, []).extend(_mesh(mesh, name) for mesh in one.iter("mesh"))
        self._instances = {one.get("id", ""): list(one.iter("instance")) for one in root.iter("constellation")}
        self._count = 0

    def placed(self) -> List[_Mesh]:
        within: Set[str] = {_id(instance) for some in self._instances.values() for instance in some}
        found = [mesh for name in self._instances if name not in within for mesh in self._of(name, 0)]
        found += [mesh for name, some in self._meshes.items() if name not in within for mesh in some]
        found = [mesh for mesh in found if len(mesh[1])]
        if not found:
            raise ShapeError("the AMF file has no triangles" + (", or none that is placed" if self._meshes else ""))
        return found

    def _of(self, name: str, depth: int) -> List[_Mesh]:
        self._count += 1
        if depth > _DEEPEST:
            raise ShapeError("the constellations of the AMF file contain each other")
        if self._count > _MOST_PLACED:
            raise ShapeError(f"the AMF file places more than {_MOST_PLACED} objects")
        if name in self._meshes:
            return self._meshes[name]
        if name not in self._instances:
            raise ShapeError(f"the AMF file places object {name!r}, which it does not have")
        found = []
        for instance in self._instances[name]:
            turn, move = _place(instance)
            found += [(points @ turn.T + move, faces) for points, faces in self._of(_id(instance), depth + 1)]
        return found


def _id(instance: ElementTree.Element) -> str:
    return instance.get("objectid", "")


def _place(instance: ElementTree.Element) -> Tuple[Floats, Floats]:
    """Rotation and shift of an instance: turned about x, then y, then z, in degrees, then moved."""
    said = {child.tag.lower(): child.text or "" for child in instance}
    try:
        angles = np.radians([float(said.get(name, "0")) for name in ("rx", "ry", "rz")])
        move = np.array([float(said.get(name, "0")) for name in ("deltax", "deltay", "deltaz")])
    except ValueError:
        raise ShapeError(f"the place of object {_id(instance)!r} in the AMF file is not given by numbers") from None
    turn = np.eye(3)
    for axis, angle in enumerate(angles):
        one, other = (axis + 1) % 3, (axis + 2) % 3
        about = np.eye(3)
        about[one, one] = about[other, other] = np.cos(angle)
        about[other, one], about[one, other] = np.sin(angle), -np.sin(angle)
        turn = about @ turn
    return turn, move


def _mesh(mesh: ElementTree.Element, name: str) -> _Mesh:
    points = _numbers(list(mesh.iterfind("vertices/vertex")), _COORDINATES, name)
    faces = _numbers(list(mesh.iterfind("volume/triangle")), ("v1", "v2", "v3"), name)
    if len(faces) and not ((0 <= faces) & (faces < len(points)) & (faces % 1 == 0)).all():
        wrong = faces[~((0 <= faces) & (faces < len(points)) & (faces % 1 == 0))][0]
        raise ShapeError(f"a face of object {name!r} of the AMF file names vertex {wrong:g}, but there are only {len(points)}")
    return points, faces.astype(np.int64)


def _numbers(elements: List[ElementTree.Element], names: Tuple[str, str, str], name: str) -> Floats:
    words = [[one.findtext(child, "") for child in names] for one in elements]
    try:
        found: Floats = np.array(words, dtype=np.float64).reshape(-1, 3)
    except ValueError:
        bad = next((row for row in words if not all(is_number(word.encode()) for word in row)), words[0])
        raise ShapeError(
            f"object {name!r} of the AMF file has a {elements[0].tag} whose {', '.join(names)} are not numbers: {bad}"[:300]
        ) from None
    return found
