# SPDX-License-Identifier: MIT
"""Layers of a point set: read-only arrays of their marks."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from ._arrays import Array, view
from ._library import lib
from ._numpy import np
from ._records import LayerInfo, PlacementInfo, get


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
            self._info = get(LayerInfo, lib.hrbfnpr_point_set_get_layer_info, self._handle, self._number)
        return self._info

    @property
    def placement(self) -> Tuple[PlacementInfo, ...]:
        """What became of candidates for marks, level by level."""
        asked = lib.hrbfnpr_point_set_get_placement, self._handle, self._number
        return tuple(get(PlacementInfo, *asked, level) for level in range(self.info.levels + 1))

    @property
    def kind(self) -> str:
        """"stipples", "hatch" or "own"."""
        return self.info.kind

    @property
    def name(self) -> str:
        """As it was given, or its kind."""
        return self.info.name

    def __len__(self) -> int:
        return self.info.marks

    @property
    def _view(self) -> Tuple[Any, ...]:
        return lib.hrbfnpr_point_set_view, self._handle, self._number

    positions = view("MARK", "POSITION", "float32 (n, 3), relative to the set's `origin`.")
    normals = view("MARK", "NORMAL", "float32 (n, 3), unit, outward.")
    directions = view("MARK", "DIRECTION", "float32 (n, 3), unit, tangent: along the stroke; for a mark of none the u of its "
                      "basis [NPAR 5.2].")  # fmt: skip
    curvatures = view("MARK", "CURVATURE", "float32 (n, 3): k1, k2, confidence; empty where not known (see "
                      "`Layer.with_curvature`).")  # fmt: skip
    ranks = view("MARK", "RANK", "float32 (n,): the u of [NPAR 6.2] in [0, 1); a mark is shown where u >= tau.")
    levels = view("MARK", "LEVEL", "uint8 (n,): the refinement step, or the pass of strokes, that placed the mark.")
    stroke_places = view("MARK", "STROKE", "uint32 (n, 2): 2 number + direction (0 or 1) of the stroke, and the mark's place "
                         "along it.\n\nFor a mark of no stroke twice its number (or that of its seed), and 0.")  # fmt: skip
    widths = view("MARK", "WIDTH", "float32 (n,): of the ink, relative, in (0, 1]; of tapered strokes only, else empty: all 1.")
    tone_normals = view("MARK", "TONE_NORMAL", "float32 (n, 3), unit: the normals that tone goes by (see "
                        "`Layer.tone_smoothing`); empty: `normals`.")  # fmt: skip
    stroke_first = view("MARK", "STROKE_FIRST", "uint32 (s + 1,): stroke s has the marks from stroke_first[s] up to "
                        "stroke_first[s + 1] - 1, in the order of `stroke_order` if that is not empty.  Empty: a layer "
                        "without strokes.")  # fmt: skip
    stroke_order = view("MARK", "STROKE_ORDER", "uint32 (n,): numbers of marks, stroke by stroke; empty where they stand so "
                        "already.")  # fmt: skip

    def strokes(self) -> List[Array]:
        """The numbers of the marks of each stroke, from end to end; without NumPy, ranges or memoryviews."""
        first, order = self.stroke_first, self.stroke_order
        numbers = order if len(order) else range(len(self)) if np is None else np.arange(len(self), dtype="I")
        return [numbers[first[i] : first[i + 1]] for i in range(len(first) - 1)]

    def __repr__(self) -> str:
        info = self.info
        return f"<hrbfnpr.MarkLayer {info.name!r}, {info.marks} marks, {info.strokes} strokes>"
