# SPDX-License-Identifier: MIT
"""Write the declarations of api.json for foreign-function interfaces that read C, such as LuaJIT and koffi, and the same
as a Lua module.  bindings/generate runs it.
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
    """Return one declaration in C."""
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


def folded(text, before=""):
    """Return one declaration after the text `before`, as lines that end after a comma, a semicolon or a brace."""
    text = re.sub(r"(?<![,;{]) ", "\0", text)
    lines = textwrap.wrap(text, WIDTH, initial_indent=before, subsequent_indent="    ", break_on_hyphens=False,
                          break_long_words=False)
    return [line.replace("\0", " ") for line in lines]


def c_text(api):
    """Return all declarations in the order of the header.  One starts in the line of the last if that saves a line."""
    lines = []
    for kind, entry in declarations(api):
        text = text_of(kind, entry)
        alone = folded(text)
        joined = folded(text, lines[-1] + " ") if lines else alone
        if lines and len(joined) <= len(alone) and len(joined[0]) <= WIDTH:
            lines[-1:] = joined
        else:
            lines += alone
    return "".join(line + "\n" for line in lines)


def outputs(api):
    """Return the text of each file."""
    text = c_text(api)
    return {
        HERE / "hrbfnpr_cdef.h": f"/* {LICENCE} */\n/* {NOTE} */\n{text}",
        ROOT / "examples" / "love" / "hrbfnpr_cdef.lua": f'-- {LICENCE}\n-- {NOTE}\nrequire("ffi").cdef[[\n{text}]]\n',
    }
