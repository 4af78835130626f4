# SPDX-License-Identifier: MIT
"""Reporters: they receive the notes, warnings and progress of a call and pass them on to the user."""
from __future__ import annotations

import sys
import warnings
from contextlib import contextmanager
from typing import Any, Callable, Iterator, List, Optional, Tuple, Union

from ._library import ffi, lib

Progress = Union[None, bool, Callable[[str, float], Any], Any]
"""A function that gets a stage's name and a fraction in [0, 1]; a tqdm bar; or True, which makes a tqdm bar."""

_NOTE_CODES = {ffi.integer_const(name): name[13:].lower() for name in dir(lib) if name.startswith("HRBFNPR_NOTE_")}
SEVERITIES = ("info", "note", "warning", "failure")


class Note(str):
    """A short sentence about something that was chosen, repaired, left out or measured, or that may be wrong.

    Attributes
    ----------
    code : str
        The name of the code in the library, such as "parts_inside"; empty for a note from the reader of a file.
    severity : {"info", "note", "warning", "failure"}
        How much it matters.
    figures : tuple of float
        The numbers of the note, in the order that its code defines.
    advice : str
        What to do about it; empty if the sentence says it or nothing needs doing.
    detail : str
        One or two more sentences that explain the note; may be empty.
    """

    code = ""
    advice = ""
    detail = ""
    severity = "note"
    figures: Tuple[float, ...] = ()

    @classmethod
    def of(cls, struct: Any) -> Note:
        """Convert a hrbfnpr_note of the library."""
        note = cls(ffi.string(struct.text).decode("utf-8", "replace"))
        note.code, note.severity = _NOTE_CODES.get(struct.code, str(struct.code)), SEVERITIES[struct.severity]
        note.figures = tuple(struct.figures[0 : struct.figure_count])
        if struct.advice != ffi.NULL:
            note.advice = ffi.string(struct.advice).decode("utf-8", "replace")
        if struct.detail != ffi.NULL:
            note.detail = ffi.string(struct.detail).decode("utf-8", "replace")
        return note

    def about(self, what: str) -> Note:
        """A copy of the note whose text begins with `what` and a colon."""
        note = Note(f"{what}: {self}")
        note.code, note.severity, note.figures = self.code, self.severity, self.figures
        note.advice, note.detail = self.advice, self.detail
        return note


class DrawingWarning(UserWarning):
    """The warning that something may be wrong with a drawing.  The message names the problem.

    Attributes
    ----------
    note : Note
        The message, with its code, figures and detail.
    """

    def __init__(self, note: str) -> None:
        super().__init__(str(note))
        self.note = note if isinstance(note, Note) else Note(note)


class Stage:
    """A part of the work, while it runs.

    Attributes
    ----------
    bar : progress bar or None
        The bar that shows the progress of the stage.
    says : str
        The result of the stage in words.  The command line prints it when the stage ends.
    """

    def __init__(self, bar: Any) -> None:
        self.bar = bar
        self.says = ""

    def reach(self, fraction: float) -> None:
        """Move the bar to a fraction in [0, 1]."""
        if self.bar is not None:
            self.bar.update(fraction - self.bar.n)


class Reporter:
    """Receives the notes and stages of a picture.  This class keeps notes and warnings, and shows nothing.

    Subclasses show them.
    """

    wording = lib.HRBFNPR_WORDING_ARGUMENTS

    def __init__(self) -> None:
        self.notes: List[Note] = []
        self.warnings: List[Note] = []
        self.failure: Optional[Note] = None
        self._stage: Optional[Stage] = None

    def note(self, text: str) -> None:
        """Receive a note of severity "note"."""
        self.notes.append(text if isinstance(text, Note) else Note(text))

    def warn(self, text: str) -> None:
        """Receive a warning.  The same text is kept only once."""
        if text not in self.warnings:
            self.warnings.append(text if isinstance(text, Note) else Note(text))

    def say(self, text: str) -> None:
        """Receive a note of severity "info", such as a measurement."""

    def begin(self, doing: str) -> Stage:
        """Called when a stage begins.  `doing` names it for a progress bar."""
        return Stage(None)

    def end(self, stage: Stage, name: str, seconds: float) -> None:
        """Called when a stage has succeeded."""

    def drop(self, stage: Stage) -> None:
        """Called in place of `end` when a stage has failed."""

    @contextmanager
    def stage(self, name: str, doing: str) -> Iterator[Stage]:
        """A stage of work that is done in Python, not in the library."""
        import time

        start, stage = time.monotonic(), self.begin(doing)
        try:
            yield stage
        except BaseException:
            self.drop(stage)
            raise
        self.end(stage, name, time.monotonic() - start)

    def take(self, event: Any) -> None:
        """Receive a hrbfnpr_picture_event: a note, or the start, progress or end of a stage."""
        if event.note != ffi.NULL:
            self.take_note(Note.of(event.note))
        elif event.says != ffi.NULL:
            stage, self._stage = self._stage or self.begin(""), None
            stage.says = ffi.string(event.says).decode()
            self.end(stage, ffi.string(event.name).decode(), event.seconds)
        elif self._stage is None:
            self._stage = self.begin(ffi.string(event.doing).decode())
        else:
            self._stage.reach(event.fraction)

    def take_note(self, note: Note) -> None:
        """Pass a note to the method for its severity, or keep it if it is a failure."""
        if note.severity == "failure":
            self.failure = note
        else:
            {"info": self.say, "note": self.note, "warning": self.warn}[note.severity](note)

    def fail(self) -> None:
        """Called when a call of the library is over.  A stage that is still open has failed and is dropped."""
        stage, self._stage = self._stage, None
        if stage is not None:
            self.drop(stage)


class _FunctionBar:
    """A progress bar with the interface of tqdm.  It calls a progress function."""

    total = 1.0

    def __init__(self, doing: str, function: Callable[[str, float], Any]) -> None:
        self.n = 0.0
        self._doing, self._function = doing, function

    def update(self, step: float) -> None:
        self.n += step
        self._function(self._doing, min(1.0, max(0.0, self.n)))


class CallReport(Reporter):
    """The reporter of `hrbfnpr.draw` and similar functions.

    Attributes
    ----------
    told : function or None
        The progress function: it gets the name of the stage and a fraction in [0, 1].
    """

    def __init__(self, progress: Progress = None) -> None:
        super().__init__()
        self.told: Optional[Callable[[str, float], Any]] = _progress_function(progress)

    def begin(self, doing: str) -> Stage:
        if self.told is None:
            return Stage(None)
        self.told(doing, 0.0)
        return Stage(_FunctionBar(doing, self.told))

    def end(self, stage: Stage, name: str, seconds: float) -> None:
        if stage.bar is not None and stage.bar.n < 1.0:
            stage.reach(1.0)

    def taken(self) -> List[Note]:
        """Return the warnings and clear them."""
        taken, self.warnings = self.warnings, []
        return taken

    def finish(self) -> None:
        """Issue the warnings as Python warnings that point to the line of the user's code that called this package."""
        depth = _depth_of_caller()
        for text in self.taken():
            warnings.warn(DrawingWarning(text), stacklevel=depth)


def _depth_of_caller() -> int:
    """The `stacklevel` with which a warning in `finish` points to the first caller outside this package."""
    depth, frame = 1, sys._getframe(1)
    package = __name__.rpartition(".")[0]
    while frame.f_back is not None and str(frame.f_globals.get("__name__", "")).split(".")[0] == package:
        frame, depth = frame.f_back, depth + 1
    return depth


def _progress_function(progress: Progress) -> Optional[Callable[[str, float], Any]]:
    """The function that a `progress` argument means; None if there is no progress to show."""
    if progress is None or progress is False:
        return None
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ImportError("progress=True needs tqdm (Debian: python3-tqdm)") from error
        progress = tqdm(leave=False)
    if hasattr(progress, "update") and hasattr(progress, "n"):
        return _function_of_bar(progress)
    if not callable(progress):
        raise TypeError("progress must be a function of a stage's name and a fraction, a tqdm bar, or True")
    function: Callable[[str, float], Any] = progress
    return function


def _function_of_bar(bar: Any) -> Callable[[str, float], Any]:
    """A progress function that moves a tqdm bar."""
    stage = ""
    bar.total = 1.0
    if getattr(bar, "bar_format", "") is None:
        bar.bar_format = "{l_bar}{bar}| {elapsed}"

    def show(doing: str, fraction: float) -> None:
        nonlocal stage
        if doing != stage and hasattr(bar, "set_description"):
            bar.set_description(doing)
        stage = doing
        bar.update(fraction - bar.n)

    return show
