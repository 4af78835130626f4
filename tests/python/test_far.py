# SPDX-License-Identifier: MIT
"""What lies so far away that all else would be a dot in the picture."""
import numpy as np
import pytest
from conftest import fibonacci_sphere
from looks import info_of
from test_input import lost, no_data, obj, table, tube
from test_shapes import write

from hrbfnpr.cli import main
from hrbfnpr.shapes import Shape


def strays(points):
    return info_of(Shape(points)).strays


def test_strays_are_few_and_far():
    points = fibonacci_sphere(2000)
    assert strays(points) == 0
    two = np.vstack([points, [[9.0, 0, 0], [0, -20, 0]]])
    assert strays(two) == 2
    assert strays(np.vstack([points, [[3.0, 0, 0]]])) == 0  # not so far
    assert strays(np.vstack([points, points[:40] + [30, 0, 0]])) == 0  # not so few
    assert strays(points[:150] + 0) == 0
    assert strays(np.vstack([two, [[np.nan, 0, 0]]])) == 2
    rod = np.column_stack([np.linspace(0, 100, 3000), np.zeros(3000), np.zeros(3000)])
    assert strays(rod) == 0


def test_values_that_stand_for_none():
    points = np.random.default_rng(1).uniform(0, 50, (100, 3))
    points[[3, 7], 2] = -9999
    info = info_of(Shape(points))
    assert (info.no_data, info.bounds_min[2] >= 0) == (2, True)
    deep = points.copy()
    deep[[3, 7], 2] = np.linspace(-9999, -9000, 2)  # one of them, and others near to it
    deep[8:40, 2] = -9990
    assert info_of(Shape(deep)).no_data == 0
    assert info_of(Shape(np.full((3, 3), -9999.0))).no_data == 0  # there would be nothing left
    points[8, 2] = 1
    assert info_of(Shape(points, None, np.array([[2, 3, 4]]))).no_data == 0  # no face would be left
    assert info_of(Shape(points, points.copy(), np.array([[0, 1, 2], [2, 3, 4], [5, 6, 8]]))).no_data == 2


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
