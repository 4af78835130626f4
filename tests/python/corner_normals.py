# SPDX-License-Identifier: MIT
"""Meshes whose files have a normal for each corner of a face."""
import numpy as np

SIDES = 8


def prism(sides=SIDES):
    """A prism with a cylinder's normals on its sides and flat caps.

    Returns points, faces, normals, and the index of a normal for each corner of a face.
    """
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    points = np.vstack([np.c_[ring, np.zeros(sides)], np.c_[ring, np.full(sides, 2.0)]])
    normals = np.vstack([np.c_[ring, np.zeros(sides)], [[0, 0, -1], [0, 0, 1]]])
    faces, own = [], []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(i, j, j + sides), (i, j + sides, i + sides)]
        own += [(i, j, j), (i, j, i)]
    for i in range(1, sides - 1):
        faces += [(0, i + 1, i), (sides, sides + i, sides + i + 1)]
        own += [(sides,) * 3, (sides + 1,) * 3]
    return points, np.array(faces), normals, np.array(own)


def obj(points, faces, normals, own, corner="{}//{}", back=False):
    lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"vn {x} {y} {z}" for x, y, z in normals]
    place, turn = (-len(points), -len(normals)) if back else (1, 1)
    lines += ["f " + " ".join(corner.format(a + place, b + turn) for a, b in zip(*pair)) for pair in zip(faces, own)]
    return "\n".join(lines) + "\n"
