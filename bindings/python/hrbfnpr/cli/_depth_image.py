# SPDX-License-Identifier: MIT
"""Points that are the image of a depth camera: without the sensor's noise, with normals, and chosen by pixels."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, Tuple

import numpy as np

from .._context import Context
from .._depth_image import DepthImageInfo, smooth_depth_image
from .._mesh import farthest_points
from ..shapes import Shape
from ..shapes._shape import Floats
from . import _nearness
from ._progress import Reporter


HOLE = 8.0  # pixels from its border to its middle: a larger one is what the camera did not see behind something


def smooth(shape: Shape, arguments: Any, context: Context, report: Reporter) -> Tuple[Shape, float]:
    """The points that were seen, on smooth surfaces, with normals that look to the camera; and how large holes are."""
    assert shape.image_shape is not None
    factor = arguments.depth_smoothing
    options = {} if factor is None else {"keep_points": True} if factor == 0 else {"smoothing": factor}
    with report.stage("smooth", "smoothing") as stage:
        seen, info = smoothed(shape, context, progress=stage.bar, **options)
        stage.says = (
            f"{info.seen} pixels of {shape.image_shape[1]} x {shape.image_shape[0]}, over {info.radius:.1f} pixels where "
            f"the depth is {info.depth:.3g}"
        )
    if info.left_out:
        report.note(f"{_nearness.of(info.left_out, 'pixel')} on no surface left out, as between an edge and what is behind it")
    fate = "the points keep it" if factor == 0 else "it is smoothed (--depth-smoothing F: more or less, 0 keeps it)"
    report.note(f"the depth camera has noise of {noise_of(info):.2g} where the depth is {info.depth:.3g}: {fate}")
    return seen, HOLE * info.depth / info.focal_length


def smoothed(shape: Shape, context: Context, **options: Any) -> Tuple[Shape, DepthImageInfo]:
    """The pixels that have a point, with normals; options of `hrbfnpr.smooth_depth_image`."""
    assert shape.image_shape is not None
    made = smooth_depth_image(shape.points.reshape(*shape.image_shape, 3), context=context, **options)
    points, normals = (np.asarray(each, dtype=float).reshape(-1, 3) for each in (made.points, made.normals))
    kept = np.isfinite(points).all(axis=1)
    return replace(shape, points=points[kept], normals=normals[kept], image_shape=None), made.info


def noise_of(info: DepthImageInfo) -> float:
    """Of the median depth z, from that of 1 / z."""
    return info.noise * info.depth**2


def chosen(points: Floats, count: int, context: Context) -> Any:
    """Indices of points that are even in the image; what is near has them nearer to each other, as it has pixels."""
    x, y, z = points.T
    places = np.column_stack([x / z, y / z, np.log(np.abs(z))])
    return np.asarray(farthest_points(places, count, context=context)[0])
