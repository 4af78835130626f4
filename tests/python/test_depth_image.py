# SPDX-License-Identifier: MIT
"""Depth images: the library smooths them, and the command line draws them."""
import re

import numpy as np
import pytest
from test_shapes import write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.cli import main

STEP, NOISE = 0.0029, 0.0014  # the Kinect's step and noise in 1 / z, in 1/m


def kinect(columns=160, rows=120, step=STEP, noise=NOISE, far=4.0):
    """Points of a slanted wall and a ball before it, as a depth camera sees them, and their true depths."""
    row, column = np.indices((rows, columns))
    u, v = (column - columns / 2) / columns, (row - rows / 2) / columns
    z = far / (1 - 0.1 * u + 0.05 * v)
    along, middle = u * u + v * v + 1, 0.3 * u + 1.5
    inside = middle**2 - along * (0.3**2 + 1.5**2 - 0.3**2)
    z = np.where(inside > 0, (middle - np.sqrt(np.maximum(inside, 0))) / along, z)
    seen = 1 / z + noise * np.random.default_rng(3).normal(size=z.shape)
    seen = step * np.round(seen / step) if step else seen
    return np.stack([u / seen, v / seen, 1 / seen], axis=-1), z


def pcd(points):
    rows, columns, _ = points.shape
    head = f"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH {columns}\nHEIGHT {rows}\n"
    data = points.astype("<f4").tobytes()
    return head.encode() + f"POINTS {rows * columns}\nDATA binary\n".encode() + data


def test_points_and_normals():
    points, z = kinect()
    points[5, 7] = np.nan
    smoothed = hrbfnpr.smooth_depth_image(points)
    info = smoothed.info
    assert smoothed.points.shape == smoothed.normals.shape == (120, 160, 3)
    assert np.isnan(smoothed.points[5, 7]).all() and (smoothed.normals[5, 7] == 0).all()
    wall = (z > 3) & np.isfinite(smoothed.points[..., 2])
    before, after = ((1 / each[..., 2] - 1 / z)[wall].std() for each in (points, smoothed.points))
    assert after < 0.25 * before
    true = np.array([0.1, -0.05, -1.0]) / np.linalg.norm([0.1, -0.05, -1.0])
    assert np.degrees(np.arccos((smoothed.normals[wall] @ true).clip(-1, 1))).mean() < 4
    assert info.seen == 160 * 120 - 1 and 0 <= info.left_out < 50
    assert info.focal_length == pytest.approx(160) and info.depth == pytest.approx(4, rel=0.1) and info.radius > 5
    assert info.noise == pytest.approx(np.hypot(NOISE, STEP / 12**0.5), rel=0.2)

    single = hrbfnpr.smooth_depth_image(points.astype("f"), keep_points=True, smoothing=0.5)
    assert single.points.dtype == single.normals.dtype == np.float32
    there = np.isfinite(single.points[..., 2])
    np.testing.assert_array_equal(single.points[there], points.astype("f")[there])
    assert single.info.radius == pytest.approx(0.5 * info.radius, rel=0.01)
    given = hrbfnpr.smooth_depth_image(points, noise=0.01)
    assert given.info.noise == pytest.approx(0.01)


def test_arrays_that_are_no_image_are_refused():
    points, _ = kinect(40, 30)
    with pytest.raises(ValueError, match=r"points must have the shape \(rows, columns, 3\), not \(1200, 3\)"):
        hrbfnpr.smooth_depth_image(points.reshape(-1, 3))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="not an image of a camera at the origin"):
        hrbfnpr.smooth_depth_image(points.reshape(40, 30, 3))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="depth_image_desc.rows is 7"):
        hrbfnpr.smooth_depth_image(points[:7])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="smoothing"):
        hrbfnpr.smooth_depth_image(points, smoothing=0)


def test_files_keep_their_rows_and_columns(tmp_path):
    points, _ = kinect(40, 30)
    shape = shapes.read(write(tmp_path, "a.pcd", pcd(points)))
    assert shape.is_picture and shape.image_shape == (30, 40)
    np.testing.assert_array_equal(shape.points.reshape(*shape.image_shape, 3), points.astype("f"))


def off_the_wall(path, z):
    """The distance of a fitted surface from the wall at its pixels, and the error of its normals in degrees."""
    model = hrbfnpr.Model.load(path)
    rows, columns = z.shape
    row, column = np.indices(z.shape)
    inner = (z > 3) & (row > 5) & (row < rows - 6) & (column > 5) & (column < columns - 6)
    points = np.stack([(column - columns / 2) / columns * z, (row - rows / 2) / columns * z, z], axis=-1)[inner]
    found = model.evaluate(points, gradient=True)
    slope = np.asarray(found.gradient)
    slope /= np.linalg.norm(slope, axis=1)[:, None]
    true = np.array([0.1, -0.05, -1.0]) / np.linalg.norm([0.1, -0.05, -1.0])
    return np.std(found.value), np.degrees(np.arccos((slope @ true).clip(-1, 1))).mean()


def test_a_noisy_wall_becomes_smooth(tmp_path, capsys):
    """Depth steps are 46 mm at 4 m. A surface through them would show islands with outlines."""
    points, z = kinect()
    file = write(tmp_path, "a.pcd", pcd(points))
    assert main(["fit", str(file), str(tmp_path / "a.hrbf")]) == 0
    said = "".join(capsys.readouterr())
    assert "points in 160 x 120 pixels, smoothed over" in said
    assert re.search(r"the depth image has noise of 0\.02\d at depth (3\.9\d|4): it is smoothed", said)
    assert "normals may be wrong" not in said
    distance, angle = off_the_wall(tmp_path / "a.hrbf", z)
    assert distance < 0.004 and angle < 2

    assert main(["fit", str(file), str(tmp_path / "b.hrbf"), "--depth-smoothing", "0"]) == 0
    assert ": it is kept" in capsys.readouterr().err
    kept, turned = off_the_wall(tmp_path / "b.hrbf", z)
    assert kept > 1.05 * distance and turned < 3  # the fit reduces noise, too
    assert main(["fit", str(file), str(tmp_path / "c.hrbf"), "--depth-smoothing", "-1"]) == 1
    assert "--depth-smoothing is -1" in capsys.readouterr().err
    assert main(["fit", str(file), str(tmp_path / "c.hrbf"), "--depth-smoothing", "101"]) == 1
    assert "--depth-smoothing is 101; it must be from 0 to 100" in capsys.readouterr().err

    # The same points without their rows.
    file = write(tmp_path, "b.pcd", pcd(points.reshape(1, -1, 3)[:, ::7]))
    assert main(["fit", str(file), str(tmp_path / "d.hrbf"), "--viewpoint", "0,0,0.001"]) == 0
    rough, steep = off_the_wall(tmp_path / "d.hrbf", z)
    assert rough > 2 * distance and steep > 3 * angle


def test_gaps_in_depth_are_not_closed_as_holes(tmp_path):
    """A hole in a scan is filled, but not the gap between the ball and the wall."""
    points, z = kinect(240, 180, far=2.2)
    saved = tmp_path / "a.hrbf"
    assert main(["fit", str(write(tmp_path, "a.pcd", pcd(points))), str(saved)]) == 0
    model = hrbfnpr.Model.load(saved)
    marks = model.generate([hrbfnpr.Layer("stipples", budget=6000)])
    places = np.concatenate([np.asarray(layer.positions, dtype=float) for layer in marks.layers]) + marks.origin
    from_ball = np.linalg.norm(places - [0.3, 0.0, 1.5], axis=1) - 0.3
    from_wall = np.abs(places @ [0.1, -0.05, -1.0] + 2.2) / np.linalg.norm([0.1, -0.05, -1.0])
    between = (from_ball > 0.06) & (from_wall > 0.06)
    assert between.mean() < 0.01


def test_a_check_reports_the_smoothing(tmp_path, capsys):
    points, _ = kinect(80, 60)
    points[:20] = np.nan
    file = write(tmp_path, "a.pcd", pcd(points))
    assert main(["check", str(file)]) == 0
    said = capsys.readouterr().out
    assert "image rows: 60" in said and "image columns: 80" in said and "image seen: 3200" in said
    assert "depth image smoothed over" in said and "normals computed" in said
    assert main(["fit", str(file), str(tmp_path / "a.hrbf"), "--viewpoint", "1,2,3"]) == 0
    assert "--viewpoint is ignored: the camera of the depth image" in capsys.readouterr().err
