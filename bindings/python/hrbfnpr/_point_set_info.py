# SPDX-License-Identifier: MIT
"""What generating a point set did, as plain data."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Tuple

from ._library import ffi
from ._names import DISTRIBUTIONS, LAYER_KINDS, SEED_SOURCES, name_of
from ._structs import read_struct

Vector = Tuple[float, float, float]


@dataclass(frozen=True)
class PlacementInfo:
    """What became of candidates for marks: attempted = placed + all dropped."""

    attempted: int
    placed: int
    dropped_not_converged: int
    dropped_strayed: int
    dropped_degenerate: int
    dropped_budget: int


@dataclass(frozen=True)
class LayerInfo:
    """One layer of marks.

    Attributes
    ----------
    kind, name : str
    marks, strokes : int
        Marks, and strokes that they form (0 for stipples).
    full_count : int
        What `marks` would be if nothing had been dropped (distribution "published"), or left out for the
        budget (strokes of "blue_noise").
    levels : int
        Refinement steps taken; of "blue_noise" strokes the last pass.
    step : float
        The initial step used; of "blue_noise" strokes the separation.
    seconds : float
    """

    kind: str
    name: str
    marks: int
    strokes: int
    full_count: int
    levels: int
    step: float
    seconds: float


@dataclass(frozen=True)
class PointSetInfo:
    """A point set.

    Attributes
    ----------
    distribution, seed_source : str
        As used.
    layers, marks : int
        How many layers, and marks in all of them.
    origin : tuple of float
        Add it to positions.
    bounds_min, bounds_max : tuple of float
        Box of all marks.
    spacing : float
        sqrt(area per mark) of the largest layer, estimated.
    seconds_seeds, seconds_total : float
    bytes : int
        Memory kept by the set.
    """

    distribution: str
    seed_source: str
    layers: int
    marks: int
    origin: Vector
    bounds_min: Vector
    bounds_max: Vector
    spacing: float
    seconds_seeds: float
    seconds_total: float
    bytes: int


def text(characters: Any) -> str:
    """Of a terminated array of characters."""
    return str(ffi.string(characters).decode())


def kind_name(number: int) -> str:
    """Of a layer's kind; one that we do not know is to be treated like "own"."""
    return name_of(LAYER_KINDS, number) if number in LAYER_KINDS.values() else "own"


def read_layer_info(struct: Any) -> LayerInfo:
    """From a filled hrbfnpr_layer_info."""
    return read_struct(LayerInfo, struct, {"kind": kind_name, "name": text})


def read_info(struct: Any) -> PointSetInfo:
    """From a filled hrbfnpr_point_set_info."""
    convert = {
        "distribution": lambda number: name_of(DISTRIBUTIONS, number),
        "seed_source": lambda number: name_of(SEED_SOURCES, number),
    }
    return read_struct(PointSetInfo, struct, convert)
