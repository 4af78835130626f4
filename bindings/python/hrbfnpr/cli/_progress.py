# SPDX-License-Identifier: MIT
"""What the user reads: stages and their seconds on stdout; bars, notes and, at the end, warnings on stderr."""
from __future__ import annotations

import shutil
import sys
import time
from typing import Any, Optional

from .. import _report
from .._library import lib
from .._report import Note, Stage


class Reporter(_report.Reporter):
    """Shows bars if stderr is a terminal and tqdm is installed.

    Parameters
    ----------
    quiet : bool
        Prints warnings alone.
    start : float, optional
        When the process started, on the scale of time.monotonic().
    verbose : bool
        Prints the detail of each note and warning below it.
    """

    wording = lib.HRBFNPR_WORDING_OPTIONS

    def __init__(self, quiet: bool, start: Optional[float] = None, verbose: bool = False) -> None:
        super().__init__()
        self.quiet, self.verbose = quiet, verbose
        self._start = time.monotonic() if start is None else start
        self._starting: Optional[float] = None if start is None else self.seconds
        self._tqdm: Any = None
        if not quiet and sys.stderr.isatty():
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
            self._print("note", text)

    def _print(self, kind: str, text: str) -> None:
        print(f"hrbfnpr: {kind}: {text}", file=sys.stderr, flush=True)
        detail = getattr(text, "detail", "")
        if self.verbose and detail:
            print(f"    {detail}", file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        """A line on stdout."""
        if not self.quiet:
            print(text, flush=True)

    def line(self, name: str, seconds: float, says: str = "") -> None:
        """A stage that is over; the first one has that of starting before it."""
        if self._starting is not None:
            starting, self._starting = self._starting, None
            self.line("start", starting, "Python and the library")
        self.say(f"{name:<12}{seconds:8.2f} s  {says}".rstrip())

    def summary(self, text: str) -> None:
        """The last line of stdout, with the seconds of it all, and the warnings after it."""
        seconds = self.seconds
        self.line("total", seconds)
        self.say(f"{text}, {seconds:.1f} s")
        self.finish()

    def finish(self) -> None:
        """Print the warnings."""
        for text in self.warnings:
            self._print("warning", text)
        self.warnings.clear()

    def begin(self, doing: str) -> Stage:
        if self._tqdm is None:
            return Stage(None)
        layout = "{desc:<18}{percentage:3.0f}% |{bar:30}| {elapsed}"
        # A terminal that does not know its width would get a fraction with all its digits instead.
        width = shutil.get_terminal_size().columns or 80
        bar = self._tqdm(total=1.0, desc=doing, bar_format=layout, file=sys.stderr, leave=False, ncols=width)
        return Stage(bar)

    def end(self, stage: Stage, name: str, seconds: float) -> None:
        if stage.bar is not None:
            stage.reach(1.0)
            stage.bar.refresh()
            stage.bar.close()
        self.line(name, seconds, stage.says)

    def drop(self, stage: Stage) -> None:
        if stage.bar is not None:
            stage.bar.close()


class Part(_report.Reporter):
    """The notes and warnings of what is part of a stage: its own stages are not told.

    Parameters
    ----------
    about : str
        What notes and warnings begin with, but for those of `general`.
    without : names of notes
        Which are not told.
    """

    wording = lib.HRBFNPR_WORDING_OPTIONS
    general = ("lines_thin", "lines_end")

    def __init__(self, whole: Reporter, about: str, without: Any = ()) -> None:
        super().__init__()
        self._whole, self._about, self._without = whole, about, without

    def take_note(self, note: Note) -> None:
        if note.severity == "failure":
            self.failure = note
        elif note.code not in self._without:
            self._whole.take_note(note if not self._about or note.code in self.general else note.about(self._about))
