# SPDX-License-Identifier: MIT
"""Checks of docs.py pass on small documents that are right, and find what is wrong with others."""

import tempfile
import unittest
from pathlib import Path

import docs

README = """# The title

See [below](#the-end), [the words](docs/glossary.md#references), <img src="docs/a.png"> and [afar](https://a.example/b).

```
[not a link](nowhere.md)
```

## The end
"""
GLOSSARY = """# Glossary

A name in brackets, as [Hart 1996].

- **ABI**, here: what may not change.
- **b\u00eate**, or beast, here: ours, though [Hart 1996] has it too.
- **ray**: a half line. [Hart 1996, 2.1]

## References

- **Hart 1996**: J. C. Hart. Sphere tracing.
"""

# check, file, what is replaced, by what
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
]


class Documents(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        (self.root / "docs").mkdir()
        (self.root / "docs/a.png").write_bytes(b"")
        (self.root / "README.md").write_text(README, encoding="utf-8")
        (self.root / "docs/glossary.md").write_text(GLOSSARY, encoding="utf-8")

    def tearDown(self):
        self.folder.cleanup()

    def test_right_documents_pass(self):
        for check in ("links", "glossary"):
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


if __name__ == "__main__":
    unittest.main()
