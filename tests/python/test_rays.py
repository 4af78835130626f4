# SPDX-License-Identifier: MIT
"""Rays cast on a model, and which points lie inside."""
import numpy as np
import pytest
from conftest import fibonacci_sphere, torus

import hrbfnpr

BOUNDS = ((-1, -1, -1), (1, 1, 1))


@pytest.fixture(scope="module")
def ball():
    return hrbfnpr.Model.from_function(lambda p: (p * p).sum(axis=1) - 1, lambda p: 2 * p, bounds=BOUNDS)


def test_first_hits(ball):
    origins = 3 * fibonacci_sphere(200)
    directions = 0.5 * fibonacci_sphere(200)[::-1] - origins
    result = ball.cast_rays(origins, directions)
    assert result.hit_rays == 200 and (result.hits == 1).all() and (result.entering == 1).all()
    assert (result.status == hrbfnpr.RAY_STATUS["hit"]).all()
    assert result.t.shape == (200,) and result.position.shape == result.normal.shape == (200, 3)
    a, b = (directions**2).sum(axis=1), (origins * directions).sum(axis=1)
    wanted = (-b - np.sqrt(b * b - a * 8)) / a
    np.testing.assert_allclose(result.t, wanted, atol=1e-8)
    np.testing.assert_allclose(result.position, origins + wanted[:, None] * directions, atol=1e-8)
    np.testing.assert_allclose(result.normal, result.position, atol=1e-8)


def test_all_hits_in_order(ring):
    result = ring.cast_rays([[-3, 0, 0], [0, 0, 5], [-3, 0, 0.2]], [[1, 0, 0], [0, 0, -1], [1, 0, 0]], maximum_hits=6)
    assert result.t.shape == result.entering.shape == (3, 6) and result.normal.shape == (3, 6, 3)
    np.testing.assert_array_equal(result.hits, [4, 0, 4])
    np.testing.assert_allclose(result.t[0, :4], [1.6, 2.4, 3.6, 4.4], atol=1e-6)
    np.testing.assert_allclose(result.normal[0, :4, 0], [-1, 1, -1, 1], atol=1e-6)
    np.testing.assert_array_equal(result.entering[0], [1, 0, 1, 0, 0, 0])
    assert np.isinf(result.t[0, 4:]).all() and np.isinf(result.t[1]).all()
    assert result.status[1] == hrbfnpr.RAY_STATUS["miss"] and result.hit_rays == 2
    np.testing.assert_allclose(ring.evaluate(result.position[2, :4]).value, 0, atol=1e-8)
    few = ring.cast_rays([-3, 0, 0], [1, 0, 0], maximum_hits=2)
    assert few.status == hrbfnpr.RAY_STATUS["truncated"] and few.t.shape == (2,)
    np.testing.assert_array_equal(few.t, result.t[0, :2])


def test_shapes(ball):
    eye, pixels = [0, 0, 5], np.zeros((4, 6, 3)) - [0, 0, 1]
    pixels[..., 0] = np.linspace(-0.5, 0.5, 6)
    many = ball.cast_rays(eye, pixels, dtype="float32")
    assert many.t.shape == many.hits.shape == (4, 6) and many.position.shape == (4, 6, 3)
    assert many.t.dtype == many.normal.dtype == np.float32
    np.testing.assert_array_equal(many.t, ball.cast_rays(np.broadcast_to(eye, (4, 6, 3)), pixels).t.astype("f4"))
    one = ball.cast_rays(np.zeros((7, 3)), [1, 2, 3])
    assert one.t.shape == (7,) and one.hit_rays == 7
    single = ball.cast_rays(eye, [0, 0, -1])
    assert np.ndim(single.t) == np.ndim(single.hits) == 0 and single.normal.shape == (3,)
    none = ball.cast_rays(np.empty((0, 3)), np.empty((0, 3)), maximum_hits=3)
    assert none.t.shape == (0, 3) and none.position.shape == (0, 3, 3) and none.hit_rays == 0


def test_rays_may_meet_the_mesh_of_a_line_set_first(ball):
    points, normals = torus()
    ring = hrbfnpr.Model.fit(points, normals)
    lines = hrbfnpr.LineSet(ring)
    eye, ends = [0, -4, 3], np.random.default_rng(3).uniform(-1, 1, (200, 3)) * [1.2, 1.2, 0.3]
    wanted = ring.cast_rays(eye, ends - eye, maximum_hits=4)
    found = ring.cast_rays(eye, ends - eye, maximum_hits=4, line_set=lines)
    on_mesh = ring.cast_rays(eye, ends - eye, maximum_hits=4, line_set=lines, refine=False)
    for hits, off in ((found, 1e-7), (on_mesh, 0.05)):
        same = hits.hits == wanted.hits
        assert same.mean() > 0.98 and np.isfinite(hits.t[same]).any()
        both = same[:, None] & np.isfinite(wanted.t)
        assert np.quantile(np.abs(hits.t[both] - wanted.t[both]), 0.9) < off
    assert (on_mesh.t != found.t).any()
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="line_set was made for another model"):
        ball.cast_rays([0, 0, 5], [0, 0, -1], line_set=lines)


@pytest.mark.parametrize(
    "change, words",
    [
        ({"origins": [[np.nan, 0, 0]]}, r"origins\[0\] is NaN"),
        ({"directions": [[0, 0, 0]]}, r"directions\[0\] is zero"),
        ({"maximum_hits": -2}, "maximum_hits is -2"),
    ],
)
def test_bad_arguments(ball, change, words):
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=words):
        ball.cast_rays(**{"origins": [[0, 0, 5]], "directions": [[0, 0, -1]], **change})


def test_bad_shapes(ball):
    with pytest.raises(ValueError, match="directions must have the shape of origins"):
        ball.cast_rays(np.zeros((2, 3)), np.ones((3, 3)))
    with pytest.raises(ValueError, match="directions"):
        ball.cast_rays(np.zeros((2, 3)), np.ones((2, 2)))
    with pytest.raises(TypeError, match="origins"):
        ball.cast_rays(None, np.ones((2, 3)))
    with pytest.raises(ValueError, match="dtype"):
        ball.cast_rays(np.zeros((2, 3)), np.ones((2, 3)), dtype="int32")


def test_contains(ball, ring):
    points = np.random.default_rng(5).uniform(-1.5, 1.5, (500, 3))
    inside = ball.contains(points)
    assert inside.dtype == bool
    np.testing.assert_array_equal(inside, np.linalg.norm(points, axis=1) < 1)
    assert ball.contains([0, 0, 0]) and not ball.contains([0, 0, 2])
    np.testing.assert_array_equal(ring.contains([[1, 0, 0], [0, 0, 0], [0, -1.1, 0.1], [9, 9, 9]]), [1, 0, 1, 0])
    assert ball.contains(np.zeros((2, 3, 3))).shape == (2, 3)
    assert ball.contains(np.empty((0, 3))).shape == (0,)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"points\[1\]"):
        ball.contains([[0, 0, 0], [np.nan, 0, 0]])
