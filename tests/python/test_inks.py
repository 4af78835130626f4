# SPDX-License-Identifier: MIT
"""Fields and inks of styles in drawings."""
import io

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr

PALETTE = ["#c02020", "#2020c0"]


@pytest.fixture(scope="module")
def marks(sphere):
    points = fibonacci_sphere(500)
    colours = np.where(points[:, :1] > 0, [[0.2, 0.2, 0.7]], [[0.7, 0.2, 0.2]])
    fields = {
        "colour": hrbfnpr.Field.from_points(points, colours),
        "height": hrbfnpr.Field.from_points(points, points[:, 2], range=(-1, 1)),
    }
    return sphere.generate(budget=4000).with_fields(fields)


def drawn(marks, **fields):
    style = hrbfnpr.Style(tone="none", tone_curve="linear", tone_fade=0)
    style.palette = PALETTE
    for name, value in fields.items():
        setattr(style.layer("stipples"), name, value)
    camera = hrbfnpr.Camera.fit(marks, (0, -1, 0), (0, 0, 1), size=(200, 200))
    return hrbfnpr.Renderer().draw((marks, style), camera)


def shown_heights(marks, drawing):
    shown = np.asarray(drawing.mark_results().shown) != 0
    return np.asarray(marks.layers[0].positions)[shown, 2]


def test_each_ink_is_a_layer(marks):
    drawing = drawn(marks, ink_field="colour")
    layers = [layer for layer in drawing.layers if layer.dots]
    assert [layer.ink_number for layer in layers] == [0, 1]
    assert np.allclose(layers[1].ink, (0x20 / 255, 0x20 / 255, 0xC0 / 255, 1))
    page = io.BytesIO()
    hrbfnpr.write_page(page, drawing, format="svg")
    assert b'"stipples ink 1"' in page.getvalue() and b'"stipples ink 2"' in page.getvalue()
    mixed = drawn(marks, ink_field="colour", palette_rule="mixed")
    assert sum(layer.dots for layer in mixed.layers) == drawing.info.dots


def test_fields_change_marks(marks):
    whole = drawn(marks)
    masked = drawn(marks, mask_field="height")
    assert shown_heights(marks, masked).min() > -0.1
    assert shown_heights(marks, whole).min() < -0.8
    sparse = shown_heights(marks, drawn(marks, density_field="height"))
    assert 0.1 < (sparse < 0).sum() / (sparse > 0).sum() < 0.6
    wide = np.asarray(drawn(marks, width_field="height").mark_results().radius)
    assert wide.max() > 0.95 and 0 < wide[wide > 0].min() < 0.2


def test_what_is_wrong_is_named(marks):
    with pytest.raises(hrbfnpr.InvalidArgumentError, match='density_field of the layer "stipples" is "heat"'):
        drawn(marks, density_field="heat")
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="kind SCALAR; it must be a field of kind COLOUR"):
        drawn(marks, ink_field="height")
