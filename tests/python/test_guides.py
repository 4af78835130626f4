# SPDX-License-Identifier: MIT
"""What lines of hatching follow."""
import numpy as np
import pytest

import hrbfnpr


@pytest.fixture(scope="module")
def ball():
    return hrbfnpr.Model.from_function(
        lambda p: (p * p).sum(axis=1) - 1, lambda p: 2 * p, bounds=((-1.1, -1.1, -1.1), (1.1, 1.1, 1.1))
    )


def marks_of(model, **fields):
    layer = model.generate([hrbfnpr.Layer("hatch", separation=0.08, **fields)]).layers[0]
    return np.asarray(layer.normals), np.asarray(layer.directions)


def test_sections_lie_across_the_axis(ball):
    axis = np.array([1.0, 2.0, 2.0]) / 3
    normal, direction = marks_of(ball, guide="sections", axis=tuple(axis))
    away = np.abs(normal @ axis) < 0.8
    assert np.abs(direction[away] @ axis).mean() < 0.05


def test_light_and_silhouette_cross_each_other_on_a_ball(ball):
    to = np.array([1.0, 0.0, 0.0])
    for guide, wanted in (("light", 1.0), ("silhouette", 0.0)):
        normal, direction = marks_of(ball, guide=guide, guide_direction=tuple(to), guide_weight=1.0)
        tangent = to - (normal @ to)[:, None] * normal
        length = np.linalg.norm(tangent, axis=1)
        steep = length > 0.7
        along = np.abs((direction * tangent).sum(axis=1) / np.maximum(length, 1e-9))[steep]
        assert abs(along.mean() - wanted) < 0.06


def test_a_guide_has_a_name():
    with pytest.raises(ValueError, match="guide"):
        hrbfnpr.Model.fit([[0, 0, 1], [0, 0, -1]], [[0, 0, 1], [0, 0, -1]]).generate(
            [hrbfnpr.Layer("hatch", guide="wind")]
        )


@pytest.mark.parametrize("fields", [{"guide_weight": 1.5}, {"guide_direction": (0, 0, 0)}])
def test_what_a_guide_cannot_take_is_refused_by_name(ball, fields):
    (name,) = fields
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=rf"layers\[0\]\.{name}"):
        marks_of(ball, guide="light", **fields)
