# SPDX-License-Identifier: MIT
"""scripts/ablate.py reads, moves and compares what it should.

    ablate_test.py PROJECT
"""

import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
sys.path.insert(0, str(PROJECT / "scripts"))

import ablate  # noqa: E402

TUNING = """struct XTuning {
    // A share.
    double share = 0.25;
    float width = 3.0f;
    std::int64_t most = 1'000;
    int rounds = 1;
    std::array<int, 2> others{1, 2};
};
"""


class Ablation(unittest.TestCase):
    def test_constants_are_found_and_moved(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "tuning.h"
            file.write_text(TUNING)
            found = list(ablate.constants_of(file))
        self.assertEqual([c.name for c in found], ["share", "width", "most", "rounds"])
        self.assertEqual([c.moved(0.5) for c in found], ["0.125", "1.5", "500", "1"])
        self.assertEqual([c.moved(2.0) for c in found], ["0.5", "6.0", "2000", "2"])
        moved = ablate.replaced(TUNING, found[1], "6.0")
        self.assertIn("    float width = 6.0f;\n", moved)
        self.assertEqual(moved.replace("6.0f", "3.0f"), TUNING)

    def test_times_do_not_count(self):
        before = ablate.pairs("table 3\nlines.error_px 0.5\nlines.warm_ms 2\nlines.valid 26\n")
        self.assertEqual(before, {"lines.error_px": 0.5, "lines.valid": 26.0})
        after = {"lines.error_px": 0.5001, "lines.valid": 25.0}
        self.assertEqual(ablate.changes(before, after), ["lines.valid 26 -> 25"])

    def test_every_room_with_a_register_has_a_benchmark(self):
        for file in sorted((PROJECT / "src").rglob("tuning.h")):
            room = str(file.parent.relative_to(PROJECT / "src"))
            if room not in ("implicit", "mesh", "picture", "published"):  # no benchmark measures these alone
                self.assertIn(room, ablate.BENCHES)
        for benches in ablate.BENCHES.values():
            for name, *_ in benches:
                self.assertTrue((PROJECT / "bench" / f"{name}.cpp").exists(), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
