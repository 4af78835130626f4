# SPDX-License-Identifier: MIT
"""Unpack the crate hrbfnpr-sys, and draw with it in a new cargo project that links the library for Linux x86-64."""
from __future__ import annotations

import os
import shutil
import subprocess
import tarfile
from pathlib import Path
from typing import List

from common import Native, Release
from rows import Row
from scene import SAMPLES, picture_hash

PROGRAM = Path(__file__).resolve().with_name("scene.rs")
MANIFEST = """[package]
name = "scene"
version = "0.0.0"
edition = "2021"

[dependencies]
hrbfnpr-sys = {{ path = "{crate}" }}
"""


def attempt(release: Release) -> List[Row]:
    package = release.dist / f"hrbfnpr-sys-{release.version}.crate"
    native = release.natives.get("linux-x64")
    if not package.is_file() or native is None or shutil.which("cargo") is None:
        missing = package.name if not package.is_file() else "library for linux-x64" if native is None else "cargo"
        return [Row(package.name, "cargo", f"not run: there is no {missing}")]
    folder = release.scratch("rust")
    where = " ".join(subprocess.check_output(["cargo", "--version"], text=True).split()[:2])
    new_project(folder, package)
    return [drawn(folder, native, Row(package.name, where))]


def new_project(folder: Path, package: Path) -> None:
    with tarfile.open(package) as archive:
        archive.extractall(folder)
    (folder / "scene" / "src").mkdir(parents=True)
    shutil.copyfile(PROGRAM, folder / "scene" / "src" / "main.rs")
    (folder / "scene" / "Cargo.toml").write_text(MANIFEST.format(crate=f"../{package.stem}"), encoding="utf-8")


def drawn(folder: Path, native: Native, row: Row) -> Row:
    libraries = str(library_folder(native))
    environment = {**os.environ, "HRBFNPR_LIB_DIR": libraries, "LD_LIBRARY_PATH": libraries}
    picture = folder / "picture.rgba"
    result = subprocess.run(["cargo", "run", "--offline", "--quiet", "--", str(SAMPLES), str(picture)],
                            cwd=folder / "scene", env=environment, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    if result.returncode != 0:
        return Row(row.package, row.where, f"failed: {result.stdout}")
    return Row(row.package, row.where, "ok", picture_hash(picture))


def library_folder(native: Native) -> Path:
    """Return the folder where the installed tree has the link libhrbfnpr.so, which the linker looks for."""
    return next(native.folder.rglob(native.platform.library)).parent
