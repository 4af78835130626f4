# SPDX-License-Identifier: MIT
"""The command line ends a surface where its points or its mesh end."""
import numpy as np
import pytest

import hrbfnpr
from hrbfnpr.cli import main

SIDE = 20


def terrain():
    x, y = np.meshgrid(np.linspace(0, 1, SIDE), np.linspace(0, 1, SIDE))
    z = 0.05 * np.sin(6 * x) * np.cos(5 * y)
    slope = np.stack([-0.3 * np.cos(6 * x) * np.cos(5 * y), 0.25 * np.sin(6 * x) * np.sin(5 * y), np.ones_like(x)], -1)
    return np.stack([x, y, z], -1).reshape(-1, 3), slope.reshape(-1, 3)


@pytest.fixture
def scan(tmp_path):
    path = tmp_path / "scan.xyz"
    np.savetxt(path, np.column_stack(terrain()))
    return path


def fitted(path, *options):
    target = path.with_suffix(".hrb")
    assert main(["fit", str(path), str(target), *options]) == 0
    return hrbfnpr.Model.load(target)


def test_a_terrain_ends_where_its_points_do(scan, capsys):
    info = fitted(scan).trim_info
    assert info.is_trimmed and info.samples == SIDE**2 and info.parts_to_end == info.parts
    assert "of the diagonal beyond the points" in capsys.readouterr().out


def test_an_open_scan_is_closed_on_request(scan, capsys):
    assert not fitted(scan, "--close").trim_info.is_trimmed
    assert "beyond" not in capsys.readouterr().out


def test_a_saved_model_keeps_its_end(scan, tmp_path, capsys):
    for options, ended in (((), True), (("--close",), False)):
        saved, copy = scan.with_suffix(".hrb"), tmp_path / "copy.hrb"
        assert fitted(scan, *options).trim_info.is_trimmed == ended
        capsys.readouterr()
        assert main(["points", str(saved), str(copy), "--budget", "500"]) == 0
        assert "\nend " not in capsys.readouterr().out


def test_flip_turns_the_sides_of_a_mesh(tmp_path):
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
    path = tmp_path / "cube.obj"
    rows = [f"v {x} {y} {z}\n" for x, y, z in vertices] + [f"f {a} {b} {c} {d}\n" for a, b, c, d in quads]
    path.write_text("".join(rows))
    middle = np.array([[0.5, 0.5, 0.5]])
    inside = fitted(path, "--samples", "100").evaluate(middle).value[0]
    assert inside < 0 < fitted(path, "--samples", "100", "--flip").evaluate(middle).value[0]


def test_a_mesh_fit_ends_with_the_mesh(tmp_path, capsys):
    points, _ = terrain()
    path = tmp_path / "mesh.obj"
    corner = np.arange(SIDE**2).reshape(SIDE, SIDE)
    a, b, c, d = (part.reshape(-1) + 1 for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]))
    rows = [f"v {x} {y} {z}\n" for x, y, z in points] + [f"f {i} {j} {k} {m}\n" for i, j, k, m in zip(a, b, c, d)]
    path.write_text("".join(rows))
    assert fitted(path).trim_info.is_trimmed
    assert "of the diagonal beyond the mesh" in capsys.readouterr().out


def test_a_fit_ends_near_a_self_crossing_mesh(tmp_path, capsys):
    # A box with one corner of its top moved far below its bottom.
    corner, faces = {}, []
    for axis, side, i, j in np.ndindex(3, 2, 5, 5):
        square = []
        for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
            place = [0, 0, 0]
            place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = 5 * side, a, b
            square.append(corner.setdefault(tuple(place), len(corner) + 1))
        faces.append(square if side else square[::-1])
    rows = [f"v {x / 5} {y / 5} {-0.6 if (x, y, z) == (2, 2, 5) else z / 5}\n" for x, y, z in corner]
    path = tmp_path / "mesh.obj"
    path.write_text("".join(rows + ["f {} {} {} {}\n".format(*face) for face in faces]))
    assert fitted(path).trim_info.share > 0.1
    assert "left out, as the mesh has none there: mend faces that cross" in capsys.readouterr().err


def test_the_border_is_drawn(scan, tmp_path, capsys):
    from PIL import Image

    # From above, a terrain has no contour: the line around it is its border.
    picture = str(tmp_path / "out.png")
    options = ["--style", "silhouette", "--size", "200", "--up", "z", "--elevation", "80", "--quiet"]
    assert main(["draw", str(scan), picture, *options]) == 0
    assert (np.asarray(Image.open(picture).convert("L")) < 100).sum() > 300
    assert main(["draw", str(scan), picture, *options, "--close"]) == 3
    assert "would be blank" in capsys.readouterr().err
