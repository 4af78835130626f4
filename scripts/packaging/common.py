# SPDX-License-Identifier: MIT
"""What the modules of this folder share: the release, its libraries, and archives with the same bytes each time."""
from __future__ import annotations

import gzip
import io
import os
import re
import shlex
import subprocess
import sys
import tarfile
import zipfile
from dataclasses import dataclass, field
from pathlib import Path
from time import gmtime
from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Union

ROOT = Path(__file__).resolve().parents[2]
PathLike = Union[str, Path]


@dataclass(frozen=True)
class Platform:
    """A system and processor that the packages serve."""

    rid: str  # the name that .NET gives it; also the name of the CMake preset that builds it
    library: str  # the file name of the shared library in packages
    wheel_tag: str  # the platform tag of its wheel
    debian: str = ""  # Debian's name of the processor, for Linux
    runtimes: Tuple[str, ...] = ()  # C++ runtimes inside the library; names of sections of THIRD-PARTY-NOTICES.md
    note: str = ""  # said wherever this platform is listed


PLATFORMS: Dict[str, Platform] = {
    platform.rid: platform
    for platform in (
        Platform("linux-x64", "libhrbfnpr.so", "manylinux_2_17_x86_64", "amd64", ("libc++",)),
        Platform("linux-arm64", "libhrbfnpr.so", "manylinux_2_17_aarch64", "arm64", ("libc++",), "run under qemu only"),
        Platform("win-x64", "libhrbfnpr.dll", "win_amd64", "", ("libstdc++", "winpthreads"), "run under Wine only"),
        Platform("osx-arm64", "libhrbfnpr.dylib", "macosx_11_0_arm64", "", ("libc++",), "not run"),
    )
}


@dataclass(frozen=True)
class Native:
    """A built library: the tree that `cmake --install` made, and the library file in it (not a link)."""

    platform: Platform
    folder: Path
    library: Path


@dataclass
class Release:
    """One run of scripts/release."""

    version: str
    epoch: int  # seconds since 1970: the date of all files in all packages
    dist: Path  # where the packages go
    work: Path  # scratch space; it may be deleted between runs
    natives: Dict[str, Native] = field(default_factory=dict)  # by RID, those that were built

    def scratch(self, name: str) -> Path:
        """Return an empty folder in the scratch space."""
        folder = self.work / name
        if folder.exists():
            run("rm", "-rf", folder)
        folder.mkdir(parents=True)
        return folder

    @property
    def environment(self) -> Dict[str, str]:
        """The environment of programs that write dates into packages."""
        return {**os.environ, "SOURCE_DATE_EPOCH": str(self.epoch), "TZ": "UTC", "LC_ALL": "C.UTF-8"}


def version() -> str:
    """Return the version of the header, which is the one place that sets it."""
    header = (ROOT / "include" / "hrbfnpr.h").read_text(encoding="utf-8")
    found = [re.search(rf"HRBFNPR_VERSION_{part} = (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH")]
    return ".".join(part.group(1) for part in found if part)


def source_date() -> int:
    """Return SOURCE_DATE_EPOCH, or else the date of the last commit."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    return int(given or run("git", "-C", ROOT, "log", "-1", "--format=%ct", quiet=True))


def run(*command: PathLike, cwd: Optional[PathLike] = None, env: Optional[Mapping[str, str]] = None,
        quiet: bool = False) -> str:
    """Run a command and return what it prints on its standard output.  A failure ends the program with its output."""
    words = [str(word) for word in command]
    if not quiet:
        print("+", shlex.join(words), flush=True)
    result = subprocess.run(words, cwd=cwd, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if result.returncode != 0:
        sys.exit(f"{result.stdout}{result.stderr}failed with status {result.returncode}: {shlex.join(words)}")
    return result.stdout


def tracked_files(*folders: str) -> List[Path]:
    """Return the files of these folders of the checkout that git tracks, relative to the root and sorted."""
    listed = run("git", "-C", ROOT, "ls-files", "-z", "--", *folders, quiet=True)
    return sorted(Path(name) for name in listed.split("\0") if name)


Contents = Mapping[str, Union[Path, bytes, str]]  # name in the archive -> file, or the file's contents


def read(source: Union[Path, bytes, str]) -> bytes:
    if isinstance(source, Path):
        return source.read_bytes()
    return source.encode("utf-8") if isinstance(source, str) else source


def is_executable(source: Union[Path, bytes, str]) -> bool:
    return isinstance(source, Path) and os.access(source, os.X_OK)


def tree(folder: Path, prefix: str = "") -> Dict[str, Path]:
    """Return the contents of a folder for write_tar and write_zip, with all names below `prefix`."""
    return {prefix + path.relative_to(folder).as_posix(): path
            for path in sorted(folder.rglob("*")) if path.is_file() or path.is_symlink()}


def write_tar(path: Path, contents: Contents, epoch: int) -> Path:
    """Write a .tar.gz whose bytes depend only on the names and the contents.  Symbolic links stay links."""
    with open(path, "wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=epoch) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted(contents):
            source = contents[name]
            entry = tarfile.TarInfo(name)
            entry.mtime = epoch
            entry.uname = entry.gname = "root"
            entry.mode = 0o755 if is_executable(source) else 0o644
            if isinstance(source, Path) and source.is_symlink():
                entry.type, entry.linkname, entry.mode = tarfile.SYMTYPE, os.readlink(source), 0o777
                archive.addfile(entry)
                continue
            data = read(source)
            entry.size = len(data)
            archive.addfile(entry, io.BytesIO(data))
    return path


def write_zip(path: Path, contents: Contents, epoch: int) -> Path:
    """Write a .zip whose bytes depend only on the names and the contents."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(contents):
            entry = zipfile.ZipInfo(name, gmtime(max(epoch, 315532800))[:6])  # a zip knows no date before 1980
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if is_executable(contents[name]) else 0o100644) << 16
            entry.create_system = 3
            archive.writestr(entry, read(contents[name]))
    return path


def notices(names: Sequence[str]) -> str:
    """Return THIRD-PARTY-NOTICES.md with only the sections of these names, besides its introduction.

    A section begins with `## NAME`.
    """
    text = (ROOT / "THIRD-PARTY-NOTICES.md").read_text(encoding="utf-8")
    introduction, *sections = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    by_name = {section.split("\n", 1)[0][3:].strip(): section for section in sections}
    missing = [name for name in names if name not in by_name]
    if missing:
        sys.exit(f"THIRD-PARTY-NOTICES.md has no section {', '.join(missing)}")
    return introduction + "".join(section for name, section in by_name.items() if name in names)


HEADERS = ("Eigen", "GLM", "Highway", "JSON for Modern C++")  # libraries whose code every build of ours contains
