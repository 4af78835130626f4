# SPDX-License-Identifier: MIT
"""Reads the comments of source files: their first line, and their words."""

import ast
import io
import re
import tokenize

NO_COMMENT = re.compile(r"SPDX|NOLINT|#!|-\*-|shellcheck|noqa|fmt: ")
SLASHES = {".h", ".cpp", ".c", ".cs", ".js", ".mjs", ".mts", ".ts", ".rs"}
HASHES = {".py", ".pyi", ".cmake", ".sh", ".gd", ".in", ".supp", ".yml"}
MARKS = {**dict.fromkeys(SLASHES, r"//[/!]?"), **dict.fromkeys(HASHES, r"#"), ".lua": r"--"}


def kind_of(path, text):
    """The suffix whose syntax a file has, or None if the file is not a source."""
    if path.name == "CMakeLists.txt":
        return ".cmake"
    if not path.suffix and (found := re.match(r"#!.*\b(python|(?:ba|da)?sh\b)", text)):
        return ".py" if found.group(1) == "python" else ".sh"
    return path.suffix if path.suffix in MARKS else None


def plain(text):
    """A comment without the tags of XML documentation."""
    return " ".join(re.sub(r"</?[\w:]+(?: [^>]*)?/?>", " ", text).split())


def paragraphs(number, lines):
    """Pairs of the first line and the words of each paragraph. Empty lines separate paragraphs."""
    found = []
    for at, line in enumerate([*lines, ""], number):
        if words := plain(line):
            found.append((at, words))
        elif found:
            yield found[0][0], " ".join(words for _, words in found)
            found = []


def docstrings(text):
    """Pairs of the first line and the words of each paragraph in the docstrings of Python."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node):
            yield from paragraphs(node.body[0].lineno, node.body[0].value.value.splitlines())


def python_marks(text):
    """The columns at which comments begin, by line."""
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    return {token.start[0]: token.start[1] for token in tokens if token.type == tokenize.COMMENT}


def line_comments(text, mark, columns=None):
    """Pairs of the first line and the words of comments that end with their line. Those on adjacent lines belong together."""
    above = []
    for number, line in enumerate([*text.split("\n"), ""], 1):
        alone = (columns is None or number in columns) and re.match(rf"\s*(?:{mark})(.*)$", line)
        if alone and not NO_COMMENT.search(line):
            above.append(alone.group(1))
            continue
        if above:
            yield from paragraphs(number - len(above), above)
            above = []
        column = 0 if columns is None else columns.get(number)
        if alone or column is None:
            continue
        beside = re.search(rf"(?:^|(?<=[\s;,{{)]))(?:{mark}) +(.+)$", line[column:])
        if beside and not NO_COMMENT.search(beside.group(0)):
            yield number, plain(beside.group(1))


def block_comments(text):
    """Pairs of the first line and the words of each paragraph in comments between /* and */."""
    for found in re.finditer(r"^[ \t]*/\*+(.*?)\*/", text, re.DOTALL | re.MULTILINE):
        lines = [re.sub(r"^\s*\*+(?!/)", "", line) for line in found.group(1).split("\n")]
        if not NO_COMMENT.search(found.group(0)):
            yield from paragraphs(text.count("\n", 0, found.start()) + 1, lines)


def comments(path, text):
    """Pairs of the first line and the words of each paragraph of a file's comments."""
    kind = kind_of(path, text)
    if kind in (".py", ".pyi"):
        yield from docstrings(text)
        yield from line_comments(text, MARKS[kind], python_marks(text))
    elif kind is not None:
        yield from line_comments(text, MARKS[kind])
        if kind in SLASHES:
            yield from block_comments(text)
