# SPDX-License-Identifier: MIT
"""Line sets, from which the contours and feature lines of a surface are drawn."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Union

from . import _records
from ._arrays import Array, block_in, vector
from ._context import Context, resolve
from ._errors import new_list, new_struct
from ._handles import Owner
from ._library import lib
from ._model import Model
from ._operation import Operation, Progress, make
from ._records import LinesFields, fill, get

if TYPE_CHECKING:
    from ._mesh import Mesh
    from ._records import LineSetInfo


class Lines(LinesFields):
    __doc__ = LinesFields.__doc__

    def _fill(self, target: Any) -> List[Any]:
        """Write a hrbfnpr_line_desc.  The result must be kept alive with it."""
        keep: List[Any] = []
        fill(target, self, keep)
        target.plane = vector("plane", self.plane)
        if len(self.levels):
            keep.append(block_in("levels", self.levels, 1, "d").fill(target.levels))
        if len(self.polylines):
            rows = [list(map(list, line)) for line in self.polylines]
            first = [0]
            for line in rows:
                first.append(first[-1] + len(line))
            keep.append(block_in("polylines", [point for line in rows for point in line]).fill(target.position))
            keep.append(block_in("line_first", first, 1, "I").fill(target.line_first))
        return keep


class LineSet(Owner):
    """The data from which the lines of a model's surface are drawn, for every camera.

    An `Item` with a line set, and a style with `lines`, is drawn with contours and feature lines as curves.  A line set is
    made once for a model.  It never changes, and several threads may use it at the same time.

    Parameters
    ----------
    model : Model
        The model whose surface is drawn.
    lines : Lines, kind, or an iterable of these, optional
        Lines to find once: ridges, valleys, parabolic lines, sections, soft edges and lines of your own.
    with_curvature : bool
        True: measure curvatures and their derivatives, which suggestive contours, apparent ridges and isophotes need.
    cell_size : float
        Size of the cells in which curves are looked for, in the model's unit; 0 = half the spacing of the samples, and
        smaller where walls are thin.  Smaller cells find smaller details, in more time.
    seed_points : array of float, shape (n, 3), optional
        Points near each part of the surface, where the search begins; None: the model's samples.
    support : float
        Where the surface ends because samples are missing, as for an open scan or a terrain.  1.5 ends it about 0.7
        spacings beyond the last samples, 3 about 0.9 spacings; the end is a line of the kind "border".  0 (default): the
        surface ends where its model ends.
    support_points : array of float, shape (n, 3), optional
        The samples for `support`; None: the centres of the model.  All points of a scan show better where it ends.
    support_normals : array of float, shape (n, 3), optional
        Normals of `support_points`, of any length except 0; None: the normals of the surface there.
    mesh : Mesh, optional
        The mesh that the model was fitted to.  Its triangles find lines where walls are thinner than cells.  Ignored with a
        `cell_size`, and if it has edges that are not manifold or whose faces do not agree.
    progress, operation, context
        As in `Model.fit`.

    Raises
    ------
    InvalidArgumentError
        If a parameter is out of its range, the mesh would have more than 4 000 000 triangles (give a larger
        `cell_size`), or `support` has no samples.
    NotConvergedError
        If no surface is found, or none near the samples.
    OutOfMemoryError, CancelledError

    Examples
    --------
    >>> lines = hrbfnpr.LineSet(model, ["ridge", hrbfnpr.Lines("section", levels=[0.1, 0.2])], with_curvature=True)
    >>> style = hrbfnpr.Style("contour-and-stipple")
    >>> style.lines = ["contour", "suggestive_contour", hrbfnpr.LineStyle("section", hidden="dashed", width=1)]
    >>> drawing = hrbfnpr.Renderer().draw(hrbfnpr.Item(marks, style, line_set=lines), camera)
    """

    def __init__(
        self,
        model: Model,
        lines: Union[str, Lines, Iterable[Union[str, Lines]]] = (),
        *,
        with_curvature: bool = False,
        cell_size: float = 0.0,
        seed_points: Optional[Array] = None,
        support: float = 0.0,
        support_points: Optional[Array] = None,
        support_normals: Optional[Array] = None,
        mesh: Optional[Mesh] = None,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> None:
        context = resolve(context)
        chosen = [lines] if isinstance(lines, (str, Lines)) else list(lines)
        made = [Lines(line) if isinstance(line, str) else line for line in chosen]
        desc = new_struct("hrbfnpr_line_set_desc")
        structs = new_list("hrbfnpr_line_desc", len(made))
        keep: List[Any] = [structs, *(line._fill(structs[i]) for i, line in enumerate(made))]
        desc.lines, desc.line_count = structs, len(made)
        desc.cell_size = cell_size
        desc.flags = lib.HRBFNPR_LINE_SET_WITH_CURVATURE if with_curvature else 0
        desc.support = support
        if mesh is not None:
            desc.mesh = mesh._handle
        for name, points in (
            ("seed_points", seed_points), ("support_points", support_points), ("support_normals", support_normals)
        ):  # fmt: skip
            if points is not None:
                keep.append(block_in(name, points).fill(getattr(desc, name)))
        given = context._handle, model._handle, desc
        super().__init__(make("line_set", lib.hrbfnpr_line_set_create, given, operation, progress, context._handle, context,
                              shared=model._function))  # fmt: skip
        del keep
        self._function = model._function
        self._curved = with_curvature or any(line.kind in ("ridge", "valley", "parabolic") for line in made)

    @classmethod
    def _of(cls, handle: Any, model: Model, curved: bool) -> LineSet:
        """A line set that the library made for a picture."""
        made = cls.__new__(cls)
        Owner.__init__(made, handle)
        made._function, made._curved = model._function, curved
        return made

    @property
    def info(self) -> LineSetInfo:
        """What making the line set found and did."""
        return get(_records.LineSetInfo, lib.hrbfnpr_line_set_get_info, self._handle)

    @property
    def has_curvature(self) -> bool:
        """Whether suggestive contours, apparent ridges and isophotes can be drawn from this line set."""
        return self._curved
