# SPDX-License-Identifier: MIT
"""Arrays in any layout are read, and results are returned without copies."""
import array

import numpy as np
import pytest

import hrbfnpr

POINTS = np.random.default_rng(1).uniform(-1.2, 1.2, (50, 3))


def layouts():
    wide = np.full((50, 7), np.nan)
    wide[:, 2:5] = POINTS
    apart = np.full((50, 6), np.nan)
    apart[:, ::2] = POINTS
    reversed_rows = np.ascontiguousarray(POINTS[::-1])[::-1]
    every_second = np.repeat(POINTS, 2, axis=0)[::2]
    record = np.zeros(50, dtype=[("flag", "u1"), ("p", "f8", (3,))])  # not aligned
    record["p"] = POINTS
    return {
        "packed": POINTS,
        "columns of a wider array": wide[:, 2:5],
        "numbers apart": apart[:, ::2],
        "column-major": np.asfortranarray(POINTS),
        "backwards": reversed_rows,
        "every second row": every_second,
        "unaligned field": record["p"],
        "big-endian": POINTS.astype(">f8"),
        "list": POINTS.tolist(),
        "tuples": [tuple(row) for row in POINTS],
        "array.array": array.array("d", POINTS.ravel()),
        "memoryview": memoryview(np.ascontiguousarray(POINTS)),
        "read-only": np.frombuffer(POINTS.tobytes()).reshape(50, 3),
    }


@pytest.mark.parametrize("name", layouts())
def test_every_layout_gives_the_same_bits(sphere, name):
    wanted = sphere.evaluate(POINTS, gradient=True)
    got = sphere.evaluate(layouts()[name], gradient=True)
    np.testing.assert_array_equal(got.value, wanted.value)
    np.testing.assert_array_equal(got.gradient, wanted.gradient)


def test_a_broadcast_row_is_read_as_repeated_rows(sphere):
    row = np.broadcast_to(POINTS[7], (50, 3))
    np.testing.assert_array_equal(sphere.evaluate(row).value, np.repeat(sphere.evaluate(POINTS).value[7], 50))


def test_float32_is_read_in_place(sphere):
    single = POINTS.astype(np.float32)
    np.testing.assert_array_equal(sphere.evaluate(single).value, sphere.evaluate(single.astype(float)).value)


def test_shapes_are_kept(sphere):
    grid = POINTS[:48].reshape(2, 4, 6, 3)
    result = sphere.evaluate(grid, gradient=True, hessian=True)
    assert result.value.shape == (2, 4, 6)
    assert result.gradient.shape == (2, 4, 6, 3)
    assert result.hessian.shape == (2, 4, 6, 6)
    assert result.hessian_matrix().shape == (2, 4, 6, 3, 3)
    one = sphere.evaluate(POINTS[0], gradient=True)
    assert np.ndim(one.value) == 0 and one.gradient.shape == (3,)
    assert one.value == sphere.evaluate(POINTS).value[0]
    assert sphere.project(POINTS[0]).position.shape == (3,)
    assert np.ndim(sphere.curvature(POINTS[0]).k1) == 0


def test_no_points_give_empty_results(sphere):
    result = sphere.evaluate(np.empty((0, 3)), gradient=True)
    assert result.value.shape == (0,) and result.gradient.shape == (0, 3)


@pytest.mark.parametrize(
    "points, kind",
    [
        (np.zeros((5, 2)), ValueError),
        (np.zeros(4), ValueError),
        (np.zeros((3, 5)), ValueError),
        (5.0, ValueError),
        ([[1, 2, 3], [4, 5]], ValueError),
        (["a", "b", "c"], TypeError),
        (np.zeros((5, 3), dtype=complex), TypeError),
        ([[None] * 3], TypeError),
        (None, TypeError),
    ],
)
def test_invalid_points_are_refused(sphere, points, kind):
    with pytest.raises(kind, match="points|inhomogeneous|sequence"):
        sphere.evaluate(points)


def test_nan_is_refused_with_its_index(sphere):
    bad = POINTS.copy()
    bad[17, 1] = np.nan
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"points.*17"):
        sphere.evaluate(bad)


def test_results_go_into_the_callers_arrays(sphere):
    wanted = sphere.evaluate(POINTS, gradient=True)
    table = np.full((50, 5), -9.0)
    out = hrbfnpr.Evaluation(table[:, 0], table[:, 1:4], None)
    got = sphere.evaluate(POINTS, out=out)
    assert got.gradient is out.gradient and got.hessian is None
    np.testing.assert_array_equal(table[:, 0], wanted.value)
    np.testing.assert_array_equal(table[:, 1:4], wanted.gradient)
    assert (table[:, 4] == -9).all()


@pytest.mark.parametrize(
    "value",
    [np.zeros(49), np.zeros(50, dtype=int), np.zeros((50, 1)), np.frombuffer(bytes(400))],
    ids=["short", "integers", "shape", "read-only"],
)
def test_a_wrong_destination_is_refused(sphere, value):
    with pytest.raises((ValueError, TypeError), match="value"):
        sphere.evaluate(POINTS, out=hrbfnpr.Evaluation(value, None, None))


def test_float32_results(sphere):
    result = sphere.evaluate(POINTS, gradient=True, dtype="float32")
    assert result.value.dtype == np.float32
    np.testing.assert_allclose(result.value, sphere.evaluate(POINTS).value, rtol=1e-6, atol=1e-7)
    assert sphere.evaluate(POINTS, dtype=np.float32).value.dtype == np.float32
    with pytest.raises(ValueError, match="dtype"):
        sphere.evaluate(POINTS, dtype="int32")


def test_views_share_the_librarys_memory(marks):
    first, second = marks.layers[0].positions, marks.layer("stipples").positions
    assert first.__array_interface__["data"] == second.__array_interface__["data"]
    assert first.dtype == np.float32 and not first.flags.writeable and not first.flags.owndata
    with pytest.raises(ValueError):
        first[0] = 0


def test_views_outlive_their_objects(ring):
    model = hrbfnpr.Model.fit(ring.points, ring.normals)
    points = model.points
    wanted = points.copy()
    model.close()
    del model
    np.testing.assert_array_equal(points, wanted)
    marks = hrbfnpr.PointSet.generate(ring, budget=500)
    normals = marks.layers[0].normals
    with marks:
        pass
    assert marks.closed
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)


def test_memory_is_returned(ring):
    context = hrbfnpr.Context(1)
    before = context.info.bytes_now
    for _ in range(3):
        model = hrbfnpr.Model.fit(ring.points, ring.normals, context=context)
        view = model.points
        assert context.info.bytes_now > before
        del model
        assert context.info.bytes_now > before  # the view keeps the model
        del view
        assert context.info.bytes_now == before
