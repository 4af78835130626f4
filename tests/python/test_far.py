# SPDX-License-Identifier: MIT
"""What lies so far away that all else would be a dot in the picture."""
import numpy as np
import pytest
from conftest import fibonacci_sphere
from test_input import lost, no_data, obj, table, tube
from test_shapes import write

import hrbfnpr
from hrbfnpr.cli import _looks, main
from hrbfnpr.shapes import Shape


def test_strays_are_few_and_far():
    points = fibonacci_sphere(2000)
    assert not _looks.strays(points).any()
    two = np.vstack([points, [[9.0, 0, 0], [0, -20, 0]]])
    assert list(np.flatnonzero(_looks.strays(two))) == [2000, 2001]
    assert not _looks.strays(np.vstack([points, [[3.0, 0, 0]]])).any()  # not so far
    assert not _looks.strays(np.vstack([points, points[:40] + [30, 0, 0]])).any()  # not so few
    assert not _looks.strays(points[:150] + 0).any()
    assert list(np.flatnonzero(_looks.strays(np.vstack([two, [[np.nan, 0, 0]]])))) == [2000, 2001]
    rod = np.column_stack([np.linspace(0, 100, 3000), np.zeros(3000), np.zeros(3000)])
    assert not _looks.strays(rod).any()


def test_values_that_stand_for_none():
    points = np.random.default_rng(1).uniform(0, 50, (100, 3))
    points[[3, 7], 2] = -9999
    shape, count, value = _looks.without_data(Shape(points))
    assert (count, value, len(shape.points)) == (2, -9999, 98)
    deep = points.copy()
    deep[[3, 7], 2] = np.linspace(-9999, -9000, 2)  # one of them, and others near to it
    deep[8:40, 2] = -9990
    assert _looks.without_data(Shape(deep))[1] == 0
    alone = Shape(np.full((3, 3), -9999.0))
    assert _looks.without_data(alone)[0] is alone
    points[8, 2] = 1
    none = Shape(points, None, np.array([[2, 3, 4]]))  # no face would be left
    assert _looks.without_data(none) == (none, 0, 0.0)
    mesh = Shape(points, points.copy(), np.array([[0, 1, 2], [2, 3, 4], [5, 6, 8]]))
    left = _looks.without_data(mesh)[0]
    assert len(left.points) == len(left.normals) == 98
    np.testing.assert_array_equal(left.points[left.triangles], points[[[0, 1, 2], [5, 6, 8]]])


@pytest.mark.parametrize("option", [[], ["--parts", "all"]])
def test_the_picture_is_of_what_is_left(tmp_path, capsys, option):
    path = write(tmp_path, "a.obj", lost())
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *option]) in (0, 3)
    assert ("far from all others" in capsys.readouterr().err) == (not option)


def test_outliers_are_kept_where_they_are_asked_for(tmp_path, capsys):
    points = fibonacci_sphere(1000)
    path = write(tmp_path, "a.xyz", table(np.vstack([points, [[40, 0, 0]]]), np.vstack([points, [[1, 0, 0]]])))
    for option in ([], ["--outliers", "keep"]):
        main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *option])
        assert ("far from all others" in capsys.readouterr().err) == (not option)


def test_nothing_is_said_of_a_mesh_without_such(tmp_path, capsys):
    vertices, faces = tube()
    path = write(tmp_path, "a.obj", obj(vertices, faces))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    assert "left out" not in capsys.readouterr().err


def test_the_check_says_so(tmp_path, capsys):
    points = fibonacci_sphere(1000)
    path = write(tmp_path, "a.xyz", table(np.vstack([points, [[40, 0, 0]]]), np.vstack([points, [[1, 0, 0]]])))
    assert main(["check", str(path)]) == 0
    assert "1 point far from all others left out" in capsys.readouterr().out
    path = write(tmp_path, "b.obj", no_data())
    main(["check", str(path)])
    assert "2 points at -9999, which stands for no data, left out" in capsys.readouterr().out
