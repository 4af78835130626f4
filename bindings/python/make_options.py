# SPDX-License-Identifier: MIT
"""hrbfnpr/_options.py, the table of a drawing's options, and hrbfnpr/_draw_call.py, the call that takes them by name.

bindings/generate runs it.  Both are made from ../picture_options.py and the header's comments, and are committed.
"""
import textwrap
from pathlib import Path

from picture_options import GROUPS, choices_of, words_of

HERE = Path(__file__).resolve().parent
NOTE = "# SPDX-License-Identifier: MIT\n# Made by make_options.py from ../picture_options.py and include/hrbfnpr.h; do not edit.\n"
WIDTH = 120
TYPES = {
    "flag": "bool", "number": "Optional[float]", "count": "Optional[int]", "choice": "Optional[str]", "text": "Optional[str]",
    "vector": "Optional[Floats]", "direction": "Direction", "up": "Direction", "paint": "Optional[Color]", "size": "Size",
    "layers": "Names", "lines": "Names", "per_layer": "PerLayer", "interval": "Optional[Floats]", "edges": "NumberOr",
    "number_or_auto": "NumberOr", "count_or_auto": "NumberOr", "assignment": "Optional[Mapping[str, Any]]",
    "file": "Optional[Any]", "page": "Size", "pens": "Names", "pen_widths": "Optional[Floats]",
}  # fmt: skip
def lines_of(text, indent, first=None):
    return "\n".join(textwrap.wrap(text, WIDTH, initial_indent=indent if first is None else first, subsequent_indent=indent,
                                   break_long_words=False, break_on_hyphens=False))  # fmt: skip


def rows(api):
    for group, options in GROUPS.items():
        for option in options:
            yield group, option, choices_of(option, api), words_of(option, api)


def table(api):
    parts = [NOTE, '"""The options of a drawing: name, target, kind, metavar, group, choices, other name, and what it is."""\n',
             "from typing import NamedTuple, Tuple\n\n\nclass Option(NamedTuple):\n",
             '    """A row; ../picture_options.py says what its columns are."""\n\n',
             *(f"    {name}: {kind}\n" for name, kind in (
                 ("name", "str"), ("target", "str"), ("kind", "str"), ("metavar", "str"), ("group", "str"),
                 ("choices", "Tuple[str, ...]"), ("alias", "str"), ("words", "str"))),
             "\n\nOPTIONS = tuple(Option(*row) for row in (\n"]  # fmt: skip
    for group, option, choices, words in rows(api):
        row = (option.name, option.target, option.kind.split()[0] if choices else option.kind, option.metavar, group, choices,
               option.alias)
        start = "    (" + ", ".join(map(quoted, row)) + ","
        text = quoted(words)
        if len(start) + len(text) + 4 <= WIDTH:
            parts.append(f"{start} {text}),\n")
        else:
            parts.append(packed(start, words))
    return "".join([*parts, "))  # fmt: skip\n"])


def quoted(value):
    if isinstance(value, tuple):
        return "(" + ", ".join(map(quoted, value)) + ("," if len(value) == 1 else "") + ")"
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def packed(start, words):
    """A row whose words have no room beside the rest: texts that Python joins."""
    room = WIDTH - 12
    pieces = textwrap.wrap(words, room, break_long_words=False, break_on_hyphens=False)
    pieces = [piece + " " for piece in pieces[:-1]] + pieces[-1:]
    lines = lines_of(start.strip(), "     ", "    ")
    return lines + "\n" + "\n".join(f"     {quoted(piece)}" for piece in pieces) + "),\n"


def call(api):
    template = (HERE / "draw_call.py.in").read_text(encoding="utf-8")
    arguments, names = [], []
    for _, option, _, _ in rows(api):
        kind = option.kind.split()[0]
        arguments.append(f"{option.name}: {TYPES[kind]} = {False if kind == 'flag' else None}")
        names.append(option.name)
    text = ", ".join(argument.replace(" ", "\0") for argument in arguments)
    given = lines_of(", ".join(f"{name}={name}" for name in names), "        ")
    return NOTE + (template.replace("@SIGNATURE@", lines_of(text, "    ").replace("\0", " "))
                   .replace("@GIVEN@", given))  # fmt: skip


def outputs(api):
    """The text of each file."""
    return {HERE / "hrbfnpr/_options.py": table(api), HERE / "hrbfnpr/_draw_call.py": call(api)}
