# SPDX-License-Identifier: MIT
"""Damages files of every format that hrbfnpr.shapes reads, and reads them. Only ShapeError may be raised.

    fuzz_readers.py [--runs N | --seconds N] [--seed N] [--keep FOLDER] [FILE...]

First it reads the given files, then the undamaged files of reader_files.py, then damaged ones: N files, or for N seconds.
A reader fails if it raises another exception, takes more than ten seconds, or uses more than 2 GiB. The file is then
reduced as long as the failure stays the same, and kept. The last lines count the files that were read, by format.
"""
import argparse
import hashlib
import random
import re
import resource
import signal
import sys
import tempfile
import time
import traceback
import warnings
from pathlib import Path

import reader_files

from hrbfnpr import shapes

SECONDS = 10  # processor time
BYTES = 2 << 30
WORDS = [
    b"0", b"-1", b"1", b"2", b"3", b"255", b"256", b"65536", b"2147483647", b"2147483648", b"-2147483649",
    b"4294967295", b"9223372036854775807", b"18446744073709551616", b"1e9", b"1e308", b"1e309", b"-1e-320", b"nan",
    b"-nan", b"inf", b"-infinity", b"0x10", b"1_000", b"1.5", b".", b"-", b"+", b"1e", b"", b"9" * 400, b"9" * 5000,
    b"true", b"null", b"[]", b"{}", b'""', b"[" * 2000, b'{"a":' * 2000, b"\xff", b"\0", b"\xe2\x82\xac", b"float",
    b"list", b"char", b"double", b"int64", b"element", b"property", b"end_header", b"v", b"f", b"vn", b"\\\n", b"\n",
    b"\r", b"#", b"//", b"NaN", b"Infinity", b"1.#IND", b"nan(ind)", b"\x1f\x8b", b"ply", b"OFF", b"solid", b"DATA", b"FIELDS", b"P2 1 1 1 ",
    b"ncols",
]  # fmt: skip


class TooSlow(BaseException):
    """Raised when a reader takes too long."""


def damaged(data, others, chance):
    """Changes, removes, doubles, inserts or cuts off a few bytes, words or lines."""
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 1, 2, 3, 6))):
        CHANGES[chance.randrange(len(CHANGES))](data, others, chance)
    return bytes(data)


def change_byte(data, others, chance):
    if data:
        at = chance.randrange(len(data))
        data[at] = chance.choice((chance.randrange(256), data[at] ^ 1 << chance.randrange(8), 0, 255))


def change_number(data, others, chance):
    """Overwrites two, four or eight bytes with an interesting number."""
    if len(data) >= 8:
        at, size = chance.randrange(len(data) - 7), chance.choice((2, 4, 8))
        number = chance.choice((0, 1, 2, 2**7, 2**15, 2**16, 2**31 - 1, 2**31, 2**32 - 1, 2**63 - 1, 2**64 - 1))
        data[at : at + size] = (number % 256**size).to_bytes(size, chance.choice(("little", "big")))


def change_word(data, others, chance):
    """Replaces a number or name in a text, or in the header of a binary file."""
    found = list(re.finditer(rb"[-+.\w]+", data[:4000]))
    if found:
        word = chance.choice(found)
        data[word.start() : word.end()] = chance.choice((chance.choice(WORDS), chance.choice(found).group()))


def cut(data, others, chance):
    if data:
        at = chance.randrange(len(data))
        del data[at : at + chance.choice((1, 4, 40, len(data)))]


def double(data, others, chance):
    if data:
        at = chance.randrange(len(data))
        data[at:at] = data[at : at + chance.choice((1, 4, 30, 300))]


def insert(data, others, chance):
    at = chance.randrange(len(data) + 1)
    data[at:at] = chance.choice(WORDS)


def change_line(data, others, chance):
    """Removes, doubles or moves a line."""
    lines = data.split(b"\n")
    line = lines.pop(chance.randrange(len(lines)))
    for _ in range(chance.choice((0, 1, 2))):
        lines.insert(chance.randrange(len(lines) + 1), line)
    data[:] = b"\n".join(lines)


def splice(data, others, chance):
    """Replaces the end by the end of another file."""
    other = chance.choice(others)
    at = chance.randrange(len(data) + 1)
    data[at:] = other[min(at, len(other)) if chance.random() < 0.5 else chance.randrange(len(other) + 1) :]


CHANGES = [change_byte, change_number, change_word, change_word, cut, double, insert, change_line, splice]


def use(path):
    """Reads a file and then uses the shape, as the command line does."""
    shape = shapes.read(path)
    if shape.is_mesh:
        shapes.mesh_facts(shape)
    if shape.is_mesh or shape.normals is not None:
        shapes.samples(shape, min(20, len(shape.points)))


def outcome(path):
    """"read", "refused" or "failed", and the trace of a failure."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        use(path)
        return "read", None
    except shapes.ShapeError as error:
        if not str(error) or "\n" in str(error):
            return "failed", f"a message of one line is missing: {error!r}"
        return "refused", None
    except (Exception, SystemExit, TooSlow):
        return "failed", traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def same_failure(trace):
    """The properties that two equal failures share: the exception, and the line in the package."""
    places = re.findall(r'File ".*?(hrbfnpr/.*?)", line (\d+)', trace)
    return trace.strip().split("\n")[-1].split(":")[0], places[-1:]


def smaller(data, path, trace):
    """Removes bytes that the failure does not need, for half a minute."""
    end, size = time.monotonic() + 30, max(1, len(data) // 2)
    while size >= 1 and time.monotonic() < end:
        at = 0
        while at < len(data) and time.monotonic() < end:
            less = data[:at] + data[at + size :]
            path.write_bytes(less)
            kind, other = outcome(path)
            if kind == "failed" and same_failure(other) == same_failure(trace):
                data = less
            else:
                at += size
        size //= 2
    return data


class Runs:
    """Counts the files that were read, by format."""

    def __init__(self, folder, keep):
        self._folder, self._keep = folder, keep
        self.counts = {}
        self.failures = {}

    def run(self, name, data):
        path = self._folder / name
        path.write_bytes(data)
        kind, trace = outcome(path)
        counts = self.counts.setdefault(name, {"read": 0, "refused": 0, "failed": 0})
        counts[kind] += 1
        if trace is not None and str(same_failure(trace)) not in self.failures:
            self.failures[str(same_failure(trace))] = trace
            data = smaller(data, path, trace)
            self._keep.mkdir(parents=True, exist_ok=True)
            kept = self._keep / f"{hashlib.sha1(data).hexdigest()[:12]}-{name}"
            kept.write_bytes(data)
            print(f"{kept}:\n{trace}", flush=True)
        path.unlink()

    def table(self):
        print(f"{'file':<16}{'runs':>9}{'read':>9}{'refused':>9}{'failed':>9}")
        for name, counts in sorted(self.counts.items()):
            print(f"{name:<16}{sum(counts.values()):>9}" + "".join(f"{counts[k]:>9}" for k in counts))
        total = sum(sum(counts.values()) for counts in self.counts.values())
        print(f"readers: {total} files executed, {len(self.failures)} failures")
        return total


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=0.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, default=Path("crashes"))
    parser.add_argument("files", type=Path, nargs="*")
    return parser.parse_args()


def too_slow(number, frame):
    raise TooSlow(f"more than {SECONDS} seconds")


def main():
    given = arguments()
    signal.signal(signal.SIGPROF, too_slow)
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    warnings.simplefilter("ignore")
    whole = reader_files.files()
    chance = random.Random(given.seed)
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(Path(folder), given.keep)
        for path in given.files:
            # Kept files are named "HASH-name.ending".
            runs.run(path.name.partition("-")[2] or path.name, path.read_bytes())
        for name, data in whole.items():
            runs.run(name, data)
        names, others = list(whole), list(whole.values())
        end, count = time.monotonic() + given.seconds, 0
        while count < given.runs or time.monotonic() < end:
            name = chance.choice(names)
            runs.run(name, damaged(whole[name], others, chance))
            count += 1
        total = runs.table()
    sys.exit(1 if runs.failures or total == 0 else 0)


if __name__ == "__main__":
    main()
