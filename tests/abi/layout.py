#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares bindings/api.json with a C compiler: constants, signatures, types of fields, sizes, offsets and alignments.

    layout.py CC [API]     for each data model of api.json that CC can compile for; API replaces bindings/api.json

The checks are assertions in a C file that includes the header. Nothing is run, so no 32-bit library is needed.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import header

# Options that select a data model. The compiler's own headers are enough; no C library is needed.
FLAGS = {
    "lp64": [[], ["-m64"]],
    "ilp32": [[], ["-m32", "-malign-double"], ["--target=armv7a-none-eabi"]],
    "i386": [[], ["-m32"], ["--target=i386-linux-gnu"]],
}


def probe(model):
    """C code that compiles only under this data model."""
    return f"""struct probe {{ char first; double second; }};
        _Static_assert(sizeof(void*) == {model['pointer']}, "pointers");
        _Static_assert(__builtin_offsetof(struct probe, second) == {model['alignment_of_8']}, "doubles");
        """


def abstract(field):
    """The type of a field without its name, and the type of a pointer to it."""
    shape = "".join(f"[{size}]" for size in field["array"])
    kind = field["type"]["c"]
    if field["type"]["kind"] == "function":
        return kind.replace("(*)", f"(*{shape})", 1), kind.replace("(*)", f"(*(*){shape})" if shape else "(**)", 1)
    return kind + shape, f"{kind} (*){shape}" if shape else f"{kind}*"


def assertions(api, model):
    """The lines of a C file with the assertions."""
    yield from ("#include <hrbfnpr.h>", "#include <stddef.h>")

    def check(what, value):
        return f'_Static_assert({what} == {value}, "{what} is {value} in api.json");'

    for group in api["constants"]:
        for constant in group["constants"]:
            yield check(constant["name"], constant["value"])
    for kind in ("typedefs", "callbacks", "functions"):  # C refuses a second declaration that differs
        for entry in api[kind]:
            yield {
                "typedefs": lambda: f"typedef {entry['type']['c']} {entry['name']};",
                "callbacks": lambda: f"typedef {header.signature(entry, '(*' + entry['name'] + ')')};",
                "functions": lambda: f"{header.signature(entry)};",
            }[kind]()
    for handle in api["handles"]:
        yield f"typedef struct {handle['name']} {handle['name']};"
    for struct in api["structs"]:
        name, whole = struct["name"], struct["layout"][model]
        yield check(f"sizeof({name})", whole["size"])
        yield check(f"_Alignof({name})", whole["align"])
        last = 0
        for field in struct["fields"]:
            layout, (kind, pointer) = field["layout"][model], abstract(field)
            place = f"(({name}*)0)->{field['name']}"
            yield check(f"offsetof({name}, {field['name']})", layout["offset"])
            yield check(f"sizeof({place})", layout["size"])
            yield check(f"_Alignof({kind})", layout["align"])
            yield check(f"_Generic(&{place}, {pointer}: 1, default: 0)", 1)
            last = layout["offset"] + layout["size"]
        if whole["size"] - last >= whole["align"]:  # api.json lacks a field
            raise SystemExit(f"{name} ends before its size")


def compiles(compiler, flags, text):
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "layout.c"
        source.write_text(text)
        command = [compiler, "-std=c11", *flags, "-ffreestanding", "-fsyntax-only", f"-I{header.HEADER.parent}"]
        result = subprocess.run([*command, str(source)], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return result.returncode == 0, re.sub(re.escape(folder) + "/", "", result.stdout)


def main():
    compiler = sys.argv[1]
    api = header.description(*map(Path, sys.argv[2:3]))
    checked, failed = 0, 0
    for model, rules in api["models"].items():
        flags = next((flags for flags in FLAGS[model] if compiles(compiler, flags, probe(rules))[0]), None)
        if flags is None:
            print(f"{model}: skipped, {compiler} does not compile for {rules['where']}")
            continue
        lines = list(assertions(api, model))
        fine, said = compiles(compiler, flags, "\n".join(lines) + "\n")
        print(said + f"{model}: {len(lines) - 2} facts, {'all as' if fine else 'NOT as'} "
              f"{' '.join([Path(compiler).name, *flags])} has them")
        checked += 1
        failed += not fine
    if not checked:
        print("no data model could be checked")
    return 1 if failed or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
