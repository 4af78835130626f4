# SPDX-License-Identifier: MIT
"""Names for the library's constants: in Python, every choice is a lower-case string."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Tuple

from ._library import ffi, lib

TABLE: Any = json.loads(Path(__file__).with_name("_records.json").read_text(encoding="utf-8"))
"""What bindings/generate made from the header for this package; see `_records.py`."""

NAMES: Dict[str, Dict[str, int]] = TABLE["names"]
"""For each prefix of constants, without HRBFNPR_: their names and numbers."""


INSTRUCTION_SETS = NAMES["INSTRUCTION_SET"]
THREAD_BACKENDS = NAMES["THREAD_BACKEND"]
LOG_LEVELS = NAMES["LOG"]
KERNELS = NAMES["KERNEL"]
CSG_KINDS = NAMES["CSG"]
SOLVERS = NAMES["SOLVER"]
SOLVER_REASONS = NAMES["SOLVER_REASON"]
NORMALS = NAMES["NORMALS"]
TRIMS = NAMES["TRIM"]
SIDES = NAMES["SIDES"]
OUTWARD = NAMES["OUTWARD"]
REPAIRS = NAMES["REPAIR"]
PROJECTION = NAMES["PROJECTION"]
PARTS = NAMES["PARTS"]
FACES = NAMES["FACES"]
EDGES = NAMES["EDGES"]
RAY = NAMES["RAY"]
LAYER_KINDS = NAMES["LAYER_KIND"]
DISTRIBUTIONS = NAMES["DISTRIBUTION"]
SEED_SOURCES = NAMES["SEED"]
DENSITIES = NAMES["DENSITY"]
GUIDES = NAMES["HATCH_GUIDE"]
FIELD_KINDS = NAMES["FIELD_KIND"]
TONE_RANGES = NAMES["TONE_RANGES"]
STROKE_STARTS = NAMES["STROKE_START"]
DEPTH_CONVENTIONS = NAMES["DEPTH"]
HIDDEN_LINES = NAMES["HIDDEN_LINES"]
VISIBILITIES = NAMES["VISIBILITY"]
TONES = NAMES["TONE"]
TONE_RULES = NAMES["TONE_RULE"]
TONE_CURVES = NAMES["TONE_CURVE"]
LIGHT_SPACES = NAMES["LIGHT"]
SHAPES = NAMES["SHAPE"]
FORMATS = NAMES["FORMAT"]
PRIMITIVES = NAMES["PRIMITIVE"]
LINE_KINDS = NAMES["LINE_KIND"]
CREASES = NAMES["CREASES"]
HIDDEN_PARTS = NAMES["HIDDEN_PARTS"]
CAPS = NAMES["CAP"]
PAGE_FORMATS = NAMES["PAGE_FORMAT"]
WIDTHS = NAMES["WIDTHS"]
DOT_SHAPES = NAMES["DOT_SHAPE"]
CURVES = NAMES["CURVES"]
LINE_TYPES = NAMES["LINE_TYPE"]
CLASSES = NAMES["CLASS"]


def number_of(argument: str, numbers: Dict[str, int], name: str) -> int:
    """The number of a name.  Hyphens and underscores are equivalent."""
    key = name.replace("-", "_").lower() if isinstance(name, str) else name
    if key not in numbers:
        choices = ", ".join(repr(choice) for choice in numbers)
        raise ValueError(f"{argument} must be one of {choices}, not {name!r}")
    return numbers[key]


def name_of(numbers: Dict[str, int], number: int) -> str:
    """The name of a number, or the number as text if only a newer library knows its name."""
    for name, value in numbers.items():
        if value == number:
            return name
    return str(number)


def preset_names() -> Tuple[str, ...]:
    """The names of the library's presets (named styles), in the order of their numbers."""
    names: List[str] = []
    while (name := lib.hrbfnpr_preset_name(len(names))) != ffi.NULL:
        names.append(ffi.string(name).decode())
    return tuple(names)


PRESETS = preset_names()
"""The names of the presets (named styles) for `Style` and `PointSet.generate`."""

# The kinds of layers of marks, and the kinds that the library can make.
MARK_KINDS = tuple(name for name in LAYER_KINDS if name != "any")
MADE_KINDS = tuple(name for name in MARK_KINDS if name != "own")
