# SPDX-License-Identifier: MIT
"""Parts of an open mesh that cross or lie close to each other: each of them is a surface of its own.

One function is 0 on all of its parts.  Beyond its border each of them goes on, and where another part is near nobody could say
whose surface that is.  Closed parts have an inside, and the library joins them as solids.
"""
from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Set, Tuple

import numpy as np

from .._mesh import Mesh
from ..shapes._shape import Floats, Integers

NEAR = 0.02  # diagonals: parts that are nearer than this disturb each other
SEAM = 0.002  # diagonals: borders that are nearer than this are one edge that the file has twice ...
SEAM_SHARE = 0.2  # ... along so much of the border of either, where their faces ...
SMOOTH = 0.7  # ... have normals with such a cosine
PLACES = 40_000  # on all parts
MOST_FACES = 300_000  # of meshes that are looked at ...
MOST_OF_ONE = 100_000  # ... and of those that hang together, by vertices at least
MOST_PARTS = 500
MOST_GROUPS = 8
FLAP = 2  # faces of what is too little for a surface of its own, at most ...
FLAP_AREA = 2e-4  # ... and its share of the area


@dataclass(frozen=True)
class Apart:
    """Faces of each group, the one of the largest area first, and how many parts these are."""

    groups: Tuple[Integers, ...]
    parts: int


def groups(mesh: Mesh) -> Optional[Apart]:
    """Those in which no part is near another; None if one group will do."""
    info = mesh.info
    if info.boundary_edges == 0 or info.faces > (MOST_OF_ONE if info.components == 1 else MOST_FACES):
        return None
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles, dtype=np.int64)
    edges = _Edges(faces)
    label, count = _labels(edges.joined(), len(faces))
    if not 1 < count <= MOST_PARTS:
        return None
    across = float(np.linalg.norm(np.ptp(points, axis=0)))
    closed = np.ones(count, dtype=bool)
    closed[label[edges.border_face]] = False
    seams = _seams(points, faces, edges, label, SEAM * across)
    solids = np.flatnonzero(closed)
    together = [*seams, *((int(solids[0]), int(part)) for part in solids[1:])]
    name, count = _labels(np.array(together, dtype=np.int64).reshape(-1, 2), count)
    label = name[label]
    area = np.bincount(label, _areas(points, faces), count)
    near = _near(points, faces, label, NEAR * across)
    little = _little(area, np.bincount(label, minlength=count))
    colour = np.array(_coloured(area, {pair for pair in near if not little[list(pair)].any()}))
    made = [np.flatnonzero(colour[label] == one) for one in range(max(colour) + 1)]
    made.sort(key=lambda one: -float(_areas(points, faces[one]).sum()))
    return Apart(tuple(made), count) if len(made) > 1 else None


def flaps(mesh: Mesh) -> Optional[Integers]:
    """A few faces on an edge of two others, which modelling left over there; None without any."""
    if mesh.info.nonmanifold_edges == 0:
        return None
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles, dtype=np.int64)
    edges = _Edges(faces)
    label, count = _labels(edges.joined(), len(faces))
    area = np.bincount(label, _areas(points, faces), count)
    little = _little(area, np.bincount(label, minlength=count))
    hangs = np.zeros(count, dtype=bool)
    for some in edges.crowded():
        at = label[some]
        hangs[at] |= not little[at].all()
    found = np.flatnonzero((little & hangs)[label])
    return found if len(found) else None


def _areas(points: Floats, faces: Integers) -> Floats:
    a, b, c = (points[faces[:, k]] for k in range(3))
    return np.asarray(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)


def _little(area: Floats, faces: Integers) -> Any:
    return (faces <= FLAP) & (area < FLAP_AREA * area.sum())


class _Edges:
    """Sides of faces in the order of their edges."""

    def __init__(self, faces: Integers) -> None:
        sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        order = np.lexsort((sides[:, 1], sides[:, 0]))
        self._face = np.tile(np.arange(len(faces)), 3)[order]
        self._sides = sides[order]
        new = np.ones(len(order), dtype=bool)
        new[1:] = (self._sides[1:] != self._sides[:-1]).any(axis=1)
        self._first = np.flatnonzero(new)
        self._size = np.diff(np.append(self._first, len(order)))

    def joined(self) -> Integers:
        """Pairs of faces on both sides of an edge; where more meet in one, surfaces cross."""
        first = self._first[self._size == 2]
        return np.column_stack([self._face[first], self._face[first + 1]])

    def crowded(self) -> List[Integers]:
        """The faces at each edge of more than two."""
        many = np.flatnonzero(self._size > 2)
        return [self._face[first : first + size] for first, size in zip(self._first[many], self._size[many])]

    @property
    def border_face(self) -> Integers:
        return self._face[self._first[self._size != 2]]

    @property
    def border(self) -> Integers:
        """Vertices of the edges of `border_face`."""
        return self._sides[self._first[self._size != 2]]


def _labels(pairs: Integers, count: int) -> Tuple[Integers, int]:
    """The number of what each of `count` things hangs together with, and how many there are."""
    least = np.arange(count)
    while len(pairs):
        a, b = least[pairs[:, 0]], least[pairs[:, 1]]
        if np.array_equal(a, b):
            break
        np.minimum.at(least, a, b)
        np.minimum.at(least, b, a)
        while not np.array_equal(least, least[least]):
            least = least[least]
    names, label = np.unique(least, return_inverse=True)
    return label, len(names)


def _meetings(places: Floats, label: Integers, side: float) -> List[Tuple[Integers, Integers]]:
    """Of eight grids of cubes: places, and the cubes that they share with places of other labels.

    Whatever is nearer than half a side shares a cube of one of them.
    """
    found = []
    for shift in range(8):
        offset = np.array([shift & 1, shift >> 1 & 1, shift >> 2]) * 0.5
        cells = np.floor(places / side + offset).astype(np.int64)
        _, cell = np.unique(cells, axis=0, return_inverse=True)
        cell = cell.reshape(-1)
        least, most = np.full(cell.max() + 1, label.max()), np.zeros(cell.max() + 1, dtype=np.int64)
        np.minimum.at(least, cell, label)
        np.maximum.at(most, cell, label)
        shared = np.flatnonzero((least != most)[cell])
        found.append((shared, cell[shared]))
    return found


def _pairs_in(shared: Integers, cell: Integers, label: Integers) -> Set[Tuple[int, int]]:
    inside: Dict[int, Set[int]] = defaultdict(set)
    for place, of in zip(shared.tolist(), cell.tolist()):
        inside[of].add(int(label[place]))
    return {(a, b) for some in inside.values() for a in some for b in some if a < b}


def _near(points: Floats, faces: Integers, label: Integers, reach: float) -> Set[Tuple[int, int]]:
    """Pairs of parts that come nearer to each other than `reach`, or not much farther."""
    places, face = _spread(points, faces)
    found: Set[Tuple[int, int]] = set()
    for shared, cell in _meetings(places, label[face], 2 * reach):
        found |= _pairs_in(shared, cell, label[face])
    return found


def _spread(points: Floats, faces: Integers) -> Tuple[Floats, Integers]:
    """Places on all faces, as many as their areas want and one at least, and the faces."""
    area = _areas(points, faces)
    many = 1 + np.floor(PLACES * area / max(float(area.sum()), 1e-300)).astype(np.int64)
    face = np.repeat(np.arange(len(faces)), many)
    random = np.random.default_rng(1).random((len(face), 2))
    outside = random.sum(axis=1) > 1
    random[outside] = 1 - random[outside]
    a, b, c = (points[faces[face, k]] for k in range(3))
    return a + random[:, :1] * (b - a) + random[:, 1:] * (c - a), face


def _seams(points: Floats, faces: Integers, edges: _Edges, label: Integers, reach: float) -> List[Tuple[int, int]]:
    """Pairs of parts that go on in each other along their borders: a cut, and not two surfaces."""
    face, ends = edges.border_face, points[edges.border]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    step = max(reach / 2, float(length.sum()) / PLACES)
    many = np.maximum(1, np.ceil(length / step)).astype(np.int64)
    edge = np.repeat(np.arange(len(face)), many)
    at = (np.arange(len(edge)) - np.repeat(np.cumsum(many) - many, many) + 0.5) / many[edge]
    places = ends[edge, 0] + at[:, None] * (ends[edge, 1] - ends[edge, 0])
    own, normal = label[face[edge]], _unit_normals(points, faces[face])[edge]
    weight = length[edge] / many[edge]
    total = np.bincount(own, weight, int(label.max()) + 1)
    along: Dict[Tuple[int, int], Set[int]] = defaultdict(set)  # places of the first beside the second
    for shared, cell in _meetings(places, own, 2 * max(reach, step)):
        inside: Dict[int, List[int]] = defaultdict(list)
        for place, of in zip(shared.tolist(), cell.tolist()):
            inside[of].append(place)
        for some in inside.values():
            goes_on = np.abs(normal[some] @ normal[some].T) > SMOOTH
            for place, others in zip(some, goes_on):
                for other in {int(own[one]) for one, is_so in zip(some, others) if is_so} - {int(own[place])}:
                    along[int(own[place]), other].add(place)
    return [pair for pair, some in along.items() if float(weight[list(some)].sum()) > SEAM_SHARE * total[pair[0]]]


def _unit_normals(points: Floats, faces: Integers) -> Floats:
    a, b, c = (points[faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300))


def _coloured(area: Floats, near: Set[Tuple[int, int]]) -> List[int]:
    """The group of each part: the largest first, each in the first group where nothing is near to it."""
    beside: Dict[int, Set[int]] = defaultdict(set)
    for a, b in near:
        beside[a].add(b)
        beside[b].add(a)
    colour: Dict[int, int] = {}
    for part in np.argsort(-area, kind="stable").tolist():
        taken = {colour[other] for other in beside[part] if other in colour}
        free = next(one for one in range(len(area) + 1) if one not in taken)
        colour[part] = min(free, MOST_GROUPS - 1)
    return [colour[part] for part in range(len(area))]
