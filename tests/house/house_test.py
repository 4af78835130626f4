# SPDX-License-Identifier: MIT
"""Each check of house.py passes on a small clean house and fails on each way to break it."""

import shutil
import tempfile
import unittest
from pathlib import Path

import house
import spdx

MIT = "SPDX-License-Identifier: " + "MIT"
CLEAN = {
    "CMakeLists.txt": "project(x VERSION ${version})\n",
    "CMakePresets.json": "{}\n",
    "include/hrbfnpr.h": "HRBFNPR_VERSION_MAJOR = 7, HRBFNPR_VERSION_MINOR = 8, HRBFNPR_VERSION_PATCH = 9,\n"
    "HRBFNPR_ABI_VERSION = 3\n",
    "src/hrbfnpr.map.in": "HRBFNPR_@HRBFNPR_ABI_VERSION@ {\n};\n",
    "CHANGELOG.md": "## [7.8.9]\n",
    "docs/others.md": "eigen-17.8.9, highway-7.8.90\n",
    "src/base/status.h": "#pragma once\n",
    "src/base/parallel_openmp.cpp": '#include "base/status.h"\n#pragma omp parallel for\n',
    "src/implicit/implicit.h": '#pragma once\n#include "base/status.h"\n',
    "src/fit/fit.h": '#pragma once\n#include "implicit/implicit.h"\n#include <Eigen/Dense>\n',
    "src/fit/fit.cpp": '#include "fit.h"\n',
    "src/surface/project.h": '#pragma once\n#include "implicit/implicit.h"\n',
    "src/frame/scene/scene.h": "#pragma once\n",
    "src/published/classify.h": '#pragma once\n#include "frame/scene/scene.h"\n',
    "src/frame/lines/strokes.h": '#pragma once\n#include "frame/scene/scene.h"\n',
    "src/frame/frame.h": '#pragma once\n#include "published/classify.h"\n',
    "src/output/raster/draw.h": "#pragma once\n",
    "src/output/vertex/vertices.h": "#pragma once\n",
    "src/api/model.cpp": '#include "fit/fit.h"\n#include "output/raster/draw.h"\n\n#include <hrbfnpr.h>\n',
}

# check, file, text that breaks the check
BREAKS = [
    ("floors", "src/base/status.h", '#include "implicit/implicit.h"\n'),
    ("floors", "src/fit/fit.cpp", '#include "surface/project.h"\n'),
    ("floors", "src/output/vertex/vertices.h", '#include "output/raster/draw.h"\n'),
    ("floors", "src/frame/scene/scene.h", '#include "frame/frame.h"\n'),
    ("floors", "src/frame/scene/scene.h", '#include "published/classify.h"\n'),
    ("floors", "src/frame/depth_layers/ink.h", '#include "frame/lines/strokes.h"\n'),
    ("floors", "src/published/classify.h", '#include "frame/lines/strokes.h"\n'),
    ("floors", "src/surface/project.h", '  #  include "api/model.h"\n'),
    ("floors", "src/surface/project.h", '#include "../base/status.h"\n'),
    ("floors", "src/surface/project.h", "#include <hrbfnpr.h>\n"),
    ("floors", "src/surface/project.h", "#include <Eigen/Core>\n"),
    ("floors", "src/attic/ghost.cpp", "int ghost;\n"),
    ("floors", "src/ghost.cpp", "int ghost;\n"),
    ("openmp", "src/fit/fit.cpp", "#pragma omp parallel\n"),
    ("openmp", "src/fit/fit.cpp", "#include <omp.h>\n"),
    ("openmp", "src/fit/fit.cpp", "int n = omp_get_max_threads();\n"),
    ("forbidden", "src/fit/fit.cpp", "thread_local int scratch;\n"),
    ("forbidden", "src/fit/fit.cpp", "std::mt19937_64 engine;\n"),
    ("forbidden", "src/fit/fit.cpp", "std::random_device device;\n"),
    ("forbidden", "src/fit/fit.cpp", "int r = std::rand();\n"),
    ("forbidden", "src/fit/fit.cpp", "int r = rand();\n"),
    ("forbidden", "CMakeLists.txt", "add_compile_options(-march=" + "native)\n"),
    ("forbidden", "CMakePresets.json", '"-ffast' + '-math"\n'),
    ("namespaces", "tests/fit/new_test.cpp", "namespace {\n}\n"),
    ("sizes", "src/fit/fit.cpp", "\n" * house.LONGEST_FILE),
    ("sizes", "bindings/csharp/Model.cs", "\n" * (house.LONGEST_FILE + 1)),
    ("version", "CMakeLists.txt", "set(HRBFNPR_ABI_VERSION 3)\n"),
    ("version", "include/hrbfnpr.h", "HRBFNPR_VERSION_MINOR = 2\n"),
    ("version", "src/hrbfnpr.map.in", "HRBFNPR_3 {\n};\n"),
    ("version", "docs/new.md", "pip install hrbfnpr-7.8.9.whl\n"),
    ("version", ".github/workflows/new.yml", "run: test -e libhrbfnpr.so.3.7.8.9\n"),
    ("spdx", "src/fit/new.cpp", "int a;\n"),
    ("spdx", "src/base/CMakeLists.txt", "add_library(base)\n"),
    ("spdx", "scripts/new", "#!/usr/bin/env bash\nset -e\n"),
    ("spdx", "bindings/new.py", "\n" * spdx.FIRST_LINES + f"# {MIT}\n"),
    ("spdx", "bindings/new.h", "// Made by make_new.py; do not edit.\n"),
    ("format", "src/fit/fit.cpp", "int   a ;\n"),
    ("words", "src/fit/fit.cpp", "// Of a closed one the first.\nint a;\n"),
    ("words", "src/fit/fit.cpp", "int a; // what is no number\n"),
    ("words", "src/fit/fit.h", "// The sides, of which\n// there are so many.\nint a;\n"),
    ("words", "src/base/base.h", "int a; // the first ...\nint b; // ... and the last\n"),
    ("words", "src/fit/fit.cpp", "/*\n * The first.\n *\n * Of the others none.\n */\nint a;\n"),
    ("words", "tests/new.py", '"""Of a closed one the first."""\n'),
    ("words", "tests/new.py", 'def f():\n    """The first.\n\n    Of the others none.\n    """\n'),
    ("words", "bench/new.py", "a = 1  # what is left\n"),
    ("words", "docs/new.py", "def f():\n    # Nobody sees\n    # these lines.\n    pass\n"),
    ("words", "scripts/new", "#!/usr/bin/env python3\n# so many\n"),
    ("words", "scripts/new", "#!/usr/bin/env bash\nset -e # what is left\n"),
    ("spdx", ".github/workflows/new.yml", "name: new\n"),
    ("words", ".github/workflows/new.yml", "name: new # what is left\n"),
    ("words", "scripts/new.sh", "# The sides, of which\n# there are so many.\n"),
    ("words", "cmake/New.cmake", "set(A 1) # Of all\n"),
    ("words", "CMakeLists.txt", "# Whoever links it.\n"),
    ("words", "src/base/CMakeLists.txt", "# Whoever links it.\n"),
    ("words", "tests/New.cs", "/// <summary>What is <c>left</c>.</summary>\nclass A {}\n"),
    ("words", "tests/New.cs", "class A {} // nobody\n"),
    ("words", "bindings/new.pyi", "def f(): ...  # what is left\n"),
    ("words", "bindings/csharp/New.cs", "/// <summary>\n/// Of all.\n/// </summary>\nclass A {}\n"),
    ("words", "bindings/js/new.d.ts", "/** What is left. */\nexport {};\n"),
    ("words", "examples/new.js", "/** Of all points. */\nlet a;\n"),
    ("words", "examples/new.mjs", "let a; // so much\n"),
]

# Files that the check of comments accepts: strings, usage lines, generated files, data.
PLAIN = {
    "tests/string.py": 'a = "# so many"\nb = """Of all\n# so many\n"""\n',
    "tests/usage.py": '"""Reads files.\n\n    usage.py LIBRARY FILE...\n"""\n',
    "tests/usage.cs": 'class A { string a = "http://nobody"; }\n',
    "scripts/usage": "#!/bin/sh\n#   usage [FILE...]\necho '# so many' ${#a}\n",
    "examples/made.js": "// Made by make.py from a.h; do not edit.\n// What is left.\n",
    "examples/so_many.txt": "# so many\n",
    "tests/corpus/so_many": "# so many\n",
}


class House(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        for name, text in CLEAN.items():
            plain = spdx.comment_of(Path(name), text) is None
            self.write(name, text if plain else spdx.with_line(Path(name), text))

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as file:
            file.write(text)

    def findings(self, check):
        if check == "format" and shutil.which("clang-format-14") is None:
            self.skipTest("there is no clang-format-14 here")
        return list(house.CHECKS[check](self.root))

    def test_a_clean_house_passes(self):
        for check in sorted(house.CHECKS.keys() - {"format"}):
            with self.subTest(check=check):
                self.assertEqual(self.findings(check), [])

    def test_each_break_is_found(self):
        for check, name, text in BREAKS:
            with self.subTest(check=check, file=name, text=text[:60]):
                self.tearDown()
                self.setUp()
                before = self.findings(check)
                self.write(name, text)
                self.assertEqual(before, [])
                self.assertNotEqual(self.findings(check), [])

    def test_comments_are_told_from_other_text(self):
        for name, text in PLAIN.items():
            self.write(name, text)
        (self.root / "tests/corpus/bytes").write_bytes(b"#!\xff so many")
        self.assertEqual(self.findings("words"), [])

    def test_the_openmp_check_fails_if_it_finds_no_openmp_at_all(self):
        (self.root / "src/base/parallel_openmp.cpp").write_text("// nothing\n")
        self.assertNotEqual(self.findings("openmp"), [])

    def test_an_empty_project_fails(self):
        shutil.rmtree(self.root / "src")
        self.assertNotEqual(self.findings("floors"), [])
        for name in ("include", "CMakeLists.txt"):
            path = self.root / name
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        self.assertNotEqual(self.findings("spdx"), [])


# file, its contents, its contents with the licence line
LICENCES = [
    ("src/a.cpp", "int a;\n", f"// {MIT}\nint a;\n"),
    ("src/a.h", "/* A. */\n", f"/* {MIT} */\n/* A. */\n"),
    ("src/a.c", "int a;\r\n", f"/* {MIT} */\r\nint a;\r\n"),
    ("src/empty.h", "", f"// {MIT}\n"),
    ("bindings/a.cs", "\ufeffclass A {}\n", f"\ufeff// {MIT}\nclass A {{}}\n"),
    ("bindings/a.py", "#!/usr/bin/env python3\n# -*- coding: utf-8 -*-\n\"\"\"A.\"\"\"\n",
     f"#!/usr/bin/env python3\n# -*- coding: utf-8 -*-\n# {MIT}\n\"\"\"A.\"\"\"\n"),
    ("examples/a.lua", "return 1\n", f"-- {MIT}\nreturn 1\n"),
    ("tests/a.js", "#!/usr/bin/env node\n'use strict'\n", f"#!/usr/bin/env node\n// {MIT}\n'use strict'\n"),
    ("cmake/a.cmake", "return()\n", f"# {MIT}\nreturn()\n"),
    ("scripts/a", "#!/bin/sh", f"#!/bin/sh\n# {MIT}\n"),
    # These files are left alone: data, a file with a licence, a generated file, a build tree.
    ("tests/corpus/a", "#!data\n", "#!data\n"),
    ("docs/a.md", "# A\n", "# A\n"),
    ("src/b.cpp", f"// B.\n// {MIT}\n", f"// B.\n// {MIT}\n"),
    ("bindings/made.h", "/* Made by make.py from a.h; do not edit. */\n", "/* Made by make.py from a.h; do not edit. */\n"),
    ("bindings/build/a.py", "a = 1\n", "a = 1\n"),
]


class Licence(unittest.TestCase):
    def test_the_licence_line_is_put_in_the_right_place(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, before, _ in LICENCES:
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_bytes(before.encode("utf-8"))
            (root / "tests/corpus/bytes").write_bytes(b"#!\xff\xfe")
            changed, left = spdx.fix(root)
            self.assertEqual(sorted(changed), sorted(name for name, before, after in LICENCES if before != after))
            self.assertEqual(left, ["bindings/made.h"])
            for name, _, after in LICENCES:
                with self.subTest(file=name):
                    self.assertEqual((root / name).read_bytes().decode("utf-8"), after)
            self.assertEqual(spdx.fix(root), ([], left))
            self.assertEqual([found.split()[0] for found in spdx.missing(root)], left)


if __name__ == "__main__":
    unittest.main()
