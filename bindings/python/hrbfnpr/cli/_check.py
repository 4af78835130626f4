# SPDX-License-Identifier: MIT
"""The command check: examines a file without drawing it."""
from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any, Dict, List

import numpy as np

from .. import shapes
from .._context import Context
from .._errors import Error
from .._inspect import inspect
from .._library import ffi, lib
from .._model import Model
from .._sources import load_saved
from .._values import words_of
from ..shapes import Shape
from ..shapes._facts import facts_of

FINE, WARNINGS, UNUSABLE = 0, 1, 2  # exit statuses
_IN_METRES = ("GLB", "glTF", "LAS", "LAZ", "E57")  # formats whose unit is the metre
_LOOKS = ("", "outward", "inward", "mixed", "open", "none")  # words for HRBFNPR_NORMALS_LOOK_*, by value


class Findings:
    """The report on a file.  The keys of `facts` are also the keys of the JSON."""

    def __init__(self, path: Path) -> None:
        self.facts: Dict[str, Any] = {"file": str(path), "status": "fine"}
        self.repairs: List[str] = []
        self.warnings: List[str] = []
        self.errors: List[str] = []
        self.advice: List[str] = []
        self.details: Dict[str, str] = {}  # explains texts of the lists above; not in the JSON

    @property
    def status(self) -> int:
        return UNUSABLE if self.errors else WARNINGS if self.warnings else FINE

    def as_dict(self) -> Dict[str, Any]:
        self.facts["status"] = ("fine", "warnings", "unusable")[self.status]
        lists = {"repairs": self.repairs, "warnings": self.warnings, "errors": self.errors, "advice": self.advice}
        return {**self.facts, **lists}


def check(path: Path, as_json: bool, context: Context, verbose: bool = False) -> int:
    """Print a report on a file.

    Returns
    -------
    int
        The exit status: 0 if the file can be drawn as it is, 1 with warnings, 2 if it cannot be used.
    """
    findings = Findings(path)
    try:
        _examine(path, findings, context)
    except (Error, OSError, ValueError) as error:
        findings.errors.append(words_of(error).replace(f"{path}: ", "", 1))
    facts = findings.as_dict()
    if as_json:
        print(json.dumps(_without_nan(facts), indent=2))
    else:
        _print(facts, findings.details if verbose else {})
    return findings.status


def _examine(path: Path, findings: Findings, context: Context) -> None:
    """Add the contents of the file, and the notes of the library about it, to the findings."""
    facts = findings.facts
    saved = load_saved(path, context)
    if saved is not None:
        kind = "model" if isinstance(saved, Model) else "point set"
        count = saved.info.centres if isinstance(saved, Model) else len(saved)
        facts.update(format=f"saved {kind}", kind=kind, points=count)
        return
    shape = shapes.read(path)
    facts.update(
        format=shape.format,
        kind="mesh" if shape.is_mesh else "points",
        points=len(shape.points),
        triangles=0 if shape.triangles is None else len(shape.triangles),
        columns=list(shape.columns),
        normals=shape.normals is not None,
        notes=list(shape.notes),
    )
    if shape.radii is not None:
        low, high = (shape.points - shape.radii[:, None]).min(axis=0), (shape.points + shape.radii[:, None]).max(axis=0)
        facts.update(kind="balls", bounds_min=low.tolist(), bounds_max=high.tolist())
        facts.update(diagonal=float(np.linalg.norm(high - low)), unit=shape.unit or "unknown")
        facts.update(radii=[float(shape.radii.min()), float(shape.radii.max())])
        return
    info, notes = inspect(shape, lib.HRBFNPR_WORDING_OPTIONS, context)
    for note in notes:
        lists = {"note": findings.repairs, "warning": findings.warnings, "failure": findings.errors}
        lists[note.severity].append(str(note))
        if note.detail:
            findings.details[str(note)] = note.detail
        if note.advice and note.advice not in findings.advice:
            findings.advice.append(note.advice)
    facts.update(_facts(shape, info))


def _facts(shape: Shape, info: Any) -> Dict[str, Any]:
    """The facts about a shape, without those that were not examined or do not apply."""
    facts: Dict[str, Any] = {"points_not_finite": info.points_not_finite}
    if info.points_not_finite >= info.points - info.no_data - info.strays:
        return facts
    unit = shape.unit or ("metres" if shape.format in _IN_METRES else "unknown")
    facts.update(
        bounds_min=list(info.bounds_min), bounds_max=list(info.bounds_max), diagonal=info.diagonal, unit=unit
    )
    if info.image_seen:
        rows, columns = shape.image_shape or (0, 0)
        facts.update(image_rows=rows, image_columns=columns)
        facts.update({name: getattr(info, name) for name in ("image_seen", "image_depth", "image_noise")})
    elif shape.is_mesh:
        facts.update(mesh=dataclasses.asdict(facts_of(info)), duplicates=info.duplicates)
    else:
        facts.update(along_curves=bool(info.along_curves), duplicates=info.duplicates)
        if info.has_normals:
            names = ("normals_zero", "normals_not_finite", "normals_unit_share")
            facts.update({name: getattr(info, name) for name in names})
    if info.normals_look:
        facts["normals_look"] = _LOOKS[info.normals_look]
        if not info.along_curves:
            facts.update(
                normals_closed=round(info.normals_closed, 3), normals_flipped_share=round(info.normals_flipped_share, 4)
            )
    reason = ffi.string(info.up_reason).decode()
    return {**facts, "up": _axis_name(list(info.up)), "up_reason": reason} if reason else facts


def _axis_name(up: List[float]) -> str:
    """The name of an axis, such as x or -x, or the three numbers of another direction."""
    for i, axis in enumerate("xyz"):
        if abs(up[i]) == sum(abs(part) for part in up):
            return axis if up[i] > 0 else f"-{axis}"
    return ",".join(f"{part:g}" for part in up)


def _without_nan(value: Any) -> Any:
    """A value with None for NaN and infinities, which JSON does not have."""
    if isinstance(value, float):
        return value if np.isfinite(value) else None
    if isinstance(value, dict):
        return {key: _without_nan(one) for key, one in value.items()}
    return [_without_nan(one) for one in value] if isinstance(value, list) else value


def _print(facts: Dict[str, Any], details: Dict[str, str]) -> None:
    """Print the facts as lines of text, each with its entry in `details` if it has one."""
    lists = ("notes", "repairs", "warnings", "errors", "advice")
    for name, value in facts.items():
        if name in (*lists, "status"):
            continue
        if isinstance(value, dict):
            print(f"{name}:")
            for inner, one in value.items():
                print(f"  {inner.replace('_', ' ')}: {_text(one)}")
        else:
            print(f"{name.replace('_', ' ')}: {_text(value)}")
    for name, words in (("notes", "note"), ("repairs", "repaired by the fit"), ("warnings", "warning"),
                        ("errors", "error"), ("advice", "what to do")):  # fmt: skip
        for text in facts.get(name, ()):
            print(f"{words}: {text}")
            if text in details:
                print(f"    {details[text]}")
    print(f"status: {facts['status']}")


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return " ".join(_text(one) for one in value)
    return str(value)
