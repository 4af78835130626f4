"""Marks as a PLY file, for other programs."""
from __future__ import annotations

from typing import BinaryIO

import numpy as np

from .._names import GROUPS
from .._point_set import PointSet
from .._streams import write_atomically


def write_ply(path: str, marks: PointSet) -> None:
    """Absolute positions, normals, directions, rank and group's number of all marks; binary."""
    fields = [(name, "<f8") for name in "xyz"]
    fields += [(name, "<f4") for name in ("nx", "ny", "nz", "dx", "dy", "dz", "rank")]
    parts = []
    for group in marks.groups:
        table = np.zeros(len(marks.ranks(group)), dtype=[*fields, ("group", "u1")])
        for i, axis in enumerate("xyz"):
            table[axis] = marks.positions(group)[:, i].astype(float) + marks.origin[i]
            table["n" + axis] = marks.normals(group)[:, i]
            table["d" + axis] = marks.directions(group)[:, i]
        table["rank"] = marks.ranks(group)
        table["group"] = GROUPS[group]
        parts.append(table)
    table = np.concatenate(parts)
    types = {"<f8": "double", "<f4": "float", "u1": "uchar"}
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(table)}"]
    lines += [f"property {types[kind]} {name}" for name, kind in [*fields, ("group", "u1")]]

    def write(file: BinaryIO) -> None:
        file.write("\n".join([*lines, "end_header", ""]).encode())
        file.write(table.tobytes())

    write_atomically(path, write)
