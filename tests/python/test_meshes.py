# SPDX-License-Identifier: MIT
"""Mesh files and glTF, as programs write them."""
import base64
import json
import struct

import numpy as np
import pytest
from test_files import CUBE_OBJ
from test_shapes import CUBE, FACES, QUADS, VERTICES, ply_header, stl, triangle_set, write

from hrbfnpr import shapes

# --- PLY, OBJ, OFF, STL ------------------------------------------------------------------------


def test_ply_of_triangles_and_quads_in_binary(tmp_path):
    faces = ("face", 3, ["list uchar uint vertex_indices", "uchar red"])
    data = ply_header("binary_big_endian", ("vertex", 8, ["double x", "double y", "double z"]), faces)
    data += CUBE.astype(">f8").tobytes() + struct.pack(">B4IB", 4, *QUADS[0], 9)
    data += struct.pack(">B3IB", 3, 4, 5, 7, 9) + struct.pack(">B4IB", 4, *QUADS[2], 9)
    shape = shapes.read(write(tmp_path, "a.ply", data))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert triangle_set(shape.triangles) == {(0, 2, 3), (0, 3, 1), (4, 5, 7), (0, 1, 5), (0, 5, 4)}


def test_ply_lists_with_invalid_numbers_are_refused(tmp_path):
    points = ("vertex", 3, ["float x", "float y", "float z"])
    data = ply_header("binary_little_endian", points, ("face", 1, ["list float int vertex_indices"]))
    with pytest.raises(shapes.ShapeError, match="line 9: the PLY header has lists whose length is a float"):
        shapes.read(write(tmp_path, "a.ply", data + bytes(64)))
    data = ply_header("binary_little_endian", points, ("face", 1, ["list uchar float vertex_indices"]))
    for odd in (float("nan"), 1e30):
        corners = bytes(36) + struct.pack("<B3f", 3, 0, 1, odd)
        with pytest.raises(shapes.ShapeError, match="a list 'vertex_indices' with something that is not a number, or too large"):
            shapes.read(write(tmp_path, "b.ply", data + corners))


def test_wrong_indices_are_named_with_line_and_column(tmp_path):
    ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    ply += "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n"
    cases = {
        "a.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3\nf 1/1 2/2 9/3\n",
                  "line 6, column 4: a face names vertex 9, but there are 3 vertices, 1 to 3"),
        "b.obj": ("v 0 0 0\nv 1 0 0\nf 1 2 0\n", "line 3, column 4: a face names vertex 0, but there are 2"),
        "c.obj": ("v 0 0 0\nv 1 0 \\\n 0\nv 0 1 0\nf 1 2 x\n", "line 5, column 4: a face has the corner 'x'"),
        "d.obj": ("v 0 0 0\nv 1 zero 0\n", "line 2, column 3: 'zero' is not a number"),
        "a.off": ("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 -4\n",
                  "line 7: a face names vertex -4, but there are 3 vertices, 0 to 2"),
        "a.ply": (ply, "line 14: a face names vertex 7, but there are 3 vertices, 0 to 2"),
    }  # fmt: skip
    for name, (text, words) in cases.items():
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, name, text))


def test_obj_dialects(tmp_path):
    text = CUBE_OBJ.replace("\n", " \r\n").replace("v ", "  v\t").replace("f 1 3 4 2", "f 1/1/1 \\\r\n 3//1 4/4 -7")
    shape = shapes.read(write(tmp_path, "a.obj", text))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert triangle_set(shape.triangles) == triangle_set(shapes.read(write(tmp_path, "b.obj", CUBE_OBJ)).triangles)
    coloured = "".join(f"v {x} {y} {z} 0.5 0.5 0.5\n" for x, y, z in CUBE)
    shape = shapes.read(write(tmp_path, "c.obj", coloured))
    assert shape.normals is None and shape.columns[3:] == ("red", "green", "blue")


@pytest.mark.parametrize(
    "data, words",
    [
        (stl(True)[:-10], "ends in the middle of its 4 triangles, after 3"),
        (stl(False)[:200], "ends in the middle"),
        (stl(False).replace(b"endsolid cube\n", b""), "there is no endsolid"),
        (b"solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 zero\n", "line 4, column 4: 'zero' is not a number"),
        (b"solid a\nfacet normal 0 0 0\nendsolid a\n", "no triangles"),
        (bytes(84), "no triangles"),
    ],
)
def test_broken_stl(tmp_path, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.stl", data))


@pytest.mark.parametrize("binary", [True, False])
def test_stl_has_z_up(tmp_path, binary):
    shape = shapes.read(write(tmp_path, "a.stl", stl(binary)))
    assert shape.up == (0, 0, 1) and len(shape.triangles) == 4
    np.testing.assert_allclose(shape.points[shape.triangles[0]], VERTICES[FACES[0]])


# --- glTF --------------------------------------------------------------------------------------


def gltf(triangles=FACES, node=None, mode=4, skin=None, normals=None, sparse=False, stride=0):
    """A glTF document and its binary data: a tetrahedron."""
    data, views, accessors = b"", [], []

    def add(array, kind, component, width=0):
        nonlocal data
        raw = array.tobytes()
        view = {"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)}
        if width:
            padded = np.zeros((len(array), width), np.uint8)
            padded[:, : array.itemsize * array.shape[1]] = array.view(np.uint8).reshape(len(array), -1)
            raw, view["byteStride"] = padded.tobytes(), width
        views.append(view)
        data += raw + bytes(-len(raw) % 4)
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind})
        return len(accessors) - 1

    attributes = {"POSITION": add(VERTICES.astype("<f4"), "VEC3", 5126, stride)}
    if normals is not None:
        attributes["NORMAL"] = add(normals.astype("<f4"), "VEC3", 5126)
    part = {"attributes": attributes, "mode": mode}
    if triangles is not None:
        part["indices"] = add(np.array(triangles, "<u2").reshape(-1, 1), "SCALAR", 5123)
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1]}, {"mesh": 0, **(node or {})}], "meshes": [{"primitives": [part]}],
        "accessors": accessors, "bufferViews": views,
    }  # fmt: skip
    if sparse:
        add(np.array([[3]], "<u1"), "SCALAR", 5121)
        add(np.array([[0, 0, 9]], "<f4"), "VEC3", 5126)
        accessors[0]["sparse"] = {"count": 1, "indices": {"bufferView": len(views) - 2, "componentType": 5121},
                                  "values": {"bufferView": len(views) - 1}}  # fmt: skip
    if skin is not None:
        attributes["JOINTS_0"] = add(np.zeros((4, 4), "<u1"), "VEC4", 5121)
        attributes["WEIGHTS_0"] = add(np.tile([1, 0, 0, 0], (4, 1)).astype("<f4"), "VEC4", 5126)
        document["nodes"].append({"translation": skin})
        document["nodes"][0]["children"].append(2)
        document["nodes"][1]["skin"] = 0
        document["skins"] = [{"joints": [2]}]
    document["buffers"] = [{"byteLength": len(data)}]
    return document, data


def glb(document, data):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


@pytest.mark.parametrize("form", ["glb", "beside", "within", "strided"])
def test_gltf_forms(tmp_path, form):
    document, data = gltf(stride=20 if form == "strided" else 0)
    if form == "beside":
        (tmp_path / "a b.bin").write_bytes(data)
        document["buffers"][0]["uri"] = "a%20b.bin"
    elif form == "within":
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    binary = form in ("glb", "strided")
    path = write(tmp_path, "a.glb" if binary else "a.gltf", glb(document, data) if binary else json.dumps(document))
    shape = shapes.read(path)
    np.testing.assert_array_equal(shape.points, VERTICES)
    assert triangle_set(shape.triangles) == triangle_set(FACES) and shape.up == (0, 1, 0)


def test_gltf_nodes(tmp_path):
    turn = {"translation": [1, 2, 3], "rotation": [0, 0, 0.5**0.5, 0.5**0.5], "scale": [2, 2, 2]}
    shape = shapes.read(write(tmp_path, "a.glb", glb(*gltf(node=turn))))
    np.testing.assert_allclose(shape.points[1], [1, 4, 3], atol=1e-6)  # x became y, twice as long
    mirror = {"matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]}
    shape = shapes.read(write(tmp_path, "b.glb", glb(*gltf(node=mirror))))
    np.testing.assert_array_equal(shape.points[1], [4, 0, 0])
    assert shapes.mesh_facts(shape).closed and not shapes.mesh_facts(shape).inside_out
    # A skinned mesh is placed by its joints, not by its node.
    shape = shapes.read(write(tmp_path, "c.glb", glb(*gltf(node={"translation": [50, 0, 0]}, skin=[0, 0, 7]))))
    np.testing.assert_array_equal(shape.points[0], [0, 0, 7])
    shape = shapes.read(write(tmp_path, "d.glb", glb(*gltf(sparse=True))))
    np.testing.assert_array_equal(shape.points[3], [0, 0, 9])


def test_a_gltf_node_with_several_parents_appears_under_each(tmp_path):
    """A node that is the child of several nodes is placed once for each of them."""
    document, data = gltf()
    document["nodes"][0]["children"] = [2, 3]
    document["nodes"] += [{"children": [1]}, {"translation": [9, 0, 0], "children": [1]}]
    shape = shapes.read(write(tmp_path, "a.glb", glb(document, data)))
    np.testing.assert_array_equal(shape.points[4:], shape.points[:4] + [9, 0, 0])
    assert len(shape.triangles) == 8
    document["nodes"][0]["children"] = [2] * 400_000
    with pytest.raises(shapes.ShapeError, match="more than 100000 nodes"):
        shapes.read(write(tmp_path, "b.glb", glb(document, data)))


def test_gltf_modes(tmp_path):
    strip = shapes.read(write(tmp_path, "a.glb", glb(*gltf([[0], [1], [2], [3]], mode=5))))
    assert triangle_set(strip.triangles) == {(0, 1, 2), (1, 3, 2)}
    fan = shapes.read(write(tmp_path, "b.glb", glb(*gltf([[0], [1], [2], [3]], mode=6))))
    assert triangle_set(fan.triangles) == {(0, 1, 2), (0, 2, 3)}
    points = shapes.read(write(tmp_path, "c.glb", glb(*gltf(None, mode=0, normals=VERTICES + 1))))
    assert not points.is_mesh
    np.testing.assert_array_equal(points.normals, VERTICES + 1)


def broken_gltf(change):
    document, data = gltf()
    change(document)
    return glb(document, data)


@pytest.mark.parametrize(
    "name, data, words",
    [
        ("a.glb", glb(*gltf())[:-20], r"cut short: it has \d+ of \d+ bytes"),
        ("a.glb", b"glTF" + struct.pack("<II", 1, 20) + bytes(20), "version 1"),
        ("a.gltf", b'{"asset": {}, "meshes": {"cube": {}}, "nodes": {}}', "version 1 are not read"),
        ("a.glb", broken_gltf(lambda d: d["accessors"][0].update(count=4000)), "cut short"),
        ("a.glb", broken_gltf(lambda d: d["accessors"][1].update(componentType=1)), "has an unknown type 1"),
        ("a.glb", broken_gltf(lambda d: d["accessors"][0].pop("componentType")), "has no 'componentType'"),
        ("a.glb", broken_gltf(lambda d: d["accessors"].pop()), "an index is larger than its list"),
        ("a.glb", broken_gltf(lambda d: d.update(scene=[0])), "a value has the wrong type"),
        ("a.glb", broken_gltf(lambda d: d["nodes"][1].update(children=[0])), "contain each other"),
        ("a.glb", broken_gltf(lambda d: d.update(meshes=[{"primitives": []}])), "no triangles"),
        ("a.glb", glb(*gltf([[0, 1, 7]])), "names vertex 7, but its part has only 4"),
        ("a.gltf", '{"asset": {}, "buffers": [{"uri": "lost.bin"}], ', "line 1, column"),
        ("a.gltf", json.dumps({**gltf()[0], "buffers": [{"uri": "lost.bin"}]}), "needs the file lost.bin in the same folder"),
    ],
)
def test_broken_gltf(tmp_path, name, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, name, data))
