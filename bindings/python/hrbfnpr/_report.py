# SPDX-License-Identifier: MIT
"""What a call tells its caller: warnings as Python's, notes for who asks, progress by a function or a bar."""
from __future__ import annotations

import sys
import warnings
from contextlib import contextmanager
from typing import Any, Callable, Iterator, List, Optional, Tuple, Union

from ._library import ffi, lib

Progress = Union[None, bool, Callable[[str, float], Any], Any]
"""A function of a stage's name and a fraction in [0, 1]; a tqdm bar; or True for a bar of its own."""

_NOTES = {ffi.integer_const(name): name[13:].lower() for name in dir(lib) if name.startswith("HRBFNPR_NOTE_")}
SEVERITIES = ("info", "note", "warning", "failure")


class Note(str):
    """A short sentence that says what was chosen, repaired or left out.

    Attributes
    ----------
    code : str
        The library's name of it, such as "parts_inside"; empty of what a file's reader says.
    severity : {"info", "note", "warning", "failure"}
    figures : tuple of float
        Its numbers.
    advice : str
        What to do about it; empty if the sentence says it or nothing needs doing.
    detail : str
        One or two more sentences that explain the note; empty if none.
    """

    code = ""
    advice = ""
    detail = ""
    severity = "note"
    figures: Tuple[float, ...] = ()

    @classmethod
    def of(cls, struct: Any) -> Note:
        """A hrbfnpr_note."""
        note = cls(ffi.string(struct.text).decode("utf-8", "replace"))
        note.code, note.severity = _NOTES.get(struct.code, str(struct.code)), SEVERITIES[struct.severity]
        note.figures = tuple(struct.figures[0 : struct.figure_count])
        if struct.advice != ffi.NULL:
            note.advice = ffi.string(struct.advice).decode("utf-8", "replace")
        if struct.detail != ffi.NULL:
            note.detail = ffi.string(struct.detail).decode("utf-8", "replace")
        return note

    def about(self, what: str) -> Note:
        """The same, and what it is about."""
        note = Note(f"{what}: {self}")
        note.code, note.severity, note.figures = self.code, self.severity, self.figures
        note.advice, note.detail = self.advice, self.detail
        return note


class DrawingWarning(UserWarning):
    """Something may be wrong with a drawing; the message says what.

    Attributes
    ----------
    note : Note
        The message, with its code, figures and detail.
    """

    def __init__(self, note: str) -> None:
        super().__init__(str(note))
        self.note = note if isinstance(note, Note) else Note(note)


class Stage:
    """A part of the work while it runs.

    Attributes
    ----------
    bar : progress bar or None
        For the `progress` of a long call.
    says : str
        What it came to, for the line that is printed of it.
    """

    def __init__(self, bar: Any) -> None:
        self.bar = bar
        self.says = ""

    def reach(self, fraction: float) -> None:
        """Let the bar show this."""
        if self.bar is not None:
            self.bar.update(fraction - self.bar.n)


class Reporter:
    """Takes what a library's picture tells: notes and stages.  This one keeps notes and warnings, and shows nothing."""

    wording = lib.HRBFNPR_WORDING_ARGUMENTS

    def __init__(self) -> None:
        self.notes: List[Note] = []
        self.warnings: List[Note] = []
        self.failure: Optional[Note] = None
        self._stage: Optional[Stage] = None

    def note(self, text: str) -> None:
        """What is good to know."""
        self.notes.append(text if isinstance(text, Note) else Note(text))

    def warn(self, text: str) -> None:
        """What may be wrong with the result, once."""
        if text not in self.warnings:
            self.warnings.append(text if isinstance(text, Note) else Note(text))

    def say(self, text: str) -> None:
        """A measurement."""

    def begin(self, doing: str) -> Stage:
        """A stage starts."""
        return Stage(None)

    def end(self, stage: Stage, name: str, seconds: float) -> None:
        """A stage is over."""

    def drop(self, stage: Stage) -> None:
        """A stage failed."""

    @contextmanager
    def stage(self, name: str, doing: str) -> Iterator[Stage]:
        """A part of the work that is Python's own."""
        import time

        start, stage = time.monotonic(), self.begin(doing)
        try:
            yield stage
        except BaseException:
            self.drop(stage)
            raise
        self.end(stage, name, time.monotonic() - start)

    def take(self, event: Any) -> None:
        """A hrbfnpr_picture_event."""
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
        """By its severity."""
        if note.severity == "failure":
            self.failure = note
        else:
            {"info": self.say, "note": self.note, "warning": self.warn}[note.severity](note)

    def fail(self) -> None:
        """The call failed: its stage is not to be ended."""
        stage, self._stage = self._stage, None
        if stage is not None:
            self.drop(stage)


class _Bar:
    """What the stages take for a progress bar, which tells a function."""

    total = 1.0

    def __init__(self, doing: str, tell: Callable[[str, float], Any]) -> None:
        self.n = 0.0
        self._doing, self._tell = doing, tell

    def update(self, step: float) -> None:
        self.n += step
        self._tell(self._doing, min(1.0, max(0.0, self.n)))


class CallReport(Reporter):
    """Of `hrbfnpr.draw` and its kin; `told` is the function that is told of progress, if there is one."""

    def __init__(self, progress: Progress = None) -> None:
        super().__init__()
        self.told: Optional[Callable[[str, float], Any]] = _teller(progress)

    def begin(self, doing: str) -> Stage:
        if self.told is None:
            return Stage(None)
        self.told(doing, 0.0)
        return Stage(_Bar(doing, self.told))

    def end(self, stage: Stage, name: str, seconds: float) -> None:
        if stage.bar is not None and stage.bar.n < 1.0:
            stage.reach(1.0)

    def taken(self) -> List[Note]:
        """The warnings, which are then gone."""
        told, self.warnings = self.warnings, []
        return told

    def finish(self) -> None:
        """Raise Python's warnings, for the line that called this package."""
        depth = _depth_of_caller()
        for text in self.taken():
            warnings.warn(DrawingWarning(text), stacklevel=depth)


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
