# SPDX-License-Identifier: MIT
"""What `check` finds out about points: their normals, which way is up, what stands for no data."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np

from .._context import Context
from .._depth_image import DepthImageInfo, smooth_depth_image
from ..shapes import Shape
from ..shapes._shape import Floats, Vector

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
MANY = 6000  # points of which all are asked whether they lie along curves
THINNED = 256  # and the fewest of which a part is
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
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
_FLAT = 0.3  # relief of a terrain over its shorter side, at most ...
_RELIEF = 0.003  # ... and at least
_UPWARD = 0.7  # mean of the normals' upward parts
_BASE = 0.05  # share of the surface that a base has, at least
_MAP = 10000.0  # eastings and northings, at least
_FOOT = 0.04  # share of the height that what it stands on has ...
_STEADY = 0.3  # ... and the share of its shadow
_NOTHING = "nothing speaks for another direction"
_OTHERS = 4.0  # how much larger it is than any other flat end; a top than feet
_MIRRORED = 1.0  # distance of mirrored samples from others, in spacings: where it is less, left and right are alike ...
_UNLIKE = 1.2  # ... and where it is more they are not
_CLEARLY = 1.8  # how much farther those mirrored along another axis are
_LEAF = 0.1  # thickness of a leaf, over its shorter side: it lies
_LOOKED_AT = 1200  # samples that are mirrored
_BELOW = 0.15  # share of the height that the border of what is open below has ...
_ITS_BORDER = 0.5  # ... for that share of its length ...
_NOT_ABOVE = 0.05  # ... with less than that in the same share of the height above ...
_ITS_HOLE = 2.0  # ... and how much larger its hole is, seen along that axis, than along others


def choose(shape: Optional[Shape], points: Floats, normals: Floats) -> Tuple[Vector, str]:
    """Up, and why."""
    if shape is not None and shape.up is not None:
        of = "pictures of a depth camera" if shape.is_picture else f"{shape.format.split(',')[0]} files"
        return shape.up, f"it is so in {of}"
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    if (extent <= 0).any():
        return Y, _NOTHING
    if _on_a_map(low, high, extent):
        return Z, "x and y are coordinates of a map"
    if _is_terrain(extent, normals, 2) and not _is_terrain(extent, normals, 1):
        return Z, "the surface is a terrain: it is flat, and looks along z everywhere"
    if (np.abs(normals[:, 2]) > 0.05).mean() > 0.98 and abs(np.sign(normals[:, 2]).mean()) > 0.95:
        return Y, _NOTHING  # a view from one side, or a relief: it has no end to stand on
    bases = _bases(points, normals, low, extent)
    if bases[4] >= _BASE and bases[4] >= _OTHERS * np.delete(bases, 4).max():
        return Z, "it has a flat base below along z, and no other flat end"
    left_right = _sideways(points, extent)
    if left_right == 1:
        return Z, "left and right, along y, are alike, above and below along z are not"
    if left_right == 2 or _opens_below(shape, 1):
        return Y, _NOTHING
    if _stands(low, high, extent, 2) and not _stands(low, high, extent, 1) and bases[4] >= bases[2]:
        return Z, "it stands on z = 0, in the middle of x and y"
    if _rests(points, 2, 1) and not (_rests(points, 1, 1) or _rests(points, 1, -1)):
        feet, top = (int(_end_of(points, 2, side).sum()) for side in (1, -1))
        if top > _OTHERS * feet or not _rests(points, 2, -1):
            return Z, "it stands on its feet below along z, and would fall along y"
    return Y, _NOTHING


def _on_a_map(low: Floats, high: Floats, extent: Floats) -> bool:
    """Eastings and northings are far from 0, heights are not."""
    middle, height = np.abs(low + high)[:2] / 2, max(abs(low[2]), abs(high[2]))
    return bool((middle > np.maximum(_MAP, 2 * extent[:2])).all() and middle.min() > 2 * height)


def hangs(points: Floats, normals: Floats) -> Optional[str]:
    """The axis along which a terrain looks down; None if it does not, or is none."""
    extent = np.ptp(points, axis=0)
    for axis in (2, 1):
        if (extent > 0).all() and _is_terrain(extent, normals, axis) and normals[:, axis].mean() < 0:
            return "xyz"[axis]
    return None


def _is_terrain(extent: Floats, normals: Floats, axis: int) -> bool:
    upward = normals[:, axis]
    upward = upward * np.sign(upward.mean())
    wide = np.delete(extent, axis).min()
    return bool(
        _RELIEF * wide < extent[axis] < _FLAT * wide and (upward > 0).mean() > 0.99 and upward.mean() > _UPWARD
    )


def _bases(points: Floats, normals: Floats, low: Floats, extent: Floats) -> Any:
    """Shares of the samples on a flat end: below along x, above along x, below along y, ..."""
    place = (points - low) / extent
    shares = []
    for axis in range(3):
        for height, outward in ((place[:, axis], -normals[:, axis]), (1 - place[:, axis], normals[:, axis])):
            shares.append(float(((height < 0.02) & (outward > 0.9)).mean()))
    return np.array(shares)


def _stands(low: Floats, high: Floats, extent: Floats, axis: int) -> bool:
    across = [other for other in range(3) if other != axis]
    middle = np.abs(low + high)[across] / 2
    return bool(abs(low[axis]) <= 0.005 * extent[axis] and (middle <= 0.05 * extent[across]).all())


def _sideways(points: Floats, extent: Floats) -> Optional[int]:
    """Along which of y and z both sides are alike, where along the other they are not: most things have a left and a
    right, but few the same above and below [Fu et al. 2008]."""
    if len(points) < 8:
        return None
    spacing = _farther(points[::2], points[1::2])
    off = []
    for axis in (1, 2):
        mirrored = points[:: max(1, len(points) // _LOOKED_AT)].copy()
        both = (points[:, axis].mean(), (points[:, axis].min() + points[:, axis].max()) / 2)
        sides = [np.where(np.arange(3) == axis, 2 * middle - mirrored, mirrored) for middle in both]
        off.append(min(_farther(side, points) for side in sides))
    for k, axis in enumerate((1, 2)):
        lies = extent[axis] < _LEAF * np.delete(extent, axis).min()
        alike, unlike = off[k] < _MIRRORED * spacing, off[1 - k] > max(_UNLIKE * spacing, _CLEARLY * off[k])
        if alike and unlike and not lies:
            return axis
    return None


def _opens_below(shape: Optional[Shape], axis: int) -> bool:
    """Whether it is a mesh with a hole to stand on, as busts have and what was scanned on a table."""
    if shape is None or shape.triangles is None or len(shape.triangles) == 0:
        return False
    faces = np.asarray(shape.triangles, dtype=np.int64)
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = sides.min(axis=1), sides.max(axis=1)
    _, first, count = np.unique(low * len(shape.points) + high, return_index=True, return_counts=True)
    start, end = (np.asarray(shape.points)[sides[first[count == 1], k]] for k in (0, 1))
    length = np.linalg.norm(end - start, axis=1)
    if not length.sum() > 0:
        return False
    height = (start[:, axis] + end[:, axis]) / 2
    heights = np.asarray(shape.points)[faces.ravel(), axis]
    share = (height - heights.min()) / np.ptp(heights)
    hole = np.abs(np.cross(start - start[0], end - start[0]).sum(axis=0))
    return bool(
        length[share < _BELOW].sum() >= _ITS_BORDER * length.sum()
        and length[share > 1 - _BELOW].sum() <= _NOT_ABOVE * length.sum()
        and hole[axis] > _ITS_HOLE * np.delete(hole, axis).max()
    )


def _farther(places: Floats, points: Floats) -> float:
    """Distance from the nearest of the points that nine in ten of the places are within."""
    nearest = [np.sqrt(((points - place) ** 2).sum(axis=1).min()) for place in places[:_LOOKED_AT]]
    return float(np.percentile(nearest, 90))


def _rests(points: Floats, axis: int, side: int) -> bool:
    """Whether it stands on what is lowest along an axis: that is wide, and the middle of all lies above it."""
    flat = np.delete(points, axis, axis=1)
    shadow, base = _hull(flat), _hull(flat[_end_of(points, axis, side)])
    if len(base) < 3 or _area(base) < _STEADY * _area(shadow):
        return False
    along, off = np.roll(base, -1, axis=0) - base, flat.mean(axis=0) - base
    return bool((along[:, 0] * off[:, 1] - along[:, 1] * off[:, 0] > 0).all())


def _end_of(points: Floats, axis: int, side: int) -> Any:
    height = side * points[:, axis]
    return height < height.min() + _FOOT * np.ptp(height)


def _area(polygon: Floats) -> float:
    following = np.roll(polygon, -1, axis=0)
    return float((polygon[:, 0] * following[:, 1] - polygon[:, 1] * following[:, 0]).sum()) / 2


def _hull(points: Floats) -> Floats:
    """Corners of the convex hull, anticlockwise [Andrew 1979]."""
    ordered = np.unique(points, axis=0)
    chains = []
    for half in (ordered, ordered[::-1]):
        chain: List[Floats] = []
        for point in half:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains += chain[:-1]
    return np.array(chains).reshape(-1, 2)


def _turn(a: Floats, b: Floats, c: Floats) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def name(up: Vector) -> str:
    """x, -x, ... or the numbers."""
    for i, axis in enumerate("xyz"):
        if abs(up[i]) == np.abs(up).sum():
            return axis if up[i] > 0 else f"-{axis}"
    return ",".join(f"{part:g}" for part in up)
NO_DATA = (-9999.0, -99999.0, -999999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1.7976931348623157e308)
FAR = 4.0  # times as far from the middle as all that is left, or as large
FEW = 0.005  # of the points, ...


def without_data(shape: Shape) -> Tuple[Shape, int, float]:
    """Without the points that have such a coordinate, far below all others; how many they are, and which it is."""
    for value in NO_DATA:
        empty = (shape.points == value).any(axis=1)
        if not empty.any() or empty.all():
            continue
        rest = shape.points[~empty]
        rest = rest[np.isfinite(rest).all(axis=1)]
        if len(rest) == 0 or rest.min() - value < np.ptp(rest, axis=0).max():
            continue
        left = _left(shape, ~empty)
        if left is not None:
            return left, int(empty.sum()), value
    return shape, 0, 0.0


def without_strays(shape: Shape) -> Tuple[Shape, int]:
    """Points without a few that lie apart from all others, and how many these are."""
    far = strays(shape.points)
    left = _left(shape, ~far) if far.any() else None
    return (shape, 0) if left is None else (left, int(far.sum()))


def _left(shape: Shape, kept: Any) -> Optional[Shape]:
    """Those points alone, with the faces that have no others; None if there would be none."""
    normals = None if shape.normals is None else shape.normals[kept]
    if not shape.is_mesh:
        return replace(shape, points=shape.points[kept], normals=normals, image_shape=None)
    assert shape.triangles is not None
    faces = shape.triangles[kept[shape.triangles].all(axis=1)]
    if len(faces) == 0:
        return None
    number = np.cumsum(kept) - 1
    sharp = shape.sharp_edges
    if sharp is not None:
        sharp = number[sharp[kept[sharp].all(axis=1)]]
    return replace(shape, points=shape.points[kept], normals=normals, triangles=number[faces], sharp_edges=sharp)


def strays(points: Floats) -> Any:
    """Which of many points are a few that lie apart from all others."""
    finite = np.isfinite(points).all(axis=1)
    far = np.zeros(len(points), dtype=bool)
    if finite.sum() < 2 / FEW:
        return far
    distance = np.full(len(points), -1.0)
    distance[finite] = np.linalg.norm(points[finite] - np.median(points[finite], axis=0), axis=1)
    last = np.sort(distance)[-int(FEW * finite.sum()) - 1 :]
    gaps = np.flatnonzero(last[1:] > FAR * last[:-1])
    if len(gaps) and last[gaps[0]] > 0:
        far = distance > last[gaps[0]]
    return far


def smoothed(shape: Shape, context: Context, **options: Any) -> Tuple[Shape, DepthImageInfo]:
    """The pixels that have a point, with normals; options of `hrbfnpr.smooth_depth_image`."""
    assert shape.image_shape is not None
    made = smooth_depth_image(shape.points.reshape(*shape.image_shape, 3), context=context, **options)
    points, normals = (np.asarray(each, dtype=float).reshape(-1, 3) for each in (made.points, made.normals))
    kept = np.isfinite(points).all(axis=1)
    return replace(shape, points=points[kept], normals=normals[kept], image_shape=None), made.info


def noise_of(info: DepthImageInfo) -> float:
    """Of the median depth z, from that of 1 / z."""
    return info.noise * info.depth**2
