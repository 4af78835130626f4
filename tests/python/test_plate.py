# SPDX-License-Identifier: MIT
"""Plates of archaeological drawings: the section and the scale bar beside the drawing."""
import numpy as np
import pytest

from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

QUICK = ["--size", "240", "--marks", "2000", "--quiet"]


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A sphere of radius 10."""
    k = np.arange(200) + 0.5
    height, around = 1 - 2 * k / 200, np.pi * (1 + 5**0.5) * k
    n = np.column_stack([np.sqrt(1 - height**2) * np.cos(around), height, np.sqrt(1 - height**2) * np.sin(around)])
    path = tmp_path_factory.mktemp("plate") / "ball.xyz"
    np.savetxt(path, np.hstack([10 * n, n]))
    return path


def test_a_plate_has_a_section_and_a_scale_bar(ball, tmp_path):
    output = tmp_path / "plate.png"
    assert main(["draw", str(ball), str(output), "--style", "archaeological", "--scale-bar", "mm", *QUICK]) == 0
    dark = np.asarray(Image.open(output).convert("L")) < 128
    assert dark.shape[1] > 440 and dark.shape[0] > 250  # the section at the right, the bar below
    # Without perspective the sphere, and so its section, is 0.9 * 240 pixels wide.
    for half in (dark[:240, :240], dark[:240, 240:]):
        columns = np.flatnonzero(half.any(axis=0))
        rows = np.flatnonzero(half.any(axis=1))
        assert columns[-1] - columns[0] == pytest.approx(216, abs=6)
        assert rows[-1] - rows[0] == pytest.approx(216, abs=6)
    # The bar: 5 mm, a quarter of the diameter.
    rows = dark[250:, :240].sum(axis=1)
    assert rows.max() == pytest.approx(5 * 216 / 20, abs=6)


def test_options_turn_plates_on_and_off(ball, tmp_path):
    output = tmp_path / "plain.png"
    for options, more in ((["--profile", "no", "--scale-bar", "none"], (0, 0)), (["--profile", "no"], (0, 44))):
        assert main(["draw", str(ball), str(output), "--style", "archaeological", *options, *QUICK]) == 0
        assert Image.open(output).size == (240 + more[0], 240 + more[1])
    assert main(["draw", str(ball), str(output), "--style", "hatch", "--scale-bar", "cm", *QUICK]) == 0
    assert Image.open(output).size == (240, 284)
    assert main(["draw", str(ball), str(output), "--style", "hatch", *QUICK]) == 0
    assert Image.open(output).size == (240, 240)
