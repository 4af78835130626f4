# SPDX-License-Identifier: MIT
"""Make the npm package with the WebAssembly modules of one thread and of several."""
from __future__ import annotations

import sys
from pathlib import Path
from typing import List

from common import ROOT, Release, run

PRESETS = ("wasm", "wasm-threads")


def make(release: Release) -> List[Path]:
    """Build the modules in build/wasm and build/wasm-threads, where they stay for the next run, and pack them."""
    for preset in PRESETS:
        run("cmake", "--preset", preset, "-S", ROOT)
        run("cmake", "--build", "--preset", preset, cwd=ROOT)
    folder = release.scratch("npm") / "package"
    printed = run(sys.executable, "-B", ROOT / "bindings" / "js" / "package.py", "pack", folder,
                  env=release.environment)
    packed = Path(printed.strip())
    return [packed.replace(release.dist / packed.name)]
