# SPDX-License-Identifier: MIT
"""Tries the archives: unpacks them, compiles a C program with each, and draws the common scene with it."""
from __future__ import annotations

import shlex
import shutil
from functools import partial
from pathlib import Path
from typing import Callable, Dict, List, Tuple

import scene
from archives import name_of
from common import Release
from roots import NotRun, attempt_row, execute
from rows import Row

CMAKE_PROJECT = """cmake_minimum_required(VERSION 3.16)
project(scene LANGUAGES C)
find_package(hrbfnpr REQUIRED)
add_executable(scene "{program}")
target_link_libraries(scene PRIVATE hrbfnpr::hrbfnpr)
"""
MINGW = "x86_64-w64-mingw32-gcc-posix"
AARCH64 = "aarch64-linux-gnu-gcc"


def attempt(release: Release) -> List[Row]:
    rows = []
    for rid in release.natives:
        archive = next(release.dist.glob(f"{name_of(release, rid)}.*"))
        if rid not in TRIALS:
            rows.append(Row(archive.name, rid, "not run: needs that system"))
            continue
        folder = unpacked(release, archive)
        rows += [attempt_row(archive.name, where, partial(draw, release, folder)) for where, draw in TRIALS[rid]]
    return rows


def unpacked(release: Release, archive: Path) -> Path:
    """Return the folder of the unpacked archive.  Its path has a space."""
    folder = release.scratch(f"unpacked {archive.name}")
    shutil.unpack_archive(archive, folder)
    return next(folder.iterdir())


def by_pkg_config(release: Release, folder: Path) -> str:
    program = release.scratch("pkg-config") / "scene"
    compile_by_pkg_config("cc", folder, program)
    return drawn(program)


def by_cmake(release: Release, folder: Path) -> str:
    need("cmake", "ninja")
    source = release.scratch("cmake")
    (source / "CMakeLists.txt").write_text(CMAKE_PROJECT.format(program=scene.C_PROGRAM), encoding="utf-8")
    execute("cmake", "-G", "Ninja", "-S", source, "-B", source / "build", f"-DCMAKE_PREFIX_PATH={folder}")
    execute("cmake", "--build", source / "build")
    return drawn(source / "build" / "scene")


def on_arm64(release: Release, folder: Path) -> str:
    """Draw under qemu on one processor: qemu 7.2 does not keep the order of other processors' stores and loads."""
    program = release.scratch("arm64") / "scene"
    compile_by_pkg_config(AARCH64, folder, program)
    need("qemu-aarch64-static", "taskset")
    system = "/usr/aarch64-linux-gnu"
    return drawn(program, "taskset", "-c", "0", "qemu-aarch64-static", "-L", system)


def on_windows(release: Release, folder: Path, import_library: str) -> str:
    """Link the import library, and run the program beside the DLL under Wine."""
    need(MINGW, "wine")
    program = release.scratch("windows") / "scene.exe"
    execute(MINGW, "-O2", "-I", folder / "include", scene.C_PROGRAM, folder / "lib" / import_library, "-o", program)
    for library in folder.glob("bin/*.dll"):
        shutil.copy(library, program.parent)
    quiet = ("WINEDEBUG=-all", "WINEDLLOVERRIDES=mscoree,mshtml=", f"WINEPREFIX={release.work / 'wine'}")
    return drawn(program, "env", *quiet, "wine")


Trial = Tuple[str, Callable[[Release, Path], str]]  # where, and the function that returns the hash of the picture
TRIALS: Dict[str, List[Trial]] = {
    "linux-x64": [("this system, pkg-config", by_pkg_config), ("this system, CMake", by_cmake)],
    "linux-arm64": [("qemu, pkg-config", on_arm64)],
    "win-x64": [(f"Wine, {name}", partial(on_windows, import_library=name))
                for name in ("libhrbfnpr.dll.a", "hrbfnpr.lib")],
}


def need(*programs: str) -> None:
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        raise NotRun(f"needs {', '.join(missing)}")


def compile_by_pkg_config(compiler: str, folder: Path, program: Path) -> None:
    """Compile the program of the scene as the archive's README tells, so that it finds the library where it is."""
    need(compiler, "pkg-config")
    search = f"PKG_CONFIG_PATH={folder / 'lib' / 'pkgconfig'}"
    flags = shlex.split(execute("env", search, "pkg-config", "--cflags", "--libs", "hrbfnpr"))
    execute(compiler, scene.C_PROGRAM, *flags, f"-Wl,-rpath,{folder / 'lib'}", "-o", program)


def drawn(program: Path, *launcher: str) -> str:
    """Run the program and return the hash of its picture."""
    picture = program.parent / "picture.raw"
    execute(*launcher, program, scene.SAMPLES, picture)
    return scene.picture_hash(picture)
