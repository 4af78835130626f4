# SPDX-License-Identifier: MIT
"""Reads the numbers of text files, all at once, and one by one to find the place of an error.

Lines are counted from 1.  So are columns, which are the words of a line.
"""
from __future__ import annotations

import re
import warnings
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._polygons import fans_of_block
from ._shape import Floats, Integers, ShapeError

_BLOCK = 1 << 24  # number of bytes that are examined together
_UTF16 = (b"\xff\xfe", b"\xfe\xff")
_CONTROL = bytes(set(range(1, 32)) - set(b"\t\n\v\f\r\x1a\x1b"))  # bytes of no text
# What Microsoft's C library writes for a number that is not finite: 1.#IND, -1.#INF00 and 1.#QNAN, or -nan(ind).
_ODD_NUMBER = re.compile(rb"(?:1\.#(?:(INF)|IND|QNAN|SNAN|J)\w*|nan\([a-z]*\))", re.I)


class Rows(NamedTuple):
    """The numbers of a text, line by line, without lines that have none.

    `values` are all numbers in order, `counts` the number of values on each line, and `lines` the line numbers.
    """

    values: Floats
    counts: Integers
    lines: Integers

    @property
    def starts(self) -> Integers:
        """Where each line begins in `values`."""
        result: Integers = np.cumsum(self.counts) - self.counts
        return result

    def table(self, width: int, what: str) -> Floats:
        """The first `width` numbers of each line."""
        short = np.flatnonzero(self.counts < width)
        if len(short):
            i = int(short[0])
            raise at(int(self.lines[i]), 0, f"{what} needs {width} numbers, and there are {self.counts[i]}")
        if len(self.counts) and (self.counts == self.counts[0]).all():
            return self.values.reshape(len(self.counts), -1)[:, :width]
        result: Floats = self.values[self.starts[:, None] + np.arange(width)]
        return result


def at(line: int, column: int, what: str) -> ShapeError:
    """An error with a line and a column; column 0 means the whole line."""
    return ShapeError(f"line {line}, column {column}: {what}" if column else f"line {line}: {what}")


def plain(data: bytes) -> bytes:
    """The text as UTF-8 without a byte-order mark, with line feeds at the ends of lines.  Raises an error if it is no text."""
    if data[:2] in _UTF16:
        data = data.decode("utf-16", errors="replace").encode()
    elif data[:3] == b"\xef\xbb\xbf":
        data = data[3:]
    elif b"\0" in data:
        data = _without_zeros(data)
    return usual_numbers(data.replace(b"\r\n", b"\n").replace(b"\r", b"\n"))


def _without_zeros(data: bytes) -> bytes:
    """A text in which some programs leave zero bytes, or that is UTF-16 without a mark."""
    head = data[:4096]
    zeros = head.count(0)
    if len(head.translate(None, _CONTROL)) < len(head) or 2 * zeros > len(head):
        raise ShapeError("this is binary data, not text")
    for first, order in ((0, "utf-16-be"), (1, "utf-16-le")):
        if head[first::2].count(0) == zeros == len(head) // 2:
            return data.decode(order, errors="replace").encode()
    return data.replace(b"\0", b" ")


def usual_numbers(text: bytes) -> bytes:
    """The text with nan and inf as Python and NumPy write them."""
    if b".#" not in text and b"(" not in text:
        return text
    return _ODD_NUMBER.sub(lambda found: b"inf" if found.group(1) else b"nan", text)


def without_comments(text: bytes, marks: Sequence[bytes] = (b"#",)) -> bytes:
    """The same lines without comments."""
    for mark in marks:
        if mark in text:
            text = re.sub(re.escape(mark) + rb"[^\n]*", b"", text)
    return text


def numbers(text: bytes, first_line: int = 1, hint: str = "") -> Rows:
    """All numbers of a text whose words are separated by spaces.

    Parameters
    ----------
    first_line : int
        Number of the text's first line, for messages.
    hint : str
        What a message adds after a word that is no number.
    """
    text = usual_numbers(text)
    words, lines, counts = _words(text)
    with warnings.catch_warnings():
        # A word that is no number ends the parse, with a warning or an error by NumPy's version.
        warnings.simplefilter("ignore", DeprecationWarning)
        try:
            values = np.fromstring(text, dtype=np.float64, sep=" ")
        except ValueError:
            values = np.empty(0)
    if len(values) != words:
        values = _one_by_one(text, first_line, hint)
    return Rows(values, counts, lines + first_line)


def _words(text: bytes) -> Tuple[int, Integers, Integers]:
    """The number of words; the lines that have words, from 0; and the number of words of each."""
    codes = np.frombuffer(text, dtype=np.uint8)
    counts: List[Any] = []
    before, first = False, 0  # whether a word continues into the block; the first line of the block
    for start in range(0, len(codes), _BLOCK):
        block = codes[start : start + _BLOCK]
        word = block > 32
        begins = np.flatnonzero(word & ~np.concatenate([[before], word[:-1]]))
        ends = np.flatnonzero(block == 10)
        counts.append((first, np.bincount(np.searchsorted(ends, begins), minlength=len(ends) + 1)))
        before, first = bool(word[-1]), first + len(ends)
    per_line = np.zeros(first + 1, dtype=np.int64)
    for line, part in counts:
        per_line[line : line + len(part)] += part
    lines = np.flatnonzero(per_line)
    return int(per_line.sum()), lines, per_line[lines]


def _one_by_one(text: bytes, first_line: int, hint: str) -> Floats:
    """The numbers that Python accepts.  Raises an error at the first word that is none."""
    values: List[float] = []
    for number, line in enumerate(text.split(b"\n"), first_line):
        for column, word in enumerate(line.split(), 1):
            values.append(number_at(word, number, column, hint))
    return np.array(values, dtype=np.float64)


def about_count(said: Optional[int], found: int) -> Tuple[str, ...]:
    """A note if a file says another number of points than it has."""
    return () if said in (None, found) else (f"the file says {said} points, but it has {found}: these are read",)


def records(rest: bytes, size: int, said: int) -> int:
    """The number of records of `size` bytes in the rest of a file, without padding after those that the file announces."""
    there = len(rest) // size
    whole = len(rest) % size == 0 and rest[said * size :].strip(b"\0") != b""
    return there if there <= said or whole else said


def number_at(word: bytes, line: int, column: int, hint: str = "") -> float:
    """The number of a word.  Raises an error with the place if the word is no number."""
    try:
        return float(word)
    except ValueError:
        raise at(line, column, f"{shown(word)} is not a number{hint and '; ' + hint}") from None


def is_number(word: bytes) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def shown(word: bytes) -> str:
    """A word of a file in quotation marks, shortened if it is very long."""
    text = word.decode("utf-8", errors="replace")
    return repr(text if len(text) <= 40 else text[:37] + "...")


def whole(rows: Rows, what: str, least: int) -> Integers:
    """The values as whole numbers.  Raises an error at one that is not.  `least` words come before the values of a line."""
    with np.errstate(invalid="ignore"):
        result: Integers = rows.values.astype(np.int64)
    wrong = np.flatnonzero(result != rows.values)
    if len(wrong):
        i = int(wrong[0])
        line = int(np.searchsorted(rows.starts, i, side="right")) - 1
        column = i - int(rows.starts[line]) + 1 + least
        raise at(int(rows.lines[line]), column, f"{what} must be a whole number, not {rows.values[i]:g}")
    return result


def polygons(
    rows: Rows, counts: Integers, starts: Integers, values: Integers, points: Optional[Floats] = None
) -> Tuple[Integers, Integers]:
    """Triangles of polygons whose corners are runs of `values`, and the line of each; cut as by `fans_of_block`."""
    parts: List[Any] = []
    lines: List[Any] = []
    for size in np.unique(counts[counts >= 3]):
        which = np.flatnonzero(counts == size)
        corners = values[starts[which][:, None] + np.arange(size)]
        triangles = fans_of_block(corners, points)
        for i in range(int(size) - 2):
            parts.append(triangles[:, i])
            lines.append(np.column_stack([which, np.full(len(which), i)]))
    if not parts:
        return np.empty((0, 3), dtype=np.int64), np.empty(0, dtype=np.int64)
    order = np.lexsort(np.concatenate(lines).T[::-1])
    return np.concatenate(parts)[order], rows.lines[np.concatenate(lines)[order, 0]]


def check_indices(triangles: Integers, lines: Integers, count: int, first: int = 0) -> None:
    """Raise an error for a corner that is no vertex, with its number and line.  `first` is the number of the first vertex."""
    wrong = np.flatnonzero(((triangles < 0) | (triangles >= count)).any(axis=1))
    if len(wrong) == 0:
        return
    i = int(wrong[0])
    index = next(int(v) for v in triangles[i] if not 0 <= v < count)
    raise at(int(lines[i]), 0, out_of_range(index + first, count, first))


def out_of_range(index: int, count: int, first: int = 0, what: str = "face") -> str:
    """The message for a face that names a missing vertex."""
    if count > 1:
        return f"a {what} names vertex {index}, but there are {count} vertices, {first} to {count - 1 + first}"
    return f"a {what} names vertex {index}, but there " + (f"is one vertex, {first}" if count else "are no vertices")
