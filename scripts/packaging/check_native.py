#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check a shared library for Linux, Windows or macOS: exports, other libraries that it needs, and the least glibc.

    check_native.py LIBRARY [--glibc 2.17]     reads ELF, PE and Mach-O files by LLVM's tools

It must export exactly the functions of include/hrbfnpr.h, and need nothing that a bare system lacks: the library is loaded
into programs with other C++ runtimes.
"""
from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Set, Tuple

API = Path(__file__).resolve().parents[2] / "bindings" / "api.json"

# The libraries of a bare system.
SYSTEM = re.compile(r"lib(c|m|pthread|dl|rt)\.so\.\d+|ld-linux[-\w]*\.so\.\d+|(KERNEL32|msvcrt|api-ms-win-crt-\w+-l1-1-0|"
                    r"ucrtbase|ADVAPI32)\.dll|/usr/lib/libSystem\.B\.dylib", re.IGNORECASE)


class Facts(NamedTuple):
    exports: Set[str]
    needs: Set[str]
    glibc: Tuple[int, ...]  # the newest version of glibc's symbols; empty elsewhere


def tool(name: str, *arguments: str) -> str:
    """Run one of LLVM's tools, which Debian installs with a version in the name."""
    for program in (name, *(f"{name}-{version}" for version in range(19, 13, -1))):
        try:
            return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout
        except FileNotFoundError:
            continue
    sys.exit(f"{name} is missing; install LLVM (Debian: llvm-14)")


def elf(path: str) -> Facts:
    dynamic = tool("llvm-objdump", "-p", path)
    symbols = tool("llvm-nm", "-D", "--defined-only", "--extern-only", path)
    exports = {line.split()[-1].split("@")[0] for line in symbols.splitlines() if line.split()[-2] != "A"}
    versions = re.findall(r"\bGLIBC_(\d+(?:\.\d+)*)", dynamic)
    newest = max((tuple(map(int, version.split("."))) for version in versions), default=())
    return Facts(exports, set(re.findall(r"NEEDED\s+(\S+)", dynamic)), newest)


def pe(path: str) -> Facts:
    text = tool("llvm-readobj", "--coff-exports", "--coff-imports", path)
    exports = set(re.findall(r"Export \{\s+Ordinal: \d+\s+Name: (\S+)", text))
    return Facts(exports, set(re.findall(r"Import \{\s+Name: (\S+)", text)), ())


def mach_o(path: str) -> Facts:
    symbols = tool("llvm-nm", "--defined-only", "--extern-only", path)
    exports = {line.split()[-1][1:] for line in symbols.splitlines() if line.strip()}
    needs = set(re.findall(r"cmd LC_LOAD_DYLIB.*?name (\S+)", tool("llvm-objdump", "-p", path), re.DOTALL))
    return Facts(exports, needs, ())


READERS: Dict[bytes, Callable[[str], Facts]] = {b"\x7fELF": elf, b"MZ": pe, b"\xcf\xfa\xed\xfe": mach_o}


def facts(path: Path) -> Facts:
    start = path.read_bytes()[:4]
    for magic, reader in READERS.items():
        if start.startswith(magic):
            return reader(str(path))
    sys.exit(f"{path} is no ELF, PE or Mach-O file")


def faults(found: Facts, functions: Set[str], glibc: Tuple[int, ...]) -> List[str]:
    """Return one line for each fault of a library."""
    lines = [f"exported, but not in the header: {name}" for name in sorted(found.exports - functions)]
    lines += [f"in the header, but not exported: {name}" for name in sorted(functions - found.exports)]
    lines += [f"needs {name}, which a bare system lacks" for name in sorted(found.needs) if not SYSTEM.fullmatch(name)]
    if glibc and found.glibc > glibc:
        lines.append(f"needs glibc {'.'.join(map(str, found.glibc))}, newer than {'.'.join(map(str, glibc))}")
    return lines


def check(path: Path, glibc: str = "") -> None:
    """End the program with the library's faults, if it has any."""
    functions = {function["name"] for function in json.loads(API.read_text(encoding="utf-8"))["functions"]}
    wrong = faults(facts(path), functions, tuple(map(int, glibc.split("."))) if glibc else ())
    if wrong:
        sys.exit("\n".join([f"{path}:", *wrong]))
    print(f"{path.name}: {len(functions)} functions, no fault")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("library", type=Path)
    parser.add_argument("--glibc", default="", help="the newest version of glibc that it may need, such as 2.17")
    arguments = parser.parse_args()
    check(arguments.library, arguments.glibc)


if __name__ == "__main__":
    main()
