# SPDX-License-Identifier: MIT
"""The rows that the try_*.py modules return, and the table that they form."""
from __future__ import annotations

import os
from collections import Counter
from dataclasses import astuple, dataclass, replace
from typing import Iterable, List, Sequence, Set

LONG = "HRBFNPR_LONG_TRIALS"  # set in the environment if trials may compile the library
COLUMNS = ("package", "where", "result", "picture")


@dataclass(frozen=True)
class Row:
    """One trial of one package in one place."""

    package: str  # the file name of the package
    where: str  # for example "bookworm, Python 3.11"
    result: str = "ok"  # "ok", "failed: WHY", "skipped: WHY" or "not run: WHY"
    picture: str = ""  # scene.picture_hash() of what the package drew, or "" if it drew nothing to compare

    @property
    def failed(self) -> bool:
        return not self.passed and not self.not_run

    @property
    def passed(self) -> bool:
        return self.result == "ok"

    @property
    def not_run(self) -> bool:
        return self.result.startswith(("not run:", "skipped:"))


def judged(rows: Sequence[Row]) -> List[Row]:
    """Return the rows, where each picture that differs from the most frequent one is a failure."""
    pictures = Counter(row.picture for row in rows if row.passed and row.picture)
    usual = pictures.most_common(1)[0][0] if pictures else ""
    return [replace(row, result="failed: another picture") if row.passed and row.picture not in ("", usual) else row
            for row in rows]


def closing_line(rows: Sequence[Row]) -> str:
    """Return the summary of rows that judged() returned."""
    tried = names(row for row in rows if not row.not_run)
    alike = names(row for row in rows if row.passed and row.picture) - names(row for row in rows if row.failed)
    missing = [f"{row.package} ({row.where})" if row.where else row.package for row in rows if row.not_run]
    line = f"{len(alike)} of {len(tried)} tried packages draw the same picture; {len(missing)} not run"
    return f"{line}: {', '.join(missing)}" if missing else line


def names(rows: Iterable[Row]) -> Set[str]:
    return {row.package for row in rows}


def table(rows: Sequence[Row]) -> str:
    """Return the rows as a Markdown table with aligned columns."""
    cells = [COLUMNS, *([one_line(cell) for cell in astuple(row)] for row in rows)]
    widths = [max(len(line[column]) for line in cells) for column in range(len(COLUMNS))]
    lines = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |" for line in cells]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([lines[0], rule, *lines[1:]])


def one_line(text: str) -> str:
    return " ".join(text.split()).replace("|", "/")


def report(rows: Sequence[Row]) -> str:
    """Return the table and the summary of the rows of all modules."""
    final = judged(rows)
    return f"{table(final)}\n\n{closing_line(final)}\n"


def status(rows: Sequence[Row]) -> int:
    """Return 1 if a row failed or two pictures differ, or else 0."""
    return int(any(row.failed for row in judged(rows)))


def long_trials() -> bool:
    return bool(os.environ.get(LONG))
