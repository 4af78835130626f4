#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make the npm package hrbfnpr from the modules that the presets wasm and wasm-threads build.

    package.py folder FOLDER [--wasm BUILD] [--threads BUILD]     makes the package as a folder
    package.py pack FOLDER [...]                                  also makes FOLDER/../hrbfnpr-VERSION.tgz

The default builds are build/wasm and build/wasm-threads.  A build that does not exist is left out: the package then
loads only without threads, or only with threads.  The same modules make an archive with the same bytes each time; its
files have the date SOURCE_DATE_EPOCH, or else the date that npm pack gives to all files.
"""
import argparse
import os
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))
from common import HEADERS, notices, tree, version, write_tar  # noqa: E402

LEFT_OUT = shutil.ignore_patterns("exports.txt")
NOTICES = (*HEADERS, "libc++", "Emscripten")
NPM_DATE = 499162500  # 1985-10-26, the date of all files in archives of npm pack


def modules(build):
    return sorted((build / "bindings" / "js").glob("hrbfnpr*.*"))


def make(folder, builds):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(HERE / "src", folder / "src", ignore=LEFT_OUT)
    (folder / "THIRD-PARTY-NOTICES.md").write_text(notices(NOTICES), encoding="utf-8")
    for path in (HERE / "package.json", HERE / "README.md", ROOT / "LICENSE"):
        shutil.copy(path, folder)
    for name, build in builds.items():
        target = folder / name
        target.mkdir()
        for path in modules(build):
            shutil.copyfile(path, target / path.name)
        # Emscripten's worker is a CommonJS script.
        (target / "package.json").write_text('{ "type": "commonjs" }\n', encoding="utf-8")


def pack(folder):
    """Write the archive, with the names that npm wants in it, and return its path."""
    date = int(os.environ.get("SOURCE_DATE_EPOCH", NPM_DATE))
    return write_tar(folder.parent / f"hrbfnpr-{version()}.tgz", tree(folder, "package/"), date)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("folder", "pack"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("--wasm", type=Path, default=ROOT / "build" / "wasm")
    parser.add_argument("--threads", type=Path, default=ROOT / "build" / "wasm-threads")
    arguments = parser.parse_args()
    builds = {name: build for name, build in (("wasm", arguments.wasm), ("wasm-threads", arguments.threads))
              if any(path.suffix == ".wasm" for path in modules(build))}
    if not builds:
        sys.exit("there is no module: run scripts/web, or build the preset wasm")
    folder = arguments.folder.resolve()
    make(folder, builds)
    print(pack(folder) if arguments.what == "pack" else arguments.folder)


if __name__ == "__main__":
    main()
