# SPDX-License-Identifier: MIT
"""Point sets: generating, attributes and saving."""
import io
import pickle
from dataclasses import replace

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr

LAYERS = (("stipples", "stipples"), ("hatch", "hatch"), ("hatch", "combing"))  # kinds and names of the layers of `marks`


def absolute(marks, layer):
    return marks.layer(layer).positions.astype(float) + marks.origin


def test_attributes(marks, ring):
    assert [(layer.kind, layer.name) for layer in marks.layers] == list(LAYERS)
    assert len(marks) == sum(len(layer.ranks) for layer in marks.layers) == marks.info.marks
    for layer in marks.layers:
        count = layer.info.marks
        assert count == pytest.approx(3000, rel=0.1) and len(layer) == count
        shapes = {"positions": (count, 3), "normals": (count, 3), "directions": (count, 3), "ranks": (count,)}
        shapes.update(levels=(count,), stroke_places=(count, 2), widths=(0,))
        shapes.update(stroke_order=(0,), stroke_first=(layer.info.strokes + 1 if layer.info.strokes else 0,))
        for name, shape in shapes.items():
            assert getattr(layer, name).shape == shape
        assert np.abs(ring.evaluate(absolute(marks, layer.name)).value).max() < 1e-5
        np.testing.assert_allclose(np.linalg.norm(layer.normals, axis=1), 1, atol=1e-5)
        np.testing.assert_allclose(np.einsum("ij,ij->i", layer.normals, layer.directions), 0, atol=1e-5)
        assert 0 <= layer.ranks.min() and layer.ranks.max() < 1
    stipples, lines, combing = marks.layers
    assert len(stipples.curvatures) == 0 and stipples.info.strokes == 0 and stipples.strokes() == []
    assert lines.curvatures.shape == (len(lines), 3) and len(combing.curvatures) == 0
    assert stipples.levels.dtype == np.uint8 and combing.stroke_places.dtype == np.uint32
    assert "stipples" in repr(marks) and "combing" in repr(combing)
    assert marks.layer(1).number == marks.layer("hatch").number == 1
    for which, error in ((3, IndexError), ("fur", KeyError)):
        with pytest.raises(error):
            marks.layer(which)


def test_tone_normals(ring):
    lines = hrbfnpr.Layer("hatch", separation=0.1)
    marks = ring.generate([lines, hrbfnpr.Layer("stipples", budget=500, tone_smoothing=0.02)])
    for layer in hrbfnpr.PointSet.load(marks.to_bytes()).layers:
        assert layer.tone_normals.shape == layer.normals.shape
        assert np.einsum("ij,ij->i", layer.normals, layer.tone_normals).min() > 0.9
    marks = ring.generate([hrbfnpr.Layer("hatch", separation=0.1, tone_smoothing=0), hrbfnpr.Layer(budget=500)])
    assert [len(layer.tone_normals) for layer in marks.layers] == [0, 0]
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="tone_smoothing is 0.5"):
        ring.generate(hrbfnpr.Layer("hatch", separation=0.1, tone_smoothing=0.5))


def test_strokes(marks):
    for layer in marks.layers[1:]:
        strokes = layer.strokes()
        assert len(strokes) == layer.info.strokes > 5
        np.testing.assert_array_equal(np.concatenate(strokes), np.arange(len(layer)))
        for stroke in strokes:
            numbers, places = layer.stroke_places[stroke].T
            assert len(set(numbers)) == 1
            np.testing.assert_array_equal(places, np.arange(len(stroke)))


def test_layers_outlive_their_set(ring):
    marks = ring.generate(budget=300)
    layer = marks.layers[0]
    wanted = layer.positions.copy()
    marks.close()
    np.testing.assert_array_equal(layer.positions, wanted)
    for use in (lambda: marks.layers, lambda: marks.layer(0)):
        with pytest.raises(ValueError, match="closed"):
            use()


def test_layers_can_be_given_in_many_forms(ring):
    def kinds(*given, **options):
        return [(layer.kind, layer.name) for layer in ring.generate(*given, budget=200, **options).layers]

    assert kinds() == kinds("stipples") == kinds(preset="stipple") == [("stipples", "stipples")]
    assert kinds(preset="full") == [("stipples", "stipples"), ("hatch", "hatch-1"), ("hatch", "hatch-2")]
    published = ring.generate(preset="full", distribution="published", levels=1).layers
    assert [layer.kind for layer in published] == ["stipples", "hatch"]
    # Options apply to all layers of a preset and override its values.
    made = ring.generate(preset="combing", budget=300, with_curvature=True).layers
    assert all(len(layer.curvatures) == len(layer) for layer in made)
    assert [layer.name for layer in made] == ["stipples", "hatch-1", "hatch-2"]
    dense = hrbfnpr.Layer("stipples", name="dense", budget=500)
    marks = ring.generate(["stipples", dense, hrbfnpr.Layer("stipples", name="d\u00fcnn", budget=50)], budget=200)
    assert [(layer.name, len(layer)) for layer in marks.layers] == [("stipples", 200), ("dense", 500), ("d\u00fcnn", 50)]
    # Options go only to the layers that have them.
    marks = ring.generate(["stipples", "hatch"], separation=0.2, with_curvature=True)
    assert len(marks.layers[0]) == 40000 and marks.layers[1].info.step == 0.2
    assert all(len(layer.curvatures) == len(layer) for layer in marks.layers)


@pytest.mark.parametrize(
    "arguments, kind, words",
    [
        ((["stipples", 3],), TypeError, "layers must be"),
        (("dots",), ValueError, "kind of a layer must be one of 'stipples'"),
        (("own",), ValueError, "kind of a layer"),
        ((hrbfnpr.Layer(tone=(0.5, 0.2)),), ValueError, "tone"),
        ((hrbfnpr.Layer(name=""),), ValueError, "name"),
        (([],), ValueError, "layers must name at least one"),
    ],
)
def test_bad_layers(ring, arguments, kind, words):
    with pytest.raises(kind, match=words):
        ring.generate(*arguments)


def test_bad_arguments_of_generate(ring):
    with pytest.raises(TypeError, match="unexpected argument 'budgets'"):
        ring.generate(budgets=3)
    with pytest.raises(TypeError, match="either layers or preset"):
        ring.generate("stipples", preset="full")
    with pytest.raises(ValueError, match="preset must be one of 'stipple'"):
        ring.generate(preset="watercolour")


def test_strokes_along_a_field(ring):
    def around(p):
        return np.cross([0.0, 0.0, 1.0], p)

    def along_and_across(layer, **options):
        """Cosines of the angle to the field, for marks of the first and of the second direction."""
        marks = ring.generate(layer, **options)
        wanted = around(absolute(marks, "hatch"))
        wanted /= np.linalg.norm(wanted, axis=1)[:, None]
        cosine = np.abs(np.einsum("ij,ij->i", wanted, marks.layers[0].directions))
        second = marks.layers[0].stroke_places[:, 0] % 2 == 1
        return cosine[~second], cosine[second]

    along, across = along_and_across(hrbfnpr.Layer("hatch", direction=lambda p, n: around(p), separation=0.1))
    assert np.quantile(along, 0.05) > 0.99 and len(across) == 0
    layer = hrbfnpr.Layer("hatch", direction=lambda p, n: around(p))
    along, across = along_and_across(layer, distribution="published")
    assert np.quantile(along, 0.05) > 0.99 and np.quantile(across, 0.95) < 0.1

    def fails(positions, normals):
        raise KeyError("no direction today")

    with pytest.raises(hrbfnpr.CallbackError, match="no direction today"):
        ring.generate(hrbfnpr.Layer("hatch", direction=fails, budget=500))


def test_densities(ring):
    def upper(points, normals):
        assert points.shape == normals.shape
        return points[:, 2] > 0

    marks = hrbfnpr.PointSet.generate(ring, budget=500, density=upper)
    assert len(marks) == 500
    assert (marks.layers[0].positions[:, 2] + marks.origin[2]).min() > -1e-3
    assert len(hrbfnpr.PointSet.generate(ring, budget=500, density="curvature", density_strength=1.0)) == 500

    def fails(points, normals):
        raise KeyError("no density today")

    with pytest.raises(hrbfnpr.CallbackError, match="no density today"):
        hrbfnpr.PointSet.generate(ring, budget=500, density=fails)


def test_options_reach_the_library(ring):
    marks = hrbfnpr.PointSet.generate(ring, budget=200, with_curvature=True, initial_step=0.1, random_seed=7)
    assert len(marks) <= 200
    assert marks.layers[0].curvatures.shape == (len(marks), 3)
    again = hrbfnpr.PointSet.generate(ring, budget=200, random_seed=7)
    other = hrbfnpr.PointSet.generate(ring, budget=200, random_seed=8)
    np.testing.assert_array_equal(marks.layers[0].positions, again.layers[0].positions)
    assert not np.array_equal(again.layers[0].positions, other.layers[0].positions)
    box = hrbfnpr.PointSet.generate(ring, distribution="published", seed_source="box", box_resolution=4, levels=1)
    assert box.info.seed_source == "box"
    given = hrbfnpr.PointSet.generate(ring, distribution="published", seed_points=[[1.4, 0, 0], [0, 1.4, 0]], levels=1)
    assert given.info.seed_source == "points" and given.layers[0].info.full_count == 10


@pytest.mark.parametrize(
    "options, kind, words",
    [
        ({"layers": ("dots",)}, ValueError, "layer.*stipples"),
        ({"distribution": "white"}, ValueError, "distribution"),
        ({"budget": -1}, hrbfnpr.InvalidArgumentError, "budget"),
        ({"layers": "hatch", "guide": "curl"}, ValueError, "guide"),
        ({"layers": "hatch", "guide": "light", "distribution": "published"}, hrbfnpr.InvalidArgumentError, r"layers\[0\].guide"),
        ({"density": "thick"}, ValueError, "density"),
        ({"tone_ranges": "random"}, ValueError, "tone_ranges"),
        ({"tone": (0.5, 0.5)}, hrbfnpr.InvalidArgumentError, r"layers\[0\].*tone"),
        ({"separation": 1}, ValueError, "separation does not apply"),
        ({"layers": hrbfnpr.Layer(), "budget": 5}, ValueError, "budget does not apply"),
        ({"seed_points": [[0, 0]]}, ValueError, "seed_points"),
        ({"seed_source": "points"}, hrbfnpr.InvalidArgumentError, "seed_points"),
        ({"random_seed": -1}, OverflowError, ""),
    ],
)
def test_bad_options(ring, options, kind, words):
    with pytest.raises(kind, match=words):
        hrbfnpr.PointSet.generate(ring, **options)


def test_own_layers():
    points = fibonacci_sphere(200)
    marks = hrbfnpr.PointSet.create(
        [
            hrbfnpr.OwnLayer(points + 50, points.astype("f4"), name="dots"),
            hrbfnpr.OwnLayer(
                points,
                points,
                kind="hatch",
                directions=np.cross(points, [0.3, 0.2, 1]),
                ranks=np.arange(200) / 200,
                levels=np.arange(200) % 3,
                widths=np.full(200, 0.5),
                stroke_first=np.arange(0, 201, 10),
                stroke_directions=np.arange(20) % 2,
            ),
        ]
    )
    dots, strokes = marks.layers
    assert [(layer.kind, layer.name) for layer in marks.layers] == [("own", "dots"), ("hatch", "hatch")]
    np.testing.assert_allclose(absolute(marks, "dots"), points + 50, atol=1e-5)
    assert len(set(dots.ranks)) > 190 and len(dots.stroke_first) == 0
    np.testing.assert_allclose(strokes.ranks, np.arange(200) / 200, atol=1e-7)
    np.testing.assert_array_equal(strokes.levels, np.arange(200) % 3)
    np.testing.assert_array_equal(strokes.widths, np.full(200, 0.5))
    np.testing.assert_array_equal(strokes.stroke_first, np.arange(0, 201, 10))
    np.testing.assert_array_equal(strokes.stroke_places[:, 0], 2 * (np.arange(200) // 10) + np.arange(200) // 10 % 2)
    np.testing.assert_array_equal(strokes.stroke_places[:, 1], np.arange(200) % 10)
    assert len(strokes.strokes()) == 20
    again = hrbfnpr.PointSet.load(marks.to_bytes()).layer("hatch")
    np.testing.assert_array_equal(again.widths, strokes.widths)


def test_own_layers_are_added_to_another_set(marks, ring):
    points = fibonacci_sphere(40)
    both = hrbfnpr.PointSet.create(hrbfnpr.OwnLayer(points, points, name="spikes"), base=marks)
    assert [layer.name for layer in both.layers] == [*(name for _, name in LAYERS), "spikes"] and len(both) == len(marks) + 40
    assert both.origin == marks.origin and both.info.spacing == marks.info.spacing
    for one, other in zip(marks.layers, both.layers):
        np.testing.assert_array_equal(one.positions, other.positions)
        np.testing.assert_array_equal(one.stroke_places, other.stroke_places)
    np.testing.assert_allclose(absolute(both, "spikes"), points, atol=1e-6)
    again = hrbfnpr.PointSet.load(both.to_bytes())
    assert [layer.name for layer in again.layers] == [layer.name for layer in both.layers]
    np.testing.assert_array_equal(again.layer("spikes").ranks, both.layer("spikes").ranks)
    copy = hrbfnpr.PointSet.create(base=marks)
    assert len(copy) == len(marks)


def own(**arrays):
    return [hrbfnpr.OwnLayer(**{"positions": np.ones((3, 3)), "normals": np.ones((3, 3)) / 3**0.5, **arrays})]


@pytest.mark.parametrize(
    "layers, words",
    [
        (own(normals=np.empty((0, 3))), "normal"),
        (own(positions=np.full((3, 3), np.nan)), "position.*0"),
        (own(positions=np.zeros((3, 2))), "own.positions must have the shape"),
        (own(name="fur", ranks=np.zeros((3, 2))), "layers.0.*rank|rank"),
        (own(kind="dots"), "the kind of a layer must be one of"),
        (own(stroke_first=[0, 2]), "stroke_first"),
        ([], "."),
    ],
)
def test_bad_own_layers(layers, words):
    with pytest.raises(ValueError, match=words):
        hrbfnpr.PointSet.create(layers)


def test_step_patches(ring):
    patches = hrbfnpr.PointSet.step_patches(ring, 16, initial_step=0.05)
    assert patches.step == 0.05 and patches.corners.shape == (16, 4, 3)
    sides = np.linalg.norm(np.roll(patches.corners, -1, axis=1) - patches.corners, axis=2)
    np.testing.assert_allclose(sides, 0.1, rtol=1e-6)
    assert hrbfnpr.PointSet.step_patches(ring, 4).step > 0
    with pytest.raises(TypeError, match="unexpected"):
        hrbfnpr.PointSet.step_patches(ring, 4, initial_stop=1)


def test_save_load_pickle(marks, tmp_path):
    stream = io.BytesIO()
    marks.save(stream)
    marks.save(tmp_path / "marks.hrbp")
    for other in (
        hrbfnpr.PointSet.load(stream.getvalue()),
        hrbfnpr.PointSet.load(tmp_path / "marks.hrbp"),
        pickle.loads(pickle.dumps(marks)),
    ):
        assert other.origin == marks.origin and replace(other.info, bytes=marks.info.bytes) == marks.info
        for one, layer in zip(other.layers, marks.layers):
            assert one.info == layer.info
            for name in ("positions", "ranks", "stroke_places", "stroke_first", "curvatures", "widths"):
                np.testing.assert_array_equal(getattr(one, name), getattr(layer, name))
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.PointSet.load(marks.to_bytes()[:-3])
