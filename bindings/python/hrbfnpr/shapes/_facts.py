# SPDX-License-Identifier: MIT
"""Facts about a mesh: its parts, its borders, and its faults."""
from __future__ import annotations

from typing import Any

from .._records import MeshFacts as MeshFacts
from .._records import read
from ._shape import Shape, ShapeError


def mesh_facts(shape: Shape) -> MeshFacts:
    """Return facts about the mesh of a shape: its parts, its borders, and its faults."""
    if not shape.is_mesh:
        raise ShapeError("the shape has no faces")
    from .._inspect import inspect

    return facts_of(inspect(shape, 0)[0])


def facts_of(info: Any) -> MeshFacts:
    """The facts in a hrbfnpr_source_info."""
    return read(MeshFacts, info)
