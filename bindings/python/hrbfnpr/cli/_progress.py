# SPDX-License-Identifier: MIT
"""Prints the progress of a command.

Stages and their seconds go to stdout.  Bars, notes and, at the end, warnings go to stderr.
"""
from __future__ import annotations

import shutil
import sys
import time
from typing import Any, Optional

from .. import _report
from .._library import lib
from .._report import Note, Stage


class Reporter(_report.Reporter):
    """The reporter of the command line.  It shows bars if stderr is a terminal and tqdm is installed.

    Parameters
    ----------
    quiet : bool
        Whether only warnings are printed.
    start : float, optional
        When the process started, on the scale of time.monotonic().  If given, the first line reports the seconds from
        there to the creation of this reporter.
    verbose : bool
        Whether the detail of each note and warning is printed below it.
    """

    wording = lib.HRBFNPR_WORDING_OPTIONS

    def __init__(self, quiet: bool, start: Optional[float] = None, verbose: bool = False) -> None:
        super().__init__()
        self.quiet, self.verbose = quiet, verbose
        self._start = time.monotonic() if start is None else start
        self._start_seconds: Optional[float] = None if start is None else self.seconds
        self._tqdm: Any = None
        if not quiet and sys.stderr.isatty():
            try:
                from tqdm import tqdm

                self._tqdm = tqdm
            except ImportError:
                pass

    @property
    def seconds(self) -> float:
        """The seconds since `start`, or since the creation of this reporter if `start` was not given."""
        return time.monotonic() - self._start

    def note(self, text: str) -> None:
        """Print a note at once."""
        if not self.quiet:
            self._print("note", text)

    def _print(self, kind: str, text: str) -> None:
        print(f"hrbfnpr: {kind}: {text}", file=sys.stderr, flush=True)
        detail = getattr(text, "detail", "")
        if self.verbose and detail:
            print(f"    {detail}", file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        """Print a line on stdout."""
        if not self.quiet:
            print(text, flush=True)

    def line(self, name: str, seconds: float, says: str = "") -> None:
        """Print the line of a finished stage.  The first call prints the line of the start before it."""
        if self._start_seconds is not None:
            seconds_of_start, self._start_seconds = self._start_seconds, None
            self.line("start", seconds_of_start, "Python and the library")
        self.say(f"{name:<12}{seconds:8.2f} s  {says}".rstrip())

    def summary(self, text: str) -> None:
        """Print the total time and the last line on stdout, and then the warnings."""
        seconds = self.seconds
        self.line("total", seconds)
        self.say(f"{text}, {seconds:.1f} s")
        self.finish()

    def finish(self) -> None:
        """Print the warnings and clear them."""
        for text in self.warnings:
            self._print("warning", text)
        self.warnings.clear()

    def begin(self, doing: str) -> Stage:
        if self._tqdm is None:
            return Stage(None)
        layout = "{desc:<18}{percentage:3.0f}% |{bar:30}| {elapsed}"
        # If the terminal does not report its width, tqdm ignores the layout and prints the unrounded fraction.
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


class PartReporter(_report.Reporter):
    """Passes notes and warnings on to another reporter, with a prefix, and does not show stages.

    It is for work within a stage of that reporter.

    Parameters
    ----------
    whole : Reporter
        The reporter that gets the notes and warnings.
    prefix : str
        Notes and warnings begin with it, except those whose codes are in `general`.
    skipped : tuple of str
        Notes with these codes are not passed on.
    """

    wording = lib.HRBFNPR_WORDING_OPTIONS
    general = ("lines_thin", "lines_end")  # codes of notes that are about the surface, not about one drawing

    def __init__(self, whole: Reporter, prefix: str, skipped: Any = ()) -> None:
        super().__init__()
        self._whole, self._prefix, self._skipped = whole, prefix, skipped

    def take_note(self, note: Note) -> None:
        if note.severity == "failure":
            self.failure = note
        elif note.code not in self._skipped:
            self._whole.take_note(note if not self._prefix or note.code in self.general else note.about(self._prefix))
