# SPDX-License-Identifier: MIT
"""Meshes whose files give the corners of their faces normals."""
import numpy as np

SIDES = 8


def prism():
    """Of eight sides, whose normals are those of a cylinder, and of two caps: points, faces, normals, and for each corner
    of a face the number of its normal."""
    turn = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    points = np.vstack([np.c_[ring, np.zeros(SIDES)], np.c_[ring, np.full(SIDES, 2.0)]])
    normals = np.vstack([np.c_[ring, np.zeros(SIDES)], [[0, 0, -1], [0, 0, 1]]])
    faces, own = [], []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        faces += [(i, j, j + SIDES), (i, j + SIDES, i + SIDES)]
        own += [(i, j, j), (i, j, i)]
    for i in range(1, SIDES - 1):
        faces += [(0, i + 1, i), (SIDES, SIDES + i, SIDES + i + 1)]
        own += [(SIDES,) * 3, (SIDES + 1,) * 3]
    return points, np.array(faces), normals, np.array(own)


def obj(points, faces, normals, own, corner="{}//{}", back=False):
    lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"vn {x} {y} {z}" for x, y, z in normals]
    place, turn = (-len(points), -len(normals)) if back else (1, 1)
    lines += ["f " + " ".join(corner.format(a + place, b + turn) for a, b in zip(*pair)) for pair in zip(faces, own)]
    return "\n".join(lines) + "\n"
