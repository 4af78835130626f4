# SPDX-License-Identifier: MIT
"""Line sets and styles of lines."""
import pickle
import re

import numpy as np
import pytest
from conftest import torus

import hrbfnpr
from hrbfnpr.cli import main


@pytest.fixture(scope="module")
def model():
    points, normals = torus()
    return hrbfnpr.Model.fit(points, normals)


@pytest.fixture(scope="module")
def marks(model):
    return model.generate(budget=2000)


def camera(model, size=(200, 160)):
    return hrbfnpr.Camera.fit(model, (0.3, 1, -0.7), (0, 0, 1), size=size)


def layers(drawing, kind):
    return [layer for layer in drawing.layers if layer.layer == -1 and layer.kind == kind]


def test_contours_are_curves(model, marks):
    lines = hrbfnpr.LineSet(model)
    assert lines.info.triangles > 1000 and lines.info.turned == 0 and lines.info.borders == 0
    style = hrbfnpr.Style("silhouette")
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model))
    (contour,) = layers(drawing, "contour")
    assert contour.strokes > 2 and contour.mark_class == "silhouette"
    info = drawing.info
    assert info.line_refined <= info.line_curves
    assert info.line_curves >= 2 and info.line_broken == info.line_settled == info.line_contradictions == 0
    assert info.silhouette == 0  # the style of these marks draws no contours
    lines = drawing.polylines(drawing.layers.index(contour))
    assert len(lines) == contour.strokes
    for line in lines:
        steps = np.linalg.norm(np.diff(line["window"][:, :2], axis=0), axis=1)
        assert np.allclose(np.cumsum(steps), line["length"][1:], atol=0.05)
        ring = np.hypot(line["position"][:, 0], line["position"][:, 1])
        off = np.abs(np.hypot(ring - 1, line["position"][:, 2]) - 0.4)
        assert off.max() < 0.02  # the line lies on the torus
    assert (drawing.image()[..., :3].min(axis=2) < 128).mean() > 0.005


def test_lines_of_every_kind(model, marks):
    ring = [(1.4 * np.cos(a), 1.4 * np.sin(a), 0) for a in np.linspace(0, 2 * np.pi, 100)]
    once = [
        "ridge", "valley", "parabolic",
        hrbfnpr.Lines("section", name="slices", levels=[-0.1, 0.1], plane=(0, 0, 3)),
        hrbfnpr.Lines("own", "ring", polylines=[ring]),
    ]  # fmt: skip
    lines = hrbfnpr.LineSet(model, once, with_curvature=True)
    assert lines.info.lines >= 4 and lines.has_curvature
    kinds = ("contour", "suggestive_contour", "apparent_ridge", "parabolic", "border", "own")
    style = hrbfnpr.Style("silhouette", lines=kinds)
    style.lines += [hrbfnpr.LineStyle("section", "slices"), hrbfnpr.LineStyle("isophote", levels=[0.3, 0.6])]
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model))
    for kind in ("contour", "parabolic", "section", "isophote", "own"):
        assert layers(drawing, kind)[0].strokes > 0, kind
    assert layers(drawing, "border")[0].strokes == 0
    style.lines = [hrbfnpr.LineStyle("section", "others")]
    assert hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model)).info.strokes == 0


def test_styles_of_lines():
    style = hrbfnpr.Style("xray")
    assert [line.kind for line in style.lines] == ["contour", "crease", "intersection"]
    assert [line.hidden for line in style.lines] == ["dashed"] * 3 and style.lines[1].creases == "all"
    assert hrbfnpr.LineStyle("crease", creases="concave").creases == "concave"
    with pytest.raises(ValueError):
        hrbfnpr.LineStyle("crease", creases="bent")
    assert hrbfnpr.Style("stipple").lines == []
    copy = style.copy()
    copy.lines[0].width = 7
    assert style.lines[0].width != 7 and copy != style
    assert pickle.loads(pickle.dumps(copy)) == copy
    assert "width=7" in repr(copy.lines[0])
    copy.set_ink("#ff0000")
    assert copy.lines[0].ink == (1, 0, 0, 1)
    with pytest.raises(AttributeError):
        copy.lines[0].widht = 3
    with pytest.raises(TypeError):
        copy.lines = [3]


def contours(drawing):
    (contour,) = layers(drawing, "contour")
    return drawing.polylines(drawing.layers.index(contour))


def test_styles_scale_with_the_picture(model, marks):
    lines, renderer, found = hrbfnpr.LineSet(model), hrbfnpr.Renderer(), []
    for scale in (1, 2, 4):
        style = hrbfnpr.Style("xray", halo_width=3.0 * scale)
        style.lines[0].wobble = 0.5
        style.lines[0].scale(scale)
        drawing = renderer.draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model, (300 * scale, 240 * scale)))
        picture = drawing.image()[..., 0].reshape(240, scale, 300, scale).mean(axis=(1, 3))
        found.append((drawing.info.strokes, sum(line["length"][-1] for line in contours(drawing)) / scale, picture))
    for strokes, length, picture in found[1:]:
        assert strokes == found[0][0]
        assert length == pytest.approx(found[0][1], rel=2e-3)
        assert np.abs(picture - found[0][2]).max() < 40  # grey levels; a line moves by a few hundredths of a pixel


def test_errors_name_the_argument(model, marks):
    lines = hrbfnpr.LineSet(model)
    style = hrbfnpr.Style("silhouette", lines=["suggestive_contour"])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="WITH_CURVATURE"):
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model))
    bad = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", lit_factor=-1)])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"lines\[0\].lit_factor"):
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, bad, line_set=lines), camera(model))
    for once, text in (
        (hrbfnpr.Lines("contour"), r"lines\[0\].kind"),
        (hrbfnpr.Lines("own"), r"lines\[0\].line_first"),
        (hrbfnpr.Lines("ridge", name="x" * 64), r"lines\[0\].name"),
    ):
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=text):
            hrbfnpr.LineSet(model, once)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="support_normals has 2"):
        hrbfnpr.LineSet(model, support_points=[[0, 0, 1]], support_normals=[[0, 0, 1], [0, 0, 1]])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="levels"):
        bad = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("isophote", levels=[2])])
        curved = hrbfnpr.LineSet(model, with_curvature=True)
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, bad, line_set=curved), camera(model))


def test_styles_of_lines_only_place_few_marks(tmp_path, capsys):
    ring = tmp_path / "ring.xyz"
    np.savetxt(ring, np.hstack(torus()), fmt="%.17g")
    draw = ["draw", str(ring), str(tmp_path / "out.png"), "--style", "silhouette", "--size", "200"]
    assert main(draw) == 0
    assert 3500 < int(re.search(r"(\d+) marks", capsys.readouterr().out).group(1)) <= 4000
    # Saved marks are many, because they may be drawn in another style.
    assert main([*draw, "--save-points", str(tmp_path / "ring.points")]) == 0
    assert len(hrbfnpr.PointSet.load(tmp_path / "ring.points")) > 20000


@pytest.fixture(scope="module")
def cushion():
    """A fit to the superellipsoid x^8 + y^8 + z^8 = 1: a cube of width 2 with round edges."""
    grid = np.linspace(-0.97, 0.97, 13)
    u, v = (side.ravel() for side in np.meshgrid(grid, grid))
    faces = [np.roll(np.stack([u, v, np.full_like(u, sign)], axis=1), axis, axis=1) for axis in range(3) for sign in (-1, 1)]
    points = np.concatenate(faces)
    points /= (points**8).sum(axis=1, keepdims=True) ** (1 / 8)
    return hrbfnpr.Model.fit(points, points**7)


def soft_edges(cushion, **fields):
    """The strokes of soft edges in a view of three faces."""
    lines = hrbfnpr.LineSet(cushion, "soft_edge")
    style = hrbfnpr.Style("silhouette")
    style.lines = [hrbfnpr.LineStyle("soft_edge", width=4, taper=0, **fields)]
    camera = hrbfnpr.Camera.fit(cushion, (1, 1.2, 0.9), (0, 0, 1), size=(400, 400))
    return hrbfnpr.Renderer().draw(hrbfnpr.Item(cushion.generate(budget=200), style, line_set=lines), camera).polylines()


def test_soft_edges_are_the_round_edges_of_a_cube(cushion):
    strokes = soft_edges(cushion)
    places = np.abs(np.concatenate([stroke["position"] for stroke in strokes]))
    assert np.sort(places, axis=1)[:, 1].min() > 0.85  # two coordinates are large on an edge
    wide = [np.concatenate([stroke["position"] for stroke in strokes])[:, axis] for axis in range(3)]
    assert all(side.max() - side.min() > 1.0 for side in wide)
    assert [] == soft_edges(cushion, creases="concave")
    assert len(soft_edges(cushion, creases="convex")) == len(strokes)


def test_weak_soft_edges_are_narrow_and_not_pale(cushion):
    def widest(strokes):
        return max(stroke["radius"].max() for stroke in strokes)

    full = soft_edges(cushion, lower=1, upper=2)
    weak = soft_edges(cushion, lower=1, upper=200)
    assert widest(full) == pytest.approx(2.0, abs=0.05)
    assert 0.2 < widest(weak) < 1.2
    assert all((stroke["color"][:, 3] == 255).all() for stroke in weak)
    assert widest(soft_edges(cushion, lower=1, upper=200, fade=0)) == pytest.approx(2.0, abs=0.05)


def test_soft_edges_vanish_beside_contours(cushion):
    towards = np.array([1, 1.2, 0.9])
    for stroke in soft_edges(cushion, lower=1, upper=2):
        normal = stroke["position"] ** 7
        facing = np.abs(normal @ towards) / np.linalg.norm(normal, axis=1) / np.linalg.norm(towards)
        assert stroke["radius"][facing > 0.75].min(initial=2.0) > 1.8
        assert stroke["radius"][facing < 0.1].max(initial=0.0) < 0.3


def test_items_that_cross_have_a_line(model, marks):
    style = hrbfnpr.Style("silhouette")
    lines = hrbfnpr.LineSet(model)
    upright = np.array([[1, 0, 0, 1], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)  # turned about x

    def drawn(move):
        pose = upright.copy()
        pose[0, 3] = move
        items = [hrbfnpr.Item(marks, style, line_set=lines), hrbfnpr.Item(marks, style, line_set=lines, transform=pose)]
        drawing = hrbfnpr.Renderer().draw(items, camera(model))
        return [line for i, layer in enumerate(drawing.layers) if layer.kind == "intersection"
                for line in drawing.polylines(i)]

    assert drawn(1.0) == []  # two linked rings do not touch
    crossing = drawn(0.5)
    assert crossing

    def off(p):
        return np.abs(np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1, p[:, 2]) - 0.4)

    places = np.concatenate([line["position"] for line in crossing])
    assert off(places).max() < 0.02
    there = np.stack([places[:, 0] - 0.5, places[:, 2], -places[:, 1]], axis=1)
    assert off(there).max() < 0.02
