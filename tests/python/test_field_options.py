# SPDX-License-Identifier: MIT
"""Values of points change drawings: --field and --palette, and the arguments of hrbfnpr.draw."""
import json
import re
import warnings

import numpy as np
import pytest
from conftest import fibonacci_sphere

import hrbfnpr
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

BALL = fibonacci_sphere(600)
QUICK = {"size": 200, "marks": 12000, "samples": 200, "azimuth": 0, "elevation": 0, "lines": "none", "allow_blank": True}
LEFT, UP = BALL[:, 0], BALL[:, 1]  # seen from the front, x runs to the right and y upward
HUES = np.where(LEFT[:, None] < 0, [0.8, 0.2, 0.2], [0.2, 0.3, 0.9])


def drawn(style="stipple", **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return hrbfnpr.draw((BALL, BALL), style, **{**QUICK, **options})


def darkness(picture, part=slice(None)):
    """The mean darkness of the disc's middle rows, in columns that are a part of the width."""
    image = 1 - picture.image[..., :3].mean(axis=-1) / 255
    height, width = image.shape
    return image[height // 4 : -height // 4, part].mean()


def halves(picture):
    half = picture.size[0] // 2
    return darkness(picture, slice(0, half)), darkness(picture, slice(half, None))


@pytest.fixture(scope="module")
def plain():
    return drawn()


def test_a_tone_is_the_value(plain):
    ramp = drawn(fields={"height": LEFT}, field="tone=height")
    left, right = halves(ramp)
    assert left > 2 * right
    left, right = halves(drawn(fields={"height": LEFT}, field={"tone": "-height"}))
    assert right > 2 * left
    flat = drawn(fields={"height": LEFT}, field="tone=height:-1000..1000")
    assert abs(np.subtract(*halves(flat))) < 0.05 * darkness(flat)
    # Values of exactly 1 leave white paper, whatever the light does.
    assert darkness(drawn(fields={"one": np.ones(600)}, field="tone=one")) < 0.01 < darkness(plain)


def test_a_mask_leaves_marks_out(plain):
    masked = drawn(fields={"good": (LEFT > 0).astype(float)}, field="mask=good")
    left, right = halves(masked)
    assert left < 0.2 * halves(plain)[0] and abs(right - halves(plain)[1]) < 0.2 * right
    lines = drawn("hatch", fields={"good": (LEFT > 0).astype(float)}, field="mask=good")
    assert halves(lines)[0] < 0.2 * halves(lines)[1]


def test_density_and_width_thin_the_marks(plain):
    for use in ("density", "width"):
        left, right = halves(drawn(fields={"side": (LEFT + 1) / 2}, field=f"{use}=side:0..1"))
        assert left < 0.6 * halves(plain)[0] and left / right < 0.6 * halves(plain)[0] / halves(plain)[1]


def test_directions_turn_the_hatching():
    def slope(way):
        flow = np.tile(way, (600, 1)).astype(float)
        options = {"fields": {"flow": flow}, "field": "direction=flow", "separation": 0.15, "tone": "none"}
        image = drawn("hatch", **options).image[70:130, 70:130, 0].astype(float)
        down, across = np.gradient(image)
        return np.abs(down).sum() / np.abs(across).sum()

    assert slope([1, 0, 0]) > 2 > 0.5 > slope([0, 1, 0])


def test_inks_come_from_the_palette():
    picture = drawn("stipple", fields={"rgb": HUES}, field="ink=rgb", palette=["#801010", (0.0, 0.0, 0.5)], tone="none")
    image = picture.image[..., :3].astype(int)
    red, blue = (image[..., 0] > image[..., 2] + 60), (image[..., 2] > image[..., 0] + 60)
    half = image.shape[1] // 2
    assert red[:, : half - 12].sum() > 500 and red[:, half + 12 :].sum() == 0
    assert blue[:, half + 12 :].sum() > 500 and blue[:, : half - 12].sum() == 0
    bytes_ = (255 * HUES).round().astype(np.uint8)
    again = drawn("stipple", fields={"hue": bytes_}, field="ink=colour", palette="#801010,#000080", tone="none")
    assert np.array_equal(again.image, picture.image)


def test_a_palette_is_chosen_from_the_colours():
    picture = drawn(fields={"rgb": HUES}, field="ink=rgb")
    note = next(note for note in picture.notes if note.code == "palette_chosen")
    inks = re.findall("#[0-9a-f]{6}", str(note))
    assert len(inks) == note.figures[0] >= 2
    parts = np.array([[int(ink[i : i + 2], 16) for i in (1, 3, 5)] for ink in inks])
    assert (parts[:, 0] > parts[:, 2] + 60).any() and (parts[:, 2] > parts[:, 0] + 60).any()
    assert (parts @ [0.2126, 0.7152, 0.0722]).max() < 130  # rather dark
    assert np.array_equal(drawn(fields={"rgb": HUES}, field="ink=rgb", palette=inks).image, picture.image)


def test_colours_in_place_of_numbers_are_their_luminance():
    light = HUES @ [0.2126, 0.7152, 0.0722]
    by_colour = drawn(fields={"rgb": HUES}, field="tone=rgb")
    by_number = drawn(fields={"light": light}, field=f"tone=light:0..1")
    assert np.abs(by_colour.image.astype(int) - by_number.image).mean() < 0.5


def test_what_is_wrong_is_named():
    with pytest.raises(ValueError, match=r"field names qualty, which the source does not have; it has quality, rgb"):
        drawn(fields={"quality": UP, "rgb": HUES}, field="tone=qualty")
    with pytest.raises(ValueError, match="the source has no values at its points"):
        drawn(field="tone=quality")
    with pytest.raises(ValueError, match="holds numbers; this use needs colours"):
        drawn(fields={"quality": UP}, field="ink=quality")
    with pytest.raises(ValueError, match=r"fields\['quality'\] must hold numbers of the shape \(600,\)"):
        drawn(fields={"quality": UP[:-1]}, field="tone=quality")
    with pytest.raises(ValueError, match="must be USE=NAME"):
        drawn(field="hue=quality")
    with pytest.raises(ValueError, match="at most 8 inks"):
        drawn(palette=["#000000"] * 9)
    with pytest.raises(ValueError, match="a model and saved marks have no points"):
        hrbfnpr.draw(drawn().model, fields={"quality": UP}, field="tone=quality")
    with pytest.raises(ValueError, match="not 'red'"):
        drawn(palette="red")


# --- files -------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def ply(tmp_path_factory):
    path = tmp_path_factory.mktemp("fields") / "ball.ply"
    table = np.zeros(600, [*((name, "<f4") for name in ("x", "y", "z", "nx", "ny", "nz", "quality")),
                           *((name, "u1") for name in ("red", "green", "blue"))])  # fmt: skip
    for i, axis in enumerate("xyz"):
        table[axis] = table[f"n{axis}"] = BALL[:, i]
    table["quality"] = LEFT
    for i, name in enumerate(("red", "green", "blue")):
        table[name] = np.round(255 * HUES[:, i])
    names = "".join(f"property {'uchar' if kind == '|u1' else 'float'} {name}\n" for name, kind in table.dtype.descr)
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex 600\n{names}end_header\n"
    path.write_bytes(head.encode() + table.tobytes())
    return path


FEW = ("--size", "160x120", "--marks", "4000", "--style", "stipple", "--azimuth", "0", "--elevation", "0", "-q")


def pixels(path):
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def test_the_command_line_equals_python(tmp_path, ply):
    out = tmp_path / "a.png"
    assert main(["draw", str(ply), str(out), *FEW, "--field", "tone=quality", "--field", "ink=rgb", "--palette",
                 "#801010,#000080"]) == 0  # fmt: skip
    same = {"size": (160, 120), "marks": 4000, "azimuth": 0, "elevation": 0}
    picture = hrbfnpr.draw(ply, "stipple", field=["tone=quality", "ink=rgb"], palette="#801010,#000080", **same)
    assert np.array_equal(picture.image[..., :3], pixels(out))
    assert {"rgb", "quality"} <= set(hrbfnpr.shapes.read(ply).fields)


def test_settings_keep_fields_and_inks(tmp_path, ply, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["draw", str(ply), "a.png", *FEW, "--field", "tone=-quality:-1..0.5,ink=rgb", "--save-settings", "s.json"]) == 0
    saved = json.loads((tmp_path / "s.json").read_text())
    assert saved["style"]["layers"][0]["tone_field"] == "-quality:-1..0.5" and len(saved["style"]["palette"]) >= 2
    assert main(["draw", str(ply), "b.png", "--settings", "s.json", "-q"]) == 0
    assert np.array_equal(pixels("a.png"), pixels("b.png"))
    assert main(["draw", str(ply), "c.png", "--settings", "s.json", "--field", "tone=,ink=", "-q"]) == 0
    assert main(["draw", str(ply), "d.png", *FEW]) == 0
    assert np.array_equal(pixels("c.png"), pixels("d.png"))


def test_settings_keep_the_direction(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    np.savez("ball.npz", points=BALL, normals=BALL, flow=np.cross(BALL, [1.0, 0, 0]))
    words = ["--size", "120", "--style", "hatch", "--separation", "0.2", "-q"]
    assert main(["draw", "ball.npz", "a.png", *words, "--field", "direction=flow", "--save-settings", "s.json"]) == 0
    assert main(["draw", "ball.npz", "b.png", "--settings", "s.json", "-q"]) == 0
    assert main(["draw", "ball.npz", "c.png", *words]) == 0
    assert np.array_equal(pixels("a.png"), pixels("b.png")) and not np.array_equal(pixels("a.png"), pixels("c.png"))


def test_saved_marks_keep_their_values(tmp_path):
    picture = drawn(fields={"quality": LEFT, "rgb": HUES}, field="tone=quality", keep_marks=True)
    picture.marks.save(tmp_path / "ball.hrb")
    size = {"size": 200, "azimuth": 0, "elevation": 0, "allow_blank": True}
    again = hrbfnpr.draw(tmp_path / "ball.hrb", "stipple", field="tone=quality", **size)
    left, right = halves(again)
    assert left > 2 * right
    with pytest.raises(ValueError, match="field names rgb, which the marks do not have; they have quality"):
        hrbfnpr.draw(tmp_path / "ball.hrb", "stipple", field="tone=rgb", **size)


def test_vectors_have_a_layer_for_each_ink(tmp_path, ply):
    for name in ("a.svg", "a.hpgl"):
        assert main(["draw", str(ply), str(tmp_path / name), *FEW, "--field", "ink=rgb", "--palette", "#801010,#000080"]) == 0
    svg = (tmp_path / "a.svg").read_text()
    assert "#801010" in svg and "#000080" in svg
    assert len(set(re.findall(r"SP[1-9];", (tmp_path / "a.hpgl").read_text()))) == 2


def test_pictures_without_fields_get_no_values(ply, monkeypatch):
    from hrbfnpr import _request

    monkeypatch.setattr(_request, "_fill_fields", lambda *_: pytest.fail("values of points are passed"))
    hrbfnpr.draw(ply, "stipple", **QUICK)


def test_a_still_has_the_marks_and_values_that_its_camera_needs():
    asked = {"fields": {"right": LEFT, "hue": HUES}, "field": "tone=right:-1..1,ink=hue"}
    still, whole = drawn(**asked), drawn(**asked, keep_marks=True)
    assert still.drawing.info.marks < 0.8 * whole.drawing.info.marks
    assert halves(still) == pytest.approx(halves(whole), rel=0.05)
    # The first drawing by another camera needs the other marks, with their values.
    behind = still.seen(azimuth=180)
    assert behind.drawing.info.marks == whole.drawing.info.marks
    assert halves(behind) == pytest.approx(halves(whole.seen(azimuth=180)), rel=0.05)
    assert halves(behind)[0] < halves(behind)[1]
