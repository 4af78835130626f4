# SPDX-License-Identifier: MIT
"""Reads a shape from a file of any known format, by its contents, or by its ending if the contents do not tell."""
from __future__ import annotations

import gzip
import os
import re
import tempfile
import zlib
from dataclasses import replace
from pathlib import Path
from typing import Callable, Dict, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _3dxml, _assimp, _cad, _heights, _scans, _vtk
from ._3mf import is_3mf, read_3mf
from ._amf import MAGIC as AMF_MAGIC
from ._amf import read_amf
from ._cube import read_cube
from ._degrees import prj_says
from ._gifti import MAGIC as GIFTI_MAGIC
from ._gifti import read_gifti
from ._gltf import read_gltf
from ._molecule import PDB_MAGIC, XYZ_MAGIC, read_molecule, read_pdb
from ._npy import read_npy, read_npz
from ._obj import read_obj, read_off
from ._pcd import read_pcd
from ._ply import read_ply
from ._ptx import MAGIC as PTX_MAGIC
from ._ptx import read_ptx
from ._shape import Hints, Shape, ShapeError
from ._stl import read_stl
from ._table import plain
from ._usda import MAGIC as USDA_MAGIC
from ._usda import read_usda
from ._xyz import read_xyz

_HEAD = 65536  # number of bytes that are examined to find the format


class Format(NamedTuple):
    """A name, and the reader.  It takes bytes, or a path if a library needs one or the file may be large.

    `hinted`: whether the reader also takes hints.
    """

    name: str
    read: Optional[Callable[..., Shape]] = None
    read_path: Optional[Callable[..., Shape]] = None
    hinted: bool = False


def _gltf_of(path: Path) -> Shape:
    return read_gltf(path.read_bytes(), path.parent)


FORMATS: Dict[str, Format] = {
    one.name: one
    for one in (
        Format("PLY", read_ply), Format("OBJ", read_obj), Format("STL", read_stl), Format("OFF", read_off),
        Format("text", read_xyz, hinted=True), Format("PCD", read_pcd), Format("glTF", None, _gltf_of),
        Format("MNI object", None, _vtk.read_mni), Format("VTP", None, _vtk.read_vtp), Format("VTU", None, _vtk.read_vtu),
        Format("VTK", None, _vtk.read_vtk), Format("LAS", None, _scans.read_las, True), Format("E57", None, _scans.read_e57),
        Format("grid", _heights.read_grid, hinted=True), Format("PGM", _heights.read_pgm),
        Format("GeoTIFF", None, _heights.read_geotiff), Format("DEM", None, _heights.read_dem), Format("3MF", None, read_3mf), Format("AMF", read_amf), Format("PTX", read_ptx),
        Format("VRML", None, _vtk.read_vrml), Format("NPY", read_npy), Format("NPZ", read_npz),
        Format("GIFTI", read_gifti), Format("PDB", read_pdb), Format("molecule", read_molecule), Format("Gaussian cube", read_cube),
        Format("USDA", read_usda), Format("3DXML", None, _3dxml.read),
        *(Format(name, None, _assimp.read) for name in _assimp.ENDINGS.values()),
        *(Format(name, None, _cad.read) for name in dict.fromkeys(_cad.ENDINGS.values())),
    )
}  # fmt: skip
ENDINGS = {
    ".ply": "PLY", ".obj": "OBJ", ".stl": "STL", ".off": "OFF", ".noff": "OFF", ".coff": "OFF", ".pcd": "PCD",
    ".xyz": "text", ".xyzn": "text", ".pwn": "text", ".txt": "text", ".asc": "text", ".csv": "text", ".pts": "text",
    ".gltf": "glTF", ".glb": "glTF", ".vtp": "VTP", ".vtu": "VTU", ".vtk": "VTK", ".las": "LAS", ".laz": "LAS",
    ".e57": "E57", ".grd": "grid", ".pgm": "PGM", ".tif": "GeoTIFF", ".tiff": "GeoTIFF",
    ".3mf": "3MF", ".amf": "AMF", ".ptx": "PTX", ".npy": "NPY", ".npz": "NPZ", ".wrl": "VRML", ".vrml": "VRML", **dict.fromkeys((".dem", ".hgt", ".dt0", ".dt1", ".dt2", ".bil", ".flt"), "DEM"),
    ".gii": "GIFTI", ".pdb": "PDB", ".ent": "PDB", ".cube": "Gaussian cube", ".cub": "Gaussian cube", ".usda": "USDA", ".3dxml": "3DXML",
    **_assimp.ENDINGS, **_cad.ENDINGS,
}  # fmt: skip
_BY_MESHIO = (".msh", ".inp", ".mesh", ".bdf", ".nas", ".med", ".xdmf", ".tet", ".avs", ".e", ".exo", ".dat")
_MAGIC: Tuple[Tuple[bytes, str], ...] = (
    (rb"ply\s", "PLY"), (rb"\x93NUMPY", "NPY"), (rb"#VRML V[12]", "VRML"), (rb"glTF", "glTF"), (rb"LASF", "LAS"), (rb"ASTM-E57", "E57"),
    (rb"(?:#[^\n]*\n|\s)*(?:VERSION\s[.\d]+\s+)?FIELDS\s", "PCD"), (rb"# vtk DataFile", "VTK"),
    (rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!--.*?-->\s*)*<VTKFile[^>]*PolyData", "VTP"),
    (rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!--.*?-->\s*)*<VTKFile[^>]*UnstructuredGrid", "VTU"),
    (AMF_MAGIC, "AMF"), (GIFTI_MAGIC, "GIFTI"), (USDA_MAGIC, "USDA"), (PDB_MAGIC, "PDB"), (XYZ_MAGIC, "molecule"), (rb"P[25]\s", "PGM"), (rb"II[*+]\0|MM\0[*+]", "GeoTIFF"), (rb"\s*(?i:ncols|nrows)\s+\d+\s", "grid"),
    (rb"ISO-10303-21;(?:(?!FILE_SCHEMA).)*FILE_SCHEMA\s*\(\s*\(\s*'(?!IFC)", "STEP"), (rb"\s*(?:DBRep_DrawableShape\s+)?CASCADE Topology", "BREP"),
    (PTX_MAGIC, "PTX"), (rb"P(?: \d*\.?\d+){3} \d+ \d+\s", "MNI object"), (rb"\s*(?:ST)?C?N?4?n?OFF(?=\d|\b)", "OFF"), (rb"\s*\{[^\0]*\"asset\"\s*:", "glTF"),
    (rb"(?:\s*#[^\r\n]*[\r\n])*\s*(?i:solid)\b[^\0]*\n\s*(?i:facet|endsolid)\b", "STL"),
    (rb"(?:\s*(?:#[^\n]*|mtllib[^\n]*|[og]\s[^\n]*|s\s[^\n]*|usemtl[^\n]*)?\n)*v[ \t]+[-+.\d]\S*[ \t]+[-+.\d]", "OBJ"),
)  # fmt: skip
READ = (
    "PLY, OBJ, STL, OFF, 3MF, AMF, glTF and GLB; points as XYZ, TXT, ASC, CSV, PTS, PWN, PTX, PCD, LAS, LAZ, E57, NPY or NPZ; "
    "VTK, VTU, VTP and VRML; STEP, IGES and BREP by Open CASCADE; Collada, FBX, 3DS, Blender, X3D and others by assimp; "
    "USDA, 3DXML; GIFTI; molecules as PDB, XYZ or Gaussian cube; height maps as ESRI grid, PGM, GeoTIFF or DEM"
)
_CONVERT = {
    **dict.fromkeys((".sldprt", ".sldasm", ".ipt", ".iam", ".prt", ".catpart", ".x_t", ".sat", ".fcstd", ".f3d"),
                    "its program exports STEP or STL"),
    **dict.fromkeys((".max", ".usd", ".usdc", ".usdz"),
                    "Blender exports it as glTF or PLY"),
    **dict.fromkeys((".fls", ".rcp", ".rcs", ".zfs", ".bin", ".pod"),
                    "CloudCompare saves it as PLY, with normals"),
    **dict.fromkeys((".zip", ".7z", ".rar", ".tar"), "unpack it first"),
    **dict.fromkeys((".ctm",), "MeshLab exports it as STL"),
    **dict.fromkeys((".nii", ".dcm", ".nrrd", ".mha", ".vti"), "it holds a volume: 3D Slicer exports a surface as PLY"),
    **dict.fromkeys((".png", ".jpg", ".jpeg", ".bmp"), "it is a picture; heights of terrain go into a PGM of 16 bits"),
    **dict.fromkeys((".mat", ".pkl", ".h5", ".hdf5"), "save its arrays of points, normals and triangles as .npz, with NumPy"),
}  # fmt: skip
_SAME_ENDING = ({"grid", "text"}, {"molecule", "text"})  # formats whose files may have the same ending

_NO_MODEL = (
    (rb"\s*<(?i:!doctype html|html)\b", "this is a web page, not a model: the download went wrong"),
    (rb"version https://git-lfs", "this is a pointer of Git LFS, not the file itself: git lfs pull fetches it"),
    (rb"\x28\xb5\x2f\xfd", "it is packed by zstd, as Blender does: unpack it with unzstd, or export it as glTF or PLY"),
)


def format_of(head: bytes, size: int) -> Optional[str]:
    """The format that the first bytes of a file show; None if they do not.  `size` is the size of the whole file."""
    for pattern, name in _MAGIC:
        if re.match(pattern, head, re.S):
            return name
    if size >= 84 and size == 84 + 50 * int.from_bytes(head[80:84], "little"):
        return "STL"
    return "text" if _is_table(head) else None


def _is_table(head: bytes) -> bool:
    """Whether the first lines hold numbers, except for headings and comments."""
    try:
        head = plain(head)
    except ShapeError:
        return False
    lines = [line for line in head.splitlines()[:40] if line.strip() and not line.lstrip().startswith((b"#", b"//", b"%"))]
    table = re.compile(rb"\s*NUMBER(?:[,;\s]+NUMBER)*[,;\s]*\Z".replace(b"NUMBER", rb"(?:[-+]?(?:nan|inf)|[-+.\d][-+.\deE]*)"), re.I)
    good = sum(1 for line in lines if table.match(line))
    return good >= 1 and good >= len(lines) - 2


def read(path: Union[str, "os.PathLike[str]"], classes: Optional[Sequence[int]] = None) -> Shape:
    """Read points or a mesh from a file.

    Parameters
    ----------
    path : path
        The file: PLY, OBJ, STL, OFF, 3MF, AMF, glTF, GLB, GIFTI, USDA and 3DXML; tables of points with three or more columns
        (such as XYZ, TXT, CSV, PTS, PWN); PTX, PCD, LAS, NPY and NPZ; molecules (PDB, XYZ, Gaussian cube); and, with the package or program that reads them, LAZ, E57, GeoTIFF, DEM,
        VTK's formats, STEP, IGES, BREP, and formats of 3D programs such as Collada, FBX, 3DS and Blender.  The contents
        decide about the format before the ending does.  Files that are packed with gzip are unpacked.
    classes : sequence of int, optional
        For LAS and LAZ: the classes of the points to read, () for all.  The default reads all points but those of noise, and
        the ground alone if points are classified as ground and as vegetation.

    Returns
    -------
    Shape
        The points, with normals or triangles if the file has them.

    Raises
    ------
    ShapeError
        If the file cannot be used.  For a text file, the message gives the line and the column (the number of the word).
    OSError
        If the file cannot be opened.
    """
    with np.errstate(invalid="ignore", over="ignore"):  # later stages leave out numbers that are not finite
        return _read(Path(path), None if classes is None else tuple(classes))


def _read(path: Path, classes: Optional[Tuple[int, ...]]) -> Shape:
    with open(path, "rb") as file:
        head = file.read(_HEAD)
        size = file.seek(0, os.SEEK_END)
    ending = path.suffix.lower()
    packed = head[:2] == b"\x1f\x8b"
    if packed:
        data = _unpacked(path)
        head, size = data[:_HEAD], len(data)
        if ending in (".gz", ".gzip"):
            ending = Path(path.stem).suffix.lower()
    expected = ENDINGS.get(ending)
    if not head.strip():
        raise ShapeError(_empty(expected, size))
    for pattern, what in _NO_MODEL:
        if re.match(pattern, head):
            raise ShapeError(what)
    name = format_of(head, size) or ("3MF" if head[:4] == b"PK\3\4" and not packed and is_3mf(path) else expected)
    if name is None:
        if ending not in _BY_MESHIO:
            raise ShapeError(_unknown(ending))
        return _read_unpacked(_vtk.read_meshio, data, ending) if packed else _vtk.read_meshio(path)
    if name == "text" and expected == "PTX" and len(head.split(b"\n", 1)[0].split()) < 3:
        name = expected  # a damaged PTX file: its reader reports the error in the header
    if name == "text" and expected == "Gaussian cube":
        name = expected  # its head looks like a table
    form = FORMATS[name]
    if classes is not None and name != "LAS":
        raise ShapeError("classes are of the points of LAS and LAZ files: leave them out")
    more = (Hints(ending in (".xyzn", ".pwn"), prj_says(path), classes),) if form.hinted else ()
    if form.read is not None:
        shape = form.read(data if packed else path.read_bytes(), *more)
    else:
        assert form.read_path is not None
        reader = form.read_path
        shape = _read_unpacked(lambda file: reader(file, *more), data, ending) if packed else reader(path, *more)
    if expected is not None and name != expected and {name, expected} not in _SAME_ENDING:
        what = "a table of points" if name == "text" else name
        note = f"the ending is {ending}, but the file holds {what} and is read as such"
        return replace(shape, notes=(note, *shape.notes))
    return shape


def _empty(expected: Optional[str], size: int) -> str:
    holds = "the file is empty" if size == 0 else "the file holds only blanks"
    if expected is None or expected == "text":
        return f"there are no points: {holds}"
    return f"not {'an' if expected[0] in 'OELS' else 'a'} {expected} file: {holds}"


def _unpacked(path: Path) -> bytes:
    try:
        with gzip.open(path) as file:
            return file.read()
    except (OSError, EOFError, zlib.error) as error:
        raise ShapeError(f"it is packed by gzip and is damaged: {error}") from None


def _read_unpacked(reader: Callable[[Path], Shape], data: bytes, ending: str) -> Shape:
    """Read unpacked data with a program or a library that needs a file, and may use its ending."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"unpacked{ending}"
        path.write_bytes(data)
        return reader(path)


def _unknown(ending: str) -> str:
    what = "the file has no ending, and its contents are of no known format"
    if ending:
        what = f"files that end in {ending} are not read"
    advice = _CONVERT.get(ending, "MeshLab, Blender or CloudCompare may convert it, to PLY for example")
    return f"{what}; {advice}. These are read: {READ}"
