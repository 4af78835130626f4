# SPDX-License-Identifier: MIT
"""Points and meshes in NumPy files."""
import io

import numpy as np
import pytest
from conftest import fibonacci_sphere
from test_shapes import CUBE, QUADS, write

from hrbfnpr import shapes
from hrbfnpr.cli import main

NORMALS = fibonacci_sphere(300)
POINTS = 2 * NORMALS + 1


def npy(array):
    data = io.BytesIO()
    np.save(data, array, allow_pickle=array.dtype.hasobject)
    return data.getvalue()


def npz(**arrays):
    data = io.BytesIO()
    np.savez_compressed(data, **arrays)
    return data.getvalue()


@pytest.mark.parametrize("name", ["a.npy", "a.xyz"])
@pytest.mark.parametrize("kind", [np.float32, np.float64, ">f4"])
def test_rows_are_points(tmp_path, name, kind):
    shape = shapes.read(write(tmp_path, name, npy(np.hstack([POINTS, NORMALS]).astype(kind))))
    assert shape.format == "NPY" and shape.columns == ("x", "y", "z", "nx", "ny", "nz")
    np.testing.assert_allclose(shape.points, POINTS, atol=1e-6)
    np.testing.assert_allclose(shape.normals, NORMALS, atol=1e-6)


def test_colours_are_no_normals(tmp_path):
    colours = np.random.default_rng(1).integers(0, 256, (300, 3))
    shape = shapes.read(write(tmp_path, "a.npy", npy(np.hstack([POINTS, colours]))))
    assert shape.normals is None and shape.columns[3:] == ("red", "green", "blue")


def test_records_are_read_by_name(tmp_path):
    record = np.zeros(300, dtype=[("intensity", "u2"), ("x", "f4"), ("y", "f4"), ("z", "f4"), *((f"normal_{c}", "f4") for c in "xyz")])
    for k, axis in enumerate("xyz"):
        record[axis], record[f"normal_{axis}"] = POINTS[:, k], NORMALS[:, k]
    shape = shapes.read(write(tmp_path, "a.npy", npy(record)))
    np.testing.assert_allclose(shape.points, POINTS, atol=1e-6)
    np.testing.assert_allclose(shape.normals, NORMALS, atol=1e-6)


def test_an_image_of_points_is_read_row_by_row(tmp_path):
    shape = shapes.read(write(tmp_path, "a.npy", npy(POINTS.reshape(15, 20, 3))))
    np.testing.assert_array_equal(shape.points, POINTS)


def test_columns_may_be_points(tmp_path):
    shape = shapes.read(write(tmp_path, "a.npy", npy(POINTS.T)))
    np.testing.assert_array_equal(shape.points, POINTS)
    assert shape.notes == ("the array is 3 x 300: its columns are read as points",)


@pytest.mark.parametrize("faces", [np.array(QUADS), np.array(QUADS, dtype=np.uint32)])
def test_arrays_are_read_by_name(tmp_path, faces):
    shape = shapes.read(write(tmp_path, "a.npz", npz(Vertices=np.array(CUBE, dtype=np.float32), faces=faces)))
    assert shape.format == "NPZ" and len(shape.points) == 8 and len(shape.triangles) == 12
    cloud = shapes.read(write(tmp_path, "b.npz", npz(points=POINTS, normals=NORMALS)))
    assert cloud.triangles is None
    np.testing.assert_array_equal(cloud.normals, NORMALS)
    np.testing.assert_array_equal(shapes.read(write(tmp_path, "c.npz", npz(arr_0=POINTS))).points, POINTS)


@pytest.mark.parametrize(
    "name, data, words",
    [
        ("a.npy", npy(POINTS)[:500], "not a usable NumPy file"),
        ("a.npy", npy(np.array([{}], dtype=object)), "not a usable NumPy file: it holds Python objects; save numbers"),
        ("a.npy", npy(POINTS[:, :2]), "is 300 x 2; give points as an array of n x 3"),
        ("a.npy", npy(np.array(1.0)), "is a single number"),
        ("a.npy", npy(np.array([["a", "b", "c"]])), "holds <U1, not numbers"),
        ("a.npy", npy(np.zeros(3, dtype=[("a", "f4")])), "its records have no fields x, y and z; they have a"),
        ("a.npy", npy(np.zeros((0, 3))), "there are no points"),
        ("a.npz", npz(cells=np.zeros((3, 3), dtype=int)), "among cells"),
        ("a.npz", npz(points=POINTS, normals=NORMALS[:5]), "normals is 5 x 3, but points is 300 x 3"),
        ("a.npz", npz(points=POINTS, faces=np.zeros((3, 3))), "faces is 3 x 3 and holds float64"),
        ("a.npz", npz(points=POINTS, faces=np.full((1, 3), 300)), "a face names vertex 300, but there are only 300"),
        ("a.npz", npz(points=POINTS)[:400], "not a usable"),
        ("a.npz", b"PK\3\4 and so on", "not a usable"),
    ],
)
def test_faults_are_named(tmp_path, name, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, name, data))


def test_arrays_are_drawn(tmp_path, capsys):
    path = write(tmp_path, "ball.npz", npz(points=POINTS))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    assert "NPZ: 300 points" in capsys.readouterr().out
