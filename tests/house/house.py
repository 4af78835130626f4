# SPDX-License-Identifier: MIT
"""The rules of the house (docs/design.md), checked on the sources.

    house.py ROOT CHECK     prints each violation and returns 1, or 77 if it cannot check

A CHECK is one of the functions below: floors, openmp, forbidden, namespaces, sizes, version, spdx, format, words.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import comments
import spdx as licence

SKIPPED = 77  # CTest's SKIP_RETURN_CODE

# A room may include itself and rooms of lower floors.
FLOORS = {
    "picture": 13,
    "api": 12,
    "frame": 11,
    "output/raster": 10,
    "output/vector": 10,
    "output/vertex": 10,
    "frame/depth_layers": 10,
    "frame/lines": 10,
    "generate": 10,
    "published": 9,
    "frame/hatch": 9,
    "frame/scene": 8,
    "features": 7,
    "hatching": 7,
    "creases": 6,
    "drawing": 6,
    "io": 6,
    "mesh/fit": 6,
    "mesh/pieces": 7,
    "stipples": 6,
    "visibility": 6,
    "curves": 5,
    "marks": 5,
    "orient": 5,
    "fit": 4,
    "surface": 4,
    "implicit": 3,
    "kernel": 2,
    "light": 2,
    "paint": 2,
    "mesh": 2,
    "geometry": 1,
    "base": 0,
}

# (pattern, the paths that may match it, the reason)
ONLY_IN = [
    (r"#\s*include\s*<hrbfnpr\.h>|#\s*include\s*\"hrbfnpr\.h\"", r"(api|picture)/", "only src/api and its first user, src/picture, know the public header"),
    (r"#\s*include\s*[<\"](Eigen|unsupported)/", r"fit/", "Eigen stays inside the solver"),
]
# Patterns that make a comment hard to read, each with a remedy.
HARD_WORDS = [
    (r"^[Oo]f ", "begin with the subject: 'For a closed chain, ...'"),
    (r"^\.\.\. |(?<![,_A-Z\]])(?<!, )\.\.\.$", "end the sentence; a sentence does not run over several declarations"),
    (r"\b[Ss]o (many|much)\b", "name the number or the distance"),
    (r"\b[Ww]hat (is|are|was|of|has)\b", "use a noun: 'the points outside', 'NaN'"),
    (r"\b(where|as|that) there (is|are) none\b", "name the thing that is missing"),
    (r"\b[Nn]obody\b|\b[Ww]hoever\b", "name the code that does it"),
]
WITH_COMMENTS = [".github", "src", "bench", "bindings", "cmake", "docs", "examples", "scripts", "tests"]
GENERATED = re.compile(r"\W*Made by .*\bdo not edit\b")
OPENMP = r"#\s*pragma\s+omp\b|<omp\.h>|\b_OPENMP\b|\bomp_\w+\s*\("
FORBIDDEN_IN_SOURCES = [
    (r"\bthread_local\b", "a host's job system may resume a call on another thread"),
    (r"\bmt19937|\brandom_device\b|\bstd::rand\b|\bsrand\s*\(|[^\w:.>]rand\s*\(\s*\)",
     "random numbers come from base/random.h, keyed by seed, index and purpose"),
]
FORBIDDEN_FLAGS = [
    (r"-march=native", "a shipped build must run on other processors"),
    (r"-ffast-math|-Ofast|-funsafe-math-optimizations", "it switches the host to flush-to-zero at link"),
]
LONGEST_FILE = 900
LONGEST_LINE = 120  # clang-format leaves the header as it is
# The only files that contain the version as text: bindings/generate writes it, or the file tells the history.
WITH_VERSION = {
    "CITATION.cff", "bindings/api.json", "bindings/csharp/Unity/package.json", "bindings/js/package.json",
    "bindings/rust/hrbfnpr-sys/Cargo.toml", "README.md", "docs/python.md",
    "CHANGELOG.md", "docs/file-format.md", "tests/io/golden_test.cpp",
}  # fmt: skip
TEXTS = {
    "", ".c", ".cff", ".cmake", ".cpp", ".cs", ".csproj", ".h", ".html", ".in", ".js", ".json", ".lua", ".md", ".mjs", ".props",
    ".py", ".rs", ".sh", ".toml", ".ts", ".txt", ".yml",
}  # fmt: skip


def source_files(root, folders, suffixes):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            hidden = any(part in ("build", "dist", "bin", "obj", "__pycache__") for part in path.relative_to(root).parts)
            if path.suffix in suffixes and path.is_file() and not hidden:
                yield path


def lines(path):
    return enumerate(path.read_text(encoding="utf-8").splitlines(), 1)


def room_of(path):
    """The room of a path relative to src/, or None."""
    for depth in (2, 1):
        room = "/".join(path.parts[:depth])
        if len(path.parts) > depth and room in FLOORS:
            return room
    return None


def broken_include(src, path, target):
    """The reason why the file `path` of src/ may not include "target", or None."""
    room = room_of(path.relative_to(src))
    if room is None:
        return "is in no room of the house: give its folder a floor in tests/house/house.py"
    if (path.parent / target).is_file() and "/" not in target:
        return None
    below = room_of(Path(target))
    if below is None or not (src / target).is_file():
        return f'includes "{target}", which is no file of src/: write its path from src/'
    if below != room and FLOORS[below] >= FLOORS[room]:
        return f'is on floor {FLOORS[room]} ({room}) and includes "{target}" of floor {FLOORS[below]} ({below})'
    return None


def floors(root):
    src = root / "src"
    files = list(source_files(root, ["src"], {".h", ".cpp"}))
    if not files:
        yield "src/ has no sources"
    for path in files:
        if room_of(path.relative_to(src)) is None:
            yield f"{path.relative_to(root)} is in no room of the house"
            continue
        for number, line in lines(path):
            found = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            why = broken_include(src, path, found.group(1)) if found and found.group(1) != "hrbfnpr.h" else None
            if why:
                yield f"{path.relative_to(root)}:{number} {why}"
            for pattern, allowed, reason in ONLY_IN:
                if re.search(pattern, line) and not re.match(allowed, path.relative_to(src).as_posix()):
                    yield f"{path.relative_to(root)}:{number} {reason}"


def openmp(root):
    files = list(source_files(root, ["src"], {".h", ".cpp"}))
    owner = root / "src/base/parallel_openmp.cpp"
    if owner not in files or not re.search(OPENMP, owner.read_text(encoding="utf-8")):
        yield "src/base/parallel_openmp.cpp does not name OpenMP: is this check still looking for the right words?"
    for path in files:
        for number, line in lines(path):
            if path != owner and re.search(OPENMP, line):
                yield f"{path.relative_to(root)}:{number} only src/base/parallel_openmp.cpp may name OpenMP"


def forbidden(root):
    for path in source_files(root, ["src"], {".h", ".cpp"}):
        for number, line in lines(path):
            for pattern, reason in FORBIDDEN_IN_SOURCES:
                if re.search(pattern, line.split("//")[0]):
                    yield f"{path.relative_to(root)}:{number} {reason}"
    build = list(source_files(root, ["cmake", "src", "tests", "bench", "examples"], {".cmake", ".txt", ".in", ".cpp", ".h"}))
    for path in [root / "CMakeLists.txt", root / "CMakePresets.json", *build]:
        for number, line in lines(path):
            for pattern, reason in FORBIDDEN_FLAGS:
                if re.search(pattern, line):
                    yield f"{path.relative_to(root)}:{number} {reason}"


def namespaces(root):
    """Tests are compiled several files at a time (HRBFNPR_UNITY), so each file needs its own namespace."""
    for path in source_files(root, ["tests"], {".cpp"}):
        if path.name.endswith("_test.cpp"):
            own = rf"^namespace ([\w:]+::)?{path.stem} {{$"
            if not re.search(own, path.read_text(encoding="utf-8"), re.MULTILINE):
                yield f"{path.relative_to(root)} has no namespace {path.stem} of its own"


def sizes(root):
    folders = ["src", "tests", "bench", "examples", "bindings"]
    for path in source_files(root, folders, {".h", ".cpp", ".c", ".cs", ".py", ".cmake"}):
        count = sum(1 for _ in lines(path))
        if count > LONGEST_FILE:
            yield f"{path.relative_to(root)} has {count} lines: split it ({LONGEST_FILE} at most)"
    for path in sorted((root / "include").glob("*.h")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if len(line) > LONGEST_LINE:
                yield f"{path.relative_to(root)}:{number} has {len(line)} characters: break it ({LONGEST_LINE} at most)"


def numbers(text, pattern):
    return [int(number) for number in re.findall(pattern, text)]


def version(root):
    """Only the header sets the version and the ABI version. bindings/generate --check compares the files that it writes."""
    header = (root / "include/hrbfnpr.h").read_text(encoding="utf-8")
    names = [f"HRBFNPR_{name}" for name in ("VERSION_MAJOR", "VERSION_MINOR", "VERSION_PATCH", "ABI_VERSION")]
    values = [numbers(header, rf"{name} = (\d+)") for name in names]
    if any(len(found) != 1 for found in values):
        yield f"include/hrbfnpr.h must set each of {', '.join(names)} once"
        return
    literal = re.compile(r"(?<!\d)" + r"\.".join(str(found[0]) for found in values[:3]) + r"(?!\d)")
    inside = source_files(root, [*WITH_COMMENTS, "include"], TEXTS)
    for path in [*(path for path in sorted(root.iterdir()) if path.suffix in TEXTS and path.is_file()), *inside]:
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="ignore").splitlines(), 1):
            if name not in WITH_VERSION and literal.search(line):
                yield f"{name}:{number} contains the version: read it from the header, or see WITH_VERSION in house.py"
    for name, pattern in (("CMakeLists.txt", r"\(HRBFNPR_ABI_VERSION \d"), ("src/hrbfnpr.map.in", r"HRBFNPR_\d")):
        if re.search(pattern, (root / name).read_text(encoding="utf-8")):
            yield f"{name} sets the ABI version: read it from the header"


def spdx(root):
    yield from licence.missing(root)


def format(root):
    tool = shutil.which("clang-format-14")
    if tool is None:
        print("skipped: there is no clang-format-14 here (other versions format differently)")
        sys.exit(SKIPPED)
    files = [str(path) for path in source_files(root, ["src", "tests", "bench", "examples"], {".h", ".cpp", ".c"})]
    result = subprocess.run([tool, "--dry-run", "-Werror", "--style=file", *files], capture_output=True, text=True)
    if result.returncode != 0:
        yield "please run scripts/lint --fix; clang-format-14 says:\n" + result.stderr


def commented_files(root):
    """Pairs of a file that may have comments and its text. A generated file has its comments from elsewhere."""
    inside = source_files(root, WITH_COMMENTS, {"", ".txt", *comments.MARKS})
    for path in [root / "CMakeLists.txt", *inside]:
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # a fuzzer's input
        if not any(GENERATED.match(line) for line in text.splitlines()[:3]):
            yield path, text


def words(root):
    """Comments are sentences that a reader understands without parsing them twice."""
    for path, text in commented_files(root):
        for number, comment in sorted(comments.comments(path, text)):
            for pattern, remedy in HARD_WORDS:
                if found := re.search(pattern, comment):
                    yield f"{path.relative_to(root)}:{number}: '{found.group(0)}': {remedy}"


CHECKS = {
    check.__name__: check
    for check in (floors, openmp, forbidden, namespaces, sizes, version, spdx, format, words)
}


def main():
    root, name = Path(sys.argv[1]).resolve(), sys.argv[2]
    findings = list(CHECKS[name](root))
    print("\n".join(findings) if findings else f"{name}: nothing breaks the rule")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
