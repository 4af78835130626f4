# SPDX-License-Identifier: MIT
"""The layers of a point set, as read-only arrays of marks."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Tuple

from . import _records
from ._arrays import Array, view, wrap
from ._callbacks import check
from ._errors import new_error
from ._library import ffi, lib
from ._numpy import np
from ._records import get
from ._surface_field import FieldValues

if TYPE_CHECKING:
    from ._records import LayerInfo, PlacementInfo


class MarkLayer:
    """A layer of a point set.

    Its arrays are read-only views of the set's memory, without a copy.  They stay valid when the set is closed.
    """

    def __init__(self, handle: Any, number: int) -> None:
        self._handle = handle
        self._number = number
        self._info: Optional[LayerInfo] = None

    @property
    def number(self) -> int:
        """The number of the layer in the set, from 0."""
        return self._number

    @property
    def info(self) -> LayerInfo:
        """What the layer holds, and how long it took."""
        if self._info is None:
            self._info = get(_records.LayerInfo, lib.hrbfnpr_point_set_get_layer_info, self._handle, self._number)
        return self._info

    @property
    def placement(self) -> Tuple[PlacementInfo, ...]:
        """What became of the candidates for marks, for each level."""
        asked = lib.hrbfnpr_point_set_get_placement, self._handle, self._number
        return tuple(get(_records.PlacementInfo, *asked, level) for level in range(self.info.levels + 1))

    @property
    def kind(self) -> str:
        """The kind of the layer: "stipples", "hatch" or "own"."""
        return self.info.kind

    @property
    def name(self) -> str:
        """The name of the layer, as given or that of its kind."""
        return self.info.name

    def __len__(self) -> int:
        return self.info.marks

    def field(self, name: str) -> FieldValues:
        """Return what a field gives at the marks: read-only `values`, float32 (n,) or (n, 3), and `weights` (n,).

        `values` is empty if the layer has none, and `weights` if all are 1.

        Raises
        ------
        InvalidArgumentError
            If no layer of the set has a field of this name.
        """
        values, weights, error = ffi.new("hrbfnpr_array *"), ffi.new("hrbfnpr_array *"), new_error()
        given = self._handle, self._number, name.encode(), values, weights, error
        check(lib.hrbfnpr_point_set_view_field(*given), error)
        return FieldValues(wrap(values, self._handle), wrap(weights, self._handle))

    @property
    def _view(self) -> Tuple[Any, ...]:
        return lib.hrbfnpr_point_set_view, self._handle, self._number

    positions = view("MARK", "POSITION", "The places, float32 (n, 3), relative to the set's `origin`.")
    normals = view("MARK", "NORMAL", "The normals, float32 (n, 3), unit, outward.")
    directions = view("MARK", "DIRECTION", "The directions along the strokes, float32 (n, 3), unit, tangent.  For a mark "
                      "without a stroke: the u of its basis [NPAR 5.2].")  # fmt: skip
    curvatures = view("MARK", "CURVATURE", "k1, k2 and confidence, float32 (n, 3); empty if not known (see "
                      "`Layer.with_curvature`).")  # fmt: skip
    ranks = view("MARK", "RANK", "The ranks u of [NPAR 6.2], float32 (n,), in [0, 1).  A mark is shown where u >= tone.")
    levels = view("MARK", "LEVEL", "The refinement steps that placed the marks, or the levels of their lines, uint8 (n,).")
    stroke_places = view("MARK", "STROKE", "2 * number + direction (0 or 1) of the stroke, and the mark's place along it, uint32 "
                         "(n, 2).\n\nFor a mark without a stroke: 2 * its number (or that of its seed), and 0.")  # fmt: skip
    widths = view("MARK", "WIDTH", "The widths of the ink as factors of the style's radius, float32 (n,), in (0, 1].  Empty: all 1.")
    tone_normals = view("MARK", "TONE_NORMAL", "The normals that set the tone, float32 (n, 3), unit (see "
                        "`Layer.tone_smoothing`).  Empty: `normals`.")  # fmt: skip
    stroke_first = view("MARK", "STROKE_FIRST", "Where the strokes begin, uint32 (s + 1,): stroke s has the marks "
                        "stroke_first[s] to stroke_first[s + 1] - 1, in the order of `stroke_order` if that is not empty.  "
                        "Empty: a layer without strokes.")  # fmt: skip
    stroke_order = view("MARK", "STROKE_ORDER", "The numbers of marks, stroke by stroke, uint32 (n,).  Empty: the marks "
                        "themselves are in this order.")  # fmt: skip

    def strokes(self) -> List[Array]:
        """Return the numbers of the marks of each stroke, from end to end; without NumPy, as ranges or memoryviews."""
        first, order = self.stroke_first, self.stroke_order
        numbers = order if len(order) else range(len(self)) if np is None else np.arange(len(self), dtype="I")
        return [numbers[first[i] : first[i + 1]] for i in range(len(first) - 1)]

    def __repr__(self) -> str:
        info = self.info
        return f"<hrbfnpr.MarkLayer {info.name!r}, {info.marks} marks, {info.strokes} strokes>"
