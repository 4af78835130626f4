# SPDX-License-Identifier: MIT
"""scripts/out_of_turn.py: all turns together run every test, and what its lists name exists.

    turns_test.py SOURCE BINARY
"""

import functools
import re
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE, BINARY = (Path(path) for path in sys.argv[1:3])
TURNS = int(re.search(r"^ *turns=(\d+)$", (SOURCE / "scripts/test").read_text(), re.MULTILINE).group(1))
LISTS = ("long.txt", "in_turn_when_checked.txt")


def listed():
    told = subprocess.run(["ctest", "--test-dir", str(BINARY), "-N"], check=True, capture_output=True, text=True).stdout
    return told, re.findall(r"^ *Test +#\d+: (.*)$", told, re.MULTILINE)


TOLD, NAMES = listed()


def pattern_of(turn, take_turns, told=TOLD, never=()):
    script = [sys.executable, "-B", str(SOURCE / "scripts/out_of_turn.py"), str(turn), str(TURNS)]
    files = [str(SOURCE / "tests" / name) for name in ("every_turn.txt", take_turns, *never)]
    return subprocess.run([*script, *files], input=told, check=True, capture_output=True, text=True).stdout.strip()


@functools.lru_cache(maxsize=None)
def left_out(turn, take_turns, told=TOLD, names=tuple(NAMES)):
    pattern = pattern_of(turn, take_turns, told)
    return {name for name in names if re.search(pattern, name)}


def patterns(name):
    return [line for line in (SOURCE / "tests" / name).read_text().splitlines() if line]


class Turns(unittest.TestCase):
    def test_each_test_has_one_turn(self):
        for take_turns in LISTS:
            out = [left_out(turn, take_turns) for turn in range(TURNS)]
            self.assertFalse(set.intersection(*out))
            for name in set.union(*out):
                self.assertEqual(sum(name in one for one in out), TURNS - 1, name)
            kept = [len(NAMES) - len(one) for one in out]
            self.assertLessEqual(max(kept) - min(kept), len(LISTS))

    def test_names_that_several_tests_have_are_one(self):
        told = "".join(f"  Test #{i}: soak.twice\n" for i in range(TURNS))
        out = [left_out(turn, "long.txt", told, ("soak.twice",)) for turn in range(TURNS)]
        self.assertEqual(sum(len(one) for one in out), TURNS - 1)

    def test_some_are_in_every_turn(self):
        always = [name for name in NAMES if any(re.search(one, name) for one in patterns("every_turn.txt"))]
        self.assertIn("soak.short", always)
        for take_turns in LISTS:
            for turn in range(TURNS):
                self.assertFalse(left_out(turn, take_turns) & set(always))

    def test_short_ones_are_too(self):
        for turn in range(TURNS):
            self.assertNotIn("house.floors", left_out(turn, "long.txt"))

    def test_ctest_leaves_out_what_it_is_told_to(self):
        for take_turns, never in zip(LISTS, ((), ("long_when_checked.txt",))):
            always = [one for name in never for one in patterns(name)]
            pattern = "|".join([*always, pattern_of(0, take_turns, TOLD, never)])
            command = ["ctest", "--test-dir", str(BINARY), "-N", "-E", pattern]
            told = subprocess.run(command, check=True, capture_output=True, text=True)
            self.assertNotIn("too big", told.stdout + told.stderr)
            kept = {name for name in NAMES if not re.search(pattern, name)}
            self.assertEqual(set(re.findall(r"^ *Test +#\d+: (.*)$", told.stdout, re.MULTILINE)), kept)

    def test_what_is_named_exists(self):
        for file in ("every_turn.txt", "in_turn_when_checked.txt"):
            for one in patterns(file):
                if one.startswith("^sanitized"):  # which the other build has
                    continue
                self.assertTrue(any(re.search(one, name) for name in NAMES), f"{file}: {one} is no test")


if __name__ == "__main__":
    if "soak.short" not in NAMES or "fuzz.mesh" not in NAMES:
        print("skipped: not all test programs are built")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
