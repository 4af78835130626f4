# SPDX-License-Identifier: MIT
"""Images of depth cameras: points without the sensor's noise, and their normals."""
from __future__ import annotations

from typing import NamedTuple, Optional

from ._arrays import Array, block_in, output
from ._context import Context, resolve
from ._errors import new_struct
from ._library import lib
from ._operation import Operation, Progress, run
from ._records import DepthImageInfo, read


class SmoothedDepthImage(NamedTuple):
    """Result of `smooth_depth_image`."""

    points: Array
    normals: Array
    info: DepthImageInfo


def smooth_depth_image(
    points: Array,
    *,
    keep_points: bool = False,
    noise: float = 0.0,
    smoothing: float = 1.0,
    progress: Optional[Progress] = None,
    operation: Optional[Operation] = None,
    context: Optional[Context] = None,
) -> SmoothedDepthImage:
    """Take the sensor's noise off the image of a depth camera, and find normals.

    The sensor's errors are as large everywhere in 1 / z, and planes are linear in it: one is fitted to the pixels around
    each, but for those beyond an edge; the point moves along its ray onto the plane.

    Parameters
    ----------
    points : array of float, shape (rows, columns, 3)
        8 to 65535 rows and columns.  The camera is in the origin and looks along z, or against it; NaN, infinity or
        z = 0 where nothing was seen.  Of an image of depths with focal lengths f and a centre c, in pixels, they are
        x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
    keep_points : bool
        Points stay where they are, and get normals.
    noise : float
        Standard deviation of 1 / z; 0 measures it.
    smoothing : float
        Factor of the radius, above 0 and up to 100.
    progress, operation, context
        See `Model.fit`.

    Returns
    -------
    SmoothedDepthImage
        `points` and `normals` of shape (rows, columns, 3), of the type of `points`; NaN and 0 where nothing was seen, or
        the point is left out; normals look to the camera.  `info` is a `DepthImageInfo`.

    Raises
    ------
    InvalidArgumentError
        If the points are no image of such a camera.
    OutOfMemoryError, CancelledError
    """
    context = resolve(context)
    desc = new_struct("hrbfnpr_depth_image_desc")
    block = block_in("points", points)
    if len(block.shape) != 2:
        raise ValueError(f"points must have the shape (rows, columns, 3), not {(*block.shape, 3)}")
    desc.rows, desc.columns = block.shape
    keep = block.fill(desc.points)
    desc.keep_points, desc.noise, desc.smoothing = bool(keep_points), noise, smoothing
    moved, to_points = output("points", None, block.shape, 3, block.code)
    normals, to_normals = output("normals", None, block.shape, 3, block.code)
    info = new_struct("hrbfnpr_depth_image_info")
    results = to_points, to_normals, info
    run(lib.hrbfnpr_smooth_depth_image, (context._handle, desc), operation, progress, context._handle, results=results)
    del keep
    return SmoothedDepthImage(moved, normals, read(DepthImageInfo, info))
