#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make the npm package hrbfnpr from the modules that the presets wasm and wasm-threads build.

    package.py folder FOLDER [--wasm BUILD] [--threads BUILD]     makes the package as a folder
    package.py pack FOLDER [...]                                  also makes FOLDER/../hrbfnpr-VERSION.tgz by npm pack

The default builds are build/wasm and build/wasm-threads.  A build that does not exist is left out: the package then
loads only without threads, or only with threads.
"""
import argparse
import json
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LEFT_OUT = shutil.ignore_patterns("exports.txt")


def version():
    return json.loads((ROOT / "bindings" / "api.json").read_text(encoding="utf-8"))["version"]


def modules(build):
    return sorted((build / "bindings" / "js").glob("hrbfnpr*.*"))


def make(folder, builds):
    described = json.loads((HERE / "package.json").read_text(encoding="utf-8"))
    if described["version"] != version():
        sys.exit(f"bindings/js/package.json is of version {described['version']}, the library of {version()}")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(HERE / "src", folder / "src", ignore=LEFT_OUT)
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
    result = subprocess.run(["npm", "pack", "--loglevel=error", "--pack-destination", folder.parent, folder],
                            capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"npm pack failed: {result.stderr}")
    return folder.parent / result.stdout.split()[-1]


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
    make(arguments.folder.resolve(), builds)
    print(pack(arguments.folder.resolve()) if arguments.what == "pack" else arguments.folder)


if __name__ == "__main__":
    main()
