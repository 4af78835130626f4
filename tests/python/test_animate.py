# SPDX-License-Identifier: MIT
"""Turntables: their frames, the file formats, and the command."""
import shutil
import subprocess

import numpy as np
import pytest
from conftest import torus
from test_cli import rows
from test_shapes import write

import hrbfnpr
from hrbfnpr import _movies
from hrbfnpr._scene import angles_of
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

POINTS, NORMALS = torus(14, 6)
BOX = np.array([[x, y, z] for x in (-1.4, 1.4) for y in (-1.4, 1.4) for z in (-0.4, 0.4)])


@pytest.fixture(scope="module")
def turn():
    return hrbfnpr.animate((POINTS, NORMALS), frames=5, size=90, marks=800, up="z")


def images(path):
    picture = Image.open(path)
    result = []
    for number in range(picture.n_frames):
        picture.seek(number)
        result.append(np.asarray(picture.convert("RGBA")))
    return result


def test_a_turn_equals_drawings_by_azimuth(turn):
    assert len(turn) == 5 and turn[0].size == turn[3].size
    centre = np.mean(turn[0].model.bounds, axis=0)
    for number, camera in enumerate(turn.cameras):
        # The view direction is that of `draw` with this azimuth.
        seen = turn[0].seen(azimuth=30 + 72 * number, elevation=20)
        assert np.asarray(camera.view)[2, :3] == pytest.approx(np.asarray(seen.camera.view)[2, :3], abs=1e-9)
        # The eye keeps its distance from the centre.
        away = np.linalg.norm((np.asarray(camera.view) @ [*centre, 1])[:3])
        first = np.linalg.norm((np.asarray(turn.cameras[0].view) @ [*centre, 1])[:3])
        assert away == pytest.approx(first)


def test_every_frame_shows_the_whole_model(turn):
    for image in turn.images():
        edge = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
        assert (edge[:, :3] > 200).all() and (image[..., :3].min(axis=-1) < 128).mean() > 0.01


def test_angles_of_whole_and_partial_turns():
    assert angles_of(4, 360) == [0, 90, 180, 270]
    assert angles_of(4, -720) == [0, -180, -360, -540]
    assert angles_of(4, 90) == [0, 30, 60, 90]
    assert angles_of(1, 90) == angles_of(1, 360) == [0]
    assert angles_of(3, 0) == [0, 0, 0]


def test_lines_keep_their_ids_from_frame_to_frame():
    slow = hrbfnpr.animate((POINTS, NORMALS), frames=4, turn=3, size=200, marks=300, lines="contour")
    numbers = [{int(line["line"][0]) for line in slow[i].drawing.polylines() if line["line"][0]} for i in range(4)]
    assert numbers[0] and all(one == numbers[0] for one in numbers)


def test_gif_and_png_hold_the_frames(turn, tmp_path):
    drawn = list(turn.images())
    turn.save(tmp_path / "a.png")
    for image, wanted in zip(images(tmp_path / "a.png"), drawn):
        assert np.array_equal(image, wanted)
    turn.save(tmp_path / "a.gif")
    shown = images(tmp_path / "a.gif")
    assert len(shown) == 5
    for image, wanted in zip(shown, drawn):
        assert np.abs(image.astype(int) - wanted).max() <= 16
        paper = (wanted == 255).all(axis=-1)
        assert (image[paper] == 255).all()
    for name, delay in (("a.gif", 80), ("a.png", 83)):
        info = Image.open(tmp_path / name).info
        assert info["loop"] == 0 and round(info["duration"]) == delay
    turn.save(tmp_path / "a.apng")
    assert (tmp_path / "a.apng").read_bytes() == (tmp_path / "a.png").read_bytes()
    assert turn._repr_html_().startswith('<img src="data:image/gif;base64,R0lGOD')


def test_a_number_in_the_name_saves_single_pictures(turn, tmp_path):
    turn.save(tmp_path / "frame-%02d.png")
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"frame-0{i}.png" for i in range(5)]
    assert np.array_equal(np.asarray(Image.open(tmp_path / "frame-03.png")), turn[3].image)


def test_transparent_frames_get_white_paper_in_a_gif(tmp_path):
    clear = hrbfnpr.animate((POINTS, NORMALS), tmp_path / "a.gif", frames=2, size=60, marks=300, transparent=True)
    assert next(clear.images())[0, 0, 3] == 0
    assert tuple(images(tmp_path / "a.gif")[0][0, 0]) == (255, 255, 255, 255)
    clear.save(tmp_path / "a.png")
    assert images(tmp_path / "a.png")[1][0, 0, 3] == 0


def test_a_film_has_the_frames(turn, tmp_path):
    if shutil.which("ffmpeg") is None:
        pytest.skip("the program ffmpeg is not installed (Debian: ffmpeg)")
    turn.save(tmp_path / "a.mp4")
    raw = subprocess.run(
        ["ffmpeg", "-loglevel", "error", "-i", tmp_path / "a.mp4", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
        capture_output=True, check=True,
    ).stdout  # fmt: skip
    width, height = (side + side % 2 for side in turn[0].size)
    frames = np.frombuffer(raw, dtype=np.uint8).reshape(-1, height, width, 3)
    assert len(frames) == 5
    for frame, wanted in zip(frames, turn.images()):
        part = frame[: wanted.shape[0], : wanted.shape[1]]
        assert np.abs(part.astype(float) - wanted[..., :3]).mean() < 6


def test_mp4_needs_ffmpeg(turn, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(OSError, match=r"needs the program ffmpeg \(Debian: ffmpeg\)"):
        turn.save(tmp_path / "a.mp4")
    program = tmp_path / "ffmpeg"
    program.write_text("#!/bin/sh\necho no such codec >&2\nexit 3\n")
    program.chmod(0o755)
    with pytest.raises(OSError, match="ffmpeg could not write .*a.mp4: no such codec"):
        turn.save(tmp_path / "a.mp4")
    assert not (tmp_path / "a.mp4").exists()


@pytest.mark.parametrize(
    "options, words",
    [
        ({"frames": 0}, "frames must be at least 1, not 0"),
        ({"fps": 0}, "fps must be above 0"),
        ({"path": "a.avi"}, "a.avi: an animation ends in .gif, .png, .apng, .mp4, or has a number"),
        ({"path": "a-%03d.bmpx"}, "no picture format is known"),
        ({"eye": (0, 0, 90), "target": (0, 0, 99)}, "would be blank"),
    ],
)
def test_invalid_options_are_named(options, words):
    with pytest.raises(ValueError, match=words):
        hrbfnpr.animate((POINTS, NORMALS), size=60, marks=200, **options)


def test_progress_is_reported_per_frame(tmp_path):
    told = []
    hrbfnpr.animate((POINTS, NORMALS), tmp_path / "a.gif", frames=4, size=60, marks=200,
                    progress=lambda stage, fraction: told.append((stage, fraction)))  # fmt: skip
    of_frames = [fraction for stage, fraction in told if stage == "drawing frames"]
    assert of_frames == pytest.approx([0, 0.25, 0.5, 0.75, 1.0]) and ("fitting", 1) in [(s, round(f)) for s, f in told]


def test_a_failure_keeps_the_old_file(turn, tmp_path):
    (tmp_path / "a.gif").write_bytes(b"before")

    def stop(stage, fraction):
        if fraction > 0.5:
            raise KeyError("stop")

    with pytest.raises(KeyError):
        turn.save(tmp_path / "a.gif", progress=stop)
    assert (tmp_path / "a.gif").read_bytes() == b"before" and len(list(tmp_path.iterdir())) == 1


def test_loops_are_written(tmp_path):
    frames = [np.full((4, 4, 4), value, dtype=np.uint8) for value in (0, 255)]
    for loops, repeated in ((0, 0), (1, None), (3, 2)):
        _movies.write(tmp_path / "a.gif", frames, 10, loops, (1, 1, 1, 1))
        assert Image.open(tmp_path / "a.gif").info.get("loop") == repeated
        _movies.write(tmp_path / "a.png", frames, 10, loops, (1, 1, 1, 1))
        assert Image.open(tmp_path / "a.png").info["loop"] == loops


def test_the_command(tmp_path, monkeypatch, capsys):
    path = write(tmp_path, "ring.xyz", rows(np.hstack([POINTS, NORMALS])))
    monkeypatch.chdir(tmp_path)
    assert main(["turntable", str(path), "--frames", "5", "--size", "90", "--marks", "800", "--up", "z"]) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1].startswith("ring.gif: 5 frames of ") and err == ""
    hrbfnpr.animate(path, "call.gif", frames=5, size=90, marks=800, up="z")
    assert (tmp_path / "ring.gif").read_bytes() == (tmp_path / "call.gif").read_bytes()
    for words, code, said in (
        (["--frames", "0"], 2, "the number must be 1 to "),
        (["-o", "a.avi"], 1, "a.avi: an animation ends in"),
        (["-o", "nowhere/a.gif"], 1, "there is no folder nowhere"),
        (["--fps", "-1"], 1, "fps must be above 0"),
        (["--eye", "0,0,90", "--target", "0,0,99", "--marks", "200"], 3, "would be blank"),
    ):
        assert main(["turntable", str(path), *words, "--quiet"]) == code
        assert said in capsys.readouterr().err
