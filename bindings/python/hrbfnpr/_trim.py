# SPDX-License-Identifier: MIT
"""Trimming: where the surface of a model ends."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, TypeVar

from . import _records
from ._arrays import Array, block_in
from ._errors import new_struct
from ._function import FunctionState
from ._handles import Owner
from ._library import lib
from ._operation import Operation, Progress, make
from ._records import get

if TYPE_CHECKING:
    from ._records import TrimInfo

Self = TypeVar("Self", bound="Trimming")


class Trimming(Owner):
    """The part of `Model` that ends surfaces where their samples end."""

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
        """Make the same model with a surface that ends where its samples end.

        The surface of an open scan or a terrain goes on beyond its samples, and a fit may have sheets where there never was
        a sample.  Trimming leaves both out.  Marks, line sets and rays of the new model end there; f, projections,
        curvatures and `contains` do not change.  If nothing is to be left out, the surface stays whole.

        Parameters
        ----------
        points : array of float, shape (N, 3), optional
            The samples; None: the model's centres.  All points of a scan show better where it ends.
        normals : array of float, shape (N, 3), optional
            The normals of the points; None: those of the surface.
        limit : float
            The surface ends where s(x) exceeds this, 0.001 to 1000; see the notes.  Larger values end it later: 1.5 about
            0.7 spacings beyond the last samples, 3 about 0.9 spacings.
        hole : float
            Holes whose points are all within this distance of a sample are filled; in diagonals, 0 or more.
        closest : float
            Samples closer to each other than this are treated as this far apart; in diagonals, 0 to 1.  Use it for samples
            that are much denser than the surface is accurate, such as many points of a mesh: 0.01 leaves out whatever is
            more than about 0.01 diagonals off them, and every part that is somewhere farther than `hole` from all samples.
        progress, operation
            As in `fit`.

        Returns
        -------
        Model
            The trimmed model.  `trim_info` counts the parts that were left out.

        Raises
        ------
        InvalidArgumentError
            If the model is not a fit, and no points are given.
        NotConvergedError
            If no part of the surface is near the samples, or there is only one sample.

        Notes
        -----
        s(x) tells how badly the samples support the surface at x: s(x) = 3 (abs(c)^2 - ln sum_j w_j), with
        q_j = (x - p_j) / (0.9 h_j), w_j = exp(-abs(q_j)^2) ((1 + n_j . m) / 2)^2 and c = sum_j w_j q_j / sum_j w_j.  Here
        p_j are the 24 samples nearest to x, n_j their normals, h_j the spacing around them, and m the normal at x.  With
        `closest` 0, a part that does not reach the end of the search box is left out only if s is 6 or more somewhere in it.
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
        """What the last `trim` left out."""
        return get(_records.TrimInfo, lib.hrbfnpr_model_get_trim_info, self._handle)
