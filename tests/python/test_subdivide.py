# SPDX-License-Identifier: MIT
"""Coarse meshes of round objects are subdivided."""
import numpy as np
import pytest
from convex_hulls import hull_in_a_box, rounded_box
from test_input import obj
from test_shapes import write

import hrbfnpr
from hrbfnpr.cli import main


def icosahedron():
    t = (1 + 5**0.5) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t),
              (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]  # fmt: skip
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
             (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
             (6, 2, 10), (8, 6, 7), (9, 8, 1)]  # fmt: skip
    return np.array(points) / np.hypot(1, t), np.array(faces)


def ball():
    """A sphere of 80 triangles."""
    points, faces = icosahedron()
    middles, quarters = {}, []

    def middle(a, b):
        if (key := (min(a, b), max(a, b))) not in middles:
            middles[key] = len(points) + len(middles)
        return middles[key]

    for a, b, c in faces:
        d, e, f = middle(a, b), middle(b, c), middle(c, a)
        quarters += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    new = np.array([points[a] + points[b] for a, b in middles])
    return np.vstack([points, new / np.linalg.norm(new, axis=1, keepdims=True)]), np.array(quarters)


@pytest.mark.parametrize(
    "options, divided", [([], 2), (["--subdivide", "1"], 1), (["--subdivide", "0"], 0), (["--edges", "10"], 0)]
)
def test_the_command_divides_coarse_round_meshes(tmp_path, capsys, options, divided):
    path = write(tmp_path, "ball.obj", obj(*ball()))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600", *options]) == 0
    said = capsys.readouterr().err
    assert f"divided {divided} time" in said if divided else "divided" not in said


def bevelled_cube():
    """A cube with flat faces and round edges; its other faces are narrow."""
    line = np.array([-0.5, -0.48, -0.45, 0.45, 0.48, 0.5])
    side = len(line)
    a, b = np.meshgrid(line, line, indexing="ij")
    points, faces = [], []
    for axis in range(3):
        for end in (-0.5, 0.5):
            first = len(points) * side**2
            grid = np.full((side**2, 3), end)
            grid[:, (axis + 1) % 3], grid[:, (axis + 2) % 3] = a.ravel(), b.ravel()
            points.append(grid)
            for k in (first + row * side + column for row in range(side - 1) for column in range(side - 1)):
                two = [(k, k + side, k + side + 1), (k, k + side + 1, k + 1)]
                faces += two if end > 0 else [face[::-1] for face in two]
    grid = np.vstack(points)
    inner = np.clip(grid, -0.45, 0.45)
    out = (grid - inner) / np.linalg.norm(grid - inner, axis=1, keepdims=True)
    return inner + 0.05 * out, np.array(faces)


# Round parts are narrow here: an edge as long as a face does not count as coarse.
def test_a_bevelled_cube_is_not_divided(tmp_path, capsys):
    points, faces = bevelled_cube()
    path = write(tmp_path, "cube.obj", obj(points, faces))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    out, said = capsys.readouterr()
    assert "divided" not in said and "warning" not in said
    assert "left out" not in out


@pytest.mark.parametrize("hull", (rounded_box, hull_in_a_box))
def test_a_convex_hull_is_not_subdivided(hull, tmp_path, capsys):
    path = write(tmp_path, "hull.obj", obj(*hull()))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    said = capsys.readouterr().err
    assert "divided" not in said and "off the mesh in places" not in said
    # Faces so coarse that they are seen to be flat are not divided for a try.
    assert ("no round shape fits them" in said) == (hull is rounded_box)


def test_notes_of_the_search_for_edges_are_not_repeated(tmp_path, capsys):
    points, faces = ball()
    path = write(tmp_path, "two.obj", obj(np.vstack([points, points + [2.003, 0, 0]]), np.vstack([faces, faces + 42])))
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    assert capsys.readouterr().err.count("cross or nearly touch") == 1


def test_a_python_call_divides_meshes_too():
    points, faces = ball()
    picture = hrbfnpr.draw((points, faces), size=60)
    assert any("the faces are coarse" in note for note in picture.notes)
