# SPDX-License-Identifier: MIT
"""Installs the Debian packages on bare systems, draws with each of them, and removes them."""
from __future__ import annotations

import shlex
import shutil
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Iterator, List

import roots
import scene
from common import ROOT, Release
from roots import Failed, NotRun, System, attempt_row, found, require
from rows import Row
from try_wheels import PYTHON, by_all_means, by_program, expect

TRIPLET = "aarch64-linux-gnu"
EXAMPLE = ROOT / "examples" / "quickstart.c"


def attempt(release: Release) -> List[Row]:
    rows = [row for suite in roots.SUITES for row in on_bare_system(release.dist, suite)]
    library, python = found(release.dist, "libhrbfnpr[0-9]*_arm64.deb"), found(release.dist, "python3-hrbfnpr_*.deb")
    headers = found(release.dist, "libhrbfnpr-dev_*_arm64.deb")
    return [*rows, attempt_row(library.name, "bookworm arm64, qemu, python3", lambda: arm64(library, python)),
            attempt_row(headers.name, "bookworm arm64, qemu, cross gcc", lambda: arm64_compiled(library, headers)),
            *linted(release.dist)]


def linted(dist: Path) -> List[Row]:
    """Return a row for each package, which fails if lintian finds an error or a warning.  It has no picture."""
    return [attempt_row(package.name, "lintian", partial(lint, package)) for package in sorted(dist.glob("*.deb"))]


def lint(package: Path) -> str:
    if shutil.which("lintian") is None:
        raise NotRun("needs lintian")
    roots.execute("lintian", "--fail-on", "error,warning", package)
    return ""


def on_bare_system(dist: Path, suite: str) -> List[Row]:
    """Return a row for each package: it is used without the packages that do not depend on it."""
    library, headers = found(dist, "libhrbfnpr[0-9]*_amd64.deb"), found(dist, "libhrbfnpr-dev_*_amd64.deb")
    python = found(dist, "python3-hrbfnpr_*.deb")
    return roots.rows_on(suite, [library, headers, python], lambda system: [
        attempt_row(headers.name, f"{suite}, gcc", lambda: compiled(system, library, headers)),
        attempt_row(library.name, f"{suite}, compiled program", lambda: by_compiled(system)),
        attempt_row(python.name, f"{suite}, python3", lambda: by_python(system, python))])


def compiled(system: System, library: Path, headers: Path) -> str:
    """Install the packages for compiling, and draw with programs that pkg-config finds the library for."""
    system.install(*system.put(library, headers), *roots.COMPILER)
    for source, program in ((EXAMPLE, "quickstart"), (scene.C_PROGRAM, "scene")):
        name = shlex.quote(*system.put(source))
        system.run("sh", "-c", f"cc -O1 {name} -o {program} $(pkg-config --cflags --libs hrbfnpr) -lm")
    system.run("./quickstart")
    expect(system, "torus.svg")
    return by_scene(system)


def by_scene(system: System, program: str = "./scene", **environment: str) -> str:
    picture = system.exchange / "scene.rgba"
    picture.unlink(missing_ok=True)
    system.run(program, *system.put(scene.SAMPLES), picture.name, **environment)
    return scene.picture_hash(picture)


def by_compiled(system: System) -> str:
    """Draw with the compiled program after the package for compiling is removed."""
    system.run("apt-get", "-q", "-y", "purge", "libhrbfnpr-dev")
    return by_scene(system)


def by_python(system: System, python: Path) -> str:
    """Draw with the Python package and its command, and remove all packages."""
    system.install(*system.put(python))
    picture = by_all_means(system, "python3")
    system.run("hrbfnpr", "draw", *system.put(scene.SAMPLES), "hrbfnpr.png", *scene.COMMAND_OPTIONS)
    if scene.picture_hash(system.exchange / "hrbfnpr.png") != picture:
        raise Failed("the command hrbfnpr draws another picture than the module")
    # A user with PYTHONDONTWRITEBYTECODE unset leaves caches, which must be removed, too.
    system.run("python3", "-c", "import hrbfnpr; hrbfnpr.draw", PYTHONDONTWRITEBYTECODE="")
    remove_all(system)
    return picture


def remove_all(system: System) -> None:
    """Remove and purge all packages.  Raises Failed if a file with the name of the library stays."""
    names = system.run("dpkg-query", "-W", "-f", "${Package}\n", "*hrbfnpr*").split()
    system.run("apt-get", "-q", "-y", "remove", *names)
    system.run("dpkg", "--purge", *names)
    left = system.run("find", "/", "-xdev", "-path", "/trial", "-prune", "-o", "-name", "*hrbfnpr*", "-print").split()
    if left:
        raise Failed(f"purge leaves {', '.join(left)}")


def arm64(library: Path, python: Path) -> str:
    """Draw with the unpacked packages of the library and of Python.

    They are not installed, because dpkg starts programs of arm64, and qemu runs only the first program.
    """
    with unpacked(library, python) as system:
        return by_program(system, PYTHON, scene.PLAIN_PYTHON_PROGRAM, PYTHONPATH="/trial/usr/lib/python3/dist-packages",
                          LD_LIBRARY_PATH=f"/trial/usr/lib/{TRIPLET}")


def arm64_compiled(library: Path, headers: Path) -> str:
    """Draw with a program that a cross compiler made with the unpacked packages."""
    compiler = f"{TRIPLET}-gcc"
    roots.refuse("" if shutil.which(compiler) else "needs gcc-aarch64-linux-gnu")
    with unpacked(library, headers) as system:
        files = system.exchange / "usr"
        roots.execute(compiler, "-O1", "-I", files / "include", scene.C_PROGRAM, "-o", system.exchange / "scene",
                      files / "lib" / TRIPLET / "libhrbfnpr.so", "-lm")
        return by_scene(system, "/trial/scene", LD_LIBRARY_PATH=f"/trial/usr/lib/{TRIPLET}")


@contextmanager
def unpacked(*packages: Path) -> Iterator[System]:
    """Yield an arm64 system with the files of these packages in /trial."""
    for package in packages:
        require(package)
    with roots.fresh_arm64() as system:
        for package in packages:
            roots.execute("dpkg-deb", "-x", package, system.exchange)
        yield system
