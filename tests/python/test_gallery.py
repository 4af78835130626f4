# SPDX-License-Identifier: MIT
"""scripts/figures draws the article's figures, here small and from models made by the test."""
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import PACKAGE, ROOT, fibonacci_sphere
from test_cli import rows

Image = pytest.importorskip("PIL.Image")


def gallery(*arguments):
    command = [sys.executable, "-B", str(ROOT / "scripts/figures/main.py"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(PACKAGE)})


def test_figures_without_data(tmp_path):
    out = tmp_path / "out"
    run = gallery("--size", "48", "--figures", "8,12,13", out)
    assert run.returncode == 0, run.stderr
    assert "figure 8, b_published" in run.stdout  # its progress
    for figure, file in (("12", "lamp_mesh.ply"), ("13", "canyon_512.ply")):
        assert f"figure {figure}: left out: {file} is missing; give a folder that has it by --data DIR" in run.stdout
    page = (out / "index.html").read_text(encoding="utf-8")
    shown = re.findall(r'<img src="([^"]+)"', page)
    assert len(shown) == 5 and sorted(shown) == sorted(path.name for path in out.glob("*.png"))
    for name in shown:
        picture = np.asarray(Image.open(out / name).convert("L"))
        assert max(picture.shape) == 48 and (picture < 200).mean() > 0.005
    assert page.count("Left out:") == 2 and 'name="viewport"' in page and "--visibility published" in page


def ply_of(points):
    """A PLY file of points on a sphere, which are their own normals."""
    header = f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n"
    header += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + "end_header\n"
    return header + rows(np.hstack([points, points]))


def test_a_folder_of_data(tmp_path):
    data = tmp_path / "data" / "points"
    data.mkdir(parents=True)
    (data / "tori_256.ply").write_text(ply_of(fibonacci_sphere(80)))
    run = gallery("--data", tmp_path / "data", "--size", "40", "--figures", "8", tmp_path)
    assert run.returncode == 0, run.stderr
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "Left out" not in page and "made from a formula" in page
    assert len(list(tmp_path.glob("figure_8_*.png"))) == 5


@pytest.mark.skipif(shutil.which("rsvg-convert") is None, reason="no rsvg-convert here (Debian: librsvg2-bin)")
def test_vectors_and_plots(tmp_path):
    points = fibonacci_sphere(80)
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "bunny_zipper.ply").write_text(ply_of(points))
    run = gallery("--data", tmp_path / "data", "--size", "64", "--figures", "vectors", tmp_path)
    assert run.returncode == 0, run.stderr
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "figure_vectors_plot.hpgl" in page and "figure_vectors_svg.svg" in page  # the commands that draw them
    names = {path.name for path in tmp_path.glob("figure_*")}
    assert names == {f"figure_vectors_{name}.png" for name in ("svg", "detail", "plot")}
    plot = np.asarray(Image.open(tmp_path / "figure_vectors_plot.png").convert("RGB")).astype(int)
    blue, red = plot[..., 2] - plot[..., 0] > 60, plot[..., 0] - plot[..., 2] > 60
    assert blue.any() and red.any()  # the pen's way begins in one colour and ends in the other


@pytest.mark.parametrize(
    "arguments, code, words",
    [
        (["--data", "nowhere"], 2, "nowhere is not a folder"),
        (["--data", "{tmp}"], 1, "has none of the models"),
        (["--figures", "7,99"], 2, "no figure '99'; choose some of 1,7,8"),
        (["--size", "5"], 2, "32 to 4096"),
        (["--figures", "8", "{tmp}/file/out"], 1, "file"),
    ],
)
def test_wrong_arguments(tmp_path, arguments, code, words):
    (tmp_path / "file").write_text("")
    out = [] if "out" in arguments[-1] else [tmp_path / "out"]
    run = gallery(*(word.format(tmp=tmp_path) for word in arguments), *out)
    assert run.returncode == code and words in run.stderr, run.stderr
    assert "Traceback" not in run.stderr
