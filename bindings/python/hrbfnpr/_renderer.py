# SPDX-License-Identifier: MIT
"""From point sets and a camera to a drawing."""
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
    style : Style, optional
        The library's default style if None.
    transform : array of float, shape (4, 4), optional
        Object to world, affine, invertible; the identity if None.
    model : Model, optional
        The surface that the marks lie on.  With the visibility "depth_layers", what hides a mark is then
        found by casting a ray from it to the eye: exact, but some 10 microseconds a mark drawn.
    poses : mapping of layer to arrays, optional
        Where the marks of some layers, by number or name, have moved: (positions, normals) or (positions,
        normals, directions), of shape (n, 3) each, absolute, in the order of the layer's marks.
    line_set : LineSet, optional
        What the style's lines are drawn from.  All items of a drawing that have one hide each other's lines.
    sides : {"front", "both"}
        "both" draws the marks on the inside of a surface that ends, such as a bowl or a leaf, too, where it looks to
        the camera: with opposite normals for tone, the same ids, and in layers of their own behind all others.
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
    """What must be kept alive."""
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

    It keeps its scratch memory, and that of drawings that nobody holds any more, from one drawing to the
    next.  Calls from several threads wait for each other: give each thread a renderer of its own.

    Parameters
    ----------
    context : Context, optional
        The default context if omitted.

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
        self._context_handle = context._handle  # works where the context was closed meanwhile, too
        self._lock = threading.RLock()

    def draw(
        self,
        items: Items,
        camera: Camera,
        *,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Drawing:
        """Classify, shade and order the marks for one camera.

        Parameters
        ----------
        items : PointSet, (PointSet, Style), Item, or an iterable of these
        camera : Camera
        progress, operation
            As in `Model.fit`: for frames that take long, as with lines of a fine surface or millions of marks.

        Returns
        -------
        Drawing
            A value: pixels, vertices and more can be had of it, at any time and on any thread.

        Raises
        ------
        CancelledError
            After a cancel; the renderer can go on.
        InvalidArgumentError
            For a camera without a viewport, a singular transform, or styles of different paper or
            visibility.
        CallbackError
            If a tone function or the function of an item's model raised.
        """
        chosen = _as_items(items)
        structs = new_list("hrbfnpr_item", len(chosen))
        keep: List[Any] = []
        states: List[Optional[CallbackState]] = []
        functions: List[CallbackState] = []  # of the models
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
