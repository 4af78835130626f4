# SPDX-License-Identifier: MIT
"""Triangulation of polygons, also of concave ones."""
import numpy as np
import pytest
from test_shapes import write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.shapes._polygons import MOST_CORNERS, fans, fans_of_block, fans_of_row


def letter_c(turn=np.eye(3)):
    flat = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3)]
    return np.array([(x, y, 0.0) for x, y in flat]) @ np.transpose(turn)


def star(points=7):
    angle = np.pi * np.arange(2 * points) / points
    radius = np.where(np.arange(2 * points) % 2 == 0, 1.0, 0.4)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle])


def areas(points, triangles):
    a, b, c = (points[triangles[..., k]] for k in range(3))
    return np.cross(b - a, c - a) / 2


def whole(points):
    return sum(np.cross(points[i - 1], points[i]) for i in range(len(points))) / 2


def rotation():
    return np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]


@pytest.mark.parametrize("points", [letter_c(), letter_c()[::-1], letter_c(rotation()), star(), np.roll(star(), 1, axis=0)])
@pytest.mark.parametrize("shift", range(4))
def test_triangles_cover_the_polygon_once(points, shift):
    points = np.roll(points, shift, axis=0)
    found = fans_of_block([range(len(points))], points)
    assert found.shape == (1, len(points) - 2, 3)
    area = areas(points, found[0])
    assert (area @ whole(points) > 0).all()  # no triangle is turned over
    assert np.allclose(area.sum(axis=0), whole(points))


def test_convex_polygons_become_fans():
    square = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.1)], dtype=float)
    assert fans_of_block([[0, 1, 2, 3]], square).tolist() == [[[0, 1, 2], [0, 2, 3]]]
    assert fans([[0, 1, 2, 3], [0, 1], [2, 1, 0]], square).tolist() == [[0, 1, 2], [0, 2, 3], [2, 1, 0]]
    assert fans([], square).shape == (0, 3)


def test_a_concave_quad():
    arrow = np.array([(0, 0, 0), (2, -1, 0), (0, 2, 0), (-2, -1, 0)], dtype=float)
    for shift in range(4):
        corners = np.roll(np.arange(4), shift)
        area = areas(arrow, fans_of_block([corners], arrow)[0])
        assert (area[:, 2] > 0).all()


def bent_quads():
    """A ring of quads with a rim that goes up and down, many of which are bent, and some of which are also concave."""
    around = 16
    angle, k = 2 * np.pi * np.arange(around) / around, np.arange(around)
    rings = [(1.0, 0 * k), (0.75, 0.05 + 0.3 * (k % 2)), (0.5, 0.1 + 0 * k), (0.5, -0.4 + 0 * k), (1.0, -0.4 + 0 * k)]
    points = np.array([(r * np.cos(angle[i]), r * np.sin(angle[i]), z[i]) for i in k for r, z in rings])
    quads = [[5 * i + j, (5 * i + 5 + j) % 80, (5 * i + 5 + (j + 1) % 5) % 80, 5 * i + (j + 1) % 5] for i in k for j in range(5)]
    return points, np.array(quads)


def test_bent_quads_are_cut_for_the_least_area():
    points, quads = bent_quads()
    ways = [np.linalg.norm(areas(points, quads[:, cut]), axis=-1).sum(axis=1) for cut in ([[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]])]
    least = np.minimum(*ways)
    assert (np.abs(ways[0] - ways[1]) > 0.01 * least).sum() >= 16
    for turn in range(4):
        for order in (quads, quads[:, ::-1]):
            found = fans_of_block(np.roll(order, turn, axis=1), points)
            assert np.allclose(np.linalg.norm(areas(points, found), axis=-1).sum(axis=1), least, rtol=2e-6)


@pytest.mark.parametrize("lift", [0.0, 0.5, 3.0])
def test_the_diagonal_of_a_bent_concave_quad_is_inside(lift):
    arrow = np.array([(0, 0, lift), (2, -1, 0), (0, 2, lift), (-2, -1, 0)], dtype=float) @ rotation().T
    for shift in range(4):
        found = fans_of_block([np.roll(np.arange(4), shift)], arrow)[0]
        assert all({0, 2} <= set(triangle) for triangle in found.tolist())


def test_a_corner_on_a_side_makes_no_sliver():
    points = np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 1, 0)], dtype=float)
    for shift in range(4):
        area = areas(points, fans_of_block([np.roll(np.arange(4), shift)], points)[0])[:, 2]
        assert np.allclose(area, 0.5)


def test_ears_are_found_in_the_best_plane():
    # The four tips of a star are bent up and down.  Seen along any axis the star crosses itself, but not along its normal.
    flat = star(4)
    bent = flat + np.outer(np.array([1, 0, -1, 0, 1, 0, -1, 0]), (0, 0, 1.2))
    normal, across = np.array([1, 1, 1]) / np.sqrt(3), np.array([1, -1, 0]) / np.sqrt(2)
    tilted = bent @ np.array([across, np.cross(normal, across), normal])
    for shift in range(8):
        found = fans_of_block([np.roll(np.arange(8), shift)], tilted)[0]
        assert (areas(flat, found)[:, 2] > 0).all()


def test_polygons_in_a_row():
    square = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], dtype=float)
    assert fans_of_row([4, 0, 1, 2, 3, 3, 0, 1, 2], square).tolist() == [[0, 1, 2], [0, 2, 3], [0, 1, 2]]
    assert fans_of_row([4, 0, 1, 2, 3], square).tolist() == [[0, 1, 2], [0, 2, 3]]
    assert fans_of_row([2, 0, 1, 2, 0, 1], square).shape == fans_of_row([], square).shape == (0, 3)
    for wrong in ([4, 0, 1], [-1, 0], [3, 0, 1, 2, 5]):
        with pytest.raises(shapes.ShapeError, match="a count and then its corners"):
            fans_of_row(wrong, square)


@pytest.mark.parametrize("name", ["a.obj", "a.off", "a.ply", "a.vtk", "a.vtp", "a.vtu"])
def test_readers_cut_bent_quads_alike(tmp_path, name):
    points, quads = bent_quads()
    lines = [f"{x:.17g} {y:.17g} {z:.17g}" for x, y, z in points]
    rows = ["4 " + " ".join(map(str, quad)) for quad in quads]
    if name.startswith("a.vt"):
        vtk = pytest.importorskip("vtk")
        from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

        place, cells = vtk.vtkPoints(), vtk.vtkCellArray()
        place.SetData(numpy_to_vtk(points))
        cells.SetCells(80, numpy_to_vtkIdTypeArray(np.insert(quads, 0, 4, axis=1).ravel().astype(np.int64), deep=True))
        data = vtk.vtkUnstructuredGrid() if name == "a.vtu" else vtk.vtkPolyData()
        data.SetPoints(place)
        data.SetCells(vtk.VTK_QUAD, cells) if name == "a.vtu" else data.SetPolys(cells)
        kinds = {"a.vtk": vtk.vtkPolyDataWriter, "a.vtp": vtk.vtkXMLPolyDataWriter, "a.vtu": vtk.vtkXMLUnstructuredGridWriter}
        writer = kinds[name]()
        writer.SetInputData(data)
        writer.SetFileName(str(tmp_path / name))
        writer.Write()
    elif name == "a.obj":
        faces = ["f " + " ".join(str(i + 1) for i in quad) for quad in quads]
        write(tmp_path, name, "\n".join([*(f"v {line}" for line in lines), *faces]))
    elif name == "a.off":
        write(tmp_path, name, "\n".join(["OFF", "80 80 0", *lines, *rows]))
    else:
        head = ["ply", "format ascii 1.0", "element vertex 80", *(f"property double {axis}" for axis in "xyz"), "element face 80"]
        write(tmp_path, name, "\n".join([*head, "property list uchar int vertex_indices", "end_header", *lines, *rows, ""]))
    shape = shapes.read(tmp_path / name)
    right = np.linalg.norm(areas(points, fans_of_block(quads, points).reshape(-1, 3)), axis=1).sum()
    assert np.isclose(np.linalg.norm(areas(shape.points, shape.triangles), axis=1).sum(), right, rtol=1e-6)
    assert len(shape.triangles) == 160


def test_a_hole_joined_by_a_slit():
    outer = [(0, 0), (4, 0), (4, 4), (0, 4)]
    inner = [(1, 1), (1, 3), (3, 3), (3, 1)]
    points = np.array([(x, y, 0.0) for x, y in [*outer, outer[0], inner[0], *inner[1:], inner[0]]])
    found = fans_of_block([range(len(points))], points)[0]
    area = areas(points, found)[:, 2]
    assert (area >= 0).all() and np.isclose(area.sum(), 12)


def test_polygons_that_cannot_be_cut_keep_their_fan():
    bow = np.array([(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0.0)])
    assert fans_of_block([[0, 1, 2, 3]], bow).tolist() == [[[0, 1, 2], [0, 2, 3]]]
    broken = bow.copy()
    broken[1] = np.nan
    assert fans_of_block([[0, 1, 2, 3]], broken).tolist() == [[[0, 1, 2], [0, 2, 3]]]
    assert fans_of_block([[0, 1, 9, -3]], bow).tolist() == [[[0, 1, 9], [0, 9, -3]]]  # the reader reports the wrong index
    many = star(MOST_CORNERS)
    assert fans_of_block([range(len(many))], many).shape == (1, len(many) - 2, 3)


@pytest.mark.parametrize("form", ["obj", "off", "ply"])
def test_readers_cut_polygons(tmp_path, form):
    points = np.vstack([letter_c(), letter_c() + (0, 0, 1)])
    faces = [list(range(8)), [8, 9, 10], list(range(15, 7, -1))]
    lines = [f"{x:g} {y:g} {z:g}" for x, y, z in points]
    if form == "obj":
        text = "".join(f"v {line}\n" for line in lines)
        text += "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)
    elif form == "off":
        text = "OFF\n16 3 0\n" + "\n".join(lines) + "\n"
        text += "".join(f"{len(face)} " + " ".join(map(str, face)) + "\n" for face in faces)
    else:
        text = "ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z\n"
        text += "element face 3\nproperty list uchar int vertex_indices\nend_header\n" + "\n".join(lines) + "\n"
        text += "".join(f"{len(face)} " + " ".join(map(str, face)) + "\n" for face in faces)
    shape = shapes.read(write(tmp_path, f"a.{form}", text))
    assert len(shape.triangles) == 13
    area = areas(shape.points, shape.triangles)[:, 2]
    assert np.allclose(area[:6].sum(), whole(letter_c())[2]) and (area[:6] > 0).all()
    assert (area[7:] < 0).all()


@pytest.mark.parametrize("apart", [False, True])
def test_neighbouring_cells_cut_shared_faces_alike(tmp_path, apart):
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
    chance = np.random.default_rng(5)
    places = [tuple(corner) for cell in np.ndindex(3, 3, 3) for corner in corners + cell]
    points = places if apart else sorted(set(places))
    lines = [f"v {x} {y} {z}" for x, y, z in points]
    for cell in range(27):
        for face in faces:
            numbers = [8 * cell + i if apart else points.index(places[8 * cell + i]) for i in face]
            lines.append("f " + " ".join(str(i + 1) for i in np.roll(numbers, chance.integers(4))))
    shape = shapes.read(write(tmp_path, "cells.obj", "\n".join(lines)))
    info = hrbfnpr.Mesh(shape.points, shape.triangles).info
    assert info.closed and np.isclose(info.volume, 27.0) and np.isclose(info.area, 54.0)
