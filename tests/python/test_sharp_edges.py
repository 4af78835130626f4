# SPDX-License-Identifier: MIT
"""The normals in a file tell sharp edges from smooth ones."""
import json
import re
import struct

import numpy as np
import pytest
from coarse import flat_ball
from corner_normals import SIDES, obj, prism
from test_shapes import write
from test_subdivide import ball

from hrbfnpr import shapes
from hrbfnpr.cli import main
from hrbfnpr.shapes._sharp_edges import sharp_edges

def split(points, faces, normals, own):
    """Vertices with normals: a point with several normals becomes several vertices."""
    corners, number = np.unique(np.column_stack([faces.ravel(), own.ravel()]), axis=0, return_inverse=True)
    return points[corners[:, 0]], number.reshape(-1, 3), normals[corners[:, 1]]


def glb(points, faces, normals):
    parts = [np.asarray(points, "<f4").tobytes(), np.asarray(normals, "<f4").tobytes(), np.asarray(faces, "<u4").tobytes()]
    start = np.cumsum([0] + [len(part) for part in parts])
    kinds = [(5126, "VEC3", len(points)), (5126, "VEC3", len(points)), (5125, "SCALAR", faces.size)]
    document = {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
        "accessors": [{"bufferView": i, "componentType": c, "type": t, "count": n} for i, (c, t, n) in enumerate(kinds)],
        "bufferViews": [{"buffer": 0, "byteOffset": int(start[i]), "byteLength": len(part)} for i, part in enumerate(parts)],
        "buffers": [{"byteLength": int(start[-1])}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", int(start[-1]), 0x004E4942) + b"".join(parts)
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def ply(points, faces, normals):
    head = "ply\nformat ascii 1.0\n" + f"element vertex {len(points)}\n"
    head += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    rows = [" ".join(map(str, row)) for row in np.column_stack([points, normals])]
    return head + "\n".join(rows + [f"3 {a} {b} {c}" for a, b, c in faces]) + "\n"


def rims(shape):
    """The ends of the shape's sharp edges, as a set. For a prism these must be the edges of both rims."""
    return {frozenset(map(tuple, np.round(shape.points[edge], 6))) for edge in shape.sharp_edges}


def rims_of_prism():
    points = np.round(prism()[0], 6)
    return {
        frozenset([tuple(points[base + i]), tuple(points[base + (i + 1) % SIDES])])
        for base in (0, SIDES)
        for i in range(SIDES)
    }


@pytest.mark.parametrize(
    "name, data",
    [
        ("a.obj", obj(*prism())),
        ("b.obj", obj(*prism(), corner="{}/1/{}")),
        ("c.obj", obj(*prism(), back=True)),
        ("d.glb", glb(*split(*prism()))),
        ("e.ply", ply(*split(*prism()))),
    ],
)
def test_normals_of_files_mark_sharp_edges(tmp_path, name, data):
    shape = shapes.read(write(tmp_path, name, data))
    assert len(shape.triangles) == len(prism()[1])
    assert rims(shape) == rims_of_prism()


@pytest.mark.parametrize("corner", ["{}", "{}/1", "{}//{}7", "{}//x"])
def test_missing_normals_mark_no_edges(tmp_path, corner):
    shape = shapes.read(write(tmp_path, "a.obj", obj(*prism(), corner=corner)))
    assert shape.sharp_edges is None and len(shape.triangles) == len(prism()[1])


def drawn(tmp_path, capsys, text, *options):
    path = write(tmp_path, "a.obj", text)
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *options]) == 0
    return capsys.readouterr().err


def test_the_command_uses_sharp_edges_of_files(tmp_path, capsys):
    said = drawn(tmp_path, capsys, obj(*prism()), "-v")
    assert "edges are sharp or round by the normals in the file" in said and "divided" in said
    assert 0 < float(re.search(r"points between them by up to ([0-9.]+)%", said)[1]) < 3
    assert "warning" not in said
    assert "normals in the file" not in drawn(tmp_path, capsys, obj(*prism()), "--edges", "auto")
    assert "divided 2 times" in drawn(tmp_path, capsys, obj(*prism(40)), "--tolerance", "0.0005")  # less than by default
    assert "divided 1 time" in drawn(tmp_path, capsys, obj(*prism()), "--subdivide", "1")


# Removing unusable vertices renumbers the rest.
def test_sharp_edges_stay_if_vertices_are_left_out(tmp_path, capsys):
    points, faces, normals, own = prism()
    points, own = np.vstack([[[-9999.0] * 3] * 2, points]), np.vstack([own, own[:1]])
    said = drawn(tmp_path, capsys, obj(points, np.vstack([faces + 2, [[0, 1, 2]]]), normals, own))
    assert "marks missing data" in said and "edges are sharp or round by the normals" in said


def test_damaged_normals_are_ignored(tmp_path):
    points, faces, normals = split(*prism())
    whole = glb(points, faces, normals)
    for damage in ((b'"NORMAL": 1', b'"NORMAL": 7'), (b'"NORMAL": 1', b'"NORMAL": 2'), (b'"NORMAL": 1', b'"NORMAL": []')):
        data = whole.replace(*damage)
        if len(data) != len(whole):  # the JSON chunk is padded with spaces
            data = whole.replace(b'"NORMAL": 1}, ', b'"NORMAL": []},')
        shape = shapes.read(write(tmp_path, "a.glb", data))
        assert shape.sharp_edges is None and len(shape.triangles) == len(faces)


def test_a_ball_is_flat_if_its_normals_are(tmp_path, capsys):
    flat = flat_ball()
    said = drawn(tmp_path, capsys, flat)
    assert "all faces are flat" in said and "divided" not in said
    assert "divided" in drawn(tmp_path, capsys, flat, "--edges", "auto")
    points, faces = ball()
    assert "divided" in drawn(tmp_path, capsys, obj(points, faces, points, faces))


def test_zero_normals_and_fine_meshes_mark_no_edges():
    points, faces = ball()
    assert sharp_edges(points, faces, np.zeros((len(faces), 3, 3))) is None
    assert sharp_edges(points, np.tile(faces, (700, 1)), np.zeros((700 * len(faces), 3, 3))) is None  # too many faces
