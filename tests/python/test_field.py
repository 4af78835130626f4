# SPDX-License-Identifier: MIT
"""Fields, and their values in point sets."""
import pickle

import numpy as np
import pytest
from conftest import torus

import hrbfnpr

UP = np.array([[0.0, 0.0, 1.0]])


@pytest.fixture(scope="module")
def model():
    points, normals = torus()
    return hrbfnpr.Model.fit(points, normals)


@pytest.fixture(scope="module")
def marks(model):
    return model.generate(["stipples", "hatch"], budget=2000)


def places(marks, layer):
    return np.asarray(marks.layers[layer].positions) + np.asarray(marks.origin)


def test_points_and_triangles(marks):
    corners = np.array([[0.0, 0, 0], [4, 0, 0], [0, 4, 0]])
    field = hrbfnpr.Field.from_points(corners, [10, 50, 10], [[0, 1, 2]], range=(10, 50))
    assert field.kind == "scalar"
    values, weights = field.evaluate([[1, 1, 5], [-3, 0, 0]])
    assert values == pytest.approx([0.25, 0]) and weights.tolist() == [1, 1]
    colours = np.array([[255, 0, 51], [0, 0, 0], [0, 0, 0]], np.uint8)
    near = hrbfnpr.Field.from_points(corners, colours, reach=2)
    assert near.kind == "colour"
    values, weights = near.evaluate([[0, 1, 0], [0, 0, 3]])
    assert values == pytest.approx(np.array([[1, 0, 0.2], [0, 0, 0]])) and weights.tolist() == [1, 0]
    as_lists = hrbfnpr.Field.from_points(corners.tolist(), colours.tolist())
    assert as_lists.kind == "colour"


def test_sets_share_marks_and_keep_values(marks):
    height = hrbfnpr.Field.from_function(lambda at, normals: at[:, 2])
    way = hrbfnpr.Field.from_function(lambda at, normals: (normals, np.abs(normals[:, 0])), "direction")
    painted = marks.with_fields({"height": height, "way": way})
    assert painted.fields == {"height": "scalar", "way": "direction"} and marks.fields == {}
    assert np.shares_memory(painted.layers[0].positions, marks.layers[0].positions)
    for number, (values, weights) in enumerate(painted.field("height")):
        assert values == pytest.approx(places(marks, number)[:, 2], abs=1e-6) and len(weights) == 0
    values, weights = painted.layers[1].field("way")
    assert weights == pytest.approx(np.abs(marks.layers[1].normals[:, 0]), abs=1e-6)
    copy = pickle.loads(pickle.dumps(painted))
    assert copy.fields == painted.fields
    assert np.array_equal(copy.layers[1].field("way").values, values)
    fewer = painted.with_fields({"way": None})
    assert fewer.fields == {"height": "scalar"}
    with pytest.raises(hrbfnpr.InvalidArgumentError, match='no field "way"'):
        fewer.field("way")


def test_a_transform_leads_to_the_field(marks):
    along = hrbfnpr.Field.from_function(lambda at, normals: at - (10, 0, 0), "direction")
    turn = np.array([[0, -2.0, 0, 10], [2, 0, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]])
    values = marks.with_fields({"out": along}, transform=turn).layers[0].field("out").values
    assert values == pytest.approx(places(marks, 0), abs=1e-5)


def test_dabs(marks):
    dabs = [hrbfnpr.Dab((1, 0, 0), (0, 0, 1), 1.0, 0.2, 0.5), hrbfnpr.Dab((1, 0, 0), (0, 0, 1), 2.0, 1.0, 0.5)]
    field = hrbfnpr.Field.from_dabs(dabs)
    values, weights = field.evaluate([[1, 0, 0], [1, 1.5, 0], [5, 0, 0]], np.repeat(UP, 3, 0))
    assert weights == pytest.approx([0.75, 0.5 * (1 - 1.5**2 / 4) ** 2, 0])
    assert values == pytest.approx([(0.5 * 0.5 * 0.2 + 0.5) / 0.75, 1, 0])
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"dabs\[0\].radius"):
        hrbfnpr.Field.from_dabs([hrbfnpr.Dab((0, 0, 0), (0, 0, 1), 0.0)])


def test_images(model, marks):
    camera = hrbfnpr.Camera.fit(model, (0, 0, -1), (0, 1, 0), size=(200, 100))
    image = np.zeros((50, 100, 4), np.float32)
    image[..., 0] = (np.arange(100) + 0.5) / 100
    image[..., 3] = 1
    values, weights = marks.with_fields({"photo": hrbfnpr.Field.from_image(image, camera)}).layers[0].field("photo")
    upward = marks.layers[0].normals[:, 2]
    clear = np.abs(upward) > 0.4
    assert np.array_equal(weights[clear] > 0.5, upward[clear] > 0)
    at = places(marks, 0)
    seen = clear & (upward > 0)
    clip = np.c_[at, np.ones(len(at))] @ np.asarray(camera.view).T @ np.asarray(camera.projection).T
    assert values[seen, 0] == pytest.approx(0.5 + 0.5 * clip[seen, 0] / clip[seen, 3], abs=1e-3)
    grey = np.full((2, 2, 4), 255, np.uint8)
    luminance = hrbfnpr.Field.from_image(grey, camera, kind="scalar", range=(0, 2))
    assert luminance.evaluate(at[seen], marks.layers[0].normals[seen]).values == pytest.approx(0.5)
    with pytest.raises(ValueError, match=r"\(height, width, 4\)"):
        hrbfnpr.Field.from_image(np.zeros((4, 4), np.uint8), camera)


def test_layers_follow_fields(model):
    half = hrbfnpr.Field.from_function(lambda at, normals: (at[:, 0] > 0) * 1.0)
    around = hrbfnpr.Field.from_function(lambda at, normals: np.cross(normals, (0, 0, 1)), "direction")
    layers = [hrbfnpr.Layer("stipples", budget=1500, density=half), hrbfnpr.Layer("hatch", budget=1500, direction=around)]
    made = model.generate(layers)
    assert places(made, 0)[:, 0].min() > -1e-3
    assert np.median(np.abs(made.layers[1].directions[:, 2])) < 0.05
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="density_field is a field of kind DIRECTION"):
        model.generate(hrbfnpr.Layer("stipples", density=around))


def test_exceptions_of_functions_are_raised(model, marks):
    def fails(at, normals):
        raise KeyError("lost")

    field = hrbfnpr.Field.from_function(fails)
    for call in (lambda: marks.with_fields({"a": field}), lambda: field.evaluate([[0, 0, 0]], UP),
                 lambda: model.generate(hrbfnpr.Layer("stipples", density=field))):  # fmt: skip
        with pytest.raises(hrbfnpr.CallbackError, match="lost"):
            call()
    odd = hrbfnpr.Field.from_function(lambda at, normals: at[:1, 0])
    with pytest.raises(hrbfnpr.CallbackError, match="values of a field must have"):
        marks.with_fields({"a": odd})
    operation = hrbfnpr.Operation()
    operation.cancel()
    with pytest.raises(hrbfnpr.CancelledError):
        marks.with_fields({"a": hrbfnpr.Field.from_points([[0.0, 0, 0]], [1.0])}, operation=operation)
    field.close()
    with pytest.raises(ValueError, match="this Field is closed"):
        marks.with_fields({"a": field})


def test_styles_name_fields():
    style = hrbfnpr.Style("stipple", palette=["#ff0000", (0, 0, 1)])
    layer = style.layer("stipples")
    layer.tone_field, layer.ink_field, layer.palette_rule = "heat", "rgb", "mixed"
    assert style.palette == [(1, 0, 0, 1), (0, 0, 1, 1)]
    copy = pickle.loads(pickle.dumps(style))
    assert copy == style and copy.layer("stipples").tone_field == "heat"
    assert "tone_field='heat'" in repr(style) and "palette=" in repr(style)
    copy.layer("stipples").tone_field = None
    assert copy != style
    with pytest.raises(TypeError, match="name of a field"):
        layer.mask_field = hrbfnpr.Field.from_points([[0.0, 0, 0]], [1.0])
    with pytest.raises(AttributeError, match="no field 'inks'"):
        layer.inks = "rgb"
