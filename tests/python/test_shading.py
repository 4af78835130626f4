# SPDX-License-Identifier: MIT
"""Occluders and shadings."""
import numpy as np
import pytest
from conftest import torus

import hrbfnpr


@pytest.fixture(scope="module")
def model():
    points, normals = torus()
    return hrbfnpr.Model.fit(points, normals)


def shown(model, item):
    camera = hrbfnpr.Camera.fit(model, (0.3, 1, -0.7), (0, 0, 1), size=(200, 160))
    return hrbfnpr.Renderer().draw(item, camera).info.shown


def test_hollows_are_darker_and_shadows_are_cast(model):
    style = hrbfnpr.Style(ambient_sky=0.3, ambient_ground=0.3, fill_light=0, evenness="surface")
    style.lights = [hrbfnpr.Light(place=(0, 1, 0.2), space="world", intensity=0.5)]
    item = hrbfnpr.Item(model.generate(budget=3000), style, line_set=hrbfnpr.LineSet(model))
    plain = shown(model, item)
    occluders = hrbfnpr.Occluders(item)
    with hrbfnpr.Shading(occluders, item) as shading:
        item.shading = shading
        hollow = shown(model, item)
        assert hollow > plain
        assert len(shading.openness()) == len(item.point_set.layers[0]) and 0 < min(shading.openness()) < 0.9
        with pytest.raises(hrbfnpr.InvalidArgumentError, match="casts no shadow"):
            shading.visible(0)
        style.lights[0].shadow = 1
        item.shading = hrbfnpr.Shading(occluders, item, previous=shading)
        assert shown(model, item) > hollow
        assert {*item.shading.visible(0)} == {0, 1}
        item.shading = shading
    with pytest.raises(ValueError, match="this Shading is closed"):
        shown(model, item)
    hrbfnpr.Occluders(item)  # neither uses the shading of the item, which is closed
    item.shading = hrbfnpr.Shading(occluders, item, sky_rays=16)
    assert shown(model, item) > plain


def test_contrast_of_curvature_darkens_hollows(model):
    """The inner side of a torus bends less than the outer one.  Without light, a tone around 0 shows the former."""
    style = hrbfnpr.Style(light_intensity=0, fill_light=0, curvature_contrast=1, tone_black=-1e-3, tone_white=1e-3,
                          tone_curve="linear", tone_fade=0, hidden_lines="show")  # fmt: skip
    marks = model.generate(budget=6000)
    item = hrbfnpr.Item(marks, style, line_set=hrbfnpr.LineSet(model))
    occluders = hrbfnpr.Occluders(item)
    item.shading = hrbfnpr.Shading(occluders, item)
    camera = hrbfnpr.Camera.fit(model, (0, 0, -1), (0, 1, 0), size=(200, 160))
    drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, shading=item.shading), camera)
    layer = marks.layers[0]
    seen = layer.normals[:, 2] > 0.2
    dark = drawing.mark_results().shown[seen] != 0
    ring = np.hypot(*(layer.positions + marks.origin)[seen, :2].T)
    assert dark[ring < 0.8].mean() > 0.98 and not dark[ring > 1].any()
    item.shading = hrbfnpr.Shading(occluders, item, curvature_scale=0)
    item.line_set = None
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="curvature_contrast is 1, but item.line_set is NULL"):
        hrbfnpr.Shading(occluders, item)


def test_borders_of_shadows_are_lines(model):
    style = hrbfnpr.Style("silhouette", lines=("contour", "shadow", "terminator"))
    style.lights = [hrbfnpr.Light(place=(1, 0.2, 0.4), space="world", shadow=0.5)]
    item = hrbfnpr.Item(model.generate(budget=100), style, line_set=hrbfnpr.LineSet(model))
    camera = hrbfnpr.Camera.fit(model, (0.3, 1, -0.7), (0, 0, 1), size=(200, 160))
    for lines in (False, True):
        item.shading = hrbfnpr.Shading(hrbfnpr.Occluders(item), item, lines=lines)
        drawn = {layer.kind for layer in hrbfnpr.Renderer().draw(item, camera).layers if layer.strokes}
        assert ({"shadow", "terminator"} <= drawn) == lines and "contour" in drawn
    item.line_set = None
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="line_set"):
        hrbfnpr.Shading(hrbfnpr.Occluders(hrbfnpr.Item(item.point_set, line_set=hrbfnpr.LineSet(model))), item, lines=True)


def test_what_is_wrong_is_named(model):
    marks = model.generate(budget=100)
    item = hrbfnpr.Item(marks, line_set=hrbfnpr.LineSet(model))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="line_set"):
        hrbfnpr.Occluders(marks)
    occluders = hrbfnpr.Occluders(item)
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="sky_rays"):
        hrbfnpr.Shading(occluders, item, sky_rays=0)
    operation = hrbfnpr.Operation()
    operation.cancel()
    for call in (lambda: hrbfnpr.Occluders(item, operation=operation),
                 lambda: hrbfnpr.Shading(occluders, item, operation=operation)):  # fmt: skip
        with pytest.raises(hrbfnpr.CancelledError):
            call()
