# SPDX-License-Identifier: MIT
"""Writes marks as a PLY file for other programs."""
from __future__ import annotations

from typing import BinaryIO

import numpy as np

from .._point_set import PointSet
from .._streams import write_atomically


def write_ply(path: str, marks: PointSet) -> None:
    """Write all marks to a binary PLY file: absolute position, normal, direction, rank and number of the layer."""
    fields = [(name, "<f8") for name in "xyz"]
    fields += [(name, "<f4") for name in ("nx", "ny", "nz", "dx", "dy", "dz", "rank")]
    parts = []
    for layer in marks.layers:
        table = np.zeros(len(layer), dtype=[*fields, ("layer", "u1")])
        for i, axis in enumerate("xyz"):
            table[axis] = layer.positions[:, i].astype(float) + marks.origin[i]
            table["n" + axis] = layer.normals[:, i]
            table["d" + axis] = layer.directions[:, i]
        table["rank"] = layer.ranks
        table["layer"] = layer.number
        parts.append(table)
    table = np.concatenate(parts)
    types = {"<f8": "double", "<f4": "float", "u1": "uchar"}
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(table)}"]
    lines += [f"property {types[kind]} {name}" for name, kind in [*fields, ("layer", "u1")]]

    def write(file: BinaryIO) -> None:
        file.write("\n".join([*lines, "end_header", ""]).encode())
        file.write(table.tobytes())

    write_atomically(path, write)
