# SPDX-License-Identifier: MIT
"""Builds and runs the tests of the C# assembly on the installed versions of .NET and Mono.

    run.py native WORK                          the declarations match those generated from the header
    run.py dotnet WORK LIBRARY CC SCENE [QUICKSTART]
    run.py mono WORK LIBRARY CC SCENE [QUICKSTART]
    run.py nuget WORK LIBRARY                   the NuGet package, and a program that uses only it
    run.py unity WORK LIBRARY                   the Unity package, without Unity

CC compiles a program that measures the header, SCENE is draw_scene, and QUICKSTART is the quick start in C. The status is
77 if there is no runtime, or if the packages for the tests are missing.
"""

import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BINDING = ROOT / "bindings" / "csharp"
TESTS = ROOT / "tests" / "csharp"
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
RID = "linux-arm64" if platform.machine() == "aarch64" else "linux-x64"
# A folder of packages for a machine without a network. Without the folder, packages come from nuget.org.
PACKAGES = os.environ.get("HRBFNPR_NUGET_SOURCE", "/opt/nuget/packages")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def run(command, **options):
    """Runs a command, prints its output, and returns its status and output."""
    result = subprocess.run(
        [str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
    )
    print(result.stdout, end="", flush=True)
    return result.returncode, result.stdout


def must(command, **options):
    status, text = run(command, **options)
    if status != 0:
        print(f"failed with {status}: {' '.join(map(str, command))}")
        sys.exit(1)
    return text


def facts(work, compiler):
    """Writes the header's layouts and constants to a file, as tests/abi/snapshot.py measures them."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(ROOT / "tests" / "abi"))
    import snapshot

    path = work / "facts.txt"
    path.write_text("\n".join(snapshot.current(compiler)) + "\n")
    return path


def environment(work, compiler, scene, quickstart):
    """The environment variables that tell the tests their reference files."""
    values = {**os.environ, "HRBFNPR_FACTS": str(facts(work, compiler)), "HRBFNPR_SCENE": str(work / "scene.pam")}
    must([scene, "sphere-stipple", work / "scene.pam", 160, 160])
    if quickstart:
        (work / "c").mkdir(exist_ok=True)
        must([quickstart], cwd=work / "c")
        values["HRBFNPR_QUICKSTART"] = str(work / "c" / "torus.svg")
    return values


class DotNet:
    """The dotnet command, without build servers, which would keep running and keep the test's output open."""

    def __init__(self, work):
        self.command = shutil.which("dotnet")
        if self.command is None:
            skip("there is no dotnet here")
        self.values = {
            **os.environ,
            "DOTNET_CLI_TELEMETRY_OPTOUT": "1",
            "DOTNET_NOLOGO": "1",
            "DOTNET_CLI_USE_MSBUILD_SERVER": "0",
            "MSBUILDDISABLENODEREUSE": "1",
            "DOTNET_CLI_UI_LANGUAGE": "en",
            "NUGET_ENHANCED_MAX_NETWORK_TRY_COUNT": "2",
            "NUGET_ENHANCED_NETWORK_RETRY_DELAY_MILLISECONDS": "200",
        }
        if "HOME" not in os.environ:
            self.values["DOTNET_CLI_HOME"] = str(work)
        version = subprocess.run(
            [self.command, "--version"], capture_output=True, text=True, env=self.values
        ).stdout.strip()
        if not version or int(version.split(".")[0]) < 8:
            skip(f"the tests need an SDK of .NET 8 or later, not {version or 'none'}")
        self.framework = f"net{version.split('.')[0]}.0"
        self.common = [f"-p:ArtifactsPath={work / 'artifacts'}", "-p:UseSharedCompilation=false", "-nodeReuse:false"]
        self.common += ["-p:UseAppHost=false", "-p:NuGetAudit=false", "-m:1", "-v:quiet", "-nologo"]

    def try_restore(self, project, *properties):
        """True if all packages are found, first in the folder of packages, then in NuGet's sources."""
        folder = [["--source", PACKAGES]] if Path(PACKAGES).is_dir() else []
        for source in (*folder, []):
            command = [self.command, "restore", project, *self.common, *properties, *source]
            result = subprocess.run(
                [str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                env=self.values)
            if result.returncode == 0:
                return True
            if not re.search(r"\bNU1(100|101|102|103|301)\b", result.stdout):
                print(result.stdout)
                sys.exit(1)
        return False

    def restore(self, project, *properties):
        if not self.try_restore(project, *properties):
            skip("there are no NuGet packages to build with: neither a folder of them nor nuget.org")

    def __call__(self, verb, project, *arguments, env=None):
        return must(
            [self.command, verb, project, "--no-restore", "-c", "Release", *self.common, *arguments],
            env={**self.values, **(env or {})},
        )


def test_dotnet(work, library, compiler, scene, quickstart=None):
    dotnet = DotNet(work)
    project = TESTS / "HrbfNpr.Tests.csproj"
    framework = f"-p:HrbfNprFrameworks={dotnet.framework}"
    dotnet.restore(project, framework)
    dotnet("build", project, framework)
    values = environment(work, compiler, scene, quickstart)
    values["HRBFNPR_LIBRARY"] = library
    dotnet("test", project, framework, "--no-build", "--logger", "console;verbosity=normal", env=values)
    return 0


def mono_sources():
    return [path for path in sorted((BINDING / "HrbfNpr").rglob("*.cs")) if "obj" not in path.parts]


def test_mono(work, library, compiler, scene, quickstart=None):
    mcs, mono = shutil.which("mcs"), shutil.which("mono")
    if mcs is None or mono is None:
        skip("there is no Mono here (Debian: mono-mcs, mono-runtime)")
    common = [mcs, "-langversion:7.2", "-unsafe", "-warnaserror", "-debug-"]
    assembly, program = work / "HrbfNpr.dll", work / "HrbfNpr.Tests.exe"
    must([*common, "-target:library", f"-out:{assembly}", f"-doc:{work / 'HrbfNpr.xml'}", *mono_sources()])
    tests = [*sorted(TESTS.glob("*.cs")), TESTS / "mono" / "Xunit.cs", ROOT / "examples" / "quickstart.cs"]
    must([*common, "-target:exe", "-main:Xunit.Runner", f"-r:{assembly}", f"-out:{program}", *tests])
    values = environment(work, compiler, scene, quickstart)
    folder = str(Path(library).parent)
    values["LD_LIBRARY_PATH"] = ":".join(filter(None, [folder, os.environ.get("LD_LIBRARY_PATH")]))
    values.pop("HRBFNPR_LIBRARY", None)
    return run([mono, program], cwd=work, env=values)[0]


def require(condition, fault):
    if not condition:
        print(fault)
        sys.exit(1)


def package(kind, work, library, *options, env=None):
    folder = work / "packages"
    shutil.rmtree(folder, ignore_errors=True)
    must([sys.executable, "-B", BINDING / "package.py", kind, folder, "--native", f"{RID}={library}", *options],
         env={**(env or os.environ), "SOURCE_DATE_EPOCH": "1700000000"})
    return folder


def test_nuget(work, library):
    dotnet = DotNet(work)
    project = BINDING / "HrbfNpr" / "HrbfNpr.csproj"
    frameworks, chosen = ["netstandard2.0", "net8.0"], []
    if not dotnet.try_restore(project):
        # The SDK has the reference packages of its own framework. Those of older frameworks come from nuget.org.
        print(f"without a network: the package is made for {dotnet.framework} only")
        frameworks, chosen = [dotnet.framework], [f"-p:HrbfNprFrameworks={dotnet.framework}"]
        dotnet.restore(project, *chosen)
    folder = package("nuget", work, library, "--no-restore", *dotnet.common, *chosen, env=dotnet.values)
    (file,) = folder.glob("HrbfNpr.*.nupkg")
    names = set(zipfile.ZipFile(file).namelist())
    wanted = {"LICENSE", "README.md", "THIRD-PARTY-NOTICES.md", "HrbfNpr.nuspec", f"runtimes/{RID}/native/libhrbfnpr.so"}
    wanted |= {f"lib/{framework}/HrbfNpr.{kind}" for framework in frameworks for kind in ("dll", "xml")}
    require(wanted <= names, f"the package lacks {sorted(wanted - names)}")

    project = TESTS / "consumer" / "Consumer.csproj"
    cache = work / "cache"  # not the user's cache, which would keep this version of the package
    shutil.rmtree(cache, ignore_errors=True)
    properties = [f"-p:ConsumerFramework={dotnet.framework}", f"-p:ConsumerPackages={cache}"]
    properties += [f"-p:HrbfNprVersion={re.search(r'HrbfNpr.(.*).nupkg', file.name).group(1)}"]
    must([dotnet.command, "restore", project, *dotnet.common, *properties, "--source", folder], env=dotnet.values)
    dotnet("build", project, *properties)
    (program,) = (work / "artifacts" / "bin" / "Consumer").rglob("Consumer.dll")
    values = {name: value for name, value in dotnet.values.items() if name != "HRBFNPR_LIBRARY"}
    for name in ("torus.ppm", "torus.svg"):
        (work / name).unlink(missing_ok=True)
    must([dotnet.command, program], cwd=work, env=values)
    require((work / "torus.ppm").stat().st_size == 3 * 800 * 600 + 15, "the program drew nothing")
    require("</svg>" in (work / "torus.svg").read_text(encoding="utf-8"), "the program wrote no SVG")
    values["HRBFNPR_LIBRARY"] = str(work / "nowhere.so")  # a library that is named must be used, so this fails
    wrong = subprocess.run([dotnet.command, program], cwd=work, env=values, capture_output=True, text=True)
    require(wrong.returncode != 0 and "DllNotFoundException" in wrong.stderr, "HRBFNPR_LIBRARY was not listened to")
    print(f"{len(names)} files in the package, and a program draws with it")
    return 0


def check_unity_files(folder):
    """Every asset has a .meta file, and no two have the same guid."""
    identities = set()
    for path in folder.rglob("*"):
        inside = path.relative_to(folder)
        if path.suffix == ".meta" or any(part.endswith("~") for part in inside.parts):
            require(not any(part.endswith("~") for part in inside.parts) or path.suffix != ".meta",
                    f"{inside} is not imported by Unity")
            continue
        meta = path.with_name(path.name + ".meta")
        require(meta.is_file(), f"{inside} has no .meta file")
        identities.add(re.search(r"^guid: ([0-9a-f]{32})$", meta.read_text(), re.MULTILINE).group(1))
    require(len(identities) == len(list(folder.rglob("*.meta"))), "two assets have the same guid")
    return len(identities)


def test_unity(work, library):
    folder = package("unity", work, library)
    archive = next(folder.glob("*.tgz"))
    first = archive.read_bytes()
    time.sleep(1)
    require(next(package("unity", work, library).glob("*.tgz")).read_bytes() == first, "the archive differs each time")
    unpacked = folder / "unpacked"
    with tarfile.open(archive) as file:
        file.extractall(unpacked)
    root = unpacked / "package"
    wanted = ["package.json", "README.md", "CHANGELOG.md", "LICENSE.md", "Third Party Notices.md",
              "Runtime/HrbfNpr.asmdef", "Runtime/Model.cs", "Runtime/Native/NativeMethods.DllImport.cs",
              f"Runtime/Plugins/{RID}/libhrbfnpr.so", "Samples~/PenAndInk/PenAndInk.cs", "Documentation~/index.md"]
    missing = [name for name in wanted if not (root / name).is_file()]
    require(not missing, f"the package lacks {missing}")
    manifest = json.loads((root / "package.json").read_text(encoding="utf-8"))
    require(archive.name == f"{manifest['name']}-{manifest['version']}.tgz", "package.json is of another package")
    require(all((root / sample["path"]).is_dir() for sample in manifest["samples"]), "a sample is missing")
    for definition in root.rglob("*.asmdef"):
        require("name" in json.loads(definition.read_text(encoding="utf-8")), f"{definition.name} has no name")
    plugin = (root / f"Runtime/Plugins/{RID}/libhrbfnpr.so.meta").read_text()
    require("Standalone: Linux64" in plugin, "the plugin is not for its platform")
    count = check_unity_files(root)

    mcs = shutil.which("mcs")
    if mcs is not None:  # compile the sources as Unity does, and those of the sample
        compile_ = [mcs, "-langversion:7.2", "-unsafe", "-warnaserror", "-target:library"]
        assembly = work / "HrbfNpr.dll"
        must([*compile_, f"-out:{assembly}", *sorted((root / "Runtime").rglob("*.cs"))])
        must([*compile_, f"-out:{work / 'Sample.dll'}", f"-r:{assembly}", TESTS / "unity" / "UnityStub.cs",
              *sorted((root / "Samples~").rglob("*.cs"))])
    print(f"{count} assets in the package" + ("" if mcs else "; not compiled, there is no mcs here"))
    return 0


def check_native_names():
    """On Windows, names that differ only in upper and lower case are one file: the library must not have the assembly's."""
    project = (BINDING / "HrbfNpr" / "HrbfNpr.csproj").read_text(encoding="utf-8")
    assembly = re.search(r"<AssemblyName>(.*)</AssemblyName>", project).group(1).lower() + ".dll"
    declared = (BINDING / "HrbfNpr" / "Native" / "NativeMethods.cs").read_text(encoding="utf-8")
    names = {"the name that is imported": re.search(r'Name = "(?!__)(.*)";', declared).group(1) + ".dll"}
    tried = re.search(r"IsWindows\(\)\)\s*{\s*return new\[\] { (.*) };", declared).group(1)
    names.update({f"the file {name} that is tried": name for name in re.findall(r'"(.*?)"', tried)})
    packed = re.search(r'"win": "(.*?)"', (BINDING / "package.py").read_text(encoding="utf-8")).group(1)
    names["the file in packages"] = packed
    for what, name in names.items():
        require(name.lower() != assembly, f"{what} is also the file name of the assembly on Windows")


def test_native(work):
    check_native_names()
    return run([sys.executable, "-B", ROOT / "bindings" / "generate", "--check", "csharp", "versions"])[0]


def main():
    what, work = sys.argv[1], Path(sys.argv[2]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    tests = {"native": test_native, "dotnet": test_dotnet, "mono": test_mono, "nuget": test_nuget, "unity": test_unity}
    return tests[what](work, *sys.argv[3:])


if __name__ == "__main__":
    sys.exit(main())
