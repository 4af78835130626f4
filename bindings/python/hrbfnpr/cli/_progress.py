# SPDX-License-Identifier: MIT
"""What is told to the user: stages and their seconds on stdout; bars, notes and, at the end, warnings on stderr."""
from __future__ import annotations

import shutil
import sys
import time
from contextlib import contextmanager
from typing import Any, Iterator, List, Optional


class Stage:
    """A part of the work while it runs.

    Attributes
    ----------
    bar : progress bar or None
        For the `progress` of a long call.
    says : str
        What is printed behind its seconds.
    """

    def __init__(self, bar: Any) -> None:
        self.bar = bar
        self.says = ""


class Reporter:
    """Bars where stderr is a terminal and tqdm is installed; warnings alone if quiet."""

    def __init__(self, quiet: bool, bars: bool = True, about: str = "", start: Optional[float] = None) -> None:
        self.quiet, self._about, self._lines = quiet, about, bars
        self._start = time.monotonic() if start is None else start
        self._starting: Optional[float] = None if start is None else self.seconds
        self._warnings: List[str] = []
        self._tqdm: Any = None
        if bars and not quiet and sys.stderr.isatty():
            try:
                from tqdm import tqdm

                self._tqdm = tqdm
            except ImportError:
                pass

    @property
    def seconds(self) -> float:
        """Since the start of the process, or of this reporter."""
        return time.monotonic() - self._start

    def note(self, text: str) -> None:
        """What is good to know; at once."""
        if not self.quiet:
            print(f"hrbfnpr: note: {self._about}{text}", file=sys.stderr, flush=True)

    def warn(self, text: str) -> None:
        """What may be wrong with the result; at the end, also if quiet."""
        if self._about + text not in self._warnings:
            self._warnings.append(self._about + text)

    def logged(self, level: str, message: str) -> None:
        """A line of the library's log: what it alone knows of a mesh is warned of."""
        start = "mesh fit: parts "
        if message.startswith(start):
            self.warn(f"parts {message[len(start):]} (--tolerance)")

    def say(self, text: str) -> None:
        """A line on stdout."""
        if not self.quiet:
            print(text, flush=True)

    def line(self, name: str, seconds: float, says: str = "") -> None:
        """A stage that is over; the first one has that of starting before it."""
        if self._lines and self._starting is not None:
            starting, self._starting = self._starting, None
            self.line("start", starting, "Python and the library")
        if self._lines:
            self.say(f"{name:<12}{seconds:8.2f} s  {says}".rstrip())

    def summary(self, text: str) -> None:
        """The last line of stdout, with the seconds of it all, and the warnings behind it."""
        seconds = self.seconds
        self.line("total", seconds)
        self.say(f"{text}, {seconds:.1f} s")
        self.finish()

    def finish(self) -> None:
        """Print the warnings."""
        for text in self._warnings:
            print(f"hrbfnpr: warning: {text}", file=sys.stderr, flush=True)
        self._warnings.clear()

    def without_bars(self, about: str = "") -> Reporter:
        """Its notes and warnings alone, for what is part of a stage; they begin with what they are about."""
        part = Reporter(self.quiet, False, f"{about}: " if about else "", self._start)
        part._warnings = self._warnings
        return part

    @contextmanager
    def stage(self, name: str, doing: str) -> Iterator[Stage]:
        """A part of the work: a bar while it runs, and a line with its seconds when it is over."""
        start = time.monotonic()
        if self._tqdm is None:
            stage = Stage(None)
            yield stage
        else:
            layout = "{desc:<18}{percentage:3.0f}% |{bar:30}| {elapsed}"
            # A terminal that does not know its width would get a fraction with all its digits instead.
            width = shutil.get_terminal_size().columns or 80
            with self._tqdm(
                total=1.0, desc=doing, bar_format=layout, file=sys.stderr, leave=False, ncols=width
            ) as bar:
                stage = Stage(bar)
                yield stage
                bar.update(1.0 - bar.n)
                bar.refresh()
        self.line(name, time.monotonic() - start, stage.says)
