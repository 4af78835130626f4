# SPDX-License-Identifier: MIT
"""The Debian packages have the same bytes each time, and the control files and the files that Debian expects."""
from __future__ import annotations

import gzip
import re
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Dict

import stand_in  # first: it sets the path of the other modules
import common
import debs


def control(package: Path) -> Dict[str, str]:
    text = common.run("dpkg-deb", "--field", package, quiet=True)
    return dict(re.findall(r"^(\S+): (.*)$", text, re.MULTILINE))


class DebsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        cls.release = stand_in.release(cls.folder / "first", "linux-x64")
        cls.library, cls.development, cls.python = debs.make(cls.release)
        cls.version = cls.release.version
        for package in (cls.library, cls.development, cls.python):
            common.run("dpkg-deb", "--extract", package, cls.folder / "root", quiet=True)
            common.run("dpkg-deb", "--control", package, cls.folder / package.name, quiet=True)

    def text(self, path: str) -> str:
        data = (self.folder / path).read_bytes()
        return (gzip.decompress(data) if path.endswith(".gz") else data).decode()

    def test_the_names_are_those_of_debian(self) -> None:
        self.assertEqual([path.name for path in (self.library, self.development, self.python)], [
            f"libhrbfnpr1_{self.version}_amd64.deb", f"libhrbfnpr-dev_{self.version}_amd64.deb",
            f"python3-hrbfnpr_{self.version}_all.deb"])

    def test_a_second_run_has_the_same_bytes(self) -> None:
        second = debs.make(stand_in.release(self.folder / "second", "linux-x64"))
        self.assertEqual([path.read_bytes() for path in second],
                         [path.read_bytes() for path in (self.library, self.development, self.python)])

    def test_the_fields_tell_the_dependencies(self) -> None:
        self.assertEqual(control(self.library)["Depends"], "libc6 (>= 2.17)")
        self.assertEqual(control(self.development)["Depends"], f"libhrbfnpr1 (= {self.version})")
        self.assertIn(f"libhrbfnpr1 (>= {self.version}), python3-cffi-backend | python3-cffi,",
                      control(self.python)["Depends"])
        self.assertEqual(self.text(f"{self.library.name}/shlibs"), f"libhrbfnpr 1 libhrbfnpr1 (>= {self.version})\n")
        self.assertEqual(self.text(f"{self.library.name}/triggers"), "activate-noawait ldconfig\n")

    def test_the_sums_are_those_of_the_files(self) -> None:
        for package in (self.library, self.development, self.python):
            subprocess.run(["md5sum", "--check", "--quiet", "--strict", self.folder / package.name / "md5sums"],
                           cwd=self.folder / "root", check=True)

    def test_the_files_are_in_the_folders_of_the_processor(self) -> None:
        folder = self.folder / "root/usr/lib/x86_64-linux-gnu"
        self.assertEqual((folder / "libhrbfnpr.so").resolve().name, "libhrbfnpr.so.1.2.3.4")
        self.assertTrue((folder / "libhrbfnpr.so.1").resolve().is_file())
        self.assertIn("${_IMPORT_PREFIX}/lib/x86_64-linux-gnu/libhrbfnpr.so.1.2.3.4",
                      self.text("root/usr/lib/x86_64-linux-gnu/cmake/hrbfnpr/hrbfnprTargets-release.cmake"))
        self.assertEqual(self.text("root/usr/lib/x86_64-linux-gnu/pkgconfig/hrbfnpr.pc"),
                         "prefix=/usr\nlibdir=${prefix}/lib/x86_64-linux-gnu\nincludedir=${prefix}/include\n")

    def test_only_the_library_has_notices_of_others(self) -> None:
        for name, expected in (("libhrbfnpr1", True), ("libhrbfnpr-dev", False), ("python3-hrbfnpr", False)):
            text = self.text(f"root/usr/share/doc/{name}/copyright")
            self.assertIn("\nFiles: *\nCopyright: 2026 The hrbfnpr authors\nLicense: Expat\n", text)
            self.assertEqual("## Highway" in text, expected)
            self.assertNotIn("END OF TERMS AND CONDITIONS", text)  # Debian has the Apache License in one place

    def test_the_changelog_has_the_date_of_the_release(self) -> None:
        self.assertEqual(self.text("root/usr/share/doc/libhrbfnpr1/changelog.gz").split("\n")[0::4], [
            f"hrbfnpr ({self.version}) unstable; urgency=medium",
            f" -- {debs.MAINTAINER}  Tue, 14 Nov 2023 22:13:20 +0000"])

    def test_the_manual_names_each_command(self) -> None:
        page = self.text("root/usr/share/man/man1/hrbfnpr.1.gz").replace("\\-", "-")
        self.assertIn(f'"2023-11-14" "hrbfnpr {self.version}"', page)
        grammar = (common.ROOT / "bindings/python/hrbfnpr/cli/_grammar.py").read_text(encoding="utf-8")
        commands = re.findall(r'^    add\("([\w-]+)", "([^"]+)"', grammar, re.MULTILINE)
        self.assertGreater(len(commands), 5)
        for name, summary in commands:
            self.assertIn(f".B {name}\n{summary[0].upper()}{summary[1:]}.\n", page)

    def test_the_python_package_is_whole(self) -> None:
        folder = self.folder / "root/usr/lib/python3/dist-packages"
        for name in ("hrbfnpr/cli/_main.py", "hrbfnpr/_options.json", "hrbfnpr/py.typed",
                     f"hrbfnpr-{self.version}.dist-info/METADATA"):
            self.assertTrue((folder / name).is_file(), name)
        self.assertEqual((self.folder / "root/usr/bin/hrbfnpr").stat().st_mode & 0o777, 0o755)


if __name__ == "__main__":
    stand_in.main("git", "dpkg-deb", "readelf")
