# SPDX-License-Identifier: MIT
"""Cameras and styles."""
import copy
import math
import pickle
import sys

import numpy as np
import pytest
from conftest import ROOT

import hrbfnpr

sys.path.append(str(ROOT / "bindings"))
import presets  # noqa: E402

BOX = ((-1, -2, -3), (1, 2, 3))


def project(camera, point):
    """Window x, y and clip w of a world point, by the camera's matrices."""
    clip = camera.projection @ camera.view @ np.append(point, 1.0)
    x, y, width, height = camera.viewport
    return x + (clip[0] / clip[3] + 1) / 2 * width, y + (1 - clip[1] / clip[3]) / 2 * height, clip[3]


def test_look_at_and_perspective():
    camera = hrbfnpr.Camera.look_at((0, 0, 5), (0, 0, 0)).perspective(math.radians(90), (200, 100), 0.1, 10)
    np.testing.assert_allclose(camera.view @ [0, 0, 5, 1], [0, 0, 0, 1], atol=1e-12)
    np.testing.assert_allclose(project(camera, (0, 0, 0)), (100, 50, 5))
    np.testing.assert_allclose(project(camera, (5, 5, 0))[:2], (150, 0), atol=1e-9)
    assert camera.size == (200, 100) and camera.viewport == (0, 0, 200, 100)
    assert camera.view.shape == (4, 4) and "200x100" in repr(camera)


def test_cameras_compare_by_value(ring):
    bare = hrbfnpr.Camera.look_at((0, 0, 5), (0, 0, 0))
    camera = bare.perspective(1.0, (20, 10), 0.1, 10)
    assert bare != camera and bare.size == (0, 0)
    same = hrbfnpr.Camera(camera.view, camera.projection, camera.viewport, camera.depth_convention)
    assert same == camera and hash(same) == hash(camera) and camera != 3
    for other in (pickle.loads(pickle.dumps(camera)), copy.copy(camera), copy.deepcopy(camera)):
        assert other == camera
    assert hrbfnpr.Camera(camera.view.T.copy().T, camera.projection.tolist(), camera.viewport) == camera
    assert hrbfnpr.Camera.fit(ring) == hrbfnpr.Camera.fit(ring.bounds)
    assert hrbfnpr.Camera(depth_convention="reversed").depth_convention == "reversed"


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda: hrbfnpr.Camera.look_at((0, 1, 0), (0, 0, 0)), "up"),
        (lambda: hrbfnpr.Camera.look_at((0, 1), (0, 0, 0)), "eye must be 3 numbers"),
        (lambda: hrbfnpr.Camera().perspective(4.0, (1, 1), 0.1, 1), "vertical_angle"),
        (lambda: hrbfnpr.Camera.fit(BOX, margin=0.5), "margin"),
        (lambda: hrbfnpr.Camera(view=np.eye(3)), "view must be a 4 x 4 matrix"),
        (lambda: hrbfnpr.Camera(depth_convention="odd"), "depth_convention"),
    ],
)
def test_bad_cameras(make, words):
    with pytest.raises(ValueError, match=words):
        make()


def test_presets():
    assert hrbfnpr.PRESETS == tuple(preset.name for preset in presets.PRESETS)
    for name in hrbfnpr.PRESETS:
        style = hrbfnpr.Style(name)
        assert style.preset == name and style.layers and hrbfnpr.preset_layers(name)
        assert style == hrbfnpr.Style(name)
    for name in ("hatch", "cross-hatch", "combing", "full"):
        guide = "combing" if name == "combing" else "curvature"
        published = hrbfnpr.preset_layers(name, "published")
        assert published == [hrbfnpr.Layer("stipples"), hrbfnpr.Layer("hatch", guide=guide)]
        assert hrbfnpr.Style(name).style_of("hatch").shown
    assert hrbfnpr.Style().preset is None and hrbfnpr.Style().tone == "light"
    with pytest.raises(ValueError, match="preset must be one of 'stipple'"):
        hrbfnpr.Style("watercolour")


def test_every_field_can_be_read_and_written():
    style = hrbfnpr.Style()
    for name in style.fields():
        value = getattr(style, name)
        setattr(style, name, value)
        assert getattr(style, name) == value, name
    for name in ("silhouette_threshold", "tone_exponent", "halo_width", "zoom_reference"):
        setattr(style, name, 0.75)
        assert getattr(style, name) == 0.75
    for name, numbers in {
        "visibility": {"depth_layers": 0, "published": 1},
        "tone_curve": {"coverage": 0, "linear": 1},
        "tone_rule": {"share": 0, "published": 1},
    }.items():
        assert name in style.fields() and getattr(style, name) == next(iter(numbers))
        for choice, number in numbers.items():
            setattr(style, name, choice)
            assert getattr(style, name) == choice and getattr(style._prepared()[0], name) == number
    style.hidden_lines = "hide"
    style.light = (1, 2, 3)
    style.paper = "#ff000080"
    assert (style.hidden_lines, style.light) == ("hide", (1, 2, 3))
    np.testing.assert_allclose(style.paper, (1, 0, 0, 128 / 255), atol=1e-6)


def test_layers_of_a_style():
    style = hrbfnpr.Style("hatch", own={"radius": 2.5, "ink": (0.1, 0.2, 0.3)}, tone_exponent=3)
    assert style.layer("own").radius == 2.5 and style.tone_exponent == 3
    np.testing.assert_allclose(style.layer("own").ink, (0.1, 0.2, 0.3, 1), atol=1e-6)
    layer = style.layer("stipples")
    layer.shown, layer.share, layer.directions = True, 0.5, "first"
    assert style.layers[0] is layer and "share=0.5" in repr(layer) and layer.directions == ("first",)
    del style
    assert layer.share == 0.5
    style = hrbfnpr.Style(ink="#102030")
    assert style.style_of("stipples").ink == style.silhouette_ink == style.style_of("own", "fur").ink
    # Presets of the library do not change.
    hrbfnpr.Style("hatch").layers[0].radius = 9
    assert hrbfnpr.Style("hatch").layers[0].radius != 9


def test_a_layer_takes_the_first_matching_style():
    style = hrbfnpr.Style()
    assert style.layers == [] and style.style_of("hatch") == hrbfnpr.LayerStyle("hatch")
    style.layers = [hrbfnpr.LayerStyle(name="fur", radius=2), hrbfnpr.LayerStyle(shape="strokes", radius=3)]
    assert style.style_of("own", "fur").radius == 2 and style.style_of("stipples", "grass").radius == 3
    lines = style.layer("hatch")  # a style for hatch, before those that match any layer
    lines.radius = 4
    assert [layer.kind for layer in style.layers] == ["any", "hatch", "any"] and lines.shape == "strokes"
    assert style.style_of("hatch").radius == 4 and style.style_of("stipples").radius == 3
    assert style.layer("hatch") is lines and style.layer("any") is style.layers[2]
    assert style.layer("fur") is style.layers[0]
    grass = style.layer("grass")
    assert style.layers[0] is grass and (grass.kind, grass.name, grass.radius) == ("any", "grass", 3)
    assert pickle.loads(pickle.dumps(grass)) == grass and grass.copy(radius=1).radius == 1
    struct, _, keep = style._prepared()
    assert struct.layer_count == 4 and hrbfnpr._style.ffi.string(struct.layers[0].name) == b"grass"
    assert struct.layers[2].name == hrbfnpr._style.ffi.NULL


@pytest.mark.parametrize(
    "change, kind",
    [
        (lambda s: setattr(s, "halo", 3), AttributeError),
        (lambda s: setattr(s.layer("stipples"), "colour", "#000000"), AttributeError),
        (lambda s: setattr(s.layer("stipples"), "shape", "round"), ValueError),
        (lambda s: setattr(s.layer("stipples"), "directions", ["third"]), ValueError),
        (lambda s: hrbfnpr.LayerStyle("dots"), ValueError),
        (lambda s: setattr(s, "layers", ["stipples"]), TypeError),
        (lambda s: setattr(s, "paper", "white"), ValueError),
        (lambda s: setattr(s, "paper", (1, 1)), ValueError),
        (lambda s: setattr(s, "light", (1, 1)), ValueError),
        (lambda s: setattr(s, "tone", "callback"), ValueError),
        (lambda s: setattr(s, "tone_rule", "none"), ValueError),
        (lambda s: setattr(s, "tone_fade", "slow"), ValueError),
        (lambda s: setattr(s, "silhouette_radius", None), TypeError),
        (lambda s: setattr(s, "halo_width", "wide"), ValueError),
        (lambda s: s.update(halo=3), TypeError),
        (lambda s: hrbfnpr.Style("stipple", hallo=3), TypeError),
        (lambda s: s.update(stipples={"colour": 3}), AttributeError),
    ],
)
def test_bad_styles(change, kind):
    with pytest.raises(kind):
        change(hrbfnpr.Style())


def tone(positions, normals):
    return np.zeros(len(positions))


def test_styles_can_be_copied():
    style = hrbfnpr.Style("full", halo_width=7, visibility="published", stipples={"radius": 3}, tone=tone)
    others = [copy.copy(style), copy.deepcopy(style), pickle.loads(pickle.dumps(style)), style.copy()]
    for other in others:
        assert other == style and other is not style
        other.halo_width = 1
        assert style.halo_width == 7 and other != style
        assert other.layers == style.layers and other.tone is tone
        other.layers[0].radius = 5
        assert style.layers[0].radius == 3
    assert style.copy(halo_width=2).halo_width == 2
    assert "halo_width=7.0" in repr(style) and repr(style).startswith("Style('full'")


def test_fit_points_fills_the_picture_with_the_points_themselves():
    points = np.array([[0, 0, 0], [1, 0.2, 0], [0.3, 0.5, 0.4]], dtype=np.float32)
    camera = hrbfnpr.Camera.fit_points(points, (0, 0, -1), origin=(10, 20, 30), size=(200, 100), margin=0.1)
    clip = np.column_stack([points + [10, 20, 30], np.ones(3)]) @ (camera.projection @ camera.view).T
    assert np.abs(clip[:, :2]).max() == pytest.approx(0.8)
    assert clip[:, :2].min(axis=0) == pytest.approx(-clip[:, :2].max(axis=0))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="points is empty"):
        hrbfnpr.Camera.fit_points(np.empty((0, 3)))
