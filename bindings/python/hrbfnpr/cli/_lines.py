# SPDX-License-Identifier: MIT
"""Lines on the command line: contours and feature lines as curves."""
from __future__ import annotations

import argparse
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .. import shapes
from .._context import Context
from .._drawing_info import DrawingInfo
from .._line_set import Lines, LineSet, LineSetInfo
from .._line_style import LineStyle
from .._model import Model
from .._names import LINE_KINDS
from .._style import Style
from ._inputs import given
from ._progress import Reporter

_SHORT = {
    "suggestive": "suggestive_contour", "ridges": "ridge", "valleys": "valley", "apparent": "apparent_ridge",
    "contours": "contour", "isophotes": "isophote", "sections": "section", "borders": "border", "creases": "crease",
}  # fmt: skip
NAMES = (
    "contour", "suggestive", "ridges", "valleys", "apparent", "parabolic", "isophotes", "section", "border", "crease",
)  # fmt: skip
_FOUND_ONCE = ("ridge", "valley", "parabolic")
# Options that mean something to contours of marks only: given, these are drawn unless --lines is given too.
_OF_MARKS = ("silhouette_threshold", "silhouette_law", "silhouette_width", "silhouette_radius", "contours_of")
_HIDDEN = {"attenuate": "attenuated", "hide": "none", "show": "shown"}
# Of every line's style.
_LAWS = ("outline_factor", "far_factor", "lit_factor", "curvature_factor", "wobble")
# Holes between samples that are not even stay closed.
_OPEN = 3.0
# What is drawn finer than contours, as a share of their width.
_FINE = 0.6
# Edges of a mesh that are shorter than the first, on average, are facets but for those longer than the second; of the
# diagonal.
_MEAN_EDGE = 0.05
_LONG_EDGE = 0.06


class Wanted(NamedTuple):
    """One kind of lines, and what was said of it: an axis and a number of planes, or levels."""

    kind: str
    axis: int = 2
    planes: int = 10
    levels: Tuple[float, ...] = (0.25, 0.5, 0.75)


def parse(text: str) -> List[Wanted]:
    """contour,suggestive,ridges,section=z:20,isophotes=0.3:0.6 ...; none for no lines."""
    if text == "none":
        return []
    return [_parse_one(part) for part in text.split(",")]


def _parse_one(part: str) -> Wanted:
    name, _, value = part.partition("=")
    kind = _SHORT.get(name, name).replace("-", "_")
    if kind not in LINE_KINDS or kind == "own":
        raise argparse.ArgumentTypeError(f"{name!r} is no kind of lines; there are {', '.join(NAMES)} and none")
    if not value:
        return Wanted(kind)
    try:
        if kind == "section":
            axis, _, count = value.partition(":")
            if axis not in ("x", "y", "z") or int(count) < 1:
                raise ValueError
            return Wanted(kind, "xyz".index(axis), int(count))
        if kind == "isophote":
            return Wanted(kind, levels=tuple(float(level) for level in value.split(":")))
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"{part!r} is not understood; write section=z:20 or isophotes=0.3:0.6")


def style_lines(arguments: Any, style: Style, pen: float) -> None:
    """Set the lines of a style: its own or those asked for, sized for the picture."""
    contour = next((line for line in style.lines if line.kind == "contour"), LineStyle("contour", width=2.2))
    if arguments.lines is not None:
        style.lines = [line for wanted in arguments.lines for line in _styles_of(wanted, contour)]
    elif any(getattr(arguments, option) is not None for option in _OF_MARKS):
        style.lines = []
    has_border = any(line.kind == "border" for line in style.lines)
    if arguments.lines is None and style.lines and not has_border and getattr(arguments, "has_end", False):
        style.lines = [*style.lines, *_styles_of(Wanted("border"), contour)]
    wider = 1.0 if arguments.line_width is None else arguments.line_width / (pen * contour.width)
    for line in style.lines:
        if arguments.hidden is not None or arguments.hidden_lines is not None:
            line.hidden = arguments.hidden or _HIDDEN[arguments.hidden_lines.replace("-", "_")]
        for field, value in given(arguments, _LAWS).items():
            setattr(line, field, value)
        if arguments.wobble is not None:
            line.wobble_width = min(1.0, 0.5 * arguments.wobble)
        line.scale(wider * pen)


def _styles_of(wanted: Wanted, contour: LineStyle) -> List[LineStyle]:
    if wanted.kind == "contour":
        return [contour.copy()]
    levels = wanted.levels if wanted.kind == "isophote" else ()
    share = 1.0 if wanted.kind in ("border", "crease") else _FINE
    taper = 0.0 if wanted.kind in ("border", "crease", "section") else contour.taper
    # Creases are the model's own, or those of the mesh that a smooth one was fitted to.
    names = [("crease", None), ("own", "crease")] if wanted.kind == "crease" else [(wanted.kind, None)]
    return [
        LineStyle(kind, name, levels, width=contour.width * share, hidden=contour.hidden, taper=taper)
        for kind, name in names
    ]


def needs_curvature(style: Style) -> bool:
    """Whether the line set of a style must hold curvatures."""
    return any(line.kind in ("suggestive_contour", "apparent_ridge", "isophote") for line in style.lines)


def make(
    arguments: Any, model: Model, style: Style, context: Context, report: Reporter, more: Sequence[Lines] = ()
) -> Optional[LineSet]:
    """The line set that a style's lines want, with some more lines; None if it has none."""
    if style.visibility == "published" or not (style.lines or more):
        return None
    wanted = wanted_lines(arguments, style)
    once = [_once(one, model) for one in wanted if one.kind in (*_FOUND_ONCE, "section")]
    own: Optional[List[Lines]] = getattr(arguments, "own_lines", None)  # of settings that were read
    if own is not None and arguments.lines is None:
        once = list(own)
    arguments.made_lines = tuple(once)
    once += more
    sharp = any(one.kind == "crease" for one in wanted)
    of_mesh = _edges_of_mesh(arguments) if sharp and _has_faces(arguments) else []
    curved = needs_curvature(style)
    support = _support(arguments, wanted, model)
    with report.stage("trace lines", "looking for lines") as stage:
        size = (getattr(arguments, "own_line_set", None) or {}).get("cell_size", 0.0)
        keywords = dict(with_curvature=curved, support=support, cell_size=size, progress=stage.bar, context=context)
        made = LineSet(model, [*once, *of_mesh], **keywords)
        if made.info.creases and of_mesh:
            made = LineSet(model, once, **keywords)
        info = made.info
        stage.says = f"on {info.triangles} triangles, {info.lines} lines found once"
    if sharp and not (_has_faces(arguments) or info.creases):
        raise shapes.ShapeError("creases come from a mesh, or from a model with edges; this file has neither")
    if support > 0:
        report.say(_what_ends(info, support))
    if info.turned > 2e-3 * info.triangles or info.missed_seeds:
        report.warn(
            f"the surface is thinner than the cells that lines are looked for in ({info.turned} of {info.triangles} "
            f"triangles look away, {info.missed_seeds} samples are missed): lines may be missing there"
        )
    return made


def wanted_lines(arguments: Any, style: Style) -> List[Wanted]:
    """Those asked for, or what a named style draws beside contours, as far as it can be had."""
    if arguments.lines is not None:
        return list(arguments.lines)
    by_settings = getattr(arguments, "own_line_set", None) is not None
    kinds = (*_FOUND_ONCE, "section") if by_settings else _FOUND_ONCE
    wanted = [Wanted(line.kind) for line in style.lines if line.kind in kinds]
    if by_settings:
        return wanted
    if any(line.name == "crease" for line in style.lines) and _has_faces(arguments):
        wanted.append(Wanted("crease"))
    return wanted


def _support(arguments: Any, wanted: Sequence[Wanted], model: Model) -> float:
    """Whoever wants a border wants it where the samples end; a trimmed model has its own."""
    if arguments.support is not None:
        return float(arguments.support)
    if "support" in (getattr(arguments, "own_line_set", None) or {}):
        return float(arguments.own_line_set["support"])
    if model.trim_info.is_trimmed:
        return 0.0
    return _OPEN if any(one.kind == "border" for one in wanted) else 0.0


def _what_ends(info: LineSetInfo, support: float) -> str:
    if info.borders == 0:
        return f"lines: the surface ends nowhere within support {support:g}"
    curves = "1 border" if info.borders == 1 else f"{info.borders} borders"
    share = f"{100 * info.left_out:.1f} % of it is left out"
    return f"lines: the surface ends beyond its samples, at {curves} (support {support:g}); {share}"


def _has_faces(arguments: Any) -> bool:
    return bool(arguments.input_shape and arguments.input_shape.is_mesh)


def _once(wanted: Wanted, model: Model) -> Lines:
    if wanted.kind == "section":
        low, high = (corner[wanted.axis] for corner in model.bounds)
        places = low + (high - low) * (np.arange(wanted.planes) + 0.5) / wanted.planes
        return Lines("section", levels=list(places), plane=np.eye(3)[wanted.axis])
    return Lines(wanted.kind)


def creases(shape: Any, angle: float = 30.0) -> Sequence[Any]:
    """Edges of a mesh where faces meet at more than an angle, joined to polylines."""
    if shape is None or not shape.is_mesh:
        raise shapes.ShapeError("creases come from a mesh; this file has no faces")
    points, index = np.unique(shape.points, axis=0, return_inverse=True)
    faces = index.reshape(-1)[shape.triangles]
    normals = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    beside: "dict[Tuple[int, int], List[int]]" = {}
    for number, face in enumerate(faces.tolist()):
        for a, b in zip(face, (*face[1:], face[0])):
            beside.setdefault((min(a, b), max(a, b)), []).append(number)
    limit = float(np.cos(np.radians(angle)))
    sharp = [edge for edge, two in beside.items() if len(two) == 2 and normals[two[0]] @ normals[two[1]] < limit]
    return [points[line] for line in _chains(sharp)]


def _edges_of_mesh(arguments: Any) -> List[Lines]:
    """All that were asked for; what a named style draws by itself, without the facets of rounded shapes."""
    found = creases(arguments.input_shape)
    if arguments.lines is None:
        found = without_facets(found, float(np.linalg.norm(np.ptp(arguments.input_shape.points, axis=0))))
    return [Lines("own", "crease", polylines=found)] if len(found) else []


def without_facets(edges: Sequence[Any], diagonal: float) -> Sequence[Any]:
    """Of a mesh most of whose edges are short these are facets of a rounded shape: the long ones are left."""
    lengths = np.array([np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in edges])
    if len(edges) == 0 or lengths.mean() > _MEAN_EDGE * diagonal:
        return edges
    return [line for line, length in zip(edges, lengths) if length > _LONG_EDGE * diagonal]


def _chains(edges: Sequence[Tuple[int, int]]) -> List[List[int]]:
    """Edges that follow each other as lines: through vertices of two edges, from corners first."""
    around: "dict[int, List[int]]" = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    left = {frozenset(edge) for edge in edges}
    lines: List[List[int]] = []
    starts = [v for v, others in around.items() if len(others) != 2] + list(around)
    for start in starts:
        for other in around[start]:
            if frozenset((start, other)) not in left:
                continue
            line = [start, other]
            left.remove(frozenset(line))
            while len(around[line[-1]]) == 2:
                after = next((v for v in around[line[-1]] if frozenset((line[-1], v)) in left), None)
                if after is None:
                    break
                left.remove(frozenset((line[-1], after)))
                line.append(after)
            lines.append(line)
    return lines


def doubts(info: DrawingInfo) -> List[str]:
    """What of a drawing's lines is not as sure as the rest."""
    counts = (
        (info.line_broken, "curves that end inside the surface, or were missed; more samples there would help"),
        (info.line_contradictions, "lines of which a part may be drawn where it is hidden, or the other way round"),
        (info.line_tangles, "places of the picture with so many crossings of lines that none was taken"),
    )
    return [f"{what}: {count}" for count, what in counts if count > 0]
