# SPDX-License-Identifier: MIT
"""Install the npm package in an empty folder with Node, without a network, and draw with it."""
from __future__ import annotations

import hashlib
import shutil
from functools import partial
from pathlib import Path
from typing import List

from common import ROOT, PathLike, Release
from roots import Failed, attempt_row, execute, refuse, require
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


def attempt(release: Release) -> List[Row]:
    package = release.dist / f"hrbfnpr-{release.version}.tgz"
    return [*(attempt_row(package.name, f"Node, {threads} thread{'s' if threads > 1 else ''}",
                          partial(scene_hash, release, package, threads)) for threads in THREADS),
            attempt_row(package.name, "Node, examples/quickstart.mjs", partial(try_quickstart, release, package))]


def installed(release: Release, package: Path) -> Path:
    """Install the package in an empty folder, and return the folder."""
    missing = [program for program in ("node", "npm") if not shutil.which(program)]
    refuse(f"needs {', '.join(missing)}" if missing else "")
    require(package)
    folder = release.scratch("node")
    shutil.copy(package, folder)
    (folder / "package.json").write_text('{ "private": true, "type": "module" }\n', encoding="utf-8")
    inside(folder, "npm", "install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", f"./{package.name}")
    return folder


def inside(folder: Path, *command: PathLike) -> None:
    """Run a command in this folder."""
    execute("env", f"--chdir={folder}", *command)


def scene_hash(release: Release, package: Path, threads: int) -> str:
    folder = installed(release, package)
    (folder / "scene.mjs").write_text(SCENE, encoding="utf-8")
    inside(folder, "node", "scene.mjs", SAMPLES, "picture.rgba", str(threads))
    return picture_hash(folder / "picture.rgba")


def try_quickstart(release: Release, package: Path) -> str:
    """Run the quick start as it is, and with threads: both must draw the same torus.svg."""
    folder = installed(release, package)
    drawings = set()
    for call in ("load()", f"load({{ threads: {THREADS[-1]} }})"):
        text = QUICKSTART.read_text(encoding="utf-8").replace("load()", call)
        (folder / "quickstart.mjs").write_text(text, encoding="utf-8")
        inside(folder, "node", "quickstart.mjs")
        drawings.add(hashlib.sha256((folder / "torus.svg").read_bytes()).hexdigest())
    if len(drawings) > 1:
        raise Failed(f"torus.svg has other bytes with {THREADS[-1]} threads")
    return ""  # the quick start draws another scene
