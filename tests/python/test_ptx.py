# SPDX-License-Identifier: MIT
"""PTX: scans are placed in their common frame, and walls face the scanner."""
import sys
from pathlib import Path

import numpy as np
import pytest
from test_shapes import write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.cli import main

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
from reader_files import ptx  # noqa: E402

TURN = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])  # a quarter turn about z, for row vectors


def wall(columns=30, rows=20):
    """A cylindrical wall around the scanner, 90 degrees wide, 4 m away."""
    turn, height = np.meshgrid(np.linspace(-0.8, 0.8, columns), np.linspace(-1.2, 1.2, rows), indexing="ij")
    return np.stack([4 * np.cos(turn), 4 * np.sin(turn), height], axis=-1).reshape(-1, 3)


def test_a_scan_is_placed(tmp_path):
    shape = shapes.read(write(tmp_path, "a.ptx", ptx(wall(), 30, TURN, (100, 200, 3))))
    np.testing.assert_allclose(shape.points, wall() @ TURN + (100, 200, 3), atol=1e-5)
    assert shape.format == "PTX" and shape.up == (0, 0, 1) and not shape.notes
    assert shape.viewpoint == (100, 200, 3)


def test_ptx_is_recognized_by_its_contents(tmp_path):
    text = ptx(wall(), 30)
    assert "the file holds PTX" in shapes.read(write(tmp_path, "a.txt", text)).notes[0]
    assert len(shapes.read(write(tmp_path, "b.ptx", text.replace(b"\n", b"\r\n"))).points) == 600
    coloured = ptx(wall(), 30, more="0.5 200 100 50")
    np.testing.assert_allclose(shapes.read(write(tmp_path, "c.ptx", coloured)).points, wall(), atol=1e-5)


def test_rays_without_an_echo_give_no_points(tmp_path):
    points = wall()
    points[::3] = 0
    shape = shapes.read(write(tmp_path, "a.ptx", ptx(points, 30, np.eye(3), (0, 0, 1))))
    assert len(shape.points) == 400 and shape.notes == ("200 places of its grid are empty",)
    with pytest.raises(shapes.ShapeError, match="no points: all places of its grids are empty"):
        shapes.read(write(tmp_path, "b.ptx", ptx(0 * points, 30)))


def test_several_scans_are_one(tmp_path):
    text = ptx(wall(), 30) + ptx(wall(4, 5), 4, TURN, (7, 8, 9))
    shape = shapes.read(write(tmp_path, "a.ptx", text))
    np.testing.assert_allclose(shape.points[600:], wall(4, 5) @ TURN + (7, 8, 9), atol=1e-5)
    assert shape.notes == ("2 scans are joined",) and shape.viewpoint is None


LINES = ptx(wall(3, 2), 3).decode().splitlines()


@pytest.mark.parametrize("lines, says", [
    (LINES[:6], "ends in the middle of a header"),
    (["0", *LINES[1:]], "line 1, column 1: a grid has 1 to 1000000000 columns; not 0"),
    (["3", "1.5", *LINES[2:]], "line 2, column 1: a grid has 1 to 1000000000 rows; not 1.5"),
    (["3 2", "3", *LINES[2:]], "line 1: line 1 of a scan's header needs 1 number, not 2"),
    ([*LINES[:9], "0 0 0 2", *LINES[10:]], "line 7: the matrix of a scan"),
    ([*LINES[:9], "nan 0 0 1", *LINES[10:]], "line 7: the matrix of a scan"),
    ([*LINES[:12], "7", *LINES[13:]], "line 13: a point needs three numbers or more, not 1"),
    ([*LINES[:12], "1 x 2", *LINES[13:]], "line 13, column 2"),
    ([*LINES, "5"], "ends in the middle of a header"),
])  # fmt: skip
def test_faults_are_named(tmp_path, lines, says):
    with pytest.raises(shapes.ShapeError, match=says):
        shapes.read(write(tmp_path, "a.ptx", "\n".join(lines).encode()))


def test_missing_points_are_noted(tmp_path):
    whole = shapes.read(write(tmp_path, "a.ptx", "\n".join(LINES).encode())).points
    for lines, found, says in (
        (LINES[:-2], 4, "the file lacks 2 points that its headers announce"),
        ([*LINES[:-1], LINES[-1][:5]], 5, "the file lacks 1 point that its headers announce"),
        (["3", "900000000", *LINES[2:]], 6, "the file lacks 2699999994 points that its headers announce"),
    ):
        shape = shapes.read(write(tmp_path, "a.ptx", "\n".join(lines).encode()))
        np.testing.assert_array_equal(shape.points, whole[:found])
        assert shape.notes == (says,)
    shape = shapes.read(write(tmp_path, "a.ptx", "\n".join([*LINES[:-1], *LINES]).encode()))
    np.testing.assert_array_equal(shape.points, np.concatenate([whole[:5], whole]))
    assert shape.notes == ("2 scans are joined", "the file lacks 1 point that its headers announce")


def looks_to(model, points, place):
    normals = model.evaluate(points, gradient=True)[1]
    return ((normals * (np.asarray(place) - points)).sum(axis=1) > 0).mean()


@pytest.mark.parametrize("kind", ["ptx", "pcd"])
def test_walls_face_the_scanner(tmp_path, capsys, kind):
    pytest.importorskip("PIL.Image")
    stood = np.array([100.0, 200.0, 3.0])
    points = wall() @ TURN + stood
    if kind == "pcd":
        head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 600\nHEIGHT 1\n"
        head += "VIEWPOINT 100 200 3 1 0 0 0\nPOINTS 600\nDATA ascii\n"
        text = (head + "".join("{:.6f} {:.6f} {:.6f}\n".format(*p) for p in points)).encode()
    else:
        text = ptx(wall(), 30, TURN, stood)
    path, saved = write(tmp_path, f"a.{kind}", text), tmp_path / "a.hrbf"
    quick = ["--size", "100", "--marks", "600"]
    assert main(["draw", str(path), str(tmp_path / "a.png"), *quick, "--save-model", str(saved)]) == 0
    assert "600 are computed, facing the scanner" in capsys.readouterr().err
    fitted = tmp_path / "b.hrbf"
    assert main(["fit", str(path), str(fitted)]) == 0
    for file in (saved, fitted):
        with hrbfnpr.Model.load(file) as model:
            assert looks_to(model, points, stood) == 1


# The user may give the viewpoint that the file lacks. Here it is on either side of the wall.
@pytest.mark.parametrize("normals", [[], ["--normals", "none"], ["--normals", "unoriented"]])
@pytest.mark.parametrize("side", [1, -1])
def test_walls_face_a_given_viewpoint(tmp_path, capsys, normals, side):
    points = wall() + [10, 20, 30]
    stood = np.array([10, 20, 30]) + (0 if side == 1 else 1000 * wall().mean(axis=0))
    columns = [points] if not normals else [points, np.tile([0.6, 0, 0.8], (len(points), 1))]
    rows = "".join(" ".join(f"{x:.6f}" for x in row) + "\n" for row in np.hstack(columns))
    path, saved = write(tmp_path, "a.xyz", rows.encode()), tmp_path / "a.hrbf"
    given = ",".join(f"{x:.6f}" for x in stood)
    assert main(["fit", str(path), str(saved), "--viewpoint", given, *normals]) == 0
    assert "the front of this open surface" not in capsys.readouterr().err
    with hrbfnpr.Model.load(saved) as model:
        assert looks_to(model, points, stood) == 1


def test_an_unused_viewpoint_gives_a_warning(tmp_path, capsys):
    points = wall()
    normals = -points / np.linalg.norm(points, axis=1, keepdims=True)
    rows = "".join(" ".join(f"{x:.6f}" for x in row) + "\n" for row in np.hstack([points, normals]))
    path = write(tmp_path, "a.xyz", rows.encode())
    assert main(["fit", str(path), str(tmp_path / "a.hrbf"), "--viewpoint", "0,0,0"]) == 0
    assert "--viewpoint is ignored: there are normals already" in capsys.readouterr().err
    assert main(["fit", str(path), str(tmp_path / "b.hrbf"), "--viewpoint", "0,0"]) == 2
    assert "--viewpoint" in capsys.readouterr().err


def test_a_pcd_viewpoint_at_the_origin_is_ignored(tmp_path):
    head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
    for line in ("VIEWPOINT 0 0 0 1 0 0 0\n", "VIEWPOINT\n", "VIEWPOINT 1 x 3\n", "VIEWPOINT 1 nan 3\n", ""):
        text = head + line + "POINTS 1\nDATA ascii\n1 2 3\n"
        assert shapes.read(write(tmp_path, "a.pcd", text.encode())).viewpoint is None
