# SPDX-License-Identifier: MIT
"""Example shapes: their points lie on the surface, have its normals, and are the same each time."""
import numpy as np
import pytest

import hrbfnpr
from hrbfnpr import datasets

MADE = {
    "sphere": datasets.sphere, "torus": datasets.torus, "linked_tori": datasets.linked_tori, "knot": datasets.knot,
    "heart": datasets.heart, "terrain": datasets.terrain,
}  # fmt: skip


def ring(p, radius, tube):
    return np.hypot(np.hypot(p[:, 0], p[:, 1]) - radius, p[:, 2]) - tube


def upright(p):
    q = p - (1, 0, 0)
    return np.column_stack([q[:, 0], q[:, 2], -q[:, 1]])


def knot_distance(p):
    t = np.linspace(0, 2 * np.pi, 20001)[:-1]
    line = np.column_stack([(2 + np.cos(3 * t)) * np.cos(2 * t), (2 + np.cos(3 * t)) * np.sin(2 * t), np.sin(3 * t)])
    return np.array([np.linalg.norm(line - one, axis=1).min() for one in p]) - 0.25


def heart_value(p):
    x, y, z = p.T
    return (x**2 + y**2 + 9 / 4 * z**2 - 1) ** 3 - x**2 * y**3 - 9 / 80 * z**2 * y**3


# Each surface as a function that is 0 on it, with a tolerance.
OF = {
    "sphere": (lambda p: np.linalg.norm(p, axis=1) - 1, 1e-12),
    "torus": (lambda p: ring(p, 1, 0.4), 1e-12),
    "linked_tori": (lambda p: np.minimum(np.abs(ring(p, 1, 0.25)), np.abs(ring(upright(p), 1, 0.25))), 1e-12),
    "knot": (knot_distance, 1e-5),
    "heart": (heart_value, 1e-12),
}


@pytest.mark.parametrize("name", OF)
def test_points_and_vertices_lie_on_the_surface(name):
    value, near = OF[name]
    for shape in (MADE[name](300), MADE[name](mesh=True)):
        assert np.abs(value(shape.points[:800])).max() < near


def slope(value, p):
    h = 1e-5
    return np.column_stack([(value(p + h * axis) - value(p - h * axis)) / (2 * h) for axis in np.eye(3)])


@pytest.mark.parametrize("name", ["sphere", "torus", "heart"])
def test_normals_match_the_formula(name):
    shape = MADE[name](200)
    gradient = slope(OF[name][0], shape.points)
    steep = np.linalg.norm(gradient, axis=1) > 0.01  # the heart's gradient vanishes on a curve
    gradient = gradient[steep] / np.linalg.norm(gradient[steep], axis=1, keepdims=True)
    assert steep.mean() > 0.9
    assert np.abs(gradient - shape.normals[steep]).max() < 1e-3


@pytest.mark.parametrize("name", MADE)
def test_points_are_even_and_seeded(name):
    shape = MADE[name](250)
    assert shape.points.shape == shape.normals.shape == (250, 3) and not shape.is_mesh
    assert np.allclose(np.linalg.norm(shape.normals, axis=1), 1)
    again, other = MADE[name](250), MADE[name](250, seed=2)
    assert np.array_equal(shape.points, again.points) and not np.array_equal(shape.points, other.points)
    away = np.linalg.norm(shape.points[:, None] - shape.points[None], axis=2) + 9 * np.eye(250)
    nearest = away.min(axis=1)
    assert nearest.min() > 0.4 * np.median(nearest)


@pytest.mark.parametrize("name", [name for name in MADE if name != "terrain"])
def test_meshes_are_closed_and_look_outward(name):
    mesh = hrbfnpr.Mesh(*(lambda s: (s.points, s.triangles))(MADE[name](mesh=True)))
    info = mesh.info
    assert info.closed and info.turned_faces == 0 and info.turned_components == 0 and info.degenerate_faces == 0
    parts = 2 if name == "linked_tori" else 1
    genus = {"sphere": 0, "heart": 0, "torus": 1, "knot": 1, "linked_tori": 2}[name]
    assert (info.components, info.genus) == (parts, genus)


def test_terrain_is_an_open_sheet_of_the_given_height():
    shape = datasets.terrain(mesh=True, height=0.2, seed=3)
    assert not hrbfnpr.Mesh(shape.points, shape.triangles).info.closed
    assert (datasets.terrain(300).normals[:, 2] > 0).all()
    assert shape.points[:, 2].std() == pytest.approx(0.2, rel=0.35)
    # The normals, compared with those of the mesh.
    flat = datasets.terrain(400)
    mesh = datasets.terrain(mesh=True)
    near = np.array([np.linalg.norm(mesh.points[:, :2] - p[:2], axis=1).argmin() for p in flat.points])
    assert np.abs(mesh.points[near, 2] - flat.points[:, 2]).max() < 0.03


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: datasets.torus(tube=1.0), "tube must be above 0 and below the radius of 1, not 1"),
        (lambda: datasets.linked_tori(tube=0.5), "or the tori touch"),
        (lambda: datasets.knot(turns=(2, 4)), "without a common divisor"),
        (lambda: datasets.knot(tube=0.5), "at most 0.4"),
        (lambda: datasets.terrain(waves=0), "waves must be at least 1"),
        (lambda: datasets.sphere(0), "count must be at least 1, not 0"),
    ],
)
def test_invalid_arguments_are_named(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_a_missing_bunny_names_the_script_that_fetches_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(datasets, "__file__", str(tmp_path / "package" / "datasets.py"))
    with pytest.raises(FileNotFoundError, match="run scripts/fetch_bunny of a checkout"):
        datasets.bunny()
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    (tmp_path / "copy.obj").write_text(text)
    assert datasets.bunny(tmp_path / "copy.obj").is_mesh
    (tmp_path / ".cache").mkdir()
    (tmp_path / ".cache" / "bunny-1.0.1.obj").write_text(text)
    (tmp_path / "below").mkdir()
    monkeypatch.chdir(tmp_path / "below")
    assert len(datasets.bunny().points) == 3
