# SPDX-License-Identifier: MIT
"""Open parts of a mesh: each is fitted and drawn separately, in one picture."""
import numpy as np
import pytest
from test_input import obj, tube
from test_shapes import write

import hrbfnpr
from hrbfnpr import Mesh, batch
from hrbfnpr.cli import main

Image = pytest.importorskip("PIL.Image")


def triangles(faces):
    return [(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)]


def merged(*parts):
    """Vertices and triangles of several meshes, as one mesh."""
    vertices, faces, first = [], [], 0
    for points, some in parts:
        vertices.append(points)
        faces += [[first + corner for corner in face] for face in triangles(some)]
        first += len(points)
    return np.vstack(vertices), np.array(faces)


def moved(part, by, turned=False):
    points, faces = part
    return (points[:, [2, 0, 1]] if turned else points) + np.array(by, dtype=float), faces


def pipe(ends=False):
    return tube(ends=ends)


def crossing(ends=False):
    return merged(pipe(), moved(pipe(ends), (-1, 1.5, 0.3), turned=True))


def wall(corner, along, up, count=12):
    steps = np.linspace(0, 1, count + 1)
    points = np.array([np.array(corner) + u * np.array(along) + v * np.array(up) for v in steps for u in steps], dtype=float)
    row = count + 1
    return points, [(r * row + c, r * row + c + 1, r * row + c + row + 1, r * row + c + row) for r in range(count)
                    for c in range(count)]  # fmt: skip


@pytest.fixture(scope="module")
def picture():
    return hrbfnpr.draw(crossing(), size=400, marks={"stipples": 6000}, azimuth=70)


def test_marks_lie_on_both_parts_only(picture):
    parts = picture._scene.parts
    assert len(parts) == 2
    assert any("2 parts cross or nearly touch" in note for note in picture.notes)
    count = []
    for marks in (part.marks for part in parts):
        places = np.concatenate([np.asarray(layer.positions, dtype=float) for layer in marks.layers]) + marks.origin
        apart = [places - (0, 0, 0), (places - (-1, 1.5, 0.3))[:, [1, 2, 0]]]
        off = min(np.abs(np.hypot(p[:, 0], p[:, 2]) - 1).max() for p in apart)
        assert off < 0.02  # the faces are flat: 0.0086
        count.append(len(marks))
    assert abs(count[0] / count[1] - 1) < 0.05  # the parts are equally large
    assert abs(sum(count) - 6000) < 100
    assert f"{sum(count)} marks" in repr(picture)


def test_separate_parts_give_no_warning(tmp_path, capsys):
    vertices, faces = crossing()
    path = str(write(tmp_path, "a.obj", obj(vertices, faces.tolist())))
    assert main(["draw", path, str(tmp_path / "a.png"), "--size", "200", "--also", str(tmp_path / "a.svg")]) == 0
    said = capsys.readouterr()
    assert "warning" not in said.err and said.out.count("\nfit ") == 2
    assert (tmp_path / "a.svg").read_text().count("<g") > 1
    assert main(["draw", path, str(tmp_path / "b.png"), "--size", "200", "--together"]) == 0
    said = capsys.readouterr()
    assert "nearly touch: drawn as" not in said.err and said.out.count("\nfit ") == 1
    assert main(["draw", path, str(tmp_path / "c.png"), "--size", "200", "--save-model", str(tmp_path / "c.hrbf")]) == 0
    assert capsys.readouterr().out.count("\nfit ") == 1  # --save-model saves one model


def test_an_animation_shows_all_parts():
    options = {"size": 80, "marks": 1500, "frames": 3}
    here = list(hrbfnpr.animate(crossing(), **options).images())
    assert min((image[..., 0] < 128).sum() for image in here) > 100
    pytest.importorskip("distributed", reason="dask.distributed is not installed (Debian: python3-distributed)")
    there = dict(batch.frames_of(crossing(), workers=1, **options))
    assert all(np.array_equal(there[i], here[i]) for i in range(3))


def surface_of_rings(radius, height):
    """A surface of revolution about y, from the radius and height of each of fifteen rings."""
    angle = 2 * np.pi * np.arange(60) / 60
    rings = [np.column_stack([r * np.cos(angle), 0 * angle + y, r * np.sin(angle)]) for r, y in zip(radius, height)]
    faces = [(60 * k + i, 60 * (k + 1) + i, 60 * (k + 1) + (i + 1) % 60, 60 * k + (i + 1) % 60)
             for k in range(len(rings) - 1) for i in range(60)]  # fmt: skip
    return np.vstack(rings), faces


def test_surface_beyond_a_border_is_no_error():
    """Two pipes in line and a flange between them: a sheet continues from one pipe into the other."""
    along = np.linspace(0, 1, 15)
    pipes = [surface_of_rings(np.ones(15), along), surface_of_rings(np.ones(15), 1.2 + along)]
    mesh = Mesh(*merged(*pipes, surface_of_rings(1 - 0.5 * along, np.ones(15))), parts="all")
    model = hrbfnpr.Model.fit_mesh(mesh, edges="sharp")
    everywhere = model.compare(mesh)
    assert everywhere.surface_max > 0.1 * everywhere.diagonal  # the sheets continue, and are trimmed
    assert model.mesh_fit.surface_max < 0.05 * everywhere.diagonal
    assert model.mesh_fit.mesh_share > 0.99


def test_a_picture_in_the_plane_of_a_wall_is_drawn():
    """The picture's border lies in the wall. The search for crossings of the border once never ended."""
    picture = hrbfnpr.draw(
        merged(wall((0, 0, 0), (3, 0, 0), (0, 2, 0)), wall((1, 0.5, 0), (1, 0, 0), (0, 1, 0), 5)), size=200, up="y", azimuth=20
    )
    assert picture.drawing.info.items == 2 and picture.drawing.info.line_curves >= 2


def columns(path):
    """Mean ink of each pixel column, from a fifth to four fifths of the width, in the middle rows."""
    with Image.open(path) as image:
        paper = Image.new("RGBA", image.size, "white")
        paper.alpha_composite(image.convert("RGBA"))
    ink = 1 - np.asarray(paper.convert("L")) / 255.0
    height, width = ink.shape
    mean = np.convolve(ink[int(0.4 * height) : int(0.6 * height)].mean(axis=0), np.ones(3) / 3, "same")
    return mean[int(0.2 * width) : int(0.8 * width)]


def test_touching_parts_have_no_gap(tmp_path):
    floor, side = wall((0, 0, 0), (1, 0, 0), (0, 1, 0), 5), wall((1, -0.1, 0), (0, 1.2, 0), (0.3, 0, -1), 7)
    points, faces = merged(floor, (side[0], [face[::-1] for face in side[1]]))
    picture = tmp_path / "seam.png"
    assert main(["draw", str(write(tmp_path, "seam.obj", obj(points, faces))), str(picture), "--size", "400", "--quiet"]) == 0
    ink = columns(picture)
    assert ink.max() > 1.5 * ink[: len(ink) // 3].mean()  # the second part is drawn
    assert ink.min() > 0.8 * ink[: len(ink) // 3].mean()


def test_crossing_parts_do_not_shine_through(tmp_path):
    one, other = wall((0, 0, 0), (1, 0, 0.6), (0, 1, 0), 6), wall((0, 0.1, 0.6), (1, 0, -0.6), (0, 1, 0), 6)
    picture = tmp_path / "cross.png"
    file = write(tmp_path, "cross.obj", obj(*merged(one, other)))
    assert main(["draw", str(file), str(picture), "--size", "400", "--lines", "none", "--quiet"]) == 0
    ink = columns(picture)
    assert ink.max() < 1.2 * np.quantile(ink, 0.9)
