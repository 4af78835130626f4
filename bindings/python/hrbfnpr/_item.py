# SPDX-License-Identifier: MIT
"""Items: the things that a drawing shows."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from ._arrays import Array, block_in, matrix_in
from ._callbacks import CallbackState
from ._errors import new_list
from ._line_set import LineSet
from ._model import Model
from ._names import SIDES, number_of
from ._point_set import PointSet
from ._style import Style

if TYPE_CHECKING:
    from ._shading import Shading

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
    shading : Shading, optional
        How much light reaches the marks; None: all.  It must be None if there are poses.
    """

    point_set: PointSet
    style: Optional[Style] = None
    transform: Optional[Array] = None
    model: Optional[Model] = None
    poses: Optional[Poses] = None
    line_set: Optional[LineSet] = None
    sides: str = "front"
    shading: Optional[Shading] = None


def as_items(items: Items) -> List[Item]:
    if isinstance(items, Item):
        return [items]
    if isinstance(items, PointSet):
        return [Item(items)]
    if isinstance(items, tuple) and len(items) == 2 and isinstance(items[1], Style):
        return [Item(*items)]
    parts: Iterable[Any] = items
    return [one for part in parts for one in as_items(part)]


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


class Prepared(NamedTuple):
    """Structs for one call."""

    structs: Any
    keep: List[Any]  # what must be kept alive
    states: List[Optional[CallbackState]]  # the states of tone functions
    functions: List[CallbackState]  # the functions of the models


def prepared(items: Sequence[Item], shaded: bool = True) -> Prepared:
    """The structs of items.  Without `shaded`, shadings are left out: they may have been closed."""
    made = Prepared(new_list("hrbfnpr_item", len(items)), [], [], [])
    for item, struct in zip(items, made.structs):
        struct.sides = number_of("sides", SIDES, item.sides)
        struct.point_set = item.point_set._handle
        made.keep.append(struct.point_set)
        if item.style is not None:
            struct.style, state, kept = item.style._prepared()
            made.states.append(state)
            made.keep.append(kept)
        for name in ("model", "line_set", "shading"):
            part = getattr(item, name)
            if part is None or (name == "shading" and not shaded):
                continue
            setattr(struct, name, part._handle)
            made.keep.append(getattr(struct, name))
            if name != "shading" and part._function is not None:
                made.functions.append(part._function)
        if item.transform is not None:
            struct.transform = matrix_in("transform", item.transform)
        if item.poses:
            made.keep.append(_fill_poses(struct, item))
    return made
