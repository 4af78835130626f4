# SPDX-License-Identifier: MIT
"""Reads 3MF, a format for 3D printers: meshes, lattices of beams and stacks of slices, and their places, as XML in a ZIP archive.

3D Manufacturing Format, core specification 1.3; ``p:path`` refers to other parts of the file (production extension 1.1);
beams and balls are those of the beam lattice extension 1.2, and slices those of the slice extension 1.0.
"""
from __future__ import annotations

import lzma
import re
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib
from pathlib import Path, PurePosixPath
from xml.parsers import expat
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._capsules import MOST_CAPSULES, capsules
from ._shape import Floats, Integers, Shape, ShapeError, Vector
from ._slices import Slice, stacked
from ._table import usual_numbers

UP: Vector = (0.0, 0.0, 1.0)  # the convention of printers
_RELATIONS = "_rels/.rels"
_MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
_PATH = "{http://schemas.microsoft.com/3dmanufacturing/production/2015/06}path"
_EXTENSIONS = {"p": _PATH[1:-5], "b": "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
               "s": "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"}  # by their usual prefixes  # fmt: skip
_UNBOUND = expat.errors.codes[expat.errors.XML_ERROR_UNBOUND_PREFIX]
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
        self._stacks: Dict[str, Dict[str, Any]] = {}  # the stacks of slices of each part
        self._meshes: Dict[Tuple[str, str], Tuple[Floats, Integers]] = {}
        self._left_out = 0
        self._points: List[Floats] = []
        self._triangles: List[Integers] = []
        self._count = 0
        self._placed = 0
        self._notes: List[str] = []

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
        notes = (*((f"{objects} of the print left out",) if self._left_out else ()), *self._notes)
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
            return _tree(usual_numbers(self._archive.read(info)))
        except ElementTree.ParseError as error:
            raise ShapeError(f"{part} of the 3MF file is not XML: {error}") from None
        except (LookupError, ValueError) as error:  # an unknown encoding
            raise ShapeError(f"{part} of the 3MF file cannot be read: {error}") from None

    def _root(self, part: str) -> ElementTree.Element:
        root = self._parsed(part)
        found = root.findall(f"{_CORE}resources/{_CORE}object")
        self._objects[part] = {one.get("id", ""): one for one in found}
        self._stacks[part] = {one.get("id", ""): one for one in _all(root, "slicestack")}
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
        said = {_local(name): value for name, value in one.attrib.items()}
        if "slicestackid" in said and (said.get("meshresolution") == "lowres" or mesh is None):
            self._stack(placed, said["slicestackid"])  # its mesh, if there is one, only stands in for the slices
        elif mesh is not None:
            self._add(placed, mesh)

    def _stack(self, placed: _Placed, number: str) -> None:
        """Add an object that is made of slices."""
        key = (placed.part, placed.number)
        if key not in self._meshes:
            bottom, slices = self._slices(placed.part, number, 0)
            try:
                points, triangles, side = stacked(bottom, slices)
            except ShapeError as error:
                raise ShapeError(f"object {placed.number!r} of the 3MF file is made of slices: {error}") from None
            self._meshes[key] = points, triangles
            self._notes.append(f"object {placed.number} is made of {len(slices)} slices: they are stacked, in cells of {side:.3g}"[:100])
        self._put(placed, *self._meshes[key])

    def _slices(self, part: str, number: str, depth: int) -> Tuple[float, List[Slice]]:
        """The lower end of a stack, and its slices.  A stack may refer to those of other parts."""
        if part not in self._stacks:
            self._root(part)
        stack = self._stacks[part].get(number)
        if stack is None or depth > 1:
            raise ShapeError(f"the 3MF file names the slices {number!r}, which {part} does not have")
        bottom = _number(stack.get("zbottom"), 0.0)
        slices: List[Slice] = []
        for reference in _all(stack, "sliceref"):
            path = reference.get("slicepath")
            slices += self._slices(part if path is None else _name(path), reference.get("slicestackid", ""), depth + 1)[1]
        for one in _all(stack, "slice"):
            corners = np.array([[_value(corner, axis, number, float) for axis in "xy"] for corner in _all(one, "vertex")])
            polygons: List[Floats] = []
            for polygon in _all(one, "polygon"):
                places = [_value(polygon, "startv", number, int), *(_value(to, "v2", number, int) for to in _all(polygon, "segment"))]
                if not all(0 <= place < len(corners) for place in places):
                    raise ShapeError(f"a slice of {number!r} of the 3MF file names a vertex that it lacks; it has {len(corners)}")
                if len(places) > 3 and places[0] == places[-1]:  # others are open
                    polygons.append(corners[places[:-1]])
            slices.append(Slice(_value(one, "ztop", number, float), polygons))
        return bottom, slices

    def _add(self, placed: _Placed, mesh: ElementTree.Element) -> None:
        key = (placed.part, placed.number)
        if key not in self._meshes:
            points, faces = _mesh(mesh, placed.number)
            beams = self._beams(mesh, points, placed.number)
            self._meshes[key] = points, faces
            if beams is not None:
                self._meshes[key] = np.concatenate([points, beams[0]]), np.concatenate([faces, beams[1] + len(points)])
        self._put(placed, *self._meshes[key])

    def _put(self, placed: _Placed, points: Floats, triangles: Integers) -> None:
        """Add a mesh at its place."""
        if len(triangles) == 0:
            return
        if np.linalg.det(placed.place[:3, :3]) < 0:
            triangles = triangles[:, ::-1]
        self._points.append(points @ placed.place[:3, :3] + placed.place[3, :3])
        self._triangles.append(triangles + self._count)
        self._count += len(points)


    def _beams(self, mesh: ElementTree.Element, points: Floats, number: str) -> Optional[Tuple[Floats, Integers]]:
        """The beams and the balls of a lattice as capsules; None without any."""
        lattice = next((child for child in mesh if _local(child.tag) == "beamlattice"), None)
        if lattice is None:
            return None
        said = {_local(name): value for name, value in lattice.attrib.items()}
        ends: List[List[int]] = []
        radii: List[List[float]] = []
        flat: List[List[bool]] = []
        for beam in _all(lattice, "beam"):
            ends.append([_value(beam, "v1", number, int), _value(beam, "v2", number, int)])
            first = _value(beam, "r1", number, float, said.get("radius"))
            radii.append([first, _value(beam, "r2", number, float, beam.get("r1", said.get("radius")))])
            flat.append([beam.get(name, said.get("cap", "sphere")) == "butt" for name in ("cap1", "cap2")])
        for ball in _balls(lattice, said, ends):
            place = _value(ball, "vindex", number, int)
            ends.append([place, place])
            radii.append([_value(ball, "r", number, float, said.get("ballradius", said.get("radius")))] * 2)
            flat.append([False, False])
        if len(ends) > MOST_CAPSULES:
            what = f"the lattice of object {number!r} of the 3MF file has {len(ends)} beams"
            raise ShapeError(f"{what}; {MOST_CAPSULES} can be drawn: export it as a mesh")
        corners, thick = np.array(ends, dtype=np.int64).reshape(-1, 2), np.array(radii, dtype=np.float64).reshape(-1, 2)
        if len(corners) and not (0 <= corners.min() and corners.max() < len(points)):
            raise ShapeError(f"a beam of object {number!r} of the 3MF file names a vertex that it lacks; it has {len(points)}")
        if len(corners) and not (np.isfinite(thick).all() and thick.min() > 0):
            raise ShapeError(f"a beam of object {number!r} of the 3MF file has no radius above 0")
        if said.get("clippingmode", "none") != "none":
            self._notes.append(f"the beams of object {number} are not clipped by its clipping mesh"[:100])
        long_enough = np.linalg.norm(points[corners[:, 1]] - points[corners[:, 0]], axis=1) >= _number(said.get("minlength"), 0.0)
        keep = long_enough | (corners[:, 0] == corners[:, 1])
        return capsules(points[corners[keep, 0]], points[corners[keep, 1]], thick[keep], np.array(flat).reshape(-1, 2)[keep])


def _tree(data: bytes) -> ElementTree.Element:
    """The XML of a part.  Prefixes that are not declared get their usual meaning, or none."""
    try:
        return ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        root = re.search(rb"<[A-Za-z_][\w:.-]*", data)
        if error.code != _UNBOUND or root is None:
            raise
        declared = set(re.findall(rb"xmlns:([\w.-]+)", data[root.end() : data.find(b">", root.end())]))
        used = set(re.findall(rb"[<\s/]([A-Za-z_][\w.-]*):[A-Za-z_]", data)) - declared - {b"xml", b"xmlns"}
        names = sorted(name.decode("latin-1") for name in used)
        more = "".join(f' xmlns:{name}="{_EXTENSIONS.get(name, "undeclared:" + name)}"' for name in names)
        return ElementTree.fromstring(data[: root.end()] + more.encode() + data[root.end() :])


def _local(name: str) -> str:
    """The name of an element or an attribute without its namespace."""
    return name.rpartition("}")[2]


def _all(element: ElementTree.Element, name: str) -> List[ElementTree.Element]:
    """The elements of a name in all namespaces."""
    return [one for one in element.iter() if _local(one.tag) == name]


def _balls(lattice: ElementTree.Element, said: Dict[str, str], ends: List[List[int]]) -> List[ElementTree.Element]:
    """The balls of a lattice: none, those that are listed, or one at each end of a beam."""
    mode = said.get("ballmode", "none")
    listed = _all(lattice, "ball") if mode != "none" else []
    known = {ball.get("vindex") for ball in listed}
    rest = sorted({end for pair in ends for end in pair}) if mode == "all" else []
    return listed + [ElementTree.Element("ball", vindex=str(end)) for end in rest if str(end) not in known]


def _value(element: ElementTree.Element, name: str, number: str, kind: Any, default: Optional[str] = None) -> Any:
    """An attribute of a beam or a ball, as a number."""
    try:
        return kind(element.get(name, default))
    except (TypeError, ValueError):
        what = _local(element.tag)
        raise ShapeError(f"object {number!r} of the 3MF file has a {what} without {name}, or it is no number") from None


def _number(text: Optional[str], default: float) -> float:
    try:
        return float(text) if text is not None else default
    except ValueError:
        return default


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
