# SPDX-License-Identifier: MIT
"""Unpacks KHR_draco_mesh_compression with the program of the Draco library, because Debian has no Python package for it."""
from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from ._optional import run
from ._ply import read_ply
from ._shape import Shape, ShapeError

_PROGRAM = "draco_decoder"
_OTHERWISE = "save it without compression, in Blender for example, or convert it to PLY"


def unpack(data: bytes) -> Shape:
    """The points and triangles of compressed data, in Draco's own order."""
    program = shutil.which(_PROGRAM)
    if program is None:
        raise ShapeError(f"its geometry is compressed by Draco: reading that needs {_PROGRAM} (draco); without it, {_OTHERWISE}")
    with tempfile.TemporaryDirectory() as folder:
        packed, plain = Path(folder) / "packed.drc", Path(folder) / "plain.ply"
        packed.write_bytes(data)
        done = run(_PROGRAM, [program, "-i", str(packed), "-o", str(plain)], _OTHERWISE)
        if done.returncode or not plain.exists():
            raise ShapeError(f"a part that Draco compressed is damaged: {_PROGRAM} cannot read it")
        return read_ply(plain.read_bytes())
