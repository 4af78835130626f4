# SPDX-License-Identifier: MIT
"""Reads formats of 3D programs (such as Collada, FBX, 3DS, Blender) with the program of the Open Asset Import Library."""
from __future__ import annotations

import shutil
import tempfile
import zipfile
from dataclasses import replace
from pathlib import Path

from ._3mf import UNPACKING
from ._gltf import read_gltf
from ._optional import run
from ._shape import Shape, ShapeError, Vector

UP: Vector = (0.0, 0.0, 1.0)  # for the formats in _Z_UP
ENDINGS = {
    ".dae": "Collada", ".fbx": "FBX", ".3ds": "3DS", ".blend": "Blender", ".x3d": "X3D", ".ac": "AC3D", ".lwo": "LWO",
    ".ms3d": "MS3D", ".md2": "MD2", ".md3": "MD3", ".md5mesh": "MD5", ".iqm": "IQM", ".ase": "ASE", ".cob": "COB",
    ".x": "X", ".b3d": "B3D", ".dxf": "DXF", ".ifc": "IFC", ".lxo": "LXO", ".nff": "NFF",
    ".ogex": "OGEX", ".smd": "SMD", ".zae": "Collada",
}  # fmt: skip
_Z_UP = ("Blender", "COB", "DXF", "SMD")  # formats with z up, which assimp does not turn
_LARGEST = 1 << 31  # largest unpacked size, in bytes
_OTHERWISE = "Blender exports it as glTF or PLY"


def read(path: Path) -> Shape:
    """Read a file by converting it to glTF."""
    path.stat()  # so that a missing file is an OSError, as in all readers
    form = ENDINGS[path.suffix.lower()]
    program = shutil.which("assimp")
    if program is None:
        raise ShapeError(f"reading {form} files needs assimp (assimp-utils); without it, {_OTHERWISE}")
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.glb"
        if path.suffix.lower() == ".zae":
            path = _unpacked(path, Path(folder))
        done = run("assimp", [program, "export", str(path.resolve()), str(scene), "-fglb2"], _OTHERWISE)
        if done.returncode or not scene.exists():
            raise ShapeError(f"assimp cannot read it{_reason(done.stdout)}; {_OTHERWISE}")
        try:
            shape = read_gltf(scene.read_bytes(), Path(folder))
        except ShapeError as error:
            raise ShapeError(f"assimp reads it wrong: {error}; {_OTHERWISE}") from None
    return replace(shape, format=form, up=UP if form in _Z_UP else shape.up)


def _unpacked(path: Path, folder: Path) -> Path:
    """The Collada file in an archive, unpacked.  Pictures in the archive are not needed."""
    try:
        with zipfile.ZipFile(path) as archive:
            names = [info for info in archive.infolist() if info.filename.lower().endswith(".dae")]
            if names and names[0].file_size <= _LARGEST:
                unpacked = folder / "scene.dae"
                unpacked.write_bytes(archive.read(names[0]))
                return unpacked
    except (zipfile.BadZipFile, *UNPACKING) as error:
        raise ShapeError(f"the .zae file is not a whole ZIP archive: {error}") from None
    what = f"is larger than {_LARGEST >> 30} GiB" if names else "is not in it"
    raise ShapeError(f"the .zae file is an archive, and the scene (.dae) {what}")


def _reason(said: bytes) -> str:
    """The first error in the program's output, or an empty text."""
    for line in said.decode(errors="replace").splitlines():
        if line.startswith("ERROR:") and line[6:].strip():
            return ": " + line[6:].strip()[:200]
    return ""
