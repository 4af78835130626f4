# SPDX-License-Identifier: MIT
"""XYZ and PWN point sets; OBJ and OFF meshes."""
from __future__ import annotations

from typing import Any, List, Optional

import numpy as np

from ._shape import Shape, ShapeError, fans


def _numbers(words: List[str], what: str) -> Any:
    try:
        return np.array(words, dtype=np.float64)
    except ValueError:
        wrong = next(word for word in words if not _is_number(word))
        raise ShapeError(f"{what} must be numbers, not {wrong!r}") from None


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _lines(text: str, comment: str = "#") -> List[List[str]]:
    """The words of each line that has any."""
    split = (line.split(comment, 1)[0].replace(",", " ").split() for line in text.splitlines())
    return [words for words in split if words]


def read_xyz(text: str) -> Shape:
    """Three or six numbers a line; or a count, then all points, then all normals (PWN)."""
    lines = _lines(text)
    if not lines:
        raise ShapeError("there are no points")
    counted = len(lines[0]) == 1
    if counted:
        count = _count(lines[0][0])
        lines = lines[1:]
    width = len(lines[0]) if lines else 0
    if any(len(words) != width for words in lines):
        raise ShapeError("the lines differ in how many numbers they hold")
    table = _numbers([word for words in lines for word in words], "coordinates").reshape(len(lines), width)
    if counted and width == 3 and len(lines) == 2 * count:
        return Shape(table[:count], table[count:])
    if counted and len(lines) != count:
        raise ShapeError(f"the first line announces {count} points, but {len(lines)} lines of {width} numbers follow")
    if width not in (3, 6):
        raise ShapeError(f"a line must hold 3 numbers, or 6 with a normal, not {width}")
    return Shape(table[:, :3], table[:, 3:] if width == 6 else None)


def _count(word: str) -> int:
    if not word.isdigit():
        raise ShapeError(f"a count was expected, not {word!r}")
    return int(word)


def read_obj(text: str) -> Shape:
    """Vertices and faces; normals only where there are no faces and one for each vertex."""
    vertices: List[str] = []
    normals: List[str] = []
    faces: List[List[int]] = []
    for words in _lines(text.replace("\\\n", " ").replace("\\\r\n", " ")):
        if words[0] in ("v", "vn") and len(words) < 4:
            raise ShapeError(f"a line of the OBJ file has too few numbers: {' '.join(words)!r}")
        if words[0] == "v":
            vertices += words[1:4]
        elif words[0] == "vn":
            normals += words[1:4]
        elif words[0] == "f":
            faces.append([_obj_index(word, len(vertices) // 3) for word in words[1:]])
    points = _numbers(vertices, "vertices").reshape(-1, 3)
    if faces:
        return Shape(points, None, fans(faces))
    matched = len(normals) == len(vertices)
    return Shape(points, _numbers(normals, "normals").reshape(-1, 3) if matched else None)


def _obj_index(word: str, count: int) -> int:
    """Of "7", "7/1", "7//3" or "-1": counted from 1, or from the end."""
    try:
        index = int(word.split("/")[0])
    except ValueError:
        raise ShapeError(f"a face of the OBJ file has the corner {word!r}") from None
    return index - 1 if index > 0 else count + index


def read_off(text: str) -> Shape:
    """OFF and its kin with normals (NOFF) or colours (COFF); text only."""
    lines = _lines(text)
    head = lines[0][0] if lines else ""
    if not head.endswith("OFF") or "BINARY" in lines[0]:
        raise ShapeError("not an OFF file in text form")
    if "4" in head or "n" in head:
        raise ShapeError(f"OFF files of the dimension of {head!r} are not understood")
    rest = [lines[0][1:], *lines[1:]] if len(lines[0]) > 1 else lines[1:]
    if not rest or len(rest[0]) < 2:
        raise ShapeError("the OFF file lacks its counts")
    vertex_count, face_count = _count(rest[0][0]), _count(rest[0][1])
    if len(rest) < 1 + vertex_count + face_count:
        raise ShapeError(f"the OFF file ends before its {vertex_count} vertices and {face_count} faces do")
    width = 6 if "N" in head else 3
    vertices = rest[1 : 1 + vertex_count]
    if any(len(words) < width for words in vertices):
        raise ShapeError(f"a vertex of the OFF file has fewer than {width} numbers")
    table = _numbers([word for words in vertices for word in words[:width]], "vertices").reshape(-1, width)
    faces = [_off_face(words) for words in rest[1 + vertex_count : 1 + vertex_count + face_count]]
    normals: Optional[Any] = table[:, 3:] if width == 6 else None
    return Shape(table[:, :3], normals, fans(faces) if faces else None)


def _off_face(words: List[str]) -> List[int]:
    count = _count(words[0])
    if len(words) < 1 + count:
        raise ShapeError(f"a face of the OFF file has fewer than its {count} corners")
    return [int(number) for number in _numbers(words[1 : 1 + count], "corners of faces")]
