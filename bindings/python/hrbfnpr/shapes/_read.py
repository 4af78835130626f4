# SPDX-License-Identifier: MIT
"""Reads a shape from a file of any known format."""
from __future__ import annotations

import contextlib
import io
import os
from pathlib import Path
from typing import Any, List, Union

import numpy as np

from ._ply import read_ply
from ._shape import Shape, ShapeError, fans_of_block
from ._text import read_obj, read_off, read_xyz

_TEXT_READERS = {".xyz": read_xyz, ".pwn": read_xyz, ".xyzn": read_xyz, ".obj": read_obj, ".off": read_off}


def read(path: Union[str, "os.PathLike[str]"]) -> Shape:
    """Read points or a mesh.

    Parameters
    ----------
    path : path
        PLY, XYZ, PWN, OBJ, OFF, or what meshio reads (STL, VTK, ...), told by the ending.

    Raises
    ------
    ShapeError
        If the file cannot be used.
    OSError
        If it cannot be opened.
    """
    path = Path(path)
    ending = path.suffix.lower()
    if ending == ".ply":
        return read_ply(path.read_bytes())
    if ending in _TEXT_READERS:
        # utf-8-sig: some programs put a byte-order mark before the first number.
        return _TEXT_READERS[ending](path.read_text(encoding="utf-8-sig", errors="replace"))
    return _read_meshio(path)


def _read_meshio(path: Path) -> Shape:
    path.stat()  # a missing file is an OSError like everywhere, whatever meshio makes of it
    try:
        import meshio
    except ImportError:
        raise ShapeError(f"reading {path.suffix or 'this kind of'} files needs meshio (python3-meshio)") from None
    try:
        # meshio reports some failures on stdout and ends the process.
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            mesh = meshio.read(path)
    except (Exception, SystemExit) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ShapeError(f"meshio cannot read it: {reason}") from error
    points = np.asarray(mesh.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ShapeError("its points are not in three dimensions")
    parts: List[Any] = [
        fans_of_block(block.data)
        for block in mesh.cells
        if block.type in ("triangle", "quad") or block.type.startswith("polygon")
    ]
    return Shape(points, None, np.concatenate(parts) if parts else None)
