# SPDX-License-Identifier: MIT
"""The guide contains every public symbol, on the pages that docs/guide generates.

    symbols.py c ROOT         all of bindings/api.json: functions, structs and their fields, constants, callbacks, handles
    symbols.py csharp ROOT    every public declaration of the C# sources
    symbols.py python ROOT    every public name of the package, and its modules
"""

import json
import re
import sys
from pathlib import Path

from docs import skip_without


def name_in(kind, declaration):
    """The name that a directive of Sphinx's C domain declares."""
    if kind == "enumerator":
        return declaration.partition(" ")[0]
    pointer = re.search(r"\(\*(\w+)\)", declaration)
    return pointer.group(1) if pointer else re.search(r"(\w+)(?:\[\d+\])*(?:\(.*)?$", declaration).group(1)


def missing_c(root):
    import c_reference

    text = "".join(page for _, page in c_reference.pages(root / "bindings/api.json"))
    api = json.loads((root / "bindings/api.json").read_text(encoding="utf-8"))
    declared = {name_in(*found) for found in re.findall(r"^ *\.\. c:(\w+):: (.*)", text, re.MULTILINE)}
    wanted = {one["name"] for kind in ("functions", "structs", "callbacks", "handles", "typedefs") for one in api[kind]}
    wanted |= {one["name"] for group in api["constants"] for one in group["constants"]}
    yield from (f"the guide's pages of C lack {name}" for name in sorted(wanted - declared))
    fields = 0
    for struct in api["structs"]:
        _, _, rest = text.partition(f".. c:struct:: {struct['name']}\n")
        body = re.split(r"^\.\. ", rest, maxsplit=1, flags=re.MULTILINE)[0]
        members = re.findall(r"\.\. c:member:: (.*)", body)
        fields += len(members)
        for field in struct["fields"]:
            if not any(re.search(rf"\b{field['name']}(\[\d+\])*(\)\(.*)?$", member) for member in members):
                yield f"the guide's pages of C lack {struct['name']}.{field['name']}"
    print(f"{len(wanted)} symbols of C and {fields} fields")


def missing_csharp(root):
    import csharp_reference

    folder = root / "bindings/csharp/HrbfNpr"
    sections = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", csharp_reference.page(folder), re.DOTALL | re.MULTILINE))
    count = 0
    for path in sorted(folder.rglob("*.cs")):
        if {"bin", "obj", "Native"} & set(path.parts):  # Native is not public
            continue
        for line in path.read_text(encoding="utf-8-sig").splitlines():
            found = re.match(r"\s*public (.*?)(?:\(|\{|=|;|$)", line)
            if not found or "this[" in line or " operator " in line:
                continue
            words = re.findall(r"\w+(?=(?:<[^<>]*>)?$)", re.sub(r"\s*(?::|where) .*", "", found.group(1)).strip())
            count += 1
            if words and not any(re.search(rf"\b{words[-1]}\b", name + text) for name, text in sections.items()):
                yield f"the guide's page of C# lacks {words[-1]} of {path.name}"
    members = sum(text.count("\n- `") for text in sections.values())
    print(f"{count} public declarations of C#, {len(sections)} types, {members} members")
    bare = [name for name, text in sections.items() if not re.search(r"```\n\n\S", text)]
    yield from (f"the guide's page of C# has no summary of {name}" for name in bare)


def missing_python(root):
    skip_without("cffi", "numpy", "PIL")
    import python_reference

    import hrbfnpr

    text = "".join(page for _, page in python_reference.pages(hrbfnpr))
    names = set(re.findall(r"\.\. (?:auto\w+|py:data):: hrbfnpr\.([\w.]+)", text))
    wanted = set(python_reference.public(hrbfnpr)) | set(hrbfnpr._MODULES) | {"csg"}
    for module in (*hrbfnpr._MODULES, "csg"):
        wanted |= {f"{module}.{name}" for name in getattr(getattr(hrbfnpr, module), "__all__", ())}
    yield from (f"the guide's pages of Python lack hrbfnpr.{name}" for name in sorted(wanted - names))
    print(f"{len(wanted)} names of Python")


CHECKS = {"c": missing_c, "csharp": missing_csharp, "python": missing_python}


def main():
    root = Path(sys.argv[2]).resolve()
    sys.path.insert(0, str(root / "docs/guide"))
    findings = list(CHECKS[sys.argv[1]](root))
    print("\n".join(findings) if findings else f"{sys.argv[1]}: as it should be")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
