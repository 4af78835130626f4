# SPDX-License-Identifier: MIT
"""Make the crate hrbfnpr-sys, the declarations for Rust, with cargo package and without a network."""
from __future__ import annotations

import shutil
from pathlib import Path
from typing import List

from common import ROOT, Release, run, tracked_files

CRATE = Path("bindings") / "rust" / "hrbfnpr-sys"


def cargo() -> str:
    """Return Debian's cargo if it is installed: another version may write other bytes."""
    return shutil.which("cargo", path="/usr/bin") or "cargo"


def make(release: Release) -> List[Path]:
    """Pack the crate.  cargo gives the same date to all files in it, whatever the release's date is."""
    folder = release.scratch("crates") / "hrbfnpr-sys"
    for path in tracked_files(str(CRATE)):
        target = folder / path.relative_to(CRATE)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / path, target)
    shutil.copyfile(ROOT / "LICENSE", folder / "LICENSE")
    run(cargo(), "package", "--no-verify", "--offline", "--quiet", cwd=folder, env=release.environment)
    packed = folder / "target" / "package" / f"hrbfnpr-sys-{release.version}.crate"
    return [packed.replace(release.dist / packed.name)]
