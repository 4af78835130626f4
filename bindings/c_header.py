# SPDX-License-Identifier: MIT
"""Reads a C header in the style of include/hrbfnpr.h: its declarations and their comments.

The parser knows `enum { NAME = value, ... };`, `typedef struct name { fields } name;`, `typedef struct name name;` (a
handle), typedefs of scalars and of function pointers, and functions after HRBFNPR_API.  Anything else raises a HeaderError
that names the line; nothing is skipped.  A comment belongs to the declaration directly below it, or to the one before it on
the same line.  A comment at the top level that an empty line follows belongs to the section.  A section begins with a
comment that has a number and a title between lines of `=`.
"""
import re
from typing import NamedTuple

SCALARS = {
    "char": 1, "int8_t": 1, "uint8_t": 1, "int16_t": 2, "uint16_t": 2, "int32_t": 4, "uint32_t": 4, "int64_t": 8,
    "uint64_t": 8, "float": 4, "double": 8, "size_t": None,  # None: the size of a pointer
}
EXPORT = "HRBFNPR_API"
GUARD = ("#ifndef HRBFNPR_H", "#define HRBFNPR_H")
SECTION = re.compile(r"=+\n(\d+)\s+(.*)\n=+(?:\n|$)(.*)", re.DOTALL)
TOKEN = re.compile(r"""
    (?P<comment>/\*.*?\*/) | (?P<directive>\#[^\n]*) | (?P<word>[A-Za-z_]\w*)
    | (?P<number>(?:0[xX][0-9a-fA-F]+|0|[1-9]\d*)[uUlL]*(?!\w)) | (?P<string>"[^"\n]*")
    | (?P<mark><<|>>|[{}()\[\];,=*|&^~+-]) | (?P<space>\s+)
    """, re.VERBOSE | re.DOTALL)


class HeaderError(Exception):
    def __init__(self, line, message):
        super().__init__(f"line {line}: {message}")
        self.line = line


class Token(NamedTuple):
    kind: str
    text: str
    line: int
    last_line: int


class Parsed(NamedTuple):
    """Lists of plain dictionaries, as in api.json but without the entries that make_api.py computes."""
    doc: str
    sections: list
    order: list  # [kind, name] of all declarations, in the header's order; an enum has the name of its first constant
    enums: list
    structs: list
    callbacks: list
    handles: list
    typedefs: list
    functions: list


def scan(text):
    at, line = 0, 1
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            raise HeaderError(line, f"not understood: {text[at:].splitlines()[0]}")
        kind, found = match.lastgroup, match.group()
        last = line + found.count("\n")
        if kind == "directive":
            found = " ".join(re.sub(r"/\*.*?\*/", "", found).split())
            if "/*" in found or found.endswith("\\"):
                raise HeaderError(line, "a directive must end with its line")
        if kind != "space":
            yield Token(kind, found, line, last)
        at, line = match.end(), last


def comment_text(comment):
    """The text of a comment without its stars.  Lines keep their indentation after the star."""
    first, *others = comment.text[2:-2].split("\n")
    lines = [first.strip()] + [re.sub(r"^\s*(\* ?)?", "", line).rstrip() for line in others]
    return "\n".join(lines).strip("\n")


class Comments:
    """Finds the comments of each token.  At the end it knows which comments were never asked for."""

    def __init__(self, tokens):
        self.above, self.behind, self.free = {}, {}, []
        waiting, index, last = [], 0, None
        for token in tokens:
            if token.kind != "comment":
                self._settle(waiting, index, token)
                waiting, index, last = [], index + 1, token
            elif last is not None and last.line == token.line and not waiting:
                self.behind.setdefault(index - 1, []).append(token)
            else:
                waiting.append(token)
        self._settle(waiting, index, None)

    def _settle(self, waiting, index, token):
        line = token.line if token is not None and token.kind != "directive" else None
        near = []
        while waiting and line is not None and waiting[-1].last_line >= line - 1 and "\n * ===" not in waiting[-1].text:
            near.insert(0, waiting.pop())
            line = near[0].line
        if near:
            self.above[index] = near
        self.free += [(index, comment) for comment in waiting]

    def take_above(self, index):
        return "\n\n".join(comment_text(comment) for comment in self.above.pop(index, []))

    def take_behind(self, first, last):
        """The comments after the tokens `first` to `last`, on one line."""
        found = [comment for index in range(first, last + 1) for comment in self.behind.pop(index, [])]
        return " ".join(" ".join(comment_text(comment).split()) for comment in found)

    def take_free(self, index):
        """The free comments before token `index`.  A free comment inside a declaration is never taken, and so is left over."""
        while self.free and self.free[0][0] == index:
            yield self.free.pop(0)[1]

    def left_over(self):
        rest = [comment for group in (*self.above.values(), *self.behind.values()) for comment in group]
        return sorted(rest + [comment for _, comment in self.free], key=lambda comment: comment.line)


def joined(*docs):
    return "\n\n".join(doc for doc in docs if doc)


class Parser:
    def __init__(self, text):
        pieces = list(scan(text))
        self.tokens = [piece for piece in pieces if piece.kind != "comment"]
        self.comments = Comments(pieces)
        self.at = 0
        self.parsed = Parsed("", [], [], [], [], [], [], [], [])
        self.file_doc = []
        self.kinds = {**dict.fromkeys(SCALARS, "scalar"), "void": "void"}  # the kind of each type
        self.values = {}  # the value of each constant
        self.names = set()
        self.last_function = None  # the last function, and the line on which it ends

    # ---- Tokens

    def fail(self, message, line=None):
        raise HeaderError(line or (self.token or self.tokens[-1]).line, message)

    @property
    def token(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def next_is(self, *texts):
        found = self.tokens[self.at:self.at + len(texts)]
        return len(found) == len(texts) and all(token.text == text for token, text in zip(found, texts))

    def take(self, *texts):
        for text in texts:
            if not self.next_is(text):
                self.fail(f"expected {text!r}, found {self.token.text if self.token else 'the end'!r}")
            self.at += 1

    def accept(self, text):
        if self.next_is(text):
            self.at += 1
            return True
        return False

    def word(self, what):
        if self.token is None or self.token.kind != "word":
            self.fail(f"expected {what}, found {self.token.text if self.token else 'the end'!r}")
        self.at += 1
        return self.tokens[self.at - 1].text

    def new_name(self, what, prefix):
        name = self.word(what)
        if not name.startswith(prefix):
            self.fail(f"{what} {name} does not begin with {prefix}", self.tokens[self.at - 1].line)
        if name in self.names:
            self.fail(f"{name} is declared twice", self.tokens[self.at - 1].line)
        self.names.add(name)
        return name

    # ---- Types, as dictionaries

    def type(self):
        """A type such as `const base* const*`.  `pointers` says for each star, from the name outward, what it points to."""
        constant = self.accept("const")
        line = self.token.line if self.token else None
        base = self.word("a type")
        if base not in self.kinds:
            self.fail(f"the type {base} is not known", line)
        pointers, text = [], ("const " if constant else "") + base
        while self.accept("*"):
            pointers.append("const" if constant else "mutable")
            constant = self.accept("const")
            text += "* const" if constant else "*"
        if constant:
            self.fail("const that no pointer points to", line)
        if not pointers and self.kinds[base] == "handle":
            self.fail(f"the handle {base} without a pointer", line)
        return {"c": text, "base": base, "kind": self.kinds[base], "pointers": pointers,
                "const": "const" in pointers[:1]}

    def value_type(self):
        line = self.token.line
        found = self.type()
        if found["c"] == "void":
            self.fail("nothing can be void", line)
        return found

    def shape(self):
        sizes = []
        while self.accept("["):
            sizes.append(self.number("]"))
            if sizes[-1] < 1:
                self.fail(f"an array of {sizes[-1]} elements")
            self.take("]")
        return sizes

    def parameters(self):
        self.take("(")
        if self.next_is("void", ")"):
            self.take("void", ")")
            return []
        result = []
        while True:
            kind = self.value_type()
            name = self.word("a parameter's name")
            if any(name == parameter["name"] for parameter in result):
                self.fail(f"two parameters {name}")
            if self.next_is("["):
                self.fail("an array as a parameter: write a pointer")
            result.append({"name": name, "type": kind})
            if not self.accept(","):
                break
        self.take(")")
        return result

    def number(self, *ends):
        """The value of a constant expression.  It ends before one of `ends`."""
        line, words = self.token.line if self.token else None, []
        while self.token is not None and self.token.text not in ends:
            token = self.token
            if token.kind == "number":
                words.append(token.text.rstrip("uUlL"))
            elif token.kind == "word" and token.text in self.values:
                words.append(str(self.values[token.text]))
            elif token.text in ("<<", ">>", "|", "&", "^", "~", "+", "-", "*", "(", ")"):
                words.append(token.text)
            else:
                self.fail(f"no constant expression: {token.text}")
            self.at += 1
        try:  # C and Python read integers and these operators alike
            value = eval(" ".join(words), {"__builtins__": {}})
        except (SyntaxError, TypeError, ValueError):
            self.fail(f"no constant expression: {' '.join(words)}", line)
        if not isinstance(value, int) or not -2**31 <= value < 2**31:
            self.fail(f"{value} is no int", line)
        return value

    # ---- Declarations

    def directive(self):
        text = self.token.text
        if text in GUARD or re.fullmatch(r"#include <std(int|def)\.h>", text):
            self.at += 1
        elif text == "#ifdef __cplusplus":
            self.at += 1
            self.take(*(["extern", '"C"', "{"] if self.next_is("extern") else ["}"]), "#endif")
        elif text == "#if defined(_WIN32)":
            self.export_mark()
        elif text == "#endif" and self.at == len(self.tokens) - 1:
            self.at += 1
        else:
            self.fail(f"a directive that is not known: {text}")

    def export_mark(self):
        """Skips #if ... #endif that only defines HRBFNPR_API."""
        depth = 0
        while True:
            token = self.token
            if token is None or not re.match(rf"#(if|elif|else|endif|define {EXPORT}\b)", token.text):
                self.fail(f"expected a definition of {EXPORT} or #endif")
            depth += token.text.startswith("#if") - (token.text == "#endif")
            self.at += 1
            if depth == 0:
                return

    def add(self, kind, target, entry, name=None):
        entry["section"] = self.parsed.sections[-1]["number"] if self.parsed.sections else None
        self.parsed.order.append([kind, name or entry["name"]])
        target.append(entry)

    def body(self, end, item):
        """Items up to `end`, each with the comment above it and the comment after it."""
        result, line = [], None
        while not self.next_is(end):
            first = self.at
            entry = item()
            above, behind = self.comments.take_above(first), self.comments.take_behind(first, self.at - 1)
            if behind and self.tokens[first].line == line:
                self.fail("a comment behind several items", line)
            line = self.tokens[first].line
            entry["doc"] = behind or above
            if behind and above:
                entry["heading"] = above  # for this item and the items that follow
            result.append(entry)
        return result

    def enumerator(self):
        name = self.new_name("a constant", "HRBFNPR_")
        self.take("=")
        self.values[name] = self.number(",", "}")
        if not self.next_is("}"):
            self.take(",")
        return {"name": name, "value": self.values[name]}

    def enum(self, first):
        self.take("enum", "{")
        constants = self.body("}", self.enumerator)
        if not constants:
            self.fail("an enum without constants")
        self.take("}", ";")
        self.add("enum", self.parsed.enums, {"doc": self.doc(first), "constants": constants}, constants[0]["name"])

    def doc(self, first):
        return joined(self.comments.take_above(first), self.comments.take_behind(self.at - 1, self.at - 1))

    def function_pointer(self, result, name):
        """The rest of a function pointer, after `result (* name`."""
        self.take(")")
        return {"returns": result, "parameters": self.parameters()}

    def field(self):
        kind = self.type()
        if self.next_is("(", "*"):
            self.take("(", "*")
            name = self.word("a field's name")
            function = self.function_pointer(kind, name)
            text = ", ".join(f"{part['type']['c']} {part['name']}" for part in function["parameters"]) or "void"
            kind = {"c": f"{kind['c']} (*)({text})", "base": None, "kind": "function", "pointers": [], "const": False,
                    **function}
        else:
            if kind["c"] == "void":
                self.fail("nothing can be void")
            name = self.word("a field's name")
        shape = self.shape()
        self.take(";")
        return {"name": name, "type": kind, "array": shape}

    def struct(self, first):
        self.take("typedef", "struct")
        name = self.new_name("a struct", "hrbfnpr_")
        if self.next_is("{"):
            self.take("{")
            fields = self.body("}", self.field)
            names = [field["name"] for field in fields]
            if not names or len(set(names)) < len(names):
                self.fail(f"{name} has {'two fields of one name' if names else 'no fields'}")
            self.take("}", name, ";")
            self.kinds[name] = "struct"
            self.add("struct", self.parsed.structs, {"name": name, "doc": self.doc(first), "fields": fields})
        else:
            self.take(name, ";")
            self.kinds[name] = "handle"
            self.add("handle", self.parsed.handles, {"name": name, "doc": self.doc(first)})

    def typedef(self, first):
        self.take("typedef")
        kind = self.type()
        if self.accept("("):
            self.take("*")
            name = self.new_name("a callback", "hrbfnpr_")
            function = self.function_pointer(kind, name)
            self.take(";")
            self.kinds[name] = "callback"
            self.add("callback", self.parsed.callbacks, {"name": name, "doc": self.doc(first), **function})
        else:
            if kind["kind"] != "scalar" or kind["pointers"]:
                self.fail("a typedef must be of a scalar, a struct or a function pointer")
            name = self.new_name("a type", "hrbfnpr_")
            self.take(";")
            self.kinds[name] = "typedef"
            self.add("typedef", self.parsed.typedefs, {"name": name, "type": kind, "doc": self.doc(first)})

    def function(self, first):
        self.take(EXPORT)
        result = self.type()
        name = self.new_name("a function", "hrbfnpr_")
        entry = {"name": name, "returns": result, "parameters": self.parameters()}
        self.take(";")
        entry["doc"] = self.doc(first)
        # Consecutive functions without an empty line between them share one comment.
        if self.last_function and not entry["doc"] and self.tokens[first].line == self.last_function[1] + 1:
            above = self.last_function[0]
            entry["see"] = above["name"] if above["doc"] else above.get("see")
        self.last_function = entry, self.tokens[self.at - 1].line
        self.add("function", self.parsed.functions, {key: value for key, value in entry.items() if value is not None})

    def free_comment(self, comment):
        text = comment_text(comment)
        found = SECTION.fullmatch(text)
        if found:
            number, title, rest = found.groups()
            self.parsed.sections.append(
                {"number": int(number), "title": " ".join(title.split()), "text": rest.strip("\n")})
        elif text.startswith("==="):
            self.fail("a section without a number and a title", comment.line)
        elif self.parsed.sections:
            self.parsed.sections[-1]["text"] = joined(self.parsed.sections[-1]["text"], text)
        else:
            self.file_doc.append(text)

    def parse(self):
        if self.token is None or [token.text for token in self.tokens[:2]] != list(GUARD):
            self.fail("no include guard", 1)
        if self.tokens[-1].text != "#endif":
            self.fail("the include guard has no #endif")
        starts = {"enum": self.enum, EXPORT: self.function}
        while self.token is not None:
            for comment in self.comments.take_free(self.at):
                self.free_comment(comment)
            first = self.at
            if self.token.kind == "directive":
                self.directive()
            elif self.token.text == "typedef":
                (self.struct if self.tokens[self.at + 1].text == "struct" else self.typedef)(first)
            elif self.token.text in starts:
                starts[self.token.text](first)
            else:
                self.fail(f"not understood: {self.token.text}")
        for comment in self.comments.take_free(self.at):
            self.free_comment(comment)
        for comment in self.comments.left_over():
            self.fail("a comment that belongs to nothing", comment.line)
        return self.parsed._replace(doc="\n\n".join(self.file_doc))


def parse(text):
    return Parser(text).parse()
