# SPDX-License-Identifier: MIT
"""The driver of the fuzzers counts the inputs it runs, and fails if it runs none.

    driver_test.py [-v] FUZZER...
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FUZZERS = []


def run(fuzzer, *paths):
    result = subprocess.run([fuzzer, *map(str, paths)], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return result.returncode, result.stdout


class DriverTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def expect(self, status, words, *paths):
        for fuzzer in FUZZERS:
            with self.subTest(fuzzer=Path(fuzzer).name):
                got, output = run(fuzzer, *paths)
                self.assertEqual(got, status, output)
                self.assertIn(words.format(name=Path(fuzzer).name), output)

    def test_the_empty_input_is_run(self):
        (self.folder / "empty").write_bytes(b"")
        self.expect(0, "{name}: 1 inputs executed", self.folder)

    def test_every_length_of_a_header_is_run(self):
        start = b"\x89HRB\r\n\x1a\n" + bytes(60)
        for length in range(len(start)):
            (self.folder / f"{length:02}").write_bytes(start[:length])
        self.expect(0, f"{{name}}: {len(start)} inputs executed", self.folder)

    def test_an_empty_corpus_fails(self):
        (self.folder / ".gitattributes").write_text("* -text\n")
        self.expect(1, "{name}: 0 inputs executed", self.folder)

    def test_no_corpus_fails(self):
        self.expect(1, "{name}: 0 inputs executed")

    def test_a_missing_corpus_fails(self):
        self.expect(1, "{name}: there is no", self.folder / "corpus")


if __name__ == "__main__":
    FUZZERS = [argument for argument in sys.argv[1:] if not argument.startswith("-")]
    unittest.main(argv=[sys.argv[0], *(argument for argument in sys.argv[1:] if argument.startswith("-"))])
