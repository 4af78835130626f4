# SPDX-License-Identifier: MIT
"""Makes src/api/struct_fields.h and src/picture/field_names.h from api.json.

The first holds what hrbfnpr_layout reports of each struct.  The second holds the fields of some structs by name, for
settings and for hrbfnpr_change.  bindings/generate runs this module.  The results are committed; the compiler fills in
sizes and offsets.
"""
import re
import textwrap

from outputs import ROOT

PATH = ROOT / "src/api/struct_fields.h"
NAMES_PATH = ROOT / "src/picture/field_names.h"
HEAD = """// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
#pragma once
// clang-format off

#include "hrbfnpr.h"

#include <cstddef>

namespace hrbfnpr::api {

struct FieldLayout {
    const char* name;
    const char* type; // as C writes it, with [n] for an array
    std::size_t offset, size; // bytes
};

#define FIELD(field, type) {#field, type, offsetof(RECORD, field), sizeof(RECORD::field)}
"""


def type_of(field):
    return field["type"]["c"] + "".join(f"[{size}]" for size in field["array"])


def packed(items, end=""):
    """The items, separated by commas or spaces, wrapped into lines of 120 columns."""
    fill = textwrap.TextWrapper(width=120 - len(end), initial_indent="    ", subsequent_indent="    ",
                                break_long_words=False, break_on_hyphens=False)
    return f"{end}\n".join(line.replace("\0", " ") for line in fill.wrap(items))


def fields_of(struct):
    items = [f'FIELD({field["name"]},\0"{type_of(field)}")'.replace(" ", "\0") for field in struct["fields"]]
    return (f"#define RECORD {struct['name']}\n"
            f"inline constexpr FieldLayout fields_of_{struct['name']}[] = {{\n{packed(', '.join(items))}}};\n"
            "#undef RECORD\n")


# ---- Fields by their names

NAMES_HEAD = """// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
#pragma once
// clang-format off

#include "picture/field_table.h"

#include <cstddef>

namespace hrbfnpr::picture {

#define FIELD(field, scalar, meaning, count, first_choice, choices) \\
    {#field, offsetof(RECORD, field), Scalar::scalar, Meaning::meaning, count, first_choice, choices}
"""
NAMED = ("style", "layer_style", "line_style", "fit_desc", "mesh_fit_desc", "generate_desc", "layer_desc",
         "line_set_desc", "line_desc", "page_desc", "shading_desc", "light")
SCALARS = {"float": "float32", "double": "float64", "int32_t": "int32", "uint32_t": "uint32", "int64_t": "int64",
           "uint64_t": "uint64", "const char*": "text"}
# Constants that need a function or an array in another field.  A text cannot give that.
WANT_MORE = ("HRBFNPR_TONE_CALLBACK", "HRBFNPR_DENSITY_CALLBACK", "HRBFNPR_DENSITY_FIELD", "HRBFNPR_KERNEL_CUSTOM", "HRBFNPR_KERNEL_CSG",
             "HRBFNPR_LINE_KIND_OWN")
# In these structs they are allowed: a line style also draws lines that the caller gave.
BUT_IN = ("hrbfnpr_line_style",)


def is_named(field):
    """Whether a text can be the field's value, and a user would change the field."""
    name = field["name"]
    return (field["type"]["c"] in SCALARS and name != "struct_size"
            and not name.startswith("reserved") and not name.endswith(("_count", "_stride")))


def choices_of(field, struct, constants):
    """(name, value) of every choice that the field's comment lists; empty for a number."""
    bits = re.findall(r"\bbit (\d+) the (\w+)", field["doc"])
    if bits:
        return tuple((name, 1 << int(bit)) for bit, name in bits)
    prefix = field.get("constants")
    if prefix is not None:
        names = list(constants[prefix])
    else:  # "HRBFNPR_REPAIR_KEEP or DROP", "HRBFNPR_PAGE_IN_PLOT_ORDER and others"
        found = re.match(r"(HRBFNPR_\w+)((?:, [A-Z_]+)*(?: or [A-Z_]+)?)( and others)?", field["doc"])
        if found is None:
            return ()
        prefix = next(prefix for prefix, group in constants.items() if found[1] in group)
        more = [f"{prefix}_{word}" for word in re.findall("[A-Z_]+", found[2])]
        names = list(constants[prefix]) if found[3] else [found[1], *more]
    return tuple((name[len(prefix) + 1:].lower(), constants[prefix][name]) for name in names
                 if name not in WANT_MORE or struct in BUT_IN)


def meaning_of(field, choices):
    if field["type"]["c"] == "const char*":
        return "text"
    if field["array"]:
        return {("float", 4): "colour", ("double", 3): "direction"}[field["type"]["c"], field["array"][0]]
    if field["doc"].startswith("1 or 0"):
        return "yes_no"
    if choices:
        return "bits" if field["name"] == "flags" or "bit 0" in field["doc"] else "choice"
    return "number"


def names(api):
    constants = {group["prefix"]: {one["name"]: one["value"] for one in group["constants"]}
                 for group in api["constants"]}
    structs = {struct["name"]: struct for struct in api["structs"]}
    firsts, table, parts = {}, [], []
    for name in (f"hrbfnpr_{name}" for name in NAMED):
        items = []
        for field in filter(is_named, structs[name]["fields"]):
            choices = choices_of(field, name, constants)
            if choices not in firsts:
                firsts[choices] = len(table) if choices else 0
                table += choices
            row = (field["name"], SCALARS[field["type"]["c"]], meaning_of(field, choices),
                   field["array"][0] if field["array"] else 1, firsts[choices], len(choices))
            items.append(f"FIELD({', '.join(map(str, row))})".replace(" ", "\0"))
        parts.append(f"#define RECORD {name}\ninline constexpr NamedField names_of_{name}[] = {{\n"
                     f"{packed(', '.join(items))}}};\n#undef RECORD\n")
    rows = ", ".join(f'{{"{name}",\0{value}}}' for name, value in table)
    structs_named = packed(" ".join(f"X({name})" for name in NAMED), " \\")
    return "".join([
        NAMES_HEAD, f"\ninline constexpr NamedConstant named_constants[] = {{\n{packed(rows)}}};\n\n", *parts,
        "#undef FIELD\n\n// Calls X for each of these structs, with its name without hrbfnpr_.\n#define HRBFNPR_NAMED_STRUCTS(X) \\\n",
        f"{structs_named}\n\n}} // namespace hrbfnpr::picture\n"])


def outputs(api):
    table = packed(" ".join(f"X({struct['name']})" for struct in api["structs"]), " \\")
    parts = [HEAD, "\n", *map(fields_of, api["structs"]), "#undef FIELD\n",
             f"\n// X(name) of all structs, in the header's order.\n#define HRBFNPR_STRUCTS(X) \\\n{table}\n",
             "\n} // namespace hrbfnpr::api\n"]
    return {PATH: "".join(parts), NAMES_PATH: names(api)}

# ---- Fields by name