# SPDX-License-Identifier: MIT
"""Normals of points that have no normals, or wrong ones."""
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
