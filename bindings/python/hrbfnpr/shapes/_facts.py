# SPDX-License-Identifier: MIT
"""What a mesh is like: parts, borders, and what is wrong with it."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Tuple

import numpy as np

from ._shape import Floats, Integers, Shape, ShapeError


@dataclass(frozen=True)
class MeshFacts:
    """Counted after vertices at the same place are joined.

    Attributes
    ----------
    components : int
        Parts that no edge joins.
    closed : bool
        Whether each edge has two triangles, which run along it in opposite directions.
    boundary_edges, holes : int
        Edges of one triangle; the lines that they make.
    non_manifold_edges : int
        Edges of more than two triangles.
    inconsistent_edges : int
        Edges whose two triangles run the same way: one of them is turned over.
    inside_out, parts_inside_out : bool, int
        Whether it is closed and its faces look inward; closed parts of which that is so.  One in another is a cavity.
    degenerate_triangles, duplicate_triangles, unused_vertices, joined_vertices, faces_not_finite : int
        Triangles without area; with the corners of another; vertices of no triangle; at the place of another;
        triangles with a corner that is not finite.
    area, volume : float
        The volume is that of a closed mesh, else 0.
    """

    components: int
    closed: bool
    boundary_edges: int
    holes: int
    non_manifold_edges: int
    inconsistent_edges: int
    inside_out: bool
    parts_inside_out: int
    degenerate_triangles: int
    duplicate_triangles: int
    unused_vertices: int
    joined_vertices: int
    faces_not_finite: int
    area: float
    volume: float


def mesh_facts(shape: Shape) -> MeshFacts:
    """Look at the faces of a shape."""
    if not shape.is_mesh:
        raise ShapeError("the shape has no faces")
    assert shape.triangles is not None
    finite = np.isfinite(shape.points[shape.triangles]).all(axis=(1, 2))
    used = np.unique(shape.triangles[finite])
    vertices, joined = np.unique(shape.points[used], axis=0, return_inverse=True)
    place = np.zeros(len(shape.points), dtype=np.int64)
    place[used] = joined.reshape(-1)
    triangles = place[shape.triangles[finite]]
    doubled = _doubled_areas(vertices, triangles)
    good = triangles[doubled > 0]
    count, repeated = len(vertices), len(good) - len(np.unique(np.sort(good, axis=1), axis=0))
    boundary, non_manifold, inconsistent = _edges(good, count)
    label, components = _components(count, good)
    closed = len(good) > 0 and len(boundary) == 0 and non_manifold == 0 and inconsistent == 0
    volumes = _volumes(vertices, good, label, components)
    open_parts = np.zeros(components, dtype=bool)
    open_parts[label[boundary[:, 0]]] = True
    return MeshFacts(
        components, closed, len(boundary), _loops(boundary, count), non_manifold, inconsistent,
        bool(closed and volumes.sum() < 0), int((volumes[~open_parts] < 0).sum()), int((doubled <= 0).sum()), repeated,
        len(shape.points) - len(np.unique(shape.triangles)), len(used) - len(vertices), int((~finite).sum()),
        float(doubled.sum() / 2), float(volumes.sum()) if closed else 0.0,
    )  # fmt: skip


def _doubled_areas(vertices: Floats, triangles: Integers) -> Any:
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1)


def _edges(triangles: Integers, count: int) -> Tuple[Integers, int, int]:
    """Edges of one triangle, and how many have more than two, or two that run the same way."""
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    forward = ends[:, 0] < ends[:, 1]
    low, high = ends.min(axis=1), ends.max(axis=1)
    keys, where, times = np.unique(low * count + high, return_inverse=True, return_counts=True)
    ways = np.bincount(where.reshape(-1), weights=np.where(forward, 1.0, -1.0), minlength=len(keys))
    single = keys[times == 1]
    boundary = np.column_stack([single // count, single % count])
    return boundary, int((times > 2).sum()), int(((times == 2) & (ways != 0)).sum())


def _components(count: int, triangles: Integers) -> Tuple[Any, int]:
    """A number for each vertex, the same within a part, and how many parts have triangles."""
    label = _labels(count, np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]]]))
    names, label = np.unique(label, return_inverse=True)
    label = label.reshape(-1)
    used = np.unique(label[triangles[:, 0]])
    number = np.zeros(len(names), dtype=np.int64)
    number[used] = np.arange(len(used))
    return number[label], len(used)


def _labels(count: int, edges: Integers) -> Integers:
    """The smallest vertex that each vertex is joined to."""
    label = np.arange(count)
    both = np.concatenate([edges, edges[:, ::-1]])
    if len(both) == 0:
        return label
    both = both[np.argsort(both[:, 0], kind="stable")]
    ends, starts = np.unique(both[:, 0], return_index=True)
    while True:
        nearest = np.minimum.reduceat(label[both[:, 1]], starts)
        new = label.copy()
        new[ends] = np.minimum(new[ends], nearest)
        # What a vertex was joined to is joined to that, too.
        np.minimum.at(new, label[ends], nearest)
        new = new[new]
        if np.array_equal(new, label):
            return label
        label = new


def _loops(boundary: Integers, count: int) -> int:
    if len(boundary) == 0:
        return 0
    names, index = np.unique(boundary, return_inverse=True)
    return len(np.unique(_labels(len(names), index.reshape(-1, 2))))


def _volumes(vertices: Floats, triangles: Integers, label: Any, components: int) -> Any:
    """Of each part."""
    if len(triangles) == 0:
        return np.zeros(components)
    a, b, c = (vertices[triangles[:, i]] - vertices.mean(axis=0) for i in range(3))
    six = np.einsum("ij,ij->i", a, np.cross(b, c))
    return np.bincount(label[triangles[:, 0]], weights=six, minlength=components) / 6
