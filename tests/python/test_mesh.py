# SPDX-License-Identifier: MIT
"""Meshes: creating, sampling, fitting and comparing them."""
import math

import numpy as np
import pytest

import hrbfnpr

TURN = 2 * np.pi


def torus(around=60, along=24, tube=0.4):
    """Vertices and triangles of a torus about the z axis."""
    u, v = np.meshgrid(np.arange(around) / around, np.arange(along) / along, indexing="ij")
    radius = 1 + tube * np.cos(TURN * v)
    points = np.stack([radius * np.cos(TURN * u), radius * np.sin(TURN * u), tube * np.sin(TURN * v)], axis=-1)
    i, j = np.meshgrid(np.arange(around), np.arange(along), indexing="ij")
    k, m = (i + 1) % around, (j + 1) % along
    a, b, c, d = i * along + j, k * along + j, k * along + m, i * along + m
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)


@pytest.fixture(scope="module")
def ring():
    return hrbfnpr.Mesh(*torus())


def test_info_and_views(ring):
    vertices, triangles = torus()
    info = ring.info
    assert info.closed is True and info.genus == 1 and info.components == 1
    assert info.faces == len(triangles) and info.vertices == len(vertices)
    assert info.creases is False
    assert info.volume == pytest.approx(2 * np.pi**2 * 0.16, rel=0.02)
    np.testing.assert_array_equal(ring.vertices, vertices)
    np.testing.assert_array_equal(ring.triangles, triangles)
    assert ring.triangles.dtype == np.int32 and not ring.vertices.flags.writeable
    assert ring.components.max() == 0 and ring.given_faces[5] == 5
    assert ring.corner_normals.shape == (len(triangles), 3, 3)
    assert "1440 vertices, 2880 faces" in repr(ring)


@pytest.mark.parametrize("kind", [np.int32, np.int64, np.uint32, np.int16, list])
def test_types_of_indices(kind):
    vertices, triangles = torus(12, 6)
    triangles = triangles.tolist() if kind is list else triangles.astype(kind)
    assert hrbfnpr.Mesh(vertices.astype(np.float32), triangles).info.faces == 144


def test_parts_can_be_chosen():
    vertices, triangles = torus()
    both = np.concatenate([vertices, vertices * [1, 1, 0.1] * [0.98, 0.98, 1]])
    inner = np.concatenate([vertices, 0.1 * vertices + [1, 0, 0]])
    faces = np.concatenate([triangles, triangles + len(vertices)])
    info = hrbfnpr.Mesh(inner, faces).info
    assert (info.components, info.nested_components, info.left_out_components) == (2, 1, 1)
    assert hrbfnpr.Mesh(inner, faces, parts="all").info.faces == len(faces)
    assert hrbfnpr.Mesh(both, faces, parts="largest").info.faces == len(triangles)
    with pytest.raises(ValueError, match="parts must be one of 'outer', 'all', 'largest'"):
        hrbfnpr.Mesh(inner, faces, parts="some")


def test_errors_name_the_face():
    vertices, triangles = torus(12, 6)
    triangles[7, 1] = 72
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"triangles\[7\] has the index 72; there are 72 vertices"):
        hrbfnpr.Mesh(vertices, triangles)
    vertices, triangles = torus(12, 6)
    vertices[3, 2] = np.nan
    with pytest.raises(hrbfnpr.InvalidArgumentError, match=r"vertices\[3\], a corner of triangles\["):
        hrbfnpr.Mesh(vertices, triangles)


def test_samples_are_even_and_deterministic(ring):
    points, normals = ring.sample(200)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1)
    middle = points * [1, 1, 0]
    middle /= np.linalg.norm(middle, axis=1)[:, None]
    np.testing.assert_allclose(np.linalg.norm(points - middle, axis=1), 0.4, atol=0.01)
    np.testing.assert_allclose(normals, (points - middle) / 0.4, atol=0.05)
    np.testing.assert_array_equal(points, ring.sample(200).points)
    np.testing.assert_array_equal(points[:50], ring.sample(50, candidates=8000).points)
    assert not np.array_equal(points, ring.sample(200, random_seed=2).points)


def test_farthest_points_match_a_plain_search():
    points = np.random.default_rng(1).random((400, 3))
    indices, distances = hrbfnpr.farthest_points(points, 60)
    assert indices.dtype == np.int64 and distances[0] == np.inf
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    nearest = np.full(len(points), np.inf)
    place = int(np.argmin(((points - middle) ** 2).sum(axis=1)))
    for i in range(60):
        assert indices[i] == place
        if i:
            assert distances[i] == pytest.approx(np.sqrt(nearest[place]))
        nearest = np.minimum(nearest, ((points - points[place]) ** 2).sum(axis=1))
        place = int(np.argmax(nearest))
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="indices.count is 500"):
        hrbfnpr.farthest_points(points, 500)


def test_fit_and_compare(ring):
    seen = []
    model = hrbfnpr.Model.fit_mesh(ring, tolerance=0.01, progress=seen.append)
    fit = model.mesh_fit
    assert fit.reached is True and fit.supported is False
    assert fit.tolerance == 0.01 and fit.centres == model.info.centres == len(model.points)
    assert seen == sorted(seen) and seen[-1] == 1.0
    compared = model.compare(ring, tolerance=0.01, points=2000)
    assert compared.mesh_share > 0.99 and compared.surface_share > 0.99
    assert compared.surface_max < 0.05 and compared.genus == 1 and compared.surface_points == 2000
    other = hrbfnpr.Model.from_function(lambda p: np.linalg.norm(p, axis=1) - 1, bounds=((-1, -1, -1), (1, 1, 1)))
    assert other.mesh_fit is None
    assert other.compare(ring, points=500).missed_share > 0.5
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="mesh_fit_desc.share is 2"):
        hrbfnpr.Model.fit_mesh(ring, share=2)


def test_sharp_edges_and_smooth_fits_of_a_cube(tmp_path):
    vertices = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    cube = hrbfnpr.Mesh(vertices, [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))])
    sharp = hrbfnpr.Model.fit_mesh(cube)
    assert sharp.mesh_fit.sheets == 6 and sharp.mesh_fit.reached and sharp.mesh_fit.poor_cells == 0
    assert abs(sharp.mesh_fit.crease_length - 12) < 1e-6 and sharp.mesh_fit.smooth_length == 0
    edge = np.stack([np.linspace(0.01, 0.99, 50), np.zeros(50), np.ones(50)], axis=1)
    assert np.abs(sharp.evaluate(edge).value).max() < 1e-6
    assert len(sharp.points) > 1000 > sharp.mesh_fit.centres == sharp.info.centres
    smooth = hrbfnpr.Model.fit_mesh(cube, edges="smooth", maximum_centres=500)
    assert smooth.mesh_fit.sheets == 1 and np.abs(smooth.evaluate(edge).value).max() > 1e-4
    coarse = hrbfnpr.Model.fit_mesh(cube, edges="sharp", crease_angle=100)
    assert coarse.mesh_fit.sheets == 6  # still sharp, because a smooth fit would be far off
    sharp.save(tmp_path / "cube.hrbf")
    assert np.array_equal(hrbfnpr.Model.load(tmp_path / "cube.hrbf").evaluate(edge).value, sharp.evaluate(edge).value)
    with pytest.raises(ValueError, match="edges"):
        hrbfnpr.Model.fit_mesh(cube, edges="round")


def test_closing():
    mesh = hrbfnpr.Mesh(*torus(12, 6))
    mesh.close()
    assert repr(mesh) == "<hrbfnpr.Mesh closed>"


def test_flat_faces_next_to_soft_bevels_stay_flat():
    """A slab with rounded corners. The bevel of its upper edge bends less than a crease does."""
    steps, radius, inset, drop = 4, 1.2, 0.6, 0.3
    vertices = []
    for inward, z in ((0, 0), (0, 1 - drop), (inset, 1)):
        for k, (x, y) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
            for a in (0.5 * math.pi * (k + s / steps) for s in range(steps + 1)):
                r = radius - inward
                vertices.append((x * (5 - radius) + r * math.cos(a), y * (3 - radius) + r * math.sin(a), z))
    n = 4 * (steps + 1)
    triangles = [(0, i + 1, i) for i in range(1, n - 1)] + [(2 * n, 2 * n + i, 2 * n + i + 1) for i in range(1, n - 1)]
    sides = [(j + i, j + (i + 1) % n) for j in (0, n) for i in range(n)]
    triangles += [t for a, b in sides for t in ((a, b, b + n), (a, b + n, a + n))]
    model = hrbfnpr.Model.fit_mesh(hrbfnpr.Mesh(vertices, triangles), edges="sharp")
    marks = model.generate(budget=4000)
    assert max(row[2] + marks.origin[2] for row in marks.layers[0].positions.tolist()) < 1.005


def test_edges_of_a_box_separate_its_faces():
    corners = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    mesh = hrbfnpr.Mesh(corners, [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))])
    found = mesh.edges()
    assert (found.info.edges, found.info.patches) == (12, 6)
    assert found.info.length == pytest.approx(12.0)
    assert found.sharp.shape == (12, 3) and found.sharp.sum() == 2 * 12
    assert sorted(np.bincount(found.patches)) == [2] * 6
    assert mesh.edges(edges="smooth").info.patches == 1
    with pytest.raises(hrbfnpr.InvalidArgumentError, match="crease_angle is 200"):
        mesh.edges(crease_angle=200.0)
