# SPDX-License-Identifier: MIT
"""Line sets: what the contours and feature lines of a surface are drawn from."""
from __future__ import annotations

from typing import Any, Iterable, List, Optional, Union

from ._arrays import Array, block_in, vector
from ._context import Context, resolve
from ._errors import new_list, new_struct
from ._handles import Owner
from ._library import lib
from ._model import Model
from ._operation import Operation, Progress, make
from ._records import LineSetInfo, LinesFields, fill, get


class Lines(LinesFields):
    __doc__ = LinesFields.__doc__

    def _fill(self, target: Any) -> List[Any]:
        """Write a hrbfnpr_line_desc; returns what must be kept alive."""
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
    """What the lines of a model's surface are drawn from, whatever the camera; see `Item.line_set`.

    Parameters
    ----------
    model : Model
    lines : Lines, kind, or an iterable of these, optional
        Lines to find once: ridges, valleys, parabolic lines, sections, own ones.
    with_curvature : bool
        Measure curvatures and their derivatives: for suggestive contours, apparent ridges and isophotes.
    cell_size : float
        Of the mesh that curves are looked for on; 0 = half the samples' spacing, and finer where walls are thin.
    seed_points : array of float, shape (n, 3), optional
        Near each part of the surface; the model's samples if omitted.
    support : float
        Where the surface ends for want of samples, as an open scan or a terrain does, with a line of the kind
        "border": 1.5 ends it some 0.7 spacings beyond the last samples, 3 some 0.9; 0 = at the search box only.
    support_points, support_normals : array of float, shape (n, 3), optional
        The samples that this is judged by; the centres of the model if omitted. All points of a scan tell better
        where it ends. Normals may be of any length; those of the surface at the points if omitted.
    progress, operation, context
        As in `Model.fit`.

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
        """One that the library made for a picture."""
        made = cls.__new__(cls)
        Owner.__init__(made, handle)
        made._function, made._curved = model._function, curved
        return made

    @property
    def info(self) -> LineSetInfo:
        """What making it did."""
        return get(LineSetInfo, lib.hrbfnpr_line_set_get_info, self._handle)

    @property
    def has_curvature(self) -> bool:
        """Whether suggestive contours, apparent ridges and isophotes can be drawn of it."""
        return self._curved
