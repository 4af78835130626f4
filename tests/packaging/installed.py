# SPDX-License-Identifier: MIT
"""Compiles the C program of tests/package with the archive and the Debian packages of an installed library.

    installed.py PREFIX WORK
"""
from __future__ import annotations

import os
import platform
import shlex
import shutil
import sys
from pathlib import Path

import stand_in  # first: it sets the path of the other modules
import archives
import common
import debs
from common import run

CONSUMER = stand_in.ROOT / "tests" / "package" / "c"
TRIPLET = debs.TRIPLETS["amd64"]


def by_cmake(prefix: Path, build: Path) -> None:
    run("cmake", "-G", "Ninja", "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    expect(run(build / "consumer"))


def by_pkg_config(folder: Path, program: Path, **variables: str) -> None:
    """Compile with the pkg-config file below the folder of libraries."""
    environment = {**os.environ, "PKG_CONFIG_PATH": str(folder / "pkgconfig"), **variables}
    flags = shlex.split(run("pkg-config", "--cflags", "--libs", "hrbfnpr", env=environment))
    run("cc", CONSUMER / "main.c", *flags, "-o", program)
    expect(run(program, env={**os.environ, "LD_LIBRARY_PATH": str(folder)}))


def expect(printed: str) -> None:
    if printed != f"2 {common.version()}\n":
        sys.exit(f"the program printed {printed!r}")


def main() -> None:
    prefix, work = Path(sys.argv[1]), Path(sys.argv[2])
    missing = [program for program in ("dpkg-deb", "readelf", "pkg-config", "ninja") if shutil.which(program) is None]
    if missing or platform.machine() != "x86_64":
        print(f"skipped: needs {', '.join(missing) or 'x86-64'}")
        sys.exit(stand_in.SKIPPED)
    shutil.rmtree(work, ignore_errors=True)
    (work / "dist").mkdir(parents=True)
    native = common.Native(common.PLATFORMS["linux-x64"], prefix, (prefix / "lib" / "libhrbfnpr.so").resolve())
    release = common.Release(common.version(), stand_in.EPOCH, work / "dist", work / "scratch", {"linux-x64": native})

    shutil.unpack_archive(archives.for_platform(release, native), work / "an archive")
    (unpacked,) = (work / "an archive").iterdir()
    by_cmake(unpacked, work / "archive, CMake")
    by_pkg_config(unpacked / "lib", work / "archive, pkg-config")

    system = work / "system"  # pkgconf cannot read a system below a path with a space
    for package in debs.make(release)[:2]:
        run("dpkg-deb", "--extract", package, system)
    by_cmake(system / "usr", work / "packages, CMake")
    by_pkg_config(system / "usr/lib" / TRIPLET, work / "packages, pkg-config", PKG_CONFIG_SYSROOT_DIR=str(system))


if __name__ == "__main__":
    main()
