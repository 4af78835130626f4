"""Builds and runs the tests of the C# assembly, with what of .NET and Mono is here.

    run.py native WORK                          the declarations are those that the header makes
    run.py dotnet WORK LIBRARY CC SCENE [QUICKSTART]
    run.py mono WORK LIBRARY CC SCENE [QUICKSTART]

CC compiles a program that measures the header, SCENE is draw_scene, QUICKSTART the quick start in C.  Returns 77
where there is no runtime, or no packages to test with.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BINDING = ROOT / "bindings" / "csharp"
TESTS = ROOT / "tests" / "csharp"
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
# Where packages may lie on a machine without a network; nuget.org is asked if there are none.
PACKAGES = os.environ.get("HRBFNPR_NUGET_SOURCE", "/opt/nuget/packages")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def run(command, **options):
    """Runs a command, prints what it says, and returns its status and that."""
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
    """The header's layouts and constants, as tests/abi/snapshot.py measures them."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(ROOT / "tests" / "abi"))
    import snapshot

    path = work / "facts.txt"
    path.write_text("\n".join(snapshot.current(compiler)) + "\n")
    return path


def environment(work, compiler, scene, quickstart):
    """What the tests compare with, in environment variables."""
    values = {**os.environ, "HRBFNPR_FACTS": str(facts(work, compiler)), "HRBFNPR_SCENE": str(work / "scene.pam")}
    must([scene, "sphere-stipple", work / "scene.pam", 160, 160])
    if quickstart:
        (work / "c").mkdir(exist_ok=True)
        must([quickstart], cwd=work / "c")
        values["HRBFNPR_QUICKSTART"] = str(work / "c" / "torus.ppm")
    return values


class DotNet:
    """The dotnet command, without servers that stay behind and keep a test's output open."""

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
        }
        version = subprocess.run(
            [self.command, "--version"], capture_output=True, text=True, env=self.values
        ).stdout.strip()
        if not version or int(version.split(".")[0]) < 8:
            skip(f"the tests need an SDK of .NET 8 or later, not {version or 'none'}")
        self.framework = f"net{version.split('.')[0]}.0"
        self.common = [f"-p:ArtifactsPath={work / 'artifacts'}", "-p:UseSharedCompilation=false", "-nodeReuse:false"]
        self.common += ["-p:UseAppHost=false", "-m:1", "-v:quiet", "-nologo"]

    def restore(self, project, *properties, sources=()):
        local = [PACKAGES] if Path(PACKAGES).is_dir() else []
        for chosen in ([*local], []) if local else ([],):
            named = [part for source in (*chosen, *sources) for part in ("--source", source)] if chosen else \
                [f"-p:RestoreAdditionalProjectSources={source}" for source in sources]
            status, text = run(
                [self.command, "restore", project, *self.common, *properties, *named], env=self.values)
            if status == 0:
                return
        if any(code in text for code in ("NU1101", "NU1102", "NU1301", "NU1100")):
            skip("there are no NuGet packages to build with: neither a folder of them nor nuget.org")
        sys.exit(1)

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


def test_native(work):
    status = run([sys.executable, "-B", BINDING / "make_native.py", "--check"])[0]
    example = (ROOT / "examples" / "quickstart.cs").read_text(encoding="utf-8")
    if f"```csharp\n{example}```\n" not in (ROOT / "README.md").read_text(encoding="utf-8"):
        print("README.md does not contain examples/quickstart.cs to the letter")
        status = 1
    for path in [*mono_sources(), *TESTS.rglob("*.cs"), *BINDING.glob("Unity/**/*.cs")]:
        count = len(path.read_text(encoding="utf-8").splitlines())
        if count > 500 and path.name != "Enums.cs":
            print(f"{path.relative_to(ROOT)} has {count} lines: split it")
            status = 1
    return status


def main():
    what, work = sys.argv[1], Path(sys.argv[2]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    return {"native": test_native, "dotnet": test_dotnet, "mono": test_mono}[what](work, *sys.argv[3:])


if __name__ == "__main__":
    sys.exit(main())
