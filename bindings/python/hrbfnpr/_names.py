# SPDX-License-Identifier: MIT
"""Names of the library's numbers: every choice is a lower-case string in Python."""
from __future__ import annotations

from typing import Dict, List, Tuple

from ._library import ffi, lib


def _numbers(prefix: str, *names: str) -> Dict[str, int]:
    return {name: ffi.integer_const(f"HRBFNPR_{prefix}_{name.upper()}") for name in names}


INSTRUCTION_SETS = _numbers("INSTRUCTION_SET", "auto", "baseline", "avx2", "avx512", "neon")
THREAD_BACKENDS = _numbers("THREAD_BACKEND", "auto", "pool", "openmp", "run_tasks", "serial")
LOG_LEVELS = _numbers("LOG", "debug", "info", "warning")
KERNELS = _numbers("KERNEL", "triharmonic", "gaussian", "wendland_c2", "custom", "csg")
CSG_KINDS = _numbers(
    "CSG", "union", "intersection", "difference", "complement", "offset", "shell", "model", "half_space", "box", "sphere",
    "cylinder", "cone", "torus",
)  # fmt: skip
SOLVERS = _numbers("SOLVER", "auto", "direct", "iterative")
SOLVER_REASONS = _numbers("SOLVER_REASON", "requested", "small", "large", "not_converged", "not_definite")
NORMALS = _numbers("NORMALS", "given", "none", "unoriented", "mixed", "inward", "auto")
TRIMS = _numbers("TRIM", "never", "auto")
SIDES = _numbers("SIDES", "front", "both")
OUTWARD = _numbers("OUTWARD", "inside", "up", "viewpoint", "as_given")
REPAIRS = _numbers("REPAIR", "keep", "drop", "reorient")
PROJECTION = _numbers("PROJECTION", "converged", "not_converged", "zero_gradient", "not_finite")
PARTS = _numbers("PARTS", "outer", "all", "largest")
FACES = _numbers("FACES", "turn", "keep")
EDGES = _numbers("EDGES", "auto", "smooth", "sharp")
RAY = _numbers("RAY", "hit", "miss", "truncated", "evaluation_limit", "not_finite")
LAYER_KINDS = _numbers("LAYER_KIND", "any", "stipples", "principal", "combing", "field", "own", "hatch")
DISTRIBUTIONS = _numbers("DISTRIBUTION", "blue_noise", "published")
SEED_SOURCES = _numbers("SEED", "auto", "samples", "box", "points")
SYMMETRIES = _numbers("SYMMETRY", "line", "cross")
DENSITIES = _numbers("DENSITY", "uniform", "curvature", "callback")
GUIDES = _numbers("HATCH_GUIDE", "curvature", "combing", "sections", "light", "silhouette")
TONE_RANGES = _numbers("TONE_RANGES", "full", "in_turn")
STROKE_STARTS = _numbers("STROKE_START", "seeds", "stipples")
DEPTH_CONVENTIONS = _numbers("DEPTH", "negative_one_to_one", "zero_to_one", "reversed")
HIDDEN_LINES = _numbers("HIDDEN_LINES", "attenuate", "hide", "show")
VISIBILITIES = _numbers("VISIBILITY", "depth_layers", "published")
TONES = _numbers("TONE", "none", "light", "callback")
TONE_RULES = _numbers("TONE_RULE", "share", "published")
TONE_CURVES = _numbers("TONE_CURVE", "coverage", "linear")
SILHOUETTE_LAWS = _numbers("SILHOUETTE_LAW", "width", "angle")
LIGHT_SPACES = _numbers("LIGHT", "world", "camera")
SHAPES = _numbers("SHAPE", "dots", "strokes", "hatch")
FORMATS = _numbers(
    "FORMAT", "rgba8", "bgra8", "rgba8_premultiplied", "bgra8_premultiplied", "rgba32f", "rgba32f_premultiplied",
    "coverage8",
)  # fmt: skip
PRIMITIVES = _numbers("PRIMITIVE", "points", "line_strips", "triangle_strips")
LINE_KINDS = _numbers(
    "LINE_KIND", "contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote",
    "section", "border", "own", "crease",
)  # fmt: skip
CREASES = _numbers("CREASES", "all", "convex", "concave")
HIDDEN_PARTS = _numbers("HIDDEN_PARTS", "none", "attenuated", "dashed", "shown")
CAPS = _numbers("CAP", "round", "flat", "pointed")
PAGE_FORMATS = _numbers("PAGE_FORMAT", "svg", "pdf", "hpgl", "gcode")
WIDTHS = _numbers("WIDTHS", "outlines", "classes")
DOT_SHAPES = _numbers("DOT_SHAPE", "circles", "lines", "spirals")
LINE_TYPES = _numbers(
    "LINE_TYPE", "as_drawn", "continuous", "dashed", "dashed_spaced", "long_dashed_dotted",
    "long_dashed_double_dotted", "long_dashed_triple_dotted", "dotted", "long_dashed_short_dashed",
    "long_dashed_double_short_dashed", "dashed_dotted", "double_dashed_dotted", "dashed_double_dotted",
    "double_dashed_double_dotted", "dashed_triple_dotted", "double_dashed_triple_dotted",
)  # fmt: skip
CLASSES = _numbers("CLASS", "none", "front", "back", "silhouette")


def number_of(argument: str, numbers: Dict[str, int], name: str) -> int:
    """The number of a name; hyphens and underscores are alike."""
    key = name.replace("-", "_").lower() if isinstance(name, str) else name
    if key not in numbers:
        choices = ", ".join(repr(choice) for choice in numbers)
        raise ValueError(f"{argument} must be one of {choices}, not {name!r}")
    return numbers[key]


def name_of(numbers: Dict[str, int], number: int) -> str:
    """The name of a number; the number in words if a newer library knows more names than we."""
    for name, value in numbers.items():
        if value == number:
            return name
    return str(number)


def preset_names() -> Tuple[str, ...]:
    """Names of the presets that the library knows, by number."""
    names: List[str] = []
    while (name := lib.hrbfnpr_preset_name(len(names))) != ffi.NULL:
        names.append(ffi.string(name).decode())
    return tuple(names)


PRESETS = preset_names()
"""Names of the presets that `Style` and `PointSet.generate` know."""

# Kinds that layers of marks have, and those of strokes that the library makes.
MARK_KINDS = tuple(name for name in LAYER_KINDS if name != "any")
MADE_KINDS = tuple(name for name in MARK_KINDS if name != "own")
STROKE_KINDS = tuple(name for name in MADE_KINDS if name != "stipples")
