# SPDX-License-Identifier: MIT
"""Shapes and models that the tests share."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hrbfnpr

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "bindings" / "python"


def fibonacci_sphere(count):
    """`count` evenly spread unit vectors."""
    i = np.arange(count) + 0.5
    z = 1 - 2 * i / count
    angle = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z * z)
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z])


def torus(around=24, across=8, tube=0.4):
    """Points and normals of a torus about the z axis, radius 1."""
    a, b = np.meshgrid(*(np.linspace(0, 2 * np.pi, n, endpoint=False) for n in (around, across)), indexing="ij")
    normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=-1).reshape(-1, 3)
    centres = np.stack([np.cos(a), np.sin(a), 0 * a], axis=-1).reshape(-1, 3)
    return centres + tube * normals, normals


@pytest.fixture(autouse=True)
def notes_of_one_line(monkeypatch):
    """Whatever a test draws, its notes and warnings have at most 100 characters."""
    from hrbfnpr import _report
    from hrbfnpr.cli import _progress

    told = []

    def watched(tell):
        def watching(self, text):
            told.append(str(text))
            return tell(self, text)

        return watching

    for kind, name in ((_report.Reporter, "note"), (_report.Reporter, "warn"), (_progress.Reporter, "note")):
        monkeypatch.setattr(kind, name, watched(getattr(kind, name)))
    yield
    assert [text for text in told if len(text) > 100 or "\n" in text] == []


@pytest.fixture(scope="session")
def sphere():
    points = fibonacci_sphere(60)
    return hrbfnpr.Model.fit(points, points)


@pytest.fixture(scope="session")
def ring():
    return hrbfnpr.Model.fit(*torus())


@pytest.fixture(scope="session")
def marks(ring):
    lines = hrbfnpr.Layer("hatch", budget=3000, with_curvature=True)
    combing = hrbfnpr.Layer("hatch", name="combing", budget=3000, guide="combing")
    return hrbfnpr.PointSet.generate(ring, [hrbfnpr.Layer("stipples", budget=3000), lines, combing])


@pytest.fixture(scope="session")
def camera(ring):
    return hrbfnpr.Camera.fit(ring, direction=(-0.3, 1, -1), up=(0, 0, 1), size=(160, 120))
