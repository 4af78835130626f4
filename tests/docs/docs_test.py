# SPDX-License-Identifier: MIT
"""The checks of docs.py and snippets.py pass on small correct documents, and find the errors in others."""

import shutil
import tempfile
import unittest
from pathlib import Path

import docs
import reliability
import snippets

README = """# The title

See [below](#the-end), [the words](docs/glossary.md#references), <img src="docs/a.png"> and [afar](https://a.example/b).

```text
[not a link](nowhere.md)
```

## The end

`hrbfnpr_camera_...` set up an `hrbfnpr_camera`, whose `hrbfnpr_camera.view` is one of `HRBFNPR_VIEW_...`, as
`HRBFNPR_VIEW_FRONT`. `HRBFNPR_LIBRARY` says where the library is, `HRBFNPR_TESTS` builds `tests/` and `base/memory`,
and `hrbfnpr_declared.h` declares it.
"""
GLOSSARY = """# Glossary

A name in brackets, as [Hart 1996].

- **ABI**, here: what may not change.
- **b\u00eate**, or beast, here: ours, though [Hart 1996] has it too.
- **ray**: a half line. [Hart 1996, 2.1]

## References

- **Hart 1996**: J. C. Hart. Sphere tracing.
"""
PRESETS = """# The named styles

## x-ray

<img src="images/presets/x-ray.png">

```sh
draw a.ply --style x-ray --size 480
```
"""
FILES = {
    "README.md": README,
    "docs/glossary.md": GLOSSARY,
    "docs/a.png": "",
    "docs/presets.md": PRESETS,
    "docs/images/presets/x-ray.png": "a picture",
    "include/hrbfnpr.h": "enum { HRBFNPR_PRESET_X_RAY = 0 };",
    "CMakeLists.txt": "option(HRBFNPR_TESTS)",
    "tests/CMakeLists.txt": "",
    "src/base/memory.h": "",
    "bindings/api.json": '{"structs": [{"name": "hrbfnpr_camera", "fields": [{"name": "view"}]}],'
                         ' "functions": ["hrbfnpr_camera_init"], "constants": ["HRBFNPR_VIEW_FRONT"]}',
    "bindings/load.py": 'os.environ.get("HRBFNPR_LIBRARY")',
    "bindings/hrbfnpr_declared.h": "",
}

# check, file, text to replace, replacement
BREAKS = [
    ("links", "README.md", "docs/a.png", "docs/b.png"),
    ("links", "README.md", "docs/glossary.md#", "docs/glossaries.md#"),
    ("links", "README.md", "#references", "#reference"),
    ("links", "README.md", "(#the-end)", "(#end)"),
    ("glossary", "docs/glossary.md", "- **ABI**", "- **Zebra**"),
    ("glossary", "docs/glossary.md", "- **b\u00eate**, or beast", "- **ABI**"),
    ("glossary", "docs/glossary.md", ", here: what", ": what"),
    ("glossary", "docs/glossary.md", "- **ABI**, here: what", "- **ABI** here: what"),
    ("glossary", "docs/glossary.md", "change.", "change\n  or may."),
    ("glossary", "docs/glossary.md", " [Hart 1996, 2.1]", ""),
    ("glossary", "docs/glossary.md", "[Hart 1996, 2.1]", "[Hart 1997]"),
    ("glossary", "docs/glossary.md", "- **Hart", "- **Anon 1900**: Work.\n- **Hart"),
    ("glossary", "docs/glossary.md", "## References", "## Works"),
    ("names", "README.md", "`hrbfnpr_camera_...", "`hrbfnpr_kamera_..."),
    ("names", "README.md", "an `hrbfnpr_camera`", "an `hrbfnpr_kamera`"),
    ("names", "README.md", "camera.view", "camera.vista"),
    ("names", "README.md", "VIEW_...", "VISTA_..."),
    ("names", "README.md", "VIEW_FRONT", "VIEW_BACK"),
    ("names", "README.md", "HRBFNPR_LIBRARY", "HRBFNPR_BOOKS"),
    ("names", "README.md", "HRBFNPR_TESTS", "HRBFNPR_TRIALS"),
    ("names", "README.md", "`tests/`", "`tests/base`"),
    ("names", "README.md", "`base/memory`", "`base/recall`"),
    ("names", "README.md", "hrbfnpr_declared", "hrbfnpr_undeclared"),
    ("presets", "docs/presets.md", "## x-ray", "## xray"),
    ("presets", "docs/presets.md", "presets/x-ray", "presets/xray"),
    ("presets", "docs/presets.md", "--style x-ray", "--style xray"),
    ("presets", "docs/images/presets/x-ray.png", "a picture", ""),
    ("presets", "include/hrbfnpr.h", "PRESET_X_RAY = 0", "PRESET_XRAY = 0"),
    ("presets", "include/hrbfnpr.h", "= 0", "= 0, HRBFNPR_PRESET_WASH = 1"),
    ("presets", "include/hrbfnpr.h", "PRESET", "PRE"),
    ("pictures", "docs/images/presets/x-ray.png", "a picture", "a" * 250_001),
    ("readme", "README.md", "afar", "afar " * 1400),
    ("pictures", "docs/presets.md", 'src="images/presets/x-ray.png"', 'src="images/presets/xray.png"'),
    ("names", "docs/glossary.md", "change.", "change, such as hrbfnpr_invented."),
]


class Documents(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        for name, text in FILES.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding="utf-8")

    def tearDown(self):
        self.folder.cleanup()

    def test_correct_documents_pass(self):
        for check in ("links", "glossary", "names", "presets", "pictures"):
            with self.subTest(check=check):
                self.assertEqual(list(docs.CHECKS[check](self.root)), [])

    def test_each_break_is_found(self):
        for check, name, before, after in BREAKS:
            with self.subTest(check=check, after=after):
                path = self.root / name
                text = path.read_text(encoding="utf-8")
                self.assertIn(before, text)
                path.write_text(text.replace(before, after, 1), encoding="utf-8")
                self.assertNotEqual(list(docs.CHECKS[check](self.root)), [])
                path.write_text(text, encoding="utf-8")

    def findings(self, check, text):
        (self.root / "README.md").write_text(text, encoding="utf-8")
        (self.root / "scripts").mkdir(exist_ok=True)
        (self.root / "scripts" / "draw").write_text("")
        return [found for found in snippets.CHECKS[check](self.root) if found.startswith("README.md")]

    def test_each_block_has_a_test_or_an_excuse(self):
        block = "```cpp\nint main() {}\n```\n"
        self.assertEqual(self.findings("all", "# T\n\n<!-- not run: it is a sketch -->\n" + block), [])
        self.assertNotEqual(self.findings("all", "# T\n\n" + block), [])  # the test for README.md is not in this folder
        self.assertNotEqual(self.findings("all", "# T\n\n<!-- not run: -->\n" + block), [])
        self.assertNotEqual(self.findings("all", "# T\n\n```\nno language\n```\n"), [])

    def test_wrong_commands_are_found(self):
        try:
            import hrbfnpr.cli  # noqa: F401
        except ImportError:
            self.skipTest("no hrbfnpr, cffi or numpy")
        right = ("scripts/draw --style x  # a comment", "A=b python3 -m hrbfnpr draw a.ply b.png --style hatch && cmake .",
                 "python3 -m hrbfnpr draw a.ply b.png \\\n  --size 400")  # fmt: skip
        wrong = ("scripts/drawn", "python3 -m hrbfnpr draw a.ply b.png --stile hatch", "cmake . && nosuchprogram a",
                 "python3 -m hrbfnpr paint a.ply", "python3 -m hrbfnpr draw a.ply b.png \\\n  --siz X")  # fmt: skip
        for command in (*right, *wrong):
            with self.subTest(command=command):
                found = self.findings("commands", f"# T\n\n```sh\n{command}\n```\n")
                self.assertEqual(len(found), command in wrong)

    def test_c_that_does_not_compile_is_found(self):
        compiler = shutil.which("cc") or shutil.which("gcc")
        if compiler is None:
            self.skipTest("no C compiler")
        (self.root / "README.md").write_text("# T\n\n```c\nint f(void) { return 1; }\n```\n", encoding="utf-8")
        self.assertEqual(list(snippets.wrong_c(self.root, compiler)), [])
        (self.root / "README.md").write_text("# T\n\n```c\nint f(void) { return g(); }\n```\n", encoding="utf-8")
        self.assertNotEqual(list(snippets.wrong_c(self.root, compiler)), [])

    def test_commands_that_run_nothing_are_found(self):
        row = "| it holds | `a.B` | 3 | {} |\n"
        table = "| promise | test | cases | command |\n|---|---|---|---|\n"
        self.assertEqual(list(reliability.commands(table + row.format("`a --x='p*'`; later `b c`"))), ["a --x='p*'", "b c"])
        script = self.root / "scripts" / "run"
        script.parent.mkdir(exist_ok=True)
        script.write_text("", encoding="utf-8")
        for command, wrong in (("scripts/run --all", False), ("scripts/walk", True), ("soak tests", True), ("ls", True)):
            with self.subTest(command=command):
                self.assertEqual(reliability.fault(command, self.root, self.root) is not None, wrong)
        program = self.root / "tests" / "b" / "test_b"
        program.parent.mkdir(parents=True)
        program.write_text('#!/bin/sh\n[ "$2" != "--gtest_filter=A.*" ] || printf "A.\\n  One\\n"\n', encoding="utf-8")
        program.chmod(0o755)
        self.assertIsNone(reliability.fault("test_b --gtest_filter='A.*'", self.root, self.root))
        self.assertIsNotNone(reliability.fault("test_b --gtest_filter=B.*", self.root, self.root))


if __name__ == "__main__":
    unittest.main()
