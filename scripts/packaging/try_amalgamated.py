# SPDX-License-Identifier: MIT
"""Tries the library as one source file: compiles it as its README.md says, and draws the common scene with it."""
from __future__ import annotations

import shutil
from functools import partial
from pathlib import Path
from typing import List

import scene
from common import Release
from roots import attempt_row, execute
from rows import Row, long_trials



def attempt(release: Release) -> List[Row]:
    archive = release.dist / f"hrbfnpr-{release.version}-amalgamated.tar.gz"
    where = "this system, one file"
    if not long_trials():
        return [Row(archive.name, where, "not run: only with --long")]
    return [attempt_row(archive.name, where, partial(draw, release, archive))]


def draw(release: Release, archive: Path) -> str:
    folder = release.scratch("one file")
    shutil.unpack_archive(archive, folder)
    source = next(folder.iterdir())
    execute("c++", "-std=c++20", "-O2", "-isystem", source / "third_party", "-DHRBFNPR_STATIC", "-c",
            source / "hrbfnpr.cpp", "-o", folder / "hrbfnpr.o")
    execute("cc", "-I", source, "-DHRBFNPR_STATIC", "-c", scene.C_PROGRAM, "-o", folder / "scene.o")
    execute("c++", folder / "scene.o", folder / "hrbfnpr.o", "-pthread", "-o", folder / "scene")
    execute(folder / "scene", scene.SAMPLES, folder / "picture.rgba")
    return scene.picture_hash(folder / "picture.rgba")
