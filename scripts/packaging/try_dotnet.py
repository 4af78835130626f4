# SPDX-License-Identifier: MIT
"""Uses the NuGet package in a new .NET project, whose only source of packages for it is the folder of the release.

The program draws the common scene, whose picture is compared, and the quick start, which must write two files.  It is run
by the SDK on this machine, and published with its runtime for Windows (Wine) and for Linux on arm64 (qemu: only the scene,
because the quick start takes minutes there).
"""
from __future__ import annotations

import os
import platform
import shutil
from pathlib import Path
from typing import List

from common import ROOT, PathLike, Release
from nuget import ENVIRONMENT, WITHOUT_SERVERS
from roots import Failed, NotRun, attempt_row, execute, require
from rows import Row
from scene import CSHARP_PROJECT, SAMPLES, picture_hash

SOURCES = (ROOT / "examples" / "quickstart.cs", CSHARP_PROJECT.with_name("Scene.cs"))
NATIVE = "linux-arm64" if platform.machine() == "aarch64" else "linux-x64"
EMULATOR = "qemu-aarch64-static"
ARM64_ROOT = Path("/usr/aarch64-linux-gnu")  # libc and libstdc++, which .NET needs, by libstdc++6-arm64-cross

PROGRAM = """
public static class Program
{
    public static void Main(string[] arguments)
    {
        Scene.Main(arguments);
        if (arguments.Length > 2)
        {
            Quickstart.Main();
        }
    }
}
"""

PROJECT = """
<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <OutputType>Exe</OutputType>
    <TargetFramework>net{sdk}.0</TargetFramework>
    <StartupObject>Program</StartupObject>
    <InvariantGlobalization>true</InvariantGlobalization>
  </PropertyGroup>
  <ItemGroup>
    <PackageReference Include="HrbfNpr" Version="{version}" />
  </ItemGroup>
</Project>
"""

# Package source mapping: HrbfNpr comes from the folder of the release only.
CONFIGURATION = """
<configuration>
  <packageSources>
    <add key="release" value="{dist}" />
  </packageSources>
  <packageSourceMapping>
    <packageSource key="release"><package pattern="HrbfNpr" /></packageSource>
    <packageSource key="nuget.org"><package pattern="*" /></packageSource>
  </packageSourceMapping>
</configuration>
"""


def attempt(release: Release) -> List[Row]:
    package = release.dist / f"HrbfNpr.{release.version}.nupkg"
    if shutil.which("dotnet") is None:
        return [Row(package.name, ".NET", "not run: there is no .NET SDK here")]
    trial = Trial(release, package)
    rows = [attempt_row(package.name, f".NET {trial.sdk}, {NATIVE}", trial.by_the_sdk)]
    if "win-x64" in release.natives:
        rows.append(attempt_row(package.name, f".NET {trial.sdk} self-contained, win-x64, Wine", trial.on_windows))
    if "linux-arm64" in release.natives and NATIVE != "linux-arm64":
        rows.append(attempt_row(package.name, f".NET {trial.sdk} self-contained, linux-arm64, qemu", trial.on_arm64))
    if "osx-arm64" in release.natives:
        rows.append(Row(package.name, "macOS", "not run: no macOS here"))
    unity = release.dist / f"io.hrbfnpr.hrbfnpr-{release.version}.tgz"
    return [*rows, Row(unity.name, "Unity", "not run: no Unity here")]


class Trial:
    """A new project in a folder of its own, also with its own folder of unpacked packages."""

    def __init__(self, release: Release, package: Path) -> None:
        self.package = package
        self.folder = release.scratch("dotnet")
        self.environment = {**os.environ, **ENVIRONMENT, "NUGET_PACKAGES": str(self.folder / "packages")}
        self.environment.pop("HRBFNPR_LIBRARY", None)
        self.sdk = self.run("dotnet", "--version").split(".")[0]
        project = self.folder / "project"
        project.mkdir()
        for source in SOURCES:
            shutil.copy(source, project)
        for name, text in (
            ("Program.cs", PROGRAM),
            ("Torus.csproj", PROJECT.format(sdk=self.sdk, version=release.version)),
            ("nuget.config", CONFIGURATION.format(dist=release.dist.resolve())),
        ):
            (project / name).write_text(text.lstrip(), encoding="utf-8")

    def run(self, *command: PathLike, **environment: str) -> str:
        return execute(*command, cwd=self.folder, env={**self.environment, **environment})

    def build(self, verb: str, out: str, *options: str) -> Path:
        """Build or publish the project and return the folder of the program."""
        require(self.package)
        self.run("dotnet", verb, self.folder / "project", "-c", "Release", "-o", self.folder / out, "-nologo", "-v:quiet",
                 f"-p:ArtifactsPath={self.folder / 'artifacts' / out}", *WITHOUT_SERVERS, *options)
        return self.folder / out

    def draw(self, *command: object, quickstart: bool = True, **environment: str) -> str:
        """Run the program and return the hash of the scene's picture."""
        written = [self.folder / name for name in ("picture.rgba", *(("torus.ppm", "torus.svg") if quickstart else ()))]
        for path in written:
            path.unlink(missing_ok=True)
        self.run(*command, SAMPLES, "picture.rgba", *(["quickstart"] if quickstart else []), **environment)
        missing = [path.name for path in written if not path.is_file()]
        if missing:
            raise Failed(f"the program did not write {', '.join(missing)}")
        return picture_hash(written[0])

    def by_the_sdk(self) -> str:
        return self.draw("dotnet", self.build("build", "native", "-p:UseAppHost=false") / "Torus.dll")

    def on_windows(self) -> str:
        need("wine", "wine")
        program = self.build("publish", "windows", "-r", "win-x64", "--self-contained") / "Torus.exe"
        quiet = {"WINEPREFIX": str(self.folder / "wine"), "WINEDEBUG": "-all"}
        # A new Wine offers to install Mono and Gecko unless these DLLs are disabled. .NET itself needs mscoree.
        self.run("wine", "wineboot", "--init", **quiet, WINEDLLOVERRIDES="mscoree,mshtml=")
        return self.draw("wine", program, **quiet)

    def on_arm64(self) -> str:
        need(EMULATOR, "qemu-user-static")
        if not (ARM64_ROOT / "lib" / "libstdc++.so.6").exists():
            raise NotRun("needs libstdc++6-arm64-cross")
        program = self.build("publish", "arm64", "-r", "linux-arm64", "--self-contained") / "Torus"
        # One processor: qemu 7.2 does not keep the order of stores and loads that the library's threads rely on.
        processor = str(max(os.sched_getaffinity(0)))
        return self.draw("taskset", "-c", processor, EMULATOR, program, quickstart=False,
                         QEMU_LD_PREFIX=str(ARM64_ROOT))


def need(program: str, package: str) -> None:
    if shutil.which(program) is None:
        raise NotRun(f"needs {package}")

