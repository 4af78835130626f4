# SPDX-License-Identifier: MIT
"""Images of depth cameras: remove the sensor's noise, and find normals."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional

from . import _records
from ._arrays import Array, block_in, output
from ._context import Context, resolve
from ._errors import new_struct
from ._library import lib
from ._operation import Operation, Progress, run
from ._records import read

if TYPE_CHECKING:
    from ._records import DepthImageInfo


class SmoothedDepthImage(NamedTuple):
    """Result of `smooth_depth_image`: `points`, `normals` and `info`, a `DepthImageInfo`."""

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
    """Remove the sensor's noise from the image of a depth camera, and find normals.

    A plane is fitted to the pixels around each point, without those beyond an edge, and the point moves along its ray onto
    the plane.  The planes are fitted in 1 / z, where the sensor's error is about the same everywhere.

    Parameters
    ----------
    points : array of float, shape (rows, columns, 3)
        One point for each pixel, with 8 to 65535 rows and columns.  The camera is at the origin and looks along +z or -z.
        NaN, infinity or z = 0 means that nothing was seen.  For an image of depths z with the focal lengths f and the
        centre c in pixels, x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
    keep_points : bool
        True: points stay where they are, and only get normals.
    noise : float
        Standard deviation of 1 / z, in 1 / (unit of the points); 0 = measure it.
    smoothing : float
        Factor of the radius over which pixels are averaged, above 0 and at most 100.  Larger values remove more noise and
        more small shapes.
    progress, operation, context
        As in `Model.fit`.

    Returns
    -------
    SmoothedDepthImage
        `points` and `normals`, each of shape (rows, columns, 3) and of the type of the given points, and `info`, a
        `DepthImageInfo`.  Where nothing was seen, and where a point is left out, the point is NaN and the normal 0.
        Normals point to the camera.

    Raises
    ------
    InvalidArgumentError
        If the points are not the image of such a camera.
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
    return SmoothedDepthImage(moved, normals, read(_records.DepthImageInfo, info))
