#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The library's code outside the dispatched functions runs on every x86-64 processor.

    instructions.py OBJDUMP LIBRARY

Each function of the binary is disassembled. Instructions of AVX and later, whose names begin with v, may occur only in
the namespaces that Highway makes for them, such as N_AVX2. The library selects these at run time. If the linker kept a
copy of a shared inline function from such a file, the program would crash on an older processor.
"""
import re
import subprocess
import sys

FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")
VECTOR = re.compile(r"^\s*[0-9a-f]+:\s+(?:\{\w+\} )?v[a-z]+[0-9a-z]*\s")
EXEMPT = re.compile(r"^\s*[0-9a-f]+:\s+ver[rw]\s")
DISPATCHED = re.compile(r"::N_AVX\w*::|N_AVX\w*")


def main():
    objdump, library = sys.argv[1:]
    code = subprocess.run([objdump, "-d", "--no-show-raw-insn", "-C", library], check=True, capture_output=True,
                          text=True).stdout
    name, functions, dispatched, faults = "", 0, set(), {}
    for line in code.splitlines():
        begin = FUNCTION.match(line)
        if begin:
            name = begin.group(1)
            functions += 1
        elif VECTOR.match(line) and not EXEMPT.match(line):
            if DISPATCHED.search(name):
                dispatched.add(name)
            else:
                faults.setdefault(name, line.strip())
    for function, line in faults.items():
        print(f"{function}: {line}")
    print(f"{functions} functions, {len(dispatched)} dispatched ones with AVX, {len(faults)} others")
    return 1 if faults or not dispatched or functions < 1000 else 0


if __name__ == "__main__":
    sys.exit(main())
