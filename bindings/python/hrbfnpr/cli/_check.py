# SPDX-License-Identifier: MIT
"""Looks at a file without drawing it."""
from __future__ import annotations

import dataclasses
import json
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Tuple

import numpy as np

from .. import shapes
from .._context import Context
from .._errors import Error
from .._mesh import Mesh
from .._model import Model
from .._orient import orient
from .._sources import load_saved
from .._values import words_of
from ..shapes import Shape, ShapeError
from ..shapes._shape import Floats
from . import _looks

FINE, WARNINGS, UNUSABLE = 0, 1, 2  # exit status
_METRES = ("GLB", "glTF", "LAS", "LAZ", "E57")
_FAR = 1e5  # distance of the origin over the size from which floats lose the shape
_FEW = 10  # samples with which a surface is a guess
_SAMPLES = 1000  # of a mesh, to see which way it looks


def of(count: int, what: str) -> str:
    """A number of things."""
    return f"{count} {what}" + ("" if count == 1 else "s")


def _has_normals(shape: Shape) -> bool:
    """Whether points have normals, others than zeros."""
    return shape.normals is not None and bool(np.any(np.nan_to_num(shape.normals)))


def _finite_faces(shape: Shape) -> Shape:
    """Without the faces that cannot be used."""
    if not shape.is_mesh:
        return shape
    assert shape.triangles is not None
    finite = np.isfinite(shape.points[shape.triangles]).all(axis=(1, 2))
    if not finite.any():
        raise ShapeError("no face has three corners that are finite")
    return shape if finite.all() else replace(shape, triangles=shape.triangles[finite])


class Findings:
    """What is reported; keys are those of the JSON."""

    def __init__(self, path: Path) -> None:
        self.facts: Dict[str, Any] = {"file": str(path), "status": "fine"}
        self.repairs: List[str] = []
        self.warnings: List[str] = []
        self.errors: List[str] = []
        self.advice: List[str] = []

    def warn(self, what: str, advice: str = "") -> None:
        self.warnings.append(what)
        if advice and advice not in self.advice:
            self.advice.append(advice)

    @property
    def status(self) -> int:
        return UNUSABLE if self.errors else WARNINGS if self.warnings else FINE

    def as_dict(self) -> Dict[str, Any]:
        self.facts["status"] = ("fine", "warnings", "unusable")[self.status]
        lists = {"repairs": self.repairs, "warnings": self.warnings, "errors": self.errors, "advice": self.advice}
        return {**self.facts, **lists}


def check(path: Path, as_json: bool, context: Context) -> int:
    """Report on a file.

    Returns
    -------
    int
        0 if it can be drawn as it is, 1 with warnings, 2 if it cannot be used.
    """
    findings = Findings(path)
    try:
        _look(path, findings, context)
    except (Error, OSError, ValueError) as error:
        findings.errors.append(words_of(error).replace(f"{path}: ", "", 1))
    facts = findings.as_dict()
    if as_json:
        print(json.dumps(_finite(facts), indent=2))
    else:
        _print(facts)
    return findings.status


def _look(path: Path, findings: Findings, context: Context) -> None:
    saved = load_saved(path, context)
    if saved is not None:
        kind = "model" if isinstance(saved, Model) else "point set"
        count = saved.info.centres if isinstance(saved, Model) else len(saved)
        findings.facts.update(format=f"saved {kind}", kind=kind, points=count)
        return
    shape = shapes.read(path)
    findings.facts.update(
        format=shape.format,
        kind="mesh" if shape.is_mesh else "points",
        points=len(shape.points),
        triangles=0 if shape.triangles is None else len(shape.triangles),
        columns=list(shape.columns),
        normals=shape.normals is not None,
    )
    findings.facts["notes"] = list(shape.notes)
    of_camera = shape.image_shape is not None and not _has_normals(shape)
    shape = shape if of_camera else _without_far(shape, findings)
    points = _places(shape, findings)
    try:
        if of_camera:
            samples, normals = _picture(shape, findings, context)
        else:
            samples, normals = _mesh(shape, findings) if shape.is_mesh else _cloud(shape, points, findings)
    except ShapeError as error:
        findings.errors.append(str(error))
        return
    up, why = _looks.choose(shape, samples, normals)
    findings.facts.update(up=_looks.name(up), up_reason=why)


def _without_far(shape: Shape, findings: Findings) -> Shape:
    """Without what stands for no data, and a few points far away, as draw leaves them out."""
    shape, empty, value = _looks.without_data(shape)
    if empty:
        findings.repairs.append(f"{of(empty, 'point')} at {value:g}, which stands for no data, left out")
    if shape.is_mesh:
        return shape
    shape, far = _looks.without_strays(shape)
    if far:
        findings.repairs.append(f"{of(far, 'point')} far from all others left out")
    return shape


def _places(shape: Shape, findings: Findings) -> Floats:
    """The usable positions; facts about them."""
    finite = np.isfinite(shape.points).all(axis=1)
    points = shape.points[finite]
    findings.facts["points_not_finite"] = int((~finite).sum())
    if len(points) == 0:
        raise ShapeError("no point is finite")
    low, high = points.min(axis=0), points.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    unit = "metres" if shape.format in _METRES else "unknown"
    findings.facts.update(bounds_min=low.tolist(), bounds_max=high.tolist(), diagonal=diagonal, unit=unit)
    if not finite.all() and not shape.is_mesh and not shape.is_picture:
        findings.repairs.append(f"{of(int((~finite).sum()), 'point')} without a finite position left out")
        findings.warn(f"{of(int((~finite).sum()), 'position')} not finite")
    if diagonal == 0:
        findings.warn(
            "all points are at one place: there is no surface to draw", "look for the scale in the program it is from"
        )
    elif float(np.abs((low + high) / 2).max()) > _FAR * diagonal:
        findings.warn(
            "it is very far from the origin for its size: single precision loses its details",
            "move it near to the origin, in double precision",
        )
    return points


def _picture(shape: Shape, findings: Findings, context: Context) -> Tuple[Floats, Floats]:
    """What draw makes of one: points without noise, with normals."""
    assert shape.image_shape is not None
    (rows, columns), (seen, info) = shape.image_shape, _looks.smoothed(shape, context)
    assert seen.normals is not None
    noise = _looks.noise_of(info)
    findings.facts.update(
        image_rows=rows, image_columns=columns, image_seen=info.seen, image_depth=info.depth, image_noise=noise
    )
    findings.repairs.append(
        f"the picture of a depth camera smoothed over {info.radius:.1f} pixels where the depth is {info.depth:.3g}, where "
        f"its noise is {noise:.2g}; normals made"
    )
    if info.left_out:
        findings.repairs.append(f"{of(info.left_out, 'pixel')} on no surface left out")
    return seen.points, seen.normals


def _cloud(shape: Shape, points: Floats, findings: Findings) -> Tuple[Floats, Floats]:
    finite = np.isfinite(shape.points).all(axis=1)
    findings.facts["along_curves"] = _looks.along_curves(shape.points[finite])
    repeated = len(points) - len(np.unique(points, axis=0))
    findings.facts["duplicates"] = repeated
    if repeated:
        findings.repairs.append(f"{of(repeated, 'point')} at the place of another merged, where their normals agree")
    if not _has_normals(shape):
        why = "there are none" if shape.normals is None else "all are zero"
        findings.repairs.append(f"normals made, as {why}")
        findings.warn("the points have no normals", "nothing: they are made; those of the scanner are surer")
        return points, np.zeros_like(points)
    assert shape.normals is not None
    length = np.linalg.norm(shape.normals, axis=1)
    bad = int((~np.isfinite(length)).sum())
    zero = int((length == 0).sum())
    usable = finite & np.isfinite(length) & (length > 0)
    unit = float((np.abs(length[usable] - 1) < 1e-3).mean()) if usable.any() else 0.0
    findings.facts.update(normals_zero=zero, normals_not_finite=bad, normals_unit_share=unit)
    if zero or bad:
        findings.repairs.append(f"{of(zero + bad, 'point')} without a usable normal left out")
        findings.warn(f"{of(zero, 'normal')} zero, {bad} not finite")
    if not usable.any():
        raise ShapeError("no point is finite and has a normal that is not zero")
    if unit < 1:
        findings.repairs.append(f"{of(round((1 - unit) * int(usable.sum())), 'normal')} made of length 1")
    if usable.sum() < _FEW:
        findings.warn(f"there are {of(int(usable.sum()), 'point')} only: the surface between them is a guess")
    points, normals = shape.points[usable], shape.normals[usable] / length[usable, None]
    points, normals, joined, opposite = _looks.agreed(points, normals)
    if joined:
        findings.repairs.append(f"{of(joined, 'place')} with several normals: their mean is used")
    if opposite:
        findings.warn(f"{of(opposite, 'place')} with opposite normals, left out")
    if len(points) == 0:
        raise ShapeError("all points are in pairs with opposite normals")
    if findings.facts["along_curves"]:
        _orientation_of_curves(points, normals, findings)
    else:
        _orientation(points, normals, False, findings)
    return points, normals


def _orientation_of_curves(points: Floats, normals: Floats, findings: Findings) -> None:
    """By the library: of points along curves neighbours and winding numbers tell nothing."""
    info = orient(points, normals, "given").info
    words = {"given": "outward", "none": "none"}.get(info.found, "inward" if info.found == "inward" else "mixed")
    findings.facts["normals_look"] = words
    if words != "outward":
        findings.repairs.append(f"normals repaired: they are {_looks.FOUND[info.found]}")
        findings.warn(f"the normals are {_looks.FOUND[info.found]}", "nothing: --normals keep leaves them")


def _orientation(points: Floats, normals: Floats, mesh: bool, findings: Findings) -> None:
    found = _looks.look(points, normals, mesh)
    words = "inward" if found.inward else "mixed" if found.mixed else "outward"
    if words == "outward" and found.closed <= -_looks.INWARD:
        words = "open"
    findings.facts.update(
        normals_look=words, normals_closed=round(found.closed, 3), normals_flipped_share=round(found.flipped, 4)
    )
    if found.inward:
        findings.repairs.append("all normals turned, as they look inward")
        findings.warn("all normals look inward", "nothing: they are turned; --normals keep leaves them")
    axis = _looks.hangs(points, normals)
    if axis is not None:
        findings.repairs.append("all normals turned, as a terrain looks up")
        findings.warn(
            f"the surface is a terrain that looks down along {axis}", "nothing: it is turned; --normals keep leaves it"
        )
    for doubt in _looks.doubts(found, len(points), mesh):
        what, _, advice = doubt.rpartition(": ")
        findings.warn(what, advice)


def _mesh(shape: Shape, findings: Findings) -> Tuple[Floats, Floats]:
    facts = shapes.mesh_facts(shape)
    findings.facts["mesh"] = dataclasses.asdict(facts)
    findings.facts["duplicates"] = facts.joined_vertices
    for count, what in (
        (facts.joined_vertices, "vertices at the place of another joined"),
        (facts.degenerate_triangles, "triangles without area left out"),
        (facts.unused_vertices, "vertices of no face left out"),
    ):
        if count:
            findings.repairs.append(f"{count} {what}")
    if facts.faces_not_finite:
        findings.repairs.append(f"{of(facts.faces_not_finite, 'face')} with a corner that is not finite left out")
        findings.warn(f"{of(facts.faces_not_finite, 'face')} with a corner that is not finite")
    if facts.inside_out:
        findings.repairs.append("all faces turned, as the mesh is inside out")
        findings.warn("the mesh is inside out", "nothing: its faces are turned")
    elif facts.parts_inside_out:
        findings.warn(
            f"{facts.parts_inside_out} of {facts.components} parts are inside out, or cavities",
            "unless they are cavities, turn their faces in MeshLab (Re-orient all faces coherently) or Blender "
            "(Recalculate outside)",
        )
    if facts.boundary_edges:
        findings.warn(
            f"it is open: {of(facts.holes, 'border')} of {of(facts.boundary_edges, 'edge')}",
            "nothing: what is drawn ends at wide borders, with a line, and closes small holes; --close closes all",
        )
    if facts.non_manifold_edges:
        left, twice = _never_parted(shape, facts.non_manifold_edges)
        if left < facts.non_manifold_edges:
            how = "mended, as faces that are there twice are left out" if twice else "parted, as solids touch there"
            findings.repairs.append(f"{of(facts.non_manifold_edges - left, 'edge')} of more than two triangles {how}")
        if left:
            findings.warn(f"{of(left, 'edge')} of more than two triangles", "nothing, if the picture is right")
    if facts.inconsistent_edges:
        findings.warn(
            f"{of(facts.inconsistent_edges, 'edge')} between triangles that look to opposite sides",
            "turn faces in MeshLab (Re-orient all faces coherently) or Blender (Recalculate outside)",
        )
    if facts.components > 1:
        findings.warn(
            f"it has {facts.components} parts",
            "nothing: those that cross, or are close to others, are drawn as surfaces of their own, and parts inside others "
            "are left out; --parts all keeps them",
        )
    good = _finite_faces(shape)
    points, normals = shapes.samples(good, _SAMPLES)
    _orientation(points, normals, True, findings)
    return points, normals


def _never_parted(shape: Shape, most: int) -> Tuple[int, int]:
    """Edges of more than two triangles that a fit has, too, and faces that it leaves out as they are there twice."""
    good = _finite_faces(shape)
    try:
        with Context() as silent:
            info = Mesh(good.points, good.triangles, parts="all", context=silent).info
        return info.nonmanifold_edges, info.repeated_faces
    except Error:
        return most, 0


def _finite(value: Any) -> Any:
    """JSON has no NaN."""
    if isinstance(value, float):
        return value if np.isfinite(value) else None
    if isinstance(value, dict):
        return {key: _finite(one) for key, one in value.items()}
    return [_finite(one) for one in value] if isinstance(value, list) else value


def _print(facts: Dict[str, Any]) -> None:
    """The same for people."""
    lists = ("notes", "repairs", "warnings", "errors", "advice")
    for name, value in facts.items():
        if name in (*lists, "status"):
            continue
        if isinstance(value, dict):
            print(f"{name}:")
            for inner, one in value.items():
                print(f"  {inner.replace('_', ' ')}: {_word(one)}")
        else:
            print(f"{name.replace('_', ' ')}: {_word(value)}")
    for name, words in (("notes", "note"), ("repairs", "repaired by the fit"), ("warnings", "warning"),
                        ("errors", "error"), ("advice", "what to do")):  # fmt: skip
        for text in facts.get(name, ()):
            print(f"{words}: {text}")
    print(f"status: {facts['status']}")


def _word(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return " ".join(_word(one) for one in value)
    return str(value)
