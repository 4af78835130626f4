# SPDX-License-Identifier: MIT
"""Write the parts of the npm package hrbfnpr that follow from api.json: constants, layouts of structs in WebAssembly,
signatures of functions and callbacks, their types for TypeScript, and the names that the linker exports.

bindings/generate runs it.  The results are committed.
"""
import json
import re
import textwrap
from pathlib import Path

from outputs import signature

FOLDER = Path(__file__).resolve().parent / "src" / "generated"
NOTE = "// SPDX-License-Identifier: MIT\n// Made by bindings/generate from bindings/api.json; do not edit.\n"
MODEL = "ilp32"  # the data model of WebAssembly: pointers of 32 bits
WIDTH = 110
SCALARS = {"char": "i8", "int8_t": "i8", "uint8_t": "u8", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64",
           "uint64_t": "u64", "float": "f32", "double": "f64"}
# How functions and callbacks pass a value of each scalar type.  j is a 64-bit integer; addresses are passed as p.
PASSED = {"i8": "i", "u8": "i", "i32": "i", "u32": "i", "i64": "j", "u64": "j", "f32": "f", "f64": "d"}
RESULTS = ("_info", "_comparison", "_identity")  # ends of names of structs that are only read
# Fields whose arrays have one number in each element.
ONE_COMPONENT = {"levels", "line_first", "stroke_first", "stroke_direction", "rank", "level", "width", "host_depth", "pen_widths"}


def camel(name, first_upper=False):
    words = name.split("_")
    head = words[0].capitalize() if first_upper else words[0]
    return head + "".join(word.capitalize() for word in words[1:])


def type_name(name):
    return camel(name.removeprefix("hrbfnpr_"), True)


def group_name(prefix):
    return "VERSION" if prefix == "HRBFNPR" else prefix.removeprefix("HRBFNPR_")


def constant_name(constant, prefix):
    return constant["name"].removeprefix(prefix + "_")


def word(name):
    """Return the name of a constant as options spell it: "blue-noise" for BLUE_NOISE."""
    return name.lower().replace("_", "-")


def documented(text, indent=""):
    """Return a JSDoc comment of a text, as lines; an empty list for no text."""
    if not text:
        return []
    lines = []
    for line in text.replace("*/", "* /").split("\n"):
        lines += textwrap.wrap(line, WIDTH) or [""]
    if len(lines) == 1:
        return [f"{indent}/** {lines[0]} */"]
    return [f"{indent}/**", *(f"{indent} * {line}".rstrip() for line in lines), f"{indent} */"]


def doc_of(entry):
    if entry.get("see"):
        return f"See {entry['see']}."
    return "\n\n".join(part for part in (entry.get("doc"), entry.get("heading")) if part)


class Names:
    """Finds the types of the header's fields in JavaScript."""

    def __init__(self, api):
        self.typedefs = {one["name"]: one["type"]["base"] for one in api["typedefs"]}
        self.prefixes = {one["name"]: group["prefix"] for group in api["constants"] for one in group["constants"]}

    def group(self, field):
        """Return the prefix of the constants that a field takes, as its comment names it or one of its constants."""
        if field["name"].endswith("flags") or field["type"]["base"] not in ("uint32_t", "int32_t"):
            return None
        mentioned = [self.prefixes.get(name, "HRBFNPR") for name in re.findall(r"HRBFNPR_\w+", field["doc"])]
        mentioned = [prefix for prefix in mentioned if prefix != "HRBFNPR"]  # HRBFNPR is the prefix of version numbers
        own = f"HRBFNPR_{field['name'].upper()}"
        return field.get("constants") or next(iter(mentioned), None) or (own if own in self.prefixes.values() else None)

    def scalar(self, kind):
        return SCALARS[self.typedefs.get(kind["base"], kind["base"])]

    def passed(self, kind):
        if kind["pointers"] or kind["kind"] in ("callback", "function"):
            return "p"
        return "v" if kind["c"] == "void" else PASSED[self.scalar(kind)]


def users(struct):
    """Return the user pointer of each callback of a struct: the next field whose name ends in "user"."""
    found = {}
    for at, field in enumerate(struct["fields"]):
        if field["type"]["kind"] == "callback":
            later = [other for other in struct["fields"][at + 1:] if other["name"].endswith("user")]
            found[field["name"]] = later[0]["name"]
    return found


def is_list(struct, at):
    names = [field["name"] for field in struct["fields"][at + 1:at + 3]]
    return len(names) == 2 and names[0].endswith("_count") and names[1].endswith("_stride")


def is_palette(struct, at):
    """Whether a field is a pointer to colours, and the next one their number."""
    field, after = struct["fields"][at], struct["fields"][at + 1:at + 2]
    return (field["type"]["base"] == "float" and bool(field["type"]["pointers"])
            and [one["name"] for one in after] == [f"{field['name']}_count"])


def field_layout(names, struct, at):
    """Return [kind, offset, ...] of a field; None for a field that callers do not set."""
    field, offsets = struct["fields"][at], {one["name"]: one["layout"][MODEL]["offset"] for one in struct["fields"]}
    kind, offset, name = field["type"], offsets[field["name"]], field["name"]
    if (name == "struct_size" or name.startswith("reserved") or name in users(struct).values()
            or (name.endswith(("_count", "_stride")) and any(
                is_list(struct, other) and at - other in (1, 2) for other in range(at)))
            or (at > 0 and is_palette(struct, at - 1))):
        return None
    if is_palette(struct, at):
        return ["colours", offset, offsets[f"{name}_count"]]
    if kind["kind"] == "function":  # only the release function of a custom model, which src/context.js sets
        return None
    if kind["kind"] == "callback":
        return ["callback", offset, kind["base"], offsets[users(struct)[name]]]
    if kind["kind"] == "handle":
        return ["handle", offset, kind["base"]]
    if kind["kind"] == "struct" and kind["pointers"]:
        if is_list(struct, at):
            rest = [offsets[other["name"]] for other in struct["fields"][at + 1:at + 3]]
            return ["list", offset, kind["base"], *rest]
        return ["pointer", offset, kind["base"]]
    if kind["kind"] == "struct":
        written = kind["base"] == "hrbfnpr_array_out"
        pairs = struct["name"] == "hrbfnpr_annotation" or name == "sharp_edges"
        components = 1 if name in ONE_COMPONENT else 2 if pairs else 3
        return ["arrayOut", offset] if written else ["array", offset, components]
    if kind["pointers"]:
        return ["text" if kind["base"] == "char" else "address", offset]
    if kind["base"] == "char":
        return ["chars", offset, field["array"][0]]
    count = 1
    for size in field["array"]:
        count *= size
    layout = [names.scalar(kind), offset]
    if field["array"]:
        return [*layout, count]
    group = names.group(field)
    return [*layout, 0, group_name(group)] if group else layout


def ts_type(layout):
    kind = layout[0]
    if kind == "callback":
        return type_name(layout[2])
    simple = {"colours": "readonly Numbers[]", "array": "ArrayInput", "arrayOut": "ArrayOutput", "text": "string", "chars": "string",
              "address": "Pointer"}
    if kind in simple:
        return simple[kind]
    if kind in ("handle", "pointer"):
        return type_name(layout[2])
    if kind == "list":
        return f"readonly {type_name(layout[2])}[]"
    if len(layout) == 4:
        return f"{camel(layout[3].lower(), True)}Name | number"
    return "Numbers" if len(layout) == 3 else "number"


def structs_of(api):
    """Yield (struct, [(field, layout)]) for all structs, with the fields that callers set or read."""
    names = Names(api)
    for struct in api["structs"]:
        pairs = [(field, field_layout(names, struct, at)) for at, field in enumerate(struct["fields"])]
        yield struct, [(field, layout) for field, layout in pairs if layout]


def dump(value):
    return json.dumps(value, ensure_ascii=False)


def constants_js(api):
    lines = [NOTE]
    for group in api["constants"]:
        pairs = ", ".join(f"{constant_name(one, group['prefix'])}: {one['value']}" for one in group["constants"])
        lines += textwrap.wrap(f"export const {group_name(group['prefix'])} = Object.freeze({{ {pairs} }});", 118,
                               subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)
    names = ", ".join(group_name(group["prefix"]) for group in api["constants"])
    lines += ["", "/** All groups of constants, by name. */", *textwrap.wrap(f"export const GROUPS = {{ {names} }};", 118,
                                                               subsequent_indent="  ")]
    return "\n".join(lines) + "\n"


def constants_dts(api):
    lines = [NOTE]
    for group in api["constants"]:
        name = group_name(group["prefix"])
        lines += [*documented(group["doc"]), f"export declare const {name}: {{"]
        for one in group["constants"]:
            lines += [*documented(doc_of(one), "  "),
                      f"  readonly {constant_name(one, group['prefix'])}: {one['value']};"]
        words = " | ".join(f'"{word(constant_name(one, group["prefix"]))}"' for one in group["constants"])
        lines += ["};", *documented(f"The constants of {name}, as options spell them."),
                  *textwrap.wrap(f"export type {camel(name.lower(), True)}Name = {words};", 118,
                                 subsequent_indent="  ", break_on_hyphens=False), ""]
    lines.append("export declare const GROUPS: Readonly<Record<string, Readonly<Record<string, number>>>>;")
    return "\n".join(lines) + "\n"


def layout_js(api):
    lines = [NOTE, "// [kind, offset, ...] of each field that a caller sets or reads.  bindings/js/make_js.py writes them.",
             "export const STRUCTS = {"]
    for struct, fields in structs_of(api):
        size = struct["layout"][MODEL]["size"]
        sized = any(field["name"] == "struct_size" for field in struct["fields"])
        lines.append(f"  {struct['name']}: {{ size: {size}, sized: {dump(sized)}, fields: {{")
        for field, layout in fields:
            lines.append(f"    {camel(field['name'])}: {dump(layout)},")
        lines.append("  } },")
    lines += ["};", "", "/** The offset of every field, by its name in C.  A test compares them with the module's. */",
              "export const OFFSETS = {"]
    for struct in api["structs"]:
        whole = [(field["name"], field["layout"][MODEL]["offset"]) for field in struct["fields"]]
        text = dump(dict(whole)).replace('"', "")
        lines += textwrap.wrap(f"  {struct['name']}: {text},", 118, subsequent_indent="    ")
    return "\n".join([*lines, "};"]) + "\n"


def functions_js(api):
    names = Names(api)
    lines = [NOTE, "// The types of a function: of its result, then of its parameters. p is an address, i an integer of 32 bits,",
             "// j an integer of 64 bits, f a float, d a double, and v nothing.",
             "export const FUNCTIONS = {"]
    for one in api["functions"]:
        lines.append(f"  {one['name']}: \"{signature_of(names, one)}\",")
    lines += ["};", "", "export const CALLBACKS = {"]
    for one in api["callbacks"]:
        lines.append(f"  {one['name']}: \"{signature_of(names, one)}\",")
    return "\n".join([*lines, "};"]) + "\n"


def signature_of(names, entry):
    return names.passed(entry["returns"]) + "".join(names.passed(one["type"]) for one in entry["parameters"])


def functions_dts(api):
    lines = [NOTE, "/** An address in the module's memory; 0 is NULL. */", "export type Pointer = number;", "",
             "/** The functions of the C interface, by their names in C.  64-bit integers are numbers here. */",
             "export interface Functions {"]
    for one in api["functions"]:
        parameters = ", ".join(f"{safe(part['name'])}: {raw_type(part['type'])}" for part in one["parameters"])
        lines += [*documented(f"{signature(one)}\n\n{doc_of(one)}", "  "),
                  f"  {one['name']}({parameters}): {raw_type(one['returns'])};"]
    lines += ["}", "", "export declare const FUNCTIONS: Readonly<Record<keyof Functions, string>>;",
              "export declare const CALLBACKS: Readonly<Record<string, string>>;"]
    return "\n".join(lines) + "\n"


def safe(name):
    return name + "_" if name in ("function", "in", "new", "delete") else name


def raw_type(kind):
    if kind["pointers"] or kind["kind"] in ("callback", "function"):
        return "Pointer"
    return "void" if kind["c"] == "void" else "number"


def options_dts(api):
    interfaces, used = [], set()
    for struct, fields in structs_of(api):
        if struct["name"] in ("hrbfnpr_array", "hrbfnpr_array_out", "hrbfnpr_error"):
            continue
        only_read = struct["name"].endswith(RESULTS)
        interfaces += [*documented(doc_of(struct)), f"export interface {type_name(struct['name'])} {{"]
        for field, layout in fields:
            kind = ts_type(layout)
            used |= set(re.findall(r"\w+", kind))
            mark = "readonly " if only_read else ""
            end = "" if only_read else "?"
            interfaces += [*documented(doc_of(field), "  "), f"  {mark}{camel(field['name'])}{end}: {kind};"]
        interfaces += ["}", ""]
    own = {type_name(struct["name"]) for struct in api["structs"]}
    basic = {"readonly", "number", "string", "void"} | own
    constants = sorted(name for name in used - basic if name.endswith("Name"))
    others = sorted(name for name in used - basic - set(constants) if name != "Pointer")
    head = [NOTE, f"import type {{ {', '.join(constants)} }} from \"./constants.js\";",
            'import type { Pointer } from "./functions.js";',
            f"import type {{ {', '.join(others)} }} from \"../index.js\";", ""]
    head = [line for part in head for line in (textwrap.wrap(part, 118, subsequent_indent="  ")
                                               if part.startswith("import") else [part])]
    return "\n".join([*head, *interfaces]) + "\n"


def exports_txt(api):
    names = [one["name"] for one in api["functions"]] + ["malloc", "free"]
    return "\n".join(f"_{name}" for name in names) + "\n"


def outputs(api):
    """Return the text of each file."""
    return {
        FOLDER / "constants.js": constants_js(api), FOLDER / "constants.d.ts": constants_dts(api),
        FOLDER / "layout.js": layout_js(api), FOLDER / "functions.js": functions_js(api),
        FOLDER / "functions.d.ts": functions_dts(api), FOLDER / "options.d.ts": options_dts(api),
        FOLDER / "exports.txt": exports_txt(api),
    }
