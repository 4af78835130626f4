# SPDX-License-Identifier: MIT
"""CAD formats that the DRAW program of Open CASCADE reads, where it is installed."""
import re
import subprocess

import numpy as np
import pytest
from test_shapes import CUBE, QUADS, write

from hrbfnpr import shapes
from hrbfnpr.cli import main
from hrbfnpr.shapes import _cad

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('box','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('{schema}'));
ENDSEC;
DATA;
"""
PRODUCT = """#1=APPLICATION_CONTEXT('automotive design');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('box','box','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#6=PRODUCT_DEFINITION('design','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=FACETED_BREP_SHAPE_REPRESENTATION('',(#20),#10);
#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))REPRESENTATION_CONTEXT('',''));
#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#20=FACETED_BREP('',#21);
"""


def step(schema="AUTOMOTIVE_DESIGN"):
    """A STEP file of a box, 1 by 1 by 2."""
    lines, faces = [], []
    for i, (x, y, z) in enumerate(CUBE):
        lines.append(f"#{100 + i}=CARTESIAN_POINT('',({x:f},{y:f},{2 * z:f}));")
    for i, quad in enumerate(QUADS):
        corners = ",".join(f"#{100 + k}" for k in quad)
        a, b, c = (np.array(CUBE[k]) * [1, 1, 2] for k in quad[:3])
        n = np.cross(b - a, c - b) / np.linalg.norm(np.cross(b - a, c - b))
        at = 200 + 10 * i
        lines += [
            f"#{at}=POLY_LOOP('',({corners}));",
            f"#{at + 1}=FACE_OUTER_BOUND('',#{at},.T.);",
            f"#{at + 2}=DIRECTION('',({n[0]:f},{n[1]:f},{n[2]:f}));",
            f"#{at + 3}=DIRECTION('',({n[1]:f},{n[2]:f},{n[0]:f}));",
            f"#{at + 4}=AXIS2_PLACEMENT_3D('',#{100 + quad[0]},#{at + 2},#{at + 3});",
            f"#{at + 5}=PLANE('',#{at + 4});",
            f"#{at + 6}=FACE_SURFACE('',(#{at + 1}),#{at + 5},.T.);",
        ]
        faces.append(f"#{at + 6}")
    lines.append(f"#21=CLOSED_SHELL('',({','.join(faces)}));")
    return HEAD.format(schema=schema) + PRODUCT + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"


@pytest.fixture
def draw():
    if _cad._program() is None:
        pytest.skip("Open CASCADE's DRAW is not installed (apt-get install occt-draw)")


@pytest.mark.parametrize("name", ["box.stp", "box.STEP", "box [x] $y.xyz"])
def test_step(draw, tmp_path, name):
    shape = shapes.read(write(tmp_path, name, step()))
    assert shape.format == "STEP" and shape.up == (0, 0, 1) and len(shape.triangles) == 12
    np.testing.assert_allclose([shape.points.min(axis=0), shape.points.max(axis=0)], [[0, 0, 0], [1, 1, 2]], atol=1e-6)
    a, b, c = (shape.points[shape.triangles[:, k]] for k in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(2)  # the faces look outward


def made_by_draw(tmp_path, commands):
    """Runs commands in DRAW that save a file."""
    (tmp_path / "make.tcl").write_text("pload MODELING XDE\n" + commands)
    program = _cad._program()
    subprocess.run(
        [program, "-b", "-f", "make.tcl"], cwd=tmp_path, env=_cad._with_plugins(program, tmp_path / "plugins"),
        check=True, capture_output=True,
    )  # fmt: skip


@pytest.mark.parametrize("ending, saves", [("brep", "save c"), ("igs", "brepiges c"), ("step", "stepwrite a c")])
def test_round_faces_stay_round(draw, tmp_path, ending, saves):
    made_by_draw(tmp_path, f"pcylinder c 10 30\n{saves} round.{ending}\n")
    shape = shapes.read(tmp_path / f"round.{ending}")
    radius = np.linalg.norm(shape.points[:, :2], axis=1)
    assert radius.max() == pytest.approx(10, abs=1e-5)
    middles = shape.points[shape.triangles].mean(axis=1)
    side = np.ptp(shape.points[shape.triangles][:, :, 2], axis=1) > 1
    off = 10 - np.linalg.norm(middles[side][:, :2], axis=1)
    assert side.sum() >= 60 and off.max() < 5e-4 * np.linalg.norm([20, 20, 30])
    said = [re.search(r"triangles, at most ([\d.e-]+)% of the diagonal off", note) for note in shape.notes]
    across = np.linalg.norm([20, 20, 30])
    assert off.max() <= 0.01 * max(float(one[1]) for one in said if one) * across * 1.05 < 1e-3 * across


def test_step_is_drawn(draw, tmp_path, capsys):
    path = write(tmp_path, "box.step", step())
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    captured = capsys.readouterr()
    assert "STEP: " in captured.out and "up is z, as in STEP files" in captured.err


def test_unreadable_files_are_named(draw, tmp_path):
    for name, data, reason in (
        ("a.step", step()[:2000], "ERR StepFile"),
        ("a.igs", "x", "Cannot read any relevant data from the IGES file"),
        ("a.brep", "no such thing", "File was not written with this version of the topology"),
    ):
        with pytest.raises(shapes.ShapeError, match=f"cannot turn it into triangles: {reason}.*; FreeCAD exports it as STL"):
            shapes.read(write(tmp_path, name, data))
    made_by_draw(tmp_path, "polyline p 0 0 0 1 0 0 1 1 0\nsave p curve.brep\n")
    with pytest.raises(shapes.ShapeError, match="no faces: curves alone"):
        shapes.read(tmp_path / "curve.brep")


def test_a_missing_program_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(_cad, "_program", lambda: None)
    with pytest.raises(shapes.ShapeError, match="needs DRAW of Open CASCADE .occt-draw.; without it, FreeCAD"):
        shapes.read(write(tmp_path, "box.step", step()))


def test_ifc_buildings_are_not_taken_for_step(tmp_path, monkeypatch):
    monkeypatch.setattr(_cad, "_program", lambda: None)
    with pytest.raises(shapes.ShapeError) as raised:
        shapes.read(write(tmp_path, "house.ifc", step("IFC2X3")))
    assert "Open CASCADE" not in str(raised.value)
