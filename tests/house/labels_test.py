# SPDX-License-Identifier: MIT
"""Every test has the label `short` or `long`, and each filter that gives a label matches a test.

    labels_test.py BINARY
"""

import fnmatch
import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

BINARY = Path(sys.argv[1])
KINDS = ("LONG", "LONG_UNCHECKED", "UNCHECKED")


def listed(program):
    """The tests of a GoogleTest program."""
    told = subprocess.run([str(program), "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    suite = ""
    for line in told.splitlines():
        name = line.split("#")[0].rstrip()
        if not name.startswith(" "):
            suite = name
        elif suite.endswith("."):
            yield suite + name.strip()


class Labels(unittest.TestCase):
    def test_each_test_is_short_or_long(self):
        told = subprocess.run(["ctest", "--test-dir", str(BINARY), "--show-only=json-v1"], check=True, capture_output=True)
        tests = json.loads(told.stdout)["tests"]
        self.assertGreater(len(tests), 1000)
        for test in tests:
            if test["name"].endswith("_NOT_BUILT"):
                continue
            labels = [p["value"] for p in test.get("properties", ()) if p["name"] == "LABELS"]
            words = re.findall(r"\w+", " ".join(label for some in labels for label in some))
            self.assertEqual(words.count("short") + words.count("long"), 1, test["name"])

    def test_each_filter_matches_a_test(self):
        files = list((BINARY / "tests").rglob("*.filters"))
        self.assertGreater(len(files), 20)
        missing = []
        for file in files:
            program = file.with_suffix("")
            if not program.exists():
                continue
            tests = list(listed(program))
            for line in file.read_text().split("\n"):
                kind, _, one = line.partition(" ")
                if one and not (kind in KINDS and any(fnmatch.fnmatchcase(name, one) for name in tests)):
                    missing.append(f"{file.name}: {line}")
        self.assertEqual(missing, [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
