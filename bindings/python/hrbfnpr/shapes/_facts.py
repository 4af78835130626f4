# SPDX-License-Identifier: MIT
"""What a mesh is like: parts, borders, and what is wrong with it."""
from __future__ import annotations

from typing import Any

from .._records import MeshFacts, read
from ._shape import Shape, ShapeError


def mesh_facts(shape: Shape) -> MeshFacts:
    """Look at the faces of a shape."""
    if not shape.is_mesh:
        raise ShapeError("the shape has no faces")
    from .._inspect import inspect

    return facts_of(inspect(shape, 0)[0])


def facts_of(info: Any) -> MeshFacts:
    """Of a hrbfnpr_source_info."""
    return read(MeshFacts, info)
