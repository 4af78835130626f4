# SPDX-License-Identifier: MIT
"""Normals for points that have none, or wrong ones."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional

from ._arrays import Array, block_in, output, vector
from ._context import Context, resolve
from ._errors import new_struct
from ._fit_desc import fill_normals
from ._library import lib
from ._names import NORMALS, number_of
from ._operation import Operation, Progress, run
from ._records import OrientInfo, read


class Oriented(NamedTuple):
    """Result of `orient`."""

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
    """Find the outward unit normals of points, or repair given ones.

    Normals are those of least energy of a Hermite fit (Huang, Carr, Ju 2019), found from several starts; noise is
    measured first.  Outward is where the winding number of a closed surface is 0; of an open one the convex side; and
    where that tells nothing, as of terrain, the side of `up` or of the viewpoint.

    Parameters
    ----------
    points : array of float, shape (N, 3)
        At least 4 different ones that are not all on a line.
    normals : array of float, shape (N, 3), optional
        Of any length; a zero one is not known, and is made.  Those that stay are returned as they are.
    mode : {"auto", "none", "unoriented", "mixed", "inward", "given"}
        What is known of the normals: "auto" finds it out, and leaves consistent outward ones alone; "none" makes all
        anew; "unoriented": directions are right, signs are not; "mixed": most signs are right, some patches are
        turned; "inward": all are turned; "given" only looks, and changes nothing.
    up : three numbers
        Of any length.
    viewpoint : three numbers, optional
        Where the points were seen from: open surfaces are turned to it.
    dtype : {"d", "f"}
        Of the result, if no normals are given: theirs otherwise.
    progress, operation, context
        See `Model.fit`.

    Returns
    -------
    Oriented
        `normals` of shape (N, 3) and `info`, an `OrientInfo`.  A low `info.confidence` is no error.

    Raises
    ------
    InvalidArgumentError
        For NaN or infinity (the message names the index), too few points, or points on a line.
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
    return Oriented(result, read(OrientInfo, info))
