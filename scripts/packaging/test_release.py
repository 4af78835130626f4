#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Installs the packages of a release as a user would, draws the common scene with each, and tabulates the pictures.

    test_release.py DIST [--natives FOLDER] [--only MODULE...] [--long]

DIST is the folder with the packages, and a MODULE is the end of the name of a module try_*.py.  The table also goes to
build/release-test.md.  The status is 1 if a trial failed or if two pictures differ.
"""
from __future__ import annotations

import argparse
import importlib
import os
import signal
import sys
import traceback
from pathlib import Path
from typing import Any, Dict, List

import natives
from common import PLATFORMS, ROOT, Native, Release, source_date, version
from rows import LONG, Row, report, status

HERE = Path(__file__).resolve().parent


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("dist", type=Path, metavar="DIST", help="folder with the packages")
    parser.add_argument("--natives", type=Path, default=natives.FOLDER, metavar="FOLDER",
                        help="folder with the installed libraries, one folder for each platform")
    parser.add_argument("--only", nargs="+", default=[], metavar="MODULE", help="run only these trials, such as wheels")
    parser.add_argument("--long", action="store_true", help="also run trials that compile the library")
    return parser.parse_args()


def libraries(folder: Path) -> Dict[str, Native]:
    """Return the libraries that scripts/release has built, FOLDER/RID."""
    return {rid: natives.installed(folder / rid, platform) for rid, platform in PLATFORMS.items()
            if (folder / rid).is_dir()}


def module_names(only: List[str]) -> List[str]:
    names = sorted(path.stem for path in HERE.glob("try_*.py"))
    unknown = [name for name in only if f"try_{name}" not in names]
    if unknown:
        sys.exit(f"there is no try_{unknown[0]}.py; there are {', '.join(names)}")
    return [name for name in names if not only or name[len("try_"):] in only]


def rows_of(name: str, release: Release) -> List[Row]:
    """Return the rows of a module.  An error in the module is a failure, and the other modules still run."""
    try:
        return importlib.import_module(name).attempt(release)
    except (Exception, SystemExit) as error:  # sys.exit is how common.run fails
        traceback.print_exc()
        return [Row(name, "", f"failed: {str(error).strip().splitlines()[-1] if str(error).strip() else repr(error)}")]


def ended(number: int, frame: Any) -> None:
    """Clean up as after Ctrl-C.  No trial takes this exception for its own failure."""
    raise KeyboardInterrupt


def main() -> int:
    options = arguments()
    signal.signal(signal.SIGTERM, ended)
    if options.long:
        os.environ[LONG] = "1"
    work = ROOT / "build" / "release-test"
    work.mkdir(parents=True, exist_ok=True)
    release = Release(version(), source_date(), options.dist.resolve(), work, libraries(options.natives))
    rows = [row for name in module_names(options.only) for row in rows_of(name, release)]
    text = report(rows)
    (ROOT / "build" / "release-test.md").write_text(text, encoding="utf-8")
    print(f"\n{text}", end="")
    return status(rows)


if __name__ == "__main__":
    sys.exit(main())
