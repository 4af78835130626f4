# SPDX-License-Identifier: MIT
"""Pictures on a ground: `ground` of draw, and --ground."""
import numpy as np
import pytest
from conftest import torus

import hrbfnpr
from hrbfnpr.cli._main import main

pytest.importorskip("PIL.Image")

LIGHT = np.array([0.6, 0.8, 0.1])
PLAIN = {"light": tuple(LIGHT), "light_space": "world", "shadow": 1, "set": {"occlusion": 0}}


def ball(count=800):
    at = np.arange(count) + 0.5
    polar, around = np.arccos(1 - 2 * at / count), np.pi * (1 + 5**0.5) * at
    return np.c_[np.cos(around) * np.sin(polar), np.cos(polar), np.sin(around) * np.sin(polar)]


def drawn(style="scientific-stipple", **options):
    normals = ball()
    given = {"size": 400, "up": "y", "elevation": 50, "ground": True, **PLAIN, **options}
    return hrbfnpr.draw((normals, normals), style, **given)


def rays(picture):
    """The eye, and the direction of the ray of each pixel's middle."""
    width, height = picture.size
    view, projection = (np.array(matrix).reshape(4, 4) for matrix in (picture.camera.view, picture.camera.projection))
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, 1 - (np.arange(height) + 0.5) / height * 2)
    back = np.linalg.inv(projection @ view)
    ends = [np.stack([x, y, np.full_like(x, z), np.ones_like(x)], -1) @ back.T for z in (-1, 1)]
    near, far = (end[..., :3] / end[..., 3:] for end in ends)
    return near, (far - near) / np.linalg.norm(far - near, axis=-1, keepdims=True)


def distance_from_ball(near, along):
    return np.linalg.norm(np.cross(-near, along), axis=-1)


def grown(mask, by):
    result = mask.copy()
    for dy in range(-by, by + 1):
        for dx in range(-by, by + 1):
            result |= np.roll(np.roll(mask, dy, 0), dx, 1)
    return result


@pytest.mark.parametrize("style", ["scientific-stipple", "engraving"])
def test_ground_is_dark_where_the_ball_casts_its_shadow(style):
    picture = drawn(style)
    near, along = rays(picture)
    on_ground = near + along * ((-1 - near[..., 1]) / along[..., 1])[..., None]
    shadow = np.linalg.norm(np.cross(on_ground, LIGHT / np.linalg.norm(LIGHT)), axis=-1) < 1
    is_ball = grown(distance_from_ball(near, along) < 1, 4)  # with its contour
    ink = picture.image[..., 0] < 160
    assert not (ink & ~grown(shadow, 2) & ~is_ball).any()
    inside = ~grown(~shadow, 2) & ~is_ball
    assert inside.sum() > 3000
    assert ink[inside].mean() > 0.25
    rows = np.nonzero(inside.any(1))[0]
    upper, lower = (ink[rows[i]:rows[i] + 30][inside[rows[i]:rows[i] + 30]].mean() for i in (0, -30))
    assert abs(upper - lower) < 0.2  # it is even


def test_ground_is_a_layer_of_its_own(tmp_path):
    picture = drawn("engraving")
    picture.save(tmp_path / "a.svg")
    assert 'inkscape:label="ground"' in (tmp_path / "a.svg").read_text()
    red = drawn("engraving", set={"occlusion": 0, "ground.ink": "#ff0000"})
    inks = red.image[(red.image[..., 0] > 200) & (red.image[..., 1] < 60)]
    assert len(inks) > 1000


def test_ground_does_not_change_the_object():
    """Nor does the light that casts shadows only on the ground."""
    seen = drawn("engraving", shadow=None)
    plain, stands = drawn("engraving", ground=None, shadow=None, camera=seen.camera).image, seen.image
    near, along = rays(seen)
    inside = ~grown(distance_from_ball(near, along) > 0.97, 4)
    assert np.array_equal(plain[inside], stands[inside])
    assert (stands[..., 0] < 128).sum() > (plain[..., 0] < 128).sum() + 1000


def test_fields_of_the_object_are_not_for_the_ground():
    colours = np.tile((1.0, 0.0, 0.0), (800, 1))
    picture = drawn("engraving", fields={"paint": colours}, field="ink=paint", palette=["#ff0000"])
    assert {layer.ink_number for layer in picture.drawing.layers if layer.name == "ground"} == {-1}


def test_ground_has_a_height():
    low, high = (drawn(ground=height, shadow=1) for height in (-1.0005, -2.0))
    assert low._scene.parts[-1].marks.bounds[0][1] == pytest.approx(-1.0005, abs=1e-5)
    assert high._scene.parts[-1].marks.bounds[0][1] == pytest.approx(-2, abs=1e-5)
    assert drawn()._scene.parts[-1].marks.bounds[0][1] == pytest.approx(-1.0, abs=5e-3)


def test_contact_is_dark_without_shadows():
    style = hrbfnpr.Style("scientific-stipple")
    style.light, style.light_space = (0, 1, 0), "world"
    normals = ball()
    picture = hrbfnpr.draw((normals, normals), style, size=400, up="y", ground=-1.3, elevation=30)
    near, along = rays(picture)
    on_ground = near + along * ((-1.3 - near[..., 1]) / along[..., 1])[..., None]
    distance = np.linalg.norm(on_ground[..., (0, 2)], axis=-1)
    seen = ~grown(distance_from_ball(near, along) < 1, 4) & (along[..., 1] < 0)
    ink = picture.image[..., 0] < 160
    shade = [ink[seen & (distance > low) & (distance < low + 0.2)].mean() for low in (0.6, 1.0, 1.9)]
    assert shade[0] > shade[1] > shade[2]
    assert shade[2] < 0.03


@pytest.mark.parametrize("options, why", [
    ({"elevation": -30}, "from below"), ({"visibility": "published", "style": "stipple"}, "depth-layers"),
])  # fmt: skip
def test_notes_say_why_there_is_no_ground(options, why):
    picture = drawn(**options)
    assert [note.code for note in picture.notes if why in str(note)] == ["no_ground"]
    assert len(picture._scene.parts) == 1


def test_marks_without_a_model_have_no_ground():
    points, normals = torus()
    marks = hrbfnpr.Model.fit(points, normals).generate(budget=2000)
    picture = hrbfnpr.draw(marks, size=100, ground=True)
    assert "no_ground" in [note.code for note in picture.notes]


def test_other_cameras_see_the_ground():
    picture = drawn("engraving", shadow=None)
    for seen in (picture.seen(azimuth=120), picture.seen(elevation=80)):
        assert (seen.image[..., 0] < 128).sum() > 0.5 * (picture.image[..., 0] < 128).sum()
    assert picture.drawing.info.items == 2
    assert picture.seen(elevation=-40).drawing.info.items == 1


def test_wrong_grounds_are_refused():
    with pytest.raises(ValueError, match="ground: lowest or the height"):
        drawn(ground="nowhere")
    assert main(["draw", "x.xyzn", "--ground=up"]) == 2


def test_settings_keep_the_ground(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    np.savetxt("ball.xyzn", np.c_[ball(), ball()])
    for option, style in (("--ground", "engraving"), ("--ground=-1.5", "full")):
        call = ["draw", "ball.xyzn", "a.png", "--up", "y", "--size", "200", "--style", style, "-q"]
        assert main([*call[:3], option, *call[3:], "--set", "ground.ink=#204080", "--save-settings", "s.json"]) == 0
        assert main(["draw", "ball.xyzn", "b.png", "--up", "y", "--settings", "s.json", "-q"]) == 0
        assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_sky_is_up():
    for up, sky in (("z", (0, 0, 1)), ("-y", (0, -1, 0))):
        assert drawn("silhouette", up=up, set={"ambient_sky": 0.5}, ground=None).style.ambient_up == sky
    assert drawn("silhouette", up="z", occlusion=0.5, ground=None, set={"ambient_up": "1,0,0"}).style.ambient_up == (1, 0, 0)


def test_borders_of_the_shadow_are_lines_on_the_ground():
    plain = {**PLAIN, "set": {"occlusion": 0, "ground.shown": 0}}
    picture = drawn("silhouette", lines=["contour", "shadow"], hidden="none", **plain)
    near, along = rays(picture)
    on_ground = near + along * ((-1 - near[..., 1]) / along[..., 1])[..., None]
    shadow = np.linalg.norm(np.cross(on_ground, LIGHT / np.linalg.norm(LIGHT)), axis=-1) < 1
    is_ball = grown(distance_from_ball(near, along) < 1, 4)  # with its contour
    ink = picture.image[..., 0] < 200
    assert not (ink & ~is_ball & ~(grown(shadow, 2) & grown(~shadow, 2))).any()
    border = grown(shadow, 1) & ~shadow & ~is_ball
    assert grown(ink, 2)[border].mean() > 0.97 and border.sum() > 100


def test_missing_shadows_are_noted():
    asked = {"ground": None, "lines": ["contour", "shadow"]}
    assert "no_shadows" in {note.code for note in drawn("silhouette", **asked, shadow=0).notes}
    assert "no_shadows" not in {note.code for note in drawn("silhouette", **asked).notes}


def test_object_of_lines_hides_the_ground():
    assert drawn("silhouette").style.hidden_lines == "hide"
    assert drawn("silhouette", ground=None).style.hidden_lines == drawn("silhouette", hidden_lines="attenuate").style.hidden_lines
    assert drawn("silhouette", hidden_lines="attenuate").style.hidden_lines == "attenuate"


def test_weak_shade_leaves_the_ground_white():
    """Hatching of the ground ends at a darkness of 0.08, or darker: 0.07 below the first tone of an engraving."""
    images = []
    for fade in (0.0, 0.07, 0.12):
        picture = drawn("engraving", set={"hatch.hatch_fade": fade})
        is_ball = grown(distance_from_ball(*rays(picture)) < 1, 4)
        images.append((picture.image[..., 0] < 160) & ~is_ball)
    assert (images[0] != images[1]).sum() > 100
    assert (images[1] != images[2]).sum() < 10
