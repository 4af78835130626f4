#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Functions that take a const handle. Several threads may call them at the same time with the same handle.

    const_functions.py [API]     one function per line, with its const handles, and the handles that each thread must own
"""
import sys
from pathlib import Path
from typing import List, NamedTuple

import header


class ConstFunction(NamedTuple):
    name: str
    shared: List[str]  # parameters that are const handles
    own: List[str]  # parameters that are mutable handles, such as an operation, which may be NULL


def const_functions(api: dict) -> List[ConstFunction]:
    result = []
    for function in api["functions"]:
        handles = [parameter for parameter in function["parameters"]
                   if parameter["type"]["kind"] == "handle" and len(parameter["type"]["pointers"]) == 1]
        shared = [parameter["name"] for parameter in handles if parameter["type"]["const"]]
        own = [parameter["name"] for parameter in handles if not parameter["type"]["const"]]
        if shared:
            result.append(ConstFunction(function["name"], shared, own))
    return result


def main():
    for function in const_functions(header.description(*map(Path, sys.argv[1:2]))):
        print(function.name, ",".join(function.shared), ",".join(function.own) or "-")


if __name__ == "__main__":
    main()
