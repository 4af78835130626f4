"""Renderers: pixels, outputs, vertices."""
import io
import threading

import numpy as np
import pytest

import hrbfnpr

STYLE = hrbfnpr.Style("contour-and-stipple")


@pytest.fixture(scope="module")
def renderer():
    return hrbfnpr.Renderer()


def test_a_picture(renderer, marks, camera):
    image = renderer.draw((marks, STYLE), camera)
    assert image.shape == (120, 160, 4) and image.dtype == np.uint8
    assert (image[0, 0] == 255).all()  # paper in the corner
    dark = image[..., :3].mean(axis=2) < 128
    assert 200 < dark.sum() < 15000
    info = renderer.info
    assert info.marks == info.outside + info.front + info.back + info.silhouette + info.culled > 2000
    assert info.shown > 0
    np.testing.assert_array_equal(renderer.draw((marks, STYLE), camera), image)


def test_what_can_be_drawn(renderer, marks, camera):
    wanted = renderer.draw([(marks, STYLE)], camera)
    item = hrbfnpr.Item(marks, STYLE, np.eye(4))
    for items in (item, [item], [(marks, STYLE)], ((marks, STYLE),)):
        np.testing.assert_array_equal(renderer.draw(items, camera), wanted)
    assert (renderer.draw(marks, camera) != 255).any()
    assert (renderer.draw([], camera) == 255).all()
    moved = np.eye(4)
    moved[0, 3] = 100  # a translation is in the last column
    assert (renderer.draw(hrbfnpr.Item(marks, STYLE, moved), camera) == 255).all()


def test_draws_into_the_callers_image(renderer, marks, camera):
    wanted = renderer.draw((marks, STYLE), camera)
    canvas = np.full((130, 200, 4), 9, dtype=np.uint8)
    window = canvas[5:125, 30:190]
    assert renderer.draw((marks, STYLE), camera, out=window) is window
    np.testing.assert_array_equal(window, wanted)
    canvas[5:125, 30:190] = 9
    assert (canvas == 9).all()
    upside_down = np.zeros((120, 160, 4), dtype=np.uint8)
    renderer.draw((marks, STYLE), camera, out=upside_down[::-1])
    np.testing.assert_array_equal(upside_down[::-1], wanted)
    raw = bytearray(120 * 160 * 4)
    renderer.draw((marks, STYLE), camera, out=memoryview(raw).cast("B", shape=[120, 160, 4]))
    assert bytes(raw) == wanted.tobytes()


def test_formats_and_size(renderer, marks, camera):
    ink = STYLE.copy(ink="#ff0000")
    rgba = renderer.draw((marks, ink), camera)
    bgra = renderer.draw((marks, ink), camera, format="bgra8")
    np.testing.assert_array_equal(rgba, bgra[..., [2, 1, 0, 3]])
    assert renderer.draw((marks, ink), camera, size=(300, 200)).shape == (200, 300, 4)
    clear = STYLE.copy(paper=(1, 1, 1, 0))
    straight = renderer.draw((marks, clear), camera)
    assert straight[0, 0, 3] == 0 and straight[..., 3].max() == 255


def test_over(renderer, marks, camera):
    clear = STYLE.copy(paper=(1, 1, 1, 0))
    canvas = np.full((120, 160, 4), (10, 200, 30, 255), dtype=np.uint8)
    renderer.draw((marks, clear), camera, out=canvas, over=True)
    assert (canvas[0, 0] == (10, 200, 30, 255)).all() and (canvas != (10, 200, 30, 255)).any()


class Spy:
    """The library with one function that only says what it was called with."""

    def __init__(self, name, look):
        self._lib = hrbfnpr._renderer.lib
        self.seen = []
        setattr(self, name, lambda *arguments: self.seen.append(look(*arguments)) or 0)

    def __getattr__(self, name):
        return getattr(self._lib, name)


def test_flags_of_a_drawing(renderer, marks, camera, monkeypatch):
    spy = Spy("hrbfnpr_renderer_draw_image", lambda renderer, image, desc, error: desc.flags)
    monkeypatch.setattr(hrbfnpr._renderer, "lib", spy)
    for options in ({}, {"over": True}, {"linear_light": True}, {"over": True, "linear_light": True}):
        renderer.draw((marks, STYLE), camera, **options)
    assert spy.seen == [0, 1, 2, 3]


def test_the_model_of_an_item(renderer, marks, camera, ring, monkeypatch):
    image = renderer.draw(hrbfnpr.Item(marks, STYLE, model=ring), camera)
    assert (image != 255).any() and hrbfnpr.Item(marks).model is None
    with pytest.raises(ValueError, match="closed"):
        closed = hrbfnpr.Model.load(ring.to_bytes())
        closed.close()
        renderer.prepare(hrbfnpr.Item(marks, STYLE, model=closed), camera)
    spy = Spy("hrbfnpr_renderer_prepare", lambda renderer, items, count, *_: [items[i].model for i in range(count)])
    monkeypatch.setattr(hrbfnpr._renderer, "lib", spy)
    renderer.prepare([hrbfnpr.Item(marks, model=ring), marks], camera)
    assert spy.seen == [[ring._handle, hrbfnpr._renderer.ffi.NULL]]


def test_outputs(renderer, marks, camera):
    drawing = renderer.drawing((marks, STYLE), camera, depth=True, id=True, class_=True)
    assert drawing.depth.shape == drawing.id.shape == drawing.class_.shape == (120, 160)
    drawn = drawing.id > 0
    assert drawn.any() and (drawing.depth[0, 0] == 1) and drawing.id.max() <= drawing.info.marks
    assert set(np.unique(drawing.class_)) <= set(hrbfnpr.CLASSES.values())
    assert (drawing.class_[drawn] > 0).all()
    hidden = renderer.draw((marks, STYLE), camera, host_depth=np.zeros((120, 160), dtype=np.float32))
    assert (hidden == 255).all()
    mine = np.full((120, 160), 77, dtype=np.uint32)
    classes = np.zeros((120, 160, 2), dtype=np.uint8)
    renderer.draw((marks, STYLE), camera, id=mine, class_=classes[..., 1])
    np.testing.assert_array_equal(mine, drawing.id)


@pytest.mark.parametrize(
    "options, kind, words",
    [
        ({"size": (0, 10)}, ValueError, "size"),
        ({"out": np.zeros((10, 10, 3), np.uint8)}, ValueError, "out must be"),
        ({"out": np.zeros((10, 10, 4))}, ValueError, "out must be"),
        ({"out": np.zeros((10, 10, 8), np.uint8)[..., ::2]}, ValueError, "out must be"),
        ({"out": np.frombuffer(bytes(400), np.uint8).reshape(10, 10, 4)}, ValueError, "writable"),
        ({"out": np.zeros((10, 10, 4), np.uint8), "size": (11, 10)}, ValueError, "size asks for"),
        ({"format": "cmyk"}, ValueError, "format"),
        ({"depth": np.zeros((3, 3), np.float32)}, ValueError, "depth"),
        ({"id": np.zeros((120, 160), np.int32)}, TypeError, "id"),
        ({"host_depth": np.zeros((3, 3), np.float32)}, ValueError, "host_depth"),
        ({"size": (40000, 10)}, hrbfnpr.InvalidArgumentError, "width"),
    ],
)
def test_bad_pictures(renderer, marks, camera, options, kind, words):
    with pytest.raises(kind, match=words):
        renderer.draw((marks, STYLE), camera, **options)


def test_bad_frames(renderer, marks, camera):
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="viewport"):
        renderer.prepare(marks, hrbfnpr.Camera())
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="transform"):
        renderer.prepare(hrbfnpr.Item(marks, None, np.zeros((4, 4))), camera)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="paper"):
        renderer.prepare([(marks, STYLE), (marks, STYLE.copy(paper="#000000"))], camera)
    for name, value in {"tone_exponent": -1, "tone_fade": 1.5, "silhouette_width": -1}.items():
        with pytest.raises(hrbfnpr.InvalidArgumentError, match=name):
            renderer.prepare((marks, STYLE.copy(**{name: value})), camera)
    with pytest.raises(ValueError, match="closed"):
        closed = hrbfnpr.PointSet.load(marks.to_bytes())
        closed.close()
        renderer.prepare(closed, camera)


def test_tone_function(renderer, marks, camera):
    seen = []

    def tone(positions, normals):
        seen.append((positions.copy(), normals.copy()))
        return np.ones(len(positions)) if light else [0.0] * len(positions)

    light = True
    only_stipples = hrbfnpr.Style("stipple", tone=tone, tone_curve="linear", tone_fade=0.0)
    bright = renderer.prepare((marks, only_stipples), camera)
    positions, normals = seen[0]
    assert positions.shape == normals.shape and positions.dtype == np.float32
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-4)
    light = False
    dark = renderer.prepare((marks, only_stipples), camera)
    assert bright.shown == 0 and dark.shown == dark.front > 100
    # A column of a wider array is as good as any.
    strided = only_stipples.copy(tone=lambda p, n: np.zeros((len(p), 3), dtype=np.float32)[:, 1])
    assert renderer.prepare((marks, strided), camera).shown == dark.shown


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


@pytest.mark.parametrize("visibility", ["sheets", "painted"])
def test_vertices(renderer, marks, camera, visibility):
    style = hrbfnpr.Style("contour-and-stipple", visibility=visibility)
    names = ("position", "window", "radius", "color", "normal", "direction", "id", "class", "is_paper")
    vertices = renderer.vertices((marks, style), camera, names)
    assert vertices.dtype.names == names and len(vertices) > 100
    assert vertices["color"].dtype == np.uint8 and vertices["color"].shape == (len(vertices), 4)
    assert set(np.unique(vertices["is_paper"])) <= {0, 1}
    depth = vertices["window"][:, 2]
    assert np.ptp(depth) > 0 and depth[0] > depth[-1]
    np.testing.assert_allclose(np.linalg.norm(vertices["normal"], axis=1), 1, atol=1e-4)
    info = renderer.info
    assert (vertices["is_paper"] == 0).sum() == info.shown
    assert (vertices["is_paper"] == 1).sum() == (info.painted if visibility == "painted" else 0)
    for i in (0, len(vertices) // 2, -1):
        clip = camera.projection @ camera.view @ np.append(vertices["position"][i], 1)
        x = (clip[0] / clip[3] + 1) / 2 * 160
        y = (1 - clip[1] / clip[3]) / 2 * 120
        np.testing.assert_allclose(vertices["window"][i, :2], (x, y), atol=0.01)
    default = renderer.vertices((marks, STYLE), camera)
    assert default.dtype.itemsize == 24 and (default["radius"] > 0).all()
    with pytest.raises(ValueError, match="attributes"):
        renderer.vertices((marks, STYLE), camera, ("colour",))
    with pytest.raises(ValueError, match="attributes"):
        renderer.vertices((marks, STYLE), camera, ())


def test_threads_take_turns(renderer, marks, camera):
    inks = ["#ff0000", "#00ff00", "#0000ff", "#000000"]
    wanted = [renderer.draw((marks, STYLE.copy(ink=ink)), camera) for ink in inks]
    wrong = []

    def work(i):
        for _ in range(5):
            if not np.array_equal(renderer.draw((marks, STYLE.copy(ink=inks[i])), camera), wanted[i]):
                wrong.append(i)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_drawings_save_themselves(renderer, marks, camera, tmp_path):
    image_module = pytest.importorskip("PIL.Image")
    drawing = renderer.drawing((marks, STYLE), camera)
    assert drawing._repr_png_().startswith(b"\x89PNG")
    back = np.asarray(image_module.open(io.BytesIO(drawing.to_png())))
    np.testing.assert_array_equal(back, drawing.image)
    drawing.save(tmp_path / "a.png")
    drawing.save(str(tmp_path / "b"))
    drawing.save(tmp_path / "c.jpg")
    assert image_module.open(tmp_path / "b").format == "PNG" and image_module.open(tmp_path / "c.jpg").format == "JPEG"
    with pytest.raises(ValueError, match=".xyz"):
        drawing.save(tmp_path / "d.xyz")
    with pytest.raises(FileNotFoundError):
        drawing.save(tmp_path / "no" / "a.png")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.png", "b", "c.jpg"]
