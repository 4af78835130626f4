# SPDX-License-Identifier: MIT
"""Build the libraries of all platforms by the CMake presets that have their names."""
from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import List

import check_native
from common import PLATFORMS, ROOT, Native, Platform, Release, run

GLIBC = "2.17"  # the oldest one that the libraries for Linux run with
FOLDER = ROOT / "build" / "natives"  # the install trees; test_release.py reads them
STRIP = {"linux-x64": "strip", "linux-arm64": "aarch64-linux-gnu-strip"}


def library_file(folder: Path, platform: Platform) -> Path:
    """Return the library in an install tree, not a link to it."""
    part = "bin" if platform.rid.startswith("win") else "lib"
    return (folder / part / platform.library).resolve(strict=True)


def installed(folder: Path, platform: Platform) -> Native:
    return Native(platform, folder, library_file(folder, platform))


def configure(platform: Platform, build: Path, zig: Path) -> None:
    options = [f"-DHRBFNPR_ZIG={zig}"] if platform.rid != "win-x64" else []
    # Messages and assertions contain names of source files, which must not depend on the folder of the checkout.
    options.append(f"-DCMAKE_CXX_FLAGS=-ffile-prefix-map={ROOT}=. -ffile-prefix-map={build}=.")
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    run("cmake", "--preset", platform.rid, "-S", ROOT, "-B", build, "-DHRBFNPR_TESTS=OFF", *options)


def build_native(release: Release, platform: Platform, zig: Path) -> Native:
    build = ROOT / "build" / platform.rid
    folder = FOLDER / platform.rid
    shutil.rmtree(folder, ignore_errors=True)
    configure(platform, build, zig)
    # CMake names the compiler's kind to ccache, which does not know it by the name of Zig's program.
    kind = {} if platform.rid == "win-x64" else {"CCACHE_COMPILERTYPE": "clang", "CCACHE_COMPILERCHECK": "content"}
    environment = {**release.environment, "CCACHE_SLOPPINESS": "pch_defines,time_macros", **kind}
    run("cmake", "--build", build, f"-j{os.cpu_count()}", env=environment)
    run("cmake", "--install", build, "--prefix", folder)
    native = installed(folder, platform)
    if platform.rid in STRIP:  # the others were linked without symbols
        run(STRIP[platform.rid], "--strip-unneeded", native.library)
    check_native.check(native.library, GLIBC)
    return native


def make(release: Release, rids: List[str], zig: Path) -> None:
    """Build the libraries of these platforms and enter them into the release."""
    for rid in rids:
        release.natives[rid] = build_native(release, PLATFORMS[rid], zig)
