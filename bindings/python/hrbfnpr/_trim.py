# SPDX-License-Identifier: MIT
"""Where the surface of a model ends."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, TypeVar

from ._arrays import Array, block_in
from ._callbacks import check
from ._errors import new_error, new_struct
from ._function import FunctionState
from ._handles import Owner, own
from ._library import ffi, lib
from ._operation import Operation, Progress, running
from ._structs import read_struct

Self = TypeVar("Self", bound="Trimming")


@dataclass(frozen=True)
class TrimInfo:
    """What trimming left out.

    Attributes
    ----------
    is_trimmed : bool
        Whether the surface ends somewhere; if not, all else is 0 but `samples` and `spacing`.
    samples : int
        Samples that tell where; 0: the model was never trimmed.
    parts : int
        Connected parts of the surface that are left out.
    parts_to_end : int
        Of these, those that reach the end of the search box: the samples are open there.
    share : float
        Of the surface's area in the box that is left out, 0 to 1, within some percent.
    farthest : float
        Of the places left out from the samples, in units of the model.
    spacing : float
        Of the samples: the median of how far their sixth neighbours are.
    """

    is_trimmed: bool
    samples: int
    parts: int
    parts_to_end: int
    share: float
    farthest: float
    spacing: float


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
        out, error = ffi.new("hrbfnpr_model **"), new_error()
        with running(operation, progress, self._context) as (handle, state):
            status = lib.hrbfnpr_model_trim(self._handle, desc, handle, out, error)
            check(status, error, state, shared=self._function)
        del keep
        trimmed = type(self).__new__(type(self))
        Owner.__init__(trimmed, own(out[0], lib.hrbfnpr_model_release, self._handle))
        trimmed._context, trimmed._function = self._context, self._function
        return trimmed

    @property
    def trim_info(self) -> TrimInfo:
        """What `trim` left out."""
        info, error = new_struct("hrbfnpr_trim_info"), new_error()
        check(lib.hrbfnpr_model_get_trim_info(self._handle, info, error), error)
        return read_struct(TrimInfo, info, {"is_trimmed": bool})
