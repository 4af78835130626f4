# SPDX-License-Identifier: MIT
"""Reads glTF 2 and GLB: the triangles and points of a scene, at the places of its nodes."""
from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple
from urllib.parse import unquote

import numpy as np

from . import _draco, _meshopt
from ._attributes import COLOUR, PointValues, joined
from ._shape import Floats, Integers, Shape, ShapeError, Vector
from ._sharp_edges import of_vertices

UP: Vector = (0.0, 1.0, 0.0)
_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
_DRACO = "KHR_draco_mesh_compression"
_PACKED = ("EXT_meshopt_compression", "KHR_meshopt_compression")
_EDGES = "EXT_mesh_primitive_edge_visibility"
_OUTLINE = "CESIUM_primitive_outline"  # pairs of vertices, the ends of hard edges
_HARD = 2  # the least visibility of edges that are always drawn; below: never, or only as a part of the outline
_POINTS, _TRIANGLES, _STRIP, _FAN = 0, 4, 5, 6
_MOST = 1 << 28  # largest number of elements in a list
_DEEPEST = 200  # largest depth of nodes inside nodes
_MOST_PLACED = 100_000  # largest number of placed nodes


def read_gltf(data: bytes, folder: Path) -> Shape:
    """Read the bytes of a .gltf or .glb file.  Files that it names are looked for in `folder`."""
    binary = data[:4] == b"glTF"
    text, chunk = _chunks(data) if binary else (data, b"")
    try:
        document = json.loads(text)
        if not isinstance(document, dict) or "asset" not in document:
            raise ShapeError("not a glTF file: it has no asset")
        return _Reader(document, chunk, folder, "GLB" if binary else "glTF").shape()
    except json.JSONDecodeError as error:
        raise ShapeError(f"line {error.lineno}, column {error.colno}: the JSON of the glTF file: {error.msg}") from None
    except UnicodeDecodeError:
        raise ShapeError("not a glTF file: its JSON is not text") from None
    except OverflowError:
        raise ShapeError("a number of the glTF file is larger than coordinates can be") from None
    except RecursionError:
        raise ShapeError("the JSON of the glTF file is nested too deep") from None
    except ShapeError:
        raise
    except KeyError as error:
        key = error.args[0]
        lacks = f"is incomplete: a part has no {key!r}" if isinstance(key, str) else f"has an unknown type {key!r}"
        raise ShapeError(f"the glTF file {lacks}") from None
    except IndexError:
        raise ShapeError("the glTF file is damaged: an index is larger than its list") from None
    except (TypeError, AttributeError, ValueError):
        raise ShapeError(
            "the glTF file is not valid: a value has the wrong type, such as a list in place of a number"
        ) from None


def _chunks(data: bytes) -> Tuple[bytes, bytes]:
    """The JSON of a GLB file, and its binary part."""
    if len(data) < 20:
        raise ShapeError("the GLB file ends before its contents")
    version, length = struct.unpack_from("<II", data, 4)
    if version != 2:
        raise ShapeError(f"GLB files of version {version} are not read: version 2 is")
    if length > len(data):
        raise ShapeError(f"the GLB file is cut short: it has {len(data)} of {length} bytes")
    parts: Dict[bytes, bytes] = {}
    at = 12
    while at + 8 <= length:
        size, kind = struct.unpack_from("<I4s", data, at)
        parts.setdefault(kind, data[at + 8 : at + 8 + size])
        at += 8 + size
    if b"JSON" not in parts:
        raise ShapeError("the GLB file has no JSON part")
    return parts[b"JSON"], parts.get(b"BIN\0", b"")


class _Reader:
    """Reads one document."""

    def __init__(self, document: Dict[str, Any], chunk: bytes, folder: Path, form: str) -> None:
        self._document, self._chunk, self._folder, self._form = document, chunk, folder, form
        self._buffers: Dict[int, bytes] = {}
        self._views: Dict[int, bytes] = {}  # the unpacked views
        self._points: List[Floats] = []
        self._normals: List[Optional[Floats]] = []
        self._colours: List[Tuple[int, Optional[PointValues]]] = []  # a count and colours for each part
        self._triangles: List[Integers] = []
        self._edges: List[Optional[Integers]] = []  # for each part: its hard edges, if it says which are
        self._notes: List[str] = []
        self._count = 0
        self._world: Dict[int, Floats] = {}

    def shape(self) -> Shape:
        if isinstance(self._document.get("meshes"), dict):  # version 1 has names here; version 2 has a list
            raise ShapeError("glTF files of version 1 are not read: version 2 is; Blender or MeshLab converts it")
        nodes = self._document.get("nodes", [])
        placed = self._places(nodes)
        self._world = dict(reversed(placed))  # for joints: the first place of each node
        for number, place in placed:
            if "mesh" in nodes[number]:
                self._mesh(nodes[number], place)
        if not self._points:
            raise ShapeError("the scene of the glTF file has no triangles and no points")
        triangles = np.concatenate(self._triangles) if self._triangles else None
        normals = None
        if triangles is None and all(part is not None for part in self._normals):
            normals = np.concatenate([part for part in self._normals if part is not None])
        columns = ("x", "y", "z") if normals is None else ("x", "y", "z", "nx", "ny", "nz")
        points = np.concatenate(self._points)
        sharp = None if triangles is None else self._sharp_edges(points, triangles)
        colour = joined(self._colours)
        fields = {} if colour is None else {COLOUR: colour}
        return Shape(points, normals, triangles, self._form, columns, UP, tuple(self._notes), sharp_edges=sharp, fields=fields)

    def _sharp_edges(self, points: Floats, triangles: Integers) -> Optional[Integers]:
        """The hard edges of the parts that say which are hard, and the sharp ones of other parts that have normals."""
        said = [part for part in self._edges if part is not None]
        normals = [np.full_like(place, np.nan) if part is None or part.shape != place.shape or edges is not None else part
                   for place, part, edges in zip(self._points, self._normals, self._edges)]  # fmt: skip
        has_normals = any(part is not None and edges is None for part, edges in zip(self._normals, self._edges))
        by_normals = of_vertices(points, triangles, np.concatenate(normals)) if has_normals else None
        found = said + ([] if by_normals is None else [by_normals])
        return np.concatenate(found) if found else None

    def _roots(self, nodes: List[Any]) -> List[int]:
        scenes = self._document.get("scenes", [])
        if scenes:
            return list(scenes[self._document.get("scene", 0)].get("nodes", []))
        children = {child for node in nodes for child in node.get("children", [])}
        return [i for i in range(len(nodes)) if i not in children]

    def _places(self, nodes: List[Any]) -> List[Tuple[int, Floats]]:
        """The nodes of the scene with their places, as matrices.

        A child of several nodes appears several times.  The format demands a tree, but some programs write a repeated
        part in this way.
        """
        placed: List[Tuple[int, Floats]] = []
        todo = [(root, np.eye(4), 0) for root in reversed(self._roots(nodes))]
        while todo:
            number, above, depth = todo.pop()
            if depth > _DEEPEST:
                raise ShapeError("the nodes of the glTF file contain each other")
            if len(placed) == _MOST_PLACED:
                raise ShapeError(f"the scene of the glTF file places more than {_MOST_PLACED} nodes")
            place = above @ _matrix(nodes[number])
            placed.append((number, place))
            todo += [(child, place, depth + 1) for child in reversed(nodes[number].get("children", []))]
        return placed

    def _mesh(self, node: Dict[str, Any], matrix: Floats) -> None:
        for part in self._document["meshes"][node["mesh"]]["primitives"]:
            mode = part.get("mode", _TRIANGLES)
            if mode not in (_POINTS, _TRIANGLES, _STRIP, _FAN) or "POSITION" not in part["attributes"]:
                continue
            draco = self._by_draco(part)
            points = self._accessor(part["attributes"]["POSITION"]) if draco is None else draco.points
            if "skin" in node and "JOINTS_0" in part["attributes"]:
                if draco is None:  # the joints of a Draco part are not unpacked, so it stays in its modelled pose
                    points = self._posed(points, part["attributes"], self._document["skins"][node["skin"]])
                linear = np.eye(3)
            else:
                points = points @ matrix[:3, :3].T + matrix[:3, 3]
                linear = matrix[:3, :3]
            normals, edges = None, None
            if "NORMAL" in part["attributes"] and draco is None:
                normals = self._normals_of(part, linear, mode)
            if mode != _POINTS:
                triangles = self._triangles_of(part, mode, len(points)) if draco is None else draco.triangles
                if triangles is None:
                    triangles = np.zeros((0, 3), np.int64)
                self._check(triangles, len(points))
                edges = self._hard_edges(part, triangles, len(points)) if draco is None else None
                if np.linalg.det(linear) < 0:
                    triangles = triangles[:, ::-1]
                self._triangles.append(triangles + self._count)
            self._points.append(points)
            self._normals.append(normals)
            self._edges.append(None if edges is None else edges + self._count)
            self._colours.append((len(points), self._colours_of(part, draco, len(points))))
            self._count += len(points)

    def _normals_of(self, part: Dict[str, Any], linear: Floats, mode: int) -> Optional[Floats]:
        """The normals of a part.  For faces they are only a hint: they are not transformed, and errors are ignored."""
        number = part["attributes"]["NORMAL"]
        if mode == _POINTS:
            placed: Floats = self._accessor(number) @ np.linalg.inv(linear)
            return placed
        try:
            return self._accessor(number)
        except (LookupError, TypeError, ValueError):
            return None

    def _hard_edges(self, part: Dict[str, Any], triangles: Integers, count: int) -> Optional[Integers]:
        """The edges that are always drawn, if a part says which: those of bits, line strings or an outline."""
        extensions = part.get("extensions", {})
        said, outline = extensions.get(_EDGES, {}), extensions.get(_OUTLINE)
        if _EDGES not in extensions and outline is None:
            return None
        hard: List[Integers] = []
        if outline is not None:
            ends = self._accessor(outline["indices"])[:, 0].astype(np.int64)
            hard.append(ends[: len(ends) // 2 * 2].reshape(-1, 2))
        if "visibility" in said:
            coded = self._accessor(said["visibility"])[:, 0].astype(np.uint8)
            if 4 * len(coded) < 3 * len(triangles):
                raise ShapeError(
                    f"the edges of a part of the glTF file are cut short: {len(coded)} bytes for {len(triangles)} triangles"
                )
            visible = (coded[:, None] >> np.array([0, 2, 4, 6]) & 3).reshape(-1)[: 3 * len(triangles)]
            sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
            hard.append(sides[visible >= _HARD])
        strings = said.get("lineStrings", [])
        for one in strings:
            restart = np.iinfo(_TYPES[self._document["accessors"][one["indices"]]["componentType"]]).max
            along = self._accessor(one["indices"])[:, 0].astype(np.int64)
            pairs = np.column_stack([along[:-1], along[1:]])
            hard.append(pairs[(pairs != restart).all(axis=1)])
        edges: Integers = np.concatenate(hard) if hard else np.empty((0, 2), np.int64)
        if len(edges) and not 0 <= int(edges.min()) <= int(edges.max()) < count:
            raise ShapeError(f"an edge names vertex {edges.max()}, but its part has only {count} vertices")
        note = "edges have materials of their own, which are not used"
        if any("material" in one for one in (said, *strings)) and note not in self._notes:
            self._notes.append(note)
        return edges

    def _colours_of(self, part: Dict[str, Any], draco: Optional[Shape], count: int) -> Optional[PointValues]:
        """The colours of the vertices times that of the material, as sRGB; None if the part has neither."""
        materials = self._document.get("materials", [])
        material = materials[part["material"]] if "material" in part else {}
        factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor")
        number = part["attributes"].get("COLOR_0") if draco is None else None
        if number is None and factor is None:
            return None
        linear = np.ones((count, 3)) if number is None else self._accessor(number)[:, :3]
        if len(linear) != count or linear.shape[1] != 3:
            return None
        linear = np.clip(linear * np.array([1.0, 1.0, 1.0] if factor is None else factor[:3], dtype=np.float64), 0.0, 1.0)
        coded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        return PointValues("colour", coded.astype(np.float32))

    def _triangles_of(self, part: Dict[str, Any], mode: int, count: int) -> Integers:
        indices = self._accessor(part["indices"])[:, 0].astype(np.int64) if "indices" in part else np.arange(count)
        return _triangles(indices, mode)

    def _by_draco(self, part: Dict[str, Any]) -> Optional[Shape]:
        """The unpacked part, or None if it has an uncompressed copy or is not compressed."""
        packed = part.get("extensions", {}).get(_DRACO)
        if packed is None or "bufferView" in self._document["accessors"][part["attributes"]["POSITION"]]:
            return None
        view = self._document["bufferViews"][packed["bufferView"]]
        begin = view.get("byteOffset", 0)
        return _draco.unpack(self._buffer(view["buffer"])[begin : begin + view["byteLength"]])

    @staticmethod
    def _check(triangles: Integers, count: int) -> None:
        if len(triangles) and int(triangles.max()) >= count:
            raise ShapeError(f"a face names vertex {triangles.max()}, but its part has only {count} vertices")

    def _posed(self, points: Floats, attributes: Dict[str, int], skin: Dict[str, Any]) -> Floats:
        """Points moved by the joints of a skeleton in its stored pose.  The place of the mesh's own node does not matter."""
        joints = self._accessor(attributes["JOINTS_0"]).astype(np.int64)
        weights = self._accessor(attributes["WEIGHTS_0"])
        count = len(skin["joints"])
        inverse = np.tile(np.eye(4), (count, 1, 1))
        if "inverseBindMatrices" in skin:
            inverse = self._accessor(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
        moves = np.stack([self._world.get(joint, np.eye(4)) @ inverse[i] for i, joint in enumerate(skin["joints"])])
        total = np.maximum(weights.sum(axis=1, keepdims=True), 1e-12)
        blended = np.einsum("ij,ijkl->ikl", weights / total, moves[joints])
        moved: Floats = np.einsum("ikl,il->ik", blended[:, :3, :3], points) + blended[:, :3, 3]
        return moved

    def _accessor(self, number: int) -> Floats:
        """The numbers of an accessor as floats, shape (count, width)."""
        accessor = self._document["accessors"][number]
        dtype, width, count = np.dtype(_TYPES[accessor["componentType"]]), _WIDTHS[accessor["type"]], accessor["count"]
        if count > _MOST:
            raise ShapeError(f"the glTF file has {count} numbers in a list: it is damaged, or too large")
        if "bufferView" in accessor:
            values = self._view(accessor["bufferView"], accessor.get("byteOffset", 0), dtype, width, count)
        else:
            values = np.zeros((count, width), dtype)
        if "sparse" in accessor:
            values = values.copy()
            sparse = accessor["sparse"]
            which, new = sparse["indices"], sparse["values"]
            kind = np.dtype(_TYPES[which["componentType"]])
            places = self._view(which["bufferView"], which.get("byteOffset", 0), kind, 1, sparse["count"])[:, 0]
            values[places] = self._view(new["bufferView"], new.get("byteOffset", 0), dtype, width, sparse["count"])
        result: Floats = values.astype(np.float64)
        if accessor.get("normalized") and dtype.kind in "iu":
            result = np.maximum(result / np.iinfo(dtype).max, -1.0)
        return result

    def _view(self, number: int, offset: int, dtype: Any, width: int, count: int) -> Any:
        view = self._document["bufferViews"][number]
        packed = next((view["extensions"][name] for name in _PACKED if name in view.get("extensions", {})), None)
        size = dtype.itemsize * width
        if packed is None:
            data, start = self._buffer(view["buffer"]), view.get("byteOffset", 0) + offset
            stride = view.get("byteStride") or size
        else:
            data, start, stride = self._unpacked(number, packed), offset, packed["byteStride"]
        if count == 0:
            return np.zeros((0, width), dtype)
        if min(start, count, stride) < 0 or start + stride * (count - 1) + size > len(data):
            raise ShapeError(f"the glTF file is cut short: part {number} ends after the last of {len(data)} bytes")
        rows: Any = np.ndarray((count, size), np.uint8, data, start, (stride, 1))
        return np.ascontiguousarray(rows).view(dtype)

    def _unpacked(self, number: int, packed: Dict[str, Any]) -> bytes:
        if number not in self._views:
            begin = packed.get("byteOffset", 0)
            data = self._buffer(packed["buffer"])[begin : begin + packed["byteLength"]]
            self._views[number] = _meshopt.unpack(packed, data)
        return self._views[number]

    def _buffer(self, number: int) -> bytes:
        if number not in self._buffers:
            uri = self._document["buffers"][number].get("uri")
            if uri is None:
                self._buffers[number] = self._chunk
            elif uri.startswith("data:"):
                try:
                    self._buffers[number] = base64.b64decode(uri.partition(",")[2])
                except ValueError:
                    raise ShapeError(f"data of buffer {number} of the glTF file is damaged") from None
            else:
                path = self._folder / unquote(uri)
                try:
                    self._buffers[number] = path.read_bytes()
                except OSError as error:
                    raise ShapeError(f"it needs the file {uri} in the same folder: {error.strerror}") from None
        return self._buffers[number]


def _matrix(node: Dict[str, Any]) -> Floats:
    """The matrix of a node relative to its parent."""
    if "matrix" in node:
        return np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
    result = np.eye(4)
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    turn = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip
    result[:3, :3] = turn * np.array(node.get("scale", (1.0, 1.0, 1.0)))
    result[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return result


def _triangles(indices: Integers, mode: int) -> Integers:
    """The triangles, each from the corner that the format names first."""
    if mode == _TRIANGLES:
        return indices[: len(indices) // 3 * 3].reshape(-1, 3)
    i = np.arange(max(len(indices) - 2, 0))
    if mode == _FAN:
        return np.column_stack([indices[i + 1], indices[i + 2], np.full(len(i), indices[0])])
    odd = i % 2
    return np.column_stack([indices[i], indices[i + 1 + odd], indices[i + 2 - odd]])
