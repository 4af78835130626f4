# SPDX-License-Identifier: MIT
"""Unpack the crate hrbfnpr-sys, and draw with it in a new cargo project: on this machine, and for Windows under Wine."""
from __future__ import annotations

import shutil
import tarfile
from pathlib import Path
from typing import List

from common import PathLike, Release
from crates import cargo
from roots import attempt_row, execute, refuse, require
from rows import Row
from scene import SAMPLES, picture_hash

PROGRAM = Path(__file__).resolve().with_name("scene.rs")
WINDOWS = "x86_64-pc-windows-gnu"
MINGW = "x86_64-w64-mingw32-gcc"
MANIFEST = """[package]
name = "scene"
version = "0.0.0"
edition = "2021"

[dependencies]
hrbfnpr-sys = {{ path = "{crate}" }}
"""


def attempt(release: Release) -> List[Row]:
    package = release.dist / f"hrbfnpr-sys-{release.version}.crate"
    return [attempt_row(package.name, "cargo", lambda: on_linux(release, package)),
            attempt_row(package.name, "cargo, win-x64, Wine", lambda: on_windows(release, package))]


def on_linux(release: Release, package: Path) -> str:
    refuse("" if shutil.which(cargo()) else "needs cargo")
    libraries = library_folder(release, "linux-x64", "libhrbfnpr.so")
    folder = new_project(release.scratch("rust"), package)
    program = built(folder, libraries) / "scene"
    return drawn(folder, "env", f"LD_LIBRARY_PATH={libraries}", program)


def on_windows(release: Release, package: Path) -> str:
    """Link the import library, and run the program beside the DLL under Wine."""
    needed = {"wine": "wine", cargo(): "cargo", MINGW: "gcc-mingw-w64-x86-64-posix"}
    missing = [name for program, name in needed.items() if not shutil.which(program)]
    if not Path("/usr/lib/rustlib", WINDOWS).is_dir():
        missing.append("libstd-rust-dev-windows")
    refuse(f"needs {', '.join(missing)}" if missing else "")
    libraries = library_folder(release, "win-x64", "libhrbfnpr.dll.a")
    folder = new_project(release.scratch("rust-windows"), package)
    output = built(folder, libraries, "--target", WINDOWS, "--config", f"target.{WINDOWS}.linker='{MINGW}'")
    shutil.copy(library_folder(release, "win-x64", "libhrbfnpr.dll") / "libhrbfnpr.dll", output)
    return drawn(folder, "env", f"WINEPREFIX={folder / 'wine'}", "WINEDEBUG=-all", "WINEDLLOVERRIDES=mscoree,mshtml=",
                 "wine", output / "scene.exe")


def library_folder(release: Release, rid: str, name: str) -> Path:
    """Return the folder of the installed tree that has this file."""
    native = release.natives.get(rid)
    found = sorted(native.folder.rglob(name)) if native else []
    refuse("" if found else f"needs {name} of {rid}")
    return found[0].parent.resolve()


def new_project(folder: Path, package: Path) -> Path:
    require(package)
    with tarfile.open(package) as archive:
        archive.extractall(folder)
    project = folder / "scene"
    (project / "src").mkdir(parents=True)
    shutil.copyfile(PROGRAM, project / "src" / "main.rs")
    (project / "Cargo.toml").write_text(MANIFEST.format(crate=f"../{package.stem}"), encoding="utf-8")
    return project


def built(project: Path, libraries: Path, *options: str) -> Path:
    """Build the program with the compiler beside cargo, and return the folder that it is in."""
    compiler = Path(shutil.which(cargo()) or "").with_name("rustc")
    execute("env", f"RUSTC={compiler}", f"HRBFNPR_LIB_DIR={libraries}", cargo(), "build", "--offline", "--quiet",
            "--manifest-path", project / "Cargo.toml", "--target-dir", project / "target", *options)
    return next((project / "target").rglob("debug/scene*.d")).parent


def drawn(project: Path, *program: PathLike) -> str:
    picture = project / "picture.rgba"
    execute(*program, SAMPLES, picture)
    return picture_hash(picture)
