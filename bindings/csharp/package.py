#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make packages of the C# assembly with the native library inside.

    package.py nuget FOLDER --native RID=FILE...     FOLDER/HrbfNpr.VERSION.nupkg, by dotnet pack
    package.py unity FOLDER --native RID=FILE...     FOLDER/io.hrbfnpr.hrbfnpr, and the same as a .tgz; without Unity

RID is linux-x64, linux-arm64, win-x64, win-arm64, osx-x64 or osx-arm64.  Several may be given.  Other options are passed
to dotnet.  The files in a package have the date in SOURCE_DATE_EPOCH, or else that of the last commit.  Example:

    package.py nuget dist --native linux-x64=build/release/src/libhrbfnpr.so
"""
from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Dict, List, Mapping, NamedTuple, Sequence

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "scripts" / "packaging"))
import common  # noqa: E402

FILE_NAMES = {"linux": "libhrbfnpr.so", "win": "libhrbfnpr.dll", "osx": "libhrbfnpr.dylib"}
UNITY_NAME = "io.hrbfnpr.hrbfnpr"


class Unity(NamedTuple):
    """Unity's names of a platform."""

    player: str
    editor: str  # the system of the editor
    processor: str


UNITY_PLATFORMS = {
    "linux-x64": Unity("Linux64", "Linux", "x86_64"),
    "linux-arm64": Unity("Linux64", "Linux", "ARM64"),
    "win-x64": Unity("Win64", "Windows", "x86_64"),
    "win-arm64": Unity("Win64", "Windows", "ARM64"),
    "osx-x64": Unity("OSXUniversal", "OSX", "x86_64"),
    "osx-arm64": Unity("OSXUniversal", "OSX", "ARM64"),
}


def native_files(arguments: Sequence[str]) -> Dict[str, Path]:
    """Return the file of each RID=FILE argument by its RID."""
    files = {}
    for argument in arguments:
        rid, _, path = argument.partition("=")
        if rid not in UNITY_PLATFORMS:
            sys.exit(f"{argument}: the part before = must be one of {', '.join(UNITY_PLATFORMS)}")
        if not Path(path).is_file():
            sys.exit(f"{argument}: there is no file {path}")
        files[rid] = Path(path).resolve()
    return files


def file_name(rid: str) -> str:
    return FILE_NAMES[rid.split("-")[0]]


def third_party(rids: Sequence[str]) -> str:
    """Return the notices for the libraries and the C++ runtimes that are inside the libraries of these platforms."""
    systems = {rid.split("-")[0] for rid in rids}
    runtimes = [name for rid, platform in common.PLATFORMS.items() if rid.split("-")[0] in systems
                for name in platform.runtimes]
    return common.notices([*common.HEADERS, *runtimes])


def readme(rids: Sequence[str]) -> str:
    """Return the text of the README with a list of the platforms in the package."""
    notes = {rid: common.PLATFORMS[rid].note for rid in rids if rid in common.PLATFORMS}
    lines = [f"- {rid}" + (f" ({notes[rid]})" if notes.get(rid) else "") for rid in rids]
    text = (HERE / "README.md").read_text(encoding="utf-8")
    if lines:
        text += "\n## Platforms\n\nThe package contains the native library for:\n\n" + "\n".join(lines) + "\n"
    return text


def write(folder: Path, contents: common.Contents) -> None:
    """Write files that anyone may read, whatever the modes of the originals."""
    for name, source in contents.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(common.read(source))
        path.chmod(0o644)


def nuget(folder: Path, natives: Mapping[str, Path], epoch: int, options: Sequence[str]) -> List[Path]:
    """Make the NuGet package with dotnet, and return its path."""
    if shutil.which("dotnet") is None:
        sys.exit("there is no dotnet here; the NuGet package needs the .NET SDK 8 or later")
    contents: Dict[str, object] = {f"runtimes/{rid}/native/{file_name(rid)}": path for rid, path in natives.items()}
    contents.update({"LICENSE": ROOT / "LICENSE", "README.md": readme(sorted(natives)),
                     "THIRD-PARTY-NOTICES.md": third_party(sorted(natives))})
    with tempfile.TemporaryDirectory() as scratch:
        write(Path(scratch) / "contents", contents)
        common.run("dotnet", "pack", HERE / "HrbfNpr", "-c", "Release", "-o", scratch, "-nologo", "-v:quiet",
                   f"-p:HrbfNprContents={scratch}/contents/", f"-p:ArtifactsPath={scratch}/artifacts",
                   "-p:ContinuousIntegrationBuild=true", *options,
                   env={**os.environ, "SOURCE_DATE_EPOCH": str(epoch)})
        made = Path(scratch) / f"HrbfNpr.{common.version()}.nupkg"
        return [Path(shutil.copyfile(made, folder / made.name))]


def meta(name: str, is_folder: bool) -> str:
    """Return the text of an asset's .meta file.  An installed package must contain one for each asset."""
    guid = hashlib.md5(f"{UNITY_NAME}/{name}".encode()).hexdigest()
    text = f"fileFormatVersion: 2\nguid: {guid}\n"
    path = Path(name)
    if is_folder:
        return text + "folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n"
    if path.suffix == ".cs":
        return text + "MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  executionOrder: 0\n"
    if path.suffix == ".asmdef":
        return text + "AssemblyDefinitionImporter:\n  externalObjects: {}\n"
    if path.parent.parent.name == "Plugins":
        platform = UNITY_PLATFORMS[path.parent.name]
        return text + (
            "PluginImporter:\n  serializedVersion: 2\n  isPreloaded: 0\n  isOverridable: 0\n  platformData:\n"
            "  - first:\n      Any:\n    second:\n      enabled: 0\n      settings: {}\n"
            "  - first:\n      Editor: Editor\n    second:\n      enabled: 1\n      settings:\n"
            f"        CPU: {platform.processor}\n        OS: {platform.editor}\n"
            f"  - first:\n      Standalone: {platform.player}\n    second:\n      enabled: 1\n      settings:\n"
            f"        CPU: {platform.processor}\n")
    importer = "PackageManifestImporter" if path.name == "package.json" else "TextScriptImporter"
    return text + f"{importer}:\n  externalObjects: {{}}\n"


def sources(folder: Path) -> Dict[str, Path]:
    """Return the files of a folder by their names in it, without those that dotnet builds."""
    return {name: path for name, path in common.tree(folder).items() if name.split("/")[0] not in ("bin", "obj")}


def unity_contents(natives: Mapping[str, Path]) -> Dict[str, object]:
    """Return the contents of the Unity package by their names in it."""
    manifest = json.loads((HERE / "Unity" / "package.json").read_text(encoding="utf-8"))
    manifest["version"] = common.version()
    contents: Dict[str, object] = {
        **sources(HERE / "Unity"),
        **{f"Runtime/{name}": path for name, path in sources(HERE / "HrbfNpr").items() if name.endswith(".cs")},
        **{f"Runtime/Plugins/{rid}/{file_name(rid)}": path for rid, path in natives.items()},
        "package.json": json.dumps(manifest, indent=2) + "\n",
        "README.md": readme(sorted(natives)),
        "CHANGELOG.md": ROOT / "CHANGELOG.md",
        "LICENSE.md": ROOT / "LICENSE",  # Unity shows files with this name and the next
        "Third Party Notices.md": third_party(sorted(natives)),
        "Documentation~/index.md": ROOT / "docs" / "csharp.md",
    }
    files = set(contents)
    folders = {parent.as_posix() for name in files for parent in Path(name).parents} - {"."}
    for name in files | folders:
        if "~/" not in f"{name}/":  # Unity does not import folders whose names end in ~
            contents[f"{name}.meta"] = meta(name, name in folders)
    return contents


def unity(folder: Path, natives: Mapping[str, Path], epoch: int, options: Sequence[str]) -> List[Path]:
    """Make the Unity package as a folder and as a .tgz, and return their paths."""
    if options:
        sys.exit(f"unknown options: {' '.join(options)}")
    package = folder / UNITY_NAME
    shutil.rmtree(package, ignore_errors=True)
    write(package, unity_contents(natives))
    archive = folder / f"{UNITY_NAME}-{common.version()}.tgz"
    # npm and Unity expect the folder "package" in the archive.
    common.write_tar(archive, common.tree(package, "package/"), epoch)
    return [package, archive]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("kind", choices=("nuget", "unity"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("--native", nargs="+", default=[], metavar="RID=FILE")
    arguments, options = parser.parse_known_args()  # other options are passed to dotnet
    arguments.folder.mkdir(parents=True, exist_ok=True)
    make = {"nuget": nuget, "unity": unity}[arguments.kind]
    for path in make(arguments.folder.resolve(), native_files(arguments.native), common.source_date(), options):
        print(path)


if __name__ == "__main__":
    main()
