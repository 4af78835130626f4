#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run a program of this folder and compare what it prints and writes with expected.txt.

    compare.py TEST COMMAND...

The lines of expected.txt are `TEST LINE`.  A program must print these lines, and a line with a hash for each
file that it writes.  Lines `TEST ~ LINE` may differ, and are compared without their hashes: the quick starts take their
samples from the platform's sin and cos, caller uses the best instruction set of the processor, and compilers round one
number of the style hatch differently.
"""
import hashlib
import re
import subprocess
import sys
from pathlib import Path

EXPECTED = Path(__file__).resolve().with_name("expected.txt")
HASH = re.compile(r"\b[0-9a-f]{8}\b")


def expected(test):
    """Return (line, whether its hashes may differ) for each line of this test."""
    lines = []
    for line in EXPECTED.read_text(encoding="utf-8").splitlines():
        name, _, rest = line.partition(" ")
        if name == test:
            lines.append((rest[2:], True) if rest.startswith("~ ") else (rest, False))
    return lines


def printed(command):
    """Run the command in the current folder, which is emptied first.  Return its lines, and one for each file."""
    for path in Path().iterdir():
        path.unlink()
    result = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit(f"{result.stdout}the program ended with status {result.returncode}")
    lines = result.stdout.splitlines()
    for path in sorted(Path().iterdir()):
        lines.append(f"file {path.name} {hashlib.sha256(path.read_bytes()).hexdigest()[:8]}")
    return lines


def faults(found, wanted):
    """Yield what differs, and print the lines that may differ and do."""
    if len(found) != len(wanted):
        yield f"{len(found)} lines in place of {len(wanted)}"
    for line, (want, may_differ) in zip(found, wanted):
        if line == want:
            continue
        if may_differ and HASH.sub("", line) == HASH.sub("", want):
            print(f"differs, as it may: {line}; {want} was expected")
        else:
            yield f"{line}\n  in place of\n{want}"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    test, command = sys.argv[1], sys.argv[2:]
    found = printed(command)
    print(*(f"{test} {line}" for line in found), sep="\n")
    wrong = list(faults(found, expected(test)))
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
