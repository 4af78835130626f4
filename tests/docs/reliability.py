# SPDX-License-Identifier: MIT
"""The commands in docs/reliability.md name existing tests, scripts and programs.

    reliability.py PROJECT BUILD

A filter that matches no test would run nothing and pass.
"""
import re
import shlex
import subprocess
import sys
from pathlib import Path


def commands(text):
    """The code in the last column of the table of promises."""
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)]
        if len(cells) == 6 and not set(cells[1]) <= set("- "):
            yield from re.findall(r"`([^`]+)`", cells[4])


def tests_of(program, test_filter):
    listed = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={test_filter}"], capture_output=True, text=True,
                            check=True)  # fmt: skip
    return sum(line.startswith("  ") for line in listed.stdout.splitlines())


def fault(command, project, build):
    """The error of a command in words, or None."""
    words = shlex.split(command)
    if words[0].startswith("test_"):
        program = build / "tests" / words[0].removeprefix("test_") / words[0]
        filters = [word.split("=", 1)[1] for word in words if word.startswith("--gtest_filter=")]
        return None if all(tests_of(program, each) for each in filters) and filters else "no test has this name"
    if words[0] == "ctest":
        listed = subprocess.run(["ctest", "-N", "-R", words[words.index("-R") + 1]], cwd=build, capture_output=True, text=True,
                                check=True)  # fmt: skip
        return "no test has this name" if "Total Tests: 0" in listed.stdout else None
    if "/" in words[0]:
        return None if (project / words[0]).is_file() else "there is no such file"
    if words[0] == "soak":
        return None if (project / "tests" / "soak" / "soak.cpp").is_file() else "there is no such program"
    return "not a command that is known here"


def main():
    project, build = map(Path, sys.argv[1:3])
    found = list(commands((project / "docs" / "reliability.md").read_text(encoding="utf-8")))
    faults = [(command, wrong) for command in found if (wrong := fault(command, project, build))]
    for command, wrong in faults:
        print(f"docs/reliability.md: {command}: {wrong}")
    print(f"{len(found)} commands, {len(faults)} of which name what is not there")
    return 1 if faults or len(found) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
