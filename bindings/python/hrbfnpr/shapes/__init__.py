# SPDX-License-Identifier: MIT
"""Reads point sets and meshes, and samples a mesh to a few well-spread points with normals.

Needs NumPy; formats other than PLY, XYZ, PWN, OBJ and OFF are read by meshio.

>>> shape = hrbfnpr.shapes.read("bunny.ply")
>>> points, normals = hrbfnpr.shapes.samples(shape, 1000)
"""
from ._read import read
from ._sample import farthest_points, samples
from ._shape import Shape, ShapeError

__all__ = ["Shape", "ShapeError", "farthest_points", "read", "samples"]
