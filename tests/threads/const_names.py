#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the names of all functions that take a const handle as a C++ list: const_names.py HEADER"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "abi"))

import const_functions  # noqa: E402
import header  # noqa: E402

NOTE = "// Made by tests/threads/const_names.py: functions that threads may call with one handle at the same time.\n"


def main():
    names = [function.name for function in const_functions.const_functions(header.description())]
    lines = "".join(f'    "{name}",\n' for name in names)
    Path(sys.argv[1]).write_text(f"{NOTE}inline constexpr const char* const_names[] = {{\n{lines}}};\n", "utf-8")


if __name__ == "__main__":
    main()
