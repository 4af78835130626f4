# SPDX-License-Identifier: MIT
"""Reads point sets and meshes from files, and chooses a few well-spread samples with normals.

Needs NumPy.  Some formats need another package or program (see docs/input.md).

>>> shape = hrbfnpr.shapes.read("bunny.ply")
>>> points, normals = hrbfnpr.shapes.samples(shape, 1000)
"""
from ._attributes import PointValues, values_of
from ._facts import MeshFacts, mesh_facts
from ._read import read
from ._sample import farthest_points, samples
from ._shape import Shape, ShapeError

__all__ = ["MeshFacts", "PointValues", "Shape", "ShapeError", "farthest_points", "mesh_facts", "read", "samples", "values_of"]
