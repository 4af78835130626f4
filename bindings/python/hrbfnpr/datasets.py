# SPDX-License-Identifier: MIT
"""Shapes to try things out: surfaces of formulas, exact except for rounding, and the Stanford bunny.  Needs NumPy.

Each function returns a `Shape`.  By default it holds `count` evenly spread points with unit normals that point outward.
With ``mesh=True`` it is a triangle mesh whose vertices lie on the surface.  The same arguments give the same shape; another
`seed` gives other points, or another terrain.

>>> points = hrbfnpr.datasets.torus(500)
>>> hrbfnpr.draw(points, "hatch")
>>> hrbfnpr.draw(hrbfnpr.datasets.knot(mesh=True))
"""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np

from ._mesh import farthest_points
from .shapes import Shape, read
from .shapes._shape import Floats, Integers

_CANDIDATES = 24  # number of random places on a surface from which each point is chosen
_BUNNY = Path(".cache") / "bunny-1.0.1.obj"  # where scripts/fetch_bunny puts it in a checkout

Surface = Callable[[Floats, Floats], Tuple[Floats, Floats]]
"""A map from parameters in [0, 1), shape (n,) each, to points and unit normals, shape (n, 3) each."""


def sphere(count: int = 400, *, radius: float = 1.0, mesh: bool = False, seed: int = 1) -> Shape:
    """Return a sphere around the origin: x² + y² + z² = radius²."""

    def at(directions: Floats) -> Tuple[Floats, Floats]:
        return radius * directions, directions

    return _round(at, count, mesh, seed, "sphere")


def torus(
    count: int = 600, *, radius: float = 1.0, tube: float = 0.4, mesh: bool = False, seed: int = 1
) -> Shape:
    """Return a torus around the z axis: (√(x² + y²) − radius)² + z² = tube², 0 < tube < radius."""
    if not 0 < tube < radius:
        raise ValueError(f"tube must be above 0 and below the radius of {radius:g}, not {tube:g}")
    return _sheet(_torus(radius, tube), count, mesh, seed, "torus", (96, 40), (True, True))


def _torus(radius: float, tube: float) -> Surface:
    def at(u: Floats, v: Floats) -> Tuple[Floats, Floats]:
        a, b = 2 * np.pi * u, 2 * np.pi * v
        normals = np.column_stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])
        middle = np.column_stack([np.cos(a), np.sin(a), 0 * a])
        return radius * middle + tube * normals, normals

    return at


def linked_tori(count: int = 1000, *, tube: float = 0.25, mesh: bool = False, seed: int = 1) -> Shape:
    """Return two tori of radius 1 that go through each other's holes.

    One is around the z axis; the other is around an axis parallel to y, with its middle at x = 1.  `tube` is above 0 and
    below 0.5, so that they do not touch.
    """
    if not 0 < tube < 0.5:
        raise ValueError(f"tube must be above 0 and below 0.5, or the tori touch, not {tube:g}")
    flat = _torus(1.0, tube)

    def upright(u: Floats, v: Floats) -> Tuple[Floats, Floats]:
        points, normals = flat(u, v)
        turned = [np.column_stack([a[:, 0], -a[:, 2], a[:, 1]]) for a in (points, normals)]  # by 90° about the x axis
        return turned[0] + (1.0, 0.0, 0.0), turned[1]

    first, second = (count + 1) // 2, count // 2
    parts = [
        _sheet(at, max(number, 1), mesh, seed + i, "linked tori", (96, 28), (True, True))
        for i, (at, number) in enumerate(((flat, first), (upright, second)))
    ]
    return _joined(parts)


def knot(
    count: int = 1500, *, turns: Tuple[int, int] = (2, 3), tube: float = 0.25, mesh: bool = False, seed: int = 1
) -> Shape:
    """Return a tube around the torus knot ((2 + cos qt) cos pt, (2 + cos qt) sin pt, sin qt), (p, q) = `turns`.

    The default is a trefoil.  p and q have no common divisor.  `tube` is the radius of the tube, above 0 and at most 0.4,
    so that the tube does not touch itself.
    """
    p, q = turns
    if np.gcd(p, q) != 1 or min(p, q) < 1:
        raise ValueError(f"turns must be two numbers of at least 1 without a common divisor, not {turns}")
    if not 0 < tube <= 0.4:
        raise ValueError(f"tube must be above 0 and at most 0.4, not {tube:g}")

    def at(u: Floats, v: Floats) -> Tuple[Floats, Floats]:
        middle, first, second = _knot_line(2 * np.pi * u, p, q)
        tangent = first / np.linalg.norm(first, axis=1, keepdims=True)
        across = second - (second * tangent).sum(axis=1, keepdims=True) * tangent
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        angle = 2 * np.pi * v[:, None]
        normals: Floats = np.cos(angle) * across + np.sin(angle) * np.cross(tangent, across)
        return middle + tube * normals, normals

    return _sheet(at, count, mesh, seed, "knot", (64 * max(p, q), 24), (True, True))


def _knot_line(t: Floats, p: int, q: int) -> Tuple[Floats, Floats, Floats]:
    """The middle line of the knot, and its first two derivatives."""
    r, r1, r2 = 2 + np.cos(q * t), -q * np.sin(q * t), -q * q * np.cos(q * t)
    c, s = np.cos(p * t), np.sin(p * t)
    line = np.column_stack([r * c, r * s, np.sin(q * t)])
    first = np.column_stack([r1 * c - p * r * s, r1 * s + p * r * c, q * np.cos(q * t)])
    second = np.column_stack([
        r2 * c - 2 * p * r1 * s - p * p * r * c, r2 * s + 2 * p * r1 * c - p * p * r * s, -q * q * np.sin(q * t)
    ])  # fmt: skip
    return line, first, second


def heart(count: int = 800, *, mesh: bool = False, seed: int = 1) -> Shape:
    """Return a heart, upright along y (Taubin, 1994): (x² + y² + 9/4 z² − 1)³ = x² y³ + 9/80 z² y³."""

    def value(points: Floats) -> Floats:
        x, y, z = points.T
        result: Floats = (x**2 + y**2 + 2.25 * z**2 - 1) ** 3 - x**2 * y**3 - 0.1125 * z**2 * y**3
        return result

    def at(directions: Floats) -> Tuple[Floats, Floats]:
        # Each ray from the origin crosses the surface once.
        low, high = np.zeros(len(directions)), np.full(len(directions), 2.0)
        for _ in range(60):
            middle = (low + high) / 2
            inside = value(middle[:, None] * directions) < 0
            low, high = np.where(inside, middle, low), np.where(inside, high, middle)
        points = ((low + high) / 2)[:, None] * directions
        x, y, z = points.T
        level = 3 * (x**2 + y**2 + 2.25 * z**2 - 1) ** 2
        gradient = np.column_stack([
            2 * x * level - 2 * x * y**3, 2 * y * level - 3 * y**2 * (x**2 + 0.1125 * z**2),
            4.5 * z * level - 0.225 * z * y**3,
        ])  # fmt: skip
        length = np.linalg.norm(gradient, axis=1, keepdims=True)
        return points, gradient / np.maximum(length, 1e-300)

    return _round(at, count, mesh, seed, "heart")


def terrain(
    count: int = 1500, *, height: float = 0.12, waves: int = 12, mesh: bool = False, seed: int = 1
) -> Shape:
    """Return an open sheet over [−1, 1]² with upward normals: z = Σ aᵢ sin(kᵢ · (x, y) + φᵢ), i < `waves`.

    The lengths of the wave vectors kᵢ go from 2 to 9, and the amplitudes are proportional to 1/abs(kᵢ).  Directions and
    phases are random, by the seed.  The sum is scaled so that its root mean square is `height`.
    """
    if waves < 1:
        raise ValueError(f"waves must be at least 1, not {waves}")
    random = np.random.default_rng(seed)
    angle, phase = random.uniform(0, 2 * np.pi, (2, waves))
    number = np.geomspace(2.0, 9.0, waves)
    wave = number[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    amplitude = height * np.sqrt(2.0) / number / np.sqrt((1 / number**2).sum())

    def at(u: Floats, v: Floats) -> Tuple[Floats, Floats]:
        place = np.column_stack([2 * u - 1, 2 * v - 1])
        inner = place @ wave.T + phase
        slope = (np.cos(inner) * amplitude) @ wave
        normals = np.column_stack([-slope, np.ones(len(place))])
        points = np.column_stack([place, np.sin(inner) @ amplitude])
        return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)

    return _sheet(at, count, mesh, seed, "terrain", (96, 96), (False, False))


def bunny(path: Union[None, str, "os.PathLike[str]"] = None) -> Shape:
    """Read the Stanford bunny, a mesh: that of the npm package bunny 1.0.1, or any copy of it.

    Parameters
    ----------
    path : path, optional
        The file.  By default it is looked for where ``scripts/fetch_bunny`` puts it: in ``.cache`` of the current folder,
        of a folder above it, or of the checkout of this package.

    Raises
    ------
    FileNotFoundError
        If the file is not found; the message says how to get it.
    """
    if path is not None:
        return read(path)
    here = Path.cwd()
    for folder in (here, *here.parents, *Path(__file__).resolve().parents):
        if (folder / _BUNNY).is_file():
            return read(folder / _BUNNY)
    raise FileNotFoundError(
        f"the bunny is not at {_BUNNY}: run scripts/fetch_bunny of a checkout, or give the path of a copy"
    )


def _sheet(
    surface: Surface, count: int, mesh: bool, seed: int, name: str, cells: Tuple[int, int], closed: Tuple[bool, bool]
) -> Shape:
    """A surface over the unit square, which may be closed in either direction."""
    if mesh:
        return _grid(surface, name, cells, closed)
    _check_count(count)
    random = np.random.default_rng(seed)
    u, v = _even(surface, _CANDIDATES * count + 200, random)
    return _chosen(*surface(u, v), count, name)


def _check_count(count: int) -> None:
    if count < 1:
        raise ValueError(f"count must be at least 1, not {count}")


def _chosen(points: Floats, normals: Floats, count: int, name: str) -> Shape:
    chosen, _ = farthest_points(points, count)
    numbers = np.asarray(chosen)
    return Shape(points[numbers], normals[numbers], format=name)


def _even(surface: Surface, count: int, random: Any) -> Tuple[Floats, Floats]:
    """Parameters of random places that are even over the area.  The area is measured by differences."""
    u, v = random.uniform(size=(2, 3 * count))
    step = 1e-5
    du = surface(u + step, v)[0] - surface(u - step, v)[0]
    dv = surface(u, v + step)[0] - surface(u, v - step)[0]
    area = np.linalg.norm(np.cross(du, dv), axis=1)
    kept = random.uniform(size=len(u)) * area.max() < area
    return u[kept][:count], v[kept][:count]


def _grid(surface: Surface, name: str, cells: Tuple[int, int], closed: Tuple[bool, bool]) -> Shape:
    sides = [np.arange(n + (0 if around else 1)) / n for n, around in zip(cells, closed)]
    u, v = (part.reshape(-1) for part in np.meshgrid(*sides, indexing="ij"))
    width, height = len(sides[1]), len(sides[0])
    i, j = (part.reshape(-1) for part in np.meshgrid(np.arange(cells[0]), np.arange(cells[1]), indexing="ij"))
    below, beside = (i + 1) % height, (j + 1) % width
    a, b, c, d = i * width + j, below * width + j, below * width + beside, i * width + beside
    points, normals = surface(u, v)
    triangles: Integers = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])]).astype(np.int64)
    corners = points[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    if (across * normals[triangles[:, 0]]).sum() < 0:
        triangles = np.ascontiguousarray(triangles[:, ::-1])
    return Shape(points, None, triangles, format=name)


def _round(
    surface: Callable[[Floats], Tuple[Floats, Floats]], count: int, mesh: bool, seed: int, name: str
) -> Shape:
    """A surface that every ray from the origin crosses once.  `surface` maps directions to points and normals."""
    if mesh:
        directions, triangles = _globe(5)
        return Shape(surface(directions)[0], None, triangles, format=name)
    _check_count(count)
    directions = np.random.default_rng(seed).normal(size=(_CANDIDATES * count + 200, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return _chosen(*surface(directions), count, name)


def _globe(steps: int) -> Tuple[Floats, Integers]:
    """An octahedron whose faces are divided into four `steps` times, with its vertices on the unit sphere."""
    points: Floats = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
    faces: Any = np.array(
        [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], dtype=np.int64
    )
    for _ in range(steps):
        edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
        unique, which = np.unique(edges, axis=0, return_inverse=True)
        middle = len(points) + which.reshape(-1, 3)
        points = np.concatenate([points, points[unique].sum(axis=1)])
        points /= np.linalg.norm(points, axis=1, keepdims=True)
        (a, b, c), (ab, bc, ca) = faces.T, middle.T
        faces = np.concatenate([np.column_stack(one) for one in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return points, faces


def _joined(parts: "list[Shape]") -> Shape:
    starts = np.cumsum([0] + [len(part.points) for part in parts])
    triangles: Optional[Integers] = None
    if parts[0].triangles is not None:
        triangles = np.concatenate([part.triangles + start for part, start in zip(parts, starts)])
    normals = None if parts[0].normals is None else np.concatenate([part.normals for part in parts])
    return Shape(np.concatenate([part.points for part in parts]), normals, triangles, format=parts[0].format)
