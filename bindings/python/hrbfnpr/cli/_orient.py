# SPDX-License-Identifier: MIT
"""Which way the normals of samples look: outward, inward, or some this way and some that.

`make` finds them where there are none, `settle` repairs them.
"""
from __future__ import annotations

from typing import Any, NamedTuple, Optional, Tuple

import numpy as np

from .._context import Context
from .._orient import Oriented, orient
from ..shapes._shape import Floats, Vector
from ._progress import Reporter

SOURCES = 2500  # samples that stand for all
QUERIES = 300  # of these, where it is asked
NEIGHBOURS = 8
AGREEMENT = 0.99985  # cosine of the angle up to which normals at one place are the same, as the fit has it
OPPOSITE = 0.2  # length of the mean of normals that tell nothing together
SOFT = 0.1  # of a sample's area, which keeps what lies right beside it finite
INWARD = -0.5  # sum of the winding numbers on both sides: 1 of a closed surface, -1 inside out, 0 of a flat sheet
DOUBTFUL = -0.25
MIXED = 0.02  # share of normals against their neighbours that is warned of ...
UNSURE = 0.1  # ... and up to which all others may be trusted
UNSURE_BELOW = 0.5  # confidence of normals that the library made
MANY = 6000  # points of which all are asked whether they lie along curves
THINNED = 256  # and the fewest of which a part is
LEAST = 10  # points with normals to repair
FOUND = {
    "given": "right", "none": "none of these points'", "unoriented": "of any sign", "mixed": "turned here and there",
    "inward": "inward",
}  # fmt: skip


class Normals(NamedTuple):
    """How normals look.

    `closed` is the sum of the winding numbers on both sides of the samples, in the middle: 1 where they are a
    closed surface with outward normals, -1 with inward ones, about 0 on an open sheet or with mixed ones.
    `against` is the share of normals that look against nearly all around them, `flipped` the share that would make
    as many neighbours differ if it were flipped at random, `outside_in` the share of samples where that sum is below
    0, of those where it tells anything.
    """

    closed: float
    against: float
    flipped: float
    outside_in: float

    @property
    def inward(self) -> bool:
        """All of them, of a surface that is closed but for holes."""
        return self.closed < INWARD and self.against < UNSURE

    @property
    def mixed(self) -> bool:
        """Some against their neighbours, or one part against another."""
        return self.against >= MIXED or self.flipped >= UNSURE or 0.05 < self.outside_in < 0.95


def look(points: Floats, normals: Floats, even: bool, seed: int = 1) -> Normals:
    """Winding numbers and neighbours; `even` means that each sample stands for the same area."""
    random = np.random.default_rng(seed)
    few = np.arange(len(points))
    if len(points) > SOURCES:
        few = np.sort(random.choice(len(points), SOURCES, replace=False))
    points, normals = points[few], normals[few]
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if len(points) < 6 or size == 0:
        return Normals(0.0, 0.0, 0.0, 0.0)
    points = (points - points.mean(axis=0)) / size
    distance, nearest = neighbours(points, points, min(NEIGHBOURS + 1, len(points)))
    spacing = distance[:, -1]
    areas = np.full(len(points), np.median(spacing) ** 2) if even else spacing**2
    areas = areas * (np.pi / (distance.shape[1] - 1))
    queries = np.arange(len(points))
    if len(points) > QUERIES:
        queries = random.choice(len(points), QUERIES, replace=False)
    step = np.maximum(spacing[queries], 1e-6)[:, None] * normals[queries]
    sums = sum(_winding(points[queries] + side * step, points, normals, areas) for side in (0.5, -0.5))
    telling = np.abs(sums) > 0.4
    outside_in = float((sums[telling] < 0).mean()) if telling.mean() > 0.3 else 0.0
    return Normals(float(np.median(sums)), *_against(points, normals, nearest[:, 1:]), outside_in)


def neighbours(queries: Floats, points: Floats, count: int) -> Tuple[Floats, Any]:
    """Distances to the nearest points and their indices, near ones first; a point is its own nearest."""
    squares = (points**2).sum(axis=1)
    distances, indices = [], []
    for start in range(0, len(queries), 512):
        block = queries[start : start + 512]
        d2 = squares - 2 * block @ points.T + (block**2).sum(axis=1)[:, None]
        near = np.argpartition(d2, count - 1, axis=1)[:, :count]
        d2 = np.take_along_axis(d2, near, axis=1)
        order = np.argsort(d2, axis=1)
        indices.append(np.take_along_axis(near, order, axis=1))
        distances.append(np.sqrt(np.maximum(np.take_along_axis(d2, order, axis=1), 0)))
    return np.concatenate(distances), np.concatenate(indices)


def _winding(queries: Floats, points: Floats, normals: Floats, areas: Floats) -> Floats:
    away = points[None] - queries[:, None]
    distance = np.sqrt((away**2).sum(axis=2) + SOFT * areas)
    parts = np.einsum("ijk,jk->ij", away, normals * areas[:, None]) / distance**3 / (4 * np.pi)
    result: Floats = np.clip(parts, -0.5, 0.5).sum(axis=1)  # a flat piece fills half of the view at most
    return result


def _against(points: Floats, normals: Floats, nearest: Any) -> Tuple[float, float]:
    """Share of normals that most of their neighbours on the same sheet are against, and what differing pairs tell."""
    away = points[nearest] - points[:, None]
    length = np.linalg.norm(away, axis=2)
    across = np.abs(np.einsum("ijk,ik->ij", away, normals))
    beside = (across < 0.5 * length) & (length > 0)
    opposed = np.einsum("ijk,ik->ij", normals[nearest], normals) < -0.25
    counts = beside.sum(axis=1)
    against = float(((opposed & beside).sum(axis=1) > 0.75 * counts)[counts >= 3].sum() / len(points))
    level = (across < 0.25 * length) & (length > 0)  # surely on the same sheet
    if level.mean() < 0.2:
        return against, against
    pairs = float((opposed & level).sum() / level.sum())  # 2 p (1 - p) of a share p
    return against, (1 - np.sqrt(max(1 - 2 * pairs, 0.0))) / 2


def agreed(points: Floats, normals: Floats) -> Tuple[Floats, Floats, int, int]:
    """Samples of which no two are at one place with different normals.

    Where they are, as vertices on a sharp edge of a mesh, one stays, with the mean normal; where the normals are
    opposite none does.  Also returns how many places were joined, and how many were left out.
    """
    _, first, where, counts = np.unique(points, axis=0, return_index=True, return_inverse=True, return_counts=True)
    if counts.max() == 1:
        return points, normals, 0, 0
    where = where.reshape(-1)
    differs = np.zeros(len(counts), dtype=bool)
    differs[where[np.einsum("ij,ij->i", normals, normals[first[where]]) < AGREEMENT]] = True
    if not differs.any():
        return points, normals, 0, 0
    mean = np.column_stack([np.bincount(where, weights=normals[:, axis]) for axis in range(3)]) / counts[:, None]
    length = np.linalg.norm(mean, axis=1)
    keep = ~differs[where]
    joined = differs & (length > OPPOSITE)
    keep[first[joined]] = True
    new = normals.copy()
    new[first[joined]] = mean[joined] / length[joined, None]
    return points[keep], new[keep], int(joined.sum()), int((differs & ~joined).sum())


def make(
    points: Floats, mode: str, normals: Optional[Floats], bar: Any, context: Context, **seen: Optional[Vector]
) -> Oriented:
    """Outward normals by the library; `seen`: the `up` and `viewpoint` of open surfaces, if they are known."""
    known = {name: value for name, value in seen.items() if value is not None}
    return orient(points, normals, mode, progress=bar, context=context, **known)


def in_words_of(oriented: Oriented, count: int) -> str:
    """What `make` did."""
    info = oriented.info
    kind = "closed" if info.closed else "open"
    if info.made >= count:
        done = "normals are made"
    elif info.turned or info.made:
        done = f"{info.turned} normals turned, {info.made} made anew"
    else:
        done = "normals stay as they are"
    return f"{done}; the surface is {kind}, confidence {info.confidence:.2f}"


def doubts_of(oriented: Oriented) -> Tuple[str, ...]:
    """What is not sure of it."""
    info = oriented.info
    sure = []
    if info.confidence < UNSURE_BELOW:
        sure.append(
            f"normals of the points are not sure (confidence {info.confidence:.2f}): look at the picture; more points, "
            "or normals of the scanner, help"
        )
    if info.outward_by == "up":
        sure.append(
            "the surface is open, and which side is its front cannot be told: --flip takes the other one, and --viewpoint "
            "X,Y,Z that which the scanner saw"
        )
    return tuple(sure)


def settle(
    points: Floats, normals: Floats, mode: str, report: Reporter, bar: Any, context: Context, **seen: Optional[Vector]
) -> Tuple[Floats, str]:
    """The normals of points, turned outward as far as that can be told, and what was done in words; `seen`: of `make`."""
    if mode == "keep":
        return normals, "normals as they are"
    if mode != "auto":
        return repaired(points, normals, mode, report, bar, context, **seen)
    found = look(points, normals, False)
    if (found.mixed and len(points) >= LEAST) or along_curves(points):
        return repaired(points, normals, "auto", report, bar, context, **seen)
    if found.inward:
        report.note("all normals looked inward: they are turned (--normals keep leaves them)")
        return -normals, "normals looked inward: all are turned"
    for doubt in doubts(found, len(points), False):
        report.warn(doubt)
    return normals, in_words(found)


def along_curves(points: Floats) -> bool:
    """Whether points lie along curves, where neighbours tell nothing of normals, as the library has it; not asked of many."""
    points = np.random.default_rng(1).permutation(points)[:MANY] if len(points) <= 4 * MANY else points[:0]
    while len(points) >= 2 * NEIGHBOURS:
        if _are_on_lines(points):
            return True
        points = points[::4] if len(points) >= 4 * THINNED else points[:0]
    return False


def _are_on_lines(points: Floats) -> bool:
    _, nearest = neighbours(points, points, 13)
    for count, across, share in ((4, 0.2, 0.2), (12, 0.25, 0.07)):
        away = points[nearest[:, 1 : count + 1]] - points[:, None]
        values = np.linalg.eigvalsh(np.einsum("ijk,ijl->ikl", away, away))
        if (values[:, :2].sum(axis=1) < across**2 * values[:, 2]).mean() > share:
            return True
    return False


def repaired(
    points: Floats, normals: Floats, mode: str, report: Reporter, bar: Any, context: Context, **seen: Optional[Vector]
) -> Tuple[Floats, str]:
    """The same by the library, said."""
    made = make(points, mode, normals, bar, context, **seen)
    for doubt in doubts_of(made):
        report.warn(doubt)
    if made.info.turned or made.info.made:
        report.note(
            f"the normals were {FOUND[made.info.found]}: {made.info.turned} are turned, {made.info.made} are made anew "
            "(--normals keep leaves them)"
        )
    return np.asarray(made.normals, dtype=float), in_words_of(made, len(points))


def in_words(found: Normals) -> str:
    if found.mixed:
        return "normals differ"
    if found.closed > -INWARD:
        return "normals look outward"
    return "an open surface: its normals are as they are"


def doubts(found: Normals, count: int, mesh: bool) -> Tuple[str, ...]:
    """What is wrong with normals that were not turned."""
    if found.inward:
        return ()
    if mesh and found.mixed:
        share = max(found.flipped, found.outside_in)
        return (
            f"some faces look outward and others inward (about {share:.0%}), so the surface is wrong there: turn them "
            "in MeshLab (Re-orient all faces coherently) or Blender (Recalculate outside)",
        )
    if found.against >= MIXED or found.flipped >= UNSURE:
        return (
            f"about {round(found.flipped * count)} of {count} normals look against those around them, so the surface "
            "is wrong there: --flipped-normals reorient repairs a few; orient them anew, in MeshLab or CloudCompare, if "
            "they are many",
        )
    if found.mixed:
        return (
            f"some parts have outward normals and others inward ones (about {found.outside_in:.0%}): parts that look "
            "inward are drawn empty",
        )
    if found.closed < DOUBTFUL:
        return ("most of the surface looks inward, and it is open: --flip turns all normals, if the picture is empty",)
    return ()
