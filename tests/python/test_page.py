# SPDX-License-Identifier: MIT
"""Vector output: files, pens and paper, and the same look as the picture."""
import io
import json
import os
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


def test_svg_groups_are_layers(model):
    drawing = drawn(model, "etching", 400)
    groups = groups_of(drawing.to_svg(title="A & B"))
    assert {"paper", "contour", "hatch-1", "hatch-2", "hatch-3"} <= set(groups)
    assert sum(layer.strokes for layer in drawing.layers) <= sum(len(group) for group in groups.values())
    assert b"A &amp; B" in drawing.to_svg(title="A & B").encode()


def test_layers_give_their_polylines(model):
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


def test_a_page_of_several_drawings(model):
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


def test_a_notebook_shows_vectors_of_few_lines(model, monkeypatch):
    drawing = drawn(model, "silhouette", 200)
    assert drawing._repr_svg_().startswith("<svg")
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
        (["--pen-widths", "0"], "widths in mm above 0"), (["--page", "a4", "--page-margin", "200"], "leave room"),
    ):  # fmt: skip
        try:
            status = main(["draw", str(points), str(svg), *options, *QUICK])
        except SystemExit as end:
            status = end.code
        assert status != 0 and words in capsys.readouterr().err
    assert main(["draw", str(points), str(tmp_path / "a.png"), "--page", "a4", *QUICK]) != 0
    assert "--page is for vectors" in capsys.readouterr().err


def test_plotters(points, tmp_path, capsys):
    for name, begin in (("a.hpgl", "IN;\nSP1;"), ("a.plt", "IN;\nSP1;"), ("a.gcode", "(ball.xyz)"), ("a.nc", "(ball.xyz)")):
        path = tmp_path / name
        assert main(["draw", str(points), str(path), "--style", "hatch", "--page", "a6", *QUICK]) == 0
        assert path.read_text().startswith(begin)
        said = "".join(capsys.readouterr())
        assert re.search(r"the pen draws [\d.]+ m and travels [\d.]+ m in about \d+ (min|s)", said)
    moves = re.findall(r"P[UD]([-\d,]+);", (tmp_path / "a.hpgl").read_text())
    places = np.array([pair for move in moves for pair in np.array(move.split(","), dtype=float).reshape(-1, 2)]) / 40
    assert (places >= 10 - 1e-9).all() and (places <= (105 - 10, 148 - 10)).all()  # within the margins
    up = ["--pen-up", "M5", "--pen-down", "M3 S90"]
    assert main(["draw", str(points), str(tmp_path / "b.gcode"), *up, *QUICK]) == 0
    assert "\nM5\n" in (tmp_path / "b.gcode").read_text() and "\nM3 S90\n" in (tmp_path / "b.gcode").read_text()


# The place of Debian's w3c-sgml-lib.
SVG_DTD = "/usr/share/xml/w3c-sgml-lib/schema/dtd/REC-SVG11-20110816/svg11.dtd"


@pytest.mark.parametrize("preset", ["etching", "full", "blueprint"])
def test_svg_is_valid(model, preset, tmp_path):
    if shutil.which("xmllint") is None or not os.path.exists(SVG_DTD):
        pytest.skip("no DTD of SVG 1.1 to validate with: apt-get install libxml2-utils w3c-sgml-lib")
    svg = drawn(model, preset, 300).to_svg(title="A & B")
    # A DTD knows no other XML namespaces.
    plain = re.sub(r' (xmlns:inkscape|inkscape:\w+)="[^"]*"', "", svg)
    assert plain != svg
    command = ["xmllint", "--noout", "--nonet", "--dtdvalid", SVG_DTD, str(tmp_path / "a.svg")]
    (tmp_path / "a.svg").write_text(plain)
    subprocess.run(command, check=True)
    (tmp_path / "a.svg").write_text(plain.replace("<path", "<pathe", 1))
    assert subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode != 0


@pytest.mark.parametrize("preset", ["etching", "stipple"])
def test_pdf_is_valid(model, preset, tmp_path):
    if shutil.which("qpdf") is None:
        pytest.skip("qpdf is not here: apt-get install qpdf")
    drawn(model, preset, 300).save(tmp_path / "a.pdf", title="A & B")
    subprocess.run(["qpdf", "--check", str(tmp_path / "a.pdf")], check=True)
    whole = (tmp_path / "a.pdf").read_bytes()
    (tmp_path / "a.pdf").write_bytes(whole.replace(b"startxref\n", b"startxref\n9", 1))
    assert subprocess.run(["qpdf", "--check", str(tmp_path / "a.pdf")], check=False).returncode != 0


def hpgl_lines(text):
    """Pen lines of an HPGL file in mm. HPGL has 40 units per mm; PU and PD take positions, y points up."""
    place, line, lines = (0.0, 0.0), [], []
    for code, numbers in re.findall(r"([A-Z]{2})([^;]*);", text):
        if code not in ("PU", "PD"):
            continue
        if code == "PU" and len(line) > 1:
            lines.append(line)
        line = [] if code == "PU" else line or [place]
        values = [float(number) / 40 for number in numbers.split(",") if number]
        for to in zip(values[::2], values[1::2]):
            place = to
            if code == "PD":
                line.append(to)
    return [*lines, line] if len(line) > 1 else lines


def gcode_lines(text):
    """Pen lines of a G-code file in mm. Moves keep the axes that they do not name. The pen is down at Z <= 0.  G2 and G3 are
    arcs, clockwise and counterclockwise, around a centre that is given relative to their beginnings."""
    at, line, lines = {"X": 0.0, "Y": 0.0, "Z": 1.0}, [], []
    for row in re.sub(r"\([^)]*\)|;.*", "", text).splitlines():
        words = dict(re.findall(r"([A-Z])(-?[\d.]+)", row))
        if "G" not in words or float(words["G"]) not in (0, 1, 2, 3):
            continue
        if "I" in words:
            begin, centre = complex(at["X"], at["Y"]), complex(at["X"] + float(words["I"]), at["Y"] + float(words["J"]))
            turn = np.angle((complex(float(words["X"]), float(words["Y"])) - centre) / (begin - centre)) % (2 * np.pi)
            turn -= 2 * np.pi * (words["G"] == "2")
            line += [(p.real, p.imag) for p in centre + (begin - centre) * np.exp(1j * turn * np.linspace(0, 1, 32)[1:-1])]
        at.update({axis: float(words[axis]) for axis in "XYZ" if axis in words})
        if at["Z"] > 0 and len(line) > 1:
            lines.append(line)
        line = [] if at["Z"] > 0 else [*line, (at["X"], at["Y"])]
    return [*lines, line] if len(line) > 1 else lines


def plotted(lines, height, scale, size, pen):
    """An image of lines drawn by a round pen, rendered eight times as large and then reduced."""
    from PIL import Image, ImageDraw

    fine = 8
    image = Image.new("L", (fine * size, fine * size), 255)
    draw, r = ImageDraw.Draw(image), fine * pen / scale / 2
    for line in lines:
        places = [(fine * x / scale, fine * (height - y) / scale) for x, y in line]
        draw.line(places, fill=0, width=round(2 * r))
        for x, y in places:
            draw.ellipse((x - r, y - r, x + r, y + r), fill=0)
    return np.asarray(image.resize((size, size), Image.BOX), dtype=float)


@pytest.mark.parametrize("kind, read", [("hpgl", hpgl_lines), ("gcode", gcode_lines)])
def test_plots_look_like_the_picture(model, kind, read):
    size, scale, width = 600, 0.2, 3.0
    pen = 1.5 * width * scale  # this style draws outlines 1.5 times as wide
    style = hrbfnpr.Style("silhouette")
    style.lines = [line for line in style.lines if line.kind == "contour"]
    for line in style.lines:
        line.width, line.taper, line.far_factor, line.hidden = width, 0.0, 1.0, "none"
    lines = hrbfnpr.LineSet(model, with_curvature=True)
    camera = hrbfnpr.Camera.look_at((2.0, 1.5, 3.0), (0, 0, 0), (0, 1, 0)).perspective(0.7, (size, size), 0.5, 8.0)
    marks = hrbfnpr.PointSet.generate(model, [hrbfnpr.Layer("stipples", budget=2000)])
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera)
    file = io.BytesIO()
    drawing.save(file, kind, scale=scale, pens=[Pen(width=pen)], tolerance=0.01)
    picture = np.asarray(drawing.to_pil().convert("L"), dtype=float)
    plot = plotted(read(file.getvalue().decode()), size * scale, scale, size, pen)
    psnr = 10 * np.log10(255**2 / ((plot - picture) ** 2).mean())
    print(f"{kind}: {psnr:.1f} dB")
    assert picture.min() == 0 and psnr > 30
    shifted = np.roll(plot, 2, axis=0)
    assert 10 * np.log10(255**2 / ((shifted - picture) ** 2).mean()) < psnr - 5
def ball(centre, ink, size=SIZE):
    points = fibonacci_sphere(300)
    model = hrbfnpr.Model.fit(points + centre, points)
    style = hrbfnpr.Style("contour-and-stipple")
    for layer in style.layers:
        layer.radius, layer.ink = 5 * size / 800, ink
    for line in style.lines:
        line.ink, line.width = ink, 8 * size / 800
    style.paper = (1, 1, 1, 1)
    marks = hrbfnpr.PointSet.generate(model, [hrbfnpr.Layer("stipples", budget=4000, name="stipples")])
    return hrbfnpr.Item(marks, style, line_set=hrbfnpr.LineSet(model))


def test_overlapping_colours_are_painted_as_in_the_picture(tmp_path):
    # The nearer ball comes first in the list and hides the other.
    items = [ball((0.4, 0.2, 0.7), (0.9, 0.2, 0.1, 1)), ball((-0.3, -0.1, -0.7), (0.1, 0.3, 0.8, 1))]
    for item in items:
        item.style.visibility = "depth_layers"
        item.style.hidden_lines = "show"
        item.style.attenuation_front = item.style.attenuation_back = 0.0
    camera = hrbfnpr.Camera.look_at((0.5, 0.4, 5.0), (0, 0, 0), (0, 1, 0)).perspective(0.7, (SIZE, SIZE), 0.5, 12.0)
    drawing = hrbfnpr.Renderer().draw(items, camera)
    picture = np.asarray(drawing.to_pil().convert("RGB"), dtype=float)
    svg = drawing.to_svg()
    names = list(groups_of(svg))
    assert any(", run 2" in name for name in names) and len(names) < 30
    error = ((rendered(svg.encode(), tmp_path) - picture) ** 2).mean()
    assert 10 * np.log10(255**2 / error) >= 35
    # Painted group by group, the picture differs.
    file = io.BytesIO()
    drawing.save(file, "svg", plot_order=True, join=1e-9, shortest=1e-9, dot_distance=1e-9)
    assert not any(", run" in name for name in groups_of(file.getvalue()))
    whole = ((rendered(file.getvalue(), tmp_path) - picture) ** 2).mean()
    assert whole > 2 * error
    both = [10 * np.log10(255**2 / one) for one in (error, whole)]
    print(f"far to near {both[0]:.1f} dB in {len(names)} groups, group by group {both[1]:.1f} dB")


def test_a_plot_has_the_tone_of_the_picture(model):
    size, scale, pen = 500, 0.4, 0.25
    drawing = drawn(model, "woodcut", size)
    picture = np.asarray(drawing.to_pil().convert("L"), dtype=float)
    picture = 255 * (picture - picture.min()) / (picture.max() - picture.min())  # stretched to black on white
    found = {}
    for single in (False, True):
        file = io.BytesIO()
        info = write_page(file, PageItem(drawing, scale=scale), format="hpgl", pens=[Pen("*", pen)], single_pass=single)
        plot = plotted(hpgl_lines(file.getvalue().decode()), size * scale, scale, size, pen)
        ink = (255 - plot).sum() / (255 - picture).sum()
        found[single] = info, ink, 10 * np.log10(255**2 / ((plot - picture) ** 2).mean())
        print(f"single_pass={single}: ink {ink:.3f}, PSNR {found[single][2]:.1f} dB, {info.filled_paths} filled, "
              f"drawn {info.drawn:.0f} mm, {info.seconds:.0f} s")  # fmt: skip
    assert found[False][0].filled_paths > 50 and found[True][0].filled_paths == 0
    assert abs(found[False][1] - 1) < 0.05 < 0.3 < 1 - found[True][1]
    assert found[False][2] > 30 and found[True][2] < 15
    assert found[False][0].drawn > found[True][0].drawn and found[False][0].seconds > found[True][0].seconds


def test_the_command_line_fills_lines_and_finds_pens_for_dots(points, tmp_path, capsys):
    svg, plot = tmp_path / "a.svg", tmp_path / "a.hpgl"
    assert main(["draw", str(points), str(svg), "--pen-widths", "0.2,0.8", "-v", *QUICK]) == 0
    said = "".join(capsys.readouterr())
    assert re.search(r"pens: contour 0\.\d mm, stipples 0\.\d mm\n", said)
    assert re.search(r"contour 0\.\d mm \(lines of [\d.]+ mm\), stipples 0\.\d mm \(dots of [\d.]+ mm\)\.\n", said)
    common = ["draw", str(points), str(plot), "--style", "woodcut", "--pen-widths", "0.1", "--page", "a4", "-v", *QUICK]
    assert main(common) == 0
    assert re.search(r"    It fills [1-9]\d* lines wider than the pen by several passes", "".join(capsys.readouterr()))
    assert main([*common, "--single-pass"]) == 0
    assert "    It fills 0 lines wider than the pen" in "".join(capsys.readouterr())
