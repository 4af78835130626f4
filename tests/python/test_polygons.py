# SPDX-License-Identifier: MIT
"""Triangulation of polygons, also of concave ones."""
import numpy as np
import pytest
from test_shapes import write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.shapes._polygons import MOST_CORNERS, fans, fans_of_block


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
