# SPDX-License-Identifier: MIT
"""OBJ files of coarse meshes."""
import corner_normals
import numpy as np


def obj(vertices, faces):
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in np.asarray(vertices).tolist())
    return text + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def ball():
    """A sphere of 80 triangles: an icosahedron with each face divided in four."""
    golden = (1 + 5**0.5) / 2
    corners = np.array([np.roll((0, one, golden * other), turn) for turn in range(3) for one in (-1, 1)
                        for other in (-1, 1)]) / np.hypot(1, golden)  # fmt: skip
    side = 2 / np.hypot(1, golden)
    joined = np.linalg.norm(corners[:, None] - corners, axis=2) < 1.01 * side
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
             if joined[a, b] & joined[b, c] & joined[a, c]]  # fmt: skip
    vertices, quarters = list(corners), []
    for face in faces:
        a, b, c = face if np.linalg.det(corners[list(face)]) > 0 else face[::-1]
        first = len(vertices)
        middles = [corners[p] + corners[q] for p, q in ((a, b), (b, c), (c, a))]
        vertices += [middle / np.linalg.norm(middle) for middle in middles]
        d, e, f = first, first + 1, first + 2
        quarters += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    return np.array(vertices), np.array(quarters)


def coarse_ball():
    return obj(*ball())


def flat_ball():
    """An OBJ file of `ball` whose normals are those of the flat faces."""
    points, faces = ball()
    corner = points[faces]
    normals = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    return corner_normals.obj(points, faces, normals, np.repeat(np.arange(len(faces))[:, None], 3, axis=1))
