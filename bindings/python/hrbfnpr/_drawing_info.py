# SPDX-License-Identifier: MIT
"""What a drawing is made of, as plain data."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, ClassVar, List, Tuple

from ._arrays import Array
from ._names import CLASSES, LINE_KINDS, SHAPES, name_of
from ._numpy import np
from ._point_set_info import kind_name, text
from ._structs import read_struct


@dataclass(frozen=True)
class DrawingInfo:
    """What a drawing holds, and what making it did.

    Attributes
    ----------
    items, layers : int
        Items drawn; layers of the drawing, of one ink and one class each.
    dots, strokes, stroke_points : int
        Of ink; points of all strokes.
    marks, outside : int
        Marks of the layers that the styles use, and those outside the frustum.
    front, back, silhouette : int
        Those inside, by class.
    culled : int
        Marks of no class: no tone or contour could show them.  Only with depth layers.
    shown : int
        Marks drawn as ink.
    dropped_tone, dropped_depth, dropped_zoom, dropped_hidden : int
        Marks that are not shown, by reason.
    splats : int
        Discs of paper (visibility "published"), or marks that depth layers were found from.
    nanoseconds_classify, nanoseconds_visibility, nanoseconds_sort : int
    bytes, scratch_bytes : int
        Kept by the drawing, and by its renderer.
    line_curves, line_cusps, line_crossings : int
        Curves that lines were drawn from, their cusps, and crossings where the farther one changes its visibility.
    line_broken : int
        Curves that end inside the surface, and places where one was missed.
    line_settled, line_contradictions : int
        Curves whose visibility did not add up, so that each part is as a ray of its own says; of these, those with
        a ray that was not certain.
    nanoseconds_lines : int
    line_refined : int
        Curves whose visibility did not add up at first: they, and those that cross them, were made finer.
    line_tangles : int
        Cells of the image, four pixels wide or more, with so many crossings that none was taken: lines run to and
        fro over one another there, as on a flat face seen edge-on.
    """

    items: int
    layers: int
    dots: int
    strokes: int
    stroke_points: int
    marks: int
    outside: int
    front: int
    back: int
    silhouette: int
    culled: int
    shown: int
    dropped_tone: int
    dropped_depth: int
    dropped_zoom: int
    dropped_hidden: int
    splats: int
    nanoseconds_classify: int
    nanoseconds_visibility: int
    nanoseconds_sort: int
    bytes: int
    scratch_bytes: int
    line_curves: int
    line_cusps: int
    line_crossings: int
    line_broken: int
    line_settled: int
    line_contradictions: int
    nanoseconds_lines: int
    line_refined: int
    line_tangles: int


@dataclass(frozen=True)
class DrawingLayerInfo:
    """A layer of a drawing: ink of one layer of marks, of the front or of contours.

    Attributes
    ----------
    mark_class : {"front", "silhouette"}
    item, layer : int
        Number of the item, and of the layer of its point set; -1: of lines.
    kind, name : str
        Of that layer, or the kind of lines and the name in their style.
    shape : {"dots", "strokes", "hatch"}
    ink : tuple of float
        Straight RGBA.
    dots, strokes : int
    """

    mark_class: str
    item: int
    layer: int
    kind: str
    shape: str
    name: str
    ink: Tuple[float, float, float, float]
    dots: int
    strokes: int
    _lines: ClassVar[Callable[[], List[Array]]]

    @property
    def polylines(self) -> List[Array]:
        """Its strokes, far to near: float32 (n, 2) each, pixel x and y; with more of them by `Drawing.polylines`."""
        return [np.array(line["window"][:, :2]) for line in self._lines()]


@dataclass(frozen=True)
class MarkIdentity:
    """The mark that an id stands for.

    Attributes
    ----------
    id : int
    item, layer, mark : int
        Number of the item, of the layer of its point set, and of the mark in that layer.
    stroke, place : int
        Number of its stroke, -1 for none, and its place along it.
    """

    id: int
    item: int
    layer: int
    mark: int
    stroke: int
    place: int


def read_drawing_layer(struct: Any) -> DrawingLayerInfo:
    """From a filled hrbfnpr_drawing_layer_info."""
    convert = {
        "mark_class": lambda number: name_of(CLASSES, number),
        "shape": lambda number: name_of(SHAPES, number),
        "kind": (lambda number: name_of(LINE_KINDS, number)) if struct.layer < 0 else kind_name,
        "name": text,
    }
    return read_struct(DrawingLayerInfo, struct, convert)
