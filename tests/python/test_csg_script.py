# SPDX-License-Identifier: MIT
"""Scripts that describe solids, and the command that draws them."""
import math

import pytest

import hrbfnpr

pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")

from hrbfnpr import _script  # noqa: E402
from hrbfnpr.cli import main  # noqa: E402

QUICK = ["--size", "120", "--marks", "1500", "--quiet"]
PART = """# A plate with holes, and a boss.
plate = box((4, 3, 0.5)).blend(cylinder(0.6, 2, center=(0, 0, 0.5)), 0.2)
holes = union(*[cylinder(0.2, 2).translated(1.5 * cos(90 * i), 1.1 * sin(90 * i), 0) for i in range(4)])
plate - holes - cylinder(0.3, 5)
"""


def run(text, load=None):
    return _script.run(text, load)


def value(model, *point):
    return float(model.evaluate(point).value)


def test_a_script_equals_the_operators():
    part = run(PART)
    hole = hrbfnpr.csg.cylinder(0.2, 2)
    plate = hrbfnpr.csg.box((4, 3, 0.5)).blend(hrbfnpr.csg.cylinder(0.6, 2, (0, 0, 0.5)), 0.2)
    holes = hole.translated(1.5, 0, 0).union(hole.translated(0, 1.1, 0), hole.translated(-1.5, 0, 0),
                                             hole.translated(0, -1.1, 0))  # fmt: skip
    same = plate - holes - hrbfnpr.csg.cylinder(0.3, 5)
    points = [[2 * math.sin(3 * i), 1.5 * math.cos(5 * i), math.sin(7 * i)] for i in range(200)]
    for a, b in zip(part.evaluate(points).value, same.evaluate(points).value):
        assert abs(a - b) < 1e-13
    assert value(run("a = sphere(2)\nb = 2 * 0.25 + 1 - -0.5\n~(a & sphere(b / 2 + 0.5))"), 0, 0, 0) == 1.5
    assert value(run("sphere(1).scaled(2).offset(sqrt(4))"), 0, 0, 0) == -4
    assert run("sphere(1) | half_space() & sphere(1.5)").contains((0, 0, -1.2))
    assert run("[sphere(1, center=(i, 0, 0)) for i in range(0, 4, 2)]\nsphere(1)").contains((0, 0, 0))


@pytest.mark.parametrize(
    "text, message",
    [
        ("sphere(1", "line 1: "),
        ("", "the last line must be a solid"),
        ("a = sphere(1)\n3", "the last line must be a solid"),
        ("\nspheer(1)", "line 2: there is no spheer"),
        ("a | sphere(1)", "line 1: there is no 'a'; there are box"),
        ("sphere(-1)", "line 1: .*radius is -1"),
        ("sphere(1) + sphere(2)", "line 1: unsupported operand"),
        ("sphere(2 ** 9)", "line 1: Pow cannot be used"),
        ("sphere(1 / 0)", "line 1: .*division by zero"),
        ("import os", "line 1: a line must be"),
        ("__import__('os')", "line 1: there is no __import__"),
        ("sphere(1).__class__", "line 1: Attribute cannot be used"),
        ("sphere(1).evaluate((0, 0, 0))", "line 1: this is not a function"),
        ("sphere(1).to_bytes()", "line 1: this is not a function"),
        ("(1).offset(2)", "line 1: only solids have .offset"),
        ("sphere(1, context=3)", "line 1: write options as name=value"),
        ("sphere(1, **{})", "line 1: write options as name=value"),
        ("lambda: 1", "line 1: Lambda cannot be used"),
        ("'a' * 1000000000", "line 1: only solids and numbers"),
        ("(1, 2) * 1000000000", "line 1: only solids and numbers"),
        ("[1 for i in range(10 ** 9)]", "Pow cannot be used"),
        ("[1 for i in range(1000000000)]", "repeats more than 10000 times"),
        ("[1 for i in 'abc']", "write a loop as"),
        ("a, b = 1, 2", "line 1: a line must be"),
        ("load('x.ply')", "line 1: .*no such file"),
        ("(" * 3000 + "1" + ")" * 3000, "line "),
    ],
)
def test_invalid_scripts_are_refused(text, message):
    def load(name):
        raise OSError("no such file")

    with pytest.raises(_script.ScriptError, match=message):
        run(text, load)


def test_the_command_draws_and_saves(tmp_path, capsys):
    script = tmp_path / "part.csg"
    script.write_text(PART)
    saved = tmp_path / "part.hrbf"
    picture = tmp_path / "part.png"
    assert main(["csg", str(script), str(picture), "--also", str(tmp_path / "part.svg"), "--save-model", str(saved),
                 *QUICK]) == 0  # fmt: skip
    assert max(Image.open(picture).size) == 120
    assert (tmp_path / "part.svg").stat().st_size > 1000
    assert hrbfnpr.Model.load(saved).csg_info.nodes > 10
    # The other commands know scripts by their ending. A saved solid is a model like any other, and a leaf of a tree.
    assert main(["draw", str(script), str(picture), *QUICK]) == 0
    assert main(["draw", str(saved), str(picture), *QUICK]) == 0
    other = tmp_path / "cut"
    other.write_text("load('part.hrbf') & half_space(normal=(0, 1, 0))")
    assert main(["csg", str(other), str(picture), *QUICK]) == 0
    capsys.readouterr()
    assert main(["info", str(saved)]) == 0
    assert "kernel: csg" in capsys.readouterr().out


def test_files_in_a_script_are_fitted(tmp_path):
    points = tmp_path / "ball.xyz"
    rows = []
    for i in range(60):
        z = 1 - (2 * i + 1) / 60
        x, y = (math.sqrt(1 - z * z) * f(2.4 * i) for f in (math.cos, math.sin))
        rows.append(f"{x} {y} {z} {x} {y} {z}\n")
    points.write_text("".join(rows))
    script = tmp_path / "half.csg"
    script.write_text("load('ball.xyz') - half_space()")
    saved = tmp_path / "half.hrbf"
    assert main(["fit", str(script), str(saved), "--quiet"]) == 0
    half = hrbfnpr.Model.load(saved)
    assert half.contains((0, 0, 0.5)) and not half.contains((0, 0, -0.5))
    assert half.csg_info.models == 1


def test_a_wrong_script_gives_one_line(tmp_path, capsys):
    script = tmp_path / "wrong.csg"
    script.write_text("a = sphere(1)\na - load('missing.ply')\n")
    assert main(["csg", str(script), str(tmp_path / "out.png")]) == 1
    error = capsys.readouterr().err
    assert error.startswith("hrbfnpr: error: ") and "line 2" in error and "missing.ply" in error
    assert len(error.splitlines()) == 1
