# SPDX-License-Identifier: MIT
"""Values that a file holds for each point besides its place and normal: colours, intensities, qualities and directions."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats32 = NDArray[np.float32]
else:  # NumPy before 1.20 has no numpy.typing
    Floats32 = np.ndarray

COLOUR = "rgb"  # the name of the colours of a file
_OF_SHAPE = ("x", "y", "z", "nx", "ny", "nz", "normal_x", "normal_y", "normal_z")
_COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
_NOT_VALUES = ("alpha", "number", "nothing")  # columns that are rarely meant as values
_PREFIX = "scalar_"  # CloudCompare writes it before the name of each scalar field


class PointValues(NamedTuple):
    """Values of one kind, one for each point.

    Attributes
    ----------
    kind : str
        ``"scalar"``, ``"colour"`` (sRGB from 0 to 1) or ``"direction"``.
    values : array of float32, shape (n,) for scalars, else (n, 3)
        The values.  NaN means that a point has none.
    """

    kind: str
    values: Floats32


def colours(values: Any) -> PointValues:
    """Colours from three or more columns.  Whole numbers reach to the largest number of their type, or to 255."""
    array = np.asarray(values)[:, :3]
    numbers = array.astype(np.float32)
    if array.dtype.kind == "u":
        return PointValues("colour", numbers / np.float32(np.iinfo(array.dtype).max))
    most = float(np.nanmax(numbers)) if np.isfinite(numbers).any() else 0.0
    return PointValues("colour", numbers / np.float32(1.0 if most <= 1.0 else 255.0 if most <= 255.0 else 65535.0))


def scalars(values: Any) -> PointValues:
    return PointValues("scalar", np.asarray(values).reshape(-1).astype(np.float32))


def values_of(name: str, values: Any, count: int, is_direction: bool) -> PointValues:
    """The values of an array for `count` points: numbers, or three for each point.

    Raises
    ------
    ValueError
        If the array has another shape.
    """
    array = np.asarray(values)
    if array.shape[:1] != (count,) or array.shape[1:] not in ((), (1,), (3,), (4,)) or array.dtype.kind not in "fiub":
        raise ValueError(f"fields[{name!r}] must hold numbers of the shape ({count},) or ({count}, 3), not {array.shape}")
    if array.shape[1:] in ((), (1,)):
        return scalars(array)
    return PointValues("direction", array[:, :3].astype(np.float32)) if is_direction else colours(array)


def attributes(columns: Mapping[str, Any]) -> Dict[str, PointValues]:
    """The values of named columns of numbers.

    Three columns of colours become "rgb".  Three columns whose names differ only in a last x, y and z become a direction
    with the rest of the name, as dir_x, dir_y and dir_z become "dir".  All others become scalars.
    """
    found: Dict[str, PointValues] = {}
    taken = set(_OF_SHAPE)
    for three in _COLOURS:
        if COLOUR not in found and all(name in columns for name in three):
            found[COLOUR] = colours(np.column_stack([columns[name] for name in three]))
            taken |= set(three)
    for stem, three in _directions([name for name in columns if name not in taken]):
        found[stem] = PointValues("direction", np.column_stack([columns[name] for name in three]).astype(np.float32))
        taken |= set(three)
    for name, values in columns.items():
        bare = name[len(_PREFIX) :] if name.startswith(_PREFIX) and len(name) > len(_PREFIX) else name
        if name in taken or bare in _NOT_VALUES or bare in found:
            continue
        one = scalars(values)
        if np.isfinite(one.values).any():
            found[bare] = one
    return found


def _directions(names: Iterable[str]) -> List[Tuple[str, Tuple[str, str, str]]]:
    known = set(names)
    found: List[Tuple[str, Tuple[str, str, str]]] = []
    for name in sorted(known):
        stem = name[:-1]
        three = (name, f"{stem}y", f"{stem}z")
        if name.endswith("x") and stem.strip("_") and known.issuperset(three):
            found.append((stem.rstrip("_"), three))
    return found


def joined(parts: List[Tuple[int, Optional[PointValues]]]) -> Optional[PointValues]:
    """Values of parts that follow each other, as pairs of a count and values.  Parts without values get NaN."""
    given = [part for _, part in parts if part is not None]
    if not given:
        return None
    shape = given[0].values.shape[1:]
    rows = [np.full((count, *shape), np.nan, np.float32) if part is None else part.values for count, part in parts]
    return PointValues(given[0].kind, np.concatenate(rows))
