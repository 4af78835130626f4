# SPDX-License-Identifier: MIT
"""Points along curves, such as wires and cross sections."""
import json

import numpy as np
import pytest
from curves import wires
from test_cli import rows

import hrbfnpr
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")


def drawn(tmp_path, capsys, table, *options):
    (tmp_path / "a.xyz").write_text(rows(table))
    assert main(["draw", str(tmp_path / "a.xyz"), str(tmp_path / "a.png"), "--size", "120x120", *options]) == 0
    return capsys.readouterr()


def test_the_surface_between_wires_is_drawn(tmp_path, capsys):
    out, err = drawn(tmp_path, capsys, wires()[0])
    assert "closed surface" in out and "the whole surface is kept" in out
    assert "the points lie along curves" in err and "left out" not in out + err
    ink = np.asarray(Image.open(tmp_path / "a.png").convert("L")) < 250
    drawn(tmp_path, capsys, np.hstack(wires()), "--close")
    assert (ink ^ (np.asarray(Image.open(tmp_path / "a.png").convert("L")) < 250)).mean() < 0.1


def test_normals_in_the_surface_are_replaced(tmp_path, capsys):
    points, normals = wires()
    wrong = normals.copy()
    wrong[::3] = np.cross(normals[::3], [0.6, 0.0, 0.8])
    _, err = drawn(tmp_path, capsys, np.hstack([points, wrong]))
    assert f"normals repaired: 0 turned, {len(points)} computed again" in err


def checked(tmp_path, capsys, table):
    (tmp_path / "a.xyz").write_text(rows(table))
    status = main(["check", str(tmp_path / "a.xyz"), "--json"])
    return status, json.loads(capsys.readouterr().out)


def test_check_reports_points_along_curves(tmp_path, capsys):
    points, normals = wires()
    status, facts = checked(tmp_path, capsys, np.hstack([points, normals]))
    assert status == 0 and facts["along_curves"] is True and facts["normals_look"] == "outward"
    status, facts = checked(tmp_path, capsys, np.hstack([points, -normals]))
    assert status == 1 and facts["normals_look"] == "inward"
    normals[::3] = np.cross(normals[::3], [0.6, 0.0, 0.8])
    status, facts = checked(tmp_path, capsys, np.hstack([points, normals]))
    assert status == 1 and facts["normals_look"] == "none"
    assert "the normals do not fit the points" in facts["warnings"]
