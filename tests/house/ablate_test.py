# SPDX-License-Identifier: MIT
"""Tests how scripts/ablate.py reads, changes and compares constants.

    ablate_test.py PROJECT
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
sys.path.insert(0, str(PROJECT / "scripts"))

import ablate  # noqa: E402
import ablation_copy  # noqa: E402

TUNING = """#pragma once
namespace hrbfnpr::x {
struct XTuning {
    // A share.
    double share = 0.25;
    float width = 3.0F / 2.0F;
    std::int64_t most = 1'000;
    int rounds = 1;
    std::array<int, 2> others{1, 2};
};
inline constexpr XTuning x_tuning;
} // namespace hrbfnpr::x
"""
USES = """#include "x/tuning.h"
constexpr const XTuning& also = x_tuning;
constexpr double half = 0.5 * x_tuning.share;
double f() { return x_tuning.share + also.width + x::x_tuning.rounds; } // x_tuning.share
std::array<int, x_tuning.rounds> places;
auto g() { return x_tuning.others.size(); }
"""


class Ablation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.source = Path(folder.name)
        for room in ("x", "picture"):
            (self.source / room).mkdir()
        (self.source / "x" / "tuning.h").write_text(TUNING)
        (self.source / "x" / "f.cpp").write_text(USES)

    def test_constants_are_found_and_moved(self):
        found = list(ablation_copy.constants_of(self.source, self.source / "x" / "tuning.h"))
        self.assertEqual([c.name for c in found], [f"x:x_tuning.{m}" for m in ("share", "width", "most", "rounds")])
        self.assertEqual([ablate.value_of(c.text) for c in found], [0.25, 1.5, 1000, 1])
        self.assertEqual([ablate.moved(c, 0.5) for c in found], [0.125, 0.75, 500, 1])
        self.assertEqual([ablate.moved(c, 2.0) for c in found], [0.5, 3, 2000, 2])

    def test_uses_of_constants_are_replaced(self):
        _, fixed = ablation_copy.rewrite(self.source)
        self.assertEqual(fixed, {"x": ["x_tuning.share", "x_tuning.rounds"]})
        text = (self.source / "x" / "f.cpp").read_text()
        looks = "HRBFNPR_TUNED(moved_x_tuning.share) + HRBFNPR_TUNED(moved_x_tuning.width) + HRBFNPR_TUNED(x::moved_x_tuning.rounds)"
        self.assertIn(f"double f() {{ return {looks}; }} // x_tuning.share\n", text)
        self.assertIn("constexpr double half = 0.5 * x_tuning.share;\n", text)
        self.assertIn("std::array<int, x_tuning.rounds> places;\n", text)
        self.assertIn("x_tuning.others.size()", text)
        self.assertIn("inline XTuning moved_x_tuning;\n", (self.source / "x" / "tuning.h").read_text())
        self.assertIn('{"x:x_tuning.share", ', (self.source / "picture" / "ablation.cpp").read_text())

    def test_every_constant_has_a_value(self):
        for file in ablation_copy.tuning_files(PROJECT / "src"):
            for constant in ablation_copy.constants_of(PROJECT / "src", file):
                self.assertIsInstance(ablate.value_of(constant.text), float, constant.name)

    def test_times_are_not_compared(self):
        before = ablate.pairs("table 3\nlines.error_px 0.5\nlines.warm_ms 2\nlines.valid 26\n")
        self.assertEqual(before, {"lines.error_px": 0.5, "lines.valid": 26.0})
        after = {"lines.error_px": 0.5001, "lines.valid": 25.0}
        self.assertEqual(ablate.changes(before, after), ["lines.valid 26 -> 25"])

    def test_every_room_with_tuning_constants_has_cases(self):
        for file in ablation_copy.tuning_files(PROJECT / "src"):
            self.assertIn(str(file.parent.relative_to(PROJECT / "src")), ablate.OWN_CASES)
        for benches in ablate.BENCHES.values():
            for name, *_ in benches:
                self.assertTrue((PROJECT / "bench" / f"{name}.cpp").exists(), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
