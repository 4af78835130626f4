# SPDX-License-Identifier: MIT
"""The code blocks of all documents are run, compiled or read by a test.

    snippets.py all ROOT                    a test reads each block, or the line above it says why not:
                                            <!-- not run: because ... -->
    snippets.py commands ROOT               command lines: programs exist, and `python3 -m hrbfnpr` has the options
    snippets.py c ROOT COMPILER             blocks of C compile
    snippets.py python ROOT                 blocks of Python run that no other test runs
    snippets.py csharp ROOT                 blocks of docs/csharp.md compile
"""

import contextlib
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from docs import documents, skip_without

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
CHECKED = {"c", "cpp", "python", "py", "csharp", "sh", "bash", "rust"}
# The test that runs the blocks of a document in a language. It must contain the document's name.
RUN_BY = {
    ("README.md", "c"): "tests/docs/docs.py",
    ("README.md", "python"): "tests/docs/docs.py",
    ("docs/tutorial.md", "c"): "tests/docs/docs.py",
    ("docs/tutorial.md", "python"): "docs/tutorial_pictures.py",
    ("docs/cookbook.md", "python"): "docs/cookbook_pictures.py",
    ("docs/python.md", "python"): "tests/python/test_packaging.py",
    ("bindings/rust/hrbfnpr-sys/README.md", "rust"): "tests/clients/rust.py",
}
# The test that runs the blocks below a heading of a document.
SECTIONS = {
    ("docs/python.md", "Many processes"): "tests/python/test_batch.py",
    ("docs/python.md", "Notebooks"): "tests/python/test_notebook.py",
    ("docs/python.md", "Windows of VTK and PyVista"): "tests/python/test_vtk_scene.py",
}
HERE_PYTHON = {
    "docs/csg.md",
    "docs/fields.md",
    "docs/fitting.md",
    "docs/hatching.md",
    "docs/light.md",
    "docs/lines.md",
    "docs/vectors.md",
}
PROGRAMS = set(
    (
        "apt-get blender cc cd cmake cp ctest export g++ git godot3-runner hrbfnpr-view mcs mkdir node npm npx pip"
        " pkg-config python3 sudo xvfb-run"
    ).split()
)


class Block:
    def __init__(self, document, language, code, line, section, excuse):
        self.document, self.language, self.code, self.line = document, language, code, line
        self.section, self.excuse = section, excuse

    def where(self):
        return f"{self.document}:{self.line}"


def blocks_of(root):
    for path in documents(root):
        lines, section, start = path.read_text(encoding="utf-8").splitlines(), "", None
        for number, line in enumerate(lines):
            if start is None and re.match(r"#+ ", line):
                section = line.lstrip("# ")
            fence = re.match(r"\s*```(\w*)", line)
            if fence and start is None:
                start, language = number, fence.group(1)
            elif fence:
                above = next((text for text in reversed(lines[:start]) if text.strip()), "")
                excuse = re.fullmatch(r"<!-- not run: (\S.*) -->", above.strip())
                code = "\n".join(lines[start + 1 : number]) + "\n"
                name = path.relative_to(root).as_posix()
                yield Block(name, language, code, start + 1, section, excuse and excuse.group(1))
                start = None


def reader_of(block):
    """The path of the test that reads a block, or None."""
    name, language = block.document, block.language
    if language in ("sh", "bash"):
        return "tests/docs/snippets.py"
    if language == "c" and (name, language) not in RUN_BY:
        return "tests/docs/snippets.py"
    if language == "python" and name in HERE_PYTHON or (name, language) == ("docs/csharp.md", "csharp"):
        return "tests/docs/snippets.py"
    return RUN_BY.get((name, language)) or SECTIONS.get((name, block.section))


def unknown_blocks(root):
    count = 0
    for block in blocks_of(root):
        if not block.language:
            yield f"{block.where()}: a block of code names its language; text where it has none"
        if block.language not in CHECKED or block.excuse:
            continue
        reader, count = reader_of(block), count + 1
        if reader is None:
            yield (f"{block.where()}: no test reads this block ({block.language}): let tests/docs/snippets.py, or say why not, "
                   "in a line above it: <!-- not run: because ... -->")  # fmt: skip
        elif reader != "tests/docs/snippets.py":
            text = (root / reader).read_text(encoding="utf-8") if (root / reader).is_file() else ""
            if Path(block.document).name not in text:
                yield f"{block.where()}: {reader} should run this block, and does not name {Path(block.document).name}"
    print(f"{count} blocks of code")


def command_lines(code):
    """The commands of a block, with continued lines joined and without comments."""
    for line in re.sub(r"\\\n\s*", " ", code).splitlines():
        words = shlex.split(line, comments=True)
        while words:
            end = next((i for i, word in enumerate(words) if word in ("&&", "||", "|", ";")), len(words))
            command = [word for word in words[:end]]
            while command and re.match(r"\w+=", command[0]):
                command.pop(0)
            if command:
                yield command
            words = words[end + 1 :]


def wrong_command(root, folder, words):
    """The error of a command in words, or None."""
    program = words[0]
    if words[:3] == ["python3", "-m", "hrbfnpr"]:
        from hrbfnpr.cli import _grammar

        said = io.StringIO()
        try:
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
                _grammar.build().parse_args(words[3:])
        except SystemExit as end:
            return said.getvalue().strip().splitlines()[-1] if end.code else None
        return None
    if program in ("python3", "node") and len(words) > 1 and re.search(r"\.(py|m?js)$", words[1]):
        program = words[1]
    if "/" in program and not program.startswith(("/", "build/", "$", "~")):
        return None if any((base / program).exists() for base in (root, folder)) else f"there is no {program}"
    known = program in PROGRAMS or "/" in program
    return None if known else f"{program} is not known to be a program: add it to PROGRAMS of tests/docs/snippets.py"


def wrong_commands(root):
    skip_without("cffi", "numpy")
    count = 0
    for block in blocks_of(root):
        if block.language not in ("sh", "bash") or block.excuse:
            continue
        for words in command_lines(block.code):
            count += 1
            why = wrong_command(root, (root / block.document).parent, words)
            if why:
                yield f"{block.where()}: {shlex.join(words)[:100]}: {why}"
    print(f"{count} commands")


def wrong_c(root, compiler):
    """All blocks of C are compiled at once, each as a file."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for block in blocks_of(root):
            if block.language == "c" and not block.excuse:
                files.append(Path(folder) / f"{block.document.replace('/', '_')}_{block.line}.c")
                files[-1].write_text(block.code)
        warnings = ["-std=c99", "-Wall", "-Wextra", "-Wno-missing-prototypes", "-Werror"]
        command = [compiler, *warnings, "-fsyntax-only", f"-I{root / 'include'}", *map(str, files)]
        run = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(f"{len(files)} blocks of C")
        if run.returncode != 0 or not files:
            yield f"blocks of C do not compile:\n{run.stdout}"


def names_for_python(hrbfnpr, np):
    """The variables that blocks with a single call use."""
    ring, open_sheet = hrbfnpr.datasets.torus(300), hrbfnpr.datasets.terrain(200)
    mesh = hrbfnpr.datasets.torus(60, mesh=True)
    model = hrbfnpr.Model.fit(ring.points, ring.normals)
    marks = model.generate(preset="contour-and-stipple", budget=2000)
    return {
        "hrbfnpr": hrbfnpr, "np": np, "points": open_sheet.points, "normals": open_sheet.normals, "model": model,
        "vertices": mesh.points, "triangles": mesh.triangles, "marks": marks, "style": hrbfnpr.Style("contour-and-stipple"),
        "camera": hrbfnpr.Camera.fit(model, size=(120, 120)),
    }  # fmt: skip


def wrong_python(root):
    skip_without("cffi", "numpy", "PIL")
    import numpy as np

    import hrbfnpr
    from hrbfnpr import _script

    count = 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for block in blocks_of(root):
            if block.language != "python" or block.excuse or block.document not in HERE_PYTHON:
                continue
            count += 1
            try:
                if block.code.startswith("# ") and block.code.splitlines()[0].endswith(".csg"):
                    _script.run(block.code, load=None)
                else:
                    exec(compile(block.code, block.document, "exec"), names_for_python(hrbfnpr, np))
            except Exception as error:  # every exception of a block is a finding
                yield f"{block.where()}: {type(error).__name__}: {error}"
        os.chdir(root)
    print(f"{count} blocks of Python")


CSHARP = """using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using HrbfNpr;

public static class Snippet%d
{
    static double[] points, normals, positions, values;
    static int[] triangles;
    static Model model;
    static PointSet marks;
    static Renderer renderer;
    static Item[] items;
    static Camera camera;
    static byte[] pixels;
    static float[] floats;
    static uint[] ids;
    static int width, height, x, y;
    static Drawing front, side;
    static IProgress<double> progress;
    static CancellationToken token;

    public static async Task Run()
    {
        await Task.Yield();
%s    }
}
"""


def wrong_csharp(root):
    compiler = shutil.which("mcs")
    if compiler is None:
        print("skipped: there is no mcs here (Debian: mono-mcs)")
        sys.exit(SKIPPED)
    found = [block for block in blocks_of(root) if block.document == "docs/csharp.md" and block.language == "csharp"]
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, block in enumerate(one for one in found if not one.excuse):
            code = re.sub(r"^using HrbfNpr;\n", "", block.code, flags=re.MULTILINE)
            files.append(Path(folder) / f"csharp_md_{block.line}.cs")
            files[-1].write_text(CSHARP % (number, code))
        sources = sorted((root / "bindings/csharp/HrbfNpr").rglob("*.cs"))
        sources = [path for path in sources if not {"bin", "obj"} & set(path.parts)]
        command = [compiler, "-langversion:7.2", "-unsafe", "-target:library", f"-out:{folder}/snippets.dll"]
        run = subprocess.run([*command, *map(str, sources), *map(str, files)], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)  # fmt: skip
        print(f"{len(files)} blocks of C#")
        if run.returncode != 0 or not files:
            errors = [line for line in run.stdout.splitlines() if "error" in line]
            yield "blocks of docs/csharp.md do not compile:\n" + "\n".join(errors)


CHECKS = {"all": unknown_blocks, "commands": wrong_commands, "c": wrong_c, "python": wrong_python, "csharp": wrong_csharp}


def main():
    root = Path(sys.argv[2]).resolve()
    findings = list(CHECKS[sys.argv[1]](root, *sys.argv[3:]))
    print("\n".join(findings) if findings else f"{sys.argv[1]}: as it should be")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
