# SPDX-License-Identifier: MIT
"""Tests the library as one source file, which scripts/packaging/amalgamate.py writes.

    amalgamated.py files WORK                   the file has all sources, and two archives have the same bytes
    amalgamated.py program WORK CXX CC LIBRARY  a program with the file draws the same picture as one with LIBRARY
"""

import hashlib
import re
import shutil
import sys
from pathlib import Path

from package import SKIPPED, expect, run

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))
import amalgamate  # noqa: E402
import common  # noqa: E402

LEFT_OUT = re.compile(r"// SPDX-License|#pragma once|#(undef|define) HWY_TARGET_INCLUDE|\s*#\s*include ")
OPTIMIZATION = "-O1"  # faster to compile than -O2, and to run than -O0


def check_sources(text):
    """Each source is named once, and all its lines are there, in their order."""
    named = re.findall(r"^// src/(\S+)$", text, flags=re.MULTILINE)
    sources = [path for path in sorted((ROOT / "src").rglob("*")) if path.suffix in (".h", ".cpp")]
    expect(len(sources) > 400, f"only {len(sources)} sources were found")
    names = [path.relative_to(ROOT / "src").as_posix() for path in sources]
    expect(sorted(named) == names, f"missing, unknown or there twice: {sorted(set(names) ^ set(named)) or named}")
    for path in sources:
        begin = text.index(f"// src/{path.relative_to(ROOT / 'src').as_posix()}\n")
        piece = []
        for line in [*path.read_text(encoding="utf-8").split("\n"), "#pragma once"]:
            if not LEFT_OUT.match(line):
                piece.append(line)
                continue
            found = text.find("\n".join(piece).strip(), begin)
            expect(found >= 0, f"{path}: these lines are missing:\n" + "\n".join(piece))
            piece = []


def check_includes(text):
    quoted = set(re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, flags=re.MULTILINE))
    expect(quoted == {"hrbfnpr.h", "hrbfnpr.cpp"}, f"wrong includes: {sorted(quoted)}")
    other = re.findall(r"^#include <([^>]+)>$", text[: text.index("\n// =====")], flags=re.MULTILINE)
    expect(len(other) == len(set(other)), "a header is included twice at the top")


def check_third_party(files):
    folders = {name.split("/")[1] for name in files if name.startswith("third_party/")}
    expect(folders == set(amalgamate.THIRD_PARTY), f"wrong folders: {folders}")
    for name in ("hwy/ops/x86_512-inl.h", "hwy/ops/arm_neon-inl.h", "hwy/ops/wasm_128-inl.h"):
        expect(f"third_party/{name}" in files, f"{name} is missing")


def archives(work, name):
    folder = work / name
    folder.mkdir(parents=True)
    made = amalgamate.make(common.Release(common.version(), 1700000000, folder, folder))
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in made}


def files(work):
    text = amalgamate.source_text()
    check_sources(text)
    check_includes(text)
    check_third_party(amalgamate.contents())
    first, second = archives(work, "first"), archives(work, "second")
    expect(len(first) == 2 and first == second, f"the archives differ: {first} {second}")


def picture(work, name, cc, *linked):
    program = work / name
    run(cc, "-std=c99", "-DHRBFNPR_STATIC", "-I.", ROOT / "tests/clients/reference.c", *linked, "-o", program, cwd=work)
    run(program, ROOT / "examples/torus.xyzn", work / f"{name}.raw")
    return hashlib.sha256((work / f"{name}.raw").read_bytes()).hexdigest()


def program(work, cxx, cc, library):
    amalgamate.write_folder(work)
    cache = ["ccache"] if shutil.which("ccache") else []
    compiled = run(*cache, cxx, "-std=c++20", OPTIMIZATION, "-Wall", "-Wextra", "-isystem", "third_party",
                   "-DHRBFNPR_STATIC", "-c", "hrbfnpr.cpp", cwd=work)
    expect("warning" not in compiled, "the compiler warned")
    inside = picture(work, "inside", cc, "hrbfnpr.o", "-lstdc++", "-lm", "-pthread", "-ldl")
    shared = picture(work, "shared", cc, library, f"-Wl,-rpath,{Path(library).parent}")
    expect(inside == shared, f"the pictures differ: {inside} {shared}")


def main():
    step, work, *arguments = sys.argv[1:]
    folder = Path(work) / f"amalgamated {step}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    missing = [package for name, package in amalgamate.THIRD_PARTY.items()
               if not any((place / name).is_dir() for place in amalgamate.INCLUDE_FOLDERS)]
    if missing:
        print(f"not installed in the folders of the system: {' '.join(missing)}")
        sys.exit(SKIPPED)
    {"files": files, "program": program}[step](folder, *arguments)


if __name__ == "__main__":
    main()
