"""What include/hrbfnpr.h declares: functions with their signatures, constants, structs with their fields."""

import re
from pathlib import Path
from typing import Dict, List, NamedTuple

HEADER = Path(__file__).resolve().parents[2] / "include" / "hrbfnpr.h"


class Declarations(NamedTuple):
    functions: Dict[str, str]  # name -> signature, white space folded
    constants: List[str]
    structs: Dict[str, List[str]]  # name -> fields in order
    types: Dict[str, str]  # callbacks and fields, "struct.field" -> declaration, white space folded


def _plain(text: str) -> str:
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)


def _field(declaration: str) -> str:
    """The name in `double view[16]`, `void (*release)(void* user)`, `const void* data`."""
    pointer = re.search(r"\(\*(\w+)\)", declaration)
    if pointer:
        return pointer.group(1)
    return re.search(r"(\w+)\s*(\[[^\]]*\])*$", declaration).group(1)


def read(header: Path = HEADER) -> Declarations:
    text = _plain(header.read_text(encoding="utf-8"))
    functions = {}
    for match in re.finditer(r"HRBFNPR_API\s+([^;{}]*?\b(hrbfnpr_\w+)\s*\([^;{}]*\))\s*;", text):
        functions[match.group(2)] = re.sub(r"\s+", " ", match.group(1))
    constants = []
    for body in re.findall(r"\benum\s*\{([^}]*)\}", text):
        constants += re.findall(r"\b(HRBFNPR_\w+)\s*=", body)
    structs = {}
    types = {}
    for declaration, name in re.findall(r"(typedef [^;{}]*?\(\*(\w+)\)[^;{}]*);", text):
        types[name] = re.sub(r"\s+", " ", declaration)
    for name, body in re.findall(r"typedef struct (\w+) \{([^}]*)\} \w+;", text):
        declarations = [re.sub(r"\s+", " ", part.strip()) for part in body.split(";") if part.strip()]
        structs[name] = [_field(declaration) for declaration in declarations]
        types.update({f"{name}.{_field(declaration)}": declaration for declaration in declarations})
    return Declarations(functions, constants, structs, types)
