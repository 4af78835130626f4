# SPDX-License-Identifier: MIT
"""Normals for points that have none or wrong ones."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from . import _records
from ._arrays import Array, block_in, output, vector
from ._context import Context, resolve
from ._errors import new_struct
from ._fit_desc import fill_normals
from ._library import lib
from ._names import NORMALS, number_of
from ._operation import Operation, Progress, run
from ._records import read

if TYPE_CHECKING:
    from ._records import OrientInfo


class Oriented(NamedTuple):
    """Result of `orient`: `normals` and `info`, an `OrientInfo`."""

    normals: Array
    info: OrientInfo


def orient(
    points: Array,
    normals: Optional[Array] = None,
    mode: str = "auto",
    *,
    up: Any = (0.0, 0.0, 1.0),
    viewpoint: Any = None,
    dtype: Any = "d",
    progress: Optional[Progress] = None,
    operation: Optional[Operation] = None,
    context: Optional[Context] = None,
) -> Oriented:
    """Find outward unit normals for points, or repair given normals.

    The normals are those of least bending energy of a Hermite fit (Huang, Carr, Ju 2019), found from several starts.  The
    noise of the points is measured first.  For a closed surface, outward is the side that it does not enclose.  For an open
    surface it is the side of the viewpoint, if one is given; else the convex side, if the surface encloses one side more
    than the other; else, as for a terrain, the side of `up`.

    Parameters
    ----------
    points : array of float, shape (N, 3)
        At least 4 different points that are not all on one line.
    normals : array of float, shape (N, 3), optional
        Normals of any length.  A zero normal is unknown and is made.  Normals that stay are returned unchanged.
    mode : {"auto", "none", "unoriented", "mixed", "inward", "given"}
        How far the normals can be trusted.  "auto": find out, and leave correct ones alone.  "none": make all normals.
        "unoriented": the directions are correct, the signs are not.  "mixed": most signs are correct, some patches are
        turned.  "inward": all point inward.  "given": only look, and change nothing.
    up : three numbers
        The direction that decides for surfaces like a terrain, of any length except 0.
    viewpoint : three numbers, optional
        The place from which the points were seen.  Normals of open surfaces point to its side.
    dtype : {"d", "f"}
        Type of the result, if no normals are given; otherwise it is the type of the normals.
    progress, operation, context
        As in `Model.fit`.

    Returns
    -------
    Oriented
        `normals`, shape (N, 3), and `info`, an `OrientInfo`.  A low `info.confidence` is no error.

    Raises
    ------
    InvalidArgumentError
        If there are NaN or infinity (the message names the index) or too few points, or all points are on one line.
    OutOfMemoryError, CancelledError
    """
    context = resolve(context)
    desc = new_struct("hrbfnpr_orient_desc")
    block = block_in("points", points)
    keep = fill_normals(desc, points, normals)
    desc.mode = number_of("mode", NORMALS, mode)
    desc.up = vector("up", up)
    if viewpoint is not None:
        desc.viewpoint, desc.has_viewpoint = vector("viewpoint", viewpoint), 1
    code = block_in("normals", normals).code if normals is not None else dtype
    result, target = output("normals", None, block.shape, 3, code)
    info = new_struct("hrbfnpr_orient_info")
    run(lib.hrbfnpr_orient, (context._handle, desc), operation, progress, context._handle, results=(target, info))
    del keep
    return Oriented(result, read(_records.OrientInfo, info))
