# SPDX-License-Identifier: MIT
"""Finds the models of the figures: in a folder of data, as the bunny of the npm registry, or from formulas."""

from pathlib import Path

import numpy as np


class Missing(Exception):
    """A model or a program is missing; the text says which."""


# The file of each model in a folder of data, and its credit.
FILES = {
    "sphere": ("sphere_6.ply", "made from a formula"),
    "tori": ("tori_256.ply", "made from a formula"),
    "knot": ("knot_1024.ply", "made from a formula"),
    "bunny": ("bunny_256.ply", "Stanford bunny: Stanford Computer Graphics Laboratory, shown for scholarly use"),
    "heart": (
        "heart_1024.ply",
        "Human heart (male), modified: Kristen Browne, HuBMAP Human Reference Atlas, "
        "doi:10.48539/HBM373.VSTV.568, CC BY 4.0",
    ),
    "head": ("head_4096.ply", "Bust of Demosthenes: photo scan by ryanfb, from github.com/odedstein/meshes, CC BY 4.0, sampled"),
    "lamp": ("lamp_mesh.ply", "Lantern of KayKit Halloween Bits: Kay Lousberg, CC0 1.0"),
    "canyon": ("canyon_512.ply", "Yosemite Valley: USGS National Elevation Dataset, public domain"),
}
# The scan of the bunny, and the mesh of the lamp without further options.
FILES["bunny_mesh"] = ("bunny_zipper.ply", FILES["bunny"][1])
FILES["lantern"] = FILES["lamp"]
MORE = {"lamp": ["--samples", "1500", "--crease", "30"], "bunny_mesh": ["--samples", "1100"]}
SOLIDS = Path(__file__).resolve().parents[2] / "examples"
SAMPLES = {"sphere": 6, "tori": 256, "knot": 1024, "bunny": 256, "heart": 512, "lamp": 1500}


def _tube(centre, tangent, radius, around=400, across=48):
    """Returns points and normals of a tube around a closed curve."""
    t = np.linspace(0, 2 * np.pi, around, endpoint=False)
    along = tangent(t)
    along /= np.linalg.norm(along, axis=1)[:, None]
    side = np.cross(along, np.eye(3)[np.abs(along).argmin(axis=1)])
    side /= np.linalg.norm(side, axis=1)[:, None]
    other = np.cross(along, side)
    angle = np.linspace(0, 2 * np.pi, across, endpoint=False)[:, None, None]
    normals = np.cos(angle) * side + np.sin(angle) * other
    return (centre(t) + radius * normals).reshape(-1, 3), normals.reshape(-1, 3)


def _columns(*parts):
    return np.stack(np.broadcast_arrays(*parts), axis=-1).astype(float)


def knot():
    """A tube of radius 0.35 around a trefoil knot."""
    return _tube(
        lambda t: _columns(np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)),
        lambda t: _columns(np.cos(t) + 4 * np.cos(2 * t), -np.sin(t) + 4 * np.sin(2 * t), -3 * np.cos(3 * t)),
        0.35,
    )


def tori():
    """Two linked tori: around the z axis through (-0.5, 0, 0), and around the y axis through (0.5, 0, 0)."""
    c, s = np.cos, np.sin
    first = _tube(lambda t: _columns(c(t) - 0.5, s(t), 0), lambda t: _columns(-s(t), c(t), 0), 0.32)
    second = _tube(lambda t: _columns(c(t) + 0.5, 0, s(t)), lambda t: _columns(-s(t), 0, c(t)), 0.32)
    return tuple(np.concatenate(parts) for parts in zip(first, second))


def _directions(count):
    i = np.arange(count) + 0.5
    z, turn = 1 - 2 * i / count, np.pi * (1 + 5**0.5) * i
    return _columns(np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z)


def heart():
    """Taubin's heart, x^2 + 9/4 y^2 + z^2 - 1 = z (x^2 + 9/80 y^2)^(1/3), except near the z axis, where the gradient is unbounded."""
    rays = _directions(8000)
    rays = rays[np.hypot(rays[:, 0], rays[:, 1]) > 0.05]
    square = (rays**2 * (1, 2.25, 1)).sum(axis=1)
    root = np.cbrt(rays[:, 0] ** 2 + 9 / 80 * rays[:, 1] ** 2)
    low, high = np.zeros(len(rays)), np.full(len(rays), 4.0)
    for _ in range(60):
        middle = (low + high) / 2
        inside = square * middle**2 - rays[:, 2] * root * middle ** (5 / 3) < 1
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    p = rays * low[:, None]
    x, y, z = p.T
    inner = x**2 + 9 / 80 * y**2
    slope = z / 3 * inner ** (-2 / 3)
    normals = _columns(2 * x - slope * 2 * x, 4.5 * y - slope * 9 / 40 * y, 2 * z - np.cbrt(inner))
    return p, normals / np.linalg.norm(normals, axis=1)[:, None]


def sphere():
    """The six points of the unit sphere on the axes."""
    points = np.concatenate([np.eye(3), -np.eye(3)])
    return points, points


MADE = {"sphere": sphere, "tori": tori, "knot": knot, "heart": heart}


class Models:
    """The files of the models."""

    def __init__(self, data, bunny, scratch):
        self._data, self._bunny, self._scratch = data, bunny, scratch
        if data is not None and not any(self._given(name) for name in FILES):
            names = ", ".join(file for file, _ in FILES.values())
            raise ValueError(f"{data} has none of the models ({names}), nor have its folders points/ and meshes/")

    def _given(self, name):
        folders = (".", "points", "meshes") if self._data is not None else ()
        paths = [self._data / folder / FILES[name][0] for folder in folders if name in FILES]
        return next((path for path in paths if path.is_file()), None)

    def source(self, name):
        """Returns the file of a model, the options with which it is drawn, and its credit."""
        given = self._bunny if name == "bunny_mesh" and self._bunny is not None else self._given(name)
        if given is not None:
            return given, MORE.get(name, []), FILES[name][1]
        if name == "bunny" and self._bunny is not None:
            return self._bunny, ["--samples", "256"], FILES[name][1]
        if (SOLIDS / f"{name}.csg").is_file():
            return SOLIDS / f"{name}.csg", [], "made from a script"
        if name == "cloud":
            return self._points_alone(name, "knot"), ["--samples", "2000"], "made from a formula"
        if name in MADE:
            return self._write(name), ["--samples", str(SAMPLES[name])], "made from a formula"
        raise Missing(f"{FILES[name][0]} is missing; give a folder that has it by --data DIR")

    def _points_alone(self, name, source):
        path = Path(self._scratch) / f"{name}.xyz"
        if not path.exists():
            np.savetxt(path, MADE[source]()[0], fmt="%.9g")
        return path

    def _write(self, name):
        path = Path(self._scratch) / f"{name}.xyz"
        if not path.exists():
            np.savetxt(path, np.hstack(MADE[name]()), fmt="%.9g")
        return path
