# SPDX-License-Identifier: MIT
"""Makes the Debian packages: the library, the files for compiling with it, and the Python package with its command."""
from __future__ import annotations

import gzip
import hashlib
import os
import re
import shutil
import tomllib
from dataclasses import dataclass, field
from email.utils import formatdate
from pathlib import Path
from time import gmtime, strftime
from typing import Any, Dict, List, Mapping, Tuple, Union

from common import HEADERS, ROOT, Contents, Native, Release, notices, read, run, tracked_files

MAINTAINER = "The hrbfnpr authors <hrbfnpr@hrbfnpr.invalid>"  # the project has no address yet
TRIPLETS = {"amd64": "x86_64-linux-gnu", "arm64": "aarch64-linux-gnu"}  # folder of libraries by Debian's processor name
ABOUT = """hrbfnpr draws 3D shapes in pen and ink: stipples, hatching and exact
contours with hidden lines. It fits a smooth surface to points, a scan or a
mesh, and draws it on the CPU, as pixels or as vectors."""
APACHE_LICENSE = re.compile(r"^ *Apache License\n *Version 2\.0,.*?(?=^```)", re.MULTILINE | re.DOTALL)
Files = Dict[str, Union[Path, bytes, str]]  # path below the root of the system -> contents, as in common.Contents
EXAMPLES = ("quickstart.c", "quickstart.cpp")

COMMAND = """#!/usr/bin/python3
import sys

from hrbfnpr.cli import main

sys.exit(main())
"""
COMPILE = """#!/bin/sh
set -e
if [ "$1" = configure ] && command -v py3compile >/dev/null; then
	py3compile -p python3-hrbfnpr
fi
"""
CLEAN = """#!/bin/sh
set -e
if command -v py3clean >/dev/null; then
	py3clean -p python3-hrbfnpr
fi
"""


@dataclass
class Package:
    name: str
    architecture: str
    files: Files
    fields: Mapping[str, str]  # besides those that write() adds to each control file
    control: Dict[str, str] = field(default_factory=dict)  # other control files


def make(release: Release) -> List[Path]:
    packages = []
    for native in release.natives.values():
        if native.platform.debian:
            packages += [library(release, native), development(release, native)]
    packages.append(python(release))
    return [write(release, package) for package in packages]


def library(release: Release, native: Native) -> Package:
    """Return the package that programs need at run time."""
    name, soname = f"libhrbfnpr{abi()}", f"libhrbfnpr.so.{abi()}"
    glibc = ".".join(re.findall(r"\d+", native.platform.wheel_tag)[:2])  # manylinux_2_17_x86_64 needs glibc 2.17
    folder = f"usr/lib/{TRIPLETS[native.platform.debian]}"
    return Package(
        name, native.platform.debian,
        {**documents(release, name, notices([*HEADERS, *native.platform.runtimes])),
         f"{folder}/{native.library.name}": stripped(release, native),
         f"{folder}/{soname}": native.folder / "lib" / soname},
        {"Section": "libs", "Multi-Arch": "same", "Depends": f"libc6 (>= {glibc})",
         "Description": description("library for pen-and-ink drawings of 3D shapes", "the shared library")},
        {"shlibs": f"libhrbfnpr {abi()} {name} (>= {release.version})\n", "triggers": "activate-noawait ldconfig\n"})


def development(release: Release, native: Native) -> Package:
    """Return the package that compilers need."""
    name, triplet = "libhrbfnpr-dev", TRIPLETS[native.platform.debian]
    folder = f"usr/lib/{triplet}"
    files: Files = {
        **documents(release, name),
        **{f"usr/share/doc/{name}/examples/{example}": ROOT / "examples" / example for example in EXAMPLES},
        f"{folder}/libhrbfnpr.so": native.folder / "lib" / "libhrbfnpr.so",
    }
    for path in sorted([*native.folder.glob("include/*"), *native.folder.glob("share/hrbfnpr/*")]):
        files[f"usr/{path.relative_to(native.folder)}"] = path
    for path in sorted([*native.folder.glob("lib/cmake/hrbfnpr/*"), *native.folder.glob("lib/pkgconfig/*")]):
        files[f"{folder}/{path.relative_to(native.folder / 'lib')}"] = moved(path, triplet)
    return Package(
        name, native.platform.debian, files,
        {"Section": "libdevel", "Multi-Arch": "same", "Depends": f"libhrbfnpr{abi()} (= {release.version})",
         "Description": description("files for compiling with hrbfnpr",
                                    "the header, and files for CMake and pkg-config")})


def python(release: Release) -> Package:
    """Return the package of the Python module and of the command."""
    name, folder = "python3-hrbfnpr", "usr/lib/python3/dist-packages"
    source, needed = Path("bindings/python"), project()["requires-python"].replace(">=", ">= ")
    return Package(
        name, "all",
        {**documents(release, name),
         **{f"{folder}/{path.relative_to(source)}": ROOT / path for path in tracked_files(f"{source}/hrbfnpr")},
         f"{folder}/hrbfnpr-{release.version}.dist-info/METADATA": metadata(release),
         "usr/bin/hrbfnpr": COMMAND,
         "usr/share/man/man1/hrbfnpr.1.gz": packed(manual(release))},
        {"Section": "python",
         "Depends": f"python3:any ({needed}), libhrbfnpr{abi()} (>= {release.version}), "
                    "python3-cffi-backend | python3-cffi, python3-numpy, python3-pil",
         "Recommends": "python3-meshio, python3-tqdm",
         "Description": description("pen-and-ink drawings of 3D shapes (Python 3)",
                                    "the Python package and the command hrbfnpr")},
        {"postinst": COMPILE, "prerm": CLEAN})


def abi() -> str:
    header = (ROOT / "include" / "hrbfnpr.h").read_text(encoding="utf-8")
    return re.search(r"HRBFNPR_ABI_VERSION = (\d+)", header).group(1)


def description(summary: str, contents: str) -> str:
    """Return the field Description."""
    about = ABOUT.replace("\n", "\n ")
    return f"{summary}\n {about}\n .\n This package contains {contents}."


def documents(release: Release, name: str, third_party: str = "") -> Files:
    """Return the files that Debian wants in each package: the licence and the changelog."""
    folder = f"usr/share/doc/{name}"
    return {f"{folder}/copyright": copyright_file(third_party), f"{folder}/changelog.gz": packed(changelog(release))}


def copyright_file(third_party: str) -> str:
    """Return the licence in Debian's format, with the notices for the code of third parties."""
    title, holder, terms = (ROOT / "LICENSE").read_text(encoding="utf-8").strip().split("\n\n", 2)
    assert title == "MIT License", title
    header = "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: hrbfnpr\n"
    if third_party:  # Debian wants a reference in place of a long text that every system has
        short = APACHE_LICENSE.sub("See /usr/share/common-licenses/Apache-2.0.\n", third_party)
        header += "Comment:\n" + indented(re.sub(r"^```.*\n", "", short, flags=re.MULTILINE)) + "\n"
    copyright_line = holder.replace("Copyright (c)", "Copyright:")
    return f"{header}\nFiles: *\n{copyright_line}\nLicense: Expat\n{indented(terms)}\n"


def indented(text: str) -> str:
    """Return the text as the continuation lines of a control field."""
    return "\n".join(f" {line}" if line.strip() else " ." for line in text.rstrip().split("\n"))


def changelog(release: Release) -> str:
    return (f"hrbfnpr ({release.version}) unstable; urgency=medium\n\n  * Release {release.version}.\n\n"
            f" -- {MAINTAINER}  {formatdate(release.epoch)[:-5]}+0000\n")


def manual(release: Release) -> str:
    page = (ROOT / "docs" / "hrbfnpr.1").read_text(encoding="utf-8")
    date = strftime("%Y-%m-%d", gmtime(release.epoch))
    return page.replace("@DATE@", date).replace("@VERSION@", release.version)


def metadata(release: Release) -> str:
    """Return the metadata by which pip finds the package."""
    facts = project()
    required = "".join(f"Requires-Dist: {requirement}\n" for requirement in facts["dependencies"])
    return (f"Metadata-Version: 2.1\nName: {facts['name']}\nVersion: {release.version}\n"
            f"Summary: {facts['description']}\nLicense: {facts['license']['text']}\n"
            f"Requires-Python: {facts['requires-python']}\n{required}")


def project() -> Dict[str, Any]:
    """Return the facts about the Python package."""
    return tomllib.loads((ROOT / "bindings/python/pyproject.toml").read_text(encoding="utf-8"))["project"]


def packed(text: str) -> bytes:
    return gzip.compress(text.encode("utf-8"), 9, mtime=0)


def stripped(release: Release, native: Native) -> Path:
    """Return the library without symbols that only debuggers read."""
    triplet = TRIPLETS[native.platform.debian]
    copy = release.scratch(f"stripped-{native.platform.rid}") / native.library.name
    shutil.copyfile(native.library, copy)
    copy.chmod(0o644)
    if ".symtab" in run("readelf", "--sections", "--wide", copy, quiet=True):
        run(f"{triplet}-strip", "--strip-unneeded", copy)
    return copy


def moved(path: Path, triplet: str) -> str:
    """Return a file for CMake or pkg-config as it must be when lib/ becomes /usr/lib/TRIPLET."""
    text = path.read_text(encoding="utf-8").replace("${_IMPORT_PREFIX}/lib/", f"${{_IMPORT_PREFIX}}/lib/{triplet}/")
    start = 'get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)\n'
    text = text.replace(start, start + 'get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)\n')
    text = text.replace("${CMAKE_CURRENT_LIST_DIR}/../../../", "${CMAKE_CURRENT_LIST_DIR}/../../../../")
    text = re.sub(r"^prefix=.*$", "prefix=/usr", text, flags=re.MULTILINE)
    return re.sub(r"^libdir=.*$", f"libdir=${{prefix}}/lib/{triplet}", text, flags=re.MULTILINE)


def write(release: Release, package: Package) -> Path:
    """Write the package.  Its bytes depend only on its contents and the release's date."""
    stage = release.scratch(f"deb-{package.name}-{package.architecture}")
    fill(stage, package.files)
    size = sum(1 if path.is_dir() or path.is_symlink() else -(-path.stat().st_size // 1024)
               for path in stage.rglob("*"))
    fields = {"Package": package.name, "Source": "hrbfnpr", "Version": release.version,
              "Architecture": package.architecture, "Maintainer": MAINTAINER, "Installed-Size": str(size),
              "Priority": "optional", **package.fields}
    sums = "".join(f"{hashlib.md5(read(path)).hexdigest()}  {name}\n" for name, path in regular_files(stage))
    control = "".join(f"{key}: {value}\n" for key, value in fields.items())
    fill(stage / "DEBIAN", {**package.control, "control": control, "md5sums": sums})
    for path in [stage, *stage.rglob("*")]:
        os.utime(path, (release.epoch, release.epoch), follow_symlinks=False)
    out = release.dist / f"{package.name}_{release.version}_{package.architecture}.deb"
    run("dpkg-deb", "--root-owner-group", "-Zxz", "--build", stage, out,
        env={**release.environment, "DPKG_DEB_THREADS_MAX": "1"})
    return out


def regular_files(folder: Path) -> List[Tuple[str, Path]]:
    return sorted((path.relative_to(folder).as_posix(), path) for path in folder.rglob("*")
                  if path.is_file() and not path.is_symlink())


def fill(folder: Path, contents: Contents) -> None:
    """Write the contents below the folder.  Scripts become executable; links stay links."""
    for name, source in contents.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(source, Path) and source.is_symlink():
            path.symlink_to(os.readlink(source))
            continue
        path.write_bytes(read(source))
        path.chmod(0o755 if read(source).startswith(b"#!") else 0o644)
    for path in [folder, *folder.rglob("*")]:
        if path.is_dir():
            path.chmod(0o755)
