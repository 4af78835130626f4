# SPDX-License-Identifier: MIT
"""Line sets and styles of lines."""
import pickle

import numpy as np
import pytest
from conftest import fibonacci_sphere, torus

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
    assert info.silhouette == 0  # marks draw no contours
    lines = drawing.polylines(drawing.layers.index(contour))
    assert len(lines) == contour.strokes
    for line in lines:
        steps = np.linalg.norm(np.diff(line["window"][:, :2], axis=0), axis=1)
        assert np.allclose(np.cumsum(steps), line["length"][1:], atol=0.05)
        ring = np.hypot(line["position"][:, 0], line["position"][:, 1])
        off = np.abs(np.hypot(ring - 1, line["position"][:, 2]) - 0.4)
        assert off.max() < 0.02  # world positions lie on the torus
    assert (drawing.image()[..., :3].min(axis=2) < 128).mean() > 0.005


def test_hidden_parts(model, marks):
    lines = hrbfnpr.LineSet(model)
    strokes = {}
    for hidden in ("none", "attenuated", "dashed", "shown"):
        style = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", hidden=hidden, shortest=0)])
        view = camera(model, (900, 700))
        drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), view)
        strokes[hidden] = drawing.info.strokes
    assert strokes["none"] < strokes["shown"] == strokes["attenuated"] < strokes["dashed"]


def test_tangles_are_counted(model, marks):
    steps = np.arange(6000)
    knot = np.stack([1.4 + 1e-4 * np.sin(steps), 1e-4 * np.cos(0.7 * steps), 1e-4 * np.sin(2.3 * steps)], axis=1)
    lines = hrbfnpr.LineSet(model, [hrbfnpr.Lines("own", "knot", polylines=[knot])])
    for kinds, tangled in ((["contour"], False), (["contour", "own"], True)):
        style = hrbfnpr.Style("silhouette", lines=kinds)
        view = hrbfnpr.Camera.fit(model, (-1, 0.2, 0.1), (0, 0, 1), size=(200, 160))
        drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), view)
        assert (drawing.info.line_tangles > 0) == tangled


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


def test_a_border_ends_an_open_surface():
    n = 12
    grid = np.stack(np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n)), -1).reshape(-1, 2)
    points = np.c_[grid, 0.2 * np.sin(3 * grid[:, 0])]
    normals = np.c_[-0.6 * np.cos(3 * grid[:, 0]), 0 * grid[:, 0], np.ones(len(grid))]
    sheet = hrbfnpr.Model.fit(points, normals)
    lines = hrbfnpr.LineSet(sheet)
    assert lines.info.borders == 1
    style = hrbfnpr.Style("silhouette", lines=["contour", "border"])
    view = hrbfnpr.Camera.fit(sheet, (0.2, 1, -1), (0, 0, 1), size=(200, 160))
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(sheet.generate(budget=500), style, line_set=lines), view)
    assert layers(drawing, "border")[0].strokes > 0


def test_several_items_hide_each_other(model, marks):
    ball = hrbfnpr.Model.fit(fibonacci_sphere(200), fibonacci_sphere(200))
    ball_marks, ball_lines, lines = ball.generate(budget=500), hrbfnpr.LineSet(ball), hrbfnpr.LineSet(model)
    style = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", hidden="none")])
    view = camera(model)

    def visible(place):
        shift = np.eye(4)
        shift[:3, 3] = place
        items = [hrbfnpr.Item(marks, style, line_set=lines), hrbfnpr.Item(ball_marks, style, shift, line_set=ball_lines)]
        drawing = hrbfnpr.Renderer().draw(items, view)
        assert drawing.info.line_contradictions == 0
        return layers(drawing, "contour")[1].strokes

    eye_ward = -np.array([0.3, 1, -0.7]) / np.linalg.norm([0.3, 1, -0.7])
    assert visible(2.5 * eye_ward) == 1  # whole, in front
    assert visible(-2.5 * eye_ward) > 1  # in parts, behind


def test_styles_of_lines():
    style = hrbfnpr.Style("xray")
    assert [line.kind for line in style.lines] == ["contour", "crease"]
    assert [line.hidden for line in style.lines] == ["dashed", "dashed"] and style.lines[1].creases == "all"
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


@pytest.mark.parametrize("law", ["outline_factor", "far_factor", "lit_factor", "curvature_factor"])
def test_laws_of_the_width(model, marks, law):
    lines, renderer, view = hrbfnpr.LineSet(model), hrbfnpr.Renderer(), camera(model, (600, 480))

    def draw(**fields):
        line = hrbfnpr.LineStyle("contour", width=4, taper=0, curvature_radius=0.5, **fields)
        style = hrbfnpr.Style("silhouette", lines=[line], light=(1, 0, 0))
        drawing = renderer.draw(hrbfnpr.Item(marks, style, line_set=lines), view)
        return np.concatenate([line["radius"] for line in contours(drawing)])

    assert getattr(hrbfnpr.LineStyle(), law) == 1 and np.all(draw() == 2)
    found = draw(**{law: 0.25})
    assert found.min() < 1.9 and 0.49 < found.min() and found.max() <= 2.001
    assert np.ptp(found) > 0.1


def test_an_unsteady_hand(model, marks):
    lines, renderer, view = hrbfnpr.LineSet(model), hrbfnpr.Renderer(), camera(model, (600, 480))

    def draw(**fields):
        style = hrbfnpr.Style("hatch", lines=[hrbfnpr.LineStyle("contour", **fields)])
        return renderer.draw(hrbfnpr.Item(marks, style, line_set=lines), view).image()

    straight, wobbling = draw(), draw(wobble=0.8, wobble_width=0.5)
    assert not np.array_equal(straight, wobbling)
    assert np.array_equal(wobbling, draw(wobble=0.8, wobble_width=0.5))
    assert not np.array_equal(wobbling, draw(wobble=0.8, wobble_width=0.5, wobble_seed=1))


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
        assert np.abs(picture - found[0][2]).max() < 40  # of 255, where a line moves by some hundredths of a pixel


def half_torus():
    a, b = np.meshgrid(np.linspace(0, np.pi, 20), np.linspace(0, 2 * np.pi, 14, endpoint=False))
    normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=-1).reshape(-1, 3)
    return np.stack([np.cos(a), np.sin(a), 0 * a], axis=-1).reshape(-1, 3) + 0.4 * normals, normals


def wave(count=400):
    x, y = np.random.default_rng(3).uniform(-1, 1, (2, count))
    normals = np.stack([-0.4 * np.cos(2 * x) * np.cos(3 * y), 0.6 * np.sin(2 * x) * np.sin(3 * y), 0 * x + 1], axis=-1)
    points = np.stack([x, y, 0.2 * np.sin(2 * x) * np.cos(3 * y)], axis=-1)
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)


@pytest.mark.parametrize("shape, support, borders", [(half_torus, 1.5, 2), (wave, 4.0, 1)])
def test_lines_end_where_the_samples_do(shape, support, borders):
    points, normals = shape()
    model = hrbfnpr.Model.fit(points, normals, trim="never")
    whole, lines = hrbfnpr.LineSet(model), hrbfnpr.LineSet(model, support=support)
    assert whole.info.left_out == 0 and 0 < lines.info.left_out < 0.5
    assert lines.info.borders == borders
    same = hrbfnpr.LineSet(model, support=support, support_points=points, support_normals=3 * normals)
    assert same.info.triangles == lines.info.triangles
    turned = hrbfnpr.LineSet(model, support=support, support_points=points)  # normals are the surface's own
    assert abs(turned.info.triangles - lines.info.triangles) < 0.02 * lines.info.triangles
    style = hrbfnpr.Style("silhouette", lines=["contour", hrbfnpr.LineStyle("border", hidden="shown")])
    marks = model.generate(budget=50)
    reach = 1.3 * model.info.spacing
    for towards in [(0.3, 1, -0.7), (1, 0.2, 0.1), (-0.4, 0.3, 1), (0.1, -1, -0.2)]:
        view = hrbfnpr.Camera.fit(model, towards, (0, 0.1, 1), size=(640, 480))
        drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), view)
        info = drawing.info
        assert info.line_broken == info.line_settled == info.line_contradictions == 0
        assert len(layers(drawing, "border")) == 1
        for layer in (k for k, layer in enumerate(drawing.layers) if layer.layer == -1):
            for line in drawing.polylines(layer):
                away = np.linalg.norm(line["position"][:, None] - points[None], axis=2).min(axis=1)
                assert away.max() < reach * (4 if shape is wave else 1)


def test_all_lines_end_there():
    points, normals = half_torus()
    model = hrbfnpr.Model.fit(points, normals)
    once = [hrbfnpr.Lines("section", levels=[0.1], shortest=0), "parabolic"]
    lines = hrbfnpr.LineSet(model, once, support=1.5, with_curvature=True)
    kinds = ["section", "parabolic", "suggestive_contour", "isophote"]
    style = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle(kind, hidden="shown") for kind in kinds])
    style.lines[-1].levels = [0.4]
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(model.generate(budget=50), style, line_set=lines), camera(model))
    for kind in ("section", "parabolic", "isophote"):
        assert sum(layer.strokes for layer in layers(drawing, kind)) > 0
    for k in range(len(drawing.layers)):
        for line in drawing.polylines(k):
            assert line["position"][:, 1].min() > -1.3 * model.info.spacing


def test_errors_name_the_argument(model, marks):
    lines = hrbfnpr.LineSet(model)
    style = hrbfnpr.Style("silhouette", lines=["suggestive_contour"])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="WITH_CURVATURE"):
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera(model))
    for fields in ({"lit_factor": -1}, {"far_factor": 17}, {"curvature_radius": 0}, {"wobble_width": 2}, {"wobble_length": 0}):
        (name,) = fields
        bad = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", **fields)])
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=rf"lines\[0\].{name}"):
            hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, bad, line_set=lines), camera(model))
    dark = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", lit_factor=0.5)], tone="none", light=(0, 0, 0))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="light is zero"):
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, dark, line_set=lines), camera(model))
    for once, text in (
        (hrbfnpr.Lines("contour"), r"lines\[0\].kind"),
        (hrbfnpr.Lines("section"), r"lines\[0\].levels"),
        (hrbfnpr.Lines("section", levels=[np.nan]), r"lines\[0\].levels\[0\]"),
        (hrbfnpr.Lines("ridge", lower=3, upper=1), r"lines\[0\].upper"),
        (hrbfnpr.Lines("section", levels=[0], plane=(0, 0, 0)), r"lines\[0\].plane"),
        (hrbfnpr.Lines("own"), r"lines\[0\].line_first"),
        (hrbfnpr.Lines("ridge", name="x" * 64), r"lines\[0\].name"),
    ):
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=text):
            hrbfnpr.LineSet(model, once)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="cell_size"):
        hrbfnpr.LineSet(model, cell_size=-1)
    for wrong, text in (
        ({"support": -1}, "support"),
        ({"support": np.nan}, "support"),
        ({"support_points": [[0, 0, np.inf]]}, r"support_points\[0\]"),
        ({"support_points": [[0, 0, 1]], "support_normals": [[0, 0, 1], [0, 0, 1]]}, "support_normals has 2"),
        ({"support_points": [[0, 0, 1]], "support_normals": [[0, 0, 0]]}, r"support_normals\[0\] is 0"),
    ):
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=text):
            hrbfnpr.LineSet(model, **wrong)
    with pytest.raises(hrbfnpr.NotConvergedError, match="larger support"):
        hrbfnpr.LineSet(model, support=1.5, support_points=[[9, 9, 9]], support_normals=[[0, 0, 1]])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="larger side"):
        hrbfnpr.LineSet(model, cell_size=1e-4)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="levels"):
        bad = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("isophote", levels=[2])])
        curved = hrbfnpr.LineSet(model, with_curvature=True)
        hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, bad, line_set=curved), camera(model))


def test_cancelling(model):
    def stop(fraction):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hrbfnpr.LineSet(model, progress=stop)


def ball(count=300):
    i = np.arange(count) + 0.5
    z, a = 1 - 2 * i / count, 2.399963229728653 * i
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(a), r * np.sin(a), z], axis=-1)


def placed(to, scale=1.0):
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = to
    return matrix


def test_which_item_hides_a_line():
    points = ball()
    model = hrbfnpr.Model.fit(points, points)
    lines, marks = hrbfnpr.LineSet(model), model.generate(budget=20)
    style = hrbfnpr.Style("silhouette", lines=[hrbfnpr.LineStyle("contour", hidden="dashed")])
    nothing = hrbfnpr.Item(marks, style)  # without a line set: numbers are those of items
    # From the eye at x = -9: a small ball before a large one that is run through by a third.
    items = [
        nothing,
        hrbfnpr.Item(marks, style, transform=placed((3, 0, 0)), line_set=lines),
        hrbfnpr.Item(marks, style, transform=placed((0, 0.9, 0), 0.5), line_set=lines),
        hrbfnpr.Item(marks, style, transform=placed((3, -0.9, 0), 0.7), line_set=lines),
    ]
    camera = hrbfnpr.Camera.look_at((-9, 0, 0), (0, 0, 0), (0, 0, 1)).perspective(0.5, (600, 600), 1, 20)
    drawing = hrbfnpr.Renderer().draw(items, camera)
    info = drawing.info
    assert info.line_broken == info.line_settled == info.line_contradictions == 0
    hidden_by = {}
    for number, layer in enumerate(drawing.layers):
        for line in drawing.polylines(number):
            layers, by = set(line["hidden_layers"].tolist()), set(line["hidden_by"].tolist())
            assert len(layers) == len(by) == 1
            hidden_by.setdefault(layer.item, set()).add((*layers, *by))
    none = 0xFFFFFFFF
    assert hidden_by == {
        1: {(0, none), (1, 2), (1, 3)},
        2: {(0, none)},
        3: {(0, none), (1, 1)},
    }
    points = drawing.vertices("points", ("hidden_by", "hidden_layers"))[0]
    assert (points["hidden_by"] == none).all() and (points["hidden_layers"] == 0).all()


def test_pictures_of_lines_alone_place_few_marks(tmp_path, capsys):
    ring = tmp_path / "ring.xyz"
    np.savetxt(ring, np.hstack(torus()), fmt="%.17g")
    draw = ["draw", str(ring), str(tmp_path / "out.png"), "--style", "silhouette", "--size", "200"]
    assert main(draw) == 0 and "4000 marks" in capsys.readouterr().out
    # What is saved may be drawn in another style.
    assert main([*draw, "--save-points", str(tmp_path / "ring.points")]) == 0
    assert len(hrbfnpr.PointSet.load(tmp_path / "ring.points")) > 20000
