#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The shared library exports exactly the header's functions under its SONAME, has no state, and runs nothing on load.

    exports.py NM READELF LIBRARY SONAME

No state means: no thread-local variables, and no writable variables except those listed below. A host may keep the
library loaded while it tears everything else down and sets it up again, so no state may remain in the library.
"""

import re
import subprocess
import sys
from typing import List

import header

# Demangled name -> the reason why it is allowed.
ALLOWED = {
    "hrbfnpr::base::(anonymous namespace)::team_is_ours()::team_process":
        "tells a forked child that OpenMP's threads are its parent's",
}
# Variables of the compiler and the linker in every shared library, and Eigen's cache sizes, which are set once.
RUNTIME = re.compile(r"^(completed\.0|__dso_handle|__TMC_END__|DW\.ref\..*|std::__ioinit"
                     r"|(guard variable for )?Eigen::internal::manage_caching_sizes\(.*\)::.*)$")
WRITABLE = (".data", ".bss", ".tdata", ".tbss")  # .data.rel.ro is read-only after relocation


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def check_exports(nm: str, library: str) -> List[str]:
    exported = {line.split()[2].split("@")[0] for line in output(nm, "-D", "--defined-only", library).splitlines()
                if line.split()[1] != "A"}
    declared = set(header.read().functions)
    return ([f"exported, but not in the header: {name}" for name in sorted(exported - declared)] +
            [f"in the header, but not exported: {name}" for name in sorted(declared - exported)])


def check_soname(readelf: str, library: str, soname: str) -> List[str]:
    found = re.search(r"\(SONAME\).*\[(.*)\]", output(readelf, "-d", library))
    if found and found.group(1) == soname:
        return []
    return [f"SONAME is {found.group(1) if found else 'missing'}, not {soname}"]


def check_state(nm: str, readelf: str, library: str) -> List[str]:
    faults = []
    for line in output(nm, "-C", "-f", "sysv", library).splitlines():
        columns = [column.strip() for column in line.split("|")]
        if len(columns) < 7 or columns[-1] not in WRITABLE:
            continue
        name = columns[0]
        if name not in ALLOWED and not RUNTIME.match(name):
            faults.append(f"writable state: {name} in {columns[-1]}")
    if re.search(r"^\s*TLS\s", output(readelf, "-lW", library), flags=re.MULTILINE):
        faults.append("the library has thread-local variables")
    return faults


def check_life(nm: str, readelf: str, library: str) -> List[str]:
    """The library runs no code of ours when it is loaded or unloaded."""
    faults = []
    if re.search(r"\bU __cxa_(thread_)?atexit\b", output(nm, "-D", library)):
        faults.append("a static object has a destructor")
    for section in (".init_array", ".fini_array"):  # one entry belongs to the compiler
        found = re.search(rf"\s{re.escape(section)}\s+\w+\s+\w+\s+\w+\s+(\w+)\s", output(readelf, "-SW", library))
        if found and int(found.group(1), 16) > 8:
            faults.append(f"{section} has {int(found.group(1), 16) // 8} entries instead of 1")
    return faults


def main() -> int:
    nm, readelf, library, soname = sys.argv[1:]
    faults = (check_exports(nm, library) + check_soname(readelf, library, soname) +
              check_state(nm, readelf, library) + check_life(nm, readelf, library))
    for fault in faults:
        print(fault)
    print(f"{len(header.read().functions)} functions in the header, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
