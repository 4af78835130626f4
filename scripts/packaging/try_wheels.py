# SPDX-License-Identifier: MIT
"""Installs the wheels and the source distribution on bare systems, and draws with them."""
from __future__ import annotations

import re
import shutil
import zipfile
from functools import partial
from pathlib import Path
from typing import List

import roots
import scene
from common import PLATFORMS, ROOT, Release
from roots import System, attempt_row, found, require
from rows import Row, long_trials

BUILD = ("g++", "cmake", "ninja-build", "libeigen3-dev", "libglm-dev", "libhwy-dev", "nlohmann-json3-dev",
         "python3-setuptools", "python3-wheel")
MINGW = "x86_64-w64-mingw32-gcc-posix"
PYTHON = "/usr/bin/python3"  # qemu needs the whole path
VENV = "/trial/venv/bin/python3"


def attempt(release: Release) -> List[Row]:
    wheels = {rid: found(release.dist, f"*{platform.wheel_tag}.whl") for rid, platform in PLATFORMS.items()}
    rows = [row for suite in roots.SUITES for row in on_bare_system(suite, wheels["linux-x64"])]
    for rid, where, draw in (("linux-arm64", "bookworm arm64, qemu, no NumPy", arm64),
                             ("win-x64", "its DLL, Wine", partial(windows, release))):
        rows.append(attempt_row(wheels[rid].name, where, partial(draw, wheels[rid])))
    rows.append(Row(wheels["osx-arm64"].name, "macOS", "not run: no macOS here"))
    source = found(release.dist, f"hrbfnpr-{release.version}.tar.gz")
    if not long_trials():
        return [*rows, Row(source.name, "bookworm, GCC", "not run: only with --long")]
    return [*rows, attempt_row(source.name, "bookworm, GCC", lambda: sdist(source))]


def on_bare_system(suite: str, wheel: Path) -> List[Row]:
    """Return the rows of a wheel in a new environment, first without NumPy and then with it."""
    return roots.rows_on(suite, [wheel], lambda system: [
        attempt_row(wheel.name, f"{suite}, no NumPy", lambda: without_numpy(system, wheel)),
        attempt_row(wheel.name, f"{suite}, NumPy", lambda: with_numpy(system))])


def without_numpy(system: System, wheel: Path) -> str:
    system.install(*roots.PYTHON)
    install_offline(system, wheel)
    return by_program(system, VENV, scene.PLAIN_PYTHON_PROGRAM)


def install_offline(system: System, package: Path, *options: str) -> None:
    """Install a package with pip in a new environment that sees the packages of the system."""
    system.run("python3", "-m", "venv", "--system-site-packages", "/trial/venv")
    system.run(VENV, "-m", "pip", "install", "--no-index", *options, *system.put(package))


def with_numpy(system: System) -> str:
    system.install(*roots.PICTURES)
    return by_all_means(system, VENV)


def by_all_means(system: System, python: str) -> str:
    """Draw the scene by hrbfnpr.draw and by the command, and run the quick start."""
    (samples,) = system.put(scene.SAMPLES)
    by_call = by_program(system, python, scene.PYTHON_PROGRAM)
    system.run(python, "-m", "hrbfnpr", "draw", samples, "command.png", *scene.COMMAND_OPTIONS)
    by_command = scene.picture_hash(system.exchange / "command.png")
    if by_command != by_call:
        raise roots.Failed(f"the command draws {by_command} and hrbfnpr.draw {by_call}")
    system.run(python, *system.put(ROOT / "examples" / "quickstart.py"))
    expect(system, "torus.png", "torus.svg")
    return by_call


def expect(system: System, *names: str) -> None:
    """Raise Failed if a program did not write these files."""
    missing = [name for name in names if not (system.exchange / name).is_file()]
    if missing:
        raise roots.Failed(f"the quick start did not write {', '.join(missing)}")


def by_program(system: System, python: str, program: str, **environment: str) -> str:
    """Run a Python program that draws the scene, and return the hash of its picture."""
    picture = system.exchange / "picture.rgba"
    picture.unlink(missing_ok=True)
    system.run(python, system.write("scene.py", program), *system.put(scene.SAMPLES), "picture.rgba", **environment)
    return scene.picture_hash(picture)


def arm64(wheel: Path) -> str:
    """Install a wheel with the pip of an emulated system, and draw with it."""
    require(wheel)
    with roots.fresh_arm64() as system:
        (pip,) = (Path(system.lower) / "usr/share/python-wheels").glob("pip-*.whl")
        system.run(PYTHON, f"/usr/share/python-wheels/{pip.name}/pip", "install", "--no-index", "--no-compile",
                   "--break-system-packages", *system.put(wheel))
        return by_program(system, PYTHON, scene.PLAIN_PYTHON_PROGRAM)


def windows(release: Release, wheel: Path) -> str:
    """Draw the scene with a C program for Windows that loads the library of a wheel."""
    require(wheel)
    needed = {"wine": "wine", MINGW: "gcc-mingw-w64-x86-64-posix"}
    roots.refuse(", ".join(f"needs {package}" for program, package in needed.items() if not shutil.which(program)))
    work = release.scratch("wheel-windows")
    with zipfile.ZipFile(wheel) as archive:
        archive.extract("hrbfnpr/libhrbfnpr.dll", work)
    (work / "scene.c").write_text(loading(scene.C_PROGRAM), encoding="utf-8")
    roots.execute(MINGW, "-O1", "-I", ROOT / "include", work / "scene.c", "-o", work / "scene.exe")
    roots.execute("env", f"WINEPREFIX={work / 'wine'}", "WINEDEBUG=-all", "wine", work / "scene.exe", scene.SAMPLES,
                  work / "picture.rgba", work / "hrbfnpr" / "libhrbfnpr.dll")
    return scene.picture_hash(work / "picture.rgba")


# The start of a C program for Windows whose last argument is the path of the library.
LOADER = """
#include <hrbfnpr.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>
static HMODULE library;
static void *symbol(const char *name) {
    void *const address = (void *)GetProcAddress(library, name);
    if (!address) exit(fprintf(stderr, "the library has no %s\\n", name));
    return address;
}
"""
MAIN = """
#undef main
int main(int argc, char **argv) {
    library = LoadLibraryA(argv[argc - 1]);
    if (!library) return fprintf(stderr, "cannot load %s: error %lu\\n", argv[argc - 1], GetLastError());
    return scene(argc - 1, argv);
}
"""


def loading(program: Path) -> str:
    """Return the text of a C program that finds each function with GetProcAddress and then runs another program."""
    functions = sorted(set(re.findall(r"\b(hrbfnpr_\w+)\(", program.read_text(encoding="utf-8"))))
    calls = [f'#define {name} ((__typeof__(&{name}))symbol("{name}"))' for name in functions]
    return "\n".join([LOADER, *calls, "#define main scene", f'#include "{program}"', MAIN])


def sdist(source: Path) -> str:
    """Build and install the source distribution with the packages of Debian alone, and draw with it."""
    require(source)
    with roots.fresh("bookworm") as system:
        system.install(*roots.PYTHON, *BUILD)
        install_offline(system, source, "--no-build-isolation")
        return with_numpy(system)
