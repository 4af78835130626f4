# SPDX-License-Identifier: MIT
"""Makes drawings from point sets and a camera."""
from __future__ import annotations

import threading
from typing import Optional

from ._callbacks import check
from ._camera import Camera
from ._context import Context, resolve
from ._drawing import Drawing
from ._errors import new_error
from ._handles import Owner, own
from ._item import Items, as_items, prepared
from ._library import ffi, lib
from ._operation import Operation, Progress, running


class Renderer(Owner):
    """Draws point sets with a camera [NPAR 6].

    A renderer keeps its scratch memory, and the memory of drawings that are no longer used, for the next drawing.  If
    several threads call one renderer, they wait for each other: give each thread its own renderer.

    Where the camera moves little, contours are continued from the last drawing, so that lines keep their numbers and their
    wobble.

    Parameters
    ----------
    context : Context, optional
        The threads and the log to use; None: the default context.

    Examples
    --------
    >>> marks = model.generate(preset="contour-and-stipple")
    >>> style = hrbfnpr.Style("contour-and-stipple")
    >>> drawing = hrbfnpr.Renderer().draw((marks, style), hrbfnpr.Camera.fit(marks))
    >>> image = drawing.image()
    """

    def __init__(self, *, context: Optional[Context] = None) -> None:
        context = resolve(context)
        out, error = ffi.new("hrbfnpr_renderer **"), new_error()
        check(lib.hrbfnpr_renderer_create(context._handle, out, error), error)
        super().__init__(own(out[0], lib.hrbfnpr_renderer_release, context))
        self._context = context
        self._context_handle = context._handle  # works even after the context is closed
        self._lock = threading.RLock()

    def draw(
        self,
        items: Items,
        camera: Camera,
        *,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Drawing:
        """Draw items with a camera.

        Parameters
        ----------
        items : PointSet, (PointSet, Style), Item, or an iterable of these
            What to draw.  All styles must have the same paper and visibility.
        camera : Camera
            The camera, with a viewport.
        progress, operation
            As in `Model.fit`.  Use them for drawings that take long: lines of a fine surface, or millions of marks.

        Returns
        -------
        Drawing
            A value that never changes.  Any thread may make pixels or vertices from it at any time.

        Raises
        ------
        InvalidArgumentError
            If the camera has no viewport, a transform is singular, styles differ in paper or visibility, or lines need
            curvatures that their line set does not have.
        CallbackError
            If a tone function, or the function of an item's model, raised an exception.
        CancelledError
            After a cancel.  The renderer can be used again.
        OutOfMemoryError
        """
        chosen = as_items(items)
        structs, keep, states, functions = prepared(chosen)
        layers = [item.point_set.layers for item in chosen]
        out, error = ffi.new("hrbfnpr_drawing **"), new_error()
        with running(operation, progress, self._context_handle) as (handle, state), self._lock:
            status = lib.hrbfnpr_renderer_draw_with_operation(
                self._handle, structs, len(chosen), 0, camera._struct, handle, out, error
            )
            states.append(state)
        drawn = own(out[0], lib.hrbfnpr_drawing_release, self._context) if out[0] != ffi.NULL else None
        del keep
        raised = next((function for function in functions if function.exception is not None), None)
        check(status, error, *states, shared=raised)
        return Drawing(drawn, camera.size, layers)
