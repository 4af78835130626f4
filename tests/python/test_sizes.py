# SPDX-License-Identifier: MIT
"""The number of marks does not depend on the size of the picture."""
import numpy as np
import pytest
from test_cli import files, ink  # noqa: F401 - a fixture

import hrbfnpr
from hrbfnpr.cli import main

pytest.importorskip("PIL.Image")


def test_hatching_is_the_same_at_every_size(files, tmp_path):
    saved = []
    for size in ("160", "400"):
        saved.append(tmp_path / f"{size}.points")
        picture = str(tmp_path / f"{size}.png")
        assert main(["draw", str(files["ply"]), picture, "--style", "engraving", "--size", size, "--samples", "60",
                     "--quiet", "--save-points", str(saved[-1])]) == 0  # fmt: skip
        assert 0.01 < ink(picture) < 0.9
    sets = [hrbfnpr.PointSet.load(path) for path in saved]
    lines = [marks.layer("hatch") for marks in sets]
    assert len(lines[0]) > 10000
    for name in ("levels", "stroke_first"):
        assert np.array_equal(getattr(lines[0], name), getattr(lines[1], name))
    # Each set has its own origin, and positions are single-precision.
    a, b = (line.positions + np.asarray(marks.origin) for line, marks in zip(lines, sets))
    assert np.abs(a - b).max() < 1e-6
