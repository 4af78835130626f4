# SPDX-License-Identifier: MIT
"""Makes the NuGet package and the Unity package of the C# assembly."""
from __future__ import annotations

import shutil
import sys
from pathlib import Path
from typing import List

from common import ROOT, Release, run, version

PACKAGE = ROOT / "bindings" / "csharp" / "package.py"
# Servers of dotnet would keep running after the release.
WITHOUT_SERVERS = ("-p:UseSharedCompilation=false", "-nodeReuse:false", "-p:NuGetAudit=false")
ENVIRONMENT = {
    "DOTNET_CLI_TELEMETRY_OPTOUT": "1",
    "DOTNET_NOLOGO": "1",
    "DOTNET_CLI_USE_MSBUILD_SERVER": "0",
    "DOTNET_CLI_UI_LANGUAGE": "en",
    "MSBUILDDISABLENODEREUSE": "1",
}


def make(release: Release) -> List[Path]:
    """Make both packages with all libraries that were built.  Without the .NET SDK, make only that for Unity."""
    packages = [unity(release)]
    if shutil.which("dotnet") is None:
        print("the NuGet package is left out: there is no .NET SDK here")
        return packages
    pack(release, "nuget", release.dist, *WITHOUT_SERVERS)
    return [release.dist / f"HrbfNpr.{version()}.nupkg", *packages]


def unity(release: Release) -> Path:
    folder = release.scratch("unity")
    pack(release, "unity", folder)
    (archive,) = folder.glob("*.tgz")
    return Path(shutil.copyfile(archive, release.dist / archive.name))


def pack(release: Release, kind: str, folder: Path, *options: str) -> None:
    natives = [f"{rid}={native.library}" for rid, native in release.natives.items()]
    run(sys.executable, "-B", PACKAGE, kind, folder, "--native", *natives, *options,
        env={**release.environment, **ENVIRONMENT})
