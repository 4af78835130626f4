#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make packages of the C# assembly with the native library inside.

    package.py nuget FOLDER --native RID=FILE...     FOLDER/HrbfNpr.VERSION.nupkg, by dotnet pack
    package.py unity FOLDER --native RID=FILE...     FOLDER/io.hrbfnpr.hrbfnpr, and the same as a .tgz; without Unity

RID is linux-x64, linux-arm64, win-x64, win-arm64, osx-x64 or osx-arm64.  Several may be given.  Example:

    package.py nuget dist --native linux-x64=build/release/src/libhrbfnpr.so
"""
import argparse
import hashlib
import json
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FILE_NAMES = {"linux": "libhrbfnpr.so", "win": "hrbfnpr.dll", "osx": "libhrbfnpr.dylib"}
# For each RID: Unity's names of the player platform, of the editor's system, and of the processor.
UNITY_PLATFORMS = {
    "linux-x64": ("Linux64", "Linux", "x86_64"),
    "linux-arm64": ("Linux64", "Linux", "ARM64"),
    "win-x64": ("Win64", "Windows", "x86_64"),
    "win-arm64": ("Win64", "Windows", "ARM64"),
    "osx-x64": ("OSXUniversal", "OSX", "x86_64"),
    "osx-arm64": ("OSXUniversal", "OSX", "ARM64"),
}


def version():
    return json.loads((ROOT / "bindings" / "api.json").read_text(encoding="utf-8"))["version"]


def native_files(arguments):
    """Return (RID, file to copy, name in the package) for each RID=FILE argument."""
    files = []
    for argument in arguments:
        rid, _, path = argument.partition("=")
        if rid not in UNITY_PLATFORMS:
            sys.exit(f"{argument}: the part before = must be one of {', '.join(UNITY_PLATFORMS)}")
        if not Path(path).is_file():
            sys.exit(f"{argument}: there is no file {path}")
        files.append((rid, Path(path).resolve(), FILE_NAMES[rid.split("-")[0]]))
    return files


def nuget(folder, natives, options):
    with tempfile.TemporaryDirectory() as scratch:
        for rid, path, name in natives:
            target = Path(scratch) / "runtimes" / rid / "native" / name
            target.parent.mkdir(parents=True)
            shutil.copy(path, target)
        command = ["dotnet", "pack", HERE / "HrbfNpr", "-c", "Release", "-o", folder, "-nologo", "-v:quiet"]
        command += [f"-p:HrbfNprNative={scratch}", f"-p:Version={version()}", *options]
        if subprocess.run([str(part) for part in command]).returncode != 0:
            sys.exit(1)
    print(Path(folder) / f"HrbfNpr.{version()}.nupkg")


def meta(path, name):
    """Return the text of an asset's .meta file.  An installed package must contain one for each asset."""
    guid = hashlib.md5(f"io.hrbfnpr.hrbfnpr/{name}".encode()).hexdigest()
    text = f"fileFormatVersion: 2\nguid: {guid}\n"
    if path.is_dir():
        return text + "folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n"
    if path.suffix == ".cs":
        return text + "MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  executionOrder: 0\n"
    if path.suffix == ".asmdef":
        return text + "AssemblyDefinitionImporter:\n  externalObjects: {}\n"
    if path.parent.parent.name == "Plugins":
        player, system, processor = UNITY_PLATFORMS[path.parent.name]
        return text + (
            "PluginImporter:\n  serializedVersion: 2\n  isPreloaded: 0\n  isOverridable: 0\n  platformData:\n"
            "  - first:\n      Any:\n    second:\n      enabled: 0\n      settings: {}\n"
            "  - first:\n      Editor: Editor\n    second:\n      enabled: 1\n      settings:\n"
            f"        CPU: {processor}\n        OS: {system}\n"
            f"  - first:\n      Standalone: {player}\n    second:\n      enabled: 1\n      settings:\n"
            f"        CPU: {processor}\n")
    importer = "PackageManifestImporter" if path.name == "package.json" else "TextScriptImporter"
    return text + f"{importer}:\n  externalObjects: {{}}\n"


def unity(folder, natives, options):
    del options
    name = "io.hrbfnpr.hrbfnpr"
    package = Path(folder) / name
    if package.exists():
        shutil.rmtree(package)
    shutil.copytree(HERE / "Unity", package)
    manifest = json.loads((package / "package.json").read_text(encoding="utf-8"))
    manifest["version"] = version()
    (package / "package.json").write_text(json.dumps(manifest, indent=2) + "\n", encoding="utf-8")
    for source in sorted((HERE / "HrbfNpr").rglob("*.cs")):
        inside = source.relative_to(HERE / "HrbfNpr")
        if inside.parts[0] not in ("bin", "obj"):
            (package / "Runtime" / inside).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, package / "Runtime" / inside)
    for rid, path, file_name in natives:
        target = package / "Runtime" / "Plugins" / rid / file_name
        target.parent.mkdir(parents=True)
        shutil.copy(path, target)
    (package / "Documentation~").mkdir()
    for source, target in (
        (HERE / "README.md", "README.md"),
        (ROOT / "CHANGELOG.md", "CHANGELOG.md"),
        (ROOT / "LICENSE", "LICENSE.md"),
        (ROOT / "docs" / "csharp.md", "Documentation~/index.md"),
    ):
        shutil.copy(source, package / target)
    for path in sorted(package.rglob("*")):
        inside = path.relative_to(package)
        if not any(part.endswith("~") for part in inside.parts):  # Unity does not import folders whose names end in ~
            path.with_name(path.name + ".meta").write_text(meta(path, inside.as_posix()), encoding="utf-8")
    archive = Path(folder) / f"{name}-{version()}.tgz"
    with tarfile.open(archive, "w:gz") as file:
        file.add(package, "package")  # npm and Unity expect this folder in the archive
    print(package)
    print(archive)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("kind", choices=("nuget", "unity"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("--native", nargs="+", default=[], metavar="RID=FILE")
    arguments, options = parser.parse_known_args()  # other options are passed to dotnet
    arguments.folder.mkdir(parents=True, exist_ok=True)
    make = {"nuget": nuget, "unity": unity}[arguments.kind]
    make(arguments.folder.resolve(), native_files(arguments.native), options)


if __name__ == "__main__":
    main()
