# SPDX-License-Identifier: MIT
"""Checks the documents against the project.

    docs.py links ROOT                      links to files of the project and to their headings are valid
    docs.py glossary ROOT                   docs/glossary.md is sorted; each entry cites a listed work or is marked as ours
    docs.py names ROOT                      names of the C interface, of the build and of files exist
    docs.py presets ROOT                    docs/presets.md has a section and a picture for each named style of the header
    docs.py pictures ROOT                   pictures in docs/images are small, and a document shows each of them
    docs.py readme ROOT                     README.md can be read in five minutes
    docs.py versions ROOT                   CHANGELOG.md has a section for the header's version
    docs.py quickstart ROOT FILE [PROGRAM...]
        PROGRAM (for a .py, the file itself) leaves a drawing in the current folder. README.md contains quickstart.c
        and quickstart.py to the letter, except the licence line; docs/tutorial.md contains steps.c
    docs.py agree ROOT PROGRAM...           the programs and Python write the same torus.svg from the same samples
    docs.py tutorial ROOT                   the code of docs/tutorial.md runs, and draws the committed pictures
    docs.py cookbook ROOT                   the same for docs/cookbook.md
    docs.py guide ROOT FOLDER               Sphinx builds the guide without a warning, such as a broken link
"""

import importlib.util
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import unicodedata
from pathlib import Path

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
LARGEST = {".png": 250_000, ".gif": 1_000_000}  # bytes of a picture
LANGUAGES = {".c": "c", ".py": "python"}
LISTED_IN = {"quickstart.c": "README.md", "quickstart.py": "README.md", "steps.c": "docs/tutorial.md"}
LONGEST_README = 7000  # bytes


def documents(root):
    """All documents except docs/guide, which uses Sphinx's syntax. The check `guide` reads that folder."""
    folders = ("*.md", "docs/**/*.md", "bindings/**/README.md", "examples/**/*.md")
    found = {path for folder in folders for path in root.glob(folder) if "build" not in path.relative_to(root).parts}
    return sorted(path for path in found if path.parent != root / "docs/guide")


def prose(document):
    """The text of a document without its code blocks."""
    return re.sub(r"^```.*?^```$", "", document.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def anchors(document):
    """The anchors of a document's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ +(.+?) *$", prose(document), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(root):
    for document in documents(root):
        for found in re.findall(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"", prose(document)):
            link = found[0] or found[1]
            if "://" in link or link.startswith("mailto:"):
                continue
            name, _, anchor = link.partition("#")
            target = document.parent / name if name else document
            if not target.exists():
                yield f"{document.relative_to(root)} links to {name}, which is not there"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                yield f"{document.relative_to(root)} links to {link}, but no heading there is called so"


def sort_key(term):
    """A term without accents and in lower case."""
    return unicodedata.normalize("NFD", term).encode("ascii", "ignore").decode().lower()


def glossary_list(text, what):
    """Pairs of a term and its line from one list of the glossary. Errors are appended to `what`."""
    entries = []
    for line in text.splitlines():
        found = re.match(r"- \*\*(.+?)\*\*(?:[:,] |$)", line)
        if found:
            entries.append((found.group(1), line))
        elif line.startswith(("-", "*", " ", "\t")):
            what.append(f"docs/glossary.md: an entry is one line, '- **term**: ...' or '- **term**, here: ...', not: {line}")
    for (before, _), (after, _) in zip(entries, entries[1:]):
        if sort_key(before) >= sort_key(after):
            what.append(f"docs/glossary.md: {after} does not belong behind {before}")
    return entries


def wrong_glossary(root):
    findings = []
    terms, _, references = (root / "docs/glossary.md").read_text(encoding="utf-8").partition("\n## References\n")
    entries, works = glossary_list(terms, findings), dict(glossary_list(references, findings))
    if not entries or not works:
        findings.append("docs/glossary.md has no entries or no references")
    cited = set()
    for term, line in entries:
        names = re.findall(r"\[([^\],]+)(?:, [\d.]+)?\](?!\()", line)
        cited.update(names)
        findings += [f"docs/glossary.md: {term} cites {name}, which is not listed" for name in names if name not in works]
        ours = re.match(r"- \*\*.+?\*\*(?:, [^:]*)?, here: \S", line)
        if not ours and not re.search(r"\]$", line):
            findings.append(f"docs/glossary.md: {term} ends with no [work], and is not defined ', here: '")
    findings += [f"docs/glossary.md lists {work}, which no entry cites" for work in works if work not in cited]
    return findings


def build_names(root):
    """Options, targets and environment variables whose names begin like those of the C interface."""
    for folder in ("", "src/", "examples/**/", "tests/**/"):
        for build in root.glob(f"{folder}CMakeLists.txt"):
            yield from re.findall(r"\b(?:HRBFNPR|hrbfnpr)_\w+", build.read_text(encoding="utf-8"))
    reads = r"(?:environ\.get\(|getenv |var_os\(|GetEnvironmentVariable\()\"(HRBFNPR_\w+)\""
    for folder in ("bindings", "examples", "tests/csharp"):
        for suffix in ("py", "cs", "lua", "rs"):
            for source in root.glob(f"{folder}/**/*.{suffix}"):
                yield from re.findall(reads, source.read_text(encoding="utf-8"))


def wrong_names(root):
    """Names that do not exist. The changelog is not checked, because its older entries name removed things."""
    interface = (root / "bindings/api.json").read_text(encoding="utf-8")
    api = set(re.findall(r"\b(?:HRBFNPR|hrbfnpr)_\w+", interface))
    fields = {struct["name"]: {field["name"] for field in struct["fields"]} for struct in json.loads(interface)["structs"]}
    folders = [path for path in root.iterdir() if path.is_dir() and path.name != "build" and not path.name.startswith(".")]
    tree = [path.name for folder in folders for path in (folder, *folder.rglob("*"))]
    others = set(build_names(root)) | {name.partition(".")[0].replace("-", "_") for name in tree}
    tops = {folder.name: root for folder in folders}
    tops.update({room.name: root / "src" for room in root.glob("src/*/")})
    for document in documents(root):
        name, text = document.relative_to(root), document.read_text(encoding="utf-8")
        if name.name == "CHANGELOG.md":
            continue
        for found in re.finditer(r"\b((?:HRBFNPR|hrbfnpr)_\w*)(?:\.(\w+))?", text):
            word, field = found.groups()
            if word.endswith("_"):
                known = any(entry.startswith(word) for entry in api)
            else:
                known = word in api or word in others
            if not known:
                yield f"{name} says {word}, and nothing is called so"
            elif field and word in fields and field not in fields[word]:
                yield f"{name} says {word}.{field}, and there is no such field"
        if name.parts[0] == "examples":
            continue  # their paths include those of other programs
        for path in re.findall(r"`(\w[\w.-]*/[\w./-]*)`", text):
            top = tops.get(path.partition("/")[0])
            if top and not any((top / (path + suffix)).exists() for suffix in ("", ".h", ".cpp")):
                yield f"{name} says {path}, which is not there"


def wrong_presets(root):
    header = (root / "include/hrbfnpr.h").read_text(encoding="utf-8")
    names = [name.lower().replace("_", "-") for name in re.findall(r"\bHRBFNPR_PRESET_([A-Z0-9_]+) = \d+", header)]
    if not names:
        yield "include/hrbfnpr.h has no presets"
    page = (root / "docs/presets.md").read_text(encoding="utf-8")
    sections = dict(re.findall(r"^## (\S+)\n(.*?)(?=^## |\Z)", page, re.DOTALL | re.MULTILINE))
    pictures = {path.stem: path.stat().st_size for path in (root / "docs/images/presets").glob("*.png")}
    for name in names:
        if name not in sections:
            yield f"docs/presets.md has no section {name}: run bindings/generate"
            continue
        for needed in (f'src="images/presets/{name}.png"', f"--style {name} "):
            if needed not in sections[name]:
                yield f"docs/presets.md: the section {name} lacks {needed}: run bindings/generate"
        if not pictures.get(name):
            yield f"docs/images/presets/{name}.png is not there, or empty: run docs/preset_pictures.py"
    for name in sorted(pictures.keys() - set(names)):
        yield f"docs/images/presets/{name}.png is of no preset"
    if sum(pictures.values()) > 1_500_000:
        yield f"pictures of presets have {sum(pictures.values())} bytes, more than 1.5 MB"


def wrong_pictures(root):
    """Pictures are small, and a document shows each of them."""
    shown = "".join(document.read_text(encoding="utf-8") for document in documents(root))
    for path in sorted(path for path in (root / "docs/images").rglob("*") if path.is_file()):
        name, size = path.relative_to(root / "docs").as_posix(), path.stat().st_size
        if size > LARGEST.get(path.suffix, 0):
            yield f"docs/{name} has {size} bytes, and may have {LARGEST.get(path.suffix, 0)}: draw less, or in fewer colours"
        if name not in shown:
            yield f"docs/{name} is shown by no document"


def wrong_readme(root):
    size = (root / "README.md").stat().st_size
    if size > LONGEST_README:
        yield f"README.md has {size} bytes, and may have {LONGEST_README}: move details to a page in docs/"


def wrong_versions(root):
    header = (root / "include/hrbfnpr.h").read_text(encoding="utf-8")
    parts = (re.search(rf"HRBFNPR_VERSION_{part} = (\d+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
    version = ".".join(part.group(1) for part in parts)
    changelog = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    if f"\n## [{version}]" not in changelog:
        yield f"CHANGELOG.md has no section for {version}"


def code_blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)


def read_ppm(path):
    """Width, height and RGB triples of a binary PPM whose header is one line."""
    header, pixels = path.read_bytes().split(b"\n", 1)
    magic, width, height, depth = header.split()
    if (magic, depth) != (b"P6", b"255") or len(pixels) != 3 * int(width) * int(height):
        raise ValueError(f"{path.name} is not a PPM: {header!r} and {len(pixels)} bytes")
    return int(width), int(height), zip(*[iter(pixels)] * 3)


def ink_share(path):
    """The share of pixels that are not white."""
    if path.suffix == ".ppm":
        width, height, pixels = read_ppm(path)
    else:
        from PIL import Image

        image = Image.open(path).convert("RGB")
        (width, height), pixels = image.size, image.getdata()
    return sum(1 for pixel in pixels if tuple(pixel) != (255, 255, 255)) / (width * height)


def drawn_badly(name, path):
    """The reason why an example's output is not a drawing."""
    if path.suffix == ".svg":
        shapes = len(re.findall(r"<(?:path|circle|polyline)\b", path.read_text(encoding="utf-8")))
        print(f"{name}: {path.name}, {shapes} shapes")
        if shapes < 100:
            yield f"{name}: {path.name} has {shapes} shapes; that is no drawing"
        return
    share = ink_share(path)
    print(f"{name}: {path.name}, {100 * share:.1f} % of the pixels carry ink")
    if not 0.02 < share < 0.8:
        yield f"{name}: a drawing with ink on {100 * share:.1f} % of its pixels is no drawing"


def quickstart(root, name, program):
    example = (root / "examples" / name).read_text(encoding="utf-8")
    document = LISTED_IN.get(name)
    if document:
        blocks = code_blocks((root / document).read_text(encoding="utf-8"), LANGUAGES[Path(name).suffix])
        if re.sub(r"\A.*SPDX-License-Identifier: MIT.*\n", "", example) not in blocks:
            yield f"{document} does not contain examples/{name} to the letter"
    if not program:
        skip_without("cffi", "numpy", "PIL")
    command = program or [sys.executable, str(root / "examples" / name)]
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if result.returncode != 0:
            yield f"{name} failed with {result.returncode}: {result.stdout}"
            return
        drawings = [path for path in Path(folder).iterdir() if path.suffix in (".ppm", ".png", ".svg")]
        if not drawings:
            yield f"{name} leaves no drawing"
        for path in drawings:
            yield from drawn_badly(name, path)


def torus_of_the_quick_starts():
    """The samples of the quick starts, bit for bit. NumPy's sine and cosine would differ in the last bit."""
    points, normals = [], []
    for i in range(192):
        a, b = 6.283185307179586 * (i // 8) / 24, 6.283185307179586 * (i % 8) / 8
        normal = [math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b)]
        normals.append(normal)
        points.append([math.cos(a) + 0.4 * normal[0], math.sin(a) + 0.4 * normal[1], 0.4 * normal[2]])
    return points, normals


def agree(root, programs):
    skip_without("cffi", "numpy", "PIL")
    import numpy as np

    import hrbfnpr

    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "torus.svg"
        points, normals = map(np.array, torus_of_the_quick_starts())
        hrbfnpr.draw((points, normals), "engraving", size=(800, 600)).save(page)
        wanted = page.read_text(encoding="utf-8")
        # The Python call names its source "arrays"; the programs give no name.
        wanted = wanted.replace("<title>arrays</title>\n", "").replace("&quot;arrays&quot;", "&quot;&quot;")
        for program in programs:
            subprocess.run([program], cwd=folder, check=True)
            if page.read_text(encoding="utf-8") != wanted:
                yield f"{program} and Python write different pages of the same samples"


def skip_without(*modules):
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if missing:
        print(f"skipped: {sys.executable} does not have {', '.join(missing)}")
        sys.exit(SKIPPED)


def unlike(picture, committed):
    """The difference of two pictures in size or mean tone (0 to 255) in words, or None if they are alike."""
    from PIL import Image, ImageStat

    images = [Image.open(path).convert("L") for path in (picture, committed)]
    if images[0].size != images[1].size:
        return f"is {images[1].size} pixels large, and the code draws {images[0].size}"
    means = [ImageStat.Stat(image).mean[0] for image in images]
    if abs(means[0] - means[1]) > 3:
        return f"has the mean tone {means[1]:.1f}, and the code draws {means[0]:.1f}"
    if ImageStat.Stat(images[0]).stddev[0] < 5:
        return "is empty"
    return None


def drawn_page(root, name):
    """The code of a page in docs draws exactly the pictures that the page shows and that are committed."""
    shown = set(re.findall(rf'src="images/{name}/([^"]+)"', (root / f"docs/{name}.md").read_text(encoding="utf-8")))
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-B", str(root / f"docs/{name}_pictures.py"), folder]
        result = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(result.stdout)
        if result.returncode != 0:
            yield f"the code of docs/{name}.md failed with {result.returncode}"
            return
        drawn = {path.name for path in Path(folder).iterdir()}
        committed = {path.name for path in (root / f"docs/images/{name}").iterdir()}
        if not shown or not shown == drawn == committed:
            yield f"docs/{name}.md shows {sorted(shown)}, its code draws {sorted(drawn)}, {sorted(committed)} are committed"
        for picture in sorted(drawn & committed):
            why = unlike(Path(folder) / picture, root / f"docs/images/{name}" / picture)
            if why:
                yield f"docs/images/{name}/{picture} {why}: run docs/{name}_pictures.py"


def tutorial(root):
    skip_without("cffi", "numpy", "PIL")
    yield from drawn_page(root, "tutorial")


def cookbook(root):
    skip_without("cffi", "numpy", "PIL")
    if shutil.which("rsvg-convert") is None:
        print("skipped: there is no rsvg-convert here (Debian: librsvg2-bin)")
        sys.exit(SKIPPED)
    yield from drawn_page(root, "cookbook")


def guide(root, folder):
    skip_without("cffi", "numpy", "PIL", "sphinx", "myst_parser", "furo")
    stage = [str(root / "docs/guide/stage.py"), f"{folder}/source"]
    sphinx = ["-m", "sphinx", "-q", "-E", "-n", "-W", "--keep-going", "-d", f"{folder}/doctrees", f"{folder}/source", f"{folder}/html"]
    for command in (stage, sphinx):
        run = subprocess.run([sys.executable, "-B", *command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if run.returncode != 0 or run.stdout.strip():
            yield f"the guide is not as it should be:\n{run.stdout}"
            return
    for page in ("index", "tutorial", "cookbook", "c/model", "python/model", "reference-csharp"):
        text = (Path(folder) / "html" / f"{page}.html").read_text(encoding="utf-8")
        for source in re.findall(r'<img [^>]*src="([^"]+)"', text):
            if not (Path(folder) / "html" / page).parent.joinpath(source).is_file():
                yield f"{page}.html shows {source}, which is not there"


CHECKS = {
    "links": broken_links, "glossary": wrong_glossary, "names": wrong_names, "presets": wrong_presets,
    "pictures": wrong_pictures, "readme": wrong_readme, "versions": wrong_versions, "tutorial": tutorial, "cookbook": cookbook, "guide": guide,
}  # fmt: skip


def main():
    what, root = sys.argv[1], Path(sys.argv[2]).resolve()
    if what == "agree":
        findings = list(agree(root, sys.argv[3:]))
    elif what == "quickstart":
        findings = list(quickstart(root, sys.argv[3], sys.argv[4:]))
    else:
        findings = list(CHECKS[what](root, *sys.argv[3:]))
    print("\n".join(findings) if findings else f"{what}: as it should be")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
