# SPDX-License-Identifier: MIT
"""Makes a Python wheel for each platform, and the source package that pip builds with CMake."""
from __future__ import annotations

import shutil
from pathlib import Path
from typing import Dict, List

from common import HEADERS, ROOT, Contents, Native, Release, notices, read, run, tracked_files, tree, write_tar

PACKAGE = Path("bindings") / "python"
SOURCES = ("CMakeLists.txt", "cmake", "include", "src")  # that CMake needs to build the library
PYTHON = "/usr/bin/python3"  # the one that Debian's packages belong to


def package_files() -> Dict[str, Path]:
    """Return the files of the Python package by their names in a source package, whose top folder has pyproject.toml."""
    files = {name: ROOT / PACKAGE / name for name in ("README.md", "pyproject.toml", "setup.py")}
    for file in tracked_files(str(PACKAGE / "hrbfnpr")):
        files[file.relative_to(PACKAGE).as_posix()] = ROOT / file
    return {**files, "LICENSE": ROOT / "LICENSE", "include/hrbfnpr.h": ROOT / "include" / "hrbfnpr.h"}


def write_folder(folder: Path, contents: Contents) -> Path:
    """Write files that anyone may read, whatever the modes of the originals."""
    for name, source in contents.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(read(source))
        path.chmod(0o644)
    return folder


def setup(folder: Path, release: Release, *words: str, **variables: str) -> None:
    """Run setup.py in this folder.  The umask decides the modes of the files that it makes."""
    run("sh", "-c", 'umask 022 && exec "$0" -B setup.py -q "$@"', PYTHON, *words, cwd=folder,
        env={**release.environment, **variables})


def make_wheel(native: Native, release: Release) -> Path:
    platform = native.platform
    folder = write_folder(release.scratch(f"wheel-{platform.rid}"), {
        **package_files(), "THIRD-PARTY-NOTICES.md": notices([*HEADERS, *platform.runtimes])})
    setup(folder, release, "bdist_wheel", "--plat-name", platform.wheel_tag, HRBFNPR_LIBRARY=str(native.library))
    name = f"hrbfnpr-{release.version}-py3-none-{platform.wheel_tag}.whl"
    return Path(shutil.copyfile(folder / "dist" / name, release.dist / name))


def make_source_package(release: Release) -> Path:
    sources = {file.as_posix(): ROOT / file for file in tracked_files(*SOURCES)}
    folder = write_folder(release.scratch("sdist"), {
        **sources, **package_files(), "THIRD-PARTY-NOTICES.md": notices(HEADERS)})
    setup(folder, release, "egg_info")
    information = folder / "hrbfnpr.egg-info"
    (information / "PKG-INFO").rename(folder / "PKG-INFO")
    shutil.rmtree(information)
    top = f"hrbfnpr-{release.version}"
    return write_tar(release.dist / f"{top}.tar.gz", tree(folder, f"{top}/"), release.epoch)


def make(release: Release) -> List[Path]:
    """Make a wheel for each built library, and the source package."""
    release.dist.mkdir(parents=True, exist_ok=True)
    wheels = [make_wheel(native, release) for native in release.natives.values()]
    return [*wheels, make_source_package(release)]
