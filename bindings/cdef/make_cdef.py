#!/usr/bin/env python3
"""Make the declarations of include/hrbfnpr.h for foreign-function interfaces that read C, such as LuaJIT's and koffi.

    make_cdef.py            write hrbfnpr_cdef.h, and the same as a Lua module, examples/love/hrbfnpr_cdef.lua
    make_cdef.py --check    fail if they are not what the header says

Run it after every change of the header.
"""
import re
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
HEADER = ROOT / "include" / "hrbfnpr.h"
WIDTH = 120
NOTE = "Made by bindings/cdef/make_cdef.py from include/hrbfnpr.h; do not edit."


def declarations(header: str) -> str:
    """The header without comments, preprocessor lines, `extern "C"` and export marks."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = re.sub(r"#if defined\(_WIN32\).*?#endif\n(?=\n#ifdef __cplusplus)", "", text, flags=re.DOTALL)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.DOTALL)
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)
    text = text.replace("HRBFNPR_API ", "")
    return "".join(map(folded, re.findall(r"[^;{]+(?:\{[^}]*\}[^;]*)?;", text)))


def folded(declaration: str) -> str:
    """One declaration, its lines filled and broken after a comma, a semicolon or a brace."""
    text = " ".join(declaration.split()).replace("( ", "(")
    text = re.sub(r"(?<![,;{]) ", "\0", text)
    lines = textwrap.wrap(text, WIDTH, subsequent_indent="    ", break_on_hyphens=False)
    return "\n".join(lines).replace("\0", " ") + "\n"


def generate(header: str) -> dict:
    """The text of each file."""
    text = declarations(header)
    return {
        HERE / "hrbfnpr_cdef.h": f"/* {NOTE} */\n{text}",
        ROOT / "examples" / "love" / "hrbfnpr_cdef.lua": f'-- {NOTE}\nrequire("ffi").cdef[[\n{text}]]\n',
    }


def main() -> int:
    stale = 0
    for path, text in generate(HEADER.read_text(encoding="utf-8")).items():
        if "--check" not in sys.argv[1:]:
            path.write_text(text, encoding="utf-8")
        elif not path.is_file() or path.read_text(encoding="utf-8") != text:
            print(f"{path.relative_to(ROOT)} is out of date: run {Path(__file__).name}", file=sys.stderr)
            stale = 1
    return stale


if __name__ == "__main__":
    sys.exit(main())
