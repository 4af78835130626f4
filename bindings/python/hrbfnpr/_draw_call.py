# SPDX-License-Identifier: MIT
"""`draw`: a drawing from any source in one call.  Needs NumPy.  `_draw_call.pyi` has all arguments with their types."""
from __future__ import annotations

import inspect
from typing import Any, Mapping, Optional, Union

from ._camera import Camera
from ._context import Context
from ._options import OPTIONS
from ._picture import Picture, draw_of
from ._report import Progress
from ._request import in_documentation
from ._style import Style
from ._vtk_scene import is_window

__all__ = ["Picture", "draw", "from_pyvista"]


def draw(
    source: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    fields: Optional[Mapping[str, Any]] = None,
    **others: Any,
) -> Picture:
    """Draw a file, arrays, or a mesh or point cloud of another package, in one call.

    The options are those of ``python3 -m hrbfnpr draw``, except those about files, with values of Python:
    ``size=(800, 600)``, ``samples=2000``, ``lines=["contour", "ridges"]``, ``ink="#203040"``,
    ``marks={"stipples": 20000}``, ``flip=True``, ``set={"hatch.ink": "#800000"}``.  None means the default.

    Parameters
    ----------
    source : path, arrays, Shape, Mesh, Model, PointSet, or an object of VTK, PyVista, trimesh or Open3D
        What to draw.  A path names any file that the command line reads.  Arrays are points of shape (n, 3), whose normals
        are found; (points, normals), if the second array holds floats; or (points, triangles), if it holds integers.
        Objects of other packages are meshes, grids and point clouds, and whole scenes, see `from_pyvista`.
    style : str or Style
        A named style (`hrbfnpr.PRESETS`), whose marks are sized for the picture, or a `Style`, which is used as it is.
    camera : Camera, optional
        The camera; by default one that sees everything from `azimuth` and `elevation`.
    progress : callable, tqdm bar or True, optional
        A function that is called with the present step and the fraction of it that is done, 0 to 1; or a bar of tqdm; True
        makes such a bar.
    context : Context, optional
        The threads to use; by default a new context.
    fields : mapping of str to array, optional
        Values of the source's points, for the option `field`: shape (n,) for numbers, (n, 3) for colours from 0 to 1 (or 0 to
        255) and for directions.  They are added to those of a file.
    {options}
    **others
        Options under other names: those of the fields that they set, such as ``budget`` for ``marks``.

    Returns
    -------
    Picture
        The drawing.  It shows itself in a notebook.  ``save`` writes it, ``image`` gives its pixels, and ``seen`` draws it
        from another side.

    Raises
    ------
    TypeError
        If the source or an option is unknown.
    ValueError
        If the source cannot be drawn, a value is out of its range, or the picture would be blank (unless
        ``allow_blank=True``).

    Warns
    -----
    DrawingWarning
        In the cases in which the command line prints a warning.

    Examples
    --------
    >>> hrbfnpr.draw("bunny.ply", "hatch", size=800).save("bunny.png")
    >>> hrbfnpr.draw("bunny.ply", "stipple", fields={"heat": heat}, field="tone=heat", size=800)
    >>> hrbfnpr.draw((points, normals), azimuth=60, lines="contour,suggestive")
    """
    return draw_of(source, style, others, camera, progress, context, fields)


def from_pyvista(
    plotter: Any,
    style: Union[str, Style] = "contour-and-stipple",
    *,
    camera: Optional[Camera] = None,
    progress: Progress = None,
    context: Optional[Context] = None,
    **options: Any,
) -> Picture:
    """Draw what a window of PyVista or VTK shows, seen by its camera.  `draw` does the same for such a window.

    Each visible actor is a surface at its place, and all hide each other's lines exactly.  Colours of the actors, or of their
    values by their colour maps, become inks if they differ.  Arrays of the points are `field` values by their names.
    Actors that are hidden, volumes, lines, axes and text are left out; notes of the picture say so.

    Parameters
    ----------
    plotter : Plotter of PyVista, vtkRenderWindow or vtkRenderer
        The window.  It needs not be shown before.  Of several renderers with actors the active one is drawn, or the first one.
    style, camera, progress, context
        As in `draw`.
    **options
        Those of `draw`.  The default size is that of the window.  An option that places the camera, such as `azimuth` or
        `eye`, replaces the camera of the window.

    Raises
    ------
    TypeError
        If it is not a window.
    ValueError
        If it shows nothing that can be drawn.

    Examples
    --------
    >>> hrbfnpr.from_pyvista(plotter, "engraving").save("scene.svg")
    """
    if not is_window(plotter):
        raise TypeError(
            "from_pyvista draws a Plotter of PyVista, a vtkRenderWindow or a vtkRenderer, not "
            f"{type(plotter).__name__}; hrbfnpr.draw takes meshes and actors"
        )
    return draw_of(plotter, style, options, camera, progress, context)


def _signature() -> inspect.Signature:
    """The signature of `draw` with all options by name, for help and editors."""
    signature = inspect.signature(draw)
    *named, others = signature.parameters.values()
    options = (
        inspect.Parameter(row.name, inspect.Parameter.KEYWORD_ONLY, default=row.default, annotation=row.type) for row in OPTIONS
    )
    return signature.replace(parameters=[*named, *options, others])


draw.__doc__ = (draw.__doc__ or "").replace("{options}", in_documentation("    "))
draw.__signature__ = _signature()
