# SPDX-License-Identifier: MIT
"""Finds out what the columns of a table of points hold: from a line of headings, or from their numbers."""
from __future__ import annotations

import re
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._shape import Floats

# Names of x and y on maps, the better pair first, and of heights, the better first.  The last pair are degrees.
_MAPS = (
    (r"east(?:ings?)?", r"north(?:ings?)?"),
    (r"e", r"n"),
    (r"(?:\w+[_ ])?east(?:ings?)?(?:[_ ]\w+)?", r"(?:\w+[_ ])?north(?:ings?)?(?:[_ ]\w+)?"),
    (r"(?:gps[_ ]?)?(?:lon|long|lng|longitude)", r"(?:gps[_ ]?)?(?:lat|latitude)"),
    (r"(?:\w+[_ ])?[a-z]?(?:lon|longitude)(?:[_ ]\w+)?", r"(?:\w+[_ ])?[a-z]?(?:lat|latitude)(?:[_ ]\w+)?"),
)
_HEIGHT = r"(?:elevation|elev|ele|height|hgt|altitude|alt)"
_HEIGHTS = (_HEIGHT, "h", rf"(?:[\w ]+[_ ])?{_HEIGHT}(?:[_ ][\w ]+)?|[hz]_\w+|z[gt]|hae")
_UNIT_OF_NAME = r"[_ ](?:m|metres?|meters?|mm|cm|km|ft|feet|deg|degrees?|dd|utm|wgs[_ ]?84)$"
_COLOURS = {"r": "red", "g": "green", "b": "blue", "red": "red", "green": "green", "blue": "blue"}
_AXIS = {"0": "x", "1": "y", "2": "z", "x": "x", "y": "y", "z": "z"}
_UNIT = 0.02  # largest difference of a normal's length from 1
_MOST = 0.9  # share of the rows that must agree on what a column is


class Columns(NamedTuple):
    """A name for each column, notes on how the names were found, and whether x and y are named as on a map, or as degrees."""

    names: Tuple[str, ...]
    notes: Tuple[str, ...] = ()
    on_map: bool = False
    degrees: bool = False

    def triple(self, names: Sequence[str]) -> Optional[List[int]]:
        """The places of three columns, or None if one is missing."""
        if all(name in self.names for name in names):
            return [self.names.index(name) for name in names]
        return None


def _name(word: str) -> str:
    """The standard name for a heading, or the heading itself if it is unknown."""
    bare = re.sub(r"[\[(](?!\d)[^\])]*[\])]", "", word.strip().strip("\"'").lower()).strip(" _")
    bare = re.sub(_UNIT_OF_NAME, "", bare)
    if bare in _COLOURS:
        return _COLOURS[bare]
    normal = re.fullmatch(r"(?:n|norm|normals?)[ _:.\[]*([xyz012])\]?", bare)
    normal = normal or re.fullmatch(r"([xyz])_?n(?:ormal)?", bare)
    if normal:
        return "n" + _AXIS[normal.group(1)]
    place = re.fullmatch(r"(?:p|pos|positions?|points?|coords?|coordinates?|vertex)[ _:.\[]*([xyz012])\]?", bare)
    place = place or re.fullmatch(r"([xyz])[ _]?(?:pos|position|coord|coordinate|value)?", bare)
    if place:
        return _AXIS[place.group(1)]
    return bare or "nothing"


def by_heading(words: Sequence[str]) -> Optional[Columns]:
    """The columns named by a line of headings, or None if it does not name x, y and z."""
    found = [_name(word) for word in words]
    on_map = degrees = False
    if not {"x", "y"} <= set(found):
        for east, north in _MAPS:
            places = [_first(found, east), _first(found, north)]
            if None not in places:
                on_map, degrees = True, "lon" in east
                for place, axis in zip(places, "xy"):
                    found[place or 0] = axis
                break
    if "z" not in found:
        height = next((place for place in (_first(found, names) for names in _HEIGHTS) if place is not None), None)
        if height is not None:
            found[height] = "z"
    names: List[str] = []
    for name in found:
        names.append(name if name not in names else f"{name} again")
    return Columns(tuple(names), (), on_map, degrees) if all(axis in names for axis in "xyz") else None


def _first(names: Sequence[str], pattern: str) -> Optional[int]:
    """The place of the first name that matches."""
    return next((place for place, name in enumerate(names) if re.fullmatch(pattern, name)), None)


def _is_unit(rows: Floats) -> bool:
    length = np.linalg.norm(rows, axis=1)
    used = np.isfinite(length) & (length > 0)
    return bool(used.any()) and float((np.abs(length[used] - 1) <= _UNIT).mean()) >= _MOST


def _is_numbered(table: Floats) -> bool:
    """Whether the first of four or more columns counts the rows, and the columns after it are not whole numbers."""
    if table.shape[1] < 4 or len(table) < 3:
        return False
    first = table[:, 0]
    return bool((first - first[0] == np.arange(len(table))).all() and (table[:, 1:4] != np.round(table[:, 1:4])).any())


def _is_colour(rows: Floats) -> bool:
    """Whether columns are whole numbers of 0 to 255, or numbers of 0 to 1.  Normals are neither: they have both signs."""
    finite = rows[np.isfinite(rows).all(axis=1)]
    if len(finite) == 0 or finite.min() < 0:
        return False
    if finite.max() <= 1:
        return True
    return bool(finite.max() <= 255 and (finite == np.round(finite)).all())


def by_content(table: Floats, normals_expected: bool = False, before: int = 0) -> Columns:
    """The columns named by what they hold.

    `normals_expected`: whether the file's ending promises normals.  `before`: the number of columns of the file that
    `table` lacks.
    """
    if _is_numbered(table):
        rest = by_content(table[:, 1:], normals_expected, 1)
        return Columns(("number", *rest.names), ("column 1 counts the points: it is not used", *rest.notes))
    width = table.shape[1]
    some: Any = table if len(table) <= 20000 else table[:: len(table) // 20000 + 1]
    found: Dict[int, Tuple[str, ...]] = {}
    notes: List[str] = []
    starts = range(3, width - 2)
    unit = [start for start in starts if _is_unit(some[:, start : start + 3])]
    # A colour may have the length 1 by chance, as pure red has.  Normals have both signs.
    signed = [start for start in unit if some[:, start : start + 3].min() < 0]
    place = (signed or unit or [0])[0]
    if not place:
        place = _other_normals(some, starts, normals_expected, notes, before)
    if place:
        found[place] = ("nx", "ny", "nz")
    for start in starts:
        taken = {place, place + 1, place + 2} if place else set()
        free = found.keys() <= {place} and not taken & {start, start + 1, start + 2}
        if free and _is_colour(some[:, start : start + 3]) and not _begins_with_intensity(some, start, place):
            found[start] = ("red", "green", "blue")
    names = ["x", "y", "z"] + ["other"] * (width - 3)
    for start, three in found.items():
        names[start : start + 3] = three
    if width >= 6 and not place:
        what = "colours" if any("red" in three for three in found.values()) else "no normals"
        which = next((start for start, three in found.items() if "red" in three), 3)
        unused = "they are not used as normals" if what == "colours" else "they are not used"
        notes.append(f"columns {which + 1 + before} to {which + 3 + before} are {what}: {unused}")
    return Columns(tuple(names), tuple(notes))


def _begins_with_intensity(table: Floats, start: int, normals: int) -> bool:
    """Whether four columns before the normals or the end are an intensity and a colour, as in PTS, and not a colour and alpha."""
    end = normals if normals > start else table.shape[1]
    four = table[:, start:end]
    return four.shape[1] == 4 and _is_colour(four[:, 1:]) and bool((four[:, 3] != four[0, 3]).any())


def _other_normals(table: Floats, starts: Sequence[int], expected: bool, notes: List[str], before: int) -> int:
    """The place of normals that are not of unit length; 0 if there are none."""
    for start in starts:
        rows = table[:, start : start + 3]
        if len(starts) > 1 and start + 3 != table.shape[1]:
            continue  # among several triples, only the last can hold normals
        if expected or (not _is_colour(rows) and float(np.nanmin(rows)) < 0):
            which = f"columns {start + 1 + before} to {start + 3 + before}"
            notes.append(f"{which} are read as normals, though not of length 1")
            return start
    return 0
