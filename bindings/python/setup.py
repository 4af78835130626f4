# SPDX-License-Identifier: MIT
"""Builds wheels that contain the C++ library, for any Python 3 on one platform.

The library is the one that HRBFNPR_LIBRARY names, or else the newest release build of the checkout.  If there is neither,
CMake builds it from the sources.  The environment variable CMAKE_ARGS has further options for CMake, such as
-DCMAKE_PREFIX_PATH=DIR.
"""
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Iterable, List, Tuple

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # setuptools before 70
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
# A source package has the C++ sources beside this file; a checkout has them two folders above.
ROOT = HERE if (HERE / "include" / "hrbfnpr.h").is_file() else HERE.parents[1]
SUFFIXES = (".so", ".dylib", ".dll")
CMAKE = (3, 25)  # the least version
DEBIAN = "g++ cmake ninja-build libeigen3-dev libglm-dev libhwy-dev nlohmann-json3-dev"
OPTIONS = (
    "CMAKE_BUILD_TYPE=Release", "HRBFNPR_OPENMP=OFF", "HRBFNPR_UNITY=ON", "HRBFNPR_PRECOMPILE=ON", "HRBFNPR_TESTS=OFF",
    "HRBFNPR_EXAMPLES=OFF", "HRBFNPR_INSTALL=OFF",
)  # fmt: skip
# CMake's errors contain these words if something is missing: what it is, and its Debian package.
MISSING = {
    "CMAKE_MAKE_PROGRAM": ("a build program", "ninja-build"),
    "CMAKE_C_COMPILER": ("a C compiler", "g++"),
    "CMAKE_CXX_COMPILER": ("a C++ compiler", "g++"),
    "Eigen3": ("Eigen 3.3", "libeigen3-dev"),
    "HRBFNPR_GLM_INCLUDE_DIR": ("GLM", "libglm-dev"),
    "HRBFNPR_HIGHWAY_INCLUDE_DIR": ("Highway", "libhwy-dev"),
    "HRBFNPR_JSON_INCLUDE_DIR": ("JSON for Modern C++", "nlohmann-json3-dev"),
}


def version() -> str:
    header = (ROOT / "include" / "hrbfnpr.h").read_text(encoding="utf-8")
    parts = (re.search(rf"HRBFNPR_VERSION_{part} = (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    return ".".join(part.group(1) for part in parts)


def refuse(what: str, package: str) -> None:
    """End with a message that names a missing program or library and says how to install it."""
    raise SystemExit(
        f"hrbfnpr is built from C++ sources, and {what}.\n"
        f"On Debian and Ubuntu it is in the package {package}. This command installs all that the build needs:\n"
        f"  apt-get install {DEBIAN}\n"
        "If it is in a folder that CMake does not search, set CMAKE_ARGS=-DCMAKE_PREFIX_PATH=FOLDER.\n"
        "If the library is built already, set HRBFNPR_LIBRARY to its path."
    )


def check_cmake() -> None:
    if shutil.which("cmake") is None:
        refuse("CMake is missing", "cmake")
    told = subprocess.run(["cmake", "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout
    found = re.search(r"(\d+)\.(\d+)", told)
    if found and tuple(map(int, found.groups())) < CMAKE:
        refuse(f"CMake {found.group()} is too old: {CMAKE[0]}.{CMAKE[1]} or later is needed", "cmake, from Debian 12 on")


def configure(build: Path) -> None:
    generator = ["-G", "Ninja"] if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ else []
    command = ["cmake", "-S", str(ROOT), "-B", str(build), *generator, *(f"-D{option}" for option in OPTIONS)]
    command += shlex.split(os.environ.get("CMAKE_ARGS", ""))
    print("+", shlex.join(command), flush=True)
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(result.stdout, flush=True)
    if result.returncode != 0:
        errors = result.stdout[result.stdout.find("CMake Error"):]
        for word, (what, package) in MISSING.items():
            if word in errors:
                refuse(f"CMake does not find {what}", package)
        raise SystemExit("CMake cannot configure the library; its messages are above")


def libraries(paths: Iterable[Path]) -> List[Path]:
    """Return the shared libraries among these files, the newest first."""
    found = [path for path in paths if path.suffix in SUFFIXES]
    return sorted(found, key=lambda path: path.stat().st_mtime, reverse=True)


def build_library(build: Path) -> Path:
    """Build the library with CMake in this folder, and return its path."""
    check_cmake()
    configure(build)
    command = ["cmake", "--build", str(build), "--config", "Release", "--target", "hrbfnpr"]
    if "CMAKE_BUILD_PARALLEL_LEVEL" not in os.environ:
        command += ["--parallel", str(os.cpu_count() or 1)]
    print("+", shlex.join(command), flush=True)
    if subprocess.run(command).returncode != 0:
        raise SystemExit("the library cannot be compiled; the compiler's messages are above")
    return libraries(build.rglob("*hrbfnpr*"))[0]


class BuildWithLibrary(build_py):
    def library(self) -> Path:
        named = os.environ.get("HRBFNPR_LIBRARY")
        if named:
            return Path(named)
        built = libraries(ROOT.glob("build/release/**/*hrbfnpr*")) if ROOT != HERE else []
        return built[0] if built else build_library(Path(self.get_finalized_command("build").build_temp).resolve() / "cmake")

    def run(self) -> None:
        super().run()
        source = self.library().resolve()
        suffix = next(suffix for suffix in SUFFIXES if suffix in source.name)
        shutil.copyfile(source, Path(self.build_lib) / "hrbfnpr" / f"libhrbfnpr{suffix}")


class PlatformDistribution(Distribution):
    def has_ext_modules(self) -> bool:
        return True


class PlatformWheel(bdist_wheel):
    def get_tag(self) -> Tuple[str, str, str]:
        return "py3", "none", super().get_tag()[2]

    def egg2dist(self, egginfo_path: str, distinfo_path: str) -> None:
        super().egg2dist(egginfo_path, distinfo_path)
        for name in ("LICENSE", "THIRD-PARTY-NOTICES.md"):
            shutil.copyfile(ROOT / name, Path(distinfo_path) / name)


setup(
    version=version(),
    distclass=PlatformDistribution,
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
)
