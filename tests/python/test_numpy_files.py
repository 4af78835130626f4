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
    four = shapes.read(write(tmp_path, "b.npy", npy(np.vstack([POINTS.T, np.ones(300)]))))  # homogeneous coordinates
    np.testing.assert_array_equal(four.points, POINTS)


def hat(rows, columns):
    """Heights on -3..3, row 0 in the north."""
    x, y = np.meshgrid(np.linspace(-3, 3, columns), np.linspace(3, -3, rows))
    return 2.4 * np.exp(-(x**2) - (y - 1) ** 2) - 0.3 * x


@pytest.mark.parametrize("sides", [(40, 40), (10, 10), (12, 60), (50, 33), (33, 50)])
@pytest.mark.parametrize("kind", ["f8", ">f4", "u2", "band", "last", "text", "npz"])
def test_arrays_of_heights_are_maps(tmp_path, sides, kind):
    heights = hat(*sides)
    if kind == "u2":
        heights = np.round(1000 * (heights + 1)).astype("u2")
    if kind == "text":
        path = tmp_path / "a.txt"
        np.savetxt(path, heights)
    elif kind == "npz":
        path = write(tmp_path, "a.npz", npz(arr_0=heights))
    else:
        shape = {"band": heights[None], "last": heights[:, :, None]}.get(kind, heights.astype(kind if len(kind) == 3 else heights.dtype))
        path = write(tmp_path, "a.npy", npy(shape))
    shape = shapes.read(path)
    rows, columns = sides
    assert len(shape.triangles) == 2 * (rows - 1) * (columns - 1) and shape.up == (0, 0, 1)
    assert shape.format.startswith("height map") and "gives no scale" in shape.notes[0]
    np.testing.assert_allclose(np.ptp(shape.points, axis=0), [columns - 1, rows - 1, 0.15 * max(sides)], rtol=1e-6)
    top = shape.points[:, 2].argmax()
    assert shape.points[top, 1] > (rows - 1) / 2  # the peak is in the north


def test_missing_heights_are_no_heights(tmp_path):
    heights = hat(40, 40)
    heights[3, 4], heights[5, 6] = np.nan, -9999
    shape = shapes.read(write(tmp_path, "a.npy", npy(heights)))
    assert len(shape.points) == 1598 and np.ptp(shape.points[:, 2]) == pytest.approx(6.0)
    assert "2 of 1600 heights are missing" in shape.notes


def test_few_columns_are_points(tmp_path):
    for sides in ((9, 9), (50, 32), (3, 3), (6, 100)):
        assert not shapes.read(write(tmp_path, "a.npy", npy(np.random.default_rng(1).normal(size=sides)))).is_mesh


@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize("grids", [False, True])
def test_heights_with_axes(tmp_path, order, grids):
    x, y = np.linspace(100, 109, 40), np.linspace(53, 47, 30)[::order]
    heights = hat(30, 40)[::order]
    places = dict(zip("xy", np.meshgrid(x, y))) if grids else {"x": x, "y": y}
    shape = shapes.read(write(tmp_path, "a.npz", npz(z=heights, **places)))
    top = shape.points[shape.points[:, 2].argmax()]
    where = np.unravel_index(heights.argmax(), heights.shape)
    np.testing.assert_allclose(top, [x[where[1]], y[where[0]], heights.max()])
    assert shape.notes == () and (shapes.samples(shape, 20)[1][:, 2] > 0).all()
    degrees = shapes.read(write(tmp_path, "a.npz", npz(elevation=1000 * heights, lon=x, lat=y)))
    np.testing.assert_allclose(np.ptp(degrees.points[:, 1]), 6 * 111_320)
    with pytest.raises(shapes.ShapeError, match="the x of the heights must be 40 numbers"):
        shapes.read(write(tmp_path, "a.npz", npz(z=heights, x=x[1:], y=y)))


def test_records_in_degrees(tmp_path):
    record = np.zeros(300, dtype=[("Lon", "f8"), ("Lat", "f8"), ("Height", "f4")])
    record["Lon"], record["Lat"], record["Height"] = NORMALS.T * [[0.01], [0.01], [50]] + [[10], [47], [500]]
    shape = shapes.read(write(tmp_path, "a.npy", npy(record)))
    assert np.ptp(shape.points[:, 1]) == pytest.approx(0.02 * 111_320, rel=0.01) and "degrees" in shape.notes[0]


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
