# SPDX-License-Identifier: MIT
"""Writes the library as one source file, for people who copy files into their tree.

    python3 -B scripts/packaging/amalgamate.py FOLDER     writes the files into a folder, without archives

hrbfnpr.cpp has three parts. The first has the headers and is read once. The second has the loops, the files that name
HWY_TARGET_INCLUDE: the file includes itself again for each instruction set, and then only this part is read. The third
has all other files and is read once.
"""
from __future__ import annotations

import posixpath
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Set, Tuple, Union

from common import HEADERS, ROOT, Release, notices, read, version, write_tar, write_zip

SOURCE = ROOT / "src"
TEMPLATES = Path(__file__).resolve().parent / "amalgamated"
INCLUDE = re.compile(r'^[ \t]*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
RULE = "// " + "=" * 117

# The folders of the third-party headers below a folder of includes, and what to install if they are missing.
THIRD_PARTY = {"Eigen": "libeigen3-dev", "glm": "libglm-dev", "hwy": "libhwy-dev", "nlohmann": "nlohmann-json3-dev"}
INCLUDE_FOLDERS = (Path("/usr/local/include"), Path("/usr/include/eigen3"), Path("/usr/include"))


def rooms() -> List[Path]:
    """Return the folders of the library's sources.  A folder comes after those that it needs."""
    text = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.findall(r"^hrbfnpr_room\((\w+)(?: FOLDER ([\w/]+))?", text, flags=re.MULTILINE)
    return [SOURCE / (folder or name) for name, folder in found]


def sources() -> List[Path]:
    """Return all .cpp files.  Those that include <windows.h> come last, because its macros would change other code."""
    found = [path for room in rooms() for path in sorted(room.glob("*.cpp"))]
    return sorted(found, key=lambda path: '#include "base/windows.h"' in path.read_text(encoding="utf-8"))


def is_windows(path: Path) -> bool:
    return path == SOURCE / "base" / "windows.h"


def name_of(path: Path) -> str:
    return path.relative_to(SOURCE).as_posix()


def is_loops(path: Path) -> bool:
    """Return whether Highway compiles this file once for each instruction set."""
    return "define HWY_TARGET_INCLUDE" in path.read_text(encoding="utf-8")


def is_repeated(path: Path) -> bool:
    """Return whether the loops include this header once for each instruction set."""
    return path.name.endswith("-inl.h") or "#pragma once" not in path.read_text(encoding="utf-8")


def lines_of(path: Path) -> Iterator[Tuple[int, str]]:
    """Yield the lines of a file, each with the number of conditions (#if) around it, except the toggle of a header."""
    depth = 0
    lines = path.read_text(encoding="utf-8").split("\n")
    toggled = any(line.startswith("#if defined(") and line.endswith("== defined(HWY_TARGET_TOGGLE)") for line in lines)
    for line in lines:
        word = re.match(r"\s*#\s*(if|endif)", line)
        if word and word.group(1) == "endif":
            depth -= 1
        yield (max(depth - 1, 0) if toggled else depth), line
        if word and word.group(1) == "if":
            depth += 1


@dataclass
class Parts:
    """The parts of hrbfnpr.cpp while files are added to them."""

    system: Set[str] = field(default_factory=set)  # names of headers of others that are included at the top
    headers: List[str] = field(default_factory=list)
    loops: List[str] = field(default_factory=list)
    rest: List[str] = field(default_factory=list)
    done: Set[Path] = field(default_factory=set)

    def add(self, path: Path) -> None:
        """Add a file to its part, and before it the headers that it includes, unless they are there already."""
        if path in self.done:
            return
        self.done.add(path)
        is_header = path.suffix == ".h"
        in_loops = is_loops(path) or is_repeated(path) and is_header
        text = list(self.kept_lines(path, in_loops))
        part = self.loops if in_loops else self.headers if is_header else self.rest
        while text and not text[0].strip():
            del text[0]
        part += [RULE, f"// src/{name_of(path)}", "", *text]

    def kept_lines(self, path: Path, in_loops: bool) -> Iterator[str]:
        """Yield the lines of a file without those that this file replaces.  Add the headers that it includes."""
        for depth, line in lines_of(path):
            include = INCLUDE.match(line)
            if include:
                yield from self.included(path, in_loops, depth, line, *include.groups())
            elif not re.match(r"// SPDX-License-Identifier|#pragma once|#(undef|define) HWY_TARGET_INCLUDE", line):
                yield line

    def included(self, path: Path, in_loops: bool, depth: int, line: str, ours: str, other: str) -> Iterator[str]:
        """Yield what replaces an #include line."""
        if "hrbfnpr.h" in (ours, other):
            return  # it is included at the top
        if ours:
            header = SOURCE / ours
            if depth == 0 and not is_windows(header):
                self.add(header)
            elif not (is_windows(header) or in_loops and is_repeated(header)):
                sys.exit(f"{path}: a header is included on a condition: {line}")
            elif header not in self.done:  # in its place, where the condition holds
                self.done.add(header)
                yield f"// src/{name_of(header)}"
                yield from self.kept_lines(header, in_loops)
        elif other == "hwy/foreach_target.h":
            yield from (TEMPLATES / "instruction_sets.h").read_text(encoding="utf-8").rstrip("\n").split("\n")[1:]
        elif depth > 0 or is_windows(path) or other.startswith("hwy/"):
            yield line
        else:
            self.system.add(other)


def is_third_party(name: str) -> bool:
    return name.split("/")[0] in THIRD_PARTY


def find_header(name: str) -> Optional[Path]:
    return next((folder / name for folder in INCLUDE_FOLDERS if (folder / name).is_file()), None)


def included_by(name: str, path: Path) -> List[str]:
    """Return the names of the third-party headers that a third-party header includes.  Some exist nowhere."""
    found = []
    for quoted, angled in INCLUDE.findall(path.read_text(encoding="utf-8", errors="replace")):
        beside = posixpath.normpath(posixpath.join(posixpath.dirname(name), quoted))
        found.append(beside if quoted and find_header(beside) else quoted or angled)
    return [other for other in found if is_third_party(other)]


def third_party_files(text: str) -> Dict[str, Path]:
    """Return the headers of other libraries that `text` includes on any platform, directly or not, by name."""
    found: Dict[str, Path] = {}
    first = [name for _, name in INCLUDE.findall(text) if is_third_party(name)]
    missing = [THIRD_PARTY[name.split("/")[0]] for name in first if find_header(name) is None]
    if missing:
        sys.exit(f"Headers are missing: apt-get install {' '.join(sorted(set(missing)))}")
    waiting = first
    while waiting:
        name = waiting.pop()
        path = find_header(name)
        if name not in found and path is not None:
            found[name] = path
            waiting += included_by(name, path)
    return dict(sorted(found.items()))


def source_text() -> str:
    """Return hrbfnpr.cpp."""
    parts = Parts()
    for path in sources():
        parts.add(path)
    third_party = sorted(name for name in parts.system if is_third_party(name))
    system = sorted(parts.system.difference(third_party))
    includes = [f"#include <{name}>" for name in third_party] + [""] + [f"#include <{name}>" for name in system]
    template = (TEMPLATES / "hrbfnpr.cpp.in").read_text(encoding="utf-8")
    values = {"VERSION": version(), "INCLUDES": "\n".join(includes), "HEADERS": "\n".join(parts.headers),
              "LOOPS": "\n".join(parts.loops), "REST": "\n".join(parts.rest)}
    return re.sub(r"@(\w+)@", lambda found: values[found.group(1)], template)


def abi() -> str:
    found = re.search(r"HRBFNPR_ABI_VERSION = (\d+)", (ROOT / "include" / "hrbfnpr.h").read_text(encoding="utf-8"))
    return found.group(1) if found else sys.exit("hrbfnpr.h has no HRBFNPR_ABI_VERSION")


def filled(path: Path) -> str:
    """Return the text of a template with the versions in it."""
    text = path.read_text(encoding="utf-8")
    return text.replace("@VERSION@", version()).replace("@HRBFNPR_ABI_VERSION@", abi())


def contents() -> Dict[str, Union[Path, str]]:
    """Return the files of the package, by name."""
    source = source_text()
    files: Dict[str, Union[Path, str]] = {
        "hrbfnpr.cpp": source,
        "hrbfnpr.h": ROOT / "include" / "hrbfnpr.h",
        "hrbfnpr.map": filled(SOURCE / "hrbfnpr.map.in"),
        "README.md": filled(TEMPLATES / "README.md.in"),
        "LICENSE": ROOT / "LICENSE",
        "THIRD-PARTY-NOTICES.md": notices(HEADERS),
    }
    files.update({f"third_party/{name}": path for name, path in third_party_files(source).items()})
    return files


def make(release: Release) -> List[Path]:
    """Write the archives into release.dist."""
    name = f"hrbfnpr-{release.version}-amalgamated"
    files = {f"{name}/{path}": source for path, source in contents().items()}
    return [write_tar(release.dist / f"{name}.tar.gz", files, release.epoch),
            write_zip(release.dist / f"{name}.zip", files, release.epoch)]


def write_folder(folder: Path) -> None:
    """Write the files of the package into a folder."""
    for name, source in contents().items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(read(source))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write_folder(Path(sys.argv[1]))
