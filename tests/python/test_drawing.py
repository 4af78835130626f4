# SPDX-License-Identifier: MIT
"""Drawings are values: marks, strokes, poses and image formats."""

import numpy as np
import pytest

import hrbfnpr

RESTART = 0xFFFFFFFF


@pytest.fixture(scope="module")
def renderer():
    return hrbfnpr.Renderer()


@pytest.fixture(scope="module")
def style():
    style = hrbfnpr.Style("full")
    style.layer("hatch").shape = "dots"
    return style


@pytest.fixture(scope="module")
def strokes_style():
    style = hrbfnpr.Style("full")
    style.layer("hatch").shape = "strokes"
    return style


@pytest.fixture
def drawing(renderer, marks, camera, style):
    return renderer.draw((marks, style), camera)


@pytest.fixture
def lines(renderer, marks, camera, strokes_style):
    return renderer.draw((marks, strokes_style), camera)


def flat_strokes():
    """Three horizontal lines in the plane z = 0, of 1, 20 and 40 marks."""
    lines = ((1, -0.5), (20, 0), (40, 0.5))
    parts = [np.column_stack([np.linspace(-1, 1, n), np.full(n, y), np.zeros(n)]) for n, y in lines]
    positions = np.concatenate(parts)
    normals = np.tile([0.0, 0.0, 1.0], (len(positions), 1))
    return hrbfnpr.OwnLayer(positions, normals, name="lines", stroke_first=[0, 1, 21, 61])


def above(width=200, height=100):
    return hrbfnpr.Camera.look_at((0, 0, 5), (0, 0, 0)).orthographic(2, (width, height), 1, 10)


def test_own_strokes_are_lines(renderer):
    marks = hrbfnpr.PointSet.create(flat_strokes())
    style = hrbfnpr.Style(tone="none", layers=[hrbfnpr.LayerStyle("own", shape="strokes", radius=1.5)])
    drawing = renderer.draw((marks, style), above())
    assert (drawing.info.strokes, drawing.info.stroke_points, drawing.info.dots) == (2, 60, 1)
    dark = drawing.image()[..., 0] < 60
    # A line from x = 50 to 150, 3 pixels wide and without gaps, with paper on both sides.
    assert dark[49:51, 52:148].all() and dark[24:26, 52:148].all()
    assert not dark[40:46].any() and not dark[54:60].any() and not dark[:, :45].any() and not dark[:, 155:].any()
    (info,) = (layer for layer in drawing.layers if layer.dots)
    assert (info.mark_class, info.kind, info.name, info.shape) == ("front", "own", "lines", "strokes")
    assert (info.item, info.layer, info.dots, info.strokes) == (0, 0, 1, 2)


def test_line_and_triangle_strips(renderer):
    marks = hrbfnpr.PointSet.create(flat_strokes())
    style = hrbfnpr.Style(tone="none", layers=[hrbfnpr.LayerStyle("own", shape="strokes", radius=1.5)])
    drawing = renderer.draw((marks, style), above())
    vertices, indices = drawing.vertices("line_strips", ("position", "window", "radius", "length", "id", "layer"))
    assert len(vertices) == 60 and len(indices) == 62 and indices.dtype == np.uint32
    ends = np.flatnonzero(indices == RESTART)
    strips = [vertices[part] for part in (indices[: ends[0]], indices[ends[0] + 1 : ends[1]])]
    assert sorted(map(len, strips)) == [20, 40] and ends[1] == len(indices) - 1
    for strip in strips:
        x = strip["window"][:, 0]
        np.testing.assert_allclose(strip["window"][:, 1], strip["window"][0, 1], atol=1e-3)
        np.testing.assert_allclose(strip["length"], np.abs(x - x[0]), atol=1e-2)
        np.testing.assert_allclose(strip["radius"], 1.5, rtol=1e-5)
        for vertex in strip[:: len(strip) - 1]:
            identity = drawing.identify(vertex["id"])
            assert identity.item == identity.layer == 0
            place = marks.layers[0].positions[identity.mark] + marks.origin
            np.testing.assert_allclose(place, vertex["position"], atol=1e-6)
    sides, pairs = drawing.vertices("triangle_strips", ("window", "radius"))
    assert len(sides) == 120 and len(pairs) == 122
    left, right = sides["window"][0::2], sides["window"][1::2]
    np.testing.assert_allclose((left + right)[:, :2] / 2, vertices["window"][:, :2], atol=1e-2)
    np.testing.assert_allclose(np.linalg.norm((left - right)[:, :2], axis=1), 3, atol=1e-2)
    # Dots are written as points: here the single mark.
    assert len(drawing.vertices().vertices) == 1


def test_mark_indices_are_the_shown_marks(renderer, drawing, lines, marks, camera, style):
    published = renderer.draw((marks, style.copy(visibility="published")), camera)
    assert published.info.silhouette > 100 and drawing.info.silhouette == 0
    for one in (drawing, lines, published):
        for layer in marks.layers:
            shown = one.mark_results(0, layer.number).shown
            for name in ("front", "silhouette"):
                indices = one.mark_indices(0, layer.name, name)
                assert indices.dtype == np.uint32
                np.testing.assert_array_equal(np.sort(indices), np.flatnonzero(shown == hrbfnpr.CLASSES[name]))
    layer = marks.layer("hatch")
    strips = lines.mark_indices(0, "hatch", primitive="line_strips")
    assert strips[-1] == RESTART
    along = layer.stroke_places
    run = []
    for index in strips:
        if index == RESTART:
            places = along[run]
            assert len(set(places[:, 0])) == 1 and (np.diff(places[:, 1].astype(int)) == 1).all()
            run = []
        else:
            run.append(index)
    pairs = lines.mark_indices(0, "hatch", primitive="triangle_strips")
    inner = strips[strips != RESTART]
    np.testing.assert_array_equal(pairs[pairs != RESTART], np.column_stack([2 * inner, 2 * inner + 1]).ravel())


def test_identify(drawing, marks):
    id = drawing.raster().id
    for number in np.unique(id[id > 0])[::50]:
        identity = drawing.identify(number)
        layer = marks.layers[identity.layer]
        first = sum(len(other) for other in marks.layers[: identity.layer])
        assert identity.id == number == 1 + first + identity.mark and identity.item == 0
        if layer.info.strokes:
            assert (identity.stroke, identity.place) == (
                layer.stroke_places[identity.mark, 0] // 2, layer.stroke_places[identity.mark, 1],
            )  # fmt: skip
            assert layer.strokes()[identity.stroke][identity.place] == identity.mark
        else:
            assert identity.stroke == -1
    for wrong in (0, len(marks) + 1, RESTART):
        with pytest.raises(hrbfnpr.InvalidArgumentError, match="id"):
            drawing.identify(wrong)


def test_ids_and_layers_of_several_items(renderer, marks, camera, ring):
    more = ring.generate(budget=100)
    drawing = renderer.draw([marks, (more, hrbfnpr.Style("stipple"))], camera)
    assert drawing.info.items == 2
    identity = drawing.identify(len(marks) + 1)
    assert (identity.item, identity.layer, identity.mark) == (1, 0, 0)
    assert len(drawing.mark_results(1).shown) == 100
    for item, layer, kind in ((2, 0, IndexError), (1, 1, IndexError), (-1, 0, IndexError), (0, "fur", KeyError)):
        with pytest.raises(kind):
            drawing.mark_results(item, layer)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="mark_class"):
        drawing.mark_indices(0, 0, "back")


@pytest.mark.parametrize("paper", ["#ffffff", "#e0d0b0", (1, 1, 1, 0)])
def test_the_float_image_rounds_to_the_8_bit_one(renderer, marks, camera, strokes_style, paper):
    drawing = renderer.draw((marks, strokes_style.copy(paper=paper, ink="#203040")), camera)
    for suffix in ("", "_premultiplied"):
        image = drawing.image(format="rgba32f" + suffix)
        assert image.dtype == np.float32 and image.shape == (120, 160, 4) and 0 <= image.min() and image.max() <= 1
        np.testing.assert_array_equal(np.floor(image * 255 + 0.5), drawing.image(format="rgba8" + suffix))
    out = np.zeros((125, 170, 4), np.float32)
    assert drawing.image(out=out[:120, :160], format="rgba32f").base is out
    np.testing.assert_array_equal(out[:120, :160], drawing.image(format="rgba32f"))
    assert (out[120:] == 0).all()


@pytest.mark.parametrize(
    "pose, kind, words",
    [
        ({9: (np.zeros((3, 3)), np.zeros((3, 3)))}, hrbfnpr.InvalidArgumentError, "layer"),
        ({0: (np.zeros((3, 3)), np.zeros((3, 3)))}, hrbfnpr.InvalidArgumentError, "position"),
        ({"fur": (np.zeros((3, 3)), np.zeros((3, 3)))}, KeyError, "no layer 'fur'"),
        ({0: (np.zeros((3, 3)),)}, ValueError, "pose of layer 0"),
        ({0: (np.zeros((3, 2)), np.zeros((3, 3)))}, ValueError, "positions of the pose of layer 0"),
    ],
)
def test_bad_poses(renderer, marks, camera, pose, kind, words):
    with pytest.raises(kind, match=words):
        renderer.draw(hrbfnpr.Item(marks, poses=pose), camera)


def test_a_drawing_does_not_change_later(renderer, marks, camera, style):
    first = renderer.draw((marks, style), camera)
    image = first.image()
    others = [renderer.draw((marks, style.copy(ink="#ff0000")), camera) for _ in range(4)]
    np.testing.assert_array_equal(first.image(), image)
    assert not np.array_equal(others[0].image(), image)
    with renderer.draw((marks, style), camera) as drawing:
        assert "160x120" in repr(drawing) and drawing.size == (160, 120)
    assert drawing.closed and "closed" in repr(drawing)
    for use in (drawing.image, drawing.vertices, drawing.mark_results, drawing.to_png, lambda: drawing.info):
        with pytest.raises(ValueError, match="closed"):
            use()


def test_a_drawing_outlives_its_sources(ring, camera):
    context = hrbfnpr.Context(1)
    own = hrbfnpr.Renderer(context=context)
    marks = ring.generate(budget=500, context=context)
    drawing = own.draw(marks, camera)
    image = drawing.image()
    own.close(), marks.close(), context.close()
    del own, marks, context
    np.testing.assert_array_equal(drawing.image(), image)
    assert len(drawing.mark_results().shown) == 500
