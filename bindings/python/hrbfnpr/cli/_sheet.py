# SPDX-License-Identifier: MIT
"""A contact sheet: one model in many styles."""
from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Tuple

from .. import _pictures, _scene
from .._camera import Camera
from .._context import Context
from .._model import Model
from .._names import PRESETS
from .._renderer import Item, Renderer
from . import _automatic, _blank, _lines
from ._progress import Reporter
from ._values import VIEWS

SIZE = 640  # longer side of each drawing
_PAPER, _INK, _FRAME = (255, 255, 255), (0, 0, 0), (190, 190, 190)


class Cell(NamedTuple):
    """One drawing of the sheet: its label, and the arguments that `draw` would have."""

    label: str
    arguments: argparse.Namespace


class Layout(NamedTuple):
    """Where drawings and labels are, in pixels."""

    columns: int
    width: int  # of a cell
    height: int
    text: int  # height of a label
    gap: int

    def size(self, count: int) -> Tuple[int, int]:
        rows = math.ceil(count / self.columns)
        down = self.height + self.text + 2 * self.gap
        return self.columns * (self.width + self.gap) + self.gap, rows * down + self.gap

    def corner(self, index: int) -> Tuple[int, int]:
        """The upper left corner of a cell's drawing; its label is below."""
        down, across = divmod(index, self.columns)
        return self.gap + across * (self.width + self.gap), self.gap + down * (self.height + self.text + 2 * self.gap)


def output_of(arguments: Any) -> Path:
    """Where the sheet goes."""
    return Path(arguments.output_option or arguments.output or Path(arguments.input).stem + "-sheet.png")


def cells(arguments: Any) -> List[Cell]:
    """All drawings, style by style."""
    result = []
    for style in arguments.styles or PRESETS:
        given = {**vars(arguments), "style": style, "size": arguments.size or SIZE}
        if arguments.views is None:
            result.append(Cell(style, argparse.Namespace(**given)))
        for view in arguments.views or ():
            given["azimuth"], given["elevation"] = VIEWS[view]
            result.append(Cell(f"{style}, {view}", argparse.Namespace(**given)))
    return result


class _Artist:
    """Draws cell by cell; marks and lines are made once for all that want the same."""

    def __init__(self, model: Model, context: Context, report: Reporter) -> None:
        self._model, self._context, self._report = model, context, report
        known = _automatic.probe(model, context)
        self._places, self._area = _automatic.positions(known), _scene.area_of(known)
        self._renderer = Renderer(context=context)
        self._marks: List[Tuple[Any, Any]] = []
        self._lines: Dict[Any, Any] = {}

    def camera(self, cell: Cell) -> Camera:
        return _scene.make_camera(cell.arguments, self._model, self._places)

    def draw(self, cell: Cell) -> Any:
        """A PIL.Image, the same as `draw` makes."""
        camera = self.camera(cell)
        about = self._report.without_bars(cell.label)
        style, layers = _scene.plan(cell.arguments, self._model, self._area, camera, about)
        marks, line_set = self._marks_of(cell, layers), self._lines_of(cell, style, camera)
        sides = _scene.sides_of(cell.arguments, self._model)
        drawing = self._renderer.draw(Item(marks, style, line_set=line_set, sides=sides), camera)
        try:
            _blank.check(drawing, self._model, camera, style, cell.arguments.flip)
        except _blank.BlankError as error:  # the others may be worth having
            about.warn(str(error))
        if not _scene.is_plate(cell.arguments):
            return drawing.to_pil()
        return _scene.plate(
            cell.arguments, drawing, self._model, marks, line_set, camera, style, self._context
        ).convert("RGBA")

    def _marks_of(self, cell: Cell, layers: Any) -> Any:
        for wanted, marks in self._marks:
            if wanted == layers:
                return marks
        marks = _scene.generate(cell.arguments, self._model, layers, self._context, self._report)
        self._marks.append((layers, marks))
        return marks

    def _lines_of(self, cell: Cell, style: Any, camera: Camera) -> Any:
        more = _scene.section_lines(cell.arguments, self._model, camera)
        if more:  # of this camera alone
            return _lines.make(cell.arguments, self._model, style, self._context, self._report, more)
        if not style.lines or style.visibility == "published":
            return None
        # Lines with curvatures serve styles that do not want them, too, but their mesh may be finer.
        key = _lines.needs_curvature(style), tuple(_lines.wanted_lines(cell.arguments, style))
        if key not in self._lines:
            self._lines[key] = _lines.make(cell.arguments, self._model, style, self._context, self._report)
        return self._lines[key]


def _label(text: str, height: int, width: int) -> Any:
    """A text in Pillow's own font, larger by a whole number, about so high and not wider than that if it can be."""
    from PIL import Image, ImageDraw, ImageFont

    font = ImageFont.load_default()
    left, top, right, bottom = font.getbbox(text)
    natural = Image.new("L", (right - left, bottom - top), 0)
    ImageDraw.Draw(natural).text((-left, -top), text, fill=255, font=font)
    scale = max(1, min(round(height / natural.height), width // natural.width))
    return natural.resize((scale * natural.width, scale * natural.height), Image.NEAREST)


def _layout(arguments: Any, sizes: List[Tuple[int, int]], labels: List[Any]) -> Layout:
    width = max(*(size[0] for size in sizes), *(label.width for label in labels))
    height, text = max(size[1] for size in sizes), max(label.height for label in labels)
    gap = max(4, max(width, height) // 40)
    views = len(arguments.views or ())
    columns = arguments.columns or views or round(math.sqrt(len(sizes) * (height + text + gap) / (width + gap)))
    return Layout(max(1, min(columns, len(sizes))), width, height, text, gap)


def _compose(layout: Layout, pictures: List[Any], labels: List[Any]) -> Any:
    from PIL import Image, ImageDraw

    sheet = Image.new("RGB", layout.size(len(pictures)), _PAPER)
    pen = ImageDraw.Draw(sheet)
    for index, (picture, label) in enumerate(zip(pictures, labels)):
        x, y = layout.corner(index)
        pen.rectangle((x - 1, y - 1, x + layout.width, y + layout.height), outline=_FRAME)
        place = (x + (layout.width - picture.width) // 2, y + (layout.height - picture.height) // 2)
        sheet.paste(picture, place, picture)
        place = (x + (layout.width - label.width) // 2, y + layout.height + layout.gap // 2)
        sheet.paste(_INK, place, label)
    return sheet


def draw_sheet(arguments: Any, output: Path, model: Model, context: Context, report: Reporter) -> None:
    """Draw all cells and write the sheet."""
    wanted = cells(arguments)
    artist = _Artist(model, context, report.without_bars())
    pictures = []
    with report.stage("drawings", "drawing") as stage:
        for cell in wanted:
            if stage.bar is not None:
                stage.bar.set_description(cell.label)
            pictures.append(artist.draw(cell))
            if stage.bar is not None:
                stage.bar.update(1 / len(wanted))
        stage.says = f"{len(wanted)}: marks, lines and frames of each"
    sizes = [picture.size for picture in pictures]
    text = max(8, max(map(max, sizes)) // 28)
    labels = [_label(cell.label, text, max(size[0] for size in sizes)) for cell in wanted]
    with report.stage("write", "writing") as stage:
        _pictures.save(_compose(_layout(arguments, sizes, labels), pictures, labels), output, None)
        stage.says = str(output)
    report.summary(f"{output}: {len(wanted)} drawings")
