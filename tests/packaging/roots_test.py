# SPDX-License-Identifier: MIT
"""The parts of the bare systems that need no system."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "packaging"))

import roots  # noqa: E402
import test_release  # noqa: E402
from common import PLATFORMS  # noqa: E402


class Mirror(unittest.TestCase):
    def test_deb822(self):
        text = "Types: deb\n# http://example.org/debian\nURIs: http://mirror.example/debian/\nSuites: bookworm\n"
        self.assertEqual(roots.mirror(text), "http://mirror.example/debian")

    def test_one_line(self):
        for line in ("deb http://mirror.example/debian bookworm main",
                     "deb [signed-by=/x.gpg arch=amd64] http://mirror.example/debian/ bookworm main"):
            self.assertEqual(roots.mirror("deb http://mirror.example/ubuntu x\n" + line), "http://mirror.example/debian")

    def test_other_archives_are_not_taken(self):
        for line in ("deb http://mirror.example/debian-security bookworm-security main", "# deb http://a.example/debian x",
                     "deb-src http://a.example/debian x", ""):
            self.assertEqual(roots.mirror(line), "")


class Trials(unittest.TestCase):
    def test_the_result_says_why(self):
        def failing():
            roots.execute("sh", "-c", "echo first; echo 'the last word'; exit 3")

        self.assertEqual(roots.attempt_row("a.whl", "here", failing).result, "failed: the last word")
        self.assertEqual(roots.attempt_row("a.whl", "here", lambda: roots.refuse("needs root")).result,
                         "skipped: needs root")
        self.assertEqual(roots.attempt_row("a.whl", "here", lambda: "11").picture, "11")

    def test_the_output_of_a_command_is_returned(self):
        self.assertEqual(roots.execute("echo", "word"), "word\n")

    def test_a_failure_names_the_command(self):
        with self.assertRaisesRegex(roots.Failed, "^sh -c 'exit 3' ended with 3"):
            roots.execute("sh", "-c", "exit 3")


class Natives(unittest.TestCase):
    def test_the_library_is_the_file_and_not_a_link(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for file in ("linux-x64/lib/libhrbfnpr.so.1.0", "win-x64/bin/libhrbfnpr.dll", "win-x64/lib/libhrbfnpr.dll.a"):
                (folder / file).parent.mkdir(parents=True, exist_ok=True)
                (folder / file).touch()
            (folder / "linux-x64/lib/libhrbfnpr.so").symlink_to("libhrbfnpr.so.1.0")
            found = test_release.libraries(folder)
            self.assertEqual({rid: native.library.name for rid, native in found.items()},
                             {"linux-x64": "libhrbfnpr.so.1.0", "win-x64": "libhrbfnpr.dll"})
            self.assertEqual(found["linux-x64"].platform, PLATFORMS["linux-x64"])
            self.assertEqual(found["linux-x64"].folder, folder / "linux-x64")


if __name__ == "__main__":
    unittest.main()
