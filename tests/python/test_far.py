# SPDX-License-Identifier: MIT
"""Points and parts so far away that the rest would be a dot in the picture."""
import numpy as np
import pytest
from conftest import fibonacci_sphere
from test_input import lost, no_data, obj, table
from test_shapes import write

from hrbfnpr.cli import main


@pytest.mark.parametrize("option", [[], ["--parts", "all"]])
def test_distant_parts_are_left_out_by_default(tmp_path, capsys, option):
    path = write(tmp_path, "a.obj", lost())
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *option]) in (0, 3)
    assert ("far from all others" in capsys.readouterr().err) == (not option)


def test_outliers_are_kept_on_request(tmp_path, capsys):
    points = fibonacci_sphere(1000)
    path = write(tmp_path, "a.xyz", table(np.vstack([points, [[40, 0, 0]]]), np.vstack([points, [[1, 0, 0]]])))
    for option in ([], ["--outliers", "keep"]):
        main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *option])
        assert ("far from all others" in capsys.readouterr().err) == (not option)


def test_the_check_reports_points_left_out(tmp_path, capsys):
    points = fibonacci_sphere(1000)
    path = write(tmp_path, "a.xyz", table(np.vstack([points, [[40, 0, 0]]]), np.vstack([points, [[1, 0, 0]]])))
    assert main(["check", str(path)]) == 0
    assert "1 point far from all others left out" in capsys.readouterr().out
    path = write(tmp_path, "b.obj", no_data())
    main(["check", str(path)])
    assert "2 points left out, as the value -9999 marks missing data" in capsys.readouterr().out
