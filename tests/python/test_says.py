# SPDX-License-Identifier: MIT
"""What the command line finds out by itself, says and refuses: normals, up, blank pictures, outputs, seconds."""
import io
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import PACKAGE, fibonacci_sphere, torus
from looks import hangs, look, up_of
from test_input import ball, obj, table, tube
from test_meshes import glb, gltf
from test_shapes import CUBE, QUADS, stl, write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

QUICK = ["--size", "100", "--marks", "600"]


def draw(path, output, *options):
    return main(["draw", str(path), str(output), *QUICK, *options])


# --- parts -------------------------------------------------------------------------------------


def test_parts_that_a_fit_may_join_are_warned_of(tmp_path, capsys):
    vertices, faces = tube()
    for gap, warned in ((0.01, True), (0.5, False)):
        beside = [[i + len(vertices) for i in face] for face in faces]
        path = write(tmp_path, "tubes.obj", obj(np.vstack([vertices, vertices + [2 + gap, 0, 0]]), faces + beside))
        for edges in ("smooth", "30"):
            assert draw(path, tmp_path / "tubes.png", "--tolerance", "0.05", "--edges", edges) == 0
            said = "are nearer to each other than the tolerance" in capsys.readouterr().err
            assert said == warned, edges


def test_what_coarse_faces_are_taken_for(tmp_path, capsys):
    angle = 2 * np.pi * np.arange(16) / 16  # a prism, or a cylinder
    rings = [np.column_stack([np.cos(angle), 0 * angle + y, np.sin(angle)]) for y in (0, 1)]
    sides = [[i, 16 + i, 16 + (i + 1) % 16, (i + 1) % 16] for i in range(16)]
    path = write(tmp_path, "prism.obj", obj(np.vstack(rings), [*sides, list(range(16)), list(range(31, 15, -1))]))
    assert draw(path, tmp_path / "round.png") == 0
    assert "what is round bulges over them: if they are flat, --edges 5" in capsys.readouterr().err
    assert draw(path, tmp_path / "flat.png", "--edges", "5") == 0
    assert "is not within" not in capsys.readouterr().err


# --- normals -----------------------------------------------------------------------------------


def test_normals_that_are_turned_make_the_same_picture(tmp_path, capsys):
    points, normals = torus(24, 12)
    for name, sign in (("a", 1), ("b", -1)):
        assert draw(write(tmp_path, f"{name}.xyz", table(points, sign * normals)), tmp_path / f"{name}.png") == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert capsys.readouterr().err.count("inward") == 1


def knot(count=900):
    """A tube about a trefoil: thin, and near to itself."""
    t, a = 2 * np.pi * np.arange(count) / count, np.pi * (1 + 5**0.5) * np.arange(count)
    centre = np.column_stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)])
    along = np.gradient(centre, axis=0)
    across = np.cross(along, [0.3, 0.2, 1.0])
    across /= np.linalg.norm(across, axis=1)[:, None]
    other = np.cross(along, across)
    other /= np.linalg.norm(other, axis=1)[:, None]
    normals = np.cos(a)[:, None] * across + np.sin(a)[:, None] * other
    return centre + 0.35 * normals, normals


def plates(distance):
    """Two sheets that look away from each other, and the rim between them."""
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, 21)]), axis=-1).reshape(-1, 2)
    up = np.column_stack([grid, np.full(len(grid), distance / 2)])
    return np.vstack([up, up * [1, 1, -1]]), np.repeat([[0.0, 0, 1], [0, 0, -1]], len(grid), axis=0)


@pytest.mark.parametrize("make", [lambda: ball(3.0), lambda: torus(24, 12), knot, lambda: plates(0.15)])
def test_which_way_normals_look(make):
    points, normals = make()
    random = np.random.default_rng(5)
    right = look(points, normals)
    assert right.closed > 0.6 and not right.inward and not right.mixed
    assert look(points, -normals).inward
    for share in (0.05, 0.3):
        wrong = random.random(len(points)) < share
        found = look(points, np.where(wrong[:, None], -normals, normals))
        assert found.mixed and not found.inward
        assert found.flipped == pytest.approx(wrong.mean(), abs=0.1)


def test_walls_that_are_too_thin_to_tell_are_left_alone():
    points, normals = plates(0.05)  # half as far apart as the samples
    for sign in (1, -1):
        found = look(points, sign * normals)
        assert not found.inward and not found.mixed


def test_every_fourth_normal_turned_over_is_mixed():
    points, normals = ball()
    found = look(points, np.where(np.arange(200)[:, None] % 4 == 0, -normals, normals))
    assert found.mixed and found.flipped == pytest.approx(0.25, abs=0.05)


def test_half_of_a_closed_surface_turned_over_is_mixed():
    points, normals = torus(30, 14)
    normals = np.where(points[:, :1] > 0, normals, -normals)
    assert look(points, normals).mixed


def test_sheets_are_left_as_they_are():
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, 25)]), axis=-1).reshape(-1, 2)
    points = np.column_stack([grid, 0.2 * np.sin(3 * grid[:, 0])])
    normals = np.column_stack([-0.6 * np.cos(3 * grid[:, 0]), 0 * grid[:, 0], np.ones(len(grid))])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    for sign in (1, -1):
        found = look(points, sign * normals)
        assert not found.inward and not found.mixed and abs(found.closed) < 0.25
    # Of a scan from one side, a part of a ball, the sign can be told, but not for sure.
    half = fibonacci_sphere(600)
    half = half[half[:, 2] > 0]
    found = look(half, -half)
    assert not found.inward or found.closed < -0.5


def test_uneven_points():
    points = fibonacci_sphere(3000)
    keep = np.random.default_rng(1).random(3000) < np.where(points[:, 2] > 0, 1.0, 0.05)
    points = points[keep]
    assert look(points, -points).inward and look(points, points).closed > 0.7


# --- up ----------------------------------------------------------------------------------------


def turned(shape):
    """Up along z instead of y."""
    turn = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    normals = None if shape.normals is None else shape.normals @ turn.T
    return shapes.Shape(shape.points @ turn.T, normals, shape.triangles)


def goblet():
    """A body of revolution about y with a foot and a lid."""
    heights = np.array([0, 0, 0.05, 0.1, 0.7, 0.9, 1.4, 1.7, 2.2])
    radii = np.array([0, 0.5, 0.5, 0.1, 0.1, 0.4, 0.6, 0.5, 0])
    angle = 2 * np.pi * np.arange(32) / 32
    rings = zip(heights, radii)
    vertices = np.vstack([np.column_stack([r * np.cos(angle), 0 * angle + h, r * np.sin(angle)]) for h, r in rings])
    faces = []
    for ring in range(len(heights) - 1):
        for i in range(32):
            a, b = ring * 32 + i, ring * 32 + (i + 1) % 32
            faces += [[a, a + 32, b + 32], [a, b + 32, b]]
    return shapes.Shape(vertices, None, np.array(faces))


def terrain(relief):
    grid = np.stack(np.meshgrid(np.linspace(-6, 6, 40), np.linspace(-5, 5, 34)), axis=-1).reshape(-1, 2)
    heights = relief * np.sin(grid[:, 0]) * np.cos(0.8 * grid[:, 1])
    x, y = grid[:, 0], 0.8 * grid[:, 1]
    slope = relief * np.column_stack([np.cos(x) * np.cos(y), -0.8 * np.sin(x) * np.sin(y)])
    normals = np.column_stack([-slope, np.ones(len(grid))])
    return shapes.Shape(np.column_stack([grid[:, 0], grid[:, 1], heights + 1200]), normals)


def test_up_by_the_shape():
    away = shapes.Shape(goblet().points + 7, None, goblet().triangles)
    for shape in (goblet(), away):
        assert up_of(shape) == "y" and up_of(turned(shape)) == "z"
    assert up_of(terrain(0.6)) == "z"
    lying = terrain(0.6)  # with y up
    assert up_of(shapes.Shape(lying.points[:, [0, 2, 1]], lying.normals[:, [0, 2, 1]])) == "y"
    assert up_of(terrain(4.0)) == "y" and up_of(terrain(0.0)) == "y"  # a relief; a flat sheet
    for points, normals in (ball(), torus(24, 12), knot()):
        assert up_of(shapes.Shape(points, normals)) == "y"
        assert up_of(shapes.Shape(points + 5, normals)) == "y"
    for corner, up in (([0.5, 0.5, 0.5], "y"), ([0, 0, 0], "y"), ([0.5, 0.5, 0], "z"), ([0.5, 0, 0.5], "y")):
        assert up_of(shapes.Shape(CUBE - corner, None, shapes._polygons.fans(QUADS))) == up  # all ends are flat


def four_legs():
    """A slab on four legs, which differ in length by a little."""
    top = np.array([[x, y, 0.7 + z] for x in (0, 2) for y in (0, 1.2) for z in (0, 0.1)])
    parts = [top] + [
        np.array([[x + a, y + b, z] for a in (0, 0.1) for b in (0, 0.1) for z in (0.003 * i, 0.7)])
        for i, (x, y) in enumerate(((0.1, 0.1), (1.8, 0.1), (0.1, 1.0), (1.8, 1.0)))
    ]
    quads = np.concatenate([np.asarray(QUADS) + 8 * i for i in range(5)])
    return shapes.Shape(np.concatenate(parts) + [5, 7, 3], None, shapes._polygons.fans(quads.tolist()))


def test_up_by_what_it_stands_on():
    assert up_of(four_legs()) == "z"
    for order in ([0, 2, 1], [2, 0, 1]):  # it lies along z, its feet along y and x
        assert up_of(shapes.Shape(four_legs().points[:, order], None, four_legs().triangles[:, ::-1])) == "y"
    hanging = shapes.Shape(four_legs().points * [1, -1, -1], None, four_legs().triangles)  # on its top, which is wider
    assert up_of(hanging) == "z"


def test_up_by_the_hole_it_stands_on():
    table = four_legs()
    table.points[:, 1] += 0.3 * (table.points[:, 0] - 5) * (table.points[:, 1] - 7)  # left and right are not alike
    for axis, up in ((1, "y"), (0, "z")):  # open where y is least, or where x is
        low = np.isclose(table.points[:, axis], table.points[:, axis].min())
        closed = ~low[table.triangles].all(axis=1)
        assert 0 < (~closed).sum() <= 2
        assert up_of(shapes.Shape(table.points, None, table.triangles[closed])) == up


def test_up_by_left_and_right():
    points, normals = ball()
    x, y, z = points.T
    pear = np.column_stack([1.5 * x + 0.5 * z**2, y, z + 0.9 * x**2 + 0.4 * x])  # its sides are along y
    assert up_of(shapes.Shape(pear, normals)) == "z"
    assert up_of(shapes.Shape(pear[:, [0, 2, 1]], normals[:, [0, 2, 1]])) == "y"
    upright = pear[:, [0, 2, 1]] - (pear.min(axis=0) + pear.max(axis=0))[[0, 2, 1]] / 2 + [0, 0, 1]
    assert up_of(shapes.Shape(upright, normals[:, [0, 2, 1]])) == "y"  # though on z = 0, in the middle of x and y
    leaf = pear * [1, 0.05, 1]
    assert up_of(shapes.Shape(leaf, normals)) == "y"  # it lies


def test_up_of_maps():
    steep = terrain(4.0)
    far = 5403000
    for place, up in (([512000, far, 0], "z"), ([512000, 0, 0], "y"), ([512000, far, 400000], "y"), ([9000, 9000, 0], "y")):
        assert up_of(shapes.Shape(steep.points + place, steep.normals)) == up


def test_which_terrains_hang():
    ground = terrain(0.6)
    assert hangs(ground.points, ground.normals) is None
    assert hangs(ground.points, -ground.normals) == "z"
    lying = [0, 2, 1]
    assert hangs(ground.points[:, lying], -ground.normals[:, lying]) == "y"
    steep = terrain(4.0)
    assert hangs(steep.points, -steep.normals) is None
    for points, normals in (ball(), torus(24, 12), knot()):
        assert hangs(points, -normals) is None


def test_up_by_the_format(tmp_path, capsys):
    path = write(tmp_path, "a.stl", stl(True))
    more = ["--samples", "200"]
    assert draw(path, tmp_path / "a.png", *more) == 0
    assert "up is z: it is so in STL files" in capsys.readouterr().err
    assert draw(path, tmp_path / "b.png", *more, "--up", "z") == 0 == draw(path, tmp_path / "c.png", *more, "--up", "y")
    assert "up is" not in capsys.readouterr().err
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes() != (tmp_path / "c.png").read_bytes()
    path = write(tmp_path, "a.glb", glb(*gltf()))
    assert draw(path, tmp_path / "d.png", *more, "--up", "auto") == 0
    assert "up is" not in capsys.readouterr().err


def test_up_of_saved_models(tmp_path, capsys):
    ground = terrain(0.6)
    keep = slice(None, None, 4)
    hrbfnpr.Model.fit(ground.points[keep], ground.normals[keep]).save(tmp_path / "m")
    assert draw(tmp_path / "m", tmp_path / "a.png") == 0
    assert "up is z: the surface is a terrain" in capsys.readouterr().err


# --- pictures with nothing in them -------------------------------------------------------------


@pytest.mark.parametrize(
    "options, words",
    [
        (["--eye", "0,0,5", "--target", "0,0,9"], "The camera looks away"),
        (["--normals", "keep", "--lines", "none"], "behind something, as where normals look inward: --flip"),
        (["--flip", "--style", "stipple"], "leave out --flip"),
        (["--ink", "#ffffff", "--lines", "none"], "ink cannot be seen"),
        (["--depth-range", "0.01,0.02", "--lines", "none"], "leave out --depth-range"),
    ],
)
def test_why_it_is_blank(tmp_path, capsys, options, words):
    points, normals = ball()
    sign = -1 if "keep" in options else 1
    path, output = write(tmp_path, "a.xyz", table(points, sign * normals)), tmp_path / "out.png"
    output.write_bytes(b"the picture of before")
    assert draw(path, output, *options, "--save-model", str(tmp_path / "m")) == 3
    out, err = capsys.readouterr()
    assert re.search(r"(?m)^hrbfnpr: error: the picture would be blank: .*" + words, err), err
    assert output.read_bytes() == b"the picture of before" and not (tmp_path / "m").exists()
    assert draw(path, output, *options, "--allow-blank", "-q") == 0
    assert max(Image.open(output).size) == 100


def test_a_sheet_seen_from_behind(tmp_path, capsys):
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, 9)]), axis=-1).reshape(-1, 2)
    points = np.column_stack([grid, 0.1 * grid[:, 0] ** 2])
    path = write(tmp_path, "a.xyz", table(points, np.tile([0.0, 0, -1], (81, 1))))
    options = ["--up", "y", "--lines", "none", "--normals", "keep", "--azimuth", "30"]
    assert draw(path, tmp_path / "a.png", *options) == 0, "both its sides are drawn"
    options += ["--sides", "front"]
    assert draw(path, tmp_path / "a.png", *options) == 3
    assert "looks away from the eye: another --azimuth shows its front, or --sides both" in capsys.readouterr().err
    assert draw(path, tmp_path / "a.png", *options, "--azimuth", "210") == 0


def test_a_sheet_warns_of_blank_drawings(tmp_path, capsys):
    path = write(tmp_path, "a.xyz", table(ball()[0], -ball()[1]))
    options = ["--styles", "stipple,silhouette", "--size", "60", "--marks", "600", "--normals", "keep"]
    assert main(["sheet", str(path), str(tmp_path / "s.png"), *options]) == 0
    err = capsys.readouterr().err
    assert err.count("would be blank") == 1 and "warning: stipple: the picture" in err


# --- outputs -----------------------------------------------------------------------------------


def test_outputs_are_looked_at_before_the_work(tmp_path, monkeypatch, capsys):
    path = write(tmp_path, "a.xyz", table(*ball()))
    monkeypatch.setattr("hrbfnpr._sources.read", lambda *arguments: pytest.fail("it was read"))
    nowhere = str(tmp_path / "no" / "out")
    for command in (
        ["draw", str(path), nowhere + ".png"],
        ["draw", str(path), str(tmp_path / "out.bmpx")],
        ["draw", str(path), str(tmp_path / "a.png"), "--save-model", nowhere],
        ["sheet", str(path), nowhere + ".png"],
        ["fit", str(path), nowhere],
        ["fit", str(path), str(tmp_path / "m.ply")],
        ["points", str(path), nowhere],
        ["points", str(path), str(tmp_path)],
    ):
        assert main(command) == 1
        err = capsys.readouterr().err
        assert err.count("\n") == 1 and not re.search(r"/\.\w", err), err  # no hidden file is named
    if os.geteuid():  # root may write anywhere
        (tmp_path / "locked").mkdir(mode=0o500)
        assert main(["draw", str(path), str(tmp_path / "locked" / "a.png")]) == 1
        assert "it cannot be written there" in capsys.readouterr().err


def test_a_failure_while_writing_names_the_file(tmp_path, sphere):
    with pytest.raises(FileNotFoundError) as caught:
        sphere.save(tmp_path / "nowhere" / "a.hrbf")
    assert caught.value.filename == str(tmp_path / "nowhere" / "a.hrbf")


# --- seconds, bars, order ----------------------------------------------------------------------


def run(code, *arguments):
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE)}
    command = [sys.executable, "-c", f"{code}; import sys; from hrbfnpr.cli import main; sys.exit(main())", *arguments]
    return subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def test_the_total_is_that_of_the_process(tmp_path):
    few = fibonacci_sphere(8)
    path = write(tmp_path, "a.xyz", table(few, few))
    result = run("import time; time.sleep(0.8)", "draw", str(path), str(tmp_path / "a.png"), *QUICK, "--lines", "none")
    assert result.returncode == 0, result.stdout
    lines = result.stdout.splitlines()
    seconds = {line[:12].strip(): float(line[12:20]) for line in lines if re.match(r"[a-z ]{12} +[\d.]+ s", line)}
    if sys.platform.startswith("linux"):
        assert seconds["start"] >= 0.8
    assert sum(seconds.values()) - seconds["total"] <= seconds["total"] + 0.05
    summary = next(i for i, line in enumerate(lines) if re.search(r"pixels, \d+ marks, [\d.]+ s$", line))
    assert float(lines[summary].split()[-2]) == pytest.approx(seconds["total"], abs=0.11)
    # Warnings come last, and are in words.
    assert lines[summary + 1 :] and all(line.startswith("hrbfnpr: warning: ") for line in lines[summary + 1 :])
    assert "there are 8 points only" in lines[summary + 1]


def test_bars_show_percent():
    tqdm = pytest.importorskip("tqdm").tqdm
    points = fibonacci_sphere(400)
    for total in (None, 1, 1.0):
        shown = io.StringIO()
        width = 0 if total == 1 else None
        with tqdm(desc="fitting", file=shown, total=total, mininterval=0, ncols=width) as bar:
            hrbfnpr.Model.fit(points, points, progress=bar)
            bar.refresh()
        assert "100%" in shown.getvalue() and "/1" not in shown.getvalue().split("\r")[-2]
    with tqdm(file=io.StringIO(), total=50) as bar:  # the caller's own unit
        hrbfnpr.Model.fit(points, points, progress=bar)
        assert bar.n == 50 and bar.bar_format is None


def test_how_near_the_surface_is(tmp_path, capsys):
    vertices, faces = tube()
    path = write(tmp_path, "a.obj", obj(vertices, faces))
    found = []
    for samples in ("80", "2000"):
        assert draw(path, tmp_path / "a.png", "--samples", samples) == 0
        out, err = capsys.readouterr()
        to_mesh = r"surface to mesh: 99 % within ([\d.]+)% of the diagonal, all within ([\d.]+)%"
        figures = re.search(rf"(?m)^compare .*{to_mesh}; mesh to surface: ([\d.]+)%, ([\d.]+)%", out)
        surface, surface_most, mesh, mesh_most = (float(figure) for figure in figures.groups())
        assert surface <= surface_most and mesh <= mesh_most
        found.append(mesh)
        assert ("the surface is off the mesh" in err) == (samples == "80")
    assert found[0] > 1 > found[1] > 0
    assert draw(write(tmp_path, "a.xyz", table(*ball())), tmp_path / "a.png") == 0
    assert re.search(r"(?m)^fit .* 200 centres, .*; through all samples$", capsys.readouterr().out)
