# SPDX-License-Identifier: MIT
"""Node and koffi with the declarations of bindings/cdef: a picture, a callback and an error (koffi.js)."""

import os
import shutil
import subprocess

import run

NAME = "Node koffi"
BY_STEPS = True  # tests more of the raw declarations than hrbfnpr_picture_create needs
CDEF = run.ROOT / "bindings" / "cdef" / "hrbfnpr_cdef.h"
QUIET = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "text": True}


def environment():
    """Looks for koffi in NODE_PATH, in the folder of scripts/fetch_koffi, and among npm's global packages."""
    folders = [os.environ.get("NODE_PATH", ""), str(run.ROOT / ".cache" / "node_modules")]
    if shutil.which("npm"):
        folders.append(subprocess.run(["npm", "root", "-g"], **QUIET).stdout.strip())
    return {**os.environ, "NODE_PATH": os.pathsep.join(filter(None, folders))}


def version():
    node = run.need("node", "nodejs")
    found = subprocess.run([node, "-p", "require('koffi').version"], env=environment(), **QUIET)
    if found.returncode != 0:
        raise run.Missing(
            "node finds no package koffi: run scripts/fetch_koffi, or npm install -g koffi (tried with 2.16.3 and 3.3.4)")
    return found.stdout.strip()


def draw(work, library, examples):
    picture = work / "picture.rgba"
    program = run.ROOT / "tests" / "clients" / "koffi.js"
    run.run(["node", program, CDEF, library, run.SAMPLES, picture], env=environment())
    return picture
