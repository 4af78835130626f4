# SPDX-License-Identifier: MIT
"""Points along curves on a torus of radii 3 and 1."""
import numpy as np


def on_torus(around, tube):
    """Points and normals at two angles: around the axis, and around the tube."""
    normals = np.column_stack([np.cos(tube) * np.cos(around), np.cos(tube) * np.sin(around), np.sin(tube)])
    flat = np.column_stack([3 * np.cos(around), 3 * np.sin(around), np.zeros_like(around)])
    return flat + normals, normals


def rings(count=9, each=40):
    """Points of the torus's cross sections through the axis."""
    around, tube = np.meshgrid(np.arange(count) / count, (np.arange(each) + 0.5) / each, indexing="ij")
    return on_torus(2 * np.pi * around.ravel(), 2 * np.pi * tube.ravel())[0]


def wires():
    """Points and normals along both equators and four circles around the tube."""
    turn = 2 * np.pi * np.arange(200) / 200
    small = 2 * np.pi * (np.arange(60) + 0.5) / 60
    curves = [(turn, 0 * turn), (turn, 0 * turn + np.pi)]
    curves += [(0 * small + 0.5 * np.pi * quarter + 0.1, small) for quarter in range(4)]
    return on_torus(*(np.concatenate(parts) for parts in zip(*curves)))
