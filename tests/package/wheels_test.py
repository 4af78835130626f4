# SPDX-License-Identifier: MIT
"""scripts/packaging/wheels.py makes the same wheels and the same source package each time, with all that belongs inside."""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))
import common  # noqa: E402
import wheels  # noqa: E402

RIDS = ("linux-x64", "win-x64", "osx-arm64")
SITE = f"hrbfnpr-{common.version()}.dist-info"


def can_make_wheels():
    return subprocess.run([wheels.PYTHON, "-c", "import setuptools, wheel"], capture_output=True).returncode == 0


def make(folder, umask):
    """Make all packages in this folder from stand-ins for the libraries."""
    release = common.Release(common.version(), 1700000000, folder / "dist", folder / "work")
    old = os.umask(umask)
    try:
        for rid in RIDS:
            platform = common.PLATFORMS[rid]
            library = folder / rid / platform.library.replace(".so", ".so.1.2.3.4")
            library.parent.mkdir(parents=True)
            library.write_text(rid)
            release.natives[rid] = common.Native(platform, library.parent, library)
        return wheels.make(release)
    finally:
        os.umask(old)


def unpack(package, folder):
    """Unpack a source package and return its top folder."""
    with tarfile.open(package) as archive:
        archive.extractall(folder)
    return folder / package.name[:-len(".tar.gz")]


@unittest.skipUnless(can_make_wheels(), f"{wheels.PYTHON} lacks setuptools or wheel")
class Wheels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.packages = make(cls.folder / "first", 0o022)

    def test_a_second_run_makes_the_same_bytes(self):
        for package, again in zip(self.packages, make(self.folder / "second", 0o077)):
            self.assertEqual(package.name, again.name)
            self.assertTrue(package.read_bytes() == again.read_bytes(), package.name)

    def test_names(self):
        tags = [common.PLATFORMS[rid].wheel_tag for rid in RIDS]
        wanted = [f"hrbfnpr-{common.version()}-py3-none-{tag}.whl" for tag in tags]
        self.assertEqual([package.name for package in self.packages], [*wanted, f"hrbfnpr-{common.version()}.tar.gz"])

    def test_each_wheel_has_its_library_and_its_notices(self):
        for rid, wheel in zip(RIDS, self.packages):
            platform = common.PLATFORMS[rid]
            with self.subTest(rid), zipfile.ZipFile(wheel) as archive:
                libraries = [name for name in archive.namelist() if re.search(r"\.(so|dll|dylib)", name)]
                self.assertEqual(libraries, [f"hrbfnpr/{platform.library}"])
                self.assertEqual(archive.read(libraries[0]).decode(), rid)
                self.assertEqual(archive.read(f"{SITE}/LICENSE"), (ROOT / "LICENSE").read_bytes())
                notices = archive.read(f"{SITE}/THIRD-PARTY-NOTICES.md").decode()
                self.assertEqual(notices, common.notices([*common.HEADERS, *platform.runtimes]))
                self.assertEqual({entry.date_time for entry in archive.infolist()}, {(2023, 11, 14, 22, 13, 20)})

    def test_the_source_package_has_the_sources(self):
        top = unpack(self.packages[-1], self.folder / "sources")
        for name in ("CMakeLists.txt", "src/CMakeLists.txt", "src/hrbfnpr.exports", "cmake/HrbfnprRooms.cmake", "include/hrbfnpr.h",
                     "setup.py", "pyproject.toml", "LICENSE", "THIRD-PARTY-NOTICES.md", "hrbfnpr/_records.json"):
            self.assertTrue((top / name).is_file(), name)
        self.assertIn(f"\nVersion: {common.version()}\n", (top / "PKG-INFO").read_text())

    def build(self, name, **environment):
        """Build the source package until it fails, and return its last words."""
        top = unpack(self.packages[-1], self.folder / name)
        run = subprocess.run([wheels.PYTHON, "setup.py", "-q", "bdist_wheel"], cwd=top, capture_output=True, text=True,
                             env={**os.environ, "HRBFNPR_LIBRARY": "", **environment})
        self.assertEqual(run.returncode, 1, run.stdout)
        return run.stderr

    def test_without_cmake_the_message_names_its_package(self):
        told = self.build("no-cmake", PATH=str(self.folder / "nowhere"))
        self.assertIn("CMake is missing", told)
        self.assertIn("in the package cmake.", told)

    @unittest.skipUnless(shutil.which("cmake"), "CMake is missing")
    def test_without_a_header_the_message_names_its_package(self):
        told = self.build("no-eigen", CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON")
        self.assertIn("CMake does not find Eigen 3.3", told)
        self.assertIn("in the package libeigen3-dev.", told)
        self.assertIn("apt-get install g++ cmake", told)


if __name__ == "__main__":
    unittest.main()
