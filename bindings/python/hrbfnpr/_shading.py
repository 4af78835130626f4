# SPDX-License-Identifier: MIT
"""Occlusion and cast shadows."""
from __future__ import annotations

from typing import Optional

from ._arrays import Array, wrap
from ._camera import Camera
from ._context import Context, resolve
from ._errors import check, new_error, new_struct
from ._handles import Owner
from ._item import Item, Items, as_items, prepared
from ._library import ffi, lib
from ._operation import Operation, Progress, make


class Occluders(Owner):
    """The surfaces that cast shadows and hide the sky: those of all items that have a line set, at their transforms.

    Walls thinner than a cell of the line set may let light through.  Occluders never change, and several threads may use
    them at the same time.

    Parameters
    ----------
    items : Item, or an iterable of these
        The items.
    progress, operation, context
        As in `Model.fit`.

    Raises
    ------
    InvalidArgumentError
        If no item has a line set.
    """

    def __init__(
        self, items: Items, *, progress: Optional[Progress] = None, operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> None:  # fmt: skip
        context = resolve(context)
        chosen = as_items(items)
        made = prepared(chosen, shaded=False)
        given = context._handle, made.structs, len(chosen), 0
        super().__init__(make("occluders", lib.hrbfnpr_occluders_create, given, operation, progress, context._handle, context))
        del made


class Shading(Owner):
    """How much of the sky and of each light with a shadow the marks of an item see.

    It holds for the item's point set, transform and lights, and for the occluders, and for any camera.  Only lights in the
    space of the camera move with it.

    Parameters
    ----------
    occluders : Occluders
        What casts shadows.
    item : Item
        The item; give the result as its `shading`.
    camera : Camera, optional
        The camera, for lights in its space that cast shadows.
    occlusion_reach : float
        Distance beyond which nothing hides the sky, in diagonals of the box around all occluders, 0 to 100.  0: no
        occlusion.
    lines : bool
        Whether the borders of shadows are found, too, for lines of the kinds "shadow" and "terminator".  The item then
        needs a `line_set`.
    sky_rays, shadow_rays : int
        Numbers of rays by which a mark sees the sky, and a light in whose penumbra it is; 1 to 4096.
    previous : Shading, optional
        A shading of the same item and occluders, but for other lights, whose occlusion and curvature are taken.  None: they
        are computed.
    curvature_scale : float
        Distance over which curvature is measured, in diagonals of the box around the item's surface, 0 to 1.  It is measured
        if the item's style has a `curvature_contrast`; the item then needs a line set.  0: it is not measured.
    progress, operation, context
        As in `Model.fit`.

    Raises
    ------
    InvalidArgumentError
        If a number is out of its range, the item has poses, it lacks a line set that is needed, or a light in the space of
        the camera casts shadows and there is no camera.

    Examples
    --------
    >>> style = hrbfnpr.Style("engraving", ambient_sky=0.4)
    >>> style.lights = [hrbfnpr.Light(place=(-1, 1, 1), space="world", intensity=0.8, shadow=1, softness=0.05)]
    >>> item = hrbfnpr.Item(marks, style, line_set=lines)
    >>> item.shading = hrbfnpr.Shading(hrbfnpr.Occluders(item), item)
    """

    def __init__(
        self, occluders: Occluders, item: Item, camera: Optional[Camera] = None, *, lines: bool = False,
        occlusion_reach: float = 0.35, sky_rays: int = 64, shadow_rays: int = 32, previous: Optional[Shading] = None,
        curvature_scale: float = 0.02, progress: Optional[Progress] = None, operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> None:  # fmt: skip
        context = resolve(context)
        made = prepared([item], shaded=False)
        desc = new_struct("hrbfnpr_shading_desc")
        desc.occlusion_reach, desc.sky_rays, desc.shadow_rays = occlusion_reach, sky_rays, shadow_rays
        desc.curvature_scale = curvature_scale
        desc.flags = lib.HRBFNPR_SHADING_WITH_LINES if lines else 0
        desc.previous = ffi.NULL if previous is None else previous._handle
        seen_from = ffi.NULL if camera is None else camera._struct
        given = context._handle, occluders._handle, made.structs, seen_from, desc
        super().__init__(make("shading", lib.hrbfnpr_shading_create, given, operation, progress, context._handle, context))
        del made

    def _seen(self, layer: int, light: int) -> Array:
        result, error = ffi.new("hrbfnpr_array *"), new_error()
        check(lib.hrbfnpr_shading_view(self._handle, layer, light, result, error), error)
        return wrap(result, self._handle)

    def openness(self, layer: int = 0) -> Array:
        """Return the shares of the sky that the marks of a layer see, float32 (n,), read-only, 0 to 1.

        Raises
        ------
        InvalidArgumentError
            If there is no such layer, or `occlusion_reach` was 0.
        """
        return self._seen(layer, -1)

    def visible(self, light: int = 0, layer: int = 0) -> Array:
        """Return the shares of a light that reach the marks of a layer past shadows, float32 (n,), read-only, 0 to 1.

        `light` is the number of the light among those of the style.

        Raises
        ------
        InvalidArgumentError
            If there is no such layer or light, or the light casts no shadow.
        """
        if light < 0:
            raise ValueError(f"light is {light}; it must be at least 0")
        return self._seen(layer, light)
