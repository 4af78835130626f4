# SPDX-License-Identifier: MIT
"""A release whose libraries are stand-ins, for tests of the makers of packages."""
from __future__ import annotations

import shutil
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))

from common import PLATFORMS, Native, Release, version  # noqa: E402

EPOCH = 1700000000
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
CMAKE_FILES = {
    "hrbfnprConfig.cmake": 'set(PACKAGE_PREFIX_DIR "${CMAKE_CURRENT_LIST_DIR}/../../../")\n',
    "hrbfnprTargets.cmake": 'get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)\n',
    "hrbfnprTargets-release.cmake": 'IMPORTED_LOCATION_RELEASE "${_IMPORT_PREFIX}/lib/libhrbfnpr.so.1.2.3.4"\n',
}
PKG_CONFIG_FILE = "prefix=${pcfiledir}/../..\nlibdir=${prefix}/lib\nincludedir=${prefix}/include\n"


def native(rid: str, folder: Path) -> Native:
    """Write an install tree.  Its library is a small program of this system."""
    platform = PLATFORMS[rid]
    windows = rid.startswith("win")
    library = folder / ("bin" if windows else "lib") / (platform.library + ("" if windows else ".1.2.3.4"))
    for part in ("bin", "include", "lib/cmake/hrbfnpr", "lib/pkgconfig", "share/hrbfnpr", "share/doc/hrbfnpr"):
        (folder / part).mkdir(parents=True)
    shutil.copy(str(shutil.which("true")), library)
    if not windows:
        (folder / "lib" / "libhrbfnpr.so.1").symlink_to(library.name)
        (folder / "lib" / "libhrbfnpr.so").symlink_to("libhrbfnpr.so.1")
    for name, text in CMAKE_FILES.items():
        (folder / "lib" / "cmake" / "hrbfnpr" / name).write_text(text)
    (folder / "lib" / "pkgconfig" / "hrbfnpr.pc").write_text(PKG_CONFIG_FILE)
    (folder / "share" / "hrbfnpr" / "api.json").write_text("{}\n")
    shutil.copy(ROOT / "include" / "hrbfnpr.h", folder / "include")
    return Native(platform, folder, library)


def release(folder: Path, *rids: str) -> Release:
    (folder / "dist").mkdir(parents=True)
    return Release(version(), EPOCH, folder / "dist", folder / "work",
                   {rid: native(rid, folder / "natives" / rid) for rid in rids})


def main(*programs: str) -> None:
    """Run the tests of a file, unless one of these programs is missing."""
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        print(f"skipped: needs {', '.join(missing)}")
        sys.exit(SKIPPED)
    unittest.main()
