# SPDX-License-Identifier: MIT
"""The sheet command from end to end."""
import subprocess
import sys

import numpy as np
import pytest
from conftest import torus
from test_cli import rows
from test_shapes import write

import hrbfnpr
from hrbfnpr._scene import Scene
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

QUICK = ["--size", "72", "--marks", "400", "--samples", "60", "--quiet"]
FRAME = 190  # grey of the frame around a cell


@pytest.fixture
def ring_file(tmp_path):
    return str(write(tmp_path, "ring.xyz", rows(np.hstack(torus(12, 6)))))


def sheet(arguments, output):
    assert main(["sheet", *arguments, "-o", str(output)]) == 0
    return np.asarray(Image.open(output).convert("L"))


def frames(picture):
    """The contents of all cells, row by row."""
    found = []
    for y, x in np.argwhere(picture == FRAME):
        upper_left = picture[y, x + 1] == FRAME and picture[y + 1, x] == FRAME
        if upper_left and picture[y - 1, x] != FRAME and picture[y, x - 1] != FRAME:
            right = x + int(np.argmin(picture[y, x:] == FRAME)) - 1
            bottom = y + int(np.argmin(picture[y:, x] == FRAME)) - 1
            found.append(picture[y + 1 : bottom, x + 1 : right])
    return found


def test_every_style_has_a_cell_that_is_not_blank(ring_file, tmp_path):
    picture = sheet([ring_file, *QUICK, "--columns", "4"], tmp_path / "out.png")
    inner = frames(picture)
    assert len(inner) == len(hrbfnpr.PRESETS)
    assert len({cell.shape for cell in inner}) == 1
    assert min(cell.min() for cell in inner) < 100
    assert min((cell < 128).mean() for cell in inner) > 0.005
    rows_of_cells = -(-len(inner) // 4)
    assert abs(picture.shape[1] - 4 * (inner[0].shape[1] + 4)) < 8
    assert abs(picture.shape[0] / rows_of_cells - inner[0].shape[0]) < 24


def test_a_cell_equals_the_output_of_draw(ring_file, tmp_path):
    options = ["--up", "z", "--azimuth", "70", "--light", "1,0,0", "--size", "180", "--samples", "60", "--quiet"]
    inner = frames(sheet([ring_file, *options, "--styles", "stipple,engraving"], tmp_path / "out.png"))
    for style, cell in zip(("stipple", "engraving"), inner):
        alone = tmp_path / "alone.png"
        assert main(["draw", ring_file, str(alone), *options, "--style", style]) == 0
        drawn = np.asarray(Image.open(alone).convert("L"))
        assert cell.shape == drawn.shape and (cell == drawn).all()


@pytest.mark.parametrize("size, high, wide", [(40, 9, 90), (640, 17, 200)])
def test_labels_grow_with_the_drawings_and_are_never_too_small(ring_file, tmp_path, size, high, wide):
    options = [*QUICK, "--size", str(size), "--styles", "silhouette,xray", "--columns", "1"]
    picture = sheet([ring_file, *options], tmp_path / "out.png")
    first = frames(picture)[0]
    top = (picture.shape[1] - first.shape[1]) // 2 + first.shape[0] + 2
    below = picture[top : top + 3 * high, 8:-8] < 128
    below = below[: np.flatnonzero(below.any(axis=1))[0] + 2 * high]
    columns = np.flatnonzero(below.any(axis=0))
    assert below.any(axis=1).sum() >= high - 4 and columns[-1] - columns[0] > wide / 2


def test_views_are_next_to_each_other(ring_file, tmp_path):
    options = [ring_file, *QUICK, "--up", "z", "--styles", "silhouette,stipple", "--views", "front,top,left"]
    picture = sheet(options, tmp_path / "out.png")
    inner = frames(picture)
    assert len(inner) == 6 and picture.shape[1] > 3 * inner[0].shape[1]
    middle = [cell[cell.shape[0] // 2 - 3 :][:6].min() for cell in inner]
    across = inner[0].shape[1] // 2
    assert (inner[1][30:40, across - 4 : across + 4] == 255).all()  # the view through the hole
    assert (inner[3] != inner[5]).any() and max(middle) < 255


def test_styles_share_the_surface_but_not_the_marks(ring_file, tmp_path, monkeypatch):
    used, draw = [], Scene.draw

    def note(self, *arguments, **options):
        used.append((self.parts[0].model._handle, self.parts[0].marks._handle))
        return draw(self, *arguments, **options)

    monkeypatch.setattr(Scene, "draw", note)
    sheet([ring_file, *QUICK, "--styles", "silhouette,stipple,xray,contour-and-stipple"], tmp_path / "out.png")
    models, marks = zip(*used)
    assert len(used) == 4 and all(model == models[0] for model in models)
    assert len(set(marks)) > 1  # Each style places only the marks that it shows.


def test_the_default_output_and_summary(ring_file, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["sheet", ring_file, *QUICK[:-1], "--styles", "xray,silhouette,xray"]) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1].startswith("ring-sheet.png: 2 drawings, ") and err == ""
    assert Image.open("ring-sheet.png").size[0] > 144


@pytest.mark.parametrize(
    "arguments, code, words",
    [
        (["{ring}", "out.png", "--styles", "xray,cubist"], 2, "no style 'cubist'; there are " + ", ".join(hrbfnpr.PRESETS)),
        (["{ring}", "out.png", "--styles", ""], 2, "no style ''"),
        (["{ring}", "out.png", "--views", "front,inside"], 2, "no view 'inside'; there are front, right"),
        (["{ring}", "out.png", "--size", "3"], 2, "16 to 4096"),
        (["{ring}", "out.png", "--columns", "0"], 2, "at least 1"),
        (["{ring}", "out.png", "--style", "xray", "--samples", "many"], 2, "--style|whole number"),
        (["{ring}", "nowhere/out.png"], 1, "nowhere/out.png: there is no folder nowhere$"),
        (["{ring}", "out.bmpx"], 1, "no picture format"),
        (["missing.xyz", "out.png"], 1, "missing.xyz: No such file"),
        (["marks.hrbp", "out.png"], 2, "holds a point set"),
        (["{ring}", "out.png", "--lines", "crease"], 1, "creases need a mesh"),
    ],
)
def test_failures_print_one_line_and_write_nothing(ring_file, marks, tmp_path, monkeypatch, capsys, arguments, code, words):
    import re

    monkeypatch.chdir(tmp_path)
    marks.save("marks.hrbp")
    before = sorted(tmp_path.iterdir())
    small = [] if "--size" in arguments else ["--size", "40"]
    assert main(["sheet", *(word.format(ring=ring_file) for word in arguments), *small, "--marks", "100"]) == code
    out, err = capsys.readouterr()
    assert out.count("\n") == len(re.findall(r"(?m)^[a-z ]{12} +[\d.]+ s", out)), out
    assert err.startswith("hrbfnpr: error: ") and err.count("\n") == 1, err
    assert re.search(words, err), err
    assert sorted(tmp_path.iterdir()) == before


def test_unwritable_outputs_fail_before_the_work(ring_file, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("hrbfnpr._sources.read", lambda *arguments: pytest.fail("it was drawn"))
    assert main(["sheet", ring_file, str(tmp_path / "no" / "out.png"), *QUICK]) == 1
    capsys.readouterr()


def test_a_failed_write_keeps_the_old_file(ring_file, tmp_path, monkeypatch):
    output = tmp_path / "out.png"
    output.write_bytes(b"the sheet of before")

    def fail(self, file, format):
        file.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Image.Image, "save", fail)
    assert main(["sheet", ring_file, str(output), *QUICK, "--styles", "xray"]) == 1
    assert output.read_bytes() == b"the sheet of before"
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]


def test_help_lists_the_styles():
    run = subprocess.run([sys.executable, "-m", "hrbfnpr", "sheet", "--help"], capture_output=True, text=True)
    assert run.returncode == 0
    assert all(name in " ".join(run.stdout.split()).replace("- ", "-") for name in hrbfnpr.PRESETS)
