# SPDX-License-Identifier: MIT
"""What a plate of finds has beside the drawing: a section through the middle, and a scale bar."""
from __future__ import annotations

import math
from typing import Any, List, Optional, Tuple

import numpy as np

from .._camera import Camera
from .._context import Context
from .._drawing import Drawing
from .._line_set import Lines, LineSet
from .._line_style import LineStyle
from .._model import Model
from .._page import Annotation, PageItem
from .._pictures import to_pil
from .._point_set import PointSet
from .._renderer import Item, Renderer
from .._style import LayerStyle, Style
from . import _automatic, _cut_faces

NAME = "middle"  # of the section among the lines of a line set
_STRIP = 0.09  # of the picture's longer side, for the bar ...
_LEAST_STRIP = 44.0  # ... but in pens room for the bar and what is written below it
_BAR = 0.3  # of the picture's width, at most


def _axes(camera: Camera) -> Tuple[Any, Any, Any]:
    """Right, up and towards the eye."""
    right, up, back = np.asarray(camera.view)[:3, :3]
    return right, up, back


def _middle(model: Model) -> Any:
    low, high = (np.asarray(corner, dtype=float) for corner in model.bounds)
    return (low + high) / 2


def section(model: Model, camera: Camera) -> Lines:
    """In the plane through the middle that is seen as an upright line."""
    right, _, _ = _axes(camera)
    return Lines("section", NAME, plane=tuple(right), levels=[float(right @ _middle(model))])


def compose(
    picture: Any, model: Model, marks: PointSet, lines: Optional[LineSet], camera: Camera, style: Style, unit: str,
    context: Context,
) -> Any:  # fmt: skip
    """The picture with a section at its right and a scale bar below, in the ink of its contours."""
    from PIL import Image

    scale = _automatic.pixels_per_unit(camera, _middle(model))
    pen = max(1.0, max(camera.size) / 800)
    ink = tuple(round(255 * part) for part in style.silhouette_ink[:3])
    paper = tuple(round(255 * part) for part in style.paper)
    beside = None
    if lines is not None:
        profile = _profile(model, marks, lines, camera, scale, style, pen, context)
        beside = _filled(to_pil(profile.image()), style, pen)
    width, height = picture.size
    strip = round(max(_STRIP * max(width, height), _LEAST_STRIP * pen)) if unit else 0
    plate = Image.new("RGBA", (width + (beside.size[0] if beside else 0), height + strip), paper)
    plate.paste(picture, (0, 0))
    if beside is not None:
        plate.paste(beside, (width, 0))
    if unit:
        _draw_bar(plate, (width // 2, height + strip // 3), width, scale, unit, ink, pen)
    return plate


def vectors(
    drawing: Drawing, model: Model, marks: PointSet, lines: Optional[LineSet], camera: Camera, style: Style, unit: str,
    context: Context,
) -> Tuple[List[PageItem], List[Annotation], Tuple[float, float]]:  # fmt: skip
    """The same as drawings and annotations, in pixels, and how large it is."""
    scale = _automatic.pixels_per_unit(camera, _middle(model))
    pen = max(1.0, max(camera.size) / 800)
    width, height = drawing.size
    items, notes, full = [PageItem(drawing, name="view")], [], float(width)
    if lines is not None:
        profile = _profile(model, marks, lines, camera, scale, style, pen, context)
        items.append(PageItem(profile, full, name="profile"))
        notes += hatching(profile, (full, 0.0), pen, style)
        full += profile.size[0]
    strip = max(_STRIP * max(width, height), _LEAST_STRIP * pen) if unit else 0.0
    if unit:
        notes += bar((width / 2, height + strip / 3), width, scale, unit, style.silhouette_ink, pen)
    return items, notes, (full, height + strip)


def hatching(profile: Drawing, corner: Tuple[float, float], pen: float, style: Style) -> List[Annotation]:
    """Lines at 45 degrees inside the closed outlines of a drawing, whose corner is there."""
    outlines = [np.stack((s["window"][:, 0], s["window"][:, 1]), axis=1).astype(float) for s in profile.polylines()]
    lines = _cut_faces.hatched(_cut_faces.closed(outlines), 9.0 * pen)
    return [Annotation(line + corner, None, "section hatching", 0.7 * pen, style.silhouette_ink) for line in lines]


def bar(
    place: Tuple[float, float], width: float, scale: float, unit: str, ink: Tuple[float, ...], pen: float
) -> List[Annotation]:
    """A scale bar around a place, at most that much of the width; lengths are in pixels."""
    length = bar_length(_BAR * width / scale)
    thick, line, whole = 5.0 * pen, 0.8 * pen, length * scale
    left, top = place[0] - whole / 2, place[1]
    box = np.array(((0, 0), (whole, 0), (whole, thick), (0, thick), (0, 0))) + (left, top)
    notes = [Annotation(box, None, "scale bar", line, ink)]
    for i in (0, 2, 4):
        field = np.array(((i * whole / 5, thick / 2), ((i + 1) * whole / 5, thick / 2))) + (left, top)
        notes.append(Annotation(field, None, "scale bar", thick, ink))
    height = 11.0 * pen
    for at, text in ((left, "0"), (left + whole, f"{length:g} {unit}")):
        begin = at - 0.78 * height * len(text.split()[0]) / 2  # of digits of Helvetica
        notes.append(Annotation([[begin, top + 2.0 * thick + height]], text, "scale", height, ink))
    return notes


def _profile(
    model: Model, marks: PointSet, lines: LineSet, camera: Camera, scale: float, style: Style, pen: float,
    context: Context,
) -> Drawing:  # fmt: skip
    """A drawing of the section from its right side, at the scale and the height of the picture."""
    right, up, back = _axes(camera)
    middle = _middle(model)
    points = _automatic.positions(marks) - middle
    near = points[np.abs(points @ right) < 0.02 * np.abs(points @ right).max() + 1e-12]
    across = (near if len(near) else points) @ -back
    margin = 0.05 * camera.size[0]
    width = max(1, round((across.max() - across.min()) * scale + 2 * margin))
    height = camera.size[1]
    # Where the picture has the middle of the model, the section has it too.
    clip = np.asarray(camera.projection) @ np.asarray(camera.view) @ np.append(middle, 1.0)
    target = middle - (clip[1] / clip[3]) * (height / 2 / scale) * up - back * (across.max() + across.min()) / 2
    reach = 4.0 * float(np.linalg.norm(points, axis=1).max())
    side = Camera.look_at(target + reach * right, target, up)
    side = side.orthographic(height / scale, (width, height), 0.01 * reach, 2 * reach)
    # Whole: contours, which are not drawn here, would leave gaps by their halo, and ends by a taper, in it.
    outline = LineStyle("section", NAME, width=2.6 * pen, hidden="shown", taper=0.0, ink=style.silhouette_ink)
    blank = Style(layers=[LayerStyle(shown=False, contours=False)], lines=[outline], paper=style.paper, halo_width=0.0)
    return Renderer(context=context).draw(Item(marks, blank, line_set=lines), side)


def _filled(image: Any, style: Style, pen: float) -> Any:
    """Thin lines at 45 degrees inside closed outlines."""
    from PIL import Image, ImageDraw

    paper = np.round(255 * np.asarray(style.paper[:3]))
    line = np.abs(np.asarray(image.convert("RGB"), dtype=float) - paper).max(axis=2) > 64
    outside = Image.fromarray(np.pad(line.astype(np.uint8) * 255, 1)).copy()  # of its own, to be written
    ImageDraw.floodfill(outside, (0, 0), 128)
    inside = np.asarray(outside)[1:-1, 1:-1] == 0
    y, x = np.mgrid[: inside.shape[0], : inside.shape[1]]
    period, width = 9.0 * pen, 0.7 * pen
    away = np.abs(((x + y) / math.sqrt(2)) % period - period / 2)
    cover = np.clip(width / 2 + 0.5 - away, 0, 1) * inside
    pixels = np.asarray(image, dtype=float).copy()
    ink = 255 * np.asarray(style.silhouette_ink[:3])
    pixels[..., :3] += cover[..., None] * (ink - pixels[..., :3])
    pixels[..., 3] = np.maximum(pixels[..., 3], 255 * cover)
    return Image.fromarray(np.round(pixels).astype(np.uint8), "RGBA")


def bar_length(longest: float) -> float:
    """1, 2 or 5 times a power of ten, at most that long."""
    power = 10.0 ** math.floor(math.log10(longest))
    return next(step * power for step in (5.0, 2.0, 1.0) if step * power <= longest * (1 + 1e-9))


def _draw_bar(plate: Any, place: Tuple[int, int], width: int, scale: float, unit: str, ink: Any, pen: float) -> None:
    """Five fields, black and white in turn, around a place, and how long they are together."""
    from PIL import ImageDraw

    length = bar_length(_BAR * width / scale)
    draw = ImageDraw.Draw(plate)
    thick, line = 5.0 * pen, max(1, round(0.8 * pen))
    left, top = place[0] - length * scale / 2, place[1]
    for i in range(5):
        x = left + i * length * scale / 5
        box = (round(x), round(top), round(x + length * scale / 5), round(top + thick))
        draw.rectangle(box, fill=ink if i % 2 == 0 else None, outline=ink, width=line)
    font = _font(round(16 * pen))
    for at, text in ((left, "0"), (left + length * scale, f"{length:g} {unit}")):
        _, _, wide, _ = draw.textbbox((0, 0), text, font=font)
        begin = at - wide / 2 if text == "0" else at - draw.textbbox((0, 0), f"{length:g}", font=font)[2] / 2
        draw.text((begin, top + 1.8 * thick), text, font=font, fill=ink)


def _font(size: int) -> Any:
    from PIL import ImageFont

    for name in ("DejaVuSans.ttf", "Arial.ttf", "Helvetica.ttc"):
        try:
            return ImageFont.truetype(name, size)
        except OSError:
            continue
    return ImageFont.load_default()
