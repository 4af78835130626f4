# SPDX-License-Identifier: MIT
"""What a call tells its caller: warnings as Python's, notes for who asks, progress by a function or a bar."""
from __future__ import annotations

import sys
import warnings
from contextlib import contextmanager
from functools import partial
from typing import Any, Callable, Iterator, List, Optional, Union

from ._call_options import in_python
from .cli._progress import Reporter, Stage

Progress = Union[None, bool, Callable[[str, float], Any], Any]
"""A function of a stage's name and a fraction in [0, 1]; a tqdm bar; or True for a bar of its own."""


class DrawingWarning(UserWarning):
    """Something may be wrong with a drawing; the message says what."""


class _Bar:
    """What the stages take for a progress bar, which tells a function."""

    total = 1.0

    def __init__(self, tell: Callable[[float], Any]) -> None:
        self.n = 0.0
        self._tell = tell

    def update(self, step: float) -> None:
        self.n += step
        self._tell(min(1.0, max(0.0, self.n)))


class CallReport(Reporter):
    """Prints nothing; `told` is the function that is told of progress, if there is one."""

    def __init__(self, progress: Progress = None, about: str = "") -> None:
        super().__init__(quiet=True, bars=False, about=about)
        self.notes: List[str] = []
        self.told: Optional[Callable[[str, float], Any]] = _teller(progress)

    def note(self, text: str) -> None:
        """Kept for the result."""
        self.notes.append(in_python(self._about + text))

    def taken(self) -> List[str]:
        """The warnings, which are then gone."""
        told = [in_python(text) for text in self._warnings]
        self._warnings.clear()
        return told

    def finish(self) -> None:
        """Raise Python's warnings, for the line that called this package."""
        depth = _depth_of_caller()
        for text in self.taken():
            warnings.warn(text, DrawingWarning, stacklevel=depth)

    @contextmanager
    def stage(self, name: str, doing: str) -> Iterator[Stage]:
        """A part of the work: from 0 to 1 while it runs."""
        if self.told is None:
            yield Stage(None)
            return
        tell = partial(self.told, doing)
        tell(0.0)
        bar = _Bar(tell)
        yield Stage(bar)
        if bar.n < 1.0:
            tell(1.0)


def _depth_of_caller() -> int:
    """How many frames above `finish` the first one outside this package is."""
    depth, frame = 1, sys._getframe(1)
    package = __name__.rpartition(".")[0]
    while frame.f_back is not None and str(frame.f_globals.get("__name__", "")).split(".")[0] == package:
        frame, depth = frame.f_back, depth + 1
    return depth


def _teller(progress: Progress) -> Optional[Callable[[str, float], Any]]:
    if progress is None or progress is False:
        return None
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ImportError("progress=True needs tqdm (Debian: python3-tqdm)") from error
        progress = tqdm(leave=False)
    if hasattr(progress, "update") and hasattr(progress, "n"):
        return _bar_teller(progress)
    if not callable(progress):
        raise TypeError("progress must be a function of a stage's name and a fraction, a tqdm bar, or True")
    tell: Callable[[str, float], Any] = progress
    return tell


def _bar_teller(bar: Any) -> Callable[[str, float], Any]:
    stage = ""
    bar.total = 1.0
    if getattr(bar, "bar_format", "") is None:
        bar.bar_format = "{l_bar}{bar}| {elapsed}"

    def tell(doing: str, fraction: float) -> None:
        nonlocal stage
        if doing != stage and hasattr(bar, "set_description"):
            bar.set_description(doing)
        stage = doing
        bar.update(fraction - bar.n)

    return tell
