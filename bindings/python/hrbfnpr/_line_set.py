# SPDX-License-Identifier: MIT
"""Line sets: what the contours and feature lines of a surface are drawn from."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterable, List, Optional, Sequence, Union

from ._arrays import Array, block_in, vector
from ._callbacks import check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._handles import Owner, own
from ._layer import c_name, new_list
from ._library import ffi, lib
from ._model import Model
from ._names import LINE_KINDS, number_of
from ._operation import Operation, Progress, running
from ._structs import read_struct


@dataclass
class Lines:
    """Lines that are found once, when a `LineSet` is made.

    Attributes
    ----------
    kind : {"ridge", "valley", "parabolic", "section", "own"}
    name : str
        For `LineStyle.name`.
    lower, upper : float
        A line goes on while its strength is at least `lower`, and is kept if it is `upper` somewhere;
        0 and 0 = those of the kind.
    shortest : float
        In diagonals of the model; shorter ones are dropped.
    plane : (float, float, float)
        Of sections: the normal of the planes.
    levels : sequence of float
        Of sections: where the planes are along the unit normal.
    polylines : sequence of array of float, shape (n, 3)
        Of own lines: on the surface or near it; closed if the last point is the first.
    """

    kind: str = "ridge"
    name: str = ""
    lower: float = 0.0
    upper: float = 0.0
    shortest: float = 0.01
    plane: Sequence[float] = (0.0, 0.0, 1.0)
    levels: Sequence[float] = ()
    polylines: Sequence[Array] = ()

    def _fill(self, target: Any) -> List[Any]:
        """Write a hrbfnpr_line_desc; returns what must be kept alive."""
        target.kind = number_of("kind", LINE_KINDS, self.kind)
        target.lower, target.upper, target.shortest = self.lower, self.upper, self.shortest
        target.plane = vector("plane", self.plane)
        keep = [c_name(target, self.name)]
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


@dataclass(frozen=True)
class LineSetInfo:
    """What making a line set did.

    Attributes
    ----------
    triangles : int
        Of the mesh that curves are looked for on.
    turned : int
        Triangles that look away from the surface: it is finer than the cells there, and curves may be missed.
    missed_seeds : int
        Seeds that no triangle is near: a part of the surface is too thin for the cells.
    lines, borders : int
        Lines that were found once; curves where the surface ends.
    cell_size, seconds : float
    bytes : int
    left_out : float
        The share of the area that was looked at that lies beyond its samples, 0 to 1; 0 without `support`. Of a trimmed
        model little beyond its end is looked at: see `Model.trim_info`.
    creases : int
        Curves where smooth sheets of the surface meet, from corner to corner, or closed.
    """

    triangles: int
    turned: int
    missed_seeds: int
    lines: int
    borders: int
    cell_size: float
    seconds: float
    bytes: int
    left_out: float
    creases: int


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
        desc, error = new_struct("hrbfnpr_line_set_desc"), new_error()
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
        out = ffi.new("hrbfnpr_line_set **")
        with running(operation, progress, context._handle) as (handle, state):
            status = lib.hrbfnpr_line_set_create(context._handle, model._handle, desc, handle, out, error)
            check(status, error, state, shared=model._function)
        del keep
        super().__init__(own(out[0], lib.hrbfnpr_line_set_release, context))
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
        info, error = new_struct("hrbfnpr_line_set_info"), new_error()
        check(lib.hrbfnpr_line_set_get_info(self._handle, info, error), error)
        return read_struct(LineSetInfo, info)

    @property
    def has_curvature(self) -> bool:
        """Whether suggestive contours, apparent ridges and isophotes can be drawn of it."""
        return self._curved
