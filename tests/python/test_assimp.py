# SPDX-License-Identifier: MIT
"""Formats of 3D programs that assimp reads, where it is installed."""
import gzip
import shutil

import numpy as np
import pytest
from test_shapes import CUBE, QUADS, write

from hrbfnpr import shapes
from hrbfnpr.cli import main
from hrbfnpr.shapes import _optional

COLLADA = """<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>{up}</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">{places}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount><p>{corners}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><translate>1 2 3</translate><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""


def collada(up="Y_UP"):
    """A Collada box, 1 by 1 by 2, with its corner at (1, 2, 3)."""
    places = " ".join(f"{x} {y} {2 * z}" for x, y, z in CUBE)
    return COLLADA.format(up=up, places=places, corners=" ".join(str(i) for quad in QUADS for i in quad))


@pytest.fixture
def assimp():
    if shutil.which("assimp") is None:
        pytest.skip("assimp is not installed (apt-get install assimp-utils)")


@pytest.mark.parametrize("up, high", [("Y_UP", [2, 3, 5]), ("Z_UP", [2, 5, -2])])
def test_collada(assimp, tmp_path, up, high):
    shape = shapes.read(write(tmp_path, "box.dae", collada(up)))
    assert shape.format == "Collada" and shape.up == (0, 1, 0)  # z of the file becomes y
    np.testing.assert_allclose(shape.points.max(axis=0), high, atol=1e-5)
    assert len(shape.triangles) == 12


@pytest.mark.parametrize("name", ["box.dae.gz", "box.dae"])
def test_compressed_files_are_read(assimp, tmp_path, name):
    shape = shapes.read(write(tmp_path, name, gzip.compress(collada().encode())))
    assert shape.format == "Collada" and len(shape.triangles) == 12


def test_collada_is_drawn(assimp, tmp_path, capsys):
    path = write(tmp_path, "box.dae", collada())
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    assert "Collada: " in capsys.readouterr().out


def test_unreadable_files_are_named(assimp, tmp_path):
    for name, data in (("a.fbx", b"Kaydara FBX Binary  \0"), ("a.dae", b"<COLLADA>"), ("a.3ds", b"no such thing")):
        with pytest.raises(shapes.ShapeError, match="assimp cannot read it.*; Blender exports it as glTF or PLY"):
            shapes.read(write(tmp_path, name, data))


def test_a_missing_program_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(shapes.ShapeError, match="reading Collada files needs assimp .assimp-utils.; without it"):
        shapes.read(write(tmp_path, "box.dae", collada()))


def test_a_program_that_hangs_is_named(monkeypatch):
    monkeypatch.setattr(_optional, "_LONGEST", 0.2)
    with pytest.raises(shapes.ShapeError, match="sleep did not finish reading it; wake it"):
        _optional.run("sleep", ["sleep", "20"], "wake it")
