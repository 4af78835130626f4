# SPDX-License-Identifier: MIT
"""Where views are on a sheet, on which paper and at which scale; lengths are millimetres, y grows downward."""
from __future__ import annotations

import argparse
import math
from dataclasses import dataclass, field
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..shapes._shape import Floats
from ._vectors import PAPERS
from ._vectors import page as paper
from ._view_axes import Plane, View

PAGES = ("a4", "a3", "a2", "a1", "a0")
LEFT, MARGIN = 20.0, 10.0  # beside the frame, for filing and elsewhere [ISO 5457]
PAD = 6.0  # inside it, at least
BLOCK = (180.0, 24.0)  # the title block [ISO 7200]
BAR = (80.0, 16.0)  # the scale bar
LABEL = 9.0  # of a view's name, with the distance to it
CUTTING = 17.0  # of arrows and letters around a view
_DECADES = [10.0**k for k in range(9, -10, -1)]

# Columns and rows of the views around the front one [ISO 5456-2].
_FIRST = {
    "right": (0, 1), "front": (1, 1), "left": (2, 1), "back": (3, 1), "bottom": (1, 0), "top": (1, 2), "iso": (2, 2),
}  # fmt: skip
_THIRD = {
    "left": (0, 1), "front": (1, 1), "right": (2, 1), "back": (3, 1), "top": (1, 0), "bottom": (1, 2), "iso": (2, 0),
}  # fmt: skip
PLACES = {"first": _FIRST, "third": _THIRD}


class Page(NamedTuple):
    """A sheet of paper."""

    name: str
    width: float
    height: float

    @property
    def frame(self) -> Tuple[float, float, float, float]:
        """Left, top, right and bottom."""
        return LEFT, MARGIN, self.width - MARGIN, self.height - MARGIN

    @property
    def reserved(self) -> List["Box"]:
        """For the title block and the scale bar."""
        left, _, right, bottom = self.frame
        block = Box(right - BLOCK[0], bottom - BLOCK[1], right, bottom)
        return [block, Box(left, bottom - BAR[1], left + BAR[0], bottom)]


class Box(NamedTuple):
    left: float
    top: float
    right: float
    bottom: float

    def moved(self, x: float, y: float) -> "Box":
        return Box(self.left + x, self.top + y, self.right + x, self.bottom + y)

    def grown(self, by: float) -> "Box":
        return Box(self.left - by, self.top - by, self.right + by, self.bottom + by)

    def meets(self, other: "Box") -> bool:
        return (self.left < other.right and other.left < self.right
                and self.top < other.bottom and other.top < self.bottom)  # fmt: skip


@dataclass
class Cell:
    """A view with its place in the table, and the box around it from its centre, in units and in millimetres."""

    view: View
    column: int
    row: int
    low: Floats
    high: Floats
    label: bool = False
    cuts: List[Plane] = field(default_factory=list)

    def seen(self, scale: float) -> Box:
        """The drawing alone."""
        return Box(*(scale * self.low), *(scale * self.high))

    def box(self, scale: float) -> Box:
        """With what is around it."""
        seen = self.seen(scale)
        along = [np.abs((plane.normal @ self.view.up, plane.normal @ self.view.right)) > 0.3 for plane in self.cuts]
        x, y = (CUTTING if any(way[axis] for way in along) else 0.0 for axis in (0, 1))
        box = Box(seen.left - x, seen.top - y, seen.right + x, seen.bottom + y)
        return box._replace(top=box.top - LABEL) if self.label else box


class Layout(NamedTuple):
    """The page, millimetres of a unit, and where the centre of each view is."""

    page: Page
    scale: float
    centres: List[Tuple[float, float]]


class Scale(NamedTuple):
    """As it is written, such as 1:2, and the number."""

    text: str
    value: float


def scale_of(text: str) -> Optional[Scale]:
    """1:2; None for auto."""
    if text == "auto":
        return None
    drawn, _, real = text.partition(":")
    try:
        value = float(drawn) / float(real)
    except (ValueError, ZeroDivisionError):
        value = 0.0
    if not (math.isfinite(value) and value > 0):
        raise argparse.ArgumentTypeError(f"must be such as 1:2, 2:1 or 1:1, or auto, not {text!r}")
    return Scale(text, value)


def page_of(text: str) -> Optional[Page]:
    """A paper's name, lying, or WIDTHxHEIGHT; None for auto."""
    if text.lower() == "auto":
        return None
    width, height = paper(text)
    if text.lower() in PAPERS:
        return Page(text.lower(), height, width)
    return Page(f"{width:g} x {height:g}", width, height)


def named(name: str) -> Page:
    page = page_of(name)
    assert page is not None
    return page


def iso_scales() -> List[Scale]:
    """1, 2 and 5 times powers of ten, the largest first [ISO 5455]."""
    large = [Scale(f"{step * ten:.0f}:1", step * ten) for ten in _DECADES if ten >= 1 for step in (5, 2, 1)]
    return large + [Scale(f"1:{1 / one.value:.0f}" if one.value < 1 else f"1:{one.value:.0f}", 1 / one.value)
                    for one in reversed(large[:-1])]  # fmt: skip


def cells(
    views: Sequence[View], points: Floats, middle: Floats, projection: str, upward: Floats, labels: bool
) -> List[Cell]:
    """In the order of the views; sections follow the others to the right, or below if they are seen from above."""
    found: List[Cell] = []
    across, down = 4, 3
    for view in views:
        places = view.flat(points, middle)
        low, high = places.min(axis=0), places.max(axis=0)
        if view.plane is None:
            column, row = PLACES[projection][view.name]
        elif abs(view.eye @ upward) > 1 - 1e-6:
            column, row, down = 1, down, down + 1
        else:
            column, row, across = across, 1, across + 1
        found.append(Cell(view, column, row, low, high, labels or view.plane is not None))
    return found


def is_aligned(cell: Cell, upward: Floats) -> bool:
    """Whether the view shares its centre lines with those beside it; else it is in the middle of its place."""
    return cell.view.name != "iso" and (cell.view.plane is None or cell.row != 1 or abs(cell.view.eye @ upward) < 1e-6)


def _spans(
    boxes: Sequence[Tuple[int, float, float]], gap: float
) -> Tuple[Dict[int, Tuple[float, float, float]], float]:
    """For columns or rows by number: where they begin, and how far they reach before and behind their centre line."""
    reach: Dict[int, List[float]] = {}
    for number, before, behind in boxes:
        known = reach.setdefault(number, [-math.inf, -math.inf])
        known[0], known[1] = max(known[0], before), max(known[1], behind)
    spans, at = {}, 0.0
    for number in sorted(reach):
        before, behind = reach[number]
        spans[number] = (at, before, behind)
        at += before + behind + gap
    return spans, at - gap


def table(
    drawn: Sequence[Cell], scale: float, gap: float, upward: Floats
) -> Tuple[List[Tuple[float, float]], float, float]:
    """Centres of the views from the table's upper left corner, and its size."""
    boxes = [cell.box(scale) for cell in drawn]
    shifts = []
    for cell, box in zip(drawn, boxes):
        free = not is_aligned(cell, upward)
        shifts.append(((box.left + box.right) / 2 if free else 0.0, (box.top + box.bottom) / 2 if free else 0.0))
    moved = [box.moved(-x, -y) for box, (x, y) in zip(boxes, shifts)]
    columns, width = _spans([(cell.column, -box.left, box.right) for cell, box in zip(drawn, moved)], gap)
    rows, height = _spans([(cell.row, -box.top, box.bottom) for cell, box in zip(drawn, moved)], gap)
    centres = []
    for cell, (x, y) in zip(drawn, shifts):
        begin, before, _ = columns[cell.column]
        top, above, _ = rows[cell.row]
        centres.append((begin + before - x, top + above - y))
    return centres, width, height


def place(drawn: Sequence[Cell], scale: float, page: Page, gap: float, upward: Floats) -> Optional[Layout]:
    """On this page, clear of the title block and the scale bar; None if there is no room."""
    centres, width, height = table(drawn, scale, gap, upward)
    left, top, right, bottom = page.frame
    room = right - left - 2 * PAD, bottom - top - 2 * PAD
    above = room[1] - max(BLOCK[1], BAR[1])
    if width > room[0] or height > room[1]:
        return None
    for x, y in (
        ((room[0] - width) / 2, (above - height) / 2), ((room[0] - width) / 2, 0.0),
        ((room[0] - width) / 2, (room[1] - height) / 2), (0.0, 0.0),
    ):  # fmt: skip
        corner = left + PAD + x, top + PAD + y
        boxes = [cell.box(scale).moved(corner[0] + cx, corner[1] + cy) for cell, (cx, cy) in zip(drawn, centres)]
        if y >= 0 and not any(box.meets(one.grown(PAD / 2)) for box in boxes for one in page.reserved):
            return Layout(page, scale, [(corner[0] + cx, corner[1] + cy) for cx, cy in centres])
    return None


def choose(
    drawn: Sequence[Cell], page: Optional[Page], scale: Optional[Scale], unit: float, gap: float, upward: Floats
) -> Tuple[Layout, Scale]:
    """The layout on the page and at the scale that are given, or that fit."""
    if scale is None:
        page = page or named("a3")
        for one in iso_scales():
            layout = place(drawn, one.value * unit, page, gap, upward)
            if layout is not None:
                return layout, one
        raise ValueError(f"--page {page.name}: there is no room for these views; a smaller --spacing, or a larger page")
    for one_page in [page] if page is not None else [named(name) for name in PAGES]:
        layout = place(drawn, scale.value * unit, one_page, gap, upward)
        if layout is not None:
            return layout, scale
    raise ValueError(_no_room(drawn, page, scale, unit, gap, upward))


def _no_room(
    drawn: Sequence[Cell], page: Optional[Page], scale: Scale, unit: float, gap: float, upward: Floats
) -> str:
    _, width, height = table(drawn, scale.value * unit, gap, upward)
    largest = page or named("a0")
    left, top, right, bottom = largest.frame
    fits = next((one for one in iso_scales() if place(drawn, one.value * unit, largest, gap, upward)), None)
    larger = [name for name in PAGES if page is not None and place(drawn, scale.value * unit, named(name), gap, upward)]
    ways = ([f"--scale {fits.text}"] if fits is not None else []) + [f"--page {name}" for name in larger[:1]]
    return (
        f"--scale {scale.text}: the views need {width:.0f} x {height:.0f} mm, and {largest.name} has "
        f"{right - left - 2 * PAD:.0f} x {bottom - top - 2 * PAD:.0f} beside its title block: "
        f"{' or '.join(ways) or 'a smaller --spacing'} fits"
    )


def middle_of(points: Floats, axes: Tuple[Floats, Floats, Floats]) -> Floats:
    """Of the box around points that stands as the model does."""
    turned = points @ np.stack(axes, axis=1)
    return np.asarray((turned.min(axis=0) + turned.max(axis=0)) / 2 @ np.stack(axes), dtype=float)
