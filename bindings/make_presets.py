# SPDX-License-Identifier: MIT
"""Makes everything that lists the named styles from the table in presets.py: the constants of include/hrbfnpr.h, the
library's src/api/preset_table.h, the C# enumeration, docs/presets.md and the list of the tests.

bindings/generate runs this module.  The results are committed.
"""
import re
import textwrap
from xml.sax.saxutils import escape

from make_layout import choices_of
from outputs import BINDINGS, ROOT
from presets import PRESETS

HEADER = ROOT / "include/hrbfnpr.h"
NOTE = "// SPDX-License-Identifier: MIT\n// Made by bindings/generate from bindings/presets.py; do not edit.\n"
WIDTH = 120


def constant(preset):
    return "HRBFNPR_PRESET_" + preset.name.upper().replace("-", "_")


def sentence(words):
    return words[0].upper() + words[1:] + "."


# ---- The header's constants

ENUM = re.compile(r"^enum \{\n    HRBFNPR_PRESET_.*?^\};$", re.DOTALL | re.MULTILINE)


def enum():
    starts = [f"    {constant(preset)} = {number}{',' if preset is not PRESETS[-1] else ''}"
              for number, preset in enumerate(PRESETS)]
    column = max(map(len, starts)) + 1
    lines = []
    for start, preset in zip(starts, PRESETS):
        lines += textwrap.wrap(f"/* {preset.draws}\0*/", WIDTH, initial_indent=start.ljust(column),
                               subsequent_indent=" " * (column + 3), break_on_hyphens=False)
    return "enum {\n" + "\n".join(lines).replace("\0", " ") + "\n};"


def header():
    """include/hrbfnpr.h with the constants of the table.  It is made first, because everything else is made from the header."""
    text = HEADER.read_text(encoding="utf-8")
    if len(ENUM.findall(text)) != 1:
        raise SystemExit("include/hrbfnpr.h has no enum of HRBFNPR_PRESET_...")
    return {HEADER: ENUM.sub(lambda _: enum(), text)}


# ---- The library's table

TABLE_HEAD = NOTE + """#pragma once
// clang-format off

#include "api/layer_fields.h"
#include "api/presets.h"
#include "api/style_fields.h"

#include <iterator>

namespace hrbfnpr::api::preset_table {

// Defaults with some fields set.
template <class Struct, class Change>
[[nodiscard]] constexpr Struct changed(Struct to, Change change) {
    change(to);
    return to;
}

template <std::size_t count>
[[nodiscard]] constexpr hrbfnpr_array packed(const double (&numbers)[count]) noexcept {
    return {numbers, count, sizeof(double), HRBFNPR_SCALAR_FLOAT64, 1};
}
"""


class Structs:
    """The C structs whose fields the table's rows set."""

    def __init__(self, api):
        self.constants = {group["prefix"]: {one["name"]: one["value"] for one in group["constants"]}
                          for group in api["constants"]}
        self.fields = {struct["name"]: {field["name"]: field for field in struct["fields"]} for struct in api["structs"]}

    def named(self, struct, field, words, where):
        """The C++ expression of a field that is given by the names of its constants."""
        choices = dict(choices_of(field, struct, self.constants))
        unknown = [word for word in words if word not in choices]
        if unknown or not words:
            raise SystemExit(f"bindings/presets.py: {where} is {words}; it must be of {', '.join(choices)}")
        full = [f"{prefix}_{word.upper()}" for word in words for prefix, group in self.constants.items()
                if prefix in field["doc"] and f"{prefix}_{word.upper()}" in group]
        return full[0] if len(words) == len(full) == 1 else str(sum(choices[word] for word in words))

    def statements(self, struct, fields, where):
        """C++ statements that set the fields of `to`."""
        for name, value in fields.items():
            field, place = self.fields[struct].get(name), f"{where}.{name}"
            if field is None or name == "struct_size" or name.startswith("reserved"):
                raise SystemExit(f"bindings/presets.py: {place}: {struct} has no such field")
            kind = field["type"]["c"]
            if value is None:
                continue
            if kind == "hrbfnpr_array":
                yield f"to.{name} = packed({array_name(where, name)});"
            elif field["array"]:
                if len(value) != field["array"][0]:
                    raise SystemExit(f"bindings/presets.py: {place} wants {field['array'][0]} numbers")
                yield " ".join(f"to.{name}[{i}] = {number(kind, each)};" for i, each in enumerate(value))
            elif kind == "const char*":
                yield f'to.{name} = "{value}";'
            elif isinstance(value, (str, list)):
                yield f"to.{name} = {self.named(struct, field, [value] if isinstance(value, str) else value, place)};"
            else:
                yield f"to.{name} = {number(kind, value)};"

    def arrays(self, struct, fields, where):
        """C++ arrays with the numbers of the fields of type hrbfnpr_array."""
        for name, value in fields.items():
            if name in self.fields[struct] and self.fields[struct][name]["type"]["c"] == "hrbfnpr_array":
                numbers = ", ".join(number("double", each) for each in value)
                yield f"inline constexpr double {array_name(where, name)}[] = {{{numbers}}};\n"


def array_name(where, name):
    return re.sub(r"\W+", "_", f"{where}_{name}")


def number(kind, value):
    """A number of a C type, as C++ writes it."""
    if kind in ("float", "double"):
        return repr(float(value)) + ("F" if kind == "float" else "")
    return str(int(value))


def changed(start, statements, indent):
    """A C++ expression: a struct of defaults with some fields changed."""
    statements = [statement.replace(" ", "\0") for statement in statements]
    flat = f"{indent}changed({start}(), [](auto& to) {{ {' '.join(statements)} }})"
    if len(flat) < WIDTH:
        return flat.replace("\0", " ")
    body = textwrap.fill(" ".join(statements), WIDTH, initial_indent=indent + "    ", subsequent_indent=indent + "    ",
                         break_long_words=False, break_on_hyphens=False)
    return f"{indent}changed({start}(), [](auto& to) {{\n{body}\n{indent}}})".replace("\0", " ")


LISTS = (("marks", "hrbfnpr_layer_desc", "default_layer_desc"), ("layers", "hrbfnpr_layer_style", "default_layer_style"),
         ("lines", "hrbfnpr_line_style", "default_line_style"))


def table(api):
    structs, parts, rows = Structs(api), [TABLE_HEAD], []
    for preset in PRESETS:
        word = preset.name.replace("-", "_")
        style = list(structs.statements("hrbfnpr_style", preset.style, f"{word}_style"))
        parts.append(f"\n// ---- {preset.name}\n\n")
        for name, struct, start in LISTS:
            elements = getattr(preset, name)
            if not elements:
                continue
            places = [f"{word}_{name}_{i}" for i in range(len(elements))]
            for place, fields in zip(places, elements):
                parts += structs.arrays(struct, fields, place)
            texts = [changed(start, structs.statements(struct, fields, place), "    ")
                     for place, fields in zip(places, elements)]
            parts.append(f"inline constexpr {struct} {word}_{name}[] = {{\n" + ",\n".join(texts) + "};\n")
            if name != "marks":
                style.append(f"to.{name} = {word}_{name}; to.{name[:-1]}_count = std::ssize({word}_{name});")
        rows.append(f'    {{"{preset.name}",\n{changed("default_style", style, "     ")},\n     {word}_marks}}')
    parts.append("\n// ---- All named styles, in the order of their numbers\n\ninline constexpr Preset presets[] = {\n"
                 + ",\n".join(rows) + "};\n\n} // namespace hrbfnpr::api::preset_table\n")
    return "".join(parts)


# ---- The tests' list

def test_list():
    rows = "".join(f'    {{{constant(preset)}, "{preset.name}"}},\n' for preset in PRESETS)
    return (NOTE + "// The named styles that the library must have.\n#pragma once\n// clang-format off\n\n#include <hrbfnpr.h>\n\n"
            "#include <cstdint>\n\nnamespace hrbfnpr::testing {\n\nstruct PresetName {\n    std::uint32_t preset;\n"
            f"    const char* name;\n}};\ninline constexpr PresetName preset_names[] = {{\n{rows}}};\n\n"
            "} // namespace hrbfnpr::testing\n")


# ---- C#

def csharp():
    lines = [NOTE.rstrip("\n"), "namespace HrbfNpr", "{", "    /// <summary>Named styles.</summary>",
             '    [NativeConstants("HRBFNPR_PRESET_")]', "    public enum Preset", "    {"]
    for value, preset in enumerate(PRESETS):
        words = escape(sentence(preset.draws))
        whole = f"        /// <summary>{words}</summary>"
        lines += [whole] if len(whole) <= WIDTH else [
            "        /// <summary>", *textwrap.wrap(words, WIDTH, initial_indent="        /// ",
                                                   subsequent_indent="        /// "), "        /// </summary>"]
        lines.append(f"        {''.join(part.capitalize() for part in preset.name.split('-'))} = {value},")
    return "\n".join([*lines, "    }", "}", ""])


# ---- docs/presets.md

PAGE_HEAD = """# The named styles

Each named style sets all fields of a style. Use it as it is, or change fields afterwards. You get it from
`hrbfnpr_style_init_preset` in C, `hrbfnpr.Style("engraving")` in Python and `Style.Preset` in C#. Below, each style draws
the same model, fitted to 1100 samples; the command is below its picture. To see your own model in all styles, run
`python3 -m hrbfnpr sheet model.ply styles.png`.

[frames.md](frames.md), [light.md](light.md), [hatching.md](hatching.md) and [lines.md](lines.md) explain the fields. A
field that a table below does not name has its default. `bindings/generate` writes this page from the table
`bindings/presets.py`, and `docs/preset_pictures.py` draws the pictures.

"""
PAGE_FOOT = """## The model

The bunny is a scan by the Stanford Computer Graphics Laboratory
([Stanford 3D Scanning Repository](http://graphics.stanford.edu/data/3Dscanrep/)). Its pictures are shown here for
scholarly use. `scripts/fetch_bunny` fetches the file `bunny.obj` of the commands.
"""
PICTURE_OPTIONS = "--samples 1100 --azimuth 20 --elevation 15 --size 480"


def layer_of(preset, mark):
    """How a generated layer is drawn: the first layer style that fits it."""
    return next((layer for layer in preset.layers if layer["kind"] in (mark["kind"], "any")
                 and layer.get("name") in (mark.get("name"), None)), {})


def marks_in_words(preset):
    sets = {}
    for mark in preset.marks:
        layer = layer_of(preset, mark)
        if mark["kind"] == "hatch":
            follows = f" along `{mark['guide']}`" if "guide" in mark else ""
            what = f"lines{follows} from {layer['hatch_pen']:g} px wide, from {layer['hatch_spacing']:g} px apart, at "
            sets.setdefault(what, []).append(f"{mark['angle']:g}°")
        elif layer.get("shown", True):
            yield mark["kind"] + (f" of radius {layer['radius']:g} px" if "radius" in layer else "")
    for what, angles in sets.items():
        yield what + ", ".join(angles)


def lines_in_words(preset):
    for line in preset.lines:
        what = f'lines called "{line["name"]}"' if line["kind"] == "own" else line["kind"].replace("_", " ") + "s"
        hidden = f", hidden parts `{line['hidden']}`" if "hidden" in line else ""
        yield f"{what} of {line['width']:g} px{hidden}"


def in_words(value):
    if isinstance(value, tuple):
        return "(" + ", ".join(f"{each:.3g}" for each in value) + ")"
    return value if isinstance(value, str) else f"{value:g}"


def section(preset):
    fields = ", ".join(f"`{name}` {in_words(value)}" for name, value in preset.style.items())
    rows = (("marks", "; ".join(marks_in_words(preset)) or "none"), ("lines", "; ".join(lines_in_words(preset)) or "none"),
            ("fields", fields))
    name = preset.name
    return (f"## {name}\n\n{preset.use}\n\n"
            f'<p align="center"><img src="images/presets/{name}.png" alt="The Stanford bunny in the style {name}"></p>\n\n'
            "| | |\n|---|---|\n" + "".join(f"| {what} | {words} |\n" for what, words in rows) +
            f"\n```sh\npython3 -m hrbfnpr draw bunny.obj {name}.png --style {name} {PICTURE_OPTIONS}\n```\n\n")


def outputs(api):
    """The text of each file except the header, by path."""
    return {
        ROOT / "src/api/preset_table.h": table(api),
        ROOT / "tests/support/preset_names.h": test_list(),
        BINDINGS / "csharp/HrbfNpr/Preset.cs": csharp(),
        ROOT / "docs/presets.md": PAGE_HEAD + "".join(map(section, PRESETS)) + PAGE_FOOT,
    }
