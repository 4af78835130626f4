# SPDX-License-Identifier: MIT
"""The licence line of every source file.

    spdx.py ROOT          prints the files without a licence line in their first 20 lines; returns 1 if there are any
    spdx.py ROOT --fix    adds the line to these files

Generated files are left alone by --fix: change their generator and run it.
"""

import re
import sys
from pathlib import Path

LINE = "SPDX-License-Identifier: MIT"
FIRST_LINES = 20
FOLDERS = ("src", "include", "tests", "bench", "examples", "bindings", "scripts", "cmake", "docs", ".github")
# Folders of generated files: build trees, and those of Python and .NET.
SKIPPED_FOLDERS = {"build", "dist", "bin", "obj", "__pycache__"}
SLASHES, STARS, HASH, DASHES = "// {}", "/* {} */", "# {}", "-- {}"
COMMENTS = {
    ".h": SLASHES,
    ".cpp": SLASHES,
    ".c": STARS,
    ".cs": SLASHES,
    ".js": SLASHES,
    ".py": HASH,
    ".cmake": HASH,
    ".sh": HASH,
    ".yml": HASH,
    ".lua": DASHES,
    ".rs": SLASHES,
}
GENERATED = re.compile(r"\W*(?:made|generated|written) (?:by|from) .*\bdo not edit\b", re.IGNORECASE)


def comment_of(path, text):
    """The comment syntax of a source file, or None for other files."""
    if path.name == "CMakeLists.txt":
        return HASH
    if path.suffix in (".h", ".cpp") and text.startswith("/*"):
        return STARS  # like the file's own comments
    if path.suffix:
        return COMMENTS.get(path.suffix)
    return HASH if re.match(r"#!.*\b(?:ba|da)?sh\b|#!.*\bpython", text) else None


def source_files(root):
    """Pairs of a source file and its text, sorted by name."""
    paths = [root / "CMakeLists.txt"]
    for folder in FOLDERS:
        paths += sorted(path for path in (root / folder).rglob("*") if path.is_file())
    for path in paths:
        if not path.is_file() or SKIPPED_FOLDERS.intersection(path.relative_to(root).parts[:-1]):
            continue
        if path.suffix and path.suffix not in COMMENTS and path.name != "CMakeLists.txt":
            continue
        try:
            text = path.read_bytes().decode("utf-8")
        except UnicodeDecodeError:
            continue  # data without an ending
        if comment_of(path, text.lstrip("\ufeff")):
            yield path, text


def has_line(text):
    return any(LINE in line for line in text.splitlines()[:FIRST_LINES])


def is_generated(text):
    return any(GENERATED.match(line) for line in text.splitlines()[:FIRST_LINES])


def with_line(path, text):
    """The text with the licence line in its place: first, or after a byte order mark, a #! line and an encoding."""
    mark = "\ufeff" if text.startswith("\ufeff") else ""
    lines = text[len(mark):].splitlines(keepends=True)
    end = "\r\n" if lines and lines[0].endswith("\r\n") else "\n"
    place = 1 if lines and lines[0].startswith("#!") else 0
    if path.suffix in (".py", "") and len(lines) > place and re.match(r"#.*coding[:=]", lines[place]):
        place += 1
    if place and not lines[place - 1].endswith("\n"):
        lines[place - 1] += end
    lines.insert(place, comment_of(path, text[len(mark):]).format(LINE) + end)
    return mark + "".join(lines)


def missing(root):
    """The violations in words."""
    seen = False
    for path, text in source_files(root):
        seen = True
        if not has_line(text):
            name = path.relative_to(root).as_posix()
            if is_generated(text):
                yield f"{name} lacks {LINE!r}: let the program write it that made the file"
            else:
                yield f"{name} lacks {LINE!r} in its first {FIRST_LINES} lines: run scripts/add_spdx"
    if not seen:
        yield "there are no source files"


def fix(root):
    """The names of the changed files, and of the generated files that lack the line."""
    changed, left = [], []
    for path, text in source_files(root):
        if has_line(text):
            continue
        if is_generated(text):
            left.append(path.relative_to(root).as_posix())
            continue
        path.write_bytes(with_line(path, text).encode("utf-8"))
        changed.append(path.relative_to(root).as_posix())
    return changed, left


def main():
    root = Path(sys.argv[1]).resolve()
    if sys.argv[2:] == ["--fix"]:
        changed, left = fix(root)
        print("\n".join(changed + [f"{name} is written by a program: not changed" for name in left]))
        print(f"{len(changed)} files got the line, {len(left)} wait for the program that writes them")
        return 1 if left else 0
    findings = list(missing(root))
    print("\n".join(findings) if findings else "every source file names its licence")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
