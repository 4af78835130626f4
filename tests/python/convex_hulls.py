# SPDX-License-Identifier: MIT
"""Convex hulls of a few points: long faces of very different sizes."""
import itertools

import numpy as np


def convex_hull(points):
    """The faces of the hull: triangles of points with all other points on one side."""
    three = np.array(list(itertools.combinations(range(len(points)), 3)))
    a, b, c = (points[three[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    above = np.einsum("fk,pk->fp", normal, points) - np.einsum("fk,fk->f", normal, a)[:, None]
    tiny = 1e-9 * np.abs(above).max()
    outward, inward = (above <= tiny).all(axis=1), (above >= -tiny).all(axis=1)
    return np.concatenate([three[outward], three[inward][:, ::-1]])


def rounded_box():
    """The hull of 60 random points on a rounded box."""
    points = np.random.default_rng(3).normal(size=(60, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points = np.sign(points) * np.abs(points) ** 0.3 * [1, 0.2, 0.2]
    return points, convex_hull(points)


def hull_in_a_box():
    """The hull of random points in a box: large faces. A smooth surface passes close to its vertices."""
    points = np.random.default_rng(6).uniform(-1, 1, size=(40, 3)) * [2, 1, 0.6]
    faces = convex_hull(points)
    used, faces = np.unique(faces, return_inverse=True)
    return points[used], faces.reshape(-1, 3)
