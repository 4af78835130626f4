#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares the result of hrbfnpr_layout with bindings/api.json, from which bindings are generated.

    run_time_layout.py LIBRARY
"""
import ctypes
import json
import sys
from pathlib import Path

API = Path(__file__).resolve().parents[2] / "bindings/api.json"


def as_said(struct, model):
    """A struct of api.json in the form that hrbfnpr_layout returns."""
    fields = [{"name": field["name"], "type": field["type"]["c"] + "".join(f"[{n}]" for n in field["array"]),
               "offset": field["layout"][model]["offset"], "size": field["layout"][model]["size"]}
              for field in struct["fields"]]
    return {"name": struct["name"], **struct["layout"][model], "fields": fields}


def model_of(api):
    """The data model of this interpreter, and so of the library."""
    probe = type("Probe", (ctypes.Structure,), {"_fields_": [("first", ctypes.c_char), ("second", ctypes.c_double)]})
    pointer, double = ctypes.sizeof(ctypes.c_void_p), probe.second.offset
    return next(name for name, model in api["models"].items()
                if (model["pointer"], model["alignment_of_8"]) == (pointer, double))


def main():
    api = json.loads(API.read_text(encoding="utf-8"))
    layout = ctypes.CDLL(sys.argv[1]).hrbfnpr_layout
    layout.argtypes, layout.restype = [ctypes.c_char_p], ctypes.c_char_p
    model = model_of(api)
    structs = [as_said(struct, model) for struct in api["structs"]]
    assert structs and json.loads(layout(None)) == structs, "the library and api.json disagree"
    for struct in structs:
        assert json.loads(layout(struct["name"].encode())) == struct, struct["name"]
    for name in (b"", b"hrbfnpr", b"hrbfnpr_model", b"hrbfnpr_error "):
        assert layout(name) is None, name
    print(f"{len(structs)} structs, {sum(len(struct['fields']) for struct in structs)} fields: as api.json says")


if __name__ == "__main__":
    main()
