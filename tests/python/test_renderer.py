# SPDX-License-Identifier: MIT
"""Renderers and the results of drawings: pixels, outputs and vertices."""
import io

import numpy as np
import pytest

import hrbfnpr

STYLE = hrbfnpr.Style("contour-and-stipple")


@pytest.fixture(scope="module")
def renderer():
    return hrbfnpr.Renderer()


def test_a_picture(renderer, marks, camera):
    drawing = renderer.draw((marks, STYLE), camera)
    image = drawing.image()
    assert image.shape == (120, 160, 4) and image.dtype == np.uint8
    assert (image[0, 0] == 255).all()  # paper in the corner
    dark = image[..., :3].mean(axis=2) < 128
    assert 200 < dark.sum() < 15000
    info = drawing.info
    assert info.marks == info.outside + info.front + info.back + info.silhouette + info.culled > 2000
    assert info.shown > 0
    np.testing.assert_array_equal(renderer.draw((marks, STYLE), camera).image(), image)


def test_items_can_be_given_in_many_forms(renderer, marks, camera):
    wanted = renderer.draw([(marks, STYLE)], camera).image()
    item = hrbfnpr.Item(marks, STYLE, np.eye(4))
    for items in (item, [item], [(marks, STYLE)], ((marks, STYLE),)):
        np.testing.assert_array_equal(renderer.draw(items, camera).image(), wanted)
    assert (renderer.draw(marks, camera).image() != 255).any()
    assert (renderer.draw([], camera).image() == 255).all()
    moved = np.eye(4)
    moved[0, 3] = 100  # a translation is in the last column
    assert (renderer.draw(hrbfnpr.Item(marks, STYLE, moved), camera).image() == 255).all()


def test_the_callers_array_is_drawn_into(renderer, marks, camera):
    drawing = renderer.draw((marks, STYLE), camera)
    wanted = drawing.image()
    canvas = np.full((130, 200, 4), 9, dtype=np.uint8)
    window = canvas[5:125, 30:190]
    assert drawing.image(out=window) is window
    np.testing.assert_array_equal(window, wanted)
    canvas[5:125, 30:190] = 9
    assert (canvas == 9).all()
    upside_down = np.zeros((120, 160, 4), dtype=np.uint8)
    drawing.image(160, 120, out=upside_down[::-1])
    np.testing.assert_array_equal(upside_down[::-1], wanted)
    raw = bytearray(120 * 160 * 4)
    drawing.image(out=memoryview(raw).cast("B", shape=[120, 160, 4]))
    assert bytes(raw) == wanted.tobytes()


def test_formats_and_size(renderer, marks, camera):
    ink = STYLE.copy(ink="#ff0000")
    drawing = renderer.draw((marks, ink), camera)
    rgba = drawing.image()
    bgra = drawing.image(format="bgra8")
    np.testing.assert_array_equal(rgba, bgra[..., [2, 1, 0, 3]])
    assert drawing.image(300, 200).shape == (200, 300, 4) and drawing.size == (160, 120)
    clear = STYLE.copy(paper=(1, 1, 1, 0))
    straight = renderer.draw((marks, clear), camera).image()
    assert straight[0, 0, 3] == 0 and straight[..., 3].max() == 255


def test_a_picture_is_drawn_over_another(renderer, marks, camera):
    clear = STYLE.copy(paper=(1, 1, 1, 0))
    canvas = np.full((120, 160, 4), (10, 200, 30, 255), dtype=np.uint8)
    renderer.draw((marks, clear), camera).image(out=canvas, over=True)
    assert (canvas[0, 0] == (10, 200, 30, 255)).all() and (canvas != (10, 200, 30, 255)).any()


class Spy:
    """The library with one function replaced by one that records its arguments."""

    def __init__(self, name, look):
        self._lib = hrbfnpr._library.lib
        self.seen = []
        setattr(self, name, lambda *arguments: self.seen.append(look(*arguments)) or 0)

    def __getattr__(self, name):
        return getattr(self._lib, name)


def test_flags_of_an_image(renderer, marks, camera, monkeypatch):
    spy = Spy("hrbfnpr_drawing_rasterize", lambda drawing, image, desc, error: desc.flags)
    drawing = renderer.draw((marks, STYLE), camera)
    monkeypatch.setattr(hrbfnpr._drawing, "lib", spy)
    for options in ({}, {"over": True}, {"linear_light": True}, {"over": True, "linear_light": True}):
        drawing.image(**options)
    assert spy.seen == [0, 1, 2, 3]


def test_the_model_of_an_item(renderer, marks, camera, ring, monkeypatch):
    image = renderer.draw(hrbfnpr.Item(marks, STYLE, model=ring), camera).image()
    assert (image != 255).any() and hrbfnpr.Item(marks).model is None
    with pytest.raises(ValueError, match="closed"):
        closed = hrbfnpr.Model.load(ring.to_bytes())
        closed.close()
        renderer.draw(hrbfnpr.Item(marks, STYLE, model=closed), camera)
    draw = "hrbfnpr_renderer_draw_with_operation"
    spy = Spy(draw, lambda renderer, items, count, *_: [items[i].model for i in range(count)])
    monkeypatch.setattr(hrbfnpr._renderer, "lib", spy)
    renderer.draw([hrbfnpr.Item(marks, model=ring), marks], camera)
    assert spy.seen == [[ring._handle, hrbfnpr._renderer.ffi.NULL]]


def test_outputs(renderer, marks, camera):
    drawing = renderer.draw((marks, STYLE), camera)
    image, depth, id, class_ = drawing.raster()
    np.testing.assert_array_equal(image, drawing.image())
    assert depth.shape == id.shape == class_.shape == (120, 160)
    drawn = id > 0
    assert drawn.any() and depth[0, 0] == 1 and id.max() <= drawing.info.marks
    assert set(np.unique(class_)) <= set(hrbfnpr.CLASSES.values())
    assert (class_[drawn] > 0).all()
    hidden = drawing.image(host_depth=np.zeros((120, 160), dtype=np.float32))
    assert (hidden == 255).all()
    mine = np.full((120, 160), 77, dtype=np.uint32)
    classes = np.zeros((120, 160, 2), dtype=np.uint8)
    wide = np.zeros((120, 160), dtype=np.uint32)
    drawing.image(id=mine, class_=classes[..., 1])
    drawing.image(class_=wide)
    np.testing.assert_array_equal(mine, id)
    np.testing.assert_array_equal(classes[..., 1], class_)
    np.testing.assert_array_equal(wide, class_)
    larger = drawing.raster(200, 150, id=False, format="coverage8")
    assert larger.id is None and larger.depth.shape == larger.image.shape == (150, 200)
    np.testing.assert_array_equal(larger.depth[:120, :160], depth)


@pytest.mark.parametrize(
    "size, options, kind, words",
    [
        ((0, 10), {}, ValueError, "size"),
        ((10,), {}, TypeError, "both width and height"),
        ((), {"out": np.zeros((10, 10, 3), np.uint8)}, ValueError, "out must be"),
        ((), {"out": np.zeros((10, 10, 4))}, ValueError, "out must be"),
        ((), {"out": np.zeros((10, 10, 4), np.uint8), "format": "rgba32f"}, ValueError, "out must be a float32"),
        ((), {"out": np.zeros((10, 10, 4), np.uint8), "format": "coverage8"}, ValueError, "out must be.*height, width\\)"),
        ((), {"out": np.zeros((10, 20), np.uint8)[:, ::2], "format": "coverage8"}, ValueError, "side by side"),
        ((), {"out": np.zeros((10, 10, 8), np.uint8)[..., ::2]}, ValueError, "out must be"),
        ((), {"out": np.frombuffer(bytes(400), np.uint8).reshape(10, 10, 4)}, ValueError, "writable"),
        ((11, 10), {"out": np.zeros((10, 10, 4), np.uint8)}, ValueError, "size asked for"),
        ((), {"format": "cmyk"}, ValueError, "format"),
        ((), {"depth": np.zeros((3, 3), np.float32)}, ValueError, "depth"),
        ((), {"id": np.zeros((120, 160), np.int32)}, TypeError, "id"),
        ((), {"host_depth": np.zeros((3, 3), np.float32)}, ValueError, "host_depth"),
        ((40000, 10), {}, hrbfnpr.InvalidArgumentError, "width"),
    ],
)
def test_bad_pictures(renderer, marks, camera, size, options, kind, words):
    with pytest.raises(kind, match=words):
        renderer.draw((marks, STYLE), camera).image(*size, **options)


def test_bad_frames(renderer, marks, camera):
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="viewport"):
        renderer.draw(marks, hrbfnpr.Camera())
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="transform"):
        renderer.draw(hrbfnpr.Item(marks, None, np.zeros((4, 4))), camera)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="paper"):
        renderer.draw([(marks, STYLE), (marks, STYLE.copy(paper="#000000"))], camera)
    for name, value in {"tone_exponent": -1, "tone_fade": 1.5, "fill_light": 2, "silhouette_radius": -1}.items():
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=name):
            renderer.draw((marks, STYLE.copy(**{name: value})), camera)
    with pytest.raises(ValueError, match="closed"):
        closed = hrbfnpr.PointSet.load(marks.to_bytes())
        closed.close()
        renderer.draw(closed, camera)


def test_tone_function(renderer, marks, camera):
    seen = []

    def tone(positions, normals):
        seen.append((positions.copy(), normals.copy()))
        return np.ones(len(positions)) if light else [0.0] * len(positions)

    light = True
    only_stipples = hrbfnpr.Style("stipple", tone=tone, tone_curve="linear", tone_fade=0.0)
    bright = renderer.draw((marks, only_stipples), camera).info
    positions, normals = seen[0]
    assert positions.shape == normals.shape and positions.dtype == np.float32
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-4)
    light = False
    dark = renderer.draw((marks, only_stipples), camera).info
    assert bright.shown == 0 and dark.shown == dark.front > 100
    # A column of a wider array works, too.
    strided = only_stipples.copy(tone=lambda p, n: np.zeros((len(p), 3), dtype=np.float32)[:, 1])
    assert renderer.draw((marks, strided), camera).info.shown == dark.shown


@pytest.mark.parametrize(
    "tone, words",
    [
        (lambda p, n: 1 / 0, "ZeroDivisionError"),
        (lambda p, n: [0.5], "elements"),
        (lambda p, n: None, "numbers"),
    ],
)
def test_a_tone_function_that_fails(renderer, marks, camera, tone, words):
    with pytest.raises(hrbfnpr.CallbackError, match=words) as caught:
        renderer.draw((marks, hrbfnpr.Style("stipple", tone=tone, tone_curve="linear", tone_fade=0.0)), camera)
    assert caught.value.__cause__ is not None
    with pytest.raises(hrbfnpr.CallbackError):
        renderer.draw((marks, hrbfnpr.Style("stipple", tone=lambda p, n: np.full(len(p), np.nan))), camera)


@pytest.mark.parametrize("visibility", ["depth_layers", "published"])
def test_vertices(renderer, marks, camera, visibility):
    style = hrbfnpr.Style("contour-and-stipple", visibility=visibility)
    names = ("position", "window", "radius", "color", "normal", "direction", "id", "class", "is_paper",
             "layer", "length")
    drawing = renderer.draw((marks, style), camera)
    vertices, indices = drawing.vertices("points", names)
    np.testing.assert_array_equal(indices, np.arange(len(vertices)))
    assert vertices.dtype.names == names and len(vertices) > 100
    assert vertices["color"].dtype == np.uint8 and vertices["color"].shape == (len(vertices), 4)
    assert set(np.unique(vertices["is_paper"])) <= {0, 1}
    depth = vertices["window"][:, 2]
    assert np.ptp(depth) > 0 and depth[0] > depth[-1]
    np.testing.assert_allclose(np.linalg.norm(vertices["normal"], axis=1), 1, atol=1e-4)
    info = drawing.info
    assert (vertices["is_paper"] == 0).sum() == info.shown
    assert (vertices["is_paper"] == 1).sum() == (info.splats if visibility == "published" else 0)
    for i in (0, len(vertices) // 2, -1):
        clip = camera.projection @ camera.view @ np.append(vertices["position"][i], 1)
        x = (clip[0] / clip[3] + 1) / 2 * 160
        y = (1 - clip[1] / clip[3]) / 2 * 120
        np.testing.assert_allclose(vertices["window"][i, :2], (x, y), atol=0.01)
    assert (vertices["length"] == 0).all() and vertices["layer"].max() < info.layers
    drawing = renderer.draw((marks, STYLE), camera)
    default = drawing.vertices().vertices
    assert default.dtype.itemsize == 24 and (default["radius"] > 0).all()
    with pytest.raises(ValueError, match="attributes"):
        drawing.vertices("points", ("colour",))
    with pytest.raises(ValueError, match="attributes"):
        drawing.vertices("points", ())
    with pytest.raises(ValueError, match="primitive"):
        drawing.vertices("lines")


def test_drawings_save_themselves(renderer, marks, camera, tmp_path):
    image_module = pytest.importorskip("PIL.Image")
    drawing = renderer.draw((marks, STYLE), camera)
    assert drawing._repr_png_().startswith(b"\x89PNG")
    back = np.asarray(image_module.open(io.BytesIO(drawing.to_png())))
    np.testing.assert_array_equal(back, drawing.image())
    drawing.save(tmp_path / "a.png")
    drawing.save(str(tmp_path / "b"))
    drawing.save(tmp_path / "c.jpg")
    assert image_module.open(tmp_path / "b").format == "PNG" and image_module.open(tmp_path / "c.jpg").format == "JPEG"
    with pytest.raises(ValueError, match=".xyz"):
        drawing.save(tmp_path / "d.xyz")
    with pytest.raises(FileNotFoundError):
        drawing.save(tmp_path / "no" / "a.png")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.png", "b", "c.jpg"]


def test_frames_can_be_cancelled_and_report_progress(marks, camera):
    renderer = hrbfnpr.Renderer()
    wanted = renderer.draw(marks, camera).image()
    seen = []
    renderer.draw(marks, camera, progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1.0
    operation = hrbfnpr.Operation(lambda fraction: operation.cancel())
    with pytest.raises(hrbfnpr.CancelledError):
        renderer.draw(marks, camera, operation=operation)

    def fail(fraction):
        raise KeyError("of the program's")

    with pytest.raises(hrbfnpr.CallbackError, match="of the program's"):
        renderer.draw(marks, camera, progress=fail)
    np.testing.assert_array_equal(renderer.draw(marks, camera).image(), wanted)
