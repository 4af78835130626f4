# SPDX-License-Identifier: MIT
"""Chooses points of a survey by their classes [ASPRS, LAS specification 1.4]."""
from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np

from ._shape import Integers, ShapeError

_GROUND = (2, 8, 9, 11)  # ground, its key points, water and roads
_VEGETATION = (3, 4, 5)
_NOISE = (7, 18)
_LEAST_SHARE = 0.01  # ground and vegetation each have at least this share of the points.  Larger: more surveys are read whole.


def chosen(classes: Any, withheld: Any, wanted: Optional[Sequence[int]] = None) -> Tuple[Integers, Tuple[str, ...]]:
    """The numbers of the points to use, and notes.

    `wanted` are classes, () for all.  The default leaves out noise, and all but the ground if vegetation covers it.  Points
    that are withheld are never used.
    """
    valid = ~np.asarray(withheld, dtype=bool)
    notes = [f"{(~valid).sum()} withheld points left out"] if not valid.all() else []
    classes = np.asarray(classes).astype(np.int64)
    if wanted is None:
        keep = valid & ~np.isin(classes, _NOISE)
        if (valid & ~keep).any():
            notes.append(f"{(valid & ~keep).sum()} points of noise left out (classes 7, 18)")
        ground, plants = keep & np.isin(classes, _GROUND), keep & np.isin(classes, _VEGETATION)
        if min((keep & (classes == 2)).sum(), plants.sum()) >= _LEAST_SHARE * keep.sum() > 0:
            notes.append(f"only the ground is read, {ground.sum()} of {keep.sum()} points (classes all reads all)")
            keep = ground
    else:
        keep = valid & np.isin(classes, wanted) if len(wanted) else valid
        if len(wanted):
            notes.append(f"{keep.sum()} of {len(classes)} points are of the classes {_listed(wanted)}")
    if not keep.any():
        there = _listed(np.unique(classes[valid])) or "none"
        raise ShapeError(f"there are no points of the classes to read; the file has the classes {there}")
    return np.flatnonzero(keep), tuple(notes)


def _listed(classes: Any) -> str:
    return ", ".join(str(int(one)) for one in classes)
