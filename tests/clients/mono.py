# SPDX-License-Identifier: MIT
"""The C# assembly on Mono."""

import os

import run

NAME = "C# on Mono"


def version():
    return run.run([run.need("mono", "mono-runtime"), "--version"]).split()[4]


def draw(work, library, examples):
    mcs = [run.need("mcs", "mono-mcs"), "-langversion:7.2", "-unsafe", "-warnaserror"]
    sources = run.module("csharp/run.py").mono_sources()
    assembly, program, picture = work / "HrbfNpr.dll", work / "Scene.exe", work / "picture.rgba"
    run.run([*mcs, "-target:library", f"-out:{assembly}", *sources])
    run.run([*mcs, f"-r:{assembly}", f"-out:{program}", run.ROOT / "tests" / "clients" / "csharp" / "Scene.cs"])
    run.run(["mono", program, run.SAMPLES, picture], env={**os.environ, "LD_LIBRARY_PATH": str(library.parent)})
    return picture
