# SPDX-License-Identifier: MIT
"""What a sheet has beside its views: frame, title block, symbols, names, cutting planes, centre lines, a scale bar.

Lengths are millimetres, y grows downward.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .._page import Annotation, Pen
from ..shapes._shape import Floats
from ._plate import bar_length
from ._view_axes import Plane, View
from ._view_layout import BAR, BLOCK, Box, Page

INK = (0.0, 0.0, 0.0, 1.0)
TEXT = 3.5  # height of capitals [ISO 3098]
_BEYOND = 6.0  # of cutting planes beside the drawing
_THICK_END = 5.0  # of a cutting plane's thick ends
_ARROW = 7.0
_CENTRE_BEYOND = 3.0


class Kind(NamedTuple):
    """A kind of lines: its width in widths of the widest, the number of its pen, and its type of ISO 128-2."""

    width: float
    pen: int
    line_type: str = "continuous"


# In the order of the page.
KINDS: Dict[str, Kind] = {
    "hatching": Kind(0.5, 2), "centre lines": Kind(0.5, 2, "long_dashed_dotted"), "smooth": Kind(0.5, 2),
    "hidden": Kind(0.5, 2, "dashed"), "cutting planes": Kind(0.5, 2, "long_dashed_dotted"), "outlines": Kind(1.0, 1),
    "cutting ends": Kind(1.0, 1), "frame": Kind(1.4, 1), "title block": Kind(0.5, 2), "projection": Kind(1.0, 1),
    "projection axes": Kind(0.5, 2, "long_dashed_dotted"), "scale bar": Kind(0.5, 2),
    "scale fields": Kind(0.6, 2), "texts": Kind(0.0, 2),
}  # fmt: skip


@dataclass
class Lines:
    """Annotations by kind; a layer of the page has the name of its kind and of its view."""

    width: float
    hidden: str = "dashed"

    def __post_init__(self) -> None:
        self._made: Dict[Tuple[str, str], List[Annotation]] = {}

    def add(self, kind: str, points: Any, view: str = "") -> None:
        how = self._how(kind)
        one = Annotation(np.asarray(points, dtype=float), None, f"{kind} {view}".strip(), how.width, INK, how.line_type)
        self._made.setdefault((kind, view), []).append(one)

    def text(self, at: Sequence[float], text: str, height: float = TEXT, centred: bool = False) -> None:
        """From a place on the baseline, or around it."""
        left = at[0] - text_width(text, height) / 2 if centred else at[0]
        self._made.setdefault(("texts", ""), []).append(Annotation([[left, at[1]]], text, "texts", height, INK))

    def _how(self, kind: str) -> Kind:
        how = KINDS[kind]
        how = how._replace(width=how.width * (0.5 if kind.startswith(("frame", "scale f")) else self.width))
        return how._replace(line_type="continuous") if kind == "hidden" and self.hidden == "shown" else how

    def annotations(self) -> List[Annotation]:
        """Layer after layer."""
        return [one for kind in KINDS for key, of_kind in self._made.items() if key[0] == kind for one in of_kind]

    def pens(self) -> List[Pen]:
        """For plotters: the wide pen is 1, the fine one 2."""
        kinds = ((kind, self._how(kind)) for kind in KINDS if kind != "texts")
        return [Pen(f"{kind}*", how.width, INK, how.pen, how.line_type) for kind, how in kinds]


# Widths of Helvetica, in 1/1000 of the size; of what is not here 556.
_WIDTHS = {**dict.fromkeys(" ,./:;ft!I", 278), **dict.fromkeys("ijl'|", 222), **dict.fromkeys("()r-", 333),
           **dict.fromkeys("cksvxyz", 500), **dict.fromkeys("FTZ", 611), **dict.fromkeys("ABEKPSVXY", 667),
           **dict.fromkeys("CDHNRUw", 722), **dict.fromkeys("GOQ", 778), "m": 833, "M": 833, "W": 944}  # fmt: skip


def text_width(text: str, height: float) -> float:
    """Of capitals of this height."""
    return height / 0.716 * sum(_WIDTHS.get(letter, 556) for letter in text) / 1000


def _fitting(text: str, room: float, height: float) -> Tuple[str, float]:
    """Smaller, and then shorter, where there is no room for it."""
    smaller = max(1.8, min(height, height * room / max(text_width(text, height), 1e-9)))
    while len(text) > 4 and text_width(text, smaller) > room:
        text = text[:-4] + "..."
    return text, smaller


def _rectangle(left: float, top: float, right: float, bottom: float) -> List[Tuple[float, float]]:
    return [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]


def frame(lines: Lines, page: Page) -> None:
    """Around all of the sheet [ISO 5457]."""
    lines.add("frame", _rectangle(*page.frame))


def title_block(lines: Lines, page: Page, facts: Dict[str, str], projection: str) -> None:
    """In the lower right corner [ISO 7200]: the title and the file, scale, page and projection."""
    _, _, right, bottom = page.frame
    left, top = right - BLOCK[0], bottom - BLOCK[1]
    middle, columns = top + BLOCK[1] / 2, (left, left + 100, left + 140)
    lines.add("frame", _rectangle(left, top, right, bottom))
    lines.add("title block", [(left, middle), (columns[1], middle)])
    lines.add("title block", [(columns[2], middle), (right, middle)])
    for x in columns[1:]:
        lines.add("title block", [(x, top), (x, bottom)])
    for name, x, y, room in (
        ("Title", left, top, 100.0), ("Model", left, middle, 100.0), ("Scale", columns[2], top, 40.0),
        ("Page, unit", columns[2], middle, 40.0), (f"Projection: {projection} angle", columns[1], top, 40.0),
    ):  # fmt: skip
        lines.text((x + 1.5, y + 3.0), name, 1.8)
        text, height = _fitting(facts.get(name, ""), room - 4, 5.0 if name == "Title" else TEXT)
        if text:
            lines.text((x + 2.5, y + 9.5), text, height)
    projection_symbol(lines, (columns[1] + 20, top + 14.5), projection)


def projection_symbol(lines: Lines, middle: Tuple[float, float], projection: str) -> None:
    """A truncated cone from its side, and from its smaller end, where that view belongs [ISO 5456-2]."""
    large, small, length = 5.0, 2.5, 10.0  # radii
    side = 1.0 if projection == "first" else -1.0
    cone, end = middle[0] - side * 8.0, middle[0] + side * 9.0
    half = length / 2
    trapezium = [(-half, -small), (half, -large), (half, large), (-half, small), (-half, -small)]
    lines.add("projection", np.array(trapezium) + (cone, middle[1]))
    turn = np.linspace(0, 2 * np.pi, 73)
    for radius in (large, small):
        circle = radius * np.stack((np.cos(turn), np.sin(turn)), axis=1)
        circle[-1] = circle[0]
        lines.add("projection", circle + (end, middle[1]))
    for x, reach in ((cone, half + 1.5), (end, large + 1.5)):
        lines.add("projection axes", [(x - reach, middle[1]), (x + reach, middle[1])])
    lines.add("projection axes", [(end, middle[1] - large - 1.5), (end, middle[1] + large + 1.5)])


def scale_bar(lines: Lines, page: Page, scale: float) -> None:
    """Five fields in the lower left corner; `scale` is millimetres on the paper of one of the model."""
    left, _, _, bottom = page.frame
    length = bar_length(0.75 * BAR[0] / scale)
    field, x, y = length * scale / 5, left + 6.0, bottom - 10.0
    lines.add("scale bar", _rectangle(x, y, x + 5 * field, y + 1.5))
    for i in (0, 2, 4):  # filled by lines, which plotters draw, too
        for level in np.linspace(y + 0.15, y + 1.35, 6):
            lines.add("scale fields", [(x + i * field, level), (x + (i + 1) * field, level)])
    lines.text((x, y + 5.5), "0", 2.5, centred=True)
    lines.text((x + 5 * field, y + 5.5), f"{length:g} mm", 2.5, centred=True)


def name_of(lines: Lines, view: View, box: Box) -> None:
    """Above the view."""
    section = view.plane is not None
    text = view.name if section else {"iso": "Isometric view"}.get(view.name, f"{view.name.capitalize()} view")
    lines.text(((box.left + box.right) / 2, box.top + TEXT), text, 5.0 if section else TEXT, centred=True)


def _across(point: Floats, way: Floats, box: Box) -> Tuple[Floats, Floats]:
    """Where a line through a point enters and leaves a box; both at the point if it misses the box."""
    low, high = -np.inf, np.inf
    for axis, (first, last) in enumerate(((box.left, box.right), (box.top, box.bottom))):
        if abs(way[axis]) > 1e-9:
            a, b = sorted(((first - point[axis]) / way[axis], (last - point[axis]) / way[axis]))
            low, high = max(low, a), min(high, b)
    return (point + low * way, point + high * way) if low < high else (point, point)


def _trace(view: View, normal: Floats, away: float, scale: float, centre: Tuple[float, float]) -> Tuple[Floats, Floats]:
    """A plane that is seen as a line: a point, `away` from the middle of the model, and the direction on the paper."""
    flat = np.array((normal @ view.right, -(normal @ view.up)))
    return np.asarray(centre) + scale * view.factor * away * flat, np.array((-flat[1], flat[0]))


def cutting_plane(
    lines: Lines, view: View, plane: Plane, middle: Floats, scale: float, centre: Tuple[float, float], box: Box
) -> None:
    """Where a section is: a line whose thick ends have arrows in the direction of sight, and letters [ISO 128-3]."""
    point, way = _trace(view, plane.normal, plane.place - float(plane.normal @ middle), scale, centre)
    begin, end = _across(point, way, box.grown(_BEYOND))
    lines.add("cutting planes", (begin, end), view.name)
    sight = -np.array((plane.normal @ view.right, -(plane.normal @ view.up)))
    for tip, inward in ((begin, way), (end, -way)):
        lines.add("cutting ends", (tip, tip + _THICK_END * inward), view.name)
        tail = tip - _ARROW * sight
        lines.add("cutting ends", (tail, tip), view.name)
        for side in (-1, 1):
            back = tip - 3.0 * sight + side * 0.8 * inward
            lines.add("cutting ends", (back, tip), view.name)
        letter = tip - 4.5 * inward - 0.5 * _ARROW * sight
        lines.text((letter[0], letter[1] + 2.5), plane.name, 5.0, centred=True)


def centre_line(
    lines: Lines, view: View, normal: Floats, scale: float, centre: Tuple[float, float], box: Box
) -> None:
    """A plane of symmetry through the middle, where it is seen as a line."""
    point, way = _trace(view, normal, 0.0, scale, centre)
    lines.add("centre lines", _across(point, way, box.grown(_CENTRE_BEYOND)), view.name)


def first_edge_on(views: Sequence[View], plane: Plane) -> Optional[View]:
    """The view that shows where a section is: of the front, the top and others the first that sees the plane's edge."""
    order = {name: i for i, name in enumerate(("front", "top", "left", "right", "bottom", "back"))}
    able = [view for view in views if view.plane is None and view.edge_on(plane.normal)]
    return min(able, key=lambda view: order.get(view.name, len(order)), default=None)
