# SPDX-License-Identifier: MIT
"""DXF, read by another program (ezdxf), and paths for plotters from the command line."""
import io
import re

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr
from hrbfnpr import Annotation, PageItem, Pen, write_page
from hrbfnpr.cli import main

SIZE, SCALE = 400, 0.25  # pixels, and mm of a pixel


@pytest.fixture(scope="module")
def model():
    points = fibonacci_sphere(400) * (1.0, 0.7, 0.5)
    normals = points / np.array((1.0, 0.49, 0.25))
    return hrbfnpr.Model.fit(points, normals / np.linalg.norm(normals, axis=1)[:, None])


def drawn(model, preset, budget=3000):
    layers = [hrbfnpr.Layer(one.kind, budget=budget, name=one.name) for one in hrbfnpr.preset_layers(preset)]
    marks = hrbfnpr.PointSet.generate(model, layers)
    lines = hrbfnpr.LineSet(model, with_curvature=True)
    camera = hrbfnpr.Camera.look_at((2.0, 1.5, 3.0), (0, 0, 0), (0, 1, 0)).perspective(0.7, (SIZE, SIZE), 0.5, 8.0)
    return hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, hrbfnpr.Style(preset), line_set=lines), camera)


def audited(data):
    """The document, without any fault that ezdxf finds."""
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not here: apt-get install python3-ezdxf")
    document = ezdxf.read(io.StringIO(data.decode("ascii")))
    auditor = document.audit()
    assert not auditor.errors and not auditor.fixes, [error.message for error in auditor.errors + auditor.fixes]
    return document


def distances(points, lines):
    """The distance of each point from the nearest segment of some lines."""
    a = np.concatenate([line[:-1] for line in lines])
    way = np.concatenate([np.diff(line, axis=0) for line in lines])
    square = np.maximum((way**2).sum(1), 1e-30)
    found = []
    for point in points:
        t = np.clip(((point - a) * way).sum(1) / square, 0, 1)
        found.append(np.sqrt(((point - a - t[:, None] * way) ** 2).sum(1).min()))
    return np.array(found)


@pytest.mark.parametrize("curves", ["arcs", "splines", "lines"])
def test_another_program_reads_the_lines(model, curves):
    drawing, file = drawn(model, "hatch"), io.BytesIO()
    write_page(file, PageItem(drawing, scale=SCALE), format="dxf", curves=curves, pens=[Pen("", 0.35)])
    document = audited(file.getvalue())
    from ezdxf import path

    entities = list(document.modelspace())
    kinds = {entity.dxftype() for entity in entities}
    assert ("ARC" in kinds) == (curves == "arcs") and (curves != "splines" or "SPLINE" in kinds)
    assert curves != "lines" or kinds <= {"LINE", "LWPOLYLINE"}
    lines = [line for layer in drawing.layers for line in layer.polylines]
    lines = [np.asarray(line, dtype=float) * SCALE for line in lines]
    found = [np.array([(p.x, SIZE * SCALE - p.y) for p in path.make_path(entity).flattening(0.01)])
             for entity in entities]
    assert len(found) > 20
    assert distances(np.concatenate(found)[::5], lines).max() < 0.08
    assert distances(np.concatenate(lines)[::5], found).max() < 0.08


def test_layers_pens_and_texts(model):
    drawing, file = drawn(model, "silhouette"), io.BytesIO()
    pens = [Pen("contour", 0.7, (1, 0, 0)), Pen("contour hidden*", 0.2, line_type="dashed")]
    notes = [Annotation([[5, 70], [60, 70]], group="rule: 1", line_type="long_dashed_dotted", width=0.5),
             Annotation([[5, 78]], "Größe 5 × 7 mm", "text", 4.0)]
    write_page(file, PageItem(drawing, scale=SCALE), format="dxf", pens=pens, annotations=notes, title="Ein Täfelchen")
    document = audited(file.getvalue())
    layers = {layer.dxf.name: layer.dxf for layer in document.layers}
    assert layers["contour"].true_color == 0xFF0000 and layers["contour"].lineweight == 70
    assert layers["rule_ 1"].linetype == "ACAD_ISO04W100"
    rule = next(entity for entity in document.modelspace() if entity.dxf.layer == "rule_ 1")
    assert rule.dxf.ltscale == 0.5 and tuple(rule.dxf.start) == (5, 30, 0)
    text = next(entity for entity in document.modelspace() if entity.dxftype() == "TEXT")
    words = re.sub(r"\\U\+(....)", lambda code: chr(int(code[1], 16)), text.dxf.text)
    assert words == "Größe 5 × 7 mm" and text.dxf.height == 4
    assert document.units == 4 and document.header["$EXTMAX"][:2] == (100, 100)


def test_dots_are_circles(model):
    drawing, file = drawn(model, "contour-and-stipple"), io.BytesIO()
    info = write_page(file, PageItem(drawing, scale=SCALE), format="dxf")
    dots = [entity for entity in audited(file.getvalue()).modelspace() if entity.dxf.layer == "stipples"]
    assert len(dots) == info.dots > 100 and {entity.dxftype() for entity in dots} == {"CIRCLE"}


def test_dxf_has_no_discs_of_paper(model):
    style = hrbfnpr.Style("contour-and-stipple", visibility="published")
    marks = hrbfnpr.PointSet.generate(model, [hrbfnpr.Layer("stipples", budget=500)])
    camera = hrbfnpr.Camera.look_at((2.0, 1.5, 3.0), (0, 0, 0), (0, 1, 0)).perspective(0.7, (SIZE, SIZE), 0.5, 8.0)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="DXF does not have"):
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style), camera).save(io.BytesIO(), format="dxf")


@pytest.fixture
def points(tmp_path):
    path = tmp_path / "ball.xyz"
    ball = fibonacci_sphere(300)
    np.savetxt(path, np.column_stack((ball, ball)))
    return path


QUICK = ["--size", "200", "--marks", "3000", "--style", "silhouette"]


def test_the_command_line_writes_dxf_arcs_and_short_paths(points, tmp_path, capsys):
    dxf, gcode = tmp_path / "a.dxf", tmp_path / "a.gcode"
    command = ["draw", str(points), str(dxf), "--also", str(gcode), *QUICK]
    assert main([*command, "--longest-path", "20"]) == 0
    assert dxf.read_text("ascii").startswith("999\n") and dxf.read_text().endswith("0\nEOF\n")
    short = gcode.read_text()
    assert re.search(r"^G[23] ", short, re.M)
    assert main([*command, "--curves", "lines"]) == 0
    assert not re.search(r"^G[235] ", gcode.read_text(), re.M)
    assert gcode.read_text().count("G1 Z0") < short.count("G1 Z0")
    assert main([*command, "--curves", "splines"]) == 0
    assert re.search(r"^G5 X[-.\d]+ Y[-.\d]+ I[-.\d]+ J[-.\d]+ P[-.\d]+ Q[-.\d]+", gcode.read_text(), re.M)
    capsys.readouterr()
    assert main([*command, "--longest-path", "0.5"]) != 0
    assert "longest" in capsys.readouterr().err
