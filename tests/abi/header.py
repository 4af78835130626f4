# SPDX-License-Identifier: MIT
"""Declarations of include/hrbfnpr.h, from bindings/api.json: functions, constants, and structs with their fields.

The test house.generated checks that api.json matches the header.
"""
import json
import sys
from pathlib import Path
from typing import Dict, List, NamedTuple

ROOT = Path(__file__).resolve().parents[2]
HEADER = ROOT / "include" / "hrbfnpr.h"
API = ROOT / "bindings" / "api.json"
sys.path.append(str(ROOT / "bindings"))
sys.dont_write_bytecode = True

from outputs import declaration, signature  # noqa: E402


class Declarations(NamedTuple):
    functions: Dict[str, str]  # name -> signature
    constants: List[str]
    structs: Dict[str, List[str]]  # name -> fields in order
    types: Dict[str, str]  # callbacks and fields, "struct.field" -> declaration


def description(path: Path = API) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def read(path: Path = API) -> Declarations:
    api = description(path)
    types = {entry["name"]: f"typedef {signature(entry, '(*' + entry['name'] + ')')}" for entry in api["callbacks"]}
    for struct in api["structs"]:
        types.update({f"{struct['name']}.{field['name']}": declaration(field) for field in struct["fields"]})
    return Declarations(
        {entry["name"]: signature(entry) for entry in api["functions"]},
        [constant["name"] for group in api["constants"] for constant in group["constants"]],
        {struct["name"]: [field["name"] for field in struct["fields"]] for struct in api["structs"]},
        types)
