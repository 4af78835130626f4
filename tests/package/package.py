# SPDX-License-Identifier: MIT
"""Builds other projects with the installed library, which is moved to a path with a space.

    package.py install BUILD WORK     installs BUILD below WORK and moves it
    package.py STEP SOURCE WORK       one of the other steps below; SOURCE is the library's source folder
    package.py static SOURCE WORK BUILD    reuses objects of BUILD, which made the shared library
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SKIPPED = 77


def version():
    """The version of the header."""
    header = (HERE.parents[1] / "include" / "hrbfnpr.h").read_text(encoding="utf-8")
    parts = (re.search(rf"HRBFNPR_VERSION_{part} = (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    return ".".join(part.group(1) for part in parts)


VERSION = version()


def run(*command, **options):
    command = [str(word) for word in command]
    print("+", shlex.join(command), flush=True)
    result = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    print(result.stdout, flush=True)
    if result.returncode != 0:
        sys.exit(f"failed with {result.returncode}: {shlex.join(command)}")
    return result.stdout


def expect(condition, message):
    if not condition:
        sys.exit(message)


def moved(work):
    return work / "a moved place"


def library_folder(prefix):
    found = [path.parent for path in prefix.rglob("libhrbfnpr.*") if path.suffix in (".so", ".a")]
    expect(len(found) == 1, f"there should be one library below {prefix}, found {found}")
    return found[0]


def configure(source, build, *definitions, launcher=()):
    shutil.rmtree(build, ignore_errors=True)
    launcher = [*map(str, launcher), *(["ccache"] if shutil.which("ccache") else [])]
    if launcher:
        definitions = [*definitions, f"-DCMAKE_CXX_COMPILER_LAUNCHER={';'.join(launcher)}"]
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, *definitions)


def run_consumer(program, **environment):
    output = run(program, env={**os.environ, **environment})
    expect(output == f"2 {VERSION}\n", f"the program should have printed '2 {VERSION}'")


def install(build, work):
    shutil.rmtree(work, ignore_errors=True)
    stage = work / "stage"
    run("cmake", "--install", build, "--prefix", stage)
    stage.rename(moved(work))
    texts = [path for path in moved(work).rglob("*") if path.suffix in (".cmake", ".pc")]
    expect(len(texts) >= 4, f"package files are missing: {texts}")
    for path in texts:
        text = path.read_text()
        for leak in (str(stage), str(build), str(HERE.parent.parent), "Eigen", "glm", "nlohmann"):
            expect(leak not in text, f"{path.name} names {leak}")
        expect("OpenMP::" not in text or path.name == "hrbfnprConfig.cmake", f"{path.name} names OpenMP")
    for name in ("include/hrbfnpr.h", "share/doc/hrbfnpr/LICENSE", "share/hrbfnpr/api.json",
                 "share/hrbfnpr/hrbfnpr_cdef.h"):
        expect((moved(work) / name).is_file(), f"{name} was not installed")


def find_package(language, prefix, work):
    build = work / f"find package {language}"
    wanted = VERSION.rpartition(".")[0]  # MAJOR.MINOR
    configure(HERE / language, build, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DHRBFNPR_WANTED={wanted}")
    run("cmake", "--build", build)
    run_consumer(build / "consumer")


def pkg_config(language, prefix, work):
    if shutil.which("pkg-config") is None:
        print("skipped: there is no pkg-config here")
        sys.exit(SKIPPED)
    folder = library_folder(prefix)
    environment = {**os.environ, "PKG_CONFIG_PATH": str(folder / "pkgconfig")}
    flags = shlex.split(run("pkg-config", "--cflags", "--libs", "hrbfnpr", env=environment))
    expect(run("pkg-config", "--modversion", "hrbfnpr", env=environment).strip() == VERSION, "wrong version")
    compiler, source = {
        "c": (["cc", "-std=c99"], HERE / "c/main.c"),
        "cxx": (["c++", "-std=c++11"], HERE / "cxx/main.cpp"),
    }[language]
    program = work / f"pkg config {language}"
    run(*compiler, "-Wall", "-Wextra", "-pedantic", "-Werror", source, *flags, "-o", program)
    run_consumer(program, LD_LIBRARY_PATH=str(folder))


def subdirectory(source, work):
    """A C-only project adds the library as a subdirectory without options, and gets only a shared library."""
    build = work / "sub directory"
    configure(HERE / "subdirectory", build, f"-DHRBFNPR_SOURCE_DIR={source}", "-DCMAKE_BUILD_TYPE=Debug")
    seen = (build / "seen.txt").read_text()
    expect(seen == "type=SHARED_LIBRARY\ncache-shared=\nbuild-type=Debug\n", f"unexpected: {seen}")


def static(source, work):
    """The static library is linked into its host project, installed, moved, and linked into C and C++ projects.

    Only the objects of the boundary are compiled again; the rest are those of the shared library.
    """
    build, stage, prefix = work / "static build", work / "static stage", work / "a static place"
    shutil.rmtree(prefix, ignore_errors=True)
    configure(HERE / "subdirectory", build, f"-DHRBFNPR_SOURCE_DIR={source}", "-DHOST_LANGUAGES=C;CXX",
              "-DBUILD_SHARED_LIBS=OFF", "-DHRBFNPR_INSTALL=ON", "-DCMAKE_BUILD_TYPE=Debug",
              "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DHRBFNPR_PRECOMPILE=ON", "-DHRBFNPR_UNITY=ON",
              launcher=(HERE / "reuse.sh", sys.argv[4]))
    run("cmake", "--build", build)
    run_consumer(build / "consumer")
    run("cmake", "--install", build, "--prefix", stage)
    stage.rename(prefix)
    consumers = work / "static"
    consumers.mkdir(exist_ok=True)
    for language in ("c", "cxx"):
        find_package(language, prefix, consumers)
        pkg_config(language, prefix, consumers)


def main():
    step, first, work = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    builders = {"install": install, "subdirectory": subdirectory, "static": static}
    if step in builders:
        work = work / step
        work.mkdir(parents=True, exist_ok=True)
        builders[step](first, work)
    else:
        way, language = step.rsplit("-", 1)
        work = work / "install"
        {"find-package": find_package, "pkg-config": pkg_config}[way](language, moved(work), work)


if __name__ == "__main__":
    main()
