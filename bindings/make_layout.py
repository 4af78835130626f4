# SPDX-License-Identifier: MIT
"""src/api/struct_fields.h: what hrbfnpr_layout tells of each struct, from api.json.

bindings/generate runs it.  The result is committed; the compiler fills in sizes and offsets.
"""
import textwrap

from outputs import ROOT

PATH = ROOT / "src/api/struct_fields.h"
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
    """The items, separated by commas or spaces, side by side in lines of 120 columns."""
    fill = textwrap.TextWrapper(width=120 - len(end), initial_indent="    ", subsequent_indent="    ",
                                break_long_words=False, break_on_hyphens=False)
    return f"{end}\n".join(line.replace("\0", " ") for line in fill.wrap(items))


def fields_of(struct):
    items = [f'FIELD({field["name"]},\0"{type_of(field)}")'.replace(" ", "\0") for field in struct["fields"]]
    return (f"#define RECORD {struct['name']}\n"
            f"inline constexpr FieldLayout fields_of_{struct['name']}[] = {{\n{packed(', '.join(items))}}};\n"
            "#undef RECORD\n")


def outputs(api):
    table = packed(" ".join(f"X({struct['name']})" for struct in api["structs"]), " \\")
    parts = [HEAD, "\n", *map(fields_of, api["structs"]), "#undef FIELD\n",
             f"\n// X(name) of all structs, in the header's order.\n#define HRBFNPR_STRUCTS(X) \\\n{table}\n",
             "\n} // namespace hrbfnpr::api\n"]
    return {PATH: "".join(parts)}
