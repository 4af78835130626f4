# SPDX-License-Identifier: MIT
"""Lines of one view, and which parts of them are hidden.

Contours come from drawings of the model, which count the surfaces before each part.  Creases are the mesh's own edges:
whether they are hidden is asked by rays, as it is of all lines behind a cutting plane, where what is before it counts
for nothing.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .._camera import Camera
from .._line_set import LineSet
from .._line_style import LineStyle
from .._model import Model
from .._point_set import PointSet
from .._renderer import Item, Renderer
from .._style import LayerStyle, Style
from ..shapes._shape import Floats
from ._view_axes import Plane, View
from ._view_order import Curve
from ._view_sight import Sight

PIXEL = 0.1  # mm: lines are drawn to a twentieth of it
_MEET = 0.05  # mm: between parts of a line that follow each other
_ASKED = 0.5  # mm: between places of a line that rays are cast from ...
_HALVINGS = 4  # ... and where two of them differ
_OFF = 0.006  # of the diagonal: the fitted surface may be this far from an edge of the mesh
_OFF_CONTOUR = 5e-4  # the same of lines on the surface itself
_SMALLEST_CONTOUR = 4.0  # mm across: of models with sharp edges smaller ones are ripples of the fit
_SHORTEST_EDGE = 0.06  # of the diagonal, of edges with a free end
_NEAR_CREASE = 0.005  # of the diagonal: contours beside a crease are its rounding by the fit


@dataclass(frozen=True)
class Solid:
    """What is drawn: a model, its lines and edges, and where its middle is."""

    model: Model
    lines: LineSet
    creases: Sequence[Floats]
    smooth: Sequence[str]
    middle: Floats
    diagonal: float
    marks: PointSet


@dataclass
class _Line:
    """A line: places in the model, (n, 3), and in the view, (n, 2) in mm, and of each piece whether it is hidden."""

    places: Floats
    points: Floats
    hidden: Any

    def part(self, begin: int, end: int) -> "_Line":
        return _Line(self.places[begin : end + 1], self.points[begin : end + 1], self.hidden[begin:end])


def _camera(view: View, solid: Solid, scale: float) -> Camera:
    """Sees all of the model, the middle of the view in the middle of the picture."""
    reach = 1.1 * solid.diagonal
    size = max(16, 2 * round(reach * view.factor * scale / PIXEL / 2))
    camera = Camera.look_at(solid.middle + 2 * solid.diagonal * view.eye, solid.middle, view.up)
    height = size * PIXEL / (view.factor * scale)
    return camera.orthographic(height, (size, size), 0.01 * solid.diagonal, 4 * solid.diagonal)


def _line_styles(solid: Solid, plane: Optional[Plane]) -> List[LineStyle]:
    kinds: List[Tuple[str, Optional[str]]] = [("contour", None), ("border", None), ("crease", None)]
    kinds += [(kind, None) for kind in solid.smooth]
    if plane is not None:
        kinds.append(("section", plane.name))
    return [LineStyle(kind, name, width=1.0, hidden="shown", taper=0.0, shortest=0.0) for kind, name in kinds]


def _drawn(view: View, solid: Solid, scale: float, renderer: Renderer) -> Dict[str, List[_Line]]:
    """By kind, joined where parts follow each other."""
    camera = _camera(view, solid, scale)
    # Without halos and tapers, whose gaps would be taken for hidden parts.
    style = Style(layers=[LayerStyle(shown=False, contours=False)], lines=_line_styles(solid, view.plane),
                  halo_width=0.0, tone="none")  # fmt: skip
    drawing = renderer.draw(Item(solid.marks, style, line_set=solid.lines), camera)
    half = camera.size[0] / 2
    parts: Dict[str, List[_Line]] = {}
    kinds = [layer.kind for layer in drawing.layers]
    for stroke in drawing.polylines():
        points = PIXEL * (stroke["window"][:, :2].astype(float) - half)
        hidden = np.full(len(points) - 1, bool(stroke["hidden_layers"][0]))
        line = _Line(stroke["position"].astype(float), points, hidden)
        parts.setdefault(kinds[stroke["layer"][0]], []).append(line)
    return {kind: joined(lines) for kind, lines in parts.items()}


class _Ends:
    """Ends of lines, by where they are on the paper."""

    def __init__(self, lines: Sequence[_Line]) -> None:
        self._lines = lines
        self._left = set(range(len(lines)))
        self._cells: Dict[Tuple[int, int], List[Tuple[int, int]]] = {}
        for number, line in enumerate(lines):
            for end in (0, -1):
                self._cells.setdefault(self._cell(line.points[end]), []).append((number, end))

    @staticmethod
    def _cell(point: Floats) -> Tuple[int, int]:
        return int(np.floor(point[0] / _MEET)), int(np.floor(point[1] / _MEET))

    def take(self, number: int) -> Optional[_Line]:
        """A line, once."""
        if number not in self._left:
            return None
        self._left.remove(number)
        return self._lines[number]

    def next_at(self, point: Floats) -> Optional[_Line]:
        """The line with the nearest end, which it then begins with."""
        x, y = self._cell(point)
        near = [
            (float(np.linalg.norm(self._lines[number].points[end] - point)), number, end)
            for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1) for number, end in self._cells.get((i, j), ())
            if number in self._left
        ]  # fmt: skip
        away, number, end = min(near, default=(np.inf, 0, 0))
        if away > _MEET:
            return None
        line = self.take(number)
        assert line is not None
        return _reversed(line) if end else line


def joined(parts: Sequence[_Line]) -> List[_Line]:
    """Parts whose ends meet, as one; closed where its own ends do."""
    ends, found = _Ends(parts), []
    for number in sorted(range(len(parts)), key=lambda i: (-len(parts[i].points), *parts[i].points[0])):
        line = ends.take(number)
        if line is None:
            continue
        for turned in (False, True):  # onward, then from the other end
            line = _reversed(line) if turned else line
            while not _closes(line):
                part = ends.next_at(line.points[-1])
                if part is None:
                    break
                line = _appended(line, part)
        if _closes(line):
            line.points[-1], line.places[-1] = line.points[0], line.places[0]
        found.append(line)
    return found


def _closes(line: _Line) -> bool:
    return len(line.points) > 3 and float(np.linalg.norm(line.points[0] - line.points[-1])) < _MEET


def _reversed(line: _Line) -> _Line:
    return _Line(line.places[::-1].copy(), line.points[::-1].copy(), line.hidden[::-1])


def _appended(line: _Line, part: _Line) -> _Line:
    return _Line(
        np.concatenate((line.places, part.places[1:])), np.concatenate((line.points, part.points[1:])),
        np.concatenate((line.hidden, part.hidden)),
    )  # fmt: skip


def _to_ask(line: _Line) -> Floats:
    """Places of the line that are near enough to each other, as fractional numbers of its points."""
    along = np.concatenate(((0.0,), np.cumsum(np.linalg.norm(np.diff(line.points, axis=0), axis=1))))
    lengths = np.linspace(0.0, along[-1], max(2, int(np.ceil(along[-1] / _ASKED)) + 1))
    return np.interp(lengths, along, np.arange(len(along)))


def _places_at(line: _Line, at: Floats) -> Floats:
    number = np.arange(len(line.places))
    return np.stack([np.interp(at, number, column) for column in line.places.T], axis=1)


def _at(line: _Line, at: Floats) -> _Line:
    """The line at fractional numbers of its points."""
    number = np.arange(len(line.points))
    places, points = (
        np.stack([np.interp(at, number, column) for column in values.T], axis=1)
        for values in (line.places, line.points)
    )
    middle = np.minimum((at[:-1] + at[1:]) / 2, len(line.hidden) - 0.5)
    return _Line(places, points, np.asarray(line.hidden)[middle.astype(int)])


def _asked(lines: Sequence[_Line], sight: Sight, off: float) -> List[_Line]:
    """The lines with the parts that rays say are hidden; all are asked at a time, which costs much less."""
    if not lines:
        return []
    at = [_to_ask(line) for line in lines]
    owner = np.repeat(np.arange(len(lines)), [len(one) for one in at])
    places = np.concatenate([_places_at(line, one) for line, one in zip(lines, at)])
    hidden = sight.hides(places, off)
    change = np.flatnonzero((hidden[1:] != hidden[:-1]) & (owner[1:] == owner[:-1]))
    low, high = np.zeros(len(change)), np.ones(len(change))
    for _ in range(_HALVINGS if len(change) else 0):
        middle = (low + high) / 2
        between = places[change] + middle[:, None] * (places[change + 1] - places[change])
        as_low = sight.hides(between, off) == hidden[change]
        low, high = np.where(as_low, middle, low), np.where(as_low, high, middle)
    numbers = np.concatenate(at)
    cuts = numbers[change] + (low + high) / 2 * (numbers[change + 1] - numbers[change])
    first = np.searchsorted(owner, np.arange(len(lines)))
    return [_cut_at(line, cuts[owner[change] == i], bool(hidden[first[i]])) for i, line in enumerate(lines)]


def _cut_at(line: _Line, cuts: Floats, hidden: bool) -> _Line:
    """The line with points where it begins or ends to be hidden; whether it is at its beginning is told."""
    at = np.unique(np.concatenate((np.arange(len(line.points)), cuts)))
    made = _at(line, at)
    turns = np.searchsorted(np.sort(cuts), at[:-1], side="right")
    made.hidden = (turns % 2 == 1) != hidden
    return made


def _behind(line: _Line, plane: Plane) -> List[_Line]:
    """The parts behind a plane."""
    away = line.places @ plane.normal - plane.place
    inside = away <= 0
    cross = np.flatnonzero(inside[1:] != inside[:-1])
    at = cross + away[cross] / (away[cross] - away[cross + 1])
    whole = _at(line, np.unique(np.concatenate((np.arange(len(away)), at))))
    kept = whole.places @ plane.normal - plane.place <= 1e-9 * max(1.0, abs(plane.place))
    both = kept[1:] & kept[:-1]
    changes = np.flatnonzero(np.diff(np.concatenate(([0], both.astype(int), [0]))))
    return [whole.part(begin, end) for begin, end in zip(changes[0::2], changes[1::2])]


def edges_of(creases: Sequence[Floats], diagonal: float) -> List[Floats]:
    """Without short ones that end somewhere in a face: those are the facets of a rounded shape."""
    uses: Dict[bytes, int] = {}
    for line in creases:
        for end in (line[0], line[-1]):
            uses[end.tobytes()] = uses.get(end.tobytes(), 0) + 1
    return [
        line for line in creases
        if min(uses[line[0].tobytes()], uses[line[-1].tobytes()]) > 1
        or np.linalg.norm(np.diff(line, axis=0), axis=1).sum() > _SHORTEST_EDGE * diagonal
    ]  # fmt: skip


def _creases(view: View, solid: Solid, scale: float) -> List[_Line]:
    return [
        _Line(np.asarray(edge, dtype=float), scale * view.flat(edge, solid.middle), np.zeros(len(edge) - 1, dtype=bool))
        for edge in solid.creases
    ]


def _curve(line: _Line, **more: Any) -> Curve:
    return Curve(line.points, line.hidden, **more)


def curves(view: View, solid: Solid, scale: float, renderer: Renderer) -> Tuple[List[Curve], List[Floats]]:
    """All lines of a view, and of a section the outlines of what is cut."""
    found = _drawn(view, solid, scale, renderer)
    unit = scale * view.factor
    closed = [line.points / scale for line in found.get("section", []) if _closes(line)]
    sight = Sight(solid.model, view, solid.diagonal, solid.middle, closed)
    contours = found.get("contour", []) + found.get("border", []) + found.get("crease", [])
    smooth = [line for kind in solid.smooth for line in found.get(kind, [])]
    creases = _creases(view, solid, scale)
    plane, outlines = view.plane, []
    if plane is not None:
        outlines = [line.points for line in found.get("section", [])]
        contours, creases, smooth = (
            [part for line in lines for part in _behind(line, plane)] for lines in (contours, creases, smooth)
        )
        contours, smooth = _asked(contours, sight, _OFF_CONTOUR), _asked(smooth, sight, _OFF_CONTOUR)
    creases = _asked(creases, sight, _OFF)
    beside = max(0.35, _NEAR_CREASE * solid.diagonal * unit)
    made = [_curve(line, rank=1, reach=beside) for line in creases]
    if len(solid.creases):
        contours = [line for line in contours if np.linalg.norm(np.ptp(line.points, axis=0)) > _SMALLEST_CONTOUR]
    made += [_curve(line, rank=2) for line in contours]
    made += [_curve(line, rank=3, is_smooth=True, reach=0.8) for line in smooth]
    made += [Curve(line, np.zeros(len(line) - 1, dtype=bool), rank=0) for line in outlines]
    return made, outlines
