# SPDX-License-Identifier: MIT
"""Layers of a point set: read-only arrays of their marks."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from ._arrays import Array, wrap
from ._callbacks import check
from ._errors import new_error, new_struct
from ._library import ffi, lib
from ._numpy import np
from ._point_set_info import LayerInfo, PlacementInfo, read_layer_info
from ._structs import read_struct


class MarkLayer:
    """A layer of a point set.

    Its attributes are read-only arrays on the set's own memory: nothing is copied, and they stay valid
    after the set is gone.
    """

    def __init__(self, handle: Any, number: int) -> None:
        self._handle = handle
        self._number = number
        self._info: Optional[LayerInfo] = None

    @property
    def number(self) -> int:
        """Its place in the set, from 0."""
        return self._number

    @property
    def info(self) -> LayerInfo:
        """What making it did."""
        if self._info is None:
            info, error = new_struct("hrbfnpr_layer_info"), new_error()
            check(lib.hrbfnpr_point_set_get_layer_info(self._handle, self._number, info, error), error)
            self._info = read_layer_info(info)
        return self._info

    @property
    def placement(self) -> Tuple[PlacementInfo, ...]:
        """What became of candidates for marks, level by level."""
        info, error = new_struct("hrbfnpr_placement_info"), new_error()
        result = []
        for level in range(self.info.levels + 1):
            check(lib.hrbfnpr_point_set_get_placement(self._handle, self._number, level, info, error), error)
            result.append(read_struct(PlacementInfo, info))
        return tuple(result)

    @property
    def kind(self) -> str:
        """"stipples", "principal", "combing", "field" or "own"."""
        return self.info.kind

    @property
    def name(self) -> str:
        """As it was given, or its kind."""
        return self.info.name

    def __len__(self) -> int:
        return self.info.marks

    def _view(self, attribute: str) -> Array:
        view, error = ffi.new("hrbfnpr_array *"), new_error()
        constant = ffi.integer_const(f"HRBFNPR_MARK_ATTRIBUTE_{attribute}")
        check(lib.hrbfnpr_point_set_view(self._handle, self._number, constant, view, error), error)
        return wrap(view, self._handle)

    @property
    def positions(self) -> Array:
        """float32 (n, 3), relative to the set's `origin`."""
        return self._view("POSITION")

    @property
    def normals(self) -> Array:
        """float32 (n, 3), unit, outward."""
        return self._view("NORMAL")

    @property
    def directions(self) -> Array:
        """float32 (n, 3), unit, tangent: along the stroke; for a mark of none the u of its basis [NPAR 5.2]."""
        return self._view("DIRECTION")

    @property
    def curvatures(self) -> Array:
        """float32 (n, 3): k1, k2, confidence; empty where not known (see `Layer.with_curvature`)."""
        return self._view("CURVATURE")

    @property
    def ranks(self) -> Array:
        """float32 (n,): the u of [NPAR 6.2] in [0, 1); a mark is shown where u >= tau."""
        return self._view("RANK")

    @property
    def levels(self) -> Array:
        """uint8 (n,): the refinement step, or the pass of strokes, that placed the mark."""
        return self._view("LEVEL")

    @property
    def stroke_places(self) -> Array:
        """uint32 (n, 2): 2 number + direction (0 or 1) of the stroke, and the mark's place along it.

        For a mark of no stroke twice its number (or that of its seed), and 0.
        """
        return self._view("STROKE")

    @property
    def widths(self) -> Array:
        """float32 (n,): of the ink, relative, in (0, 1]; of tapered strokes only, else empty: all 1."""
        return self._view("WIDTH")

    @property
    def tone_normals(self) -> Array:
        """float32 (n, 3), unit: the normals that tone goes by (see `Layer.tone_smoothing`); empty: `normals`."""
        return self._view("TONE_NORMAL")

    @property
    def stroke_first(self) -> Array:
        """uint32 (s + 1,): stroke s has the marks from stroke_first[s] up to stroke_first[s + 1] - 1, in the
        order of `stroke_order` if that is not empty.  Empty: a layer without strokes."""
        return self._view("STROKE_FIRST")

    @property
    def stroke_order(self) -> Array:
        """uint32 (n,): numbers of marks, stroke by stroke; empty where they stand so already."""
        return self._view("STROKE_ORDER")

    def strokes(self) -> List[Array]:
        """The numbers of the marks of each stroke, from end to end; without NumPy, ranges or memoryviews."""
        first, order = self.stroke_first, self.stroke_order
        numbers = order if len(order) else range(len(self)) if np is None else np.arange(len(self), dtype="I")
        return [numbers[first[i] : first[i + 1]] for i in range(len(first) - 1)]

    def __repr__(self) -> str:
        info = self.info
        return f"<hrbfnpr.MarkLayer {info.name!r}, {info.marks} marks, {info.strokes} strokes>"
