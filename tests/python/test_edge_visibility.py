# SPDX-License-Identifier: MIT
"""Edges that a glTF file marks as hard, by EXT_mesh_primitive_edge_visibility, are sharp; all others are smooth."""
import json
import struct

import numpy as np
import pytest
from corner_normals import prism
from test_sharp_edges import rims, rims_of_prism
from test_shapes import write
from test_subdivide import ball

from hrbfnpr import shapes
from hrbfnpr.cli import main

NAME = "EXT_mesh_primitive_edge_visibility"
TYPES = {"<f4": 5126, "<u4": 5125, "<u2": 5123, "<u1": 5121}


def glb(points, indices, mode=4, visibility=None, strings=(), string_type="<u2", more=(), material=None):
    """A mesh with the visibility of its edges, and line strings as lists of indices."""
    arrays = [("<f4", np.asarray(points)), ("<u4", np.asarray(indices).reshape(-1))]
    said = {} if material is None else {"material": material}
    if visibility is not None:
        said["visibility"] = len(arrays)
        arrays.append(("<u1", np.asarray(visibility)))
    if strings:
        restart = np.iinfo(string_type).max
        joined = [index for string in strings for index in (*string, restart)][:-1]
        said["lineStrings"] = [{"indices": len(arrays)}]
        arrays.append((string_type, np.array(joined)))
    parts = [array.astype(kind).tobytes() for kind, array in arrays]
    parts = [part + bytes(-len(part) % 4) for part in parts]
    start = np.cumsum([0] + [len(part) for part in parts])
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "mode": mode, "extensions": {NAME: said}}
    document = {
        "asset": {"version": "2.0"}, "extensionsUsed": [NAME], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive, *more]}],
        "accessors": [{"bufferView": i, "componentType": TYPES[kind], "type": "VEC3" if array.ndim > 1 else "SCALAR",
                       "count": len(array)} for i, (kind, array) in enumerate(arrays)],
        "bufferViews": [{"buffer": 0, "byteOffset": int(start[i]), "byteLength": len(part)} for i, part in enumerate(parts)],
        "buffers": [{"byteLength": int(start[-1])}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", int(start[-1]), b"BIN\0") + b"".join(parts)
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def coded(values):
    """Visibilities of edges, two bits each, the lowest bits first."""
    values = np.concatenate([values, np.zeros(-len(values) % 4, int)]).reshape(-1, 4)
    return (values << [0, 2, 4, 6]).sum(axis=1)


def values_of(points, triangles, hard):
    """The visibility of all edges: 2 for the first side of a hard edge and 3 for others, 1 for the first of the rest."""
    seen, values = set(), []
    for triangle in triangles:
        for i in range(3):
            ends = frozenset(tuple(np.round(points[triangle[k]], 6)) for k in (i, (i + 1) % 3))
            first = ends not in seen
            seen.add(ends)
            values.append((2 if first else 3) if ends in hard else int(first))
    return np.array(values)


def edges_of(shape):
    return {frozenset(map(int, edge)) for edge in shape.sharp_edges}


def test_bits_are_read_as_the_extension_says(tmp_path):
    square = [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]]
    data = glb(square, [0, 1, 2, 0, 2, 3], visibility=[18, 2])  # the example of the extension
    assert edges_of(shapes.read(write(tmp_path, "a.glb", data))) == {frozenset((0, 1)), frozenset((2, 3))}
    for mode, indices in ((5, [1, 0, 2, 3]), (6, [0, 1, 2, 3])):  # strips and fans, in the order of the format
        order = {5: [(1, 0, 2), (0, 3, 2)], 6: [(1, 2, 0), (2, 3, 0)]}[mode]
        values = [2 * (edge == (2, 3) or edge == (3, 2)) for t in order for edge in zip(t, (*t[1:], t[0]))]
        data = glb(square, indices, mode, coded(np.array(values)))
        assert edges_of(shapes.read(write(tmp_path, f"{mode}.glb", data))) == {frozenset((2, 3))}


def test_hard_edges_are_sharp_and_others_are_round(tmp_path, capsys):
    points, faces = prism()[:2]
    path = write(tmp_path, "a.glb", glb(points, faces, visibility=coded(values_of(points, faces, rims_of_prism()))))
    shape = shapes.read(path)
    assert rims(shape) == rims_of_prism() and shape.notes == ()
    picture = ["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]
    assert main([*picture, "-v"]) == 0
    assert "edges are sharp or round by the normals in the file" in capsys.readouterr().err
    points, faces = ball()
    all_hard = {frozenset(map(tuple, np.round(points[face[[i, (i + 1) % 3]]], 6))) for face in faces for i in range(3)}
    write(tmp_path, "a.glb", glb(points, faces, visibility=coded(values_of(points, faces, all_hard))))
    assert main([*picture, "-v"]) == 0
    assert "all faces are flat" in capsys.readouterr().err


@pytest.mark.parametrize("string_type", ["<u1", "<u2", "<u4"])
def test_line_strings_are_hard_edges(tmp_path, string_type):
    points, faces = prism()[:2]
    sides = len(rims_of_prism()) // 2
    strings = [[*range(sides), 0], [*range(sides, 2 * sides), sides]]
    one = shapes.read(write(tmp_path, "a.glb", glb(points, faces, strings=strings, string_type=string_type)))
    assert rims(one) == rims_of_prism()
    half = coded(values_of(points, faces, {edge for edge in rims_of_prism() if all(end[2] > 0 for end in edge)}))
    low = [string for string in strings if points[string[0]][2] <= 0]
    both = shapes.read(write(tmp_path, "b.glb", glb(points, faces, visibility=half, strings=low, material=0)))
    assert rims(both) == rims_of_prism()
    assert both.notes == ("edges have materials of their own, which are not used",)


def test_outlines_of_cesium_are_hard_edges(tmp_path):
    points, faces = prism()[:2]
    sides = len(rims_of_prism()) // 2
    pairs = [index for base in (0, sides) for i in range(sides) for index in (base + i, base + (i + 1) % sides)]
    data = glb(points, faces, strings=[pairs])
    said, outline = b'"EXT_mesh_primitive_edge_visibility": {"lineStrings": [{"indices": 2}]}', b'"CESIUM_primitive_outline": {"indices": 2}'
    assert said in data
    assert rims(shapes.read(write(tmp_path, "a.glb", data.replace(said, outline.ljust(len(said)))))) == rims_of_prism()


def test_edges_belong_to_their_part(tmp_path):
    points, faces = prism()[:2]
    values = coded(values_of(points, faces, rims_of_prism()))
    plain = {"attributes": {"POSITION": 0}, "indices": 1}
    shape = shapes.read(write(tmp_path, "a.glb", glb(points, faces, visibility=values, more=[plain])))
    assert len(shape.points) == 2 * len(points) and shape.sharp_edges.max() < len(points)


def test_damaged_edges_are_named(tmp_path):
    points, faces = prism()[:2]
    for data, words in (
        (glb(points, faces, visibility=[0, 1]), f"edges of a part .* are cut short: 2 bytes for {len(faces)} triangles"),
        (glb(points, faces, strings=[[0, 1, 999]]), "an edge names vertex 999, but its part has only"),
        (glb(points, faces, visibility=[0]).replace(b'"visibility": 2', b'"visibility": 9'), "an index is larger"),
        (glb(points, faces, strings=[[0, 1]]).replace(b'[{"indices": 2}]', b'{"indices": 2}  '), "wrong type"),
    ):
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.glb", data))
