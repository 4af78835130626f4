# SPDX-License-Identifier: MIT
"""The command sheet: draws one model in several styles or views, side by side in one picture."""
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
from ._progress import PartReporter, Reporter

SIZE = 640  # default of the longer side of each drawing, in pixels
_PAPER, _INK, _FRAME = (255, 255, 255), (0, 0, 0), (190, 190, 190)
# Codes of notes about small defects of lines, which are hard to see in the small drawings of a sheet.
_SKIPPED_NOTES = ("lines_broken", "lines_doubted", "lines_tangled")
_VIEW_OPTIONS = ("azimuth", "direction", "eye")  # each of these chooses the view


class Cell(NamedTuple):
    """One drawing of the sheet: its label, and the style and options with which `draw` makes the same drawing."""

    label: str
    style: str
    options: Options


class Layout(NamedTuple):
    """The sizes and places of drawings and labels, in pixels.  Drawings are in a grid of cells."""

    columns: int  # number of cells side by side
    width: int  # width of a cell
    height: int  # height of a cell without its label
    text: int  # height of a label
    gap: int  # space between cells

    def size(self, count: int) -> Tuple[int, int]:
        """The width and height of a sheet with this number of cells."""
        rows = math.ceil(count / self.columns)
        down = self.height + self.text + 2 * self.gap
        return self.columns * (self.width + self.gap) + self.gap, rows * down + self.gap

    def corner(self, index: int) -> Tuple[int, int]:
        """The upper left corner of a cell.  Its label is below the drawing."""
        down, across = divmod(index, self.columns)
        return self.gap + across * (self.width + self.gap), self.gap + down * (self.height + self.text + 2 * self.gap)


def cells(arguments: Any, options: Options) -> List[Cell]:
    """All cells: each style in each view.  The views of a style follow each other."""
    result = []
    given: Options = {"size": SIZE, **options}
    if not any(name in options for name in _VIEW_OPTIONS):
        given["azimuth"] = 30.0  # one view for all cells; `draw` alone would show the front of an open surface
    for style in arguments.styles or PRESETS:
        if arguments.views is None:
            result.append(Cell(style, style, given))
        for view in arguments.views or ():
            azimuth, elevation = VIEWS[view]
            result.append(Cell(f"{style}, {view}", style, {**given, "azimuth": azimuth, "elevation": elevation}))
    return result


class _FirstCellReporter(PartReporter):
    """The reporter of the first cell, with which the surface is fitted.

    Most notes are then about the file, so they get no prefix.  The stages that place the marks and trace the lines of
    this cell are not printed, because the other cells print none.
    """

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


def _draw_cell(scene: Scene, report: Any) -> Any:
    """The drawing as a PIL.Image, the same as `draw` makes.

    A blank drawing gives a warning and no error, because the other cells may be useful.
    """
    try:
        drawing = scene.draw(report=report)
    except BlankError as error:
        report.take_note(_warning_of(report.failure))
        drawing = scene.draw(scene.camera)  # with a given camera, a blank drawing is no error
        del error
    return _pictures.to_pil(scene.image(drawing, scene.camera))


def _warning_of(failure: Note) -> Note:
    """Turn a failure into a warning.  Its first sentence is the text, and the others are the detail."""
    what, _, why = str(failure).partition(". ")
    note = Note(what)
    note.code, note.severity, note.figures, note.detail = failure.code, "warning", failure.figures, why and f"{why}."
    return note


def _label(text: str, height: int, width: int) -> Any:
    """A picture of a text in the default font of Pillow, enlarged by a whole number to about this height.

    It is at most `width` wide, unless the text is wider at its natural size.
    """
    from PIL import Image, ImageDraw, ImageFont

    font = ImageFont.load_default()
    # Pillow before 9.2 has getsize in place of getbbox.
    left, top, right, bottom = font.getbbox(text) if hasattr(font, "getbbox") else (0, 0, *font.getsize(text))
    natural = Image.new("L", (right - left, bottom - top), 0)
    ImageDraw.Draw(natural).text((-left, -top), text, fill=255, font=font)
    scale = max(1, min(round(height / natural.height), width // natural.width))
    return natural.resize((scale * natural.width, scale * natural.height), Image.NEAREST)


def _layout(arguments: Any, sizes: List[Tuple[int, int]], labels: List[Any]) -> Layout:
    """The layout for drawings of these sizes.  By default each view has a column, or the sheet is about square."""
    width = max(*(size[0] for size in sizes), *(label.width for label in labels))
    height, text = max(size[1] for size in sizes), max(label.height for label in labels)
    gap = max(4, max(width, height) // 40)
    views = len(arguments.views or ())
    columns = arguments.columns or views or round(math.sqrt(len(sizes) * (height + text + gap) / (width + gap)))
    return Layout(max(1, min(columns, len(sizes))), width, height, text, gap)


def _compose(layout: Layout, pictures: List[Any], labels: List[Any]) -> Any:
    """The whole sheet as a PIL.Image."""
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
    first_report = _FirstCellReporter(report, wanted[0].label)
    first_scene = scene_of(
        arguments.input, wanted[0].style, wanted[0].options, None, context, first_report, flags=("TOGETHER",)
    )
    if first_scene.model is None:
        raise UsageError(f"{arguments.input} holds a point set; a sheet needs a mesh, points or a model")
    pictures = []
    with report.stage("drawings", "drawing") as stage:
        for cell in wanted:
            if stage.bar is not None:
                stage.bar.set_description(cell.label)
            cell_report = PartReporter(report, cell.label, _SKIPPED_NOTES)
            scene = first_scene if cell is wanted[0] else first_scene.restyled(
                cell.options, cell.style, cell_report, flags=("TOGETHER",))  # fmt: skip
            pictures.append(_draw_cell(scene, cell_report))
            if stage.bar is not None:
                stage.bar.update(1 / len(wanted))
        stage.says = f"{len(wanted)} drawings, each with its marks and lines"
    sizes: List[Tuple[int, int]] = [picture.size for picture in pictures]
    text = max(8, max(max(size) for size in sizes) // 28)
    labels = [_label(cell.label, text, max(size[0] for size in sizes)) for cell in wanted]
    with report.stage("write", "writing") as stage:
        _pictures.save(_compose(_layout(arguments, sizes, labels), pictures, labels), output, None)
        stage.says = str(output)
    report.summary(f"{output}: {len(wanted)} drawings")
