# SPDX-License-Identifier: MIT
"""The C# assembly on .NET."""

import os
import shutil

import run

NAME = "C# on .NET"


def version():
    run.need("dotnet", "none; the .NET SDK is Microsoft's")
    return run.run(["dotnet", "--version"], env={**os.environ, "DOTNET_NOLOGO": "1"}).strip()


def draw(work, library, examples):
    csharp = run.module("csharp/run.py")
    try:
        dotnet = csharp.DotNet(work)
        project = run.ROOT / "tests" / "clients" / "csharp" / "Scene.csproj"
        framework = f"-p:HrbfNprFrameworks={dotnet.framework}"
        dotnet.restore(project, framework)
        dotnet("build", project, framework)
    except SystemExit as end:
        if end.code == run.SKIPPED:
            raise run.Missing("there is no .NET SDK 8 or later, or no NuGet packages to build with") from end
        raise run.Failed("it was not built") from end
    (program,) = (work / "artifacts" / "bin" / "Scene").rglob("Scene.dll")
    picture = work / "picture.rgba"
    run.run([shutil.which("dotnet"), program, run.SAMPLES, picture],
            env={**dotnet.values, "HRBFNPR_LIBRARY": str(library)})
    return picture
