# SPDX-License-Identifier: MIT
"""The archives have the same bytes each time and contain the files that users need."""
from __future__ import annotations

import os
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

import stand_in  # first: it sets the path of the other modules
import archives
import common


class WriterTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def inputs(self, date: int) -> common.Contents:
        """A script and a link to it, with this date, beside bytes and text."""
        script, link = self.folder / "script", self.folder / "link"
        link.unlink(missing_ok=True)
        script.write_text("#!/bin/sh\n")
        script.chmod(0o755)
        os.utime(script, (date, date))
        link.symlink_to("script")
        return {"b/script": script, "b/link": link, "a": b"bytes", "c": "text"}

    def both(self, write, name: str) -> Path:
        """Write the archive twice, expect the same bytes, and return it."""
        first = write(self.folder / f"1{name}", self.inputs(1000), stand_in.EPOCH)
        contents = self.inputs(2000)
        second = write(self.folder / f"2{name}", dict(reversed(contents.items())), stand_in.EPOCH)
        self.assertEqual(first.read_bytes(), second.read_bytes())
        return second

    def test_a_tar_archive_depends_on_names_and_contents_only(self) -> None:
        with tarfile.open(self.both(common.write_tar, ".tar.gz")) as archive:
            entries = archive.getmembers()
            self.assertEqual([entry.name for entry in entries], ["a", "b/link", "b/script", "c"])
            self.assertEqual([oct(entry.mode) for entry in entries], ["0o644", "0o777", "0o755", "0o644"])
            self.assertEqual({entry.mtime for entry in entries}, {stand_in.EPOCH})
            self.assertEqual(entries[1].linkname, "script")

    def test_a_zip_archive_depends_on_names_and_contents_only(self) -> None:
        with zipfile.ZipFile(self.both(common.write_zip, ".zip")) as archive:
            self.assertEqual(archive.namelist(), ["a", "b/link", "b/script", "c"])
            self.assertEqual(archive.read("c"), b"text")
            self.assertEqual(archive.getinfo("a").date_time, (2023, 11, 14, 22, 13, 20))


class ArchivesTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.version = common.version()

    def test_each_platform_has_an_archive(self) -> None:
        release = stand_in.release(self.folder, "linux-x64", "win-x64")
        linux, windows = [archives.for_platform(release, native) for native in release.natives.values()]
        name = f"hrbfnpr-{self.version}-linux-x64"
        self.assertEqual(linux.name, f"{name}.tar.gz")
        with tarfile.open(linux) as archive:
            self.assertEqual([entry.removeprefix(f"{name}/") for entry in archive.getnames()], [
                "LICENSE", "README.txt", "THIRD-PARTY-NOTICES.md", "include/hrbfnpr.h",
                *(f"lib/cmake/hrbfnpr/{file}" for file in sorted(stand_in.CMAKE_FILES)),
                "lib/libhrbfnpr.so", "lib/libhrbfnpr.so.1", "lib/libhrbfnpr.so.1.2.3.4", "lib/pkgconfig/hrbfnpr.pc",
                "share/hrbfnpr/api.json"])
        with zipfile.ZipFile(windows) as archive:
            name = f"hrbfnpr-{self.version}-win-x64"
            self.assertIn(f"{name}/bin/libhrbfnpr.dll", archive.namelist())
            self.assertIn("(run under Wine only)", archive.read(f"{name}/README.txt").decode())

    def test_the_readme_is_short(self) -> None:
        release = stand_in.release(self.folder, "linux-x64", "win-x64")
        for native in release.natives.values():
            lines = archives.readme(release, native).splitlines()
            self.assertEqual(len(lines), 10)
            self.assertLess(max(map(len, lines)), 120)

    def test_the_sources_have_a_folder(self) -> None:
        tracked = common.tracked_files("include", "cmake")
        with mock.patch.object(archives, "tracked_files", lambda: tracked):
            path = archives.sources(stand_in.release(self.folder))
        self.assertEqual(path.name, f"hrbfnpr-{self.version}-source.tar.gz")
        with tarfile.open(path) as archive:
            self.assertEqual(archive.getnames(), [f"hrbfnpr-{self.version}/{name.as_posix()}" for name in tracked])


if __name__ == "__main__":
    stand_in.main("git")
