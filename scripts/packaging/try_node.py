# SPDX-License-Identifier: MIT
"""Install the npm package in an empty folder with Node, without a network, and draw with it."""
from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import List, Optional

from common import ROOT, Native, Release
from rows import Row
from scene import SAMPLES, picture_hash

QUICKSTART = ROOT / "examples" / "quickstart.mjs"
THREADS = (1, 2)

# Fits the samples of the common scene: SAMPLES MODEL.  The last bits of a fit in WebAssembly differ from those of other
# builds, and the dots lie elsewhere.  So the module draws a model that the library for Linux has fitted.
FIT = """
import sys
import numpy, hrbfnpr

samples = numpy.loadtxt(sys.argv[1])
hrbfnpr.Model.fit(samples[:, :3], samples[:, 3:]).save(sys.argv[2])
"""

# The common scene of examples/README.md from a model: MODEL PICTURE THREADS.
SCENE = """
import { readFile, writeFile } from "node:fs/promises";
import { load } from "hrbfnpr";

const [file, picture, threads] = process.argv.slice(2);
const context = (await load({ threads: Number(threads) })).createContext();
const model = context.loadModel(await readFile(file));
const view = { direction: [0, 1, -1], up: [0, 0, 1], width: 640, height: 480 };
await writeFile(picture, context.draw({ model }, view).rasterize().data);
"""


class Failed(Exception):
    """A command failed; the message is its output."""


def attempt(release: Release) -> List[Row]:
    package = release.dist / f"hrbfnpr-{release.version}.tgz"
    missing = [program for program in ("node", "npm") if shutil.which(program) is None]
    if missing or not package.is_file():
        why = f"there is no {missing[0]} here" if missing else f"there is no {package.name}"
        return [Row(package.name, "Node", f"not run: {why}")]
    folder = release.scratch("node")
    where = f"Node {checked(folder, 'node', '--version').strip()[1:]}"
    try:
        install(folder, package)
    except Failed as failed:
        return [Row(package.name, where, f"failed: npm install: {failed}")]
    return [*scenes(folder, release.natives.get("linux-x64"), Row(package.name, f"{where}, a model of linux-x64")),
            quickstart(folder, Row(package.name, f"{where}, examples/quickstart.mjs"))]


def checked(folder: Path, *command: object, **variables: str) -> str:
    result = subprocess.run([str(word) for word in command], cwd=folder, env={**os.environ, **variables}, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode != 0:
        raise Failed(result.stdout.strip() or f"status {result.returncode}")
    return result.stdout


def install(folder: Path, package: Path) -> None:
    shutil.copy(package, folder)
    (folder / "package.json").write_text('{ "private": true, "type": "module" }\n', encoding="utf-8")
    checked(folder, "npm", "install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", f"./{package.name}")


def scenes(folder: Path, native: Optional[Native], row: Row) -> List[Row]:
    if native is None:
        return [replace(row, result="not run: there is no library for linux-x64")]
    (folder / "scene.mjs").write_text(SCENE, encoding="utf-8")
    rows = []
    try:
        checked(folder, sys.executable, "-B", "-c", FIT, SAMPLES, "torus.model", HRBFNPR_LIBRARY=str(native.library),
                PYTHONPATH=str(ROOT / "bindings" / "python"))
        for threads in THREADS:
            checked(folder, "node", "scene.mjs", "torus.model", "picture.rgba", threads)
            count = f"{threads} thread{'s' if threads > 1 else ''}"
            rows.append(replace(row, where=f"{row.where}, {count}", picture=picture_hash(folder / "picture.rgba")))
    except Failed as failed:
        rows.append(replace(row, result=f"failed: {failed}"))
    return rows


def quickstart(folder: Path, row: Row) -> Row:
    """Run the quick start as it is, and with threads: both must draw the same torus.svg."""
    drawings = set()
    for call in ("load()", f"load({{ threads: {THREADS[-1]} }})"):
        text = QUICKSTART.read_text(encoding="utf-8").replace("load()", call)
        (folder / "quickstart.mjs").write_text(text, encoding="utf-8")
        try:
            checked(folder, "node", "quickstart.mjs")
        except Failed as failed:
            return replace(row, result=f"failed: {call}: {failed}")
        drawings.add(hashlib.sha256((folder / "torus.svg").read_bytes()).hexdigest())
    return row if len(drawings) == 1 else replace(row, result="failed: threads change torus.svg")
