# SPDX-License-Identifier: MIT
"""Builds wheels that contain the library, for any Python 3 on this platform.

The library is the one that HRBFNPR_LIBRARY names, or else the newest release build of the checkout.
"""
import os
import re
import shutil
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def version() -> str:
    header = (ROOT / "include" / "hrbfnpr.h").read_text(encoding="utf-8")
    parts = (re.search(rf"HRBFNPR_VERSION_{part} = (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    return ".".join(part.group(1) for part in parts)


def library() -> Path:
    named = os.environ.get("HRBFNPR_LIBRARY")
    if named:
        return Path(named)
    built = [path for path in ROOT.glob("build/release/**/*hrbfnpr*") if path.suffix in (".so", ".dylib", ".dll")]
    if not built:
        raise SystemExit("no library to put into the wheel: build the release preset or set HRBFNPR_LIBRARY")
    return max(built, key=lambda path: path.stat().st_mtime)


class BuildWithLibrary(build_py):
    def run(self) -> None:
        super().run()
        source = library().resolve()
        # Without version numbers: libhrbfnpr.so.1.1.2.3 becomes libhrbfnpr.so.
        name = re.sub(r"(\.so|\.dylib|\.dll).*", r"\1", source.name)
        shutil.copy2(source, Path(self.build_lib) / "hrbfnpr" / name)


class PlatformDistribution(Distribution):
    def has_ext_modules(self) -> bool:
        return True


class PlatformWheel(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(
    version=version(),
    distclass=PlatformDistribution,
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
)
