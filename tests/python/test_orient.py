# SPDX-License-Identifier: MIT
"""Normals of points that have none, or wrong ones."""
import numpy as np
import pytest
from conftest import torus

import hrbfnpr


@pytest.fixture(scope="module")
def cloud():
    points, normals = torus(25, 16)
    return np.asarray(points, dtype=float), np.asarray(normals, dtype=float)


def test_points_alone(cloud):
    points, normals = cloud
    found, info = hrbfnpr.orient(points)
    assert ((found * normals).sum(axis=1) > 0.95).all()
    assert (info.found, info.made, info.turned, info.direction_change) == ("none", 400, 0, None)
    assert info.closed and info.outward_by == "inside" and info.confidence > 0.9 and info.components == 1
    single = hrbfnpr.orient(points.astype("f"), dtype="f").normals
    assert single.dtype == np.float32 and ((single * normals).sum(axis=1) > 0.95).all()


def test_what_is_right_stays(cloud):
    points, normals = cloud
    kept = hrbfnpr.orient(points, normals)
    assert kept.info.found == "given" and kept.info.turned == 0
    np.testing.assert_array_equal(kept.normals, normals)
    twice = hrbfnpr.orient(points, 2 * normals.astype("f"))
    np.testing.assert_array_equal(twice.normals, 2 * normals.astype("f"))


@pytest.mark.parametrize("mode", ["auto", "inward"])
def test_inward_normals_are_turned(cloud, mode):
    points, normals = cloud
    turned = hrbfnpr.orient(points, -normals, mode)
    np.testing.assert_array_equal(turned.normals, normals)
    assert turned.info.found == "inward" and turned.info.turned == 400


def test_patches_are_repaired(cloud):
    points, normals = cloud
    mixed = np.where(points[:, :1] > 0.8, -normals, normals)
    repaired = hrbfnpr.orient(points, mixed)
    np.testing.assert_array_equal(repaired.normals, normals)
    assert repaired.info.found == "mixed" and repaired.info.turned == (points[:, 0] > 0.8).sum()


def test_colours_are_no_normals(cloud):
    points, normals = cloud
    made = hrbfnpr.orient(points, np.random.default_rng(3).random((400, 3)))
    assert made.info.found == "none" and made.info.direction_change > 20
    assert ((made.normals * normals).sum(axis=1) > 0.95).all()


def test_viewpoint_and_up():
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0))
    points = np.stack([x, y, np.sin(0.7 * x) + np.cos(0.6 * y)], axis=-1)
    up = hrbfnpr.orient(points)
    assert up.normals.shape == (12, 12, 3) and (up.normals[..., 2] > 0).all() and up.info.outward_by == "up"
    assert (hrbfnpr.orient(points, up=(0, 0, -2)).normals[..., 2] < 0).all()
    below = hrbfnpr.orient(points, viewpoint=(6, 6, -40))
    assert (below.normals[..., 2] < 0).all() and below.info.outward_by == "viewpoint"


def test_bad_input_is_named(cloud):
    points, normals = cloud
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="points has 3 elements"):
        hrbfnpr.orient(points[:3])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="one line"):
        hrbfnpr.orient(np.arange(10.0)[:, None] * [1.0, 2.0, 3.0])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"points\[5\] is NaN"):
        hrbfnpr.orient(np.where(np.arange(400)[:, None] == 5, np.nan, points))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="give one normal for each point"):
        hrbfnpr.orient(points, mode="mixed")
    with pytest.raises(ValueError, match="mode must be one of"):
        hrbfnpr.orient(points, normals, "sideways")


def test_a_fit_without_normals(cloud):
    points, normals = cloud
    model = hrbfnpr.Model.fit(points)
    assert model.info.normals_found == "none" and model.info.normals_confidence > 0.9
    assert model.contains([1, 0, 0]) and not model.contains([0, 0, 0])
    turned = hrbfnpr.Model.fit(points, -normals, normal_mode="auto")
    assert turned.contains([1, 0, 0]) and turned.info.normals_turned == 400
    silent = hrbfnpr.Model.fit(points, -normals)
    assert silent.info.normals_inward and silent.info.normals_confidence is None
    assert not hrbfnpr.Model.fit(points, normals).info.normals_inward


def test_progress_and_cancelling(cloud):
    seen = []
    hrbfnpr.orient(cloud[0], progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1.0
    operation = hrbfnpr.Operation()
    operation.cancel()
    with pytest.raises(hrbfnpr.CancelledError):
        hrbfnpr.orient(cloud[0], operation=operation)
