# SPDX-License-Identifier: MIT
"""workflows.py passes a small correct workflow, and finds each fault of a wrong one."""

import importlib.util
import tempfile
import unittest
from pathlib import Path

import workflows

COMMIT = "0123456789abcdef0123456789abcdef01234567"
CLEAN = f"""# Builds everything.
#
# Not run yet: this workflow.
name: build
on: push
permissions:
  contents: read
concurrency:
  group: build
jobs:
  test:
    runs-on: somewhere
    timeout-minutes: 10
    steps:
      - uses: actions/checkout@{COMMIT} # v1.0.2
      - run: scripts/test --all
      - run: cmake --preset release && cmake --build --preset release && ctest --preset release
      - run: |
          if test -n "${{{{ matrix.name }}}}"; then
            echo it
          fi
"""
# Text of the clean workflow, text in its place, a word of the finding
FAULTS = [
    ("jobs:\n", "jobs: [\n", "parsed"),
    ("# Not run yet: this workflow.\n", "", "not run"),
    ("  contents: read\n", "  contents: write\n", "permission"),
    ("permissions:\n  contents: read\n", "", "permission"),
    ("concurrency:\n  group: build\n", "", "concurrency"),
    ("    timeout-minutes: 10\n", "", "timeout-minutes"),
    (f"@{COMMIT}", "@v1", "commit"),
    (" # v1.0.2", "", "commit"),
    ("scripts/test --all", "scripts/best --all", "scripts/best"),
    ("scripts/test --all", "scripts/test --some", "--some"),
    ("cmake --preset release", "cmake --preset hidden", "--preset hidden"),
    ("ctest --preset release", "ctest --preset debug", "ctest --preset debug"),
    ("          fi\n", "", "bash"),
    ("    runs-on: somewhere\n", "    runs-on: somewhere\n    env: {NAME: tests/nothing.py}\n", "tests/nothing.py"),
]
PRESETS = """{"configurePresets": [{"name": "release"}, {"name": "debug"}, {"name": "hidden", "hidden": true}],
 "buildPresets": [{"name": "release"}], "testPresets": [{"name": "release"}]}"""


@unittest.skipIf(importlib.util.find_spec("yaml") is None, "there is no yaml here (Debian: python3-yaml)")
class Rules(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.write("CMakePresets.json", PRESETS)
        self.write("scripts/test", "# scripts/test --all\n")
        self.write(".github/workflows/build.yml", CLEAN)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def test_a_correct_workflow_passes(self):
        self.assertEqual(list(workflows.rules(self.root)), [])

    def test_each_fault_is_found(self):
        for before, after, word in FAULTS:
            with self.subTest(after=after, word=word):
                self.assertEqual(CLEAN.count(before), 1)
                self.write(".github/workflows/build.yml", CLEAN.replace(before, after))
                found = "\n".join(workflows.rules(self.root))
                self.assertIn(word, found)

    def test_an_action_has_one_commit_everywhere(self):
        self.write(".github/workflows/second.yml", CLEAN.replace(COMMIT, COMMIT[::-1]))
        self.assertIn("another commit", "\n".join(workflows.rules(self.root)))

    def test_no_workflow_is_a_finding(self):
        (self.root / ".github/workflows/build.yml").unlink()
        self.assertNotEqual(list(workflows.rules(self.root)), [])


if __name__ == "__main__":
    unittest.main()
