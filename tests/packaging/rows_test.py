# SPDX-License-Identifier: MIT
"""The table of the trials of a release."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "packaging"))

from rows import Row, judged, report, status, table  # noqa: E402

WHEEL = Row("a.whl", "bookworm", picture="11")
DEB = Row("b.deb", "trixie", picture="11")
MAC = Row("c.whl", "macOS", "not run: no macOS here")


class Rows(unittest.TestCase):
    def test_pictures_that_are_equal_pass(self):
        rows = [WHEEL, DEB, MAC]
        self.assertEqual(status(rows), 0)
        self.assertTrue(report(rows).endswith(
            "\n\n2 of 2 tried packages draw the same picture; 1 not run: c.whl (macOS)\n"), report(rows))

    def test_a_picture_that_differs_fails(self):
        rows = [WHEEL, DEB, Row("d.deb", "bullseye", picture="22")]
        self.assertEqual(status(rows), 1)
        self.assertEqual([row.result for row in judged(rows)], ["ok", "ok", "failed: another picture"])
        self.assertIn("2 of 3 tried packages", report(rows))

    def test_a_failure_in_one_place_counts_for_its_package(self):
        rows = [WHEEL, Row("a.whl", "bullseye", "failed: no"), DEB]
        self.assertEqual(status(rows), 1)
        self.assertIn("1 of 2 tried packages", report(rows))

    def test_a_failure_has_no_say_in_the_usual_picture(self):
        rows = [Row("d.deb", "x", "failed: no", "22"), Row("d.deb", "y", "failed: no", "22"), WHEEL]
        self.assertEqual(judged(rows)[2].result, "ok")

    def test_an_unknown_result_is_a_failure(self):
        self.assertEqual(status([Row("a.whl", "bookworm", "good")]), 1)

    def test_nothing_tried(self):
        self.assertEqual(status([MAC]), 0)
        self.assertIn("0 of 0 tried packages", report([MAC]))

    def test_a_package_that_draws_nothing_is_not_counted_as_alike(self):
        self.assertIn("1 of 2 tried packages", report([WHEEL, Row("e.tar.gz", "here")]))

    def test_columns_are_aligned(self):
        lines = table([WHEEL, MAC, Row("x", "two\nlines | here", "failed: why")]).splitlines()
        self.assertEqual(len({len(line) for line in lines}), 1)
        self.assertEqual(len({line.count("|") for line in lines}), 1)
        self.assertIn("| two lines / here |", lines[-1])


if __name__ == "__main__":
    unittest.main()
