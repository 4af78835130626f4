# SPDX-License-Identifier: MIT
"""Makes hrbfnpr/_cffi.py, the declarations of the C interface, from api.json.  bindings/generate runs this module.

The result is committed, so that installing the package needs neither api.json nor a C parser.
"""
import contextlib
import io
import tempfile
from pathlib import Path

from make_cdef import c_text

HERE = Path(__file__).resolve().parent
MODULE = HERE / "hrbfnpr" / "_cffi.py"


def outputs(api):
    """The text of each file, by path."""
    from cffi import FFI

    builder = FFI()
    builder.set_source("hrbfnpr._cffi", None)
    builder.cdef(c_text(api))
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "_cffi.py"
        with contextlib.redirect_stdout(io.StringIO()):  # cffi prints the names of the files that it writes
            builder.emit_python_code(str(target))
        text = target.read_text(encoding="utf-8")
    note = "# SPDX-License-Identifier: MIT\n# Made by make_cffi.py from include/hrbfnpr.h; do not edit."
    return {MODULE: text.replace("# auto-generated file", note, 1)}
