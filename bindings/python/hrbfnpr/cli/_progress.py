# SPDX-License-Identifier: MIT
"""What is told to the user on the way: progress bars and notes, on stderr."""
from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import Any, Iterator


class Reporter:
    """Bars where stderr is a terminal and tqdm is installed; nothing if quiet."""

    def __init__(self, quiet: bool, bars: bool = True, about: str = "") -> None:
        self.quiet, self._about = quiet, about
        self._tqdm: Any = None
        if bars and not quiet and sys.stderr.isatty():
            try:
                from tqdm import tqdm

                self._tqdm = tqdm
            except ImportError:
                pass

    def note(self, text: str) -> None:
        if not self.quiet:
            print(f"hrbfnpr: note: {self._about}{text}", file=sys.stderr)

    def without_bars(self, about: str = "") -> "Reporter":
        """Its notes alone, for what is part of a stage; they begin with what they are about."""
        return Reporter(self.quiet, bars=False, about=f"{about}: " if about else "")

    @contextmanager
    def stage(self, name: str) -> Iterator[Any]:
        """A bar for the `progress` of a long call, or None."""
        if self._tqdm is None:
            yield None
            return
        layout = "{desc:<16}{percentage:3.0f}% |{bar:40}| {elapsed}"
        with self._tqdm(total=1.0, desc=name, bar_format=layout, file=sys.stderr) as bar:
            yield bar
            bar.update(1.0 - bar.n)
