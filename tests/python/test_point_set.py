"""Point sets: generating, attributes, saving."""
import io
import pickle

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr

GROUPS = ("stipple", "curvature", "combing")


def absolute(marks, group):
    return marks.positions(group).astype(float) + marks.origin


def test_attributes(marks, ring):
    assert marks.groups == GROUPS and len(marks) == sum(len(marks.ranks(group)) for group in GROUPS)
    for group in GROUPS:
        count = marks.info.group[group].count
        assert 500 < count <= 3000
        shapes = {"positions": (count, 3), "normals": (count, 3), "directions": (count, 3), "ranks": (count,)}
        shapes.update(levels=(count,), strokes=(count, 2), widths=(0 if group == "stipple" else count,))
        for name, shape in shapes.items():
            assert getattr(marks, name)(group).shape == shape
        assert np.abs(ring.evaluate(absolute(marks, group)).value).max() < 1e-5
        normals, directions = marks.normals(group), marks.directions(group)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
        np.testing.assert_allclose(np.einsum("ij,ij->i", normals, directions), 0, atol=1e-5)
        assert 0 <= marks.ranks(group).min() and marks.ranks(group).max() < 1
    assert len(marks.curvatures("stipple")) == 0
    assert marks.curvatures("curvature").shape == (marks.info.group["curvature"].count, 3)
    assert marks.levels("stipple").dtype == np.uint8 and marks.strokes("combing").dtype == np.uint32
    assert "stipple" in repr(marks)


def test_the_published_recursion():
    points = fibonacci_sphere(6)
    model = hrbfnpr.Model.fit(points, points)
    marks = hrbfnpr.PointSet.generate(
        model, GROUPS, distribution="paper", seed_source="samples", levels={"stipple": 4, "curvature": 2, "combing": 3}
    )
    info = marks.info
    assert info.distribution == "paper" and info.seed_source == "samples"
    assert [info.group[name].full_count for name in GROUPS] == [3750, 6 * 2 * 9, 6 * 2 * 27]
    for name in GROUPS:
        dropped = sum(
            level.dropped_not_converged + level.dropped_strayed + level.dropped_degenerate + level.dropped_budget
            for level in info.group[name].level
        )
        assert sum(level.attempted for level in info.group[name].level) == info.group[name].count + dropped
        assert len(info.group[name].level) == info.group[name].levels + 1


def torus_samples(along, around):
    u, v = (a.ravel() for a in np.meshgrid(np.arange(along) * 2 * np.pi / along, np.arange(around) * 2 * np.pi / around))
    out = np.stack([np.cos(u), np.sin(u), 0 * u], axis=1)
    normals = np.cos(v)[:, None] * out + np.sin(v)[:, None] * np.array([0, 0, 1])
    return out + 0.35 * normals, normals


def test_strokes_follow_the_principal_directions_of_a_fitted_torus():
    model = hrbfnpr.Model.fit(*torus_samples(128, 32))
    for field in ("line", "cross"):
        marks = hrbfnpr.PointSet.generate(model, "curvature", budget=30000, stroke_field=field)
        p, d = absolute(marks, "curvature"), marks.directions("curvature").astype(float)
        around = np.stack([-p[:, 1], p[:, 0], 0 * p[:, 0]], axis=1) / np.hypot(p[:, 0], p[:, 1])[:, None]
        cosine = np.abs(np.einsum("ij,ij->i", around, d))
        sine = np.linalg.norm(d - np.einsum("ij,ij->i", around, d)[:, None] * around, axis=1)
        first = marks.strokes("curvature")[:, 0] % 2 == 0  # k2, the smaller one by sign, is the tube's
        error = np.degrees(np.where(first, np.arctan2(sine, cosine), np.arctan2(cosine, sine)))
        assert error.mean() <= 0.05 and np.quantile(error, 0.95) <= 0.2


def test_separation_step_and_length_of_strokes(ring):
    marks = hrbfnpr.PointSet.generate(
        ring, "combing", stroke_separation=0.08, stroke_step=0.02, stroke_length=0.6, stroke_field="line"
    )
    strokes, p = marks.strokes("combing"), absolute(marks, "combing")
    steps = np.linalg.norm(np.diff(p, axis=0), axis=1)[np.diff(strokes[:, 0].astype(int)) == 0]
    assert abs(steps / 0.02 - 1).max() < 0.25
    assert strokes[:, 1].max() <= 31
    assert marks.info.group["combing"].step == 0.08
    widths = marks.widths("combing")
    assert 0 < widths.min() < 0.5 and widths.max() == 1
    again = hrbfnpr.PointSet.load(marks.to_bytes())
    np.testing.assert_array_equal(again.widths("combing"), widths)


def test_strokes_from_stipples():
    points = fibonacci_sphere(12)
    model = hrbfnpr.Model.fit(points, points)
    marks = hrbfnpr.PointSet.generate(
        model, ("stipple", "combing"), distribution="paper", levels={"stipple": 1, "combing": 1},
        stroke_seeds="stipples", seed_level=1, seed_source="samples",
    )  # fmt: skip
    assert marks.info.group["combing"].full_count == 12 * 5 * 2 * 3


def test_densities(ring):
    def upper(points, normals):
        assert points.shape == normals.shape
        return points[:, 2] > 0

    marks = hrbfnpr.PointSet.generate(ring, budget=500, density=upper)
    assert len(marks) == 500
    assert (marks.positions("stipple")[:, 2] + marks.origin[2]).min() > -1e-3
    assert len(hrbfnpr.PointSet.generate(ring, budget=500, density="curvature", density_strength=1.0)) == 500

    def fails(points, normals):
        raise KeyError("no density today")

    with pytest.raises(hrbfnpr.CallbackError, match="no density today"):
        hrbfnpr.PointSet.generate(ring, budget=500, density=fails)


def test_layers_share_a_budget(ring):
    marks = hrbfnpr.PointSet.generate(ring, ("stipple", "curvature"), order="layered", shared_budget=9000)
    assert len(marks.positions("stipple")) == pytest.approx(3000, rel=0.02)
    assert len(marks.positions("curvature")) == pytest.approx(6000, rel=0.1)
    assert marks.ranks("stipple").min() >= 2 / 3 - 1e-6
    ranks, second = marks.ranks("curvature"), marks.strokes("curvature")[:, 0] % 2 == 1
    assert 1 / 3 - 1e-6 <= ranks[~second].min() and ranks[~second].max() <= 2 / 3 + 1e-6
    assert ranks[second].max() <= 1 / 3 + 1e-6
    chosen = hrbfnpr.PointSet.generate(ring, budget=100, layers={"stipple": (0.25, 0.5)})
    assert 0.5 - 1e-6 <= chosen.ranks("stipple").min() and chosen.ranks("stipple").max() <= 0.75


def test_options_arrive(ring):
    marks = hrbfnpr.PointSet.generate(ring, budget=200, curvature_of="stipple", initial_step=0.1, random_seed=7)
    assert marks.info.group["stipple"].count <= 200
    assert marks.curvatures("stipple").shape == (marks.info.group["stipple"].count, 3)
    again = hrbfnpr.PointSet.generate(ring, budget=200, random_seed=7)
    other = hrbfnpr.PointSet.generate(ring, budget=200, random_seed=8)
    np.testing.assert_array_equal(marks.positions("stipple"), again.positions("stipple"))
    assert not np.array_equal(again.positions("stipple"), other.positions("stipple"))
    box = hrbfnpr.PointSet.generate(ring, distribution="paper", seed_source="box", box_resolution=4, levels=1)
    assert box.info.seed_source == "box"
    given = hrbfnpr.PointSet.generate(ring, distribution="paper", seed_points=[[1.4, 0, 0], [0, 1.4, 0]], levels=1)
    assert given.info.seed_source == "points" and given.info.group["stipple"].full_count == 10


@pytest.mark.parametrize(
    "options, kind, words",
    [
        ({"groups": ("dots",)}, ValueError, "groups.*stipple"),
        ({"groups": ()}, hrbfnpr.InvalidArgumentError, "groups"),
        ({"distribution": "white"}, ValueError, "distribution"),
        ({"box_jitter": 0.7}, hrbfnpr.InvalidArgumentError, "box_jitter"),
        ({"box_resolution": 0}, hrbfnpr.InvalidArgumentError, "box_resolution"),
        ({"levels": 13}, hrbfnpr.InvalidArgumentError, "levels"),
        ({"levels": {"dots": 1}}, ValueError, "levels"),
        ({"budget": -1}, hrbfnpr.InvalidArgumentError, "budget"),
        ({"stroke_separation": -1}, hrbfnpr.InvalidArgumentError, "stroke_separation"),
        ({"stroke_step": float("inf")}, hrbfnpr.InvalidArgumentError, "stroke_step"),
        ({"stroke_length": float("nan")}, hrbfnpr.InvalidArgumentError, "stroke_length"),
        ({"stroke_field": "curl"}, ValueError, "stroke_field"),
        ({"density": "thick"}, ValueError, "density"),
        ({"density_strength": 1.5}, hrbfnpr.InvalidArgumentError, "density_strength"),
        ({"order": "random"}, ValueError, "order"),
        ({"layers": {"hair": (0, 1)}}, ValueError, "layers"),
        ({"layers": {"stipple": (0.5, 0.5)}}, hrbfnpr.InvalidArgumentError, r"layer\[0\]"),
        ({"layers": {"stipple": (0.0, 1.5)}}, hrbfnpr.InvalidArgumentError, r"layer\[0\]"),
        ({"shared_budget": -1}, hrbfnpr.InvalidArgumentError, "shared_budget"),
        ({"shared_budget": 100, "budget": 50}, hrbfnpr.InvalidArgumentError, r"shared_budget.*group\[0\]"),
        ({"initial_step": float("nan")}, hrbfnpr.InvalidArgumentError, "initial_step"),
        ({"seed_points": [[0, 0]]}, ValueError, "seed_points"),
        ({"seed_source": "points"}, hrbfnpr.InvalidArgumentError, "seed_points"),
        ({"random_seed": -1}, OverflowError, ""),
    ],
)
def test_bad_options(ring, options, kind, words):
    with pytest.raises(kind, match=words):
        hrbfnpr.PointSet.generate(ring, **options)


def test_from_arrays():
    points = fibonacci_sphere(200)
    marks = hrbfnpr.PointSet.from_arrays(
        {
            "stipple": {"position": points + 50, "normal": points.astype("f4")},
            "combing": {
                "position": points,
                "normal": points,
                "direction": np.cross(points, [0.3, 0.2, 1]),
                "rank": np.arange(200) / 200,
                "level": np.arange(200) % 3,
                "stroke": np.column_stack([np.arange(200) // 10, np.arange(200) % 10]),
            },
        }
    )
    assert marks.groups == ("stipple", "combing")
    np.testing.assert_allclose(absolute(marks, "stipple"), points + 50, atol=1e-5)
    np.testing.assert_allclose(marks.ranks("combing"), np.arange(200) / 200, atol=1e-7)
    np.testing.assert_array_equal(marks.levels("combing"), np.arange(200) % 3)
    np.testing.assert_array_equal(marks.strokes("combing")[:, 0], np.arange(200) // 10)


@pytest.mark.parametrize(
    "groups, words",
    [
        ({"stipple": {"position": np.zeros((3, 3))}}, "normal"),
        ({"stipple": {"position": np.zeros((3, 3)), "normal": np.zeros((3, 3))}}, "normal.*0"),
        ({"stipple": {"position": np.ones((3, 3)), "normal": np.ones((2, 3))}}, "normal"),
        ({"stipple": {"position": np.full((3, 3), np.nan), "normal": np.ones((3, 3))}}, "position.*0"),
        ({"stipple": {"place": np.zeros((3, 3))}}, "no attribute 'place'"),
        ({"dots": {}}, "group must be one of"),
        ({}, "."),
    ],
)
def test_bad_arrays(groups, words):
    with pytest.raises(ValueError, match=words):
        hrbfnpr.PointSet.from_arrays(groups)


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
        assert other.origin == marks.origin and other.groups == marks.groups
        for group in GROUPS:
            np.testing.assert_array_equal(other.positions(group), marks.positions(group))
            np.testing.assert_array_equal(other.ranks(group), marks.ranks(group))
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.PointSet.load(marks.to_bytes()[:-3])


def test_a_model_is_not_a_point_set(ring, marks):
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.PointSet.load(ring.to_bytes())
    with pytest.raises(hrbfnpr.CorruptDataError):
        hrbfnpr.Model.load(marks.to_bytes())
