# SPDX-License-Identifier: MIT
"""Makes hrbfnpr/_options.json, the table of a drawing's options, and hrbfnpr/_draw_call.pyi, the call that takes them by name.

bindings/generate runs this module.  Both files are made from ../picture_options.py and the header's comments, and are
committed.
"""
import json
import textwrap
from pathlib import Path

from picture_options import GROUPS, choices_of, words_of

HERE = Path(__file__).resolve().parent
WIDTH = 120
TYPES = {
    "flag": "bool", "number": "Optional[float]", "count": "Optional[int]", "choice": "Optional[str]", "text": "Optional[str]",
    "vector": "Optional[Floats]", "direction": "Direction", "up": "Direction", "paint": "Optional[Color]", "size": "Size",
    "layers": "Names", "lines": "Names", "per_layer": "PerLayer", "interval": "Optional[Floats]", "edges": "NumberOr",
    "ground": "Ground", "lights": "Lights",
    "number_or_auto": "NumberOr", "count_or_auto": "NumberOr", "assignment": "Optional[Mapping[str, Any]]",
    "file": "Optional[Any]", "page": "Size", "pens": "Names", "pen_widths": "Optional[Floats]",
    "fields": "Fields", "palette": "Palette", "classes": "Union[str, int, Sequence[int], None]",
}  # fmt: skip


def rows(api):
    """The columns of `Option` in hrbfnpr/_options.py, for each option."""
    for group, options in GROUPS.items():
        for option in options:
            choices = choices_of(option, api)
            kind = option.kind.split()[0] if choices else option.kind
            yield [option.name, option.target, kind, option.metavar, group, choices, option.alias, words_of(option, api),
                   TYPES[option.kind.split()[0]]]  # fmt: skip


def table(api):
    lines = (json.dumps(row, ensure_ascii=False) for row in rows(api))
    return "[\n" + ",\n".join(lines) + "\n]\n"


def stub(api):
    arguments = ", ".join(f"{row[0]}: {row[8]} = ..." for row in rows(api)).replace(" ", "\0").replace(",\0", ", ")
    template = (HERE / "draw_call.pyi.in").read_text(encoding="utf-8")
    lines = textwrap.wrap(arguments, WIDTH, initial_indent="    ", subsequent_indent="    ", break_long_words=False,
                          break_on_hyphens=False)  # fmt: skip
    return template.replace("@SIGNATURE@", "\n".join(lines).replace("\0", " "))


def outputs(api):
    """The text of each file, by path."""
    return {HERE / "hrbfnpr/_options.json": table(api), HERE / "hrbfnpr/_draw_call.pyi": stub(api)}
