# SPDX-License-Identifier: MIT
"""Where the surface of a model ends."""
from __future__ import annotations

from typing import Any, Optional, TypeVar

from ._arrays import Array, block_in
from ._errors import new_struct
from ._function import FunctionState
from ._handles import Owner
from ._library import lib
from ._operation import Operation, Progress, make
from ._records import TrimInfo, get

Self = TypeVar("Self", bound="Trimming")


class Trimming(Owner):
    """The part of `Model` that ends surfaces."""

    _context: Any
    _function: Optional[FunctionState]

    def trim(
        self: Self,
        points: Optional[Array] = None,
        normals: Optional[Array] = None,
        *,
        limit: float = 1.5,
        hole: float = 0.05,
        closest: float = 0.0,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Self:
        """The same model with a surface that ends where its samples do.

        The surface of an open scan or a terrain goes on where the samples end, and a fit may grow sheets where no
        sample ever was.  Marks, line sets and rays of the new model end where those do; f, projections, curvatures and
        `contains` do not change.  A surface of which nothing is to be left out stays whole.

        Parameters
        ----------
        points, normals : array of float, shape (N, 3), optional
            The samples; by default the model's centres.  All points of a scan tell better where it ends.  Without
            normals those of the surface are taken.
        limit : float
            The surface ends where s(x) = 3 (|c|^2 - ln sum_j w_j) exceeds this, with q_j = (x - p_j) / (0.9 h_j),
            w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2 and c = sum_j w_j q_j / sum_j w_j; p_j: the 24 samples nearest
            to x, with normals n_j and the spacing h_j around them, m: the normal at x.  1.5 ends it some 0.7 spacings
            beyond the last samples, 3 some 0.9.
        hole : float
            Holes that nowhere are farther from the samples than so many diagonals stay closed.
        closest : float
            In diagonals: spacings are taken to be at least this, and no part that is farther than `hole` from all
            samples stays.  For many points of a mesh, of which 0.01 leaves out what is more than about 0.01
            diagonals off them.  0: the spacing is the samples' own, and only what they surely do not bear out
            (s >= 6 somewhere) goes by `hole`.
        progress, operation
            See `Operation`.

        Raises
        ------
        NotConvergedError
            If no part of the surface is near the samples, as of a single one.
        """
        desc = new_struct("hrbfnpr_trim_desc")
        keep = []
        if points is not None:
            keep.append(block_in("points", points).fill(desc.points))
        if normals is not None:
            keep.append(block_in("normals", normals).fill(desc.normals))
        desc.limit, desc.hole, desc.closest = limit, hole, closest
        made = make("model", lib.hrbfnpr_model_trim, (self._handle, desc), operation, progress, self._context, self._handle,
                    shared=self._function)  # fmt: skip
        del keep
        trimmed = type(self).__new__(type(self))
        Owner.__init__(trimmed, made)
        trimmed._context, trimmed._function = self._context, self._function
        return trimmed

    @property
    def trim_info(self) -> TrimInfo:
        """What `trim` left out."""
        return get(TrimInfo, lib.hrbfnpr_model_get_trim_info, self._handle)
