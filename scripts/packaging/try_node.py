# SPDX-License-Identifier: MIT
"""Install the npm package in an empty folder with Node, without a network, and draw with it."""
from __future__ import annotations

import hashlib
import shutil
import subprocess
from pathlib import Path
from typing import List

from common import ROOT, Release
from rows import Row
from scene import SAMPLES, picture_hash

QUICKSTART = ROOT / "examples" / "quickstart.mjs"
THREADS = (1, 2)

# The common scene of examples/README.md: SAMPLES PICTURE THREADS.
SCENE = """
import { readFile, writeFile } from "node:fs/promises";
import { load } from "hrbfnpr";

const [samples, picture, threads] = process.argv.slice(2);
const rows = (await readFile(samples, "utf8")).trim().split("\\n").map((line) => line.trim().split(/\\s+/).map(Number));
const source = { points: rows.map((row) => row.slice(0, 3)), normals: rows.map((row) => row.slice(3)) };
const context = (await load({ threads: Number(threads) })).createContext();
const view = { direction: [0, 1, -1], up: [0, 0, 1], width: 640, height: 480 };
await writeFile(picture, context.draw(source, view).rasterize().data);
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
    rows = [drawn(folder, package, where, threads) for threads in THREADS]
    return [*rows, quickstart(folder, package, f"{where}, examples/quickstart.mjs")]


def checked(folder: Path, *command: object) -> str:
    result = subprocess.run([str(word) for word in command], cwd=folder, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    if result.returncode != 0:
        raise Failed(result.stdout.strip() or f"status {result.returncode}")
    return result.stdout


def install(folder: Path, package: Path) -> None:
    shutil.copy(package, folder)
    (folder / "package.json").write_text('{ "private": true, "type": "module" }\n', encoding="utf-8")
    checked(folder, "npm", "install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", f"./{package.name}")


def drawn(folder: Path, package: Path, where: str, threads: int) -> Row:
    where = f"{where}, {threads} thread{'s' if threads > 1 else ''}"
    (folder / "scene.mjs").write_text(SCENE, encoding="utf-8")
    picture = folder / f"picture-{threads}.rgba"
    try:
        checked(folder, "node", "scene.mjs", SAMPLES, picture, threads)
    except Failed as failed:
        return Row(package.name, where, f"failed: {failed}")
    return Row(package.name, where, "ok", picture_hash(picture))


def quickstart(folder: Path, package: Path, where: str) -> Row:
    """Run the quick start as it is, and with threads: both must draw the same torus.svg."""
    drawings = []
    for call in ("load()", f"load({{ threads: {THREADS[-1]} }})"):
        text = QUICKSTART.read_text(encoding="utf-8").replace("load()", call)
        (folder / "quickstart.mjs").write_text(text, encoding="utf-8")
        try:
            checked(folder, "node", "quickstart.mjs")
        except Failed as failed:
            return Row(package.name, where, f"failed: {call}: {failed}")
        drawings.append(hashlib.sha256((folder / "torus.svg").read_bytes()).hexdigest())
    return Row(package.name, where, "ok" if len(set(drawings)) == 1 else "failed: threads change torus.svg")
