# SPDX-License-Identifier: MIT
"""A Markdown page of the public members of the C# assembly, with the summaries from the XML comments of its sources."""

import re
from html import unescape

TYPE = re.compile(r"public (?:[\w ]*? )?(class|struct|enum|interface|delegate) ")
HIDDEN = re.compile(r"(?:(?:internal|private|protected|static|sealed|abstract|unsafe|readonly|partial) )*"
                    r"(?:class|struct|enum|interface) \w")  # fmt: skip


def words(comment):
    """The summary in an XML comment, as Markdown."""
    found = re.search(r"<summary>(.*?)</summary>", comment, re.DOTALL)
    text = found.group(1) if found else ""
    text = re.sub(r"<see cref=\"(?:\w:)?([^\"]+)\"\s*/>", lambda m: f"`{m.group(1).partition('(')[0]}`", text)
    text = re.sub(r"<(?:paramref|typeparamref) name=\"([^\"]+)\"\s*/>", r"`\1`", text)
    text = re.sub(r"<c>(.*?)</c>", r"`\1`", text, flags=re.DOTALL)
    text = re.sub(r"<see langword=\"(\w+)\"\s*/>", r"`\1`", text)
    text = unescape(re.sub(r"</?\w[^>]*>", " ", text))
    return re.sub(r"([*_|<])(?![^`]*`(?:[^`]*`[^`]*`)*[^`]*$)", r"\\\1", " ".join(text.split()))


def signature(lines):
    """A declaration up to its body, on one line."""
    text = " ".join(line.strip() for line in lines)
    text = re.split(r"\s*(?:\{|=>|;)|\s(?::|where)\s", text)[0]
    return re.sub(r"\s*=\s*[^,()]+$", "", text) if "(" not in text else text


def declarations(source):
    """(depth, comment, declaration) of everything public in a file.  The declaration is None where a hidden type begins."""
    lines, comment, number = source.splitlines(), [], 0
    in_enum = None
    while number < len(lines):
        line = lines[number]
        text, depth = line.strip(), (len(line) - len(line.lstrip())) // 4
        if in_enum is not None and depth <= in_enum and text == "}":
            in_enum = None
        if text.startswith("///"):
            comment.append(text[3:].strip())
        elif re.match(r"\[|#|//", text) or not text:
            pass  # an attribute or a condition, between a comment and its declaration
        elif text.startswith("public ") or (in_enum is not None and re.match(r"\w+(?: = [^,]+)?,?$", text)):
            parts = [text]
            while not re.search(r"[{;]|=>|\)$", " ".join(parts)) and in_enum is None and number + 1 < len(lines):
                if lines[number + 1].strip().startswith("{"):
                    break
                number += 1
                parts.append(lines[number].strip())
            yield depth, "\n".join(comment), signature(parts).rstrip(",")
            if re.match(r"public enum ", text):
                in_enum = depth
            comment = []
        else:
            if HIDDEN.match(text):
                yield depth, "", None
            comment = []
        number += 1


def name_of(declaration):
    return re.search(r"(?:class|struct|enum|interface) (\w+)|delegate .*?(\w+)(?:<[^>]*>)?\(", declaration)


def types(folder):
    """For each type: its declaration, its comment and its members.  The parts of a partial type are joined."""
    found = {}
    for path in sorted(folder.rglob("*.cs")):
        if {"bin", "obj"} & set(path.parts):
            continue
        around = []  # the types around a line, each with its depth and its name; None for the name of a hidden type
        for depth, comment, declaration in declarations(path.read_text(encoding="utf-8-sig")):
            while around and around[-1][0] >= depth:
                around.pop()
            if declaration is None:
                around.append((depth, None))
            elif TYPE.match(declaration + " ") and all(name for _, name in around):
                match = name_of(declaration)
                around.append((depth, match.group(1) or match.group(2)))
                known = found.setdefault(around[-1][1], [declaration, comment, []])
                known[1] = known[1] or comment
            elif around and all(name for _, name in around):
                found[around[-1][1]][2].append((declaration, comment))
    return found


def page(folder):
    text = """# The C# assembly: every member

The public types of `HrbfNpr` and their members, with the summaries of their XML comments. Editors show the rest of the
comments: parameters, ranges, exceptions. [The C# assembly](csharp.md) gives an overview with examples.

"""
    for name, (declaration, comment, members) in sorted(types(folder).items()):
        text += f"## {name}\n\n```csharp\n{declaration}\n```\n\n{words(comment)}\n\n"
        for member, about in members:
            text += f"- `{member.replace('public ', '', 1)}`" + (f"\\\n  {words(about)}" if words(about) else "") + "\n"
        text += "\n"
    return text
