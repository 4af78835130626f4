# SPDX-License-Identifier: MIT
"""Makes a copy of the sources whose tuning constants can be set at run time, for scripts/ablate.py.

Each use `x_tuning.member` becomes a read of a second, variable instance, and is noted. Uses that must be constants for the
compiler (sizes of arrays, constexpr) are not changed.
"""

import re
import shutil
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Set, Tuple

INSTANCE = re.compile(r"^inline constexpr (?P<type>\w+Tuning) (?P<name>\w+)(?:\{\})?;", re.M)
NAMESPACE = re.compile(r"^namespace (?P<name>[\w:]+) \{", re.M)
STRUCT = re.compile(r"^struct (?P<name>\w+) \{")
ALIAS = re.compile(r"^constexpr const \w+Tuning& (?P<name>\w+) = (?P<instance>(?:\w+::)*\w*tuning);$", re.M)
MEMBER = re.compile(
    r"^\s+(?P<type>double|float|int|std::u?int\w+_t|std::size_t) (?P<name>\w+) = (?P<value>[^;{}]+);"
)
USE = re.compile(r"(?<![\w:.])(?P<instance>(?:\w+::)*\w*tuning)\.(?P<member>\w+)\b(?!\()")

HEADER = """// Made by scripts/ablation_copy.py.
#pragma once
extern "C" void hrbfnpr_tuning_used(const void* member);
// The value of a constant. Notes the first read at this place in the sources.
#define HRBFNPR_TUNED(member)                                                                                              \\
    ([]() {                                                                                                                \\
        static bool noted = false;                                                                                         \\
        if (!noted) {                                                                                                      \\
            noted = true;                                                                                                  \\
            hrbfnpr_tuning_used(&(member));                                                                                \\
        }                                                                                                                  \\
        return member;                                                                                                     \\
    }())
"""

REGISTER = """// Made by scripts/ablation_copy.py. Sets constants by name, and tells which were read.
%(includes)s

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <string>

namespace {
struct Row {
    const char* name;
    void (*set)(double);
    double (*get)();
    const void* at;
};
const Row rows[] = {
%(rows)s
};
std::mutex& guard() {
    static auto* const made = new std::mutex;
    return *made;
}
std::set<const void*>& used() {
    static auto* const made = new std::set<const void*>;
    return *made;
}
} // namespace

extern "C" __attribute__((visibility("default"))) void hrbfnpr_tuning_used(const void* member) {
    const std::lock_guard lock(guard());
    used().insert(member);
}
// 1 if there is such a constant.
extern "C" __attribute__((visibility("default"))) int hrbfnpr_tune(const char* name, double value) {
    for (const Row& row : rows)
        if (std::strcmp(row.name, name) == 0) {
            row.set(value);
            return 1;
        }
    return 0;
}
// The names of the constants that were looked at since the last call, each with a newline.
extern "C" __attribute__((visibility("default"))) const char* hrbfnpr_tuned() {
    static std::string names;
    const std::lock_guard lock(guard());
    names.clear();
    for (const Row& row : rows)
        if (used().count(row.at) != 0) names += std::string(row.name) + "\\n";
    return names.c_str();
}

namespace {
void tell() {
    if (const char* file = std::getenv("HRBFNPR_TUNED"))
        if (std::FILE* to = std::fopen(file, "w")) {
            std::fputs(hrbfnpr_tuned(), to);
            std::fclose(to);
        }
}
// HRBFNPR_TUNE="name=value" sets one before anything else runs; HRBFNPR_TUNED names a file for the names of those used.
__attribute__((constructor(101))) void begin() {
    if (const char* asked = std::getenv("HRBFNPR_TUNE")) {
        const std::string text = asked;
        const auto sign = text.find('=');
        if (sign == std::string::npos || !hrbfnpr_tune(text.substr(0, sign).c_str(), std::atof(text.c_str() + sign + 1))) {
            std::fprintf(stderr, "HRBFNPR_TUNE: %%s\\n", asked);
            std::_Exit(3);
        }
    }
    if (std::getenv("HRBFNPR_TUNED")) std::atexit(tell);
}
} // namespace
"""


class Constant(NamedTuple):
    """A member of a tuning struct."""

    room: str
    instance: str
    member: str
    is_whole: bool
    text: str  # its value, written in C++
    qualified: str  # the variable in the copy

    @property
    def name(self) -> str:
        return f"{self.room}:{self.instance}.{self.member}"


def constants_of(source: Path, file: Path) -> Iterator[Constant]:
    """Yields the constants of a tuning header, in their order there."""
    text = file.read_text()
    room = str(file.parent.relative_to(source))
    space = NAMESPACE.search(text)
    instances = {found["type"]: found["name"] for found in INSTANCE.finditer(text)}
    struct = ""
    for line in text.splitlines():
        opened = STRUCT.match(line)
        struct = opened["name"] if opened else "" if line.startswith("};") else struct
        found = MEMBER.match(line)
        if found and space and struct in instances:
            is_whole = found["type"] not in ("double", "float")
            qualified = f"{space['name']}::moved_{instances[struct]}.{found['name']}"
            yield Constant(room, instances[struct], found["name"], is_whole, found["value"], qualified)


def tuning_files(source: Path) -> List[Path]:
    """Returns the headers with tuning constants."""
    return sorted(file for file in source.rglob("*.h") if INSTANCE.search(file.read_text()))


def is_fixed(line: str, at: int) -> bool:
    """Tells whether the use at this place of a line must be a constant for the compiler."""
    before = line[:at]
    if re.search(r"\b(constexpr|static_assert)\b", line) and "if constexpr" not in line:
        return True
    return bool(re.search(r"std::array<[^<>]*$", before) or re.search(r"^\s+\w+ \w+\[$", before))


def rewritten(text: str, known: Set[str]) -> Tuple[str, List[str]]:
    """Returns the text with uses of known constants replaced by reads, and the uses that stay."""
    for alias in ALIAS.finditer(text):
        text = text.replace(alias[0], "")
        text = re.sub(rf"(?<![\w:.]){alias['name']}\.(?=\w)", f"{alias['instance']}.", text)
    kept: List[str] = []
    lines: List[str] = []
    constant = False  # the line before began a constant and did not end it
    for line in text.split("\n"):
        code, comment, rest = line.partition("//")
        if line.startswith("#"):
            lines.append(line)
            continue

        def look(use: "re.Match[str]", stays: bool = constant, line: str = line) -> str:
            *spaces, instance = use["instance"].split("::")
            name = f"{instance}.{use['member']}"
            if name not in known:
                return use[0]
            if stays or is_fixed(line, use.start()):
                kept.append(name)
                return use[0]
            return f"HRBFNPR_TUNED({'::'.join([*spaces, 'moved_' + name])})"

        lines.append(USE.sub(look, code) + comment + rest)
        begins = "constexpr" in code and "if constexpr" not in code and not code.rstrip().endswith("{")
        constant = (constant or begins) and ";" not in code
    return "\n".join(lines), kept


def rewrite(source: Path) -> Tuple[List[Constant], Dict[str, List[str]]]:
    """Rewrites the copied sources. Returns all constants, and for each room the `instance.member`s with a use that stays."""
    constants: List[Constant] = []
    fixed: Dict[str, List[str]] = {}
    registers = tuning_files(source)
    for file in registers:
        constants += constants_of(source, file)
    known = {f"{c.instance}.{c.member}" for c in constants}
    for file in sorted([*source.rglob("*.cpp"), *source.rglob("*.h")]):
        text = before = file.read_text()
        text, kept = rewritten(text, known)
        if kept:
            fixed.setdefault(str(file.parent.relative_to(source)), []).extend(kept)
        if file in registers:
            text = INSTANCE.sub(lambda found: found[0] + f"\ninline {found['type']} moved_{found['name']};", text)
            text = text.replace("#pragma once\n", '#pragma once\n#include "ablation.h"\n', 1)
        if text != before:
            file.write_text(text)
    (source / "ablation.h").write_text(HEADER)
    includes = "\n".join(f'#include "{file.relative_to(source)}"' for file in registers)
    rows = "\n".join(
        f'    {{"{c.name}", [](double v) {{ {c.qualified} = static_cast<decltype({c.qualified})>(v); }},'
        f" []() {{ return static_cast<double>({c.qualified}); }}, &{c.qualified}}},"
        for c in constants
        if not c.text.startswith("static")
    )
    (source / "picture" / "ablation.cpp").write_text(REGISTER % {"includes": includes, "rows": rows})
    return constants, fixed


def copy(root: Path, to: Path) -> None:
    """Copies what a build of the library and the benchmarks needs. Unchanged files keep their times."""
    for folder in ("src", "include", "bench", "tests", "cmake", "bindings"):
        shutil.rmtree(to / folder, ignore_errors=True)
        shutil.copytree(root / folder, to / folder, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("CMakeLists.txt", "CMakePresets.json"):
        shutil.copy(root / name, to / name)
