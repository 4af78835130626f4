# SPDX-License-Identifier: MIT
"""Surfaces end where their samples end."""
import math

import pytest

import hrbfnpr

WHOLE = 1500


def zone(low, tilt=0):
    """Even samples of the unit sphere above a plane, which are their own normals. `tilt` slants the plane."""
    points = []
    for i in range(WHOLE):
        z = 1 - (2 * i + 1) / WHOLE
        r, turn = math.sqrt(1 - z * z), 2.399963229728653 * i
        if z + tilt * r * math.cos(turn) > low:
            points.append((r * math.cos(turn), r * math.sin(turn), z))
    return points


def heights(marks):
    """The marks' coordinates along (1, 0, 1)."""
    x, _, z = marks.origin
    return [(row[0] + x + row[2] + z) / math.sqrt(2) for row in marks.layers[0].positions.tolist()]


def test_a_fit_ends_where_its_samples_do():
    cap = zone(0.0, 1.0)
    model = hrbfnpr.Model.fit(cap, cap)
    whole = hrbfnpr.Model.fit(cap, cap, trim="never")
    assert model.trim_info == whole.trim(cap, cap).trim_info and model.trim_info.is_trimmed
    assert min(heights(whole.generate(budget=2000))) < 1.5 * min(heights(model.generate(budget=2000)))
    ball = zone(-1.0)
    info = hrbfnpr.Model.fit(ball, ball).trim_info
    assert not info.is_trimmed and info.samples == WHOLE
    with pytest.raises(ValueError, match="'never', 'auto'"):
        hrbfnpr.Model.fit(cap, cap, trim="often")


def test_a_smooth_open_mesh_ends_straight_along_its_border():
    n = 41
    grid = [
        (x / (n - 1), y / (n - 1), 0.1 * math.sin(6 * x / n) * math.cos(5 * y / n)) for y in range(n) for x in range(n)
    ]
    cells = [n * y + x for y in range(n - 1) for x in range(n - 1)]
    triangles = [t for i in cells for t in ((i, i + 1, i + n + 1), (i, i + n + 1, i + n))]
    marks = hrbfnpr.Model.fit_mesh(hrbfnpr.Mesh(grid, triangles)).generate(budget=40000)
    farthest = [0.0] * 50  # from the four sides, in strips 0.02 wide
    for row in marks.layers[0].positions.tolist():
        x, y = row[0] + marks.origin[0], row[1] + marks.origin[1]
        for out, along in ((x, y), (y, x), (1 - x, y), (1 - y, x)):
            strip = int(50 * along)
            if 2 <= strip < 48:
                farthest[strip] = max(farthest[strip], out)
    assert 0.996 < min(farthest[2:48]) and max(farthest) < 1.001


def test_given_samples_decide_where_a_model_ends():
    ball = zone(-1.0)
    model = hrbfnpr.Model.fit(ball, ball)
    assert not model.trim().trim_info.is_trimmed
    cap = zone(0.0)
    for normals in (cap, None):
        info = model.trim(cap, normals).trim_info
        assert info.is_trimmed and info.samples == len(cap) and 0.3 < info.share < 0.6
    assert not model.trim(cap, hole=1.0).trim_info.is_trimmed


def test_a_function_is_trimmed_too():
    def value(points):
        return [math.hypot(*point) - 1 for point in points.tolist()]

    model = hrbfnpr.Model.from_function(value, bounds=((-1, -1, -1), (1, 1, 1)))
    cap = zone(0.0)
    info = model.trim(cap, cap).trim_info
    assert info.is_trimmed and info.parts == 1
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="trim_desc.points is empty"):
        model.trim()


def test_coarse_round_walls_have_no_holes():
    """A bowl with ten flat sides. The fitted surface bulges by 1 % of the diagonal over them, which is not an error."""
    sides, rows = 10, 5
    vertices = [(0.0, 0.0, 0.0)]
    for row in range(rows + 1):
        radius = 0.6 + 0.5 * math.sin(math.pi * (0.15 + 0.7 * row / rows))
        turns = [2 * math.pi * i / sides for i in range(sides)]
        vertices += [(radius * math.cos(turn), radius * math.sin(turn), row / rows) for turn in turns]
    faces = [(0, 1 + (i + 1) % sides, 1 + i) for i in range(sides)]
    for row in range(rows):
        for i in range(sides):
            p, q = 1 + row * sides + i, 1 + row * sides + (i + 1) % sides
            faces += [(p, q, q + sides), (p, q + sides, p + sides)]
    mesh = hrbfnpr.Mesh(vertices, faces)
    diagonal = math.dist(mesh.info.bounds_min, mesh.info.bounds_max)
    bowl = hrbfnpr.Model.fit_mesh(mesh, edges="sharp", crease_angle=60.0, far=0.02 * diagonal)
    assert bowl.mesh_fit.mesh_p99 > 0.009 * diagonal
    assert bowl.trim_info.share < 0.16  # the open top alone; with holes in the walls it is 0.31


def quarter(steps):
    return [0.5 * math.pi * k / steps for k in range(steps + 1)]


def test_a_narrow_trough_ends_at_its_border():
    """The trough is narrow, but points on a mesh are not taken for points along curves: its top stays open."""
    length, around = 80, 10
    ends = [(-math.cos(a), math.sin(a)) for a in quarter(5)[1:]]
    stations = ends + [(length - x, r) for x, r in reversed(ends)]
    turns = [math.pi * i / around for i in range(around + 1)]
    vertices = [(x, r * math.cos(a), -r * math.sin(a)) for x, r in stations for a in turns]
    n, last = len(turns), (len(stations) - 1) * len(turns)
    corners = [n * j + i for j in range(len(stations) - 1) for i in range(around)]
    triangles = [t for i in corners for t in ((i, i + 1, i + n + 1), (i, i + n + 1, i + n))]
    vertices += [(-1, 0, 0), (length + 1, 0, 0)]
    triangles += [t for i in range(around) for t in ((last + n, i + 1, i), (last + n + 1, last + i, last + i + 1))]
    model = hrbfnpr.Model.fit_mesh(hrbfnpr.Mesh(vertices, triangles))
    marks = model.generate(budget=2000)
    assert max(row[2] + marks.origin[2] for row in marks.layers[0].positions.tolist()) < 0.1


def test_a_tray_with_small_faces_at_its_corners_stays_open():
    """Most faces lie at the round edges, and rays from inside hardly leave there. Most of the area is elsewhere."""
    width, depth, height, radius, rim = 5.8, 5.1, 0.28, 0.05, 0.12
    turns = quarter(5)
    profile = [(radius * (1 - math.sin(a)), radius * (1 - math.cos(a))) for a in turns]
    profile += [(radius * (1 - math.cos(a)), height - radius * (1 - math.sin(a))) for a in turns]
    profile += [(rim, height), (rim, height - 0.03)]
    vertices = []
    for inward, z in profile:
        r, off = radius - min(inward, radius), max(inward, radius)
        for k, (x, y) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
            for a in (turn + 0.5 * math.pi * k for turn in turns):
                vertices.append(
                    (x * (width / 2 - off) + r * math.cos(a), y * (depth / 2 - off) + r * math.sin(a), z)
                )
    n = 4 * len(turns)
    sides = [(n * j + i, n * j + (i + 1) % n) for j in range(len(profile) - 1) for i in range(n)]
    triangles = [t for a, b in sides for t in ((a, b, b + n), (a, b + n, a + n))]
    triangles += [(0, i + 1, i) for i in range(1, n - 1)]
    model = hrbfnpr.Model.fit_mesh(hrbfnpr.Mesh(vertices, triangles), edges="sharp")
    marks = model.generate(budget=4000)
    places = [[a + b for a, b in zip(row, marks.origin)] for row in marks.layers[0].positions.tolist()]
    within = [z for x, y, z in places if abs(x) < 2.7 and abs(y) < 2.3]
    assert len(within) > 2000 and max(within) < 0.02


def test_lines_of_a_flat_drawing_keep_their_width():
    """A flat frame whose bars are 1 % of its width, like the lines of letters."""
    outer, inner = [(0, 0), (10, 0), (10, 6), (0, 6)], [(0.12, 0.12), (9.88, 0.12), (9.88, 5.88), (0.12, 5.88)]
    vertices = [(x, y, 0) for x, y in outer + inner]
    triangles = [t for i in range(4) for t in ((i, (i + 1) % 4, (i + 1) % 4 + 4), (i, (i + 1) % 4 + 4, i + 4))]
    marks = hrbfnpr.Model.fit_mesh(hrbfnpr.Mesh(vertices, triangles)).generate(budget=4000)
    places = [[a + b for a, b in zip(row, marks.origin)] for row in marks.layers[0].positions.tolist()]
    within = [min(x, y, 10 - x, 6 - y) for x, y, _ in places]  # distance from the outer side
    assert -0.02 < min(within) and max(within) < 0.14
