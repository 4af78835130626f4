#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares the interface with its snapshot: every signature, type, constant, sizeof and offsetof.

    snapshot.py CC            compare with snapshot.txt
    snapshot.py CC --update   append new lines

Lines may only be added: a changed or missing line breaks existing programs. Two kinds of lines may change. The size of a
struct may grow, because fields are added at its end and old sizes stay readable by struct_size. A count (..._COUNT) may
grow.
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Dict, List

import header

SNAPSHOT = Path(__file__).with_name("snapshot.txt")


def measure(compiler: str, declared: header.Declarations) -> List[str]:
    """Constants and layouts, measured by a compiled program in the 64-bit data model."""
    lines = ['#include <hrbfnpr.h>', '#include <stddef.h>', '#include <stdio.h>', 'int main(void) {']
    for name in declared.constants:
        lines.append(f'printf("constant {name} = %ld\\n", (long){name});')
    for name, fields in declared.structs.items():
        lines.append(f'printf("sizeof {name} = %zu\\n", sizeof({name}));')
        for field in fields:
            lines.append(f'printf("offsetof {name}.{field} = %zu\\n", offsetof({name}, {field}));')
    lines.append("return 0; }")
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder) / "layout.c", Path(folder) / "layout"
        source.write_text("\n".join(lines))
        subprocess.run([compiler, f"-I{header.HEADER.parent}", str(source), "-o", str(program)], check=True)
        return subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout.splitlines()


def current(compiler: str) -> List[str]:
    declared = header.read()
    signatures = [f"function {name} : {signature}" for name, signature in declared.functions.items()]
    types = [f"type {name} : {declaration}" for name, declaration in declared.types.items()]
    return signatures + types + measure(compiler, declared)


def keyed(lines: List[str]) -> Dict[str, str]:
    return dict(line.split(" = " if " = " in line else " : ", 1) for line in lines)


def may_grow(key: str) -> bool:
    return key.startswith("sizeof ") or (key.startswith("constant ") and key.endswith("_COUNT"))


def got_a_name(key: str, old: Dict[str, str], new: Dict[str, str]) -> bool:
    """True if the key is a reserved field that the new header replaces by a field of the same type."""
    record, _, field = key.partition(".")
    if not field.startswith("reserved"):
        return False
    name = record.split(" ", 1)[1]
    place = old[f"offsetof {name}.{field}"]
    kind = old[f"type {name}.{field}"].split(" ")[0]
    return any(fact.startswith(f"offsetof {name}.") and where == place and
               new[fact.replace("offsetof", "type", 1)].split(" ")[0] == kind for fact, where in new.items())


def compare(old: Dict[str, str], new: Dict[str, str]) -> List[str]:
    faults = []
    for key, value in old.items():
        if key not in new and got_a_name(key, old, new):
            continue
        if key not in new:
            faults.append(f"gone: {key}")
        elif new[key] != value and not (may_grow(key) and int(new[key]) > int(value)):
            faults.append(f"changed: {key}: {value} -> {new[key]}")
    return faults


def main() -> int:
    lines = current(sys.argv[1])
    old_lines = SNAPSHOT.read_text().splitlines() if SNAPSHOT.exists() else []
    old, new = keyed(old_lines), keyed(lines)
    faults = compare(old, new)
    if not faults and "--update" in sys.argv:
        SNAPSHOT.write_text("\n".join(lines) + "\n")
        return 0
    missing = [f"not in the snapshot (run snapshot.py CC --update): {key}" for key in new if new[key] != old.get(key)]
    for line in faults + ([] if faults else missing):
        print(line)
    print(f"{len(new)} facts of the boundary, {len(faults)} broken")
    return 1 if faults or missing else 0


if __name__ == "__main__":
    sys.exit(main())
