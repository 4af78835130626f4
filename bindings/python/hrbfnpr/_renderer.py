# SPDX-License-Identifier: MIT
"""Makes drawings from point sets and a camera."""
from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Any, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from ._arrays import Array, block_in, matrix_in
from ._callbacks import CallbackState, check
from ._camera import Camera
from ._context import Context, resolve
from ._drawing import Drawing
from ._errors import new_error, new_list
from ._handles import Owner, own
from ._library import ffi, lib
from ._line_set import LineSet
from ._model import Model
from ._names import SIDES, number_of
from ._operation import Operation, Progress, running
from ._point_set import PointSet
from ._style import Style

Items = Union[PointSet, "Item", Tuple[PointSet, Style], Iterable[Any]]
Poses = Mapping[Union[int, str], Sequence[Array]]


@dataclass
class Item:
    """One thing to draw.

    Attributes
    ----------
    point_set : PointSet
        The marks to draw.
    style : Style, optional
        How they are drawn; None: the library's default style.
    transform : array of float, shape (4, 4), optional
        The matrix from the object to the world, affine and invertible; None: the identity.
    model : Model, optional
        The surface on which the marks lie.  With it, and the visibility "depth_layers", a ray from each mark to the eye
        finds what hides the mark.  This is exact, but slow.  It must be None if there are poses.
    poses : mapping of layer to arrays, optional
        New places for the marks of some layers, by number or name: (positions, normals) or (positions, normals,
        directions), of shape (n, 3) each, absolute, in the order of the layer's marks.
    line_set : LineSet, optional
        The lines to draw.  All items of a drawing that have one hide each other's lines.  It must be None if there are
        poses.
    sides : {"front", "both"}
        "front": marks are drawn on the side to which the normals point.  "both": also on the other side, for a surface that
        ends, such as a bowl or a leaf.  Where the other side faces the camera, marks have opposite normals and the same
        identities, and are in separate layers after all others.
    """

    point_set: PointSet
    style: Optional[Style] = None
    transform: Optional[Array] = None
    model: Optional[Model] = None
    poses: Optional[Poses] = None
    line_set: Optional[LineSet] = None
    sides: str = "front"


def _as_items(items: Items) -> List[Item]:
    if isinstance(items, Item):
        return [items]
    if isinstance(items, PointSet):
        return [Item(items)]
    if isinstance(items, tuple) and len(items) == 2 and isinstance(items[1], Style):
        return [Item(*items)]
    parts: Iterable[Any] = items
    return [one for part in parts for one in _as_items(part)]


def _fill_poses(struct: Any, item: Item) -> List[Any]:
    """Write the poses of an item.  The result must be kept alive."""
    poses = item.poses or {}
    structs = new_list("hrbfnpr_layer_pose", len(poses))
    keep = [structs]
    for (which, arrays), pose in zip(poses.items(), structs):
        pose.layer = item.point_set.layer(which).number if isinstance(which, str) else which
        if len(arrays) not in (2, 3):
            raise ValueError(f"the pose of layer {which!r} must be positions, normals and perhaps directions")
        for field, value in zip(("position", "normal", "direction"), arrays):
            keep.append(block_in(f"{field}s of the pose of layer {which!r}", value).fill(getattr(pose, field)))
    struct.poses, struct.pose_count = structs, len(poses)
    return keep


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
        chosen = _as_items(items)
        structs = new_list("hrbfnpr_item", len(chosen))
        keep: List[Any] = []
        states: List[Optional[CallbackState]] = []
        functions: List[CallbackState] = []  # the functions of the models
        for item, struct in zip(chosen, structs):
            struct.sides = number_of("sides", SIDES, item.sides)
            struct.point_set = item.point_set._handle
            keep.append(struct.point_set)
            if item.style is not None:
                struct.style, state, kept = item.style._prepared()
                states.append(state)
                keep.append(kept)
            if item.model is not None:
                struct.model = item.model._handle
                keep.append(struct.model)
                if item.model._function is not None:
                    functions.append(item.model._function)
            if item.line_set is not None:
                struct.line_set = item.line_set._handle
                keep.append(struct.line_set)
                if item.line_set._function is not None:
                    functions.append(item.line_set._function)
            if item.transform is not None:
                struct.transform = matrix_in("transform", item.transform)
            if item.poses:
                keep.append(_fill_poses(struct, item))
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
