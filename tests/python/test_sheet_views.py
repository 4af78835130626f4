# SPDX-License-Identifier: MIT
"""Technical drawings of views and sections: sizes, placement, line types, and errors."""
import re

import numpy as np
import pytest
from conftest import fibonacci_sphere, torus

from hrbfnpr.cli import main

NUMBER = r"-?(?:\d+\.?\d*|\.\d+)"


def paths_of(path):
    """For each layer of an SVG, the points along each path in mm."""
    found = {}
    layer = None
    for tag in re.finditer(r'<g [^>]*inkscape:label="([^"]*)"|<path [^>]*d="([^"]*)"', path.read_text()):
        if tag.group(1) is not None:
            layer = tag.group(1)
        else:
            found.setdefault(layer, []).append(absolute(tag.group(2)))
    return found


def absolute(d):
    """Points along an SVG path of M, L, H, V, C and round A, absolute or relative."""
    points, at = [], np.zeros(2)
    t = np.linspace(0.1, 1, 10)[:, None]
    for command, numbers in re.findall(rf"([a-zA-Z])((?:[\s,]*{NUMBER})*)", d):
        values = np.array([float(x) for x in re.findall(NUMBER, numbers)])
        origin = 1 if command.islower() else 0
        if command in "hHvV":
            steps = [np.eye(2)["hv".index(command.lower())] * value for value in values]
            assert command.islower()
            for step in steps:
                at = at + step
                points.append(at)
        elif command in "cC":
            for a, b, c in values.reshape(-1, 3, 2) + 0.0:
                a, b, c = (origin * at + x for x in (a, b, c))
                points += list((1 - t) ** 3 * at + 3 * t * (1 - t) ** 2 * a + 3 * t**2 * (1 - t) * b + t**3 * c)
                at = c
        elif command in "aA":
            for radius, _, _, large, sweep, *end in values.reshape(-1, 7):
                end = origin * at + np.array(end)
                points += list(on_arc(at, end, radius, large, sweep, np.linspace(0.02, 1, 50)[:, None]))
                at = end
        elif command in "mMlL":
            for pair in values.reshape(-1, 2):
                at = origin * at + pair
                points.append(at)
        else:
            assert command in "zZ", command
    return np.array(points)


def on_arc(begin, end, radius, large, sweep, share):
    """Points at shares of the way along an arc of a circle."""
    half = (end - begin) / 2
    across = np.array((-half[1], half[0])) / np.linalg.norm(half)
    side = 1.0 if large != sweep else -1.0
    centre = begin + half + side * np.sqrt(max(0.0, radius**2 - half @ half)) * across
    first, last = (np.arctan2(*(place - centre)[::-1]) for place in (begin, end))
    turn = (last - first) % (2 * np.pi) if sweep else -((first - last) % (2 * np.pi))
    angle = first + share * turn
    return centre + radius * np.hstack((np.cos(angle), np.sin(angle)))


def box_of(paths, prefix):
    points = np.concatenate([p for name, of_one in paths.items() if name.startswith(prefix) for p in of_one])
    return points.min(axis=0), points.max(axis=0)


@pytest.fixture(scope="module")
def egg(tmp_path_factory):
    """An ellipsoid, 40 wide, 24 high and 16 deep."""
    axes = np.array((20.0, 12.0, 8.0))
    n = fibonacci_sphere(600)
    path = tmp_path_factory.mktemp("views") / "egg.xyz"
    np.savetxt(path, np.hstack((n * axes, n / axes / np.linalg.norm(n / axes, axis=1, keepdims=True))))
    return path


@pytest.fixture(scope="module")
def ring(tmp_path_factory):
    """A torus about z, 28 wide, its tube 8 thick."""
    path = tmp_path_factory.mktemp("views") / "ring.xyz"
    points, normals = torus(36, 16)
    np.savetxt(path, np.hstack((10 * points, normals)))
    return path


@pytest.fixture(scope="module")
def bush(tmp_path_factory):
    """A turned part about z: a flange 50 wide and 8 high, a shaft 30 wide, a bore 16 wide, and 22 wide above z = 22."""
    corners = [(8, 0), (25, 0), (25, 8), (15, 8), (15, 36), (11, 36), (11, 22), (8, 22)]
    profile = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        parts = round(np.hypot(b[0] - a[0], b[1] - a[1]) / 2)
        profile += [np.add(a, np.subtract(b, a) * i / parts) for i in range(parts)]
    r, z = np.array(profile).T
    turn, count = 2 * np.pi * np.arange(72)[:, None] / 72, len(r)
    points = np.stack((r * np.cos(turn), r * np.sin(turn), np.broadcast_to(z, (72, count))), axis=-1).reshape(-1, 3)
    at = np.arange(72 * count).reshape(72, count)
    beside = np.roll(at, -1, 0)
    quads = np.stack((at, beside, np.roll(beside, -1, 1), np.roll(at, -1, 1)), axis=-1).reshape(-1, 4)
    path = tmp_path_factory.mktemp("views") / "bush.off"
    lines = ["OFF", f"{len(points)} {len(quads)} 0", *("{:g} {:g} {:g}".format(*p) for p in points)]
    path.write_text("\n".join([*lines, *("4 {} {} {} {}".format(*q) for q in quads)]) + "\n")
    return path


def drawn(model, tmp_path, *options, name="sheet.svg"):
    output = tmp_path / name
    assert main(["sheet-views", str(model), str(output), "--quiet", "--up", "y", *options]) == 0
    return paths_of(output)


@pytest.mark.parametrize("scale, factor", [("1:2", 0.5), ("2:1", 2.0), ("1:1", 1.0)])
def test_sizes_follow_the_scale(egg, tmp_path, scale, factor):
    paths = drawn(egg, tmp_path, "--scale", scale, "--views", "front,left,top")
    for name, size in (("front", (40, 24)), ("left", (16, 24)), ("top", (40, 16))):
        low, high = box_of(paths, f"outlines {name}")
        assert high - low == pytest.approx(factor * np.array(size), abs=0.05 + 0.002 * factor * 40)


def test_hidden_edges_are_dashed_and_thin(ring, tmp_path):
    """The inner side of a torus is hidden by its outer side."""
    paths = drawn(ring, tmp_path, "--up", "z", "--views", "front,top", "--scale", "2:1")
    assert len(paths["hidden front"]) > 8  # dashes
    lengths = [np.linalg.norm(np.diff(dash, axis=0), axis=1).sum() for dash in paths["hidden front"]]
    assert max(lengths) < 6.0  # 12 line widths of 0.25 mm, with a margin
    low, high = box_of(paths, "hidden front")
    outer = box_of(paths, "outlines front")
    assert (low > outer[0] - 0.1).all() and (high < outer[1] + 0.1).all()
    assert "hidden top" not in paths  # from above nothing is hidden
    text = (tmp_path / "sheet.svg").read_text()
    group = re.search(r'inkscape:label="hidden front"[^>]*>\s*<path[^>]*stroke-width="([\d.]+)"', text)
    whole = re.search(r'inkscape:label="outlines front"[^>]*>\s*<path[^>]*stroke-width="([\d.]+)"', text)
    widths = [float(found.group(1)) for found in (group, whole)] if group and whole else [0.25, 0.5]
    assert widths == [0.25, 0.5]


def test_coincident_lines_are_drawn_once(ring, tmp_path):
    """From the side, the front and the back of a torus have the same outline."""
    paths = drawn(ring, tmp_path, "--up", "z", "--views", "front", "--scale", "2:1")
    length = sum(np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in paths["outlines front"])
    assert length == pytest.approx(2 * (2 * 20 + np.pi * 8), rel=0.05)


def inside(points, centres, radius):
    return (np.linalg.norm(points[:, None] - centres, axis=2) < radius).any(axis=1)


def test_a_section_is_hatched_inside_the_cut_only(ring, tmp_path):
    paths = drawn(ring, tmp_path, "--up", "z", "--views", "front,top", "--section", "y", "--scale", "2:1")
    low, high = box_of(paths, "outlines A-A")
    assert high - low == pytest.approx((56, 16), abs=0.2)
    middle = (low + high) / 2
    centres = middle + np.array(((-20.0, 0.0), (20.0, 0.0)))
    hatching = paths["hatching A-A"]
    ends = np.concatenate(hatching)
    assert len(hatching) >= 8 and inside(ends, centres, 8.1).all()
    for line in hatching:
        step = line[-1] - line[0]
        assert abs(step[0]) == pytest.approx(abs(step[1]), abs=0.02) and step[0] * step[1] < 0  # rising at 45 degrees
    # Half of the torus is visible beyond the plane: straight lines between the circles, and nothing hidden.  Each may be
    # drawn in several strokes.
    for height in (-8, 8):
        ends = [np.sort(line[:, 0] - middle[0]) for line in paths["outlines A-A"]
                if np.abs(line[:, 1] - middle[1] - height).max() < 0.5]  # fmt: skip
        ends = sorted((x[0], x[-1]) for x in ends)
        assert ends[0][0] < -15 and ends[-1][1] > 15
        assert all(begin - end < 0.1 for (_, end), (begin, _) in zip(ends, ends[1:]))
    assert "hidden A-A" not in paths
    assert {"cutting planes top", "cutting ends top"} <= set(paths)


def test_holes_of_a_section_are_not_hatched(bush, tmp_path):
    cuts = ("--section", "y", "--section", "z:15")
    paths = drawn(bush, tmp_path, "--up", "z", "--views", "front", *cuts, "--scale", "1:1")
    low, high = box_of(paths, "outlines A-A")
    assert high - low == pytest.approx((50, 36), abs=0.4)  # the fit's 0.5 % of the diagonal
    ends = np.concatenate(paths["hatching A-A"]) - (low[0] / 2 + high[0] / 2, high[1])
    x, height = np.abs(ends[:, 0]), -ends[:, 1]
    bore, wall = np.where(height > 22.3, 11, 8), np.where(height > 8.3, 15, 25)
    assert (x > bore - 0.4).all() and (x < wall + 0.4).all()
    round_hatching = np.concatenate(paths["hatching B-B"])
    away = np.linalg.norm(round_hatching - sum(box_of(paths, "hatching B-B")) / 2, axis=1)
    assert np.minimum(np.abs(away - 8), np.abs(away - 15)).max() < 0.4
    # From the front the bore is hidden: both sides of both widths.
    hidden = np.concatenate(paths["hidden front"]) - sum(box_of(paths, "outlines front")) / 2
    for x in (-11, -8, 8, 11):
        assert (np.abs(hidden[:, 0] - x) < 0.3).sum() > 8


def test_centre_lines_are_drawn_on_request(egg, tmp_path):
    paths = drawn(egg, tmp_path, "--views", "front", "--centre-lines", "--scale", "1:1")
    low, high = box_of(paths, "centre lines front")
    assert high - low == pytest.approx((46, 30), abs=0.5)
    assert "centre lines front" not in drawn(egg, tmp_path, "--views", "front")


def test_pdf(egg, tmp_path):
    assert main(["sheet-views", str(egg), str(tmp_path / "egg.pdf"), "--quiet"]) == 0
    assert (tmp_path / "egg.pdf").read_bytes()[:5] == b"%PDF-"


def test_the_output_reports_scale_and_page(egg, tmp_path, capsys):
    assert main(["sheet-views", str(egg), str(tmp_path / "egg.svg"), "--scale", "1:2"]) == 0
    said = capsys.readouterr().out
    assert "4 views at 1:2 on a4, 297 x 210 mm, first angle" in said
    assert main(["sheet-views", str(egg), str(tmp_path / "egg.svg"), "--page", "a4"]) == 0
    assert "at 2:1 on a4" in capsys.readouterr().out


@pytest.mark.parametrize("options, status, words", [
    (["--scale", "10:1", "--page", "a4"], 1, ["--scale 10:1", "a4", "--scale 2:1", "--page a0"]),
    (["--scale", "1:0"], 2, ["--scale", "1:2"]),
    (["--views", "front,side"], 2, ["side", "front, back"]),
    (["--section", "w:3"], 2, ["is not a plane"]),
    (["--section", "x:50"], 1, ["--section", "misses", "-19.9", "19.9"]),
    (["--smooth", "hills"], 2, ["hills", "ridges"]),
    (["--unit-mm", "0"], 2, ["--unit-mm", "above 0"]),
    (["--page", "a99"], 2, ["--page", "a4"]),
])  # fmt: skip
def test_impossible_views_are_refused(egg, tmp_path, capsys, options, status, words):
    assert main(["sheet-views", str(egg), str(tmp_path / "egg.svg"), "--quiet", *options]) == status
    said = capsys.readouterr().err
    assert all(word in said for word in words), said
    assert not (tmp_path / "egg.svg").exists()


def test_pixel_formats_are_refused(egg, tmp_path, capsys):
    assert main(["sheet-views", str(egg), str(tmp_path / "egg.png")]) == 1
    assert ".svg" in capsys.readouterr().err


def test_solids_have_centre_lines(tmp_path):
    (tmp_path / "part.csg").write_text("box((4, 2, 1)) - cylinder(0.7, 2, center=(1, 0, 0))\n")
    paths = drawn(tmp_path / "part.csg", tmp_path, "--views", "top", "--centre-lines", "--scale", "10:1", "--up", "z")
    low, high = box_of(paths, "centre lines top")
    assert high - low == pytest.approx((46, 0), abs=0.5)  # only along x, because the hole is off centre


@pytest.fixture(scope="module")
def pin(tmp_path_factory):
    """A pin of radius 10 on a plate of radius 30, with a fillet of radius 3 where they meet and a rounded top edge."""
    quarter = np.linspace(0, np.pi / 2, 9)
    fillet = [(13 - 3 * np.sin(a), 8 - 3 * np.cos(a)) for a in quarter]
    top = [(7 + 3 * np.cos(a), 27 + 3 * np.sin(a)) for a in quarter]
    r, z = np.array([(0, 0), (30, 0), (30, 5), *fillet, *top, (0, 30)]).T
    turn, count = 2 * np.pi * np.arange(48)[:, None] / 48, len(r)
    points = np.stack((r * np.cos(turn), r * np.sin(turn), np.broadcast_to(z, (48, count))), axis=-1).reshape(-1, 3)
    at = np.arange(48 * count).reshape(48, count)
    beside = np.roll(at, -1, 0)
    quads = np.stack((at, beside, np.roll(beside, -1, 1), np.roll(at, -1, 1)), axis=-1)[:, :-1].reshape(-1, 4)
    path = tmp_path_factory.mktemp("views") / "pin.obj"
    path.write_text("".join(["v {:g} {:g} {:g}\n".format(*p) for p in points]
                            + ["f {} {} {} {}\n".format(*q) for q in quads + 1]))  # fmt: skip
    return path


@pytest.mark.parametrize("how, gap", [("thin", 0.0), ("short", 1.5)])
def test_tangent_edges_are_thin_lines(pin, tmp_path, how, gap):
    """From the front, the four circles of both fillets are level lines from one outline to the other."""
    paths = drawn(pin, tmp_path, "--up", "z", "--views", "front,top", "--scale", "1:1", "--tangent", how)
    lines = sorted(paths["tangent front"], key=lambda line: -line[:, 1].mean())
    bottom = box_of(paths, "outlines front")[1][1]
    for line, (height, radius) in zip(lines, ((8, 10), (27, 10))):
        assert bottom - line[:, 1] == pytest.approx(np.full(len(line), height), abs=0.1)
        assert np.ptp(line[:, 0]) == pytest.approx(2 * (radius - gap), abs=0.8)
    assert len(lines) == 2  # the circles in the planes of the plate and of the top coincide with outlines
    low, high = box_of(paths, "tangent top")
    assert high - low == pytest.approx([26, 26], abs=0.1)


def test_tangent_edges_can_be_left_out(pin, tmp_path):
    paths = drawn(pin, tmp_path, "--up", "z", "--views", "front", "--scale", "1:1", "--tangent", "none")
    assert not any(name.startswith("tangent") for name in paths)


def test_scans_have_no_tangent_edges(egg, ring, bush, tmp_path):
    for model in (egg, ring, bush):
        assert not any(name.startswith("tangent") for name in drawn(model, tmp_path, "--views", "front,iso"))


def test_draw_has_tangent_edges_on_request(pin, egg, tmp_path, capsys):
    output = tmp_path / "pin.svg"
    options = ["--style", "silhouette", "--up", "z", "--page", "a5", "--quiet"]
    assert main(["draw", str(pin), str(output), "--lines", "contour,crease,tangent", *options]) == 0
    assert "tangent edge" in paths_of(output)
    assert main(["draw", str(pin), str(output), *options]) == 0
    assert "tangent edge" not in paths_of(output)
    assert main(["draw", str(egg), str(output), "--lines", "tangent", *options]) == 1
    assert "tangent edges need a mesh" in capsys.readouterr().err


def test_a_mesh_tells_its_tangent_edges(pin):
    from hrbfnpr import Mesh
    from hrbfnpr.shapes import read

    shape = read(pin)
    mesh = Mesh(shape.points, shape.triangles)
    sharp = mesh.edges(tangent=True).sharp
    assert (sharp == 2).sum() == 2 * 4 * 48  # four circles, each edge with two sides
    assert ((sharp == 1) == (mesh.edges().sharp == 1)).all() and sharp.max() == 2
    assert mesh.edges().sharp.max() == 1


def test_verified_sheets_carry_how_many_pieces_agree(bush, tmp_path, capsys):
    output = tmp_path / "sheet.svg"
    assert main(["sheet-views", str(bush), str(output), "--up", "z", "--views", "front,top", "--section", "y", "--verify"]) == 0
    said = re.search(r"(\d+) of (\d+) pieces of lines agree with rays; (\d+) undecided, \d+ repaired", capsys.readouterr().err)
    assert said.group(1) == said.group(2)
    assert int(said.group(2)) > 10
    assert said.group(0) in output.read_text()


def test_pictures_can_be_verified(ring, tmp_path, capsys):
    options = ["--style", "silhouette", "--size", "200", "--azimuth", "20", "--elevation", "25"]
    assert main(["draw", str(ring), str(tmp_path / "ring.png"), *options, "--verify"]) == 0
    said = re.search(r"(\d+) of (\d+) pieces of lines agree with rays", capsys.readouterr().err)
    assert said.group(1) == said.group(2)
    assert int(said.group(2)) >= 2
