# SPDX-License-Identifier: MIT
"""What a mesh is like: parts, borders, and what is wrong with it."""
from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from ._shape import Shape, ShapeError


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


# Fields of hrbfnpr_source_info with another name.
_NAMES = {
    "holes": "boundary_loops", "non_manifold_edges": "nonmanifold_edges", "inconsistent_edges": "contrary_edges",
    "parts_inside_out": "components_inside_out", "degenerate_triangles": "degenerate_faces",
    "duplicate_triangles": "repeated_faces", "joined_vertices": "duplicates",
}  # fmt: skip


def mesh_facts(shape: Shape) -> MeshFacts:
    """Look at the faces of a shape."""
    if not shape.is_mesh:
        raise ShapeError("the shape has no faces")
    from .._inspect import inspect

    return facts_of(inspect(shape, 0)[0])


def facts_of(info: Any) -> MeshFacts:
    """Of a hrbfnpr_source_info."""
    values = {field.name: getattr(info, _NAMES.get(field.name, field.name)) for field in fields(MeshFacts)}
    return MeshFacts(**{**values, "closed": bool(info.closed), "inside_out": bool(info.inside_out)})
