# SPDX-License-Identifier: MIT
"""Lines at 45 degrees inside closed outlines, as cut faces are drawn [ISO 128-3]."""
from __future__ import annotations

from typing import List, Sequence

import numpy as np

from ..shapes._shape import Floats

CLOSED = 1e-3  # distance of ends that meet, of the outline's length


def closed(lines: Sequence[Floats]) -> List[Floats]:
    """Outlines that go round, from parts of them in any order and direction."""
    rest = [line for line in lines if len(line) > 1]
    found = []
    while rest:
        outline = rest.pop()
        while not _meet(outline[-1], outline[0], outline) and rest:
            ends = np.linalg.norm([(line[0], line[-1]) for line in rest] - outline[-1], axis=2)
            nearest, turned = divmod(int(ends.argmin()), 2)
            if not _meet(rest[nearest][-turned], outline[-1], outline):
                break
            line = rest.pop(nearest)
            outline = np.concatenate((outline, (line[::-1] if turned else line)[1:]))
        if len(outline) > 3 and _meet(outline[-1], outline[0], outline):
            found.append(outline)
    return found


def _meet(a: Floats, b: Floats, outline: Floats) -> bool:
    length = np.linalg.norm(np.diff(outline, axis=0), axis=1).sum()
    return bool(np.linalg.norm(a - b) <= max(CLOSED * length, 1e-6) and len(outline) > 1)


def hatched(outlines: Sequence[Floats], period: float) -> List[Floats]:
    """Segments, (2, 2) each, of lines that rise to the right, `period` apart, where they are inside.

    Inside is what an odd number of outlines goes round, so that holes stay empty.  y grows downward.
    """
    if not outlines:
        return []
    turn = np.array(((1.0, 1.0), (1.0, -1.0))) / np.sqrt(2)  # along u a line's number, along v its points
    edges = np.concatenate([np.stack((line, np.roll(line, -1, axis=0)), axis=1) for line in outlines]) @ turn
    u, v = edges[..., 0], edges[..., 1]
    segments = []
    first, last = np.floor(u.min() / period), np.ceil(u.max() / period)
    for number in np.arange(first, last + 1):
        level = (number + 0.5) * period
        cut = (u[:, 0] <= level) != (u[:, 1] <= level)
        part = (level - u[cut, 0]) / (u[cut, 1] - u[cut, 0])
        places = np.sort(v[cut, 0] + part * (v[cut, 1] - v[cut, 0]))
        for begin, end in zip(places[0::2], places[1::2]):
            segments.append(np.array(((level, begin), (level, end))) @ turn)
    return segments
