# SPDX-License-Identifier: MIT
"""glTF files with Draco compression."""
import shutil
import subprocess

import numpy as np
import pytest
from test_meshes import glb
from test_meshopt import torus_mesh

from hrbfnpr import shapes


def document_of(data, skin=False):
    node = {"mesh": 0, "translation": [1, 2, 3], **({"skin": 0} if skin else {})}
    extension = {"bufferView": 0, "attributes": {"POSITION": 0}}
    attributes = {"POSITION": 0, **({"JOINTS_0": 1, "WEIGHTS_0": 2} if skin else {})}
    part = {"attributes": attributes, "indices": 1, "extensions": {"KHR_draco_mesh_compression": extension}}
    return {
        "asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"], "nodes": [node],
        "skins": [{"joints": [0]}], "meshes": [{"primitives": [part]}], "buffers": [{"byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "accessors": [
            {"componentType": 5126, "count": 800, "type": "VEC3"}, {"componentType": 5123, "count": 4800, "type": "SCALAR"},
        ],
    }  # fmt: skip


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    """A torus as Draco data."""
    encoder = shutil.which("draco_encoder")
    if encoder is None:
        pytest.skip("Draco is not installed (apt-get install draco)")
    folder = tmp_path_factory.mktemp("draco")
    points, _, triangles = torus_mesh()
    rows = [f"v {x} {y} {z}\n" for x, y, z in points] + [f"f {a} {b} {c}\n" for a, b, c in triangles + 1]
    (folder / "a.obj").write_text("".join(rows))
    command = [encoder, "-i", str(folder / "a.obj"), "-o", str(folder / "a.drc"), "-qp", "16"]
    subprocess.run(command, check=True, capture_output=True)
    return (folder / "a.drc").read_bytes()


@pytest.mark.parametrize("skin", [False, True])
def test_a_compressed_mesh_is_read(packed, tmp_path, skin):
    path = tmp_path / "a.glb"
    path.write_bytes(glb(document_of(packed, skin), packed))
    shape = shapes.read(path)
    points, _, triangles = torus_mesh()
    moved = points + (0 if skin else np.array([1, 2, 3]))  # a skinned mesh is placed by its joints, not by its node
    near = np.linalg.norm(shape.points[:, None] - moved, axis=2)
    assert near.min(axis=1).max() < 1e-3 and near.min(axis=0).max() < 1e-3
    assert shape.triangles.shape == triangles.shape


def test_damaged_data_is_refused(packed, tmp_path):
    path = tmp_path / "a.glb"
    path.write_bytes(glb(document_of(packed[:40]), packed[:40]))
    with pytest.raises(shapes.ShapeError, match="that Draco compressed is damaged"):
        shapes.read(path)


def test_a_missing_program_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    path = tmp_path / "a.glb"
    path.write_bytes(glb(document_of(b"DRACO"), b"DRACO"))
    with pytest.raises(shapes.ShapeError, match="needs draco_decoder .draco.; without it, save it without compression"):
        shapes.read(path)
