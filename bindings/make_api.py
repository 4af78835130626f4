#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Make api.json, the description of the C interface from which all bindings are made, from include/hrbfnpr.h.

    make_api.py            write it
    make_api.py --check    fail if it is out of date

bindings/generate does this, and makes the bindings too.  README.md in this folder describes api.json.
"""
import json
import os
import re
import sys

sys.dont_write_bytecode = True

import c_header  # noqa: E402
from outputs import API, ROOT, write  # noqa: E402

HEADER = ROOT / "include" / "hrbfnpr.h"
SCHEMA = 1
WIDTH = 160
# C leaves these properties of a layout to the platform.
MODELS = {
    "lp64": {"pointer": 8, "alignment_of_8": 8, "where": "64-bit pointers: Linux, macOS, Windows"},
    "ilp32": {"pointer": 4, "alignment_of_8": 8, "where": "32-bit pointers: ARM, WebAssembly, Windows"},
    "i386": {"pointer": 4, "alignment_of_8": 4, "where": "32-bit pointers: x86 except Windows"},
}


class Layouts:
    """Sizes and alignments under one of MODELS."""

    def __init__(self, model, parsed):
        self.model = model
        self.known = {"void": (0, 1)}
        for name, size in c_header.SCALARS.items():
            self.known[name] = self.scalar(size or model["pointer"])
        for typedef in parsed.typedefs:
            self.known[typedef["name"]] = self.known[typedef["type"]["base"]]
        for callback in parsed.callbacks:
            self.known[callback["name"]] = self.scalar(model["pointer"])

    def scalar(self, size):
        return size, min(size, self.model["alignment_of_8"])

    def of_type(self, kind):
        if kind["pointers"] or kind["kind"] == "function":
            return self.scalar(self.model["pointer"])
        return self.known[kind["base"]]

    def of_struct(self, struct):
        """[offset, size, alignment] of each field, and the struct's [size, alignment]."""
        fields, end, widest = [], 0, 1
        for field in struct["fields"]:
            size, alignment = self.of_type(field["type"])
            for count in field["array"]:
                size *= count
            offset = -(-end // alignment) * alignment
            fields.append({"offset": offset, "size": size, "align": alignment})
            end, widest = offset + size, max(widest, alignment)
        self.known[struct["name"]] = -(-end // widest) * widest, widest
        return fields, dict(zip(("size", "align"), self.known[struct["name"]]))


def add_layouts(parsed):
    for name, model in MODELS.items():
        layouts = Layouts(model, parsed)
        for struct in parsed.structs:
            fields, whole = layouts.of_struct(struct)
            struct.setdefault("layout", {})[name] = whole
            for field, layout in zip(struct["fields"], fields):
                field.setdefault("layout", {})[name] = layout


def prefix(names, mentioned):
    """What the names have in common, shortened to a prefix that the header mentions as HRBFNPR_..._... if it mentions one."""
    common = os.path.commonprefix([name + "_" for name in names]).rpartition("_")[0]
    if len(names) == 1:
        common = common.rpartition("_")[0]
    words = common.split("_")
    for count in range(len(words), 1, -1):
        if "_".join(words[:count]) in mentioned:
            return "_".join(words[:count])
    return common


def add_prefixes(parsed, text):
    """Adds the prefix of each enum.  Adds to each field the prefix of the constants that its comment names."""
    mentioned = set(re.findall(r"\b(HRBFNPR_\w+)_\.\.\.", text))
    first_to_prefix = {}
    for enum in parsed.enums:
        names = [constant["name"] for constant in enum["constants"]]
        enum["prefix"] = prefix(names, mentioned)
        if enum["prefix"] in first_to_prefix.values():
            line = text[:re.search(rf"\b{names[0]}\s*=", text).start()].count("\n") + 1
            raise c_header.HeaderError(line, f"a second enum of {enum['prefix']}_...")
        first_to_prefix[names[0]] = enum["prefix"]
    for entry in parsed.order:
        if entry[0] == "enum":
            entry[1] = first_to_prefix[entry[1]]
    for struct in parsed.structs:
        for field in struct["fields"]:
            found = re.findall(r"\b(HRBFNPR_\w+)_\.\.\.", field["doc"])
            if found and found[0] in first_to_prefix.values():
                field["constants"] = found[0]


def add_uses(parsed):
    """Adds each function's noun, and whether several threads may call it with the same handles at the same time."""
    nouns = [entry["name"] for group in (parsed.handles, parsed.structs, parsed.typedefs) for entry in group]
    for function in parsed.functions:
        mine = [noun for noun in nouns if function["name"].startswith(noun + "_")]
        function["noun"] = max(mine, key=len) if mine else None
        function["concurrent"] = all(
            parameter["type"]["const"] for parameter in function["parameters"]
            if parameter["type"]["kind"] == "handle" and len(parameter["type"]["pointers"]) == 1)


def ordered(entry):
    """The entry with its keys in a fixed order: short ones first, lists last."""
    keys = ["prefix", "name", "section", "noun", "concurrent", "value", "type", "array", "returns", "constants",
            "layout", "see", "doc", "heading", "parameters", "fields"]
    return {key: ordered(entry[key]) if isinstance(entry[key], dict) else
            [ordered(item) if isinstance(item, dict) else item for item in entry[key]]
            if isinstance(entry[key], list) else entry[key]
            for key in sorted(entry, key=lambda key: keys.index(key) if key in keys else -1)}


def make(text):
    """The description of a header, as a dictionary."""
    parsed = c_header.parse(text)
    add_prefixes(parsed, text)
    add_layouts(parsed)
    add_uses(parsed)
    values = {constant["name"]: constant["value"] for enum in parsed.enums for constant in enum["constants"]}
    version = [values.get(f"HRBFNPR_VERSION_{part}") for part in ("MAJOR", "MINOR", "PATCH")]
    if None in version or "HRBFNPR_ABI_VERSION" not in values:
        raise SystemExit("the header has no HRBFNPR_VERSION_MAJOR, _MINOR, _PATCH or HRBFNPR_ABI_VERSION")
    return {
        "schema": SCHEMA,
        "version": ".".join(map(str, version)),
        "abi_version": values["HRBFNPR_ABI_VERSION"],
        "doc": parsed.doc,
        "models": MODELS,
        "sections": parsed.sections,
        "order": parsed.order,
        **{key: [ordered(entry) for entry in group] for key, group in (
            ("typedefs", parsed.typedefs), ("handles", parsed.handles), ("constants", parsed.enums),
            ("callbacks", parsed.callbacks), ("structs", parsed.structs), ("functions", parsed.functions))},
    }


def dump(value, indent="", before=0):
    """JSON in which a value stays on one line if it fits there."""
    flat = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or not value or len(indent) + before + len(flat) < WIDTH:
        return flat
    deeper = indent + "  "
    if isinstance(value, dict):
        items, ends = [f'"{key}": {dump(item, deeper, len(key) + 4)}' for key, item in value.items()], "{}"
    else:
        items, ends = [dump(item, deeper) for item in value], "[]"
    return ends[0] + ",".join(f"\n{deeper}{item}" for item in items) + f"\n{indent}{ends[1]}"


def outputs():
    """The text of each file, by path."""
    try:
        return {API: dump(make(HEADER.read_text(encoding="utf-8"))) + "\n"}
    except c_header.HeaderError as error:
        raise SystemExit(f"include/hrbfnpr.h, {error}") from None


def main():
    return 1 if write(outputs(), "--check" in sys.argv[1:]) and "--check" in sys.argv[1:] else 0


if __name__ == "__main__":
    sys.exit(main())
