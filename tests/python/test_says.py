# SPDX-License-Identifier: MIT
"""The command line's own choices and messages: normals, up, blank pictures, outputs and times."""
import io
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import PACKAGE, fibonacci_sphere, torus
from test_input import ball, obj, table, tube
from test_meshes import glb, gltf
from test_shapes import stl, write

import hrbfnpr
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

QUICK = ["--size", "100", "--marks", "600"]


def draw(path, output, *options):
    return main(["draw", str(path), str(output), *QUICK, *options])


# --- parts -------------------------------------------------------------------------------------


def test_coarse_faces_are_round_unless_the_option_says_flat(tmp_path, capsys):
    angle = 2 * np.pi * np.arange(16) / 16  # either a prism or a cylinder
    rings = [np.column_stack([np.cos(angle), 0 * angle + y, np.sin(angle)]) for y in (0, 1)]
    sides = [[i, 16 + i, 16 + (i + 1) % 16, (i + 1) % 16] for i in range(16)]
    path = write(tmp_path, "prism.obj", obj(np.vstack(rings), [*sides, list(range(16)), list(range(31, 15, -1))]))
    assert draw(path, tmp_path / "round.png") == 0
    assert "in places: --edges 5 keeps faces flat" in capsys.readouterr().err
    assert draw(path, tmp_path / "flat.png", "--edges", "5") == 0
    assert "off the mesh in places" not in capsys.readouterr().err


# --- normals -----------------------------------------------------------------------------------


def test_inward_normals_give_the_same_picture(tmp_path, capsys):
    points, normals = torus(24, 12)
    for name, sign in (("a", 1), ("b", -1)):
        assert draw(write(tmp_path, f"{name}.xyz", table(points, sign * normals)), tmp_path / f"{name}.png") == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert capsys.readouterr().err.count("inward") == 1


# --- up ----------------------------------------------------------------------------------------


def test_the_format_decides_the_up_axis(tmp_path, capsys):
    path = write(tmp_path, "a.stl", stl(True))
    more = ["--samples", "200"]
    assert draw(path, tmp_path / "a.png", *more) == 0
    assert "up is z, as in STL files" in capsys.readouterr().err
    assert draw(path, tmp_path / "b.png", *more, "--up", "z") == 0 == draw(path, tmp_path / "c.png", *more, "--up", "y")
    assert "up is" not in capsys.readouterr().err
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes() != (tmp_path / "c.png").read_bytes()
    path = write(tmp_path, "a.glb", glb(*gltf()))
    assert draw(path, tmp_path / "d.png", *more, "--up", "auto") == 0
    assert "up is" not in capsys.readouterr().err


# --- blank pictures ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "options, words",
    [
        (["--eye", "0,0,5", "--target", "0,0,9"], "The camera looks away"),
        (["--normals", "keep", "--lines", "none"], "are hidden, as if normals pointed inward: --flip"),
        (["--flip", "--style", "stipple"], "leave out --flip"),
        (["--ink", "#ffffff", "--lines", "none"], "ink has the colour of the paper"),
        (["--depth-range", "0.01,0.02", "--lines", "none"], "leave out --depth-range"),
    ],
)
def test_the_reason_for_a_blank_picture_is_named(tmp_path, capsys, options, words):
    points, normals = ball()
    sign = -1 if "keep" in options else 1
    path, output = write(tmp_path, "a.xyz", table(points, sign * normals)), tmp_path / "out.png"
    output.write_bytes(b"the picture of before")
    assert draw(path, output, *options, "--save-model", str(tmp_path / "m")) == 3
    out, err = capsys.readouterr()
    assert re.search(r"(?m)^hrbfnpr: error: the picture would be blank: .*" + words, err), err
    assert output.read_bytes() == b"the picture of before" and not (tmp_path / "m").exists()
    assert draw(path, output, *options, "--allow-blank", "-q") == 0
    assert max(Image.open(output).size) == 100


def test_an_open_surface_seen_from_its_back(tmp_path, capsys):
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, 9)]), axis=-1).reshape(-1, 2)
    points = np.column_stack([grid, 0.1 * grid[:, 0] ** 2])
    path = write(tmp_path, "a.xyz", table(points, np.tile([0.0, 0, -1], (81, 1))))
    options = ["--up", "y", "--lines", "none", "--normals", "keep", "--azimuth", "30"]
    assert draw(path, tmp_path / "a.png", *options) == 0, "both its sides are drawn"
    options += ["--sides", "front"]
    assert draw(path, tmp_path / "a.png", *options) == 3
    assert "shows only its back: try another --azimuth, or --sides both" in capsys.readouterr().err
    assert draw(path, tmp_path / "a.png", *options, "--azimuth", "210") == 0


def test_sheet_warns_of_blank_drawings(tmp_path, capsys):
    path = write(tmp_path, "a.xyz", table(ball()[0], -ball()[1]))
    options = ["--styles", "stipple,silhouette", "--size", "60", "--marks", "600", "--normals", "keep"]
    assert main(["sheet", str(path), str(tmp_path / "s.png"), *options]) == 0
    err = capsys.readouterr().err
    assert err.count("would be blank") == 1 and "warning: stipple: the picture" in err


# --- details -----------------------------------------------------------------------------------


def test_verbose_prints_details(tmp_path, capsys):
    path = write(tmp_path, "a.obj", obj(*tube()))
    said = "hrbfnpr: warning: .*% of the mesh is more than 1% of the diagonal off the surface: try --samples 320"
    detail = r"\n    The farthest place is \d+\.\d% off. Thin parts need more samples.\n"
    few = ["--samples", "80"]
    assert draw(path, tmp_path / "a.png", *few, "--verbose") == 0
    assert re.search(said + detail, capsys.readouterr().err)
    assert draw(path, tmp_path / "a.png", *few) == 0
    assert re.search(said + "\n", err := capsys.readouterr().err) and not re.search("^ ", err, re.M)
    assert draw(path, tmp_path / "a.png", "--quiet", "--verbose") == 2
    assert "not allowed with argument" in capsys.readouterr().err


def test_verbose_prints_details_of_a_check(tmp_path, capsys):
    path = write(tmp_path, "a.obj", obj(*(part[:-1] if i else part for i, part in enumerate(tube()))))
    assert main(["check", str(path)]) == 1
    detail = "\n    The border of a hole that stays open is drawn as a line.\n"
    assert detail not in capsys.readouterr().out
    assert main(["check", str(path), "-v"]) == 1
    assert re.search(r"\nwarning: the mesh is open: it has \d border.* edges?" + detail, capsys.readouterr().out)


def test_warnings_of_python_have_details(tmp_path):
    path = write(tmp_path, "a.obj", obj(*tube()))
    with pytest.warns(hrbfnpr.DrawingWarning, match="off the surface: try samples=320") as caught:
        hrbfnpr.draw(path, size=100, marks=600, samples=80)
    note = next(one.message.note for one in caught if "off the surface" in str(one.message))
    assert note.code == "off_mesh" and note.detail.endswith("Thin parts need more samples.") and len(note.figures) == 2


# --- outputs -----------------------------------------------------------------------------------


def test_outputs_are_checked_before_the_work(tmp_path, monkeypatch, capsys):
    path = write(tmp_path, "a.xyz", table(*ball()))
    monkeypatch.setattr("hrbfnpr._sources.read", lambda *arguments: pytest.fail("it was read"))
    nowhere = str(tmp_path / "no" / "out")
    for command in (
        ["draw", str(path), nowhere + ".png"],
        ["draw", str(path), str(tmp_path / "out.bmpx")],
        ["draw", str(path), str(tmp_path / "a.png"), "--save-model", nowhere],
        ["sheet", str(path), nowhere + ".png"],
        ["fit", str(path), nowhere],
        ["fit", str(path), str(tmp_path / "m.ply")],
        ["points", str(path), nowhere],
        ["points", str(path), str(tmp_path)],
    ):
        assert main(command) == 1
        err = capsys.readouterr().err
        assert err.count("\n") == 1 and not re.search(r"/\.\w", err), err  # hidden files are not named
    if os.geteuid():  # root may write anywhere
        (tmp_path / "locked").mkdir(mode=0o500)
        assert main(["draw", str(path), str(tmp_path / "locked" / "a.png")]) == 1
        assert "it cannot be written there" in capsys.readouterr().err


def test_a_failure_while_writing_names_the_file(tmp_path, sphere):
    with pytest.raises(FileNotFoundError) as caught:
        sphere.save(tmp_path / "nowhere" / "a.hrbf")
    assert caught.value.filename == str(tmp_path / "nowhere" / "a.hrbf")


# --- times, progress bars and order of messages ------------------------------------------------


def run(code, *arguments):
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE)}
    command = [sys.executable, "-c", f"{code}; import sys; from hrbfnpr.cli import main; sys.exit(main())", *arguments]
    return subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def test_the_total_is_the_time_of_the_process(tmp_path):
    few = fibonacci_sphere(8)
    path = write(tmp_path, "a.xyz", table(few, few))
    result = run("import time; time.sleep(0.8)", "draw", str(path), str(tmp_path / "a.png"), *QUICK, "--lines", "none")
    assert result.returncode == 0, result.stdout
    lines = result.stdout.splitlines()
    seconds = {line[:12].strip(): float(line[12:20]) for line in lines if re.match(r"[a-z ]{12} +[\d.]+ s", line)}
    if sys.platform.startswith("linux"):
        assert seconds["start"] >= 0.8
    assert sum(seconds.values()) - seconds["total"] <= seconds["total"] + 0.05
    summary = next(i for i, line in enumerate(lines) if re.search(r"pixels, \d+ marks, [\d.]+ s$", line))
    assert float(lines[summary].split()[-2]) == pytest.approx(seconds["total"], abs=0.11)
    # Warnings come last, and are written in words.
    assert lines[summary + 1 :] and all(line.startswith("hrbfnpr: warning: ") for line in lines[summary + 1 :])
    assert "there are only 8 points" in lines[summary + 1]


def test_bars_show_percent():
    tqdm = pytest.importorskip("tqdm").tqdm
    points = fibonacci_sphere(400)
    for total in (None, 1, 1.0):
        shown = io.StringIO()
        width = 0 if total == 1 else None
        with tqdm(desc="fitting", file=shown, total=total, mininterval=0, ncols=width) as bar:
            hrbfnpr.Model.fit(points, points, progress=bar)
            bar.refresh()
        assert "100%" in shown.getvalue() and "/1" not in shown.getvalue().split("\r")[-2]
    with tqdm(file=io.StringIO(), total=50) as bar:  # the caller's bar keeps its unit
        hrbfnpr.Model.fit(points, points, progress=bar)
        assert bar.n == 50 and bar.bar_format is None


def test_the_distance_of_the_surface_is_reported(tmp_path, capsys):
    vertices, faces = tube()
    path = write(tmp_path, "a.obj", obj(vertices, faces))
    found = []
    for samples in ("80", "2000"):
        assert draw(path, tmp_path / "a.png", "--samples", samples) == 0
        out, err = capsys.readouterr()
        figures = re.search(r"(?m)^compare .*99% of .* within ([\d.]+)% of the diagonal .*, all within ([\d.]+)%$", out)
        most, all_of_it = (float(figure) for figure in figures.groups())
        assert most <= all_of_it
        found.append(most)
        assert ("% of the diagonal off the surface: try --samples 320" in err) == (samples == "80")
    assert found[0] > 1 > found[1] > 0
    assert draw(write(tmp_path, "a.xyz", table(*ball())), tmp_path / "a.png") == 0
    assert re.search(r"(?m)^fit .* 200 centres, .*; passes through all samples$", capsys.readouterr().out)
