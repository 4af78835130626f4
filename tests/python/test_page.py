# SPDX-License-Identifier: MIT
"""Drawings as vectors: files, pens, paper, and that they look like the picture."""
import io
import json
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr
from hrbfnpr import Annotation, PageItem, Pen, write_page
from hrbfnpr.cli import main

SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
SIZE = 1600


@pytest.fixture(scope="module")
def model():
    points = fibonacci_sphere(400) * (1.0, 0.7, 0.5)
    normals = points / np.array((1.0, 0.49, 0.25))
    return hrbfnpr.Model.fit(points, normals / np.linalg.norm(normals, axis=1)[:, None])


def drawn(model, preset, size=SIZE):
    style = hrbfnpr.Style(preset)
    for layer in style.layers:
        layer.radius *= size / 800
    layers = [hrbfnpr.Layer(one.kind, budget=20_000, name=one.name, angle=one.angle) if one.kind == "hatch" else
              hrbfnpr.Layer(one.kind, budget=20_000, name=one.name) for one in hrbfnpr.preset_layers(preset)]
    marks = hrbfnpr.PointSet.generate(model, layers)
    lines = hrbfnpr.LineSet(model, with_curvature=True) if style.lines else None
    camera = hrbfnpr.Camera.look_at((2.0, 1.5, 3.0), (0, 0, 0), (0, 1, 0)).perspective(0.7, (size, size), 0.5, 8.0)
    return hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera)


def rendered(svg, tmp_path):
    from PIL import Image

    if shutil.which("rsvg-convert") is None:
        pytest.skip("rsvg-convert is not here: apt-get install librsvg2-bin")
    (tmp_path / "a.svg").write_bytes(svg)
    command = ["rsvg-convert", "-w", str(SIZE), "-h", str(SIZE), str(tmp_path / "a.svg"), "-o", str(tmp_path / "a.png")]
    subprocess.run(command, check=True)
    return np.asarray(Image.open(tmp_path / "a.png").convert("RGB"), dtype=float)


@pytest.mark.parametrize("preset", hrbfnpr.PRESETS)
def test_vectors_look_like_the_picture(model, preset, tmp_path):
    drawing = drawn(model, preset)
    picture = np.asarray(drawing.to_pil().convert("RGB"), dtype=float)
    assert picture.std() > 3
    svg = drawing.to_svg().encode()
    error = ((rendered(svg, tmp_path) - picture) ** 2).mean()
    assert 10 * np.log10(255**2 / error) >= 35


def groups_of(svg):
    root = ET.fromstring(svg)
    return {group.get(LABEL): group for group in root.iter(f"{SVG}g") if group.get(LABEL)}


def test_groups_are_layers(model):
    drawing = drawn(model, "etching", 400)
    groups = groups_of(drawing.to_svg(title="A & B"))
    assert {"paper", "contour", "hatch-1", "hatch-2", "hatch-3"} <= set(groups)
    assert sum(layer.strokes for layer in drawing.layers) <= sum(len(group) for group in groups.values())
    assert b"A &amp; B" in drawing.to_svg(title="A & B").encode()


def test_layers_have_polylines(model):
    drawing = drawn(model, "etching", 300)
    for number, layer in enumerate(drawing.layers):
        lines = layer.polylines
        assert len(lines) == layer.strokes == len(drawing.polylines(number))
        assert all(line.shape[1] == 2 and line.dtype == np.float32 for line in lines)
        assert all(-50 < line.min() and line.max() < 350 for line in lines)
    assert sum(layer.strokes for layer in drawing.layers) > 100
    assert "polylines" not in repr(drawing.layers[0])


def test_files_by_their_endings(model, tmp_path):
    drawing = drawn(model, "hatch", 300)
    for name, begin in (("a.svg", b"<?xml"), ("a.pdf", b"%PDF-1.5")):
        info = drawing.save(tmp_path / name, scale=0.5)
        assert (tmp_path / name).read_bytes().startswith(begin)
        assert info.bytes == (tmp_path / name).stat().st_size and info.width == 150 and info.paths > 10
    assert drawing.save(tmp_path / "a.png") is None
    with pytest.raises(TypeError, match="scale"):
        drawing.save(tmp_path / "a.png", scale=2)
    with pytest.raises(TypeError, match="no option 'colour'"):
        drawing.save(tmp_path / "a.svg", colour=2)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="tolerance"):
        drawing.save(tmp_path / "b.svg", tolerance=-1)
    assert not (tmp_path / "b.svg").exists() and len(list(tmp_path.iterdir())) == 3


def test_a_page_of_several(model):
    drawing, file = drawn(model, "silhouette", 200), io.BytesIO()
    items = [PageItem(drawing, name="one"), PageItem(drawing, x=60, scale=0.3, name="two")]
    note = Annotation([[5, 70], [60, 70]], group="rule", line_type="dashed", width=0.5)
    pens = [Pen("contour*", 0.7, (1, 0, 0)), Pen("contour hidden*", 0.2, line_type="dashed")]
    info = write_page(file, items, pens=pens, annotations=[note, Annotation([[5, 78]], "two of them", "text", 4.0)])
    svg = file.getvalue().decode()
    groups = groups_of(svg)
    assert {"one", "two", "contour", "rule", "text"} <= set(groups) and info.width == 120
    assert groups["contour"].get("fill") == "#ff0000" and 'stroke-width=".7"' in svg
    assert len(groups["rule"]) == 8 and groups["text"][0].text == "two of them"
    with pytest.raises(ValueError, match="line_type"):
        write_page(file, items, pens=[Pen(line_type="zigzag")])


def test_a_notebook_shows_vectors_if_they_are_few(model, monkeypatch):
    drawing = drawn(model, "silhouette", 200)
    assert drawing._repr_svg_().startswith("<?xml")
    monkeypatch.setattr("hrbfnpr._drawing._MOST_IN_NOTEBOOK", drawing.info.strokes - 1)
    assert drawing._repr_svg_() is None


@pytest.fixture
def points(tmp_path):
    path = tmp_path / "ball.xyz"
    ball = fibonacci_sphere(300)
    np.savetxt(path, np.column_stack((ball, ball)))
    return path


QUICK = ["--size", "200", "--marks", "3000"]


def test_the_command_line_writes_vectors(points, tmp_path, capsys):
    svg, pdf, png = (tmp_path / f"a.{ending}" for ending in ("svg", "pdf", "png"))
    command = ["draw", str(points), str(svg), "--also", str(pdf), "--also", str(png), *QUICK]
    assert main(command) == 0
    assert f"{svg}, {pdf}, {png}" in capsys.readouterr().out
    root = ET.parse(svg).getroot()
    facts = json.loads(root.find(f"{SVG}metadata").text.splitlines()[0])
    assert facts["input"] == "ball.xyz" and facts["model"]["centres"] == 300 and len(facts["camera"]["view"]) == 4
    assert float(root.get("width")[:-2]) == pytest.approx(200 * 25.4 / 96, abs=1e-3)
    first = svg.read_bytes()
    assert main(command) == 0 and svg.read_bytes() == first


def test_paper_and_pens(points, tmp_path, capsys):
    svg = tmp_path / "a.svg"
    options = ["--page", "a5", "--pens", "contour=#803000:0.5,stipples=:0.3", "--dots", "lines"]
    assert main(["draw", str(points), str(svg), *options, *QUICK]) == 0
    root = ET.parse(svg).getroot()
    assert {root.get("width"), root.get("height")} == {"148mm", "210mm"}
    groups = groups_of(svg.read_bytes())
    assert groups["contour"].get("fill") == "#803000"
    assert {path.get("stroke-width") for path in groups["contour"]} == {".5"}
    assert {path.get("stroke-width") for path in groups["stipples"]} == {".3"}
    assert main(["draw", str(points), str(svg), "--pen-widths", "0.2,0.8", *QUICK]) == 0
    assert {path.get("stroke-width") for path in groups_of(svg.read_bytes())["contour"]} <= {".2", ".8"}
    capsys.readouterr()
    for options, words in (
        (["--pens", "contour"], "GROUP=COLOUR:WIDTH"), (["--pens", "a=#12:1"], "colour"), (["--page", "b9"], "a4"),
        (["--pen-widths", "0"], "widths above 0"), (["--page", "a4", "--page-margin", "200"], "leave room"),
    ):  # fmt: skip
        try:
            status = main(["draw", str(points), str(svg), *options, *QUICK])
        except SystemExit as end:
            status = end.code
        assert status != 0 and words in capsys.readouterr().err
    assert main(["draw", str(points), str(tmp_path / "a.png"), "--page", "a4", *QUICK]) != 0
    assert "--page is of vectors" in capsys.readouterr().err


def test_a_plate_of_vectors(points, tmp_path):
    svg = tmp_path / "a.svg"
    assert main(["draw", str(points), str(svg), "--style", "archaeological", "--scale-bar", "cm", "--size", "200"]) == 0
    groups = groups_of(svg.read_bytes())
    assert {"view", "profile", "section", "section hatching", "scale bar", "scale"} <= set(groups)
    assert len(groups["section hatching"]) > 5 and re.fullmatch(r"[125]?0?\.?\d* cm", groups["scale"][1].text)


def test_hatching_of_cut_faces():
    from hrbfnpr.cli._cut_faces import closed, hatched

    square = np.array(((0, 0), (10, 0), (10, 10), (0, 10), (0, 0)), dtype=float)
    hole = 4 + 0.2 * square
    parts = [square[:3], square[4:1:-1], hole]
    outlines = closed(parts)
    assert sorted(len(outline) for outline in outlines) == [5, 5]
    assert closed([square[:4]]) == []
    lines = hatched(outlines, 0.5)
    length = sum(np.linalg.norm(b - a) for a, b in lines)
    assert length * 0.5 == pytest.approx(96, rel=0.02)  # the area
    for a, b in lines:
        assert (b - a)[0] == pytest.approx(-(b - a)[1])  # rising to the right, y down
        for t in np.linspace(0.01, 0.99, 9):
            x, y = a + t * (b - a)
            assert 0 <= x <= 10 and 0 <= y <= 10 and not (4.01 < x < 5.99 and 4.01 < y < 5.99)


def test_plotters(points, tmp_path, capsys):
    for name, begin in (("a.hpgl", "IN;\nSP1;"), ("a.plt", "IN;\nSP1;"), ("a.gcode", "(ball.xyz)"), ("a.nc", "(ball.xyz)")):
        path = tmp_path / name
        assert main(["draw", str(points), str(path), "--style", "hatch", "--page", "a6", *QUICK]) == 0
        assert path.read_text().startswith(begin)
        said = "".join(capsys.readouterr())
        assert re.search(r"the pen draws \d\.\d\d m and travels \d\.\d\d m, in about \d+ min \d+ s", said)
    moves = re.findall(r"P[UD]([-\d,]+);", (tmp_path / "a.hpgl").read_text())
    places = np.array([pair for move in moves for pair in np.array(move.split(","), dtype=float).reshape(-1, 2)]) / 40
    assert (places >= 10 - 1e-9).all() and (places <= (105 - 10, 148 - 10)).all()  # within the margin
    up = ["--pen-up", "M5", "--pen-down", "M3 S90"]
    assert main(["draw", str(points), str(tmp_path / "b.gcode"), *up, *QUICK]) == 0
    assert "\nM5\n" in (tmp_path / "b.gcode").read_text() and "\nM3 S90\n" in (tmp_path / "b.gcode").read_text()


def test_plot_order_travels_less(model):
    drawing = drawn(model, "etching", 400)
    as_drawn, sorted_lines = io.BytesIO(), io.BytesIO()
    assert drawing.save(as_drawn, "svg").travelled == 0
    info = drawing.save(sorted_lines, "svg", plot_order=True)
    assert info.drawn > info.travelled > 0 and info.seconds > info.drawn / 30
    names = [set(groups_of(file.getvalue())) for file in (as_drawn, sorted_lines)]
    assert names[0] == names[1]
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="PUBLISHED"):
        style = hrbfnpr.Style("stipple", visibility="published")
        marks = hrbfnpr.PointSet.generate(model, [hrbfnpr.Layer("stipples", budget=500)])
        hrbfnpr.Renderer().draw((marks, style), hrbfnpr.Camera.fit(model, (0, 0, -1))).save(io.BytesIO(), "hpgl")
