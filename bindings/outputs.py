# SPDX-License-Identifier: MIT
"""Loads api.json, and writes or compares the files that are made from it."""
import json
import sys
from pathlib import Path

BINDINGS = Path(__file__).resolve().parent
ROOT = BINDINGS.parent
API = BINDINGS / "api.json"
COMMAND = "bindings/generate"


def load(path=API):
    return json.loads(path.read_text(encoding="utf-8"))


def declarations(api):
    """(kind, entry) of all declarations in the header's order.  The kind is "enum", "struct", "callback" and so on."""
    kinds = {"enum": "constants", "struct": "structs", "callback": "callbacks", "handle": "handles",
             "typedef": "typedefs", "function": "functions"}
    entries = {(kind, entry.get("name", entry.get("prefix"))): entry
               for kind, group in kinds.items() for entry in api[group]}
    for kind, name in api["order"]:
        yield kind, entries[kind, name]


def declaration(entry):
    """A field or a parameter as C writes it: `double view[16]`, `void (*release)(void* user)`."""
    kind, name = entry["type"], entry["name"]
    if kind["kind"] == "function":
        return kind["c"].replace("(*)", f"(*{name})", 1)
    return f"{kind['c']} {name}" + "".join(f"[{size}]" for size in entry.get("array", []))


def signature(entry, name=None):
    """A function or a callback as C writes it: `hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model, ...)`."""
    parameters = ", ".join(map(declaration, entry["parameters"])) or "void"
    return f"{entry['returns']['c']} {name or entry['name']}({parameters})"


def write(files, check=False):
    """Writes the texts that differ from their files.  With `check` it only reports them.  Returns their number."""
    stale = 0
    for path, text in files.items():
        if path.is_file() and path.read_text(encoding="utf-8") == text:
            continue
        stale += 1
        if check:
            print(f"{path.relative_to(ROOT)} is out of date: run {COMMAND}", file=sys.stderr)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            print(path.relative_to(ROOT))
    return stale
