# SPDX-License-Identifier: MIT
"""Pages in reStructuredText for every symbol of the C interface, from bindings/api.json, one for each section of the header."""

import json
import re

LINKED = r"\b(hrbfnpr_\w+|HRBFNPR_[A-Z0-9_]+)\b(?!\.\.\.|_)"
ROLES = {"function": "func", "struct": "struct", "callback": "type", "handle": "type", "typedef": "type", "constant": "enumerator"}


class Names:
    """The symbols of the C interface, with the kind of each."""

    def __init__(self, api):
        self.kinds = {one["name"]: "function" for one in api["functions"]}
        self.kinds.update({one["name"]: "struct" for one in api["structs"]})
        self.kinds.update({one["name"]: "callback" for one in api["callbacks"]})
        self.kinds.update({one["name"]: "handle" for one in api["handles"]})
        self.kinds.update({one["name"]: "typedef" for one in api["typedefs"]})
        self.kinds.update({one["name"]: "constant" for group in api["constants"] for one in group["constants"]})

    def linked(self, text):
        """Plain text as reStructuredText, with links to the symbols that it names."""
        parts = re.split(r"(`[^`]+`)|" + LINKED, text)
        made = ""
        for code, name, plain in zip(parts[1::3] + [None], parts[2::3] + [None], parts[0::3]):
            made += re.sub(r"([\\*`|_])", r"\\\1", plain)
            if name in self.kinds:
                made += f":c:{ROLES[self.kinds[name]]}:`{name}`\\ "
            elif name or code:
                made += f"``{(name or code).strip('`')}``\\ "
        return made.strip()


def paragraphs(text):
    """The blocks of a comment, each with whether it is prose.  Formulas and tables are not: they are indented or have columns."""
    text = re.sub(r"^-{8,}$", "", text, flags=re.MULTILINE)
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        lines = block.splitlines()
        if not any(line.strip() for line in lines):
            continue
        columns = sum(bool(re.search(r"\S   +\S", line)) for line in lines)
        yield lines, not (columns > 1 or all(line.startswith("   ") for line in lines))


def prose(names, text, indent=""):
    for lines, plain in paragraphs(text):
        if plain:
            words = names.linked(" ".join(line.strip() for line in lines))
            words = re.sub(r"^([-+]|\d+[.)]|\w[.)]) ", r"\\\1 ", words)
            yield f"{indent}{words}\n\n"
        else:
            yield f"{indent}::\n\n" + "".join(f"{indent}   {line.rstrip()}\n" for line in lines) + "\n"


def declared(kind, name):
    """A C declaration: the name after its type, or inside the parentheses of a pointer to a function."""
    return kind.replace("(*)", f"(*{name})", 1) if "(*)" in kind else f"{kind} {name}"


def parameters(one):
    return ", ".join(declared(p["type"]["c"], p["name"]) for p in one["parameters"]) or "void"


def enum(names, group):
    yield f".. rubric:: ``{group['prefix']}_...``\n\n"
    yield from prose(names, group["doc"])
    for one in group["constants"]:
        yield f".. c:enumerator:: {one['name']} = {one['value']}\n\n"
        yield from prose(names, one["doc"], "   ")


def struct(names, one):
    yield f".. c:struct:: {one['name']}\n\n"
    yield from prose(names, one["doc"], "   ")
    for field in one["fields"]:
        size = "".join(f"[{n}]" for n in field["array"])
        yield f"   .. c:member:: {declared(field['type']['c'], field['name'] + size)}\n\n"
        yield from prose(names, field["doc"], "      ")


def callback(names, one):
    yield f".. c:type:: {one['returns']['c']} (*{one['name']})({parameters(one)})\n\n"
    yield from prose(names, one["doc"], "   ")


def function(names, one):
    yield f".. c:function:: {one['returns']['c']} {one['name']}({parameters(one)})\n\n"
    yield from prose(names, one["doc"], "   ")


def handle(names, one):
    yield f".. c:type:: struct {one['name']} {one['name']}\n\n   A handle: an opaque pointer to an object of the library.\n\n"
    yield from prose(names, one["doc"], "   ")


def typedef(names, one):
    yield f".. c:type:: {one['type']['c']} {one['name']}\n\n"
    yield from prose(names, one["doc"], "   ")


WRITERS = {"enum": enum, "struct": struct, "callback": callback, "function": function, "handle": handle, "typedef": typedef}


def heading(section):
    """The title of a section in lower case, and the text after its colon."""
    title, _, rest = re.sub(r"\s*\[NPAR[^]]*\]", "", section["title"]).partition(":")
    short = re.match(r"[A-Z]+(?: [A-Z]+)*", title).group(0)
    return short.capitalize(), (title[len(short) :] + (": " + rest if rest else "")).strip(": ")


def pages(path):
    """The name and the text of each page."""
    api = json.loads(path.read_text(encoding="utf-8"))
    names = Names(api)
    of_kind = {
        "enum": {one["prefix"]: one for one in api["constants"]}, "struct": {one["name"]: one for one in api["structs"]},
        "callback": {one["name"]: one for one in api["callbacks"]}, "function": {one["name"]: one for one in api["functions"]},
        "handle": {one["name"]: one for one in api["handles"]}, "typedef": {one["name"]: one for one in api["typedefs"]},
    }  # fmt: skip
    entries = []
    for section in api["sections"]:
        title, more = heading(section)
        name = re.sub(r"\W+", "-", title.lower())
        text = f"{title}\n{'=' * len(title)}\n\n" + (f"{names.linked(more[:1].upper() + more[1:])}.\n\n" if more else "")
        text += "".join(prose(names, section.get("text", "")))
        for kind, symbol in api["order"]:
            one = of_kind[kind][symbol]
            if one["section"] == section["number"]:
                text += "".join(WRITERS[kind](names, one))
        entries.append(name)
        yield name, text
    intro = f"""The C interface
===============

``hrbfnpr.h``, version {api['version']}, ABI version {api['abi_version']}, for C99, C++11 and later.  The first page holds the contracts of all
functions.  Each other page is a section of the header.

.. toctree::
   :maxdepth: 1

"""
    yield "index", intro + "".join(f"   {entry}\n" for entry in entries)
