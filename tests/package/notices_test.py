# SPDX-License-Identifier: MIT
"""THIRD-PARTY-NOTICES.md has a section for every library that a package can contain."""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))
import common  # noqa: E402


def sections(text):
    return re.findall(r"^## (.+)$", text, re.MULTILINE)


class Notices(unittest.TestCase):
    def test_each_platform_has_the_sections_of_its_libraries(self):
        for platform in common.PLATFORMS.values():
            with self.subTest(platform.rid):
                names = [*common.HEADERS, *platform.runtimes]
                text = common.notices(names)
                self.assertEqual(sorted(sections(text)), sorted(names))
                self.assertTrue(text.startswith("# Third-party notices\n"))

    def test_webassembly_has_a_section(self):
        self.assertEqual(sections(common.notices(["Emscripten"])), ["Emscripten"])

    def test_a_name_without_a_section_is_an_error(self):
        with self.assertRaisesRegex(SystemExit, "has no section Missing"):
            common.notices(["Eigen", "Missing"])

    def test_a_section_that_is_referred_to_is_in_every_package(self):
        text = (ROOT / "THIRD-PARTY-NOTICES.md").read_text(encoding="utf-8")
        referred = set(re.findall(r"in the\s+section ([\w+]+)", text))
        self.assertEqual(referred, {"Highway"})
        self.assertIn("Highway", common.HEADERS)
        self.assertIn("TERMS AND CONDITIONS FOR USE, REPRODUCTION, AND DISTRIBUTION", common.notices(["Highway"]))


if __name__ == "__main__":
    unittest.main()
