# SPDX-License-Identifier: MIT
"""The declarations of api.json for foreign-function interfaces that read C, such as LuaJIT's and koffi; and the same as
a Lua module.  bindings/generate runs it.
"""
import re
import textwrap
from pathlib import Path

from outputs import ROOT, declaration, declarations, signature

HERE = Path(__file__).resolve().parent
WIDTH = 120
LICENCE = "SPDX-License-Identifier: MIT"
NOTE = "Made by bindings/cdef/make_cdef.py from include/hrbfnpr.h; do not edit."


def text_of(kind, entry):
    """One declaration in C."""
    name = entry.get("name")
    if kind == "enum":
        constants = ", ".join(f"{constant['name']} = {constant['value']}" for constant in entry["constants"])
        return f"enum {{ {constants} }};"
    if kind == "struct":
        fields = " ".join(f"{declaration(field)};" for field in entry["fields"])
        return f"typedef struct {name} {{ {fields} }} {name};"
    if kind == "handle":
        return f"typedef struct {name} {name};"
    if kind == "typedef":
        return f"typedef {entry['type']['c']} {name};"
    if kind == "callback":
        return f"typedef {signature(entry, f'(*{name})')};"
    return f"{signature(entry)};"


def folded(text):
    """One declaration, its lines filled and broken after a comma, a semicolon or a brace."""
    text = re.sub(r"(?<![,;{]) ", "\0", text)
    lines = textwrap.wrap(text, WIDTH, subsequent_indent="    ", break_on_hyphens=False)
    return "\n".join(lines).replace("\0", " ") + "\n"


def c_text(api):
    """All declarations in the header's order; a short one goes on in the line before, where it fits."""
    lines = []
    for kind, entry in declarations(api):
        first, *more = folded(text_of(kind, entry)).rstrip("\n").split("\n")
        if lines and not more and len(lines[-1]) + 1 + len(first) <= WIDTH:
            lines[-1] += " " + first
        else:
            lines += [first, *more]
    return "".join(line + "\n" for line in lines)


def outputs(api):
    """The text of each file."""
    text = c_text(api)
    return {
        HERE / "hrbfnpr_cdef.h": f"/* {LICENCE} */\n/* {NOTE} */\n{text}",
        ROOT / "examples" / "love" / "hrbfnpr_cdef.lua": f'-- {LICENCE}\n-- {NOTE}\nrequire("ffi").cdef[[\n{text}]]\n',
    }
