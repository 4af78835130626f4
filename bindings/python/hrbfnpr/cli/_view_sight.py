# SPDX-License-Identifier: MIT
"""Whether places of a model are seen from the eye of a view, or from a plane that cuts it."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from .._model import Model
from ..shapes._shape import Floats
from ._view_axes import View

_STEPS = 128  # of a ray across the model
_FINER = 12  # parts of a step where the surface comes near
_NEAR = 1.5  # steps: how near that is
_AT_ONCE = 2000  # rays
_OPEN = 0.01  # of the surface, what is left out of an open one
_BEHIND = 1e-3  # of the diagonal: what lies farther behind a cut face than this is hidden by it


class Sight:
    """Rays to the eye, which f is looked up along: many at a time that costs less than following each one.

    Walls thinner than 1 / (_STEPS _FINER) of the diagonal may be missed, of open surfaces sheets that are nearer to
    each other than 1 / (2 _STEPS).
    """

    def __init__(
        self, model: Model, view: View, diagonal: float, middle: Floats, outlines: Sequence[Floats] = ()
    ) -> None:
        self._model, self._view, self._diagonal, self._middle = model, view, diagonal, middle
        trim = model.trim_info
        self._is_open = trim.is_trimmed and trim.share > _OPEN  # else what is left out is of a solid's surface
        self._lipschitz = model.lipschitz() if self._is_open else 0.0
        self._outlines = outlines

    def hides(self, places: Floats, off: float) -> Any:
        """For each place whether surface lies before it.

        Rays begin `off` diagonals beside the surface, where it does not hide itself.
        """
        hidden = np.zeros(len(places), dtype=bool)
        for begin in range(0, len(places), _AT_ONCE):
            part = slice(begin, begin + _AT_ONCE)
            hidden[part] = self._hides(np.asarray(places[part], dtype=float), off)
        return hidden

    def _hides(self, places: Floats, off: float) -> Any:
        gradient = np.asarray(self._model.evaluate(places, gradient=True).gradient)
        outward = gradient / np.maximum(np.linalg.norm(gradient, axis=1, keepdims=True), 1e-300)
        if self._is_open:  # either side of a sheet may be seen
            outward *= np.where(outward @ self._view.eye < 0, -1.0, 1.0)[:, None]
        start = places + off * self._diagonal * outward
        plane = self._view.plane
        far = np.full(len(start), self._diagonal) if plane is None else plane.place - start @ plane.normal
        far = np.maximum(far, 0.0)
        if not self._is_open:
            return self._looked_up(start, far)
        hidden = self._followed(start, far)
        if plane is not None:  # what is cut is solid
            hidden |= (plane.place - places @ plane.normal > _BEHIND * self._diagonal) & self._is_cut(places)
        return hidden

    def _is_cut(self, places: Floats) -> Any:
        """Whether places are seen within an odd number of outlines, which are in units of the model."""
        points = self._view.flat(places, self._middle)
        odd = np.zeros(len(points), dtype=bool)
        for outline in self._outlines:
            x, y = outline[:-1].T
            to_x, to_y = outline[1:].T
            crossed = (y <= points[:, 1:]) != (to_y <= points[:, 1:])
            with np.errstate(divide="ignore", invalid="ignore"):
                at = x + (points[:, 1:] - y) / (to_y - y) * (to_x - x)
            odd ^= (crossed & (at > points[:, :1])).sum(axis=1) % 2 == 1
        return odd

    def _looked_up(self, start: Floats, far: Floats) -> Any:
        """Whether f is below 0 somewhere between: finer where it is least."""
        at = far[:, None] * np.linspace(0.0, 1.0, _STEPS + 1)
        value = self._values(start, at)
        hidden = (value < 0).any(axis=1)
        step = far / _STEPS
        least = (value <= np.roll(value, 1, axis=1)) & (value <= np.roll(value, -1, axis=1))
        ray, number = np.nonzero(least & (value < _NEAR * step[:, None]) & ~hidden[:, None])
        between = np.linspace(-1.0, 1.0, 2 * _FINER + 1)
        finer = np.clip(at[ray, number][:, None] + step[ray][:, None] * between, 0.0, far[ray][:, None])
        below = (self._values(start[ray], finer) < 0).any(axis=1)
        hidden[ray[below]] = True
        return hidden

    def _values(self, start: Floats, at: Floats) -> Floats:
        if at.size == 0:
            return np.zeros(at.shape)
        points = start[:, None, :] + at[..., None] * self._view.eye
        return np.asarray(self._model.evaluate(points).value)

    def _followed(self, start: Floats, far: Floats) -> Any:
        """Whether an open surface is met: behind it f is below 0, too, and beyond its end there is none."""
        at = far[:, None] * np.linspace(0.0, 1.0, 2 * _STEPS + 1)
        inside = self._values(start, at) < 0
        ray, number = np.nonzero(inside[:, 1:] != inside[:, :-1])
        hidden = np.zeros(len(start), dtype=bool)
        if len(ray):
            step = 1.001 * far[ray] / (2 * _STEPS)
            begin = start[ray] + at[ray, number][:, None] * self._view.eye
            rays = np.broadcast_to(self._view.eye, begin.shape)
            hits = self._model.cast_rays(begin, rays, t_max=float(step.max()), lipschitz=self._lipschitz)
            hidden[ray[(np.asarray(hits.hits) > 0) & (np.asarray(hits.t) <= step)]] = True
        return hidden
