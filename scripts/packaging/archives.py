# SPDX-License-Identifier: MIT
"""Makes an archive with header and library for each platform, and the archive of the sources."""
from __future__ import annotations

from pathlib import Path
from typing import Dict, List, Union

from common import HEADERS, ROOT, Native, Release, notices, tracked_files, tree, write_tar, write_zip

FOLDERS = ("bin", "include", "lib", "share/hrbfnpr")  # those of the install tree that the archive has

README = """hrbfnpr {version} for {rid}{note}

header     include/hrbfnpr.h; share/hrbfnpr/api.json describes it for binding generators
library    {library}
CMake      find_package(hrbfnpr {minor} REQUIRED) and target_link_libraries(NAME hrbfnpr::hrbfnpr),
           then: cmake -DCMAKE_PREFIX_PATH=THIS_FOLDER ...
pkg-config export PKG_CONFIG_PATH=THIS_FOLDER/lib/pkgconfig
           cc program.c $(pkg-config --cflags --libs hrbfnpr)
run        {run}
licence    LICENSE and THIRD-PARTY-NOTICES.md must accompany the library
"""
RUN = {
    "linux": "LD_LIBRARY_PATH=THIS_FOLDER/lib, or link with -Wl,-rpath",
    "osx": "link with -Wl,-rpath,THIS_FOLDER/lib; macOS must trust the library, which is not notarised",
    "win": "keep libhrbfnpr.dll beside the program; MSVC links lib/hrbfnpr.lib, MinGW lib/libhrbfnpr.dll.a",
}


def make(release: Release) -> List[Path]:
    return [*(for_platform(release, native) for native in release.natives.values()), sources(release)]


def name_of(release: Release, rid: str) -> str:
    """Return the name of the archive of a platform, which is also the folder in it."""
    return f"hrbfnpr-{release.version}-{rid}"


def for_platform(release: Release, native: Native) -> Path:
    name = name_of(release, native.platform.rid)
    contents: Dict[str, Union[Path, str]] = {
        "LICENSE": ROOT / "LICENSE",
        "THIRD-PARTY-NOTICES.md": notices([*HEADERS, *native.platform.runtimes]),
        "README.txt": readme(release, native),
    }
    for folder in FOLDERS:
        contents.update(tree(native.folder / folder, f"{folder}/"))
    inside = {f"{name}/{path}": source for path, source in contents.items()}
    if native.platform.rid.startswith("win"):
        return write_zip(release.dist / f"{name}.zip", inside, release.epoch)
    return write_tar(release.dist / f"{name}.tar.gz", inside, release.epoch)


def readme(release: Release, native: Native) -> str:
    platform = native.platform
    return README.format(
        version=release.version, minor=release.version.rpartition(".")[0], rid=platform.rid,
        note=f" ({platform.note})" if platform.note else "",
        library=native.library.relative_to(native.folder).as_posix(), run=RUN[platform.rid.partition("-")[0]])


def sources(release: Release) -> Path:
    name = f"hrbfnpr-{release.version}"
    inside = {f"{name}/{path.as_posix()}": ROOT / path for path in tracked_files()}
    return write_tar(release.dist / f"{name}-source.tar.gz", inside, release.epoch)
