"""Names of the library's numbers: every choice is a lower-case string in Python."""
from __future__ import annotations

from typing import Dict, Iterable, Tuple, Union

from ._library import ffi


def _numbers(prefix: str, *names: str) -> Dict[str, int]:
    return {name: ffi.integer_const(f"HRBFNPR_{prefix}_{name.upper()}") for name in names}


INSTRUCTION_SETS = _numbers("INSTRUCTION_SET", "auto", "baseline", "avx2", "avx512", "neon")
THREAD_BACKENDS = _numbers("THREAD_BACKEND", "auto", "pool", "openmp", "run_tasks", "serial")
LOG_LEVELS = _numbers("LOG", "debug", "info", "warning")
KERNELS = _numbers("KERNEL", "triharmonic", "gaussian", "wendland_c2", "custom")
SOLVERS = _numbers("SOLVER", "auto", "direct", "iterative")
SOLVER_REASONS = _numbers("SOLVER_REASON", "requested", "small", "large", "not_converged", "not_definite")
REPAIRS = _numbers("REPAIR", "keep", "drop", "reorient")
PROJECTION = _numbers("PROJECTION", "converged", "not_converged", "zero_gradient", "not_finite")
RAY = _numbers("RAY", "hit", "miss", "truncated", "evaluation_limit", "not_finite")
GROUPS = _numbers("GROUP", "stipple", "curvature", "combing")
DISTRIBUTIONS = _numbers("DISTRIBUTION", "blue_noise", "paper")
SEED_SOURCES = _numbers("SEED", "auto", "samples", "box", "points")
STROKE_FIELDS = _numbers("STROKE_FIELD", "line", "cross")
DENSITIES = _numbers("DENSITY", "uniform", "curvature", "callback")
ORDERS = _numbers("ORDER", "separate", "layered")
LAYERS = _numbers(
    "LAYER", "stipple", "curvature_first", "curvature_second", "combing_first", "combing_second"
)
GROUP_SEEDS = _numbers("GROUP_SEED", "seeds", "stipples")
DEPTH_CONVENTIONS = _numbers("DEPTH", "negative_one_to_one", "zero_to_one", "reversed")
HIDDEN_LINES = _numbers("HIDDEN_LINES", "attenuate", "hide", "show")
VISIBILITIES = _numbers("VISIBILITY", "sheets", "painted")
TONES = _numbers("TONE", "none", "light", "callback")
TONE_RULES = _numbers("TONE_RULE", "share", "paper")
TONE_CURVES = _numbers("TONE_CURVE", "coverage", "linear")
SILHOUETTE_LAWS = _numbers("SILHOUETTE_LAW", "width", "angle")
LIGHT_SPACES = _numbers("LIGHT", "world", "camera")
FORMATS = _numbers("FORMAT", "rgba8", "bgra8", "rgba8_premultiplied", "bgra8_premultiplied")
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


def group_bits(groups: Union[str, Iterable[str]]) -> int:
    """The bits of some groups' names."""
    names = [groups] if isinstance(groups, str) else groups
    bits = 0
    for name in names:
        bits |= 1 << number_of("groups", GROUPS, name)
    return bits


def group_names(bits: int) -> Tuple[str, ...]:
    """The names of some groups' bits."""
    return tuple(name for name, number in GROUPS.items() if bits >> number & 1)
