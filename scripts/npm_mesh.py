# SPDX-License-Identifier: MIT
"""Makes an OBJ file from an npm package whose index.js exports `positions` and `cells`.

npm_mesh.py PACKAGE.tgz MESH.obj
"""
import json
import os
import re
import sys
import tarfile


def exported(text, name):
    """Returns the array that the module exports under a name."""
    match = re.search(rf"\bexports\.{name}\s*=\s*(\[\[.*?\]\s*\])", text, flags=re.DOTALL)
    if match is None:
        sys.exit(f"npm_mesh.py: the package exports no {name}, so it has no mesh")
    return json.loads(match.group(1))


def main(archive, mesh):
    with tarfile.open(archive) as package:
        text = package.extractfile("package/index.js").read().decode()
    lines = [f"v {x} {y} {z}" for x, y, z in exported(text, "positions")]
    lines += ["f " + " ".join(str(corner + 1) for corner in cell) for cell in exported(text, "cells")]
    with open(mesh + ".part", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    os.replace(mesh + ".part", mesh)


main(*sys.argv[1:])
