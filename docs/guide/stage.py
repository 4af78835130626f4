# SPDX-License-Identifier: MIT
"""Puts the pages of the guide together in a folder for Sphinx: the pages of docs/, and a page of every symbol.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so stage.py FOLDER

The pages of docs/ are Markdown for a forge.  In the copies, HTML images become Sphinx's images, and links to files that are
not pages become plain text.
"""

import json
import re
import shutil
import sys
from pathlib import Path

import c_reference
import csharp_reference
import python_reference

import hrbfnpr

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Pages from outside docs/, and their names in the guide.
OTHERS = {
    "CONTRIBUTING.md": "contributing", "SECURITY.md": "security", "CHANGELOG.md": "changelog", "examples/README.md": "examples",
}  # fmt: skip
QUICKSTARTS = (("c", "C", "c"), ("cpp", "C++", "cpp"), ("csharp", "C#", "cs"))


def figure(match):
    """Turns HTML images into Sphinx's images, which are copied into the guide.  Several images in one paragraph become tiles."""
    tags = [dict(re.findall(r'(\w+)="([^"]*)"', tag)) for tag in re.findall(r"<img [^>]*>", match.group(0))]
    if len(tags) > 1:
        tiles = "\n".join(f"![{of.get('alt', '')}]({of['src']})" for of in tags)
        return f":::{{container}} tiles\n{tiles}\n:::"
    made = ""
    for of in tags:
        width = f":width: {of['width']}px\n" if of.get("width", "").isdigit() else ""
        alt = json.dumps(of.get("alt", ""), ensure_ascii=False)
        made += f"\n```{{image}} {of['src']}\n:alt: {alt}\n{width}:align: center\n```\n"
    return made


def title_of(page):
    return re.search(r"^# (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE).group(1)


def relink(text, page, names):
    """Turns links to pages into links to their names in the guide, and links to other files of the project into text."""

    def one(match):
        label, link = match.groups()
        if "://" in link or link.startswith(("#", "mailto:")):
            return match.group(0)
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve()
        relative = target.relative_to(ROOT).as_posix() if target.is_relative_to(ROOT) else ""
        if relative in names:
            label = title_of(target) if label.endswith(".md") else label
            return f"[{label}]({names[relative]}.md{'#' + anchor if anchor else ''})"
        if relative == "include/hrbfnpr.h":
            return f"[{label}](c/index.rst)"
        if relative == "README.md":
            return f"[{label}](index.md)"
        return label if "`" in label else f"`{label}`" if "/" in label else f"{label} (`{relative}`)"

    return re.sub(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", one, text)


def outside_code(change, text):
    """Applies `change` to everything except blocks of code."""
    parts = re.split(r"(^```.*?^```$)", text, flags=re.DOTALL | re.MULTILINE)
    return "".join(part if part.startswith("```") else change(part) for part in parts)


def staged(path, names):
    def change(text):
        text = relink(text, path, names)
        text = re.sub(r"^ *<!-- not run: .* -->\n", "", text, flags=re.MULTILINE)
        return re.sub(r"^<p align=\"center\">\s*(?:<a [^>]*>)?<img .*?</p>$", figure, text, flags=re.DOTALL | re.MULTILINE)

    return outside_code(change, path.read_text(encoding="utf-8"))


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def index(names):
    """The first page: README.md and the lists of contents.  Pages that no list names are added to the end of the how-to list."""
    lists = (HERE / "index.md").read_text(encoding="utf-8")
    left = sorted(name for name in names.values() if not re.search(rf"^{re.escape(name)}$", lists, re.MULTILINE))
    lists = lists.replace("\nbuilding\n", "\n" + "\n".join(["building", *left]) + "\n")
    return staged(ROOT / "README.md", names).replace("docs/images/", "images/") + "\n" + lists


def quickstarts(target):
    """Writes the pages of the quick starts in other languages."""
    for file, language, suffix in QUICKSTARTS:
        shutil.copy(ROOT / f"examples/quickstart.{suffix}", target)
        shown = f"```{{literalinclude}} quickstart.{suffix}\n:language: {file}\n:lines: 2-\n```\n"
        about = f"# Quick start in {language}\n\nA torus of 192 samples, as on the [first page](index.md).\n\n"
        write(target / f"quickstart-{file}.md", about + shown)


def main():
    target = Path(sys.argv[1]).resolve()
    if target.exists() and not (target / "conf.py").is_file():
        raise SystemExit(f"stage.py: {target} is not a folder that stage.py made: name a new one")
    shutil.rmtree(target, ignore_errors=True)  # also removes pages that no longer exist
    target.mkdir(parents=True)
    shutil.copy(HERE / "conf.py", target)
    names = {path.relative_to(ROOT).as_posix(): path.stem for path in (ROOT / "docs").glob("*.md")}
    names.update(OTHERS)
    for relative, name in names.items():
        write(target / f"{name}.md", staged(ROOT / relative, names))
    shutil.copytree(ROOT / "docs/images", target / "images")
    shutil.copytree(HERE / "static", target / "static")
    quickstarts(target)
    write(target / "index.md", index(names))
    for name, text in c_reference.pages(ROOT / "bindings/api.json"):
        write(target / "c" / f"{name}.rst", text)
    for name, text in python_reference.pages(hrbfnpr):
        write(target / "python" / f"{name}.rst", text)
    write(target / "reference-csharp.md", csharp_reference.page(ROOT / "bindings/csharp/HrbfNpr"))


if __name__ == "__main__":
    main()
