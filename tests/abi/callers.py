#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Programs built with older, current and future headers get the same results from the library.

    callers.py LIBRARY CC...

caller.c is built with each header of headers/, with the current header, and with a header of the future, in which every
struct with a struct_size is longer. Each compiler that is installed builds it. The program with the future header also
sets a field that this library does not know, which the library refuses.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = HERE.parents[1] / "include/hrbfnpr.h"
FLAGS = {"tcc": ["-Wall", "-Werror"]}
STRICT = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror"]


def of_the_future(text):
    """A header in which every descriptor and result has grown."""
    pattern = re.compile(r"(typedef struct (hrbfnpr_\w+) \{\n    uint32_t struct_size;.*?)(\n\} \2;)", re.DOTALL)
    longer, count = pattern.subn(r"\1\n    int64_t of_the_future[2];\3", text)
    assert count > 30, count
    return longer


def run(compiler, name, header, library, folder):
    """Builds and runs the caller; returns its output."""
    include = folder / f"{Path(compiler).name}-{name}"
    include.mkdir()
    (include / "hrbfnpr.h").write_text(header, encoding="utf-8")
    program = include / "caller"
    options = FLAGS.get(Path(compiler).name, STRICT) + (["-DCALLER_TAIL"] if name == "future" else [])
    subprocess.run([compiler, *options, f"-I{include}", str(HERE / "caller.c"), "-o", str(program), str(library),
                    f"-Wl,-rpath,{library.parent}"], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{compiler}, header {name}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    library = Path(sys.argv[1]).resolve()
    compilers = [compiler for compiler in sys.argv[2:] if shutil.which(compiler)]
    headers = {path.stem: path.read_text(encoding="utf-8") for path in sorted((HERE / "headers").glob("*.header"))}
    assert headers, "no header was kept"
    headers["today"] = HEADER.read_text(encoding="utf-8")
    headers["future"] = of_the_future(headers["today"])
    with tempfile.TemporaryDirectory() as folder:
        said = {(compiler, name): run(compiler, name, header, library, Path(folder))
                for compiler in compilers for name, header in headers.items()}
    first = next(iter(said.values()))
    for caller, text in said.items():
        if text != first:
            sys.exit(f"{caller} got something else:\n{text}than the first:\n{first}")
    left_out = sorted(set(sys.argv[2:]) - set(compilers))
    print(f"{len(said)} programs: {len(headers)} headers by {', '.join(compilers)}; the same results"
          + (f" (not here: {', '.join(left_out)})" if left_out else ""))


if __name__ == "__main__":
    main()
