# SPDX-License-Identifier: MIT
"""A drawing of anything in one call.  Needs NumPy.  `_draw_call.pyi` has all arguments with their types."""
from __future__ import annotations

import inspect
from typing import Any, Optional, Union

from ._camera import Camera
from ._context import Context
from ._options import OPTIONS
from ._picture import Picture, draw_of
from ._report import Progress
from ._request import in_documentation
from ._style import Style

__all__ = ["Picture", "draw"]


def draw(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    **others: Any,
) -> Picture:
    """Draw a file, arrays, or a mesh or cloud of another package, in one call.

    Options are those of ``python3 -m hrbfnpr draw`` that are not about files, as Python's values:
    ``size=(800, 600)``, ``samples=2000``, ``lines=["contour", "ridges"]``, ``ink="#203040"``,
    ``marks={"stipples": 20000}``, ``flip=True``, ``set={"hatch.ink": "#800000"}``; None stands for the default.

    Parameters
    ----------
    source : path, arrays, Shape, Mesh, Model, PointSet, or a mesh or cloud of PyVista, trimesh or Open3D
        A path is that of any file that the command line reads.  Arrays are points of shape (n, 3), whose normals are
        found, (points, normals) with an array of floats, or (points, triangles) with an array of integers.
    style : str or Style
        A named style (`hrbfnpr.PRESETS`), whose marks are sized for the picture, or one that is used as it is.
    camera : Camera, optional
        By default one that sees all, from `azimuth` and `elevation`.
    progress : callable, tqdm bar or True, optional
        Called with what is done and a fraction in [0, 1] of it; True makes a bar of tqdm's.
    context : Context, optional
        A new one if omitted.
    {options}
    **others
        Other names of these: those of the fields that they set, such as ``budget`` of ``marks``.

    Returns
    -------
    Picture
        Shows itself in a notebook; ``save``, ``image``, ``seen`` from another side.

    Raises
    ------
    TypeError
        For a source or an option that is unknown.
    ValueError
        For a source that cannot be drawn, a value out of its range, and a picture that would be blank
        (``allow_blank=True`` lets it be).

    Warns
    -----
    DrawingWarning
        Where the command line prints a warning.

    Examples
    --------
    >>> hrbfnpr.draw("bunny.ply", "hatch", size=800).save("bunny.png")
    >>> hrbfnpr.draw((points, normals), azimuth=60, lines="contour,suggestive")
    """
    return draw_of(source, style, others, camera, progress, context)


def _signature() -> inspect.Signature:
    """That of `draw`, with the options by their names: what help and editors show."""
    signature = inspect.signature(draw)
    *named, others = signature.parameters.values()
    options = (
        inspect.Parameter(row.name, inspect.Parameter.KEYWORD_ONLY, default=row.default, annotation=row.type) for row in OPTIONS
    )
    return signature.replace(parameters=[*named, *options, others])


draw.__doc__ = (draw.__doc__ or "").replace("{options}", in_documentation("    "))
draw.__signature__ = _signature()
