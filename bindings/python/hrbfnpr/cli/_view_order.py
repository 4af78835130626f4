# SPDX-License-Identifier: MIT
"""Lines of a view that coincide: one of them is drawn, visible ones before hidden ones before thin ones [ISO 128-2].

Views along planes of symmetry and flat faces have a line behind nearly every line.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..shapes._shape import Floats

VISIBLE, HIDDEN, SMOOTH = "outlines", "hidden", "smooth"
STEP = 0.15  # mm, of places that are compared
_SHORTEST_REST = 0.5  # mm of what is left between other lines
_JOINING = 5.0  # mm beside another line before they meet, at most
_BRIDGED, _STRAIGHT = 2.0, 0.99  # mm of a gap, and cosine of directions, that are as of one line
_ALIKE = math.sin(math.radians(25.0))  # of directions that count as one
_FLICKER = 2.0  # mm: parts that are hidden, or not, for less than this are as what is before and behind them
_ONWARD = 0.7  # of the length: how far such a part gets
_SHORTEST = {VISIBLE: 0.8, HIDDEN: 1.2, SMOOTH: 3.0}  # mm of what is drawn


@dataclass
class Curve:
    """A line on the paper, (n, 2) in mm from the view's centre.

    Attributes
    ----------
    hidden : array of bool, shape (n - 1,)
        Of each piece.
    rank : int
        Curves of lower rank come first.
    reach : float
        Others of the same kind that are nearer than this, and as good as parallel, are left out.
    """

    points: Floats
    hidden: Any
    rank: int = 1
    reach: float = 0.35
    is_smooth: bool = False

    @property
    def along(self) -> Floats:
        steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        return np.concatenate(((0.0,), np.cumsum(steps)))


class _Place(NamedTuple):
    x: float
    y: float
    dx: float
    dy: float
    along: float
    curve: int
    around: float  # length of a closed curve, else 0
    reach: float


def _apart(a: float, b: float, around: float) -> float:
    """Along a curve."""
    return min(abs(a - b), around - abs(a - b)) if around > 0 else abs(a - b)


class _Drawn:
    """Places of lines that are drawn, by cells of the paper."""

    def __init__(self, cell: float) -> None:
        self._cell = cell
        self._places: Dict[Tuple[int, int], List[_Place]] = {}

    def _near(self, x: float, y: float) -> Iterator[_Place]:
        column, row = math.floor(x / self._cell), math.floor(y / self._cell)
        for i in (column - 1, column, column + 1):
            for j in (row - 1, row, row + 1):
                yield from self._places.get((i, j), ())

    def has(self, new: _Place) -> bool:
        """Whether a line is there, other than what the curve itself has just drawn."""
        for old in self._near(new.x, new.y):
            reach = max(old.reach, new.reach)
            if (old.x - new.x) ** 2 + (old.y - new.y) ** 2 >= reach * reach:
                continue
            if old.curve == new.curve and _apart(old.along, new.along, new.around) < 4 * reach:
                continue
            if abs(old.dx * new.dy - old.dy * new.dx) < _ALIKE:
                return True
        return False

    def add(self, place: _Place) -> None:
        key = math.floor(place.x / self._cell), math.floor(place.y / self._cell)
        self._places.setdefault(key, []).append(place)


def _runs(flags: Any) -> List[Tuple[int, int, bool]]:
    """Begin, end and value of equal ones that follow each other."""
    flags = np.asarray(flags, dtype=bool)
    ends = [*(np.flatnonzero(flags[1:] != flags[:-1]) + 1), len(flags)]
    return [(begin, end, bool(flags[begin])) for begin, end in zip([0, *ends[:-1]], ends)]


def steady(curve: Curve) -> Any:
    """`hidden` without parts that are too short to be seen."""
    hidden, along = np.array(curve.hidden, dtype=bool), curve.along
    runs = _runs(hidden)
    goes_round = np.array_equal(curve.points[0], curve.points[-1]) and hidden[0] != hidden[-1]
    for begin, end, value in runs if goes_round else runs[1:-1]:
        length = along[end] - along[begin]
        # What turns back, at a cusp, goes on as another line does.
        if length < _FLICKER and np.linalg.norm(curve.points[end] - curve.points[begin]) > _ONWARD * length:
            hidden[begin:end] = not value
    return hidden


def _part(curve: Curve, along: Floats, begin: float, end: float) -> Floats:
    """Of the curve, from one length to another."""
    inside = (along > begin + 1e-9) & (along < end - 1e-9)
    ends = [[np.interp(at, along, curve.points[:, axis]) for axis in (0, 1)] for at in (begin, end)]
    return np.concatenate((ends[:1], curve.points[inside], ends[1:]))


def _kept(curve: Curve, number: int, begin: float, end: float, drawn: _Drawn) -> Iterator[Tuple[float, float]]:
    """Lengths between which nothing is drawn yet; they are then."""
    along = curve.along
    at = np.linspace(begin, end, max(2, math.ceil((end - begin) / STEP) + 1))
    x, y = (np.interp(at, along, curve.points[:, axis]) for axis in (0, 1))
    piece = np.clip(np.searchsorted(along, at, side="right") - 1, 0, len(along) - 2)
    way = np.diff(curve.points, axis=0)[piece] / np.maximum(np.diff(along)[piece], 1e-12)[:, None]
    around = float(along[-1]) if np.array_equal(curve.points[0], curve.points[-1]) else 0.0
    free = np.zeros(len(at), dtype=bool)
    for i, (s, px, py, (dx, dy)) in enumerate(zip(at.tolist(), x.tolist(), y.tolist(), way.tolist())):
        place = _Place(px, py, dx, dy, s, number, around, curve.reach)
        free[i] = not drawn.has(place)
        if free[i]:
            drawn.add(place)
    _go_on(free, at, curve.reach)
    for first, last, value in _runs(free):
        if value and last > first + 1:
            yield float(at[first]), float(at[last - 1])


def _go_on(free: Any, at: Floats, reach: float) -> None:
    """Draw lines as far as those that they join: they are near to them before they meet, or go on as one of them."""
    runs = _runs(free)
    lengths = [float(at[last - 1] - at[first]) for first, last, _ in runs]
    for i, (first, last, value) in enumerate(runs):
        beside = [lengths[j] for j in (i - 1, i + 1) if 0 <= j < len(runs)]
        if not value and beside and lengths[i] < max(2 * reach, min(_JOINING, *beside)):
            free[first:last] = True
    # Another line that begins where this one is left out is near to it before that.
    more = math.ceil(reach / STEP)
    for first, last, value in _runs(free):
        if value:
            free[max(0, first - more) : last + more] = True


def _class_of(curve: Curve, hidden: bool) -> str:
    if curve.is_smooth:
        return "" if hidden else SMOOTH  # hidden ones are not drawn
    return HIDDEN if hidden else VISIBLE


def in_order(curves: Sequence[Curve], wanted: Sequence[str] = (VISIBLE, HIDDEN, SMOOTH)) -> Dict[str, List[Floats]]:
    """What is drawn of each kind."""
    curves = [one for one in curves if len(one.points) > 1]
    drawn = _Drawn(max([one.reach for one in curves], default=1.0))
    found: Dict[str, List[Floats]] = {kind: [] for kind in wanted}
    parts = [
        (number, curve, float(curve.along[begin]), float(curve.along[end]), _class_of(curve, hidden))
        for number, curve in enumerate(curves)
        for begin, end, hidden in _runs(steady(curve))
    ]
    # Long parts first: a line goes on over short ones beside it, which would then be drawn twice.
    parts.sort(key=lambda part: (part[1].rank, part[2] - part[3]))
    for kind in wanted:
        for number, curve, begin, end, own in parts:
            if own != kind or end - begin < _SHORTEST[kind]:
                continue
            for first, last in _kept(curve, number, begin, end, drawn):
                if last - first >= _SHORTEST_REST:
                    found[kind].append(_part(curve, curve.along, first, last))
    return {kind: _bridged(pieces) for kind, pieces in found.items()}


def _bridged(pieces: Sequence[Floats]) -> List[Floats]:
    """Pieces that go on as one behind a short gap, as one."""
    rest = list(pieces)
    found = []
    while rest:
        line = rest.pop(0)
        for _ in range(2):  # onward, then from the other end
            line = line[::-1]
            while (i := _next_of(line, rest)) is not None:
                part = rest.pop(abs(i) - 1)
                line = np.concatenate((line, part if i > 0 else part[::-1]))
        found.append(line)
    return found


def _next_of(line: Floats, rest: Sequence[Floats]) -> Optional[int]:
    """1 and the number of a piece that goes on where the line ends; negative if its own end is there."""
    way = _direction(line)
    if not rest or np.array_equal(line[0], line[-1]):
        return None
    ends = np.array([(part[0], part[-1]) for part in rest]) - line[-1]
    away = np.linalg.norm(ends, axis=2)
    for number, at_end in np.argwhere((away > 0) & (away < _BRIDGED) & (ends @ way > _STRAIGHT * away)):
        part = rest[number][::-1] if at_end else rest[number]
        if -_direction(part[::-1]) @ way > _STRAIGHT:
            return -int(number) - 1 if at_end else int(number) + 1
    return None


def _direction(line: Floats) -> Floats:
    """In which the last millimetre of a line goes."""
    along = np.concatenate(((0.0,), np.cumsum(np.linalg.norm(np.diff(line[::-1], axis=0), axis=1))))
    begin = [np.interp(1.0, along, line[::-1, axis]) for axis in (0, 1)]
    step = line[-1] - begin
    return np.asarray(step / max(float(np.linalg.norm(step)), 1e-12))
