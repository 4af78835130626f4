# SPDX-License-Identifier: MIT
"""Reads GIFTI, a format for surfaces of brains: points, triangles, and values of the points, as XML.

Geometry format under the Neuroimaging Informatics Technology Initiative, version 1.0.
"""
from __future__ import annotations

import base64
import binascii
import xml.etree.ElementTree as ElementTree
import zlib
from typing import Dict, List, Optional, Tuple

import numpy as np

from ._attributes import PointValues, scalars
from ._shape import Floats, Integers, Shape, ShapeError, Vector

UP: Vector = (0.0, 0.0, 1.0)  # z is superior, the convention of brains
MAGIC = rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!DOCTYPE[^>]*>\s*)?(?:<!--.*?-->\s*)*<GIFTI\b"
_TYPES = {"NIFTI_TYPE_UINT8": "u1", "NIFTI_TYPE_INT32": "i4", "NIFTI_TYPE_FLOAT32": "f4", "NIFTI_TYPE_FLOAT64": "f8"}
_MOST = 1 << 28  # largest number of values of an array
_PLACES, _FACES, _DIRECTIONS = "NIFTI_INTENT_POINTSET", "NIFTI_INTENT_TRIANGLE", "NIFTI_INTENT_VECTOR"
_OTHERWISE = "wb_command -gifti-convert GZIP_BASE64_BINARY writes it anew"


def read_gifti(data: bytes) -> Shape:
    """Read the bytes of a GIFTI file.  Several surfaces of a file are drawn together."""
    try:
        root = ElementTree.fromstring(data)
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise ShapeError(f"the GIFTI file is not valid XML, so it may be cut short: {error}") from None
    arrays = [(one.get("Intent", ""), _name_of(one), _array(one, i)) for i, one in enumerate(root.iter("DataArray"), 1)]
    points = [_rows(array, "points") for intent, _, array in arrays if intent == _PLACES]
    faces = [_rows(array, "triangles") for intent, _, array in arrays if intent == _FACES]
    if not points:
        raise ShapeError(
            "the GIFTI file has no points: it holds values for a surface in another file, which ends in .surf.gii"
        )
    if len(faces) not in (0, len(points)):
        raise ShapeError(f"the GIFTI file has {len(points)} arrays of points and {len(faces)} arrays of triangles")
    first = np.cumsum([0] + [len(part) for part in points])
    for part, start, face in zip(points, first, faces):
        if len(face) and not 0 <= int(face.min()) <= int(face.max()) < len(part):
            raise ShapeError(f"a face names vertex {int(face.max())}, but its surface has only {len(part)} vertices")
    triangles: Optional[Integers] = (
        np.concatenate([face.astype(np.int64) + start for face, start in zip(faces, first)]) if faces else None
    )
    places = np.concatenate(points).astype(np.float64)
    return Shape(places, None, triangles, "GIFTI", ("x", "y", "z"), UP, fields=_fields(arrays, len(places)), unit="millimetres")


def _fields(arrays: List[Tuple[str, str, Floats]], count: int) -> Dict[str, PointValues]:
    """The arrays with a number, or a direction, for each point."""
    found: Dict[str, PointValues] = {}
    for intent, name, array in arrays:
        bare = intent.replace("NIFTI_INTENT_", "").lower()
        if intent in (_PLACES, _FACES) or len(array) != count or array.ndim > 2:
            continue
        if array.size == count:
            found.setdefault(name or bare, scalars(array))
        elif intent == _DIRECTIONS and array.shape[1:] == (3,):
            found.setdefault(name or bare, PointValues("direction", array.astype(np.float32)))
    return found


def _name_of(element: ElementTree.Element) -> str:
    for one in element.iterfind("MetaData/MD"):
        if one.findtext("Name", "").strip() == "Name":
            return (one.findtext("Value") or "").strip()[:63]
    return ""


def _rows(array: Floats, what: str) -> Floats:
    if array.ndim != 2 or array.shape[1] != 3:
        raise ShapeError(f"the {what} of the GIFTI file have the shape {array.shape}, not (n, 3)")
    return array


def _array(element: ElementTree.Element, number: int) -> Floats:
    """The values of an array; `number` is for messages."""
    which = f"array {number} of the GIFTI file"
    try:
        shape = tuple(int(element.get(f"Dim{i}", "")) for i in range(int(element.get("Dimensionality", "1"))))
    except ValueError:
        raise ShapeError(f"{which} does not say its size: its Dim attributes are no whole numbers") from None
    size = int(np.prod(np.array(shape, dtype=object))) if shape else 0
    if not 0 < len(shape) <= 6 or min(shape) < 0 or size > _MOST:
        raise ShapeError(f"{which} has the size {' x '.join(map(str, shape))}: it is damaged, or too large")
    kind = element.get("DataType", "")
    if kind not in _TYPES:
        raise ShapeError(f"{which} has values of the type {kind or 'that is missing'}, which GIFTI does not have")
    values = _values(element, np.dtype(_TYPES[kind]), which, size)
    if len(values) != size:
        raise ShapeError(f"{which} has {len(values)} of {size} values: it is cut short or damaged; {_OTHERWISE}")
    order = "F" if element.get("ArrayIndexingOrder") == "ColumnMajorOrder" else "C"
    return values.reshape(shape, order=order)  # type: ignore[call-overload,no-any-return]


def _values(element: ElementTree.Element, kind: "np.dtype[np.generic]", which: str, size: int) -> Floats:
    text, coding = (element.findtext("Data") or "").encode(), element.get("Encoding", "")
    if coding == "ASCII":
        try:
            return np.array(text.split(), dtype=np.float64)
        except ValueError:
            raise ShapeError(f"{which} holds a word that is not a number") from None
    if coding not in ("Base64Binary", "GZipBase64Binary"):
        advice = "its values are in another file; " if coding == "ExternalFileBinary" else f"its encoding is {coding!r}; "
        raise ShapeError(f"{which} is not read: {advice}{_OTHERWISE}")
    try:
        packed = base64.b64decode(b"".join(text.split()), validate=True)
        if coding == "GZipBase64Binary":
            opener = zlib.decompressobj(zlib.MAX_WBITS | 32)
            packed = opener.decompress(packed, size * kind.itemsize + 1)
    except (binascii.Error, zlib.error, ValueError) as error:
        raise ShapeError(f"{which} is damaged: {error}; {_OTHERWISE}") from None
    whole = packed[: len(packed) // kind.itemsize * kind.itemsize]
    return np.frombuffer(whole, kind.newbyteorder(">" if element.get("Endian") == "BigEndian" else "<"))
