# SPDX-License-Identifier: MIT
"""The command line from end to end."""
import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import PACKAGE, torus
from test_shapes import CUBE, QUADS, stl, write

import hrbfnpr
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

QUICK = ["--size", "120", "--marks", "1500", "--samples", "60", "--quiet"]


STAGE = r"([a-z ]{12}) +(\d+\.\d\d) s(?:  .*)?"  # a line of the summary


def rows(table):
    return "".join(" ".join(f"{x:.6f}" for x in row) + "\n" for row in table)


@pytest.fixture
def files(tmp_path):
    """A small file of each kind."""
    points, normals = torus(12, 6)
    both = np.hstack([points, normals])
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 72\n"
    header += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + "end_header\n"
    cube = "".join(f"v {x} {y} {z}\n" for x, y, z in CUBE)
    faces = "".join("f " + " ".join(str(i + 1) for i in quad) + "\n" for quad in QUADS)
    off = "OFF\n8 6 0\n" + rows(CUBE) + "".join("4 " + " ".join(map(str, quad)) + "\n" for quad in QUADS)
    return {
        "ply": write(tmp_path, "a.ply", header.encode() + both.astype("<f4").tobytes()),
        "xyz": write(tmp_path, "a.xyz", rows(both)),
        "pwn": write(tmp_path, "a.pwn", "72\n" + rows(points) + rows(normals)),
        "obj": write(tmp_path, "a.obj", cube + faces),
        "stl": write(tmp_path, "a.stl", stl(binary=True)),
        "off": write(tmp_path, "a.off", off),
    }


def ink(path):
    """The share of dark pixels."""
    return (np.asarray(Image.open(path).convert("L")) < 128).mean()


FILES = {
    "draw": "IN {} OUT", "csg": "IN {} OUT", "sheet": "IN {} OUT", "turntable": "IN {} OUT", "sheet-views": "IN {} OUT",
    "fit": "IN {} OUT", "points": "IN {} OUT", "check": "IN {}", "info": "IN {}",
}  # fmt: skip


@pytest.mark.parametrize("command", FILES)
def test_options_may_stand_anywhere(command, capsys):
    from hrbfnpr.cli._grammar import build

    options = ["--json"] if command in ("check", "info") else ["--threads", "2"]
    files = FILES[command].replace("{}", "").split()
    between = " ".join(FILES[command].split()).format(" ".join(options)).split()
    for words in ([*files, *options], [*options, *files], between, [*options, "--quiet", *between]):
        arguments = build().parse_args([command, *words])
        assert arguments.input == "IN" and getattr(arguments, "output", "OUT") == "OUT"
        assert arguments.json if "--json" in words else arguments.threads == 2
    after = build().parse_args([command, *options, "--", *(f"-{name}" for name in files)])
    assert after.input == "-IN" and getattr(after, "output", "-OUT") == "-OUT"
    for wrong in ([*files, "one", "two"], [*files, "--nonsense"], []):
        if command == "info" and not wrong:
            continue
        with pytest.raises(SystemExit):
            build().parse_args([command, *wrong])


@pytest.mark.parametrize("kind", ["ply", "xyz", "pwn", "obj", "stl", "off"])
def test_draw_every_kind(files, tmp_path, kind, capsys):
    if kind == "stl":
        pytest.importorskip("meshio")
    output = tmp_path / "out.png"
    assert main(["draw", str(files[kind]), str(output), *QUICK]) == 0
    assert max(Image.open(output).size) == 120
    assert 0.01 < ink(output) < 0.9
    out, err = capsys.readouterr()
    # 60 samples are few for sharp edges: a warning says so.
    edged = kind in ("obj", "stl", "off")
    assert out == "" and ("% of the mesh is more than 1% of the diagonal off the surface" in err) == edged
    assert all(line.startswith("hrbfnpr: warning: ") for line in err.splitlines()) and bool(err) == edged


def test_the_default_output_and_summary(files, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["draw", str(files["xyz"]), "--size", "100x80", "--marks", "500", "--samples", "50", "--keep-marks"]) == 0
    out, err = capsys.readouterr()
    lines = out.splitlines()
    assert re.fullmatch(r"a\.png: 100 x 80 pixels, 500 marks, \d+\.\d s", lines[-1]) and err == ""
    stages = [re.fullmatch(STAGE, line) for line in lines[:-1]]
    assert all(stages), lines
    names = ["start", "read", "sample", "orient", "fit", "end", "place marks", "trace lines", "frame", "write", "total"]
    assert [stage.group(1).strip() for stage in stages] == names
    seconds = [float(stage.group(2)) for stage in stages]
    assert abs(seconds[-1] - sum(seconds[:-1])) < 0.1 + 0.2 * seconds[-1]
    assert Image.open("a.png").size == (100, 80)


@pytest.mark.parametrize(
    "options",
    [
        ["--kernel", "gaussian", "--kernel-radius", "0.5", "--degree", "0"],
        ["--kernel", "wendland-c2", "--regularization", "0.01", "--solver", "direct", "--refinement-steps", "1"],
        ["--distribution", "published", "--seeds", "box", "--box-resolution", "6", "--box-jitter", "0.1"],
        ["--distribution", "published", "--levels", "stipples=2,hatch=1", "--layers", "stipples,hatch"],
        ["--distribution", "published", "--stroke-start", "stipples", "--start-level", "1", "--style", "combing"],
        ["--separation", "0.1", "--stroke-step", "0.03", "--style", "hatch", "--projection-tolerance", "1e-6"],
        ["--seed-points", "{xyz}", "--distribution", "published", "--levels", "1"],
        ["--marks", "stipples=800", "--random-seed", "9", "--curvature-of", "stipples,hatch"],
        ["--direction", "-1,-1,-0.5", "--up", "-z", "--fov", "0", "--margin", "0.2"],
        ["--azimuth", "-45", "--elevation", "60", "--up", "z", "--fov", "60"],
        ["--eye", "3,2,3", "--target", "0,0,0", "--fov", "40"],
        ["--eye", "-3,2,3", "--fov", "0"],
        ["--light", "-1,0,0", "--light-space", "world", "--tone-exponent", "2", "--tone-rule", "published"],
        ["--light", "1,0,0", "--light-space", "world", "--fill-light", "0.4", "--tone-smoothing", "0.02"],
        ["--tone", "none", "--share", "0.5", "--mark-radius", "0.6", "--ink", "#203040", "--paper", "1,0.9,0.8"],
        ["--hidden-lines", "hide", "--delta", "0.3", "--halo", "4", "--splat-radius", "3", "--splat-overlap", "0"],
        ["--visibility", "published", "--tone-curve", "linear", "--tone-fade", "0"],
        ["--visibility", "depth-layers", "--tone-curve", "coverage"],
        ["--attenuation-front", "0.5", "--attenuation-back", "0.2", "--style", "silhouette"],
        ["--depth-range", "2,9", "--zoom-reference", "50", "--zoom-exponent", "1"],
        ["--silhouette-ink", "#ff0000", "--silhouette-radius", "2", "--visibility", "published"],
        ["--set", "stipples.radius=2", "--set", "stipples.shown=true", "--set", "tone=none"],
        ["--set", "stipples.shown=true", "--set", "hatch.directions=first", "--style", "cross-hatch"],
        ["--set", "light=y", "--set", "stipples.ink=#ff0000", "--set", "hatch.contours=0"],
        ["--shape", "strokes", "--style", "hatch"],
        ["--guide", "light", "--guide-direction", "1,2,3", "--guide-weight", "0.5", "--style", "engraving"],
        ["--lines", "contour,suggestive,ridges,valleys,apparent,parabolic,border", "--style", "silhouette"],
        ["--lines", "contour,section=z:5,isophotes=0.2:0.6", "--hidden", "dashed", "--line-width", "1.5"],
        ["--lines", "none", "--style", "hatch"],
        ["--outline", "2", "--far-lines", "0.5", "--lit-lines", "0.5", "--sharp-lines", "0.5", "--wobble", "0.5"],
        ["--tone-ranges", "in-turn", "--style", "full", "--set", "hatch.shape=strokes"],
        ["--distribution", "published", "--style", "full"],
        ["--scale-bar", "mm", "--profile", "yes", "--lines", "ridges", "--style", "hatch"],
        ["--style", "archaeological", "--profile", "no", "--scale-bar", "none", "--fov", "30"],
        ["--tone-ranges", "in-turn", "--shared-marks", "3000", "--layers", "stipples,hatch"],
        ["--crease", "30", "--threads", "1", "--max-centres", "100"],
    ],
)  # fmt: skip
def test_every_option(files, tmp_path, options, capsys):
    options = [word.format(**files) for word in options]
    output = tmp_path / "out.png"
    code = main(["draw", str(files["xyz"]), str(output), *QUICK, *options])
    if options[:2] == ["--set", "stipples.radius=2"]:  # --set cannot set "tone"
        assert code == 2
        return
    assert code == 0, capsys.readouterr().err
    assert ink(output) > 0.0005


def test_transparent_paper_and_other_formats(files, tmp_path):
    output = tmp_path / "out.png"
    assert main(["draw", str(files["ply"]), str(output), *QUICK, "--transparent"]) == 0
    alpha = np.asarray(Image.open(output))[..., 3]
    assert alpha[0, 0] == 0 and alpha.max() == 255
    assert main(["draw", str(files["ply"]), str(tmp_path / "out.tif"), *QUICK]) == 0
    assert Image.open(tmp_path / "out.tif").format == "TIFF"


def test_fit_points_draw_and_info(files, tmp_path, capsys):
    model, marks, ply = (str(tmp_path / name) for name in ("m.hrbf", "m.hrbp", "m.ply"))
    assert main(["fit", str(files["xyz"]), model]) == 0
    assert "72 centres" in capsys.readouterr().out
    assert main(["points", model, marks, "--layers", "stipples,hatch", "--marks", "900", "--levels", "2"]) == 0
    assert "marks" in capsys.readouterr().out
    assert main(["points", model, ply, "--marks", "900", "-q"]) == 0
    saved = hrbfnpr.PointSet.load(marks)
    assert [layer.name for layer in saved.layers] == ["stipples", "hatch"]
    exported = hrbfnpr.shapes.read(ply)
    assert len(exported.points) == len(saved.layer("stipples")) and exported.normals is not None
    first, second = str(tmp_path / "1.png"), str(tmp_path / "2.png")
    again = str(tmp_path / "again.hrbp")
    assert main(["draw", model, first, *QUICK, "--save-points", again, "--save-model", model + "2"]) == 0
    assert main(["draw", again, second, *QUICK]) == 0
    assert ink(second) > 0.01 and os.path.exists(model + "2")
    capsys.readouterr()
    for path, kind in ((model, "model"), (marks, "point set"), (ply, "points"), (str(files["obj"]), "mesh")):
        assert main(["info", path]) == 0
        assert f"kind: {kind}" in capsys.readouterr().out
        assert main(["info", path, "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["kind"] == kind
    assert main(["info"]) == 0
    assert f"version: {hrbfnpr.__version__}" in capsys.readouterr().out
    assert main(["info", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["thread_count"] >= 1


def test_large_point_sets_are_thinned(tmp_path, capsys):
    points = np.random.default_rng(1).normal(size=(5000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    path = write(tmp_path, "big.xyz", rows(np.hstack([points, points])))
    assert main(["fit", str(path), str(tmp_path / "m"), "--samples", "30"]) == 0
    assert "30 centres" in capsys.readouterr().out


def test_fit_chooses_centres_from_all_points(tmp_path, capsys):
    points = np.random.default_rng(1).normal(size=(5000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    path, model = write(tmp_path, "big.xyz", rows(np.hstack([points, points]))), str(tmp_path / "m")
    options = ["--tolerance", "1e-3", "--outliers", "drop", "--flipped-normals", "reorient", "--regularization", "auto"]
    assert main(["fit", str(path), model, *options, "--max-centres", "900"]) == 0
    info = hrbfnpr.Model.load(model).info
    assert info.samples == 5000 and info.centres < 900 and info.input_share_within == 1
    assert "points are used" not in capsys.readouterr().err
    assert main(["fit", str(path), model, "--max-centres", "50"]) == 0
    assert "50 centres" in capsys.readouterr().out


def test_unusable_points_are_left_out_with_a_note(tmp_path, capsys):
    points, normals = torus(12, 6)
    normals[3] = 0
    path = write(tmp_path, "a.xyz", rows(np.hstack([points, normals])))
    assert main(["fit", str(path), str(tmp_path / "m")]) == 0
    out, err = capsys.readouterr()
    assert "71 centres" in out and err == "hrbfnpr: note: 1 point left out: without a usable position or normal\n"


# --- failures ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "arguments, code, words",
    [
        ([], 2, "COMMAND"),
        (["paint"], 2, "invalid choice: 'paint'"),
        (["draw"], 2, "INPUT"),
        (["draw", "{xyz}", "--style", "cubist"], 2, "cubist"),
        (["draw", "{xyz}", "--size", "0x10"], 2, "at least 1|1 to 32768"),
        (["draw", "{xyz}", "--size", "99999"], 2, "1 to 32768"),
        (["draw", "{xyz}", "--size", "1x2x3"], 2, "WIDTHxHEIGHT"),
        (["draw", "{xyz}", "--samples", "many"], 2, "whole number"),
        (["draw", "{xyz}", "--samples", "0"], 2, "at least 1"),
        (["draw", "{xyz}", "--light", "1,2"], 2, "3 numbers"),
        (["draw", "{xyz}", "--light", "0,0,0"], 2, "0,0,0"),
        (["draw", "{xyz}", "--up", "up"], 2, "3 numbers"),
        (["draw", "{xyz}", "--ink", "blue"], 2, "#rrggbb"),
        (["draw", "{xyz}", "--depth-range", "5,1"], 2, "MIN < MAX"),
        (["draw", "{xyz}", "--marks", "dots=3"], 2, "there is no layer 'dots'; there are stipples"),
        (["draw", "{xyz}", "--kernel-radius", "nan"], 2, "finite"),
        (["draw", "{xyz}", "--set", "colour=3"], 2, "no field 'colour'"),
        (["draw", "{xyz}", "--set", "radius"], 2, "FIELD=VALUE"),
        (["draw", "{xyz}", "--set", "tone_exponent=x"], 2, "number is needed"),
        (["draw", "{xyz}", "--set", "stipples.shown=maybe"], 2, "true or false"),
        (["draw", "{xyz}", "--degree", "-2"], 2, "-1 to 3"),
        (["draw", "{xyz}", "--unknown"], 2, "unrecognized"),
        (["draw", "missing.xyz"], 1, "missing.xyz: No such file"),
        (["draw", "."], 1, "directory"),
        (["draw", "{xyz}", "/nowhere/out.png"], 1, "/nowhere/out.png: there is no folder /nowhere$"),
        (["draw", "{xyz}", "."], 1, r"\.: it is a folder"),
        (["draw", "{xyz}", "out.png", "--save-model", "/nowhere/m"], 1, "/nowhere/m: there is no folder"),
        (["draw", "{xyz}", "out.png", "--save-points", "m.xyz"], 1, "m.xyz: a point set cannot be saved as .xyz"),
        (["fit", "{xyz}", "/nowhere/m"], 1, "/nowhere/m: there is no folder"),
        (["fit", "{xyz}", "m.stl"], 1, "m.stl: a model cannot be saved as .stl: use .hrbf"),
        (["points", "{xyz}", "m.obj"], 1, "m.obj: a point set cannot be saved as .obj: use .hrbm, or .ply"),
        (["draw", "{xyz}", "out.psd"], 1, "no picture format"),
        (["draw", "{xyz}", "out.bmpx"], 1, "no picture format"),
        (["draw", "{xyz}", "--box-jitter", "0.9"], 1, "box_jitter"),
        (["draw", "{xyz}", "--layers", "hatch", "--separation", "50"], 1, "use a smaller separation"),
        (["draw", "{xyz}", "--style", "xray", "--lines", "none"], 3, "nothing is drawn"),
        (["draw", "{xyz}", "--tone-exponent", "-1"], 1, "tone_exponent"),
        (["draw", "{xyz}", "--direction", "0,1,0"], 1, "up"),
        (["draw", "{xyz}", "--tolerance", "-1"], 1, "tolerance"),
        (["draw", "{xyz}", "--regularization", "some"], 2, "number is needed"),
        (["draw", "{xyz}", "--outliers", "reorient"], 2, "outliers"),
        (["draw", "bad.xyz"], 1, "bad.xyz: line 1: a line holds x y z.*; this line holds 2 numbers"),
        (["draw", "bad.ply"], 1, "bad.ply: not a PLY"),
        (["draw", "bad.hrbf"], 1, "bad.hrbf: "),
        (["draw", "flat.xyz"], 1, "at least 4 different ones are needed"),
        (["draw", "bad.stl"], 1, "bad.stl: "),
        (["fit", "bad.xyz", "out"], 1, "bad.xyz"),
        (["fit", "{xyz}"], 2, "OUTPUT"),
        (["points", "marks.hrbp", "out"], 2, "point set, so its marks are placed already"),
        (["fit", "marks.hrbp", "out"], 2, "holds a point set"),
        (["info", "bad.ply"], 1, "bad.ply"),
        (["info", "missing"], 1, "missing: No such file"),
    ],
)
def test_bad_command_lines(files, marks, tmp_path, monkeypatch, capsys, arguments, code, words):
    import re

    monkeypatch.chdir(tmp_path)
    write(tmp_path, "bad.xyz", "1 2\n")
    write(tmp_path, "bad.ply", "nothing")
    write(tmp_path, "bad.hrbf", b"\x89HRB\r\n\x1a\n" + bytes(100))
    write(tmp_path, "bad.stl", b"")
    write(tmp_path, "flat.xyz", "1 2 3\n4 5 6\n")
    marks.save(tmp_path / "marks.hrbp")
    before = sorted(tmp_path.iterdir())
    quick = ["--marks", "100", "--size", "50"] if arguments[:1] == ["draw"] else []
    given = [word.format(**files) for word in arguments]
    given[2:2] = [word for word in quick if "--marks" not in arguments and "--size" not in arguments]
    if arguments[:1] == ["draw"] and len(arguments) > 2 and not arguments[2].startswith("-"):
        given = [*[word.format(**files) for word in arguments], *quick]
    assert main(given) == code
    out, err = capsys.readouterr()
    assert all(re.fullmatch(STAGE, line) for line in out.splitlines()), out
    assert err.startswith("hrbfnpr: error: ") and err.count("\n") == 1, err
    assert re.search(words, err), err
    assert sorted(tmp_path.iterdir()) == before  # no file is left


def test_help_and_version(capsys):
    for command in ([], ["draw"], ["sheet"], ["fit"], ["points"], ["info"]):
        assert main([*command, "--help"]) == 0
        assert "usage: hrbfnpr" in capsys.readouterr().out
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"hrbfnpr {hrbfnpr.__version__}\n"


def test_only_the_options_of_the_command_in_use_are_added():
    from hrbfnpr.cli import _grammar

    parser = _grammar.build()
    commands = next(action for action in parser._actions if action.dest == "command").choices
    arguments = parser.parse_args(["draw", "x.ply", "--size", "300"])
    assert arguments.option_size == 300
    assert len(commands["draw"]._actions) > 50 and len(commands["sheet"]._actions) == 1  # 1: --help
    assert parser.parse_args(["draw", "y.ply"]).input == "y.ply"


def test_a_failed_output_is_not_half_written(files, tmp_path, monkeypatch):
    from PIL import Image as pil

    output = tmp_path / "out.png"
    output.write_bytes(b"the picture of before")

    def fail(self, file, format):
        file.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(pil.Image, "save", fail)
    assert main(["draw", str(files["xyz"]), str(output), *QUICK]) == 1
    assert output.read_bytes() == b"the picture of before"
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]


def process(*arguments, **options):
    return subprocess.Popen(
        [sys.executable, "-m", "hrbfnpr", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(PACKAGE)},
        **options,
    )


def test_the_module_runs_as_a_program(files, tmp_path):
    with process("draw", str(files["ply"]), str(tmp_path / "out.png"), *QUICK[:-1], "--keep-marks") as run:
        out, err = run.communicate(timeout=60)
    assert (run.returncode, err) == (0, "") and "x 120 pixels, 1500 marks" in out


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_c(tmp_path):
    import signal

    points = np.random.default_rng(1).normal(size=(3500, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    path = write(tmp_path, "big.xyz", rows(np.hstack([points, points])))
    output = tmp_path / "out.png"
    with process("draw", str(path), str(output), "--solver", "direct") as run:
        while not run.stdout.readline().startswith("read "):  # the fit follows, and takes minutes
            assert run.poll() is None
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=60)
    assert (run.returncode, err) == (130, "hrbfnpr: error: interrupted\n")
    assert out == "" or re.fullmatch(STAGE, out.splitlines()[-1])
    assert not output.exists()


def test_progress_bars_appear_on_terminals_only(files, tmp_path):
    pytest.importorskip("tqdm")
    pty = pytest.importorskip("pty")
    reader, writer = pty.openpty()
    run = subprocess.Popen(
        [sys.executable, "-m", "hrbfnpr", "draw", str(files["ply"]), str(tmp_path / "o.png"), *QUICK[:-1]],
        stdout=subprocess.PIPE,
        stderr=writer,
        env={**os.environ, "PYTHONPATH": str(PACKAGE)},
    )
    os.close(writer)
    text = b""
    while True:
        try:
            part = os.read(reader, 4096)
        except OSError:
            break
        if not part:
            break
        text += part
    os.close(reader)
    run.communicate(timeout=60)
    for stage in (b"fitting", b"placing marks", b"drawing", b"100%"):
        assert stage in text
    assert b"/1" not in text  # and no fraction with all its digits
