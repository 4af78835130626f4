# SPDX-License-Identifier: MIT
"""Statements of docs/input.md about each kind of input are true, and so are the printed lines."""
import dataclasses
import json
import re
import shlex

import numpy as np
import pytest
from conftest import ROOT, fibonacci_sphere, torus
from coarse import coarse_ball, flat_ball, obj
from convex_hulls import rounded_box
from corner_normals import obj as obj_with_normals, prism
from curves import rings
from test_cli import STAGE, rows
from test_meshes import glb, gltf
from test_ptx import ptx, wall
from test_scans import las, pcd_picture
from test_shapes import CUBE, QUADS, ply_header, stl, write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")

DOCUMENT = (ROOT / "docs" / "input.md").read_text(encoding="utf-8")
QUICK = ["--size", "100", "--marks", "600", "--lines", "none"]


def ball(scale=1.0):
    points = fibonacci_sphere(200)
    return scale * points, points


def table(points, normals=None):
    return rows(points if normals is None else np.hstack([points, normals]))


def tube(across=24, along=12, turned=(), ends=True):
    """A cylinder of quads about y, with or without caps. Faces whose indices are in `turned` are turned over."""
    angle = 2 * np.pi * np.arange(across) / across
    rings = [np.column_stack([np.cos(angle), 0 * angle + y, np.sin(angle)]) for y in np.linspace(0, 3, along)]
    vertices = np.vstack([*rings, [[0, 0, 0], [0, 3, 0]]])
    faces = []
    for ring in range(along - 1):
        for i in range(across):
            a, b = ring * across + i, ring * across + (i + 1) % across
            faces.append([a, a + across, b + across, b])
    if ends:
        first, last = len(vertices) - 2, (along - 1) * across
        for i in range(across):
            faces.append([first, i, (i + 1) % across])
            faces.append([len(vertices) - 1, last + (i + 1) % across, last + i])
    return vertices, [face[::-1] if number in turned else face for number, face in enumerate(faces)]


def waves():
    across, down = np.meshgrid(np.arange(12), np.arange(10))
    return "ncols 12\nnrows 10\ncellsize 30\n" + rows(500 + 20 * np.sin(across / 2) * np.cos(down / 3))


def hanging():
    across, down = np.meshgrid(np.arange(12), np.arange(10))
    vertices = np.column_stack([across.ravel(), down.ravel(), np.sin(across.ravel() / 2)])
    corners = [i for i in range(108) if i % 12 < 11]
    return obj(vertices, [[i, i + 12, i + 13, i + 1] for i in corners])


def mask(way):
    """A bowl whose outside faces +z (way = 1) or -z (way = -1)."""
    turn, tilt = np.meshgrid(2 * np.pi * np.arange(16) / 16, np.pi / 2 * np.arange(1, 9) / 8)
    rim = np.column_stack([(np.sin(tilt) * np.cos(turn)).ravel(), (np.sin(tilt) * np.sin(turn)).ravel(), np.cos(tilt).ravel()])
    vertices = np.vstack([rim, [[0, 0, 1]]]) * [1, 1, way]
    faces = [[128, i, (i + 1) % 16] for i in range(16)]
    faces += [[r + i, r + 16 + i, r + 16 + (i + 1) % 16, r + (i + 1) % 16] for r in range(0, 112, 16) for i in range(16)]
    return obj(vertices, faces if way > 0 else [face[::-1] for face in faces])


def mixed():
    points, normals = ball()
    signs = np.where(np.random.default_rng(3).random(200) < 0.3, -1, 1)
    return table(points, signs[:, None] * normals)


def noisy():
    points = fibonacci_sphere(1500)
    return points + np.random.default_rng(4).normal(scale=0.03, size=points.shape)


def dusty():
    dust = np.random.default_rng(5).uniform(-3, 3, (40, 3))
    return np.vstack([fibonacci_sphere(1500), dust[np.linalg.norm(dust, axis=1) > 1.5]])


def edged():
    """The faces of a cube, each with points along its edges."""
    side = np.linspace(-1, 1, 7)
    square = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    parts = []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            points, normals = np.zeros((49, 3)), np.zeros((49, 3))
            points[:, [(axis + 1) % 3, (axis + 2) % 3]] = square
            points[:, axis], normals[:, axis] = sign, sign
            parts.append(table(points, normals))
    return "".join(parts)


def with_zeros():
    points, normals = ball()
    normals = normals.copy()
    normals[::50] = 0
    return table(points, normals)


def holed():
    vertices, faces = tube(ends=False)
    return obj(vertices, [face[::-1] for face in faces])


def nested_parts(ends=True):
    vertices, faces = tube(ends=ends)
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    inside = [[i + len(vertices) for i in face] for face in faces]
    return obj(np.vstack([vertices, middle + 0.3 * (vertices - middle)]), [*tube()[1], *inside])


def far_away():
    points = fibonacci_sphere(1000)
    return table(np.vstack([points, [[40, 0, 0], [45, 3, 0]]]), np.vstack([points, [[1, 0, 0], [1, 0, 0]]]))


def lost():
    vertices, faces = tube()
    first = len(vertices)
    return obj(np.vstack([vertices, [[60, 0, 0], [60, 0.1, 0], [60, 0, 0.1]]]), [*faces, [first, first + 1, first + 2]])


def no_data():
    x, y = np.meshgrid(np.arange(12.0), np.arange(10.0))
    z = np.sin(x / 3) * np.cos(y / 2)
    z[4, 5:7] = -9999
    cells = [12 * row + column for row in range(9) for column in range(11)]
    return obj(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), [[i, i + 1, i + 13, i + 12] for i in cells])


def voxels():
    """Three cubes that share a corner."""
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    vertices = np.vstack([cube + place for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0))])
    return obj(vertices, [[8 * which + corner for corner in side] for which in range(3) for side in sides])


def crossing_parts():
    vertices, faces = tube(ends=False)
    beside = [[i + len(vertices) for i in face] for face in faces]
    return obj(np.vstack([vertices, vertices[:, [2, 0, 1]] + [0.3, 0.2, 0.1]]), [*faces, *beside])


def left_over():
    """A tube with an extra small face on one of its edges."""
    vertices, faces = tube()
    outside = (vertices[100] + vertices[101]) / 2 * [1.01, 1, 1.01]
    return obj(np.vstack([vertices, [outside]]), [*faces, [100, 101, len(vertices)]])


def near_parts():
    vertices, faces = tube()
    beside = [[i + len(vertices) for i in face] for face in faces]
    return obj(np.vstack([vertices, vertices + [2.01, 0, 0]]), [*faces, *beside])


def not_finite():
    vertices, faces = tube()
    return obj(vertices, faces) + "v nan 0 0\nf 1 2 " + str(len(vertices) + 1) + "\n"


def cut_short():
    places, faces = ["float x", "float y", "float z"], ["list uchar int vertex_indices"]
    return ply_header("binary_little_endian", ("vertex", 100, places), ("face", 1, faces)) + bytes(200)


def hill(across=100.0, along=100.0):
    """Places on a hill of 60."""
    x, y = np.meshgrid(np.linspace(0, 1, 15), np.linspace(0, 1, 15))
    return np.column_stack([across * x.ravel(), along * y.ravel(), 30 * np.sin(3 * x + 2 * y).ravel() + 500])


def forest():
    """A hill, and trees on each third of its points."""
    ground = hill()
    points = np.vstack([ground, ground[::3] + [0, 0, 25]])
    return las(points=points, count=len(points), flags=np.where(np.arange(len(points)) < len(ground), 2, 5))


def thin():
    rod = np.array([[0.02, 1, 0.02]])
    vertices, faces = tube()
    cube = obj(CUBE * 3, QUADS)
    shifted = [[i + 8 for i in face] for face in faces]
    return cube + obj(vertices * rod + [1.5, 3, 1.5], shifted)


# For each row of the tables in docs/input.md: the file name, its contents, options, and the exit status.
ROWS = {
    "points, all normals inward": ("a.xyz", lambda: table(ball()[0], -ball()[1]), [], 0),
    "points, some normals inward": ("a.xyz", mixed, [], 0),
    "points without normals": ("a.xyz", lambda: table(ball()[0]), [], 0),
    "points of one scan without normals, scanner position known": (
        "a.ptx", lambda: ptx(wall(), 30).decode(), [], 0),
    "points with normals and noise": ("a.xyz", lambda: table(noisy(), fibonacci_sphere(1500)), [], 0),
    "points with noise, without normals": ("a.xyz", lambda: table(noisy()), [], 0),
    "points with stray points around them": ("a.xyz", lambda: table(dusty()), [], 0),
    "points along curves, such as wires, cross sections or a tracked pen": ("a.xyz", lambda: table(rings()), [], 0),
    "points with colours, without normals": (
        "a.xyz", lambda: "".join(f"{x} {y} {z} 9 200 31\n" for x, y, z in ball()[0].tolist()), [], 0),
    "points of a laser survey, with classes of ground and vegetation": ("a.las", forest, [], 0),
    "points with longitude, latitude and height": (
        "a.csv", lambda: "lon,lat,height\n" + table(hill(0.01, 0.01) + [10, 47, 0]).replace(" ", ","), [], 0),
    "points, some without a usable position or normal": ("a.xyz", with_zeros, [], 0),
    "points with normals, a few far away": ("a.xyz", far_away, [], 0),
    "several points at one place": ("a.xyz", lambda: 2 * table(*ball()), [], 0),
    "several points with different normals at one place, as on a sharp edge": ("a.xyz", edged, [], 0),
    "more than 4096 points": ("a.xyz", lambda: table(*2 * [fibonacci_sphere(4200)]), ["--max-centres", "0"], 0),
    "fewer than ten points": ("a.xyz", lambda: table(*2 * [fibonacci_sphere(8)]), [], 0),
    "points in a plane, or a flat mesh": ("a.obj", lambda: obj(CUBE[:4] * [3, 2, 1], [[0, 1, 3, 2]]), [], 0),
    "a solid pressed flat": ("a.obj", lambda: obj(tube()[0] * [0, 1, 1], tube()[1]), [], 1),
    "one point": ("a.xyz", lambda: "0 0 0 0 0 1\n", [], 3),
    "closed mesh, inside out": ("a.obj", lambda: obj(tube()[0], [face[::-1] for face in tube()[1]]), [], 0),
    "mesh with holes, inside out": ("a.obj", holed, [], 0),
    "mesh, some faces turned over": ("a.obj", lambda: obj(*tube(turned=range(0, 60, 7))), [], 0),
    "mesh with sharp edges": ("a.obj", lambda: obj(CUBE, QUADS), [], 0),
    "coarse mesh of a round shape": ("a.obj", coarse_ball, [], 0),
    "coarse mesh, some edges sharp by the file's normals": (
        "a.obj", lambda: obj_with_normals(*prism()), [], 0),
    "coarse mesh, all edges sharp by the file's normals": ("a.obj", flat_ball, [], 0),
    "coarse mesh that no round surface fits, such as a convex hull": (
        "a.obj", lambda: obj(*rounded_box()), [], 0),
    "mesh of solids that share faces, such as voxels": ("a.obj", voxels, [], 0),
    "mesh with a tiny part far away": ("a.obj", lost, [], 0),
    "mesh or points with -9999 or a similar number for missing data": ("a.obj", no_data, [], 0),
    "mesh with closed parts inside others, whichever way they are wound": ("a.obj", nested_parts, [], 0),
    "mesh with open parts inside others": ("a.obj", lambda: nested_parts(ends=False), [], 0),
    "mesh with thin parts, `--samples` too small": ("a.obj", thin, ["--samples", "60"], 0),
    "mesh with parts closer than the tolerance":
        ("a.obj", near_parts, ["--tolerance", "0.05"], 0),
    "mesh with open parts that cross or nearly touch":
        ("a.obj", crossing_parts, ["--tolerance", "0.05"], 0),
    "mesh with a few faces that only hang on an edge of two others": ("a.obj", left_over, [], 0),
    "mesh, some corners not finite": ("a.obj", not_finite, [], 0),
    "depth image: a PCD file whose rows are those of an image": ("a.pcd", lambda: pcd_picture(), [], 0),
    "open surface whose front faces away, such as a mask that faces -z":
        ("a.obj", lambda: mask(-1), [], 0),
    "height map": ("a.asc", waves, [], 0),
    "terrain whose normals point down": ("a.obj", hanging, [], 0),
    "STL file": ("a.stl", lambda: stl(True), ["--samples", "200"], 0),
    "file with the wrong ending": ("a.xyz", lambda: stl(True), ["--samples", "200"], 0),
    "text that is no table of numbers": ("a.xyz", lambda: "Dear Sir,\nI send you my scan.\n", [], 1),
    "face with a vertex that does not exist": ("a.obj", lambda: "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n", [], 1),
    "points with a wrong count, or cut short": ("a.pts", lambda: "201\n" + table(*ball()), [], 0),
    "truncated file": ("a.ply", cut_short, [], 1),
    "empty file": ("a.ply", lambda: "", [], 1),
    "unknown format": ("a.docx", lambda: b"PK\3\4" + bytes(50), [], 1),
    "camera that looks away": ("a.xyz", lambda: table(*ball()), ["--eye", "0,0,5", "--target", "0,0,9"], 3),
    "output in a folder that does not exist": ("a.xyz", lambda: table(*ball()), ["-o", "nowhere/out.png"], 1),
}  # fmt: skip

# The text printed for each row. N is any number, FILE is the file. None: nothing is printed.
SAID = {
    "points, all normals inward": "note: all normals pointed inward: they are turned (--normals keep leaves them)",
    "points, some normals inward": "note: normals repaired: N turned, N computed again",
    "points without normals": "note: the points have no normals: N are computed",
    "points of one scan without normals, scanner position known":
        "note: the points have no normals: N are computed, facing the scanner",
    "points with normals and noise":
        "note: the samples are noisy: the surface is smoothed (--regularization 0 keeps the noise)",
    "points with noise, without normals":
        "note: the samples are noisy: the surface is smoothed (--regularization 0 keeps the noise)",
    "points with stray points around them":
        "note: N points far from all others left out (--outliers keep keeps them)",
    "points along curves, such as wires, cross sections or a tracked pen":
        "note: the points lie along curves: the surface between the curves is drawn too",
    "points with colours, without normals": "note: columns 4 to 6 are colours: they are not used as normals",
    "points of a laser survey, with classes of ground and vegetation":
        "note: only the ground is read, N of N points (classes all reads all)",
    "points with longitude, latitude and height": "note: degrees are converted to metres, the unit of the heights",
    "points, some without a usable position or normal": "note: N points left out: without a usable position or normal",
    "points with normals, a few far away": "note: N points far from all others left out",
    "several points at one place": "note: N samples merged with another at the same place",
    "several points with different normals at one place, as on a sharp edge":
        "note: N places with several normals, as on a sharp edge: their mean is used",
    "more than 4096 points": "note: N of N points are used",
    "fewer than ten points": "warning: there are only N points: the surface between them is a guess",
    "points in a plane, or a flat mesh": "warning: all points lie in a plane: the surface is flat and ends where they do",
    "a solid pressed flat":
        "error: FILE: the mesh is flat: all of its vertices lie in one plane, N % of the area looks one way and N % the other, so it has no inside; keep the faces of one side, or give it a thickness",
    "one point": "error: the picture would be blank: nothing is drawn. All samples are at one point",
    "closed mesh, inside out": "note: the mesh was inside out: its faces are turned",
    "mesh with holes, inside out": "note: all normals pointed inward: they are turned",
    "mesh, some faces turned over": "note: N faces turned to the side of their neighbours",
    "mesh with sharp edges": None,
    "coarse mesh of a round shape":
        "note: the faces are coarse: divided N times and rounded (--subdivide 0 leaves them)",
    "coarse mesh, some edges sharp by the file's normals":
        "note: edges are sharp or round by the normals in the file (--edges auto goes by their angles)",
    "coarse mesh, all edges sharp by the file's normals":
        "note: all faces are flat, by the normals in the file (--edges smooth rounds them)",
    "coarse mesh that no round surface fits, such as a convex hull":
        "note: the faces are coarse and stay flat: no round shape fits them (--edges smooth rounds)",
    "mesh of solids that share faces, such as voxels": "note: N faces left out: without area, or repeated",
    "mesh with a tiny part far away": "note: N part (N face) far from all others left out",
    "mesh or points with -9999 or a similar number for missing data":
        "note: N vertices left out, as the value -9999 marks missing data",
    "mesh with closed parts inside others, whichever way they are wound":
        "note: N part inside others left out (N faces)",
    "mesh with open parts inside others": "note: N part inside others left out (N faces)",
    "mesh with thin parts, `--samples` too small":
        "warning: N% of the mesh is more than 1% of the diagonal off the surface",
    "mesh with parts closer than the tolerance":
        "warning: parts N and N nearly touch, and may be joined: try a smaller --tolerance",
    "mesh with open parts that cross or nearly touch":
        "note: N parts cross or nearly touch: drawn as N surfaces",
    "mesh with a few faces that only hang on an edge of two others":
        "note: N face left out: each hangs on an edge of two others",
    "mesh, some corners not finite": "warning: N face left out, as a corner is not finite",
    "depth image: a PCD file whose rows are those of an image":
        "note: the depth image has noise of N at depth N: it is smoothed",
    "open surface whose front faces away, such as a mask that faces -z":
        "note: the surface is drawn from its front, azimuth N",
    "height map": "note: up is z, as in height map files (--up y changes it)",
    "terrain whose normals point down": "note: the terrain faced down along z: its normals are turned",
    "STL file": "note: up is z, as in STL files (--up y changes it)",
    "file with the wrong ending": "note: the ending is .xyz, but the file holds STL and is read as such",
    "text that is no table of numbers": "error: FILE: line 1, column 1: 'Dear' is not a number; a line holds x y z",
    "face with a vertex that does not exist":
        "error: FILE: line 5, column 4: a face names vertex 9, but there are 3 vertices, 1 to 3",
    "points with a wrong count, or cut short": "note: the file says N points, but it has N: these are read",
    "truncated file": "error: FILE: the PLY file ends in the middle of its N elements 'vertex'",
    "empty file": "error: FILE: not a PLY file: the file is empty",
    "unknown format": "error: FILE: files that end in .docx are not read",
    "camera that looks away": "error: the picture would be blank: nothing is drawn. The camera looks away from the model",
    "output in a folder that does not exist": "error: nowhere/out.png: there is no folder nowhere",
}  # fmt: skip


def documented():
    section = DOCUMENT.split("\n## What happens\n")[1].split("\n## ")[0]
    names = re.findall(r"^\| (.+?) \| .+ \| .+ \|$", section, re.M)
    return [name for name in names if name != "What you have"]


def test_each_row_has_a_case():
    assert documented() == list(ROWS) == list(SAID)


@pytest.mark.parametrize("name", ROWS)
def test_messages_match_the_documentation(tmp_path, monkeypatch, capsys, name):
    monkeypatch.chdir(tmp_path)
    file, make, options, code = ROWS[name]
    write(tmp_path, file, make())
    output = [] if "-o" in options else ["out.png"]
    assert main(["draw", file, *output, *QUICK, *options]) == code
    out, err = capsys.readouterr()
    if SAID[name] is None:
        assert err == ""
    else:
        words = re.escape("hrbfnpr: " + SAID[name]).replace("FILE", re.escape(file))
        assert re.search(r"(?m)^" + re.sub(r"\bN\b", r"\\d+(?:\\.\\d+)?", words), err), err
    lines = err.splitlines()
    assert all(re.match(r"hrbfnpr: (note|warning|error): ", line) for line in lines)
    order = [re.match(r"hrbfnpr: (note|warning|error)", line).group(1) for line in lines]
    assert order == sorted(order, key=["note", "warning", "error"].index)
    assert ("error" in order) == (code != 0)
    assert (tmp_path / "out.png").exists() == (code == 0)
    assert not [path for path in tmp_path.iterdir() if path.name not in (file, "out.png")]


WARNINGS = [name for name, said in SAID.items() if said and said.startswith("warning")]


# --quiet treats all notes alike, so the rows with warnings and two rows with notes are enough.
@pytest.mark.parametrize("name", WARNINGS + ["STL file", "height map"])
def test_quiet_prints_warnings_only(tmp_path, monkeypatch, capsys, name):
    monkeypatch.chdir(tmp_path)
    file, make, options, _ = ROWS[name]
    write(tmp_path, file, make())
    assert main(["draw", file, "out.png", *QUICK, *options, "--quiet"]) == 0
    out, err = capsys.readouterr()
    assert out == "" and all(line.startswith("hrbfnpr: warning: ") for line in err.splitlines())
    assert ("hrbfnpr: warning: " in err) >= (name in WARNINGS)


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", DOCUMENT, re.DOTALL | re.MULTILINE)


def test_documented_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, "scan.xyz", table(*torus(16, 8)))
    commands = [line for block in blocks("sh") for line in block.splitlines() if line]
    assert len(commands) >= 3
    for command in commands:
        words = shlex.split(command, comments=True)
        assert words[:3] == ["python3", "-m", "hrbfnpr"]
        assert main(words[3:]) == 0, command
    assert Image.open("scan.png").size[0] <= 400
    capsys.readouterr()


def test_documented_output_has_the_printed_format():
    (shown,) = blocks("text")
    lines = shown.splitlines()
    assert all(re.fullmatch(STAGE, line) for line in lines[:-1])
    assert re.fullmatch(r"\S+: \d+ x \d+ pixels, \d+ marks, \d+\.\d s", lines[-1])


def test_json_has_the_documented_keys(tmp_path, capsys):
    section = DOCUMENT.split("\n## check\n")[1]
    entries = re.findall(r"^\| (`.+?) \| (.+) \|$", section, re.M)
    keys = {key for names, _ in entries for key in re.findall(r"`(\w+)`", names)}
    found = set()
    files = {"a.xyz": table(*ball()), "a.obj": obj(CUBE, QUADS), "a.pcd": pcd_picture()}
    for path in (write(tmp_path, name, data) for name, data in files.items()):
        assert main(["check", str(path), "--json"]) == 0
        found |= json.loads(capsys.readouterr().out).keys()
    assert found == keys
    mesh = next(value for names, value in entries if names == "`mesh`")
    assert re.findall(r"`(\w+)`", mesh) == [field.name for field in dataclasses.fields(shapes.MeshFacts)]


# --- check -------------------------------------------------------------------------------------


def checked(path, capsys):
    code = main(["check", str(path), "--json"])
    facts = json.loads(capsys.readouterr().out)
    assert main(["check", str(path)]) == code
    out, err = capsys.readouterr()
    assert err == "" and out.splitlines()[-1] == f"status: {facts['status']}"
    assert ("fine", "warnings", "unusable")[code] == facts["status"]
    return facts


def test_check_of_points(tmp_path, capsys):
    facts = checked(write(tmp_path, "a.csv", "x,y,z,nx,ny,nz\n" + table(*ball(2.0)).replace(" ", ",")), capsys)
    assert facts["status"] == "fine" and facts["points"] == 200 and facts["normals_look"] == "outward"
    assert facts["columns"] == ["x", "y", "z", "nx", "ny", "nz"] and facts["diagonal"] == pytest.approx(6.92, abs=0.05)
    assert facts["repairs"] == facts["warnings"] == facts["advice"] == []
    facts = checked(write(tmp_path, "b.xyz", table(ball()[0], -3 * ball()[1])), capsys)
    assert facts["normals_look"] == "inward" and facts["normals_unit_share"] == 0 and len(facts["repairs"]) == 2
    facts = checked(write(tmp_path, "c.xyz", mixed()), capsys)
    assert facts["normals_look"] == "mixed" and 0.2 < facts["normals_flipped_share"] < 0.4
    facts = checked(write(tmp_path, "d.xyz", with_zeros() + table(*(part[1:5] for part in ball()))), capsys)
    assert facts["normals_zero"] == 4 and facts["duplicates"] >= 1 and facts["status"] == "warnings"
    facts = checked(write(tmp_path, "e.xyz", "nan 0 0 0 0 1\n" + table(*ball())), capsys)
    assert facts["points_not_finite"] == 1
    facts = checked(write(tmp_path, "f.xyz", table(ball()[0] + [4e6, 5e6, 0], ball()[1])), capsys)
    assert "far from the origin" in facts["warnings"][0]


def test_several_normals_at_one_place(tmp_path, capsys):
    facts = checked(write(tmp_path, "a.xyz", edged()), capsys)
    assert facts["status"] == "fine" and "68 places with several normals: their mean is used" in facts["repairs"]
    points, normals = ball()
    both = table(points, normals) + table(points[:3], -normals[:3])
    assert main(["draw", str(write(tmp_path, "b.xyz", both)), str(tmp_path / "b.png"), *QUICK]) == 0
    out, err = capsys.readouterr()
    assert "warning: 3 places with opposite normals left out" in err and " 197 centres" in out
    path = write(tmp_path, "c.xyz", table(points, normals) + table(points, -normals))
    assert main(["draw", str(path), str(tmp_path / "c.png"), *QUICK]) == 1
    assert "all points come in pairs with opposite normals" in capsys.readouterr().err


def test_check_of_unusable_files(tmp_path, capsys):
    for name, data, words in (
        ("b.xyz", "Dear\n", "^line 1, column 1"),
        ("c.xyz", "", "empty"),
        ("d.docx", "", "no points"),
        ("missing", None, "No such file"),
        ("f.obj", "v 0 0 0\nf 1 1 1\n", "none has an area|degenerate"),
    ):
        path = tmp_path / name if data is None else write(tmp_path, name, data)
        facts = checked(path, capsys)
        assert facts["status"] == "unusable" and re.search(words, facts["errors"][0]), facts["errors"]


def test_check_of_meshes(tmp_path, capsys):
    facts = checked(write(tmp_path, "a.obj", obj(*tube())), capsys)
    mesh = facts["mesh"]
    assert facts["status"] == "fine" and mesh["closed"] and mesh["components"] == 1
    assert mesh["volume"] == pytest.approx(3 * np.pi, rel=0.02) and mesh["area"] == pytest.approx(8 * np.pi, rel=0.02)
    facts = checked(write(tmp_path, "h.stl", stl(True)), capsys)
    assert facts["mesh"]["joined_vertices"] == 8 and facts["mesh"]["closed"] and facts["up"] == "z"
    facts = checked(write(tmp_path, "i.glb", glb(*gltf())), capsys)
    assert facts["unit"] == "metres" and facts["up"] == "y"


def test_check_of_saved_files(tmp_path, capsys, sphere, marks):
    sphere.save(tmp_path / "a.hrbf")
    marks.save(tmp_path / "a.hrbm")
    assert checked(tmp_path / "a.hrbf", capsys)["kind"] == "model"
    assert checked(tmp_path / "a.hrbm", capsys)["kind"] == "point set"


@pytest.mark.parametrize("way, options", [(1, []), (-1, ["--azimuth", "30"]), (-1, ["--direction", "0,0,-1"])])
def test_an_explicit_view_direction_is_kept(tmp_path, capsys, way, options):
    assert main(["draw", str(write(tmp_path, "a.obj", mask(way))), str(tmp_path / "out.png"), *QUICK, *options]) == 0
    assert "from its front" not in capsys.readouterr().err


def test_dust_does_not_become_sheets(tmp_path):
    path = write(tmp_path, "a.xyz", table(dusty()))
    far = {}
    for options in ((), ("--outliers", "keep")):
        model = tmp_path / "a.hrb"
        assert main(["fit", str(path), str(model), "--quiet", *options]) == 0
        marks = hrbfnpr.Model.load(model).generate(budget=2000)
        places = np.asarray(marks.layers[0].positions) + marks.origin
        far[options] = float((np.abs(np.linalg.norm(places, axis=1) - 1) > 0.05).mean())
    assert far[()] == 0 and far[("--outliers", "keep")] > 0.1
