# SPDX-License-Identifier: MIT
"""Writes the version of include/hrbfnpr.h into the files of package managers that must contain it.

bindings/generate runs this module.  The results are committed.  Other files read the header when they are used.
"""
import re

from outputs import ROOT

# Each pattern matches the lines of its file that have the version, from the beginning to the version.
LINES = {
    "CITATION.cff": r"^version: ",
    "README.md": r'^pip install "hrbfnpr-',
    "docs/python.md": r'^pip install "hrbfnpr-',
    "bindings/csharp/Unity/package.json": r'^  "version": "',
    "bindings/js/package.json": r'^  "version": "',
    "bindings/rust/hrbfnpr-sys/Cargo.toml": r'^version = "',
}


def with_version(name, text, version):
    """Return the text of a file with this version."""
    changed, count = re.subn(rf"({LINES[name]})\d+\.\d+\.\d+", rf"\g<1>{version}", text, flags=re.MULTILINE)
    if count == 0:
        raise SystemExit(f"{name} has no line that matches {LINES[name]}")
    return changed


def outputs(api):
    """The text of each file, by path."""
    return {ROOT / name: with_version(name, (ROOT / name).read_text(encoding="utf-8"), api["version"]) for name in LINES}
