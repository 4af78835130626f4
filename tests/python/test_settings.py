# SPDX-License-Identifier: MIT
"""Settings files: --settings and --save-settings of draw."""

import json
from pathlib import Path

import numpy as np
import pytest

from hrbfnpr.cli._main import main

Image = pytest.importorskip("PIL.Image")

SAMPLES = Path(__file__).resolve().parents[2] / "examples" / "torus.xyzn"
FEW = ("--size", "160x120", "--marks", "4000", "-q")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def draw(name, *options):
    assert main(["draw", str(SAMPLES), name, *options]) == 0
    return np.asarray(Image.open(name).convert("RGBA")).astype(int)


def put(folder, **settings):
    (folder / "s.json").write_text(json.dumps({"hrbfnpr-settings": 1, **settings}))
    return ("--settings", "s.json")


@pytest.mark.parametrize("options", [
    ("--style", "engraving", "--separation", "0.1"),
    ("--style", "archaeological", "--profile", "no", "--scale-bar", "none", "--separation", "0.1"),
    ("--lines", "contour,suggestive,section=z:7,isophotes=0.3:0.6", "--ink", "#204060", "--hidden", "dashed"),
    ("--distribution", "published", "--levels", "3", "--step", "0.2", "--style", "full"),
    ("--style", "combing", "--layers", "hatch", "--guide", "combing", "--fov", "0", "--set", "hatch.hatch_pen=1.5"),
    ("--kernel", "wendland-c2", "--kernel-radius", "3", "--tone", "none", "--transparent"),
])  # fmt: skip
def test_saved_settings_draw_the_same_picture(folder, options):
    first = draw("a.png", *FEW, *options, "--save-settings", "saved.json")
    assert np.array_equal(draw("b.png", "--settings", "saved.json", "-q"), first)
    draw("c.png", "--settings", "saved.json", "--save-settings", "again.json", "-q")
    assert np.array_equal(draw("d.png", "--settings", "again.json", "-q"), first)


def test_options_override_the_file(folder):
    draw("a.png", *FEW, "--save-settings", "saved.json")
    assert draw("b.png", "--settings", "saved.json", "--size", "80x60", "-q").shape == (60, 80, 4)
    turned = draw("c.png", "--settings", "saved.json", "--azimuth", "120", "-q")
    assert not np.array_equal(turned, draw("a.png", "--settings", "saved.json", "-q"))
    blue = draw("d.png", "--settings", "saved.json", "--style", "blueprint", "-q")
    assert blue[0, 0, 2] > blue[0, 0, 0] + 30


def test_a_picture_of_another_size_has_the_same_view(folder):
    small = draw("a.png", *FEW, "--save-settings", "saved.json")
    large = draw("b.png", "--settings", "saved.json", "--size", "480x240", "-q")
    assert large[:, :100].min() == 255, "the wider picture has free sides"
    inked = [np.nonzero((picture[..., 0] < 200).any(axis=1))[0][[0, -1]] / len(picture) for picture in (small, large)]
    assert np.abs(inked[0] - inked[1]).max() < 0.03


WRONG = [
    ({"styel": {}}, "styel: there is no such field; there are hrbfnpr-settings, preset"),
    ({"style": {"layers": [{"kind": "hatch"}, {"radius": "wide"}]}}, "style.layers[1].radius: a number is needed"),
    ({"camera": {"view": [0] * 16, "projection": [0] * 16}}, "size: it is missing"),
]  # fmt: skip


@pytest.mark.parametrize("settings, message", WRONG)
def test_faults_are_named(folder, capsys, settings, message):
    assert main(["draw", str(SAMPLES), "a.png", *put(folder, **settings)]) == 1
    said = capsys.readouterr().err
    assert message in said and "s.json" in said and said.count("\n") == 1


def test_options_that_settings_do_not_hold_are_named(folder, capsys):
    assert main(["draw", str(SAMPLES), "a.png", "--samples", "100", "--size", "80", "--marks", "2000", "--save-settings",
                 "s.json"]) == 0  # fmt: skip
    assert "settings do not hold --samples" in " ".join(capsys.readouterr().err.split())
