# SPDX-License-Identifier: MIT
"""Values of points that files hold besides places and normals: colours, intensities and others."""
import struct
import sys
from pathlib import Path

import numpy as np
import pytest
from test_meshes import glb, gltf
from test_scans import COLOURS, NORMALS, POINTS, las, lines, pcd
from test_shapes import ply_header, write

from hrbfnpr import shapes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
from reader_files import ptx  # noqa: E402

GREY = np.arange(60)
SHARES = COLOURS / 255


def has_colours(fields, name="rgb"):
    assert fields[name].kind == "colour" and fields[name].values.dtype == np.float32
    np.testing.assert_allclose(fields[name].values, SHARES, atol=1e-6)


def has_numbers(fields, name, values=GREY):
    assert fields[name].kind == "scalar" and fields[name].values.shape == (len(values),)
    np.testing.assert_allclose(fields[name].values, values, rtol=1e-6)


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
def test_ply(tmp_path, form):
    properties = ["float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "uchar alpha", "float quality",
                  "float scalar_Dip", "float dir_x", "float dir_y", "float dir_z", "list uchar int rings"]  # fmt: skip
    head = ply_header(form, ("vertex", 60, properties))
    if form == "ascii":
        body = lines(POINTS, COLOURS, GREY, GREY.astype(float), -GREY.astype(float), NORMALS, np.zeros(60, int)).encode()
    else:
        table = np.zeros(60, [("p", "<f4", 3), ("c", "u1", 4), ("q", "<f4", 2), ("d", "<f4", 3), ("n", "u1")])
        table["p"], table["c"][:, :3], table["d"] = POINTS, COLOURS, NORMALS
        table["q"][:, 0], table["q"][:, 1] = GREY, -GREY
        body = table.tobytes()
    fields = shapes.read(write(tmp_path, "a.ply", head + body)).fields
    assert set(fields) == {"rgb", "dir", "quality", "Dip"}
    has_colours(fields)
    has_numbers(fields, "quality")
    has_numbers(fields, "Dip", -GREY)
    assert fields["dir"].kind == "direction"
    np.testing.assert_allclose(fields["dir"].values, NORMALS, atol=1e-6)


def test_colours_of_bytes_are_not_stretched(tmp_path):
    head = ply_header("binary_little_endian", ("vertex", 2, ["float x", "float y", "float z", "uchar red", "uchar green",
                                                             "uchar blue"]))  # fmt: skip
    body = struct.pack("<3f3B3f3B", 0, 0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0)
    values = shapes.read(write(tmp_path, "a.ply", head + body)).fields["rgb"].values
    assert values.max() == np.float32(1 / 255)


def test_obj(tmp_path):
    vertices = "".join("v " + line + "\n" for line in lines(POINTS, SHARES).splitlines())
    for more in ("", "f 1 2 3\nf 2 3 4\n"):
        has_colours(shapes.read(write(tmp_path, "a.obj", vertices + more)).fields)
    uneven = vertices + "v 1 2 3\n"
    assert not shapes.read(write(tmp_path, "b.obj", uneven)).fields


def test_off(tmp_path):
    for kind, columns in (("COFF", (POINTS, COLOURS, GREY)), ("CNOFF", (POINTS, NORMALS, SHARES))):
        text = f"{kind}\n60 1 0\n{lines(*columns)}3 0 1 2\n"
        has_colours(shapes.read(write(tmp_path, "a.off", text)).fields)


@pytest.mark.parametrize("name, text", {
    "meshlab.pts": "60\n" + lines(POINTS, GREY, COLOURS, NORMALS),
    "headed.csv": "x,y,z,nx,ny,nz,R,G,B,intensity\n" + lines(POINTS, NORMALS, COLOURS, GREY, mark=","),
    "words.csv": "x,y,z,what,r,g,b,intensity\n" + "".join(
        ",".join(map(str, [*p, "a tree", *c, i])) + "\n" for p, c, i in zip(POINTS.tolist(), COLOURS.tolist(), GREY)),
}.items())  # fmt: skip
def test_tables(tmp_path, name, text):
    fields = shapes.read(write(tmp_path, name, text)).fields
    assert set(fields) == {"rgb", "intensity"}
    has_colours(fields)
    has_numbers(fields, "intensity")


def test_columns_without_names_are_numbered(tmp_path):
    fields = shapes.read(write(tmp_path, "a.xyz", lines(POINTS, NORMALS, GREY, GREY / 7))).fields
    assert set(fields) == {"column7", "column8"}
    has_numbers(fields, "column8", np.round(GREY / 7, 6))


def test_ptx(tmp_path):
    wall = POINTS.repeat(10, axis=0)
    fields = shapes.read(write(tmp_path, "a.ptx", ptx(wall, 30, more="0.5 200 100 50"))).fields
    assert set(fields) == {"intensity", "rgb"}
    has_numbers(fields, "intensity", np.full(600, 0.5))
    np.testing.assert_allclose(fields["rgb"].values, np.tile([200, 100, 50], (600, 1)) / 255, atol=1e-6)
    two = ptx(wall, 30, more="0.5") + ptx(wall, 30, more="")
    joined = shapes.read(write(tmp_path, "b.ptx", two)).fields["intensity"].values
    assert np.isfinite(joined[:600]).all() and np.isnan(joined[600:]).all() and len(joined) == 1200


def test_pcd(tmp_path):
    packed = (COLOURS[:, 0] << 16 | COLOURS[:, 1] << 8 | COLOURS[:, 2]).astype("<u4")
    plain = bytearray(pcd("binary"))
    table = np.frombuffer(plain[-60 * 28 :], [("p", "<f4", 3), ("rgb", "<u4"), ("n", "<f4", 3)]).copy()
    table["rgb"] = packed
    data = bytes(plain[: -60 * 28]) + table.tobytes()
    has_colours(shapes.read(write(tmp_path, "a.pcd", data)).fields)
    as_float = data.replace(b"TYPE F F F U", b"TYPE F F F F")
    has_colours(shapes.read(write(tmp_path, "b.pcd", as_float)).fields)
    named = b"FIELDS x y z intensity"
    has_numbers(shapes.read(write(tmp_path, "c.pcd", data.replace(b"FIELDS x y z rgb", named))).fields, "intensity", packed)


def test_las(tmp_path):
    data = bytearray(las(form=2))
    record = np.zeros((60, 26), np.uint8)
    record[:, :20] = np.frombuffer(bytes(data[-1200:]), np.uint8).reshape(60, 20)
    record[:, 12:14] = GREY.astype("<u2").view(np.uint8).reshape(60, 2)
    record[:, 20:26] = (257 * COLOURS).astype("<u2").view(np.uint8).reshape(60, 6)
    struct.pack_into("<H", data, 105, 26)
    fields = shapes.read(write(tmp_path, "a.las", bytes(data[:-1200]) + record.tobytes())).fields
    has_colours(fields)
    has_numbers(fields, "intensity")


def test_arrays_of_numpy(tmp_path):
    np.savez(tmp_path / "a.npz", points=POINTS, colors=COLOURS.astype(np.uint8), heat=GREY / 60, flow=NORMALS, other=np.eye(3))
    fields = shapes.read(tmp_path / "a.npz").fields
    assert set(fields) == {"rgb", "heat", "flow"} and fields["flow"].kind == "direction"
    has_colours(fields)
    has_numbers(fields, "heat", GREY / 60)
    record = np.zeros(60, [("x", "f8"), ("y", "f8"), ("z", "f8"), ("quality", "i4")])
    record["x"], record["y"], record["z"] = POINTS.T
    record["quality"] = GREY
    np.save(tmp_path / "a.npy", record)
    has_numbers(shapes.read(tmp_path / "a.npy").fields, "quality")


def test_gltf_colours_are_linear(tmp_path):
    document, data = gltf()
    linear = np.array([[0, 0, 0], [1, 0.5, 0.214041], [0.5, 0.5, 0.5], [1, 1, 1]], "<f4")
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": 48})
    document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126, "count": 4,
                                  "type": "VEC3"})  # fmt: skip
    part = document["meshes"][0]["primitives"][0]
    part["attributes"]["COLOR_0"] = len(document["accessors"]) - 1
    document["buffers"][0]["byteLength"] = len(data) + 48
    values = shapes.read(write(tmp_path, "a.glb", glb(document, data + linear.tobytes()))).fields["rgb"].values
    np.testing.assert_allclose(values[1], [1, 0.735357, 0.5], atol=1e-5)
    part["material"], document["materials"] = 0, [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 1, 1]}}]
    values = shapes.read(write(tmp_path, "b.glb", glb(document, data + linear.tobytes()))).fields["rgb"].values
    np.testing.assert_allclose(values[1], [1, 0, 0.5], atol=1e-5)
    del part["attributes"]["COLOR_0"]
    values = shapes.read(write(tmp_path, "c.glb", glb(document, data + linear.tobytes()))).fields["rgb"].values
    np.testing.assert_allclose(values, np.tile([1, 0, 1], (4, 1)), atol=1e-6)


def test_files_without_values_have_no_fields(tmp_path):
    for name, text in (("a.xyz", lines(POINTS, NORMALS)), ("b.xyz", lines(POINTS)), ("c.pts", "60\n" + lines(POINTS))):
        assert not shapes.read(write(tmp_path, name, text)).fields
