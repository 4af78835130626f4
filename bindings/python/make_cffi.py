#!/usr/bin/env python3
"""Make hrbfnpr/_cffi.py, the declarations of the C boundary, from include/hrbfnpr.h.

    make_cffi.py            write it
    make_cffi.py --check    fail if it is not what the header says

Run it after every change of the header.  The result is committed, so that installing the package
needs neither the header nor a C parser.
"""
import contextlib
import io
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = HERE.parents[1] / "include" / "hrbfnpr.h"
MODULE = HERE / "hrbfnpr" / "_cffi.py"
sys.path.insert(0, str(HERE.parent / "cdef"))

from make_cdef import declarations  # noqa: E402


def generate(header: str) -> str:
    """The text of the module."""
    from cffi import FFI

    builder = FFI()
    builder.set_source("hrbfnpr._cffi", None)
    builder.cdef(declarations(header))
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "_cffi.py"
        with contextlib.redirect_stdout(io.StringIO()):  # cffi announces what it writes
            builder.emit_python_code(str(target))
        text = target.read_text(encoding="utf-8")
    return text.replace("# auto-generated file", "# Made by make_cffi.py from include/hrbfnpr.h; do not edit.", 1)


def main() -> int:
    text = generate(HEADER.read_text(encoding="utf-8"))
    if "--check" in sys.argv[1:]:
        if MODULE.read_text(encoding="utf-8") != text:
            print(f"{MODULE.name} is out of date: run {Path(__file__).name}", file=sys.stderr)
            return 1
        return 0
    MODULE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
