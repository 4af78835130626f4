#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Build the libraries of all platforms and pack them.  scripts/release installs what this needs, and calls it.

    make_release.py DIST ZIG [--platforms RID...] [--packages MODULE...]
"""
from __future__ import annotations

import argparse
import importlib
import sys
import time
from pathlib import Path
from typing import List

import natives
from common import PLATFORMS, ROOT, Release, source_date, version

# The modules that make packages, in this order.  The bill of materials lists the packages of all others.
MODULES = ("amalgamate", "archives", "wheels", "debs", "nuget", "npm", "crates", "sbom")


def make_packages(release: Release, modules: List[str]) -> List[str]:
    """Make the packages of these modules.  Return one line for each package: its time, size and name."""
    lines = []
    for name in modules:
        start = time.monotonic()
        paths = importlib.import_module(name).make(release)
        seconds = time.monotonic() - start
        lines += [f"{seconds if path == paths[0] else 0:6.0f} s {path.stat().st_size / 1e6:7.2f} MB  {path.name}"
                  for path in paths]
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("dist", type=Path)
    parser.add_argument("zig", type=Path)
    parser.add_argument("--platforms", nargs="+", choices=list(PLATFORMS), default=list(PLATFORMS), metavar="RID")
    parser.add_argument("--packages", nargs="+", choices=MODULES, default=list(MODULES), metavar="MODULE")
    arguments = parser.parse_args()
    arguments.dist.mkdir(parents=True, exist_ok=True)
    release = Release(version(), source_date(), arguments.dist.resolve(), ROOT / "build" / "release-work")
    start = time.monotonic()
    natives.make(release, arguments.platforms, arguments.zig.resolve())
    built = time.monotonic()
    lines = make_packages(release, arguments.packages)
    importlib.import_module("sbom").write_sums(release)
    print(f"\nlibraries for {', '.join(release.natives)}: {built - start:.0f} s")
    print(*lines, sep="\n")
    print(f"{arguments.dist / 'SHA256SUMS'} has the sums; whole: {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    sys.exit(main())
