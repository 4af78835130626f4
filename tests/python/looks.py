# SPDX-License-Identifier: MIT
"""What the library finds out about points and meshes, for tests."""
from types import SimpleNamespace

from hrbfnpr._inspect import inspect
from hrbfnpr.cli._check import _LOOKS, _axis
from hrbfnpr.shapes import Shape


def info_of(shape):
    """A hrbfnpr_source_info."""
    return inspect(shape, 0)[0]


def look(points, normals):
    """Which way normals look."""
    info = info_of(Shape(points, normals))
    name = _LOOKS[info.normals_look]
    return SimpleNamespace(inward=name == "inward", mixed=name == "mixed", closed=info.normals_closed,
                           flipped=info.normals_flipped_share)  # fmt: skip


def hangs(points, normals):
    """The axis that a terrain looks down along."""
    return (None, "y", "z")[info_of(Shape(points, normals)).looks_down]


def up_of(shape):
    """x, -x, ..."""
    return _axis(list(info_of(shape).up))
