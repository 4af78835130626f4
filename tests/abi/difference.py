#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The current header is compatible with the kept older headers, according to libabigail.

    difference.py CC ABIDW ABIDIFF

A shared library of empty functions with debug information is built from each header of headers/ and from the current
one, and libabigail compares them. exports.py checks that the real library exports the same functions. Changes that
callers cannot see are allowed: new functions, constants at the end of an enum, members at the end of a struct, and a
name for a reserved member.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = HERE.parents[1] / "include/hrbfnpr.h"
FUNCTION = re.compile(r"^HRBFNPR_API ([^;]*);", re.MULTILINE)
APPENDED = """
[suppress_type]
  type_kind = struct
  has_data_member_inserted_at = end
[suppress_type]
  type_kind = struct
  has_size_change = yes
  has_data_member_inserted_at = end
[suppress_type]
  type_kind = enum
  changed_enumerators_regexp = .*_COUNT$
"""


def definitions(header):
    """Every function that the header declares, with an empty body."""
    without_comments = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    found = FUNCTION.findall(without_comments)
    assert len(found) > 60, len(found)
    return "\n".join(f"{one} {{ {'' if one.startswith('void ') else 'return 0;'} }}" for one in found)


def describe(compiler, abidw, header, folder):
    """The interface of a header as abidw writes it."""
    folder.mkdir()
    (folder / "hrbfnpr.h").write_text(header, encoding="utf-8")
    (folder / "stub.c").write_text('#include "hrbfnpr.h"\n' + definitions(header), encoding="utf-8")
    subprocess.run([compiler, "-std=c11", "-g", "-fPIC", "-shared", "-w", "stub.c", "-o", "libhrbfnpr.so"],
                   cwd=folder, check=True)
    subprocess.run([abidw, "--headers-dir", str(folder), "--drop-private-types", "libhrbfnpr.so", "--out-file",
                    "boundary.abi"], cwd=folder, check=True)
    return folder / "boundary.abi"


def main():
    compiler, abidw, abidiff = sys.argv[1:]
    faults = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "appended").write_text(APPENDED, encoding="utf-8")
        today = describe(compiler, abidw, HEADER.read_text(encoding="utf-8"), folder / "today")
        kept = sorted((HERE / "headers").glob("*.header"))
        for path in kept:
            before = describe(compiler, abidw, path.read_text(encoding="utf-8"), folder / path.stem)
            done = subprocess.run([abidiff, "--suppressions", str(folder / "appended"), "--no-added-syms", str(before),
                                   str(today)], capture_output=True, text=True)
            print(f"{path.stem}: abidiff says {done.returncode}")
            if done.returncode:
                faults += 1
                print(done.stdout + done.stderr)
    return 1 if faults or not kept else 0


if __name__ == "__main__":
    sys.exit(main())
