# SPDX-License-Identifier: MIT
"""A contact sheet: one model in many styles."""
from __future__ import annotations

import math
from pathlib import Path
from typing import Any, List, NamedTuple, Tuple

from .. import _pictures
from .._context import Context
from .._names import PRESETS
from .._report import Note
from .._request import Options
from .._scene import BlankError, Scene
from .._sources import scene_of
from ._grammar import VIEWS
from ._outputs import UsageError, check_picture
from ._progress import Part, Reporter

SIZE = 640  # longer side of each drawing
_PAPER, _INK, _FRAME = (255, 255, 255), (0, 0, 0), (190, 190, 190)
_NOT_TOLD = ("lines_broken", "lines_doubted", "lines_tangled")  # of so small drawings
_VIEW = ("azimuth", "direction", "eye")


class Cell(NamedTuple):
    """One drawing of the sheet: its label, and the style and options that `draw` would have."""

    label: str
    style: str
    options: Options


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


def cells(arguments: Any, options: Options) -> List[Cell]:
    """All drawings, style by style."""
    result = []
    given: Options = {"size": SIZE, **options}
    if not any(name in options for name in _VIEW):
        given["azimuth"] = 30.0  # not the front of an open surface: all cells are seen from one side
    for style in arguments.styles or PRESETS:
        if arguments.views is None:
            result.append(Cell(style, style, given))
        for view in arguments.views or ():
            azimuth, elevation = VIEWS[view]
            result.append(Cell(f"{style}, {view}", style, {**given, "azimuth": azimuth, "elevation": elevation}))
    return result


class _First(Part):
    """Of the first cell, which the surface is made with: what is said of this is said of the file."""

    def take_note(self, note: Any) -> None:
        if note.code in ("marks_limited", "levels_limited"):
            super().take_note(note)
        else:
            self._whole.take_note(note)
            self.failure = self._whole.failure

    def begin(self, doing: str) -> Any:
        return self._whole.begin(doing)

    def end(self, stage: Any, name: str, seconds: float) -> None:
        if name in ("place marks", "trace lines"):
            self._whole.drop(stage)
        else:
            self._whole.end(stage, name, seconds)

    def drop(self, stage: Any) -> None:
        self._whole.drop(stage)


def _drawn(scene: Scene, report: Any) -> Any:
    """A PIL.Image, the same as `draw` makes; one that is blank is warned of, as the others may be worth having."""
    try:
        drawing = scene.draw(report=report)
    except BlankError as error:
        report.take_note(_warning_of(report.failure))
        drawing = scene.draw(scene.camera)
        del error
    return _pictures.to_pil(scene.image(drawing, scene.camera))


def _warning_of(failure: Note) -> Note:
    """Why a drawing is blank is the detail of its warning."""
    what, _, why = str(failure).partition(". ")
    note = Note(what)
    note.code, note.severity, note.figures, note.detail = failure.code, "warning", failure.figures, why and f"{why}."
    return note


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


def draw_sheet(arguments: Any, options: Options, context: Context, report: Reporter) -> None:
    """Draw all cells and write the sheet."""
    output = Path(arguments.output_option or arguments.output or Path(arguments.input).stem + "-sheet.png")
    check_picture(output)
    wanted = cells(arguments, options)
    first = _First(report, wanted[0].label)
    made = scene_of(arguments.input, wanted[0].style, wanted[0].options, None, context, first, flags=("TOGETHER",))
    if made.model is None:
        raise UsageError(f"{arguments.input} holds a point set; a sheet needs a mesh, points or a model")
    pictures = []
    with report.stage("drawings", "drawing") as stage:
        for cell in wanted:
            if stage.bar is not None:
                stage.bar.set_description(cell.label)
            about = Part(report, cell.label, _NOT_TOLD)
            scene = made if cell is wanted[0] else made.restyled(cell.options, cell.style, about, flags=("TOGETHER",))
            pictures.append(_drawn(scene, about))
            if stage.bar is not None:
                stage.bar.update(1 / len(wanted))
        stage.says = f"{len(wanted)} drawings, each with its marks and lines"
    sizes = [picture.size for picture in pictures]
    text = max(8, max(map(max, sizes)) // 28)
    labels = [_label(cell.label, text, max(size[0] for size in sizes)) for cell in wanted]
    with report.stage("write", "writing") as stage:
        _pictures.save(_compose(_layout(arguments, sizes, labels), pictures, labels), output, None)
        stage.says = str(output)
    report.summary(f"{output}: {len(wanted)} drawings")
