"""What generating a point set did, as plain data."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Tuple

from ._names import DISTRIBUTIONS, GROUPS, SEED_SOURCES, name_of
from ._structs import read_struct

Vector = Tuple[float, float, float]


@dataclass(frozen=True)
class LevelInfo:
    """What became of one level's candidates: attempted = placed + all dropped."""

    attempted: int
    placed: int
    dropped_not_converged: int
    dropped_strayed: int
    dropped_degenerate: int
    dropped_budget: int


@dataclass(frozen=True)
class GroupInfo:
    """One group of marks.

    Attributes
    ----------
    count, strokes : int
        Marks, and strokes that they belong to (0 for stipples).
    full_count : int
        What the count would be if nothing had been dropped (distribution "paper").
    levels : int
        Refinement steps taken.
    step : float
        The initial step used.
    seconds : float
    level : tuple of LevelInfo
        One for the seeds and one for each refinement step.
    """

    count: int
    strokes: int
    full_count: int
    levels: int
    step: float
    seconds: float
    level: Tuple[LevelInfo, ...]


@dataclass(frozen=True)
class PointSetInfo:
    """A point set.

    Attributes
    ----------
    distribution, seed_source : str
        As used.
    origin : tuple of float
        Add it to positions.
    bounds_min, bounds_max : tuple of float
        Box of all marks.
    spacing : float
        sqrt(area per mark) of the largest group, estimated.
    seconds_seeds, seconds_total : float
    bytes : int
        Memory kept by the set.
    seeds : LevelInfo
    group : mapping of str to GroupInfo
        By the name of the group.
    """

    distribution: str
    seed_source: str
    origin: Vector
    bounds_min: Vector
    bounds_max: Vector
    spacing: float
    seconds_seeds: float
    seconds_total: float
    bytes: int
    seeds: LevelInfo
    group: Mapping[str, GroupInfo]


def _level(struct: Any) -> LevelInfo:
    return read_struct(LevelInfo, struct)


def _group(struct: Any) -> GroupInfo:
    def used(levels: Any) -> Tuple[LevelInfo, ...]:
        return tuple(_level(levels[i]) for i in range(struct.levels + 1))

    return read_struct(GroupInfo, struct, {"level": used})


def read_info(struct: Any) -> PointSetInfo:
    """From a filled hrbfnpr_point_set_info."""
    return read_struct(
        PointSetInfo,
        struct,
        {
            "distribution": lambda number: name_of(DISTRIBUTIONS, number),
            "seed_source": lambda number: name_of(SEED_SOURCES, number),
            "seeds": _level,
            "group": lambda groups: {name: _group(groups[number]) for name, number in GROUPS.items()},
        },
    )
