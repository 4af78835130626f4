# SPDX-License-Identifier: MIT
"""Write the crate hrbfnpr-sys from api.json: the declarations in src/lib.rs, and checks of their sizes in src/layout.rs.

bindings/generate runs it.  The results are committed.
"""
import textwrap
from pathlib import Path

from outputs import declarations

FOLDER = Path(__file__).resolve().parent / "hrbfnpr-sys"
NOTE = "// SPDX-License-Identifier: MIT\n// Made by bindings/generate from bindings/api.json; do not edit.\n"
WIDTH = 100
SCALARS = {
    "char": "c_char", "int8_t": "i8", "uint8_t": "u8", "int16_t": "i16", "uint16_t": "u16", "int32_t": "i32",
    "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64", "float": "f32", "double": "f64", "size_t": "usize",
    "void": "c_void",
}
KEYWORDS = set("""abstract as async await become box break const continue do dyn else enum extern false final fn for gen
    if impl in let loop macro match mod move mut override priv pub ref return static struct trait true try type typeof
    unsafe unsized use virtual where while yield""".split())
HANDLE = """#[repr(C)]
pub struct {name} {{
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}}"""
CRATE = """#![no_std]
#![allow(non_camel_case_types)]
#![allow(rustdoc::broken_intra_doc_links)] // [NPAR 4.1] is not a link

#[cfg(hrbfnpr_no_core_c_char)]
extern crate std;

#[cfg(not(hrbfnpr_no_core_c_char))]
use core::ffi::c_char;
use core::ffi::c_void;
use core::marker::{PhantomData, PhantomPinned};
#[cfg(hrbfnpr_no_core_c_char)]
use std::os::raw::c_char;

mod layout;"""
LAYOUT = """//! Compares sizes, alignments and offsets with those of the C compiler.  The crate does not compile if one differs.
use super::*;
use core::mem::{align_of, size_of};

/// Returns the number for 64-bit pointers, for 32-bit pointers, or for 32-bit x86, which aligns f64 to 4 bytes.
#[allow(dead_code)] // old compilers do not see its uses
const fn either(lp64: usize, ilp32: usize, i386: usize) -> usize {
    if cfg!(target_pointer_width = "64") {
        lp64
    } else if cfg!(all(target_arch = "x86", not(windows))) {
        i386
    } else {
        ilp32
    }
}"""


def named(name):
    return f"r#{name}" if name in KEYWORDS else name


def documented(text, mark="///", indent=""):
    lines = []
    for line in text.split("\n") if text else []:
        lines += [line] if len(line) < WIDTH else textwrap.wrap(line, WIDTH - 10)
    return [f"{indent}{mark} {line}".rstrip() for line in lines]


def doc_of(entry, indent=""):
    if entry.get("see"):
        return [f"{indent}/// See [`{entry['see']}`]."]
    return documented("\n\n".join(part for part in (entry["doc"], entry.get("heading")) if part), "///", indent)


def listed(first, items, last, indent=""):
    """Return `first`, the items and `last` in one line if they fit, else with one item in each line."""
    line = f"{indent}{first}{', '.join(items)}{last}"
    if len(line) <= WIDTH:
        return [line]
    return [f"{indent}{first}", *(f"{indent}    {item}," for item in items), f"{indent}{last}"]


def result_of(entry):
    kind = entry["returns"]
    return "" if kind["c"] == "void" else f" -> {rust_type(kind)}"


def parameters_of(entry):
    return [f"{named(parameter['name'])}: {rust_type(parameter['type'])}" for parameter in entry["parameters"]]


def rust_type(kind, array=()):
    if kind["kind"] == "function":
        text = f"Option<unsafe extern \"C\" fn({', '.join(parameters_of(kind))}){result_of(kind)}>"
    else:
        text = SCALARS.get(kind["base"], kind["base"])
    for pointed in kind["pointers"]:
        text = f"*{'const' if pointed == 'const' else 'mut'} {text}"
    for size in reversed(array):
        text = f"[{text}; {size}]"
    return text


class Constants:
    """Finds the type of a group of constants: from its name, from the fields that take them, or from its numbers."""

    def __init__(self, api):
        self.typedefs = {typedef["name"].upper(): typedef["name"] for typedef in api["typedefs"]}
        self.taken = {}
        for struct in api["structs"]:
            for field in struct["fields"]:
                if field.get("constants"):
                    self.taken.setdefault(field["constants"], set()).add(rust_type(field["type"]))

    def type_of(self, group):
        taken = self.taken.get(group["prefix"], set())
        if group["prefix"] in self.typedefs:
            return self.typedefs[group["prefix"]]
        if len(taken) == 1 and taken <= {"i32", "u32"}:
            return taken.pop()
        return "i32" if any(constant["value"] < 0 for constant in group["constants"]) else "u32"

    def lines(self, group):
        # A comment of //, so that it does not become the documentation of the first constant.
        yield from documented(group["doc"], "//")
        for constant in group["constants"]:
            yield from doc_of(constant)
            yield f"pub const {constant['name']}: {self.type_of(group)} = {constant['value']};"


def struct_lines(struct):
    yield from doc_of(struct)
    yield from ("#[repr(C)]", "#[derive(Debug, Clone, Copy)]", f"pub struct {struct['name']} {{")
    for field in struct["fields"]:
        yield from doc_of(field, "    ")
        yield f"    pub {named(field['name'])}: {rust_type(field['type'], field['array'])},"
    yield "}"


def callback_lines(callback):
    yield from doc_of(callback)
    name, first, last = f"pub type {callback['name']} =", 'unsafe extern "C" fn(', f"){result_of(callback)}"
    whole = f"Option<{first}{', '.join(parameters_of(callback))}{last}>;"
    if len(name) + 1 + len(whole) <= WIDTH:
        yield f"{name} {whole}"
    elif 4 + len(whole) <= WIDTH:
        yield from (name, f"    {whole}")
    else:
        lines = listed(first, parameters_of(callback), last, "    ")
        yield from (f"{name} Option<", *lines[:-1], lines[-1] + ",", ">;")


def function_lines(function):
    """Yield the lines of a function in an `extern "C"` block."""
    yield from doc_of(function, "    ")
    yield from listed(f"pub fn {function['name']}(", parameters_of(function), f"){result_of(function)};", "    ")


def sections_text(api):
    parts = [api["doc"]]
    for section in api["sections"]:
        if section["text"]:
            parts.append(f"# {section['title']}\n\n{section['text']}")
    return "\n\n".join(parts)


def lib_text(api):
    constants = Constants(api)
    titles = {section["number"]: section["title"] for section in api["sections"]}
    blocks, last = ["\n".join(documented(sections_text(api), "//!")) + "\n" + CRATE], None
    functions = []

    def close():
        if functions:
            blocks.append('extern "C" {\n' + "\n".join(functions) + "\n}")
            functions.clear()

    for kind, entry in declarations(api):
        if entry["section"] != last or kind != "function":
            close()
        if entry["section"] != last:
            last = entry["section"]
            blocks.append(f"// {last}  {titles[last]}")
        if kind == "function":
            functions.extend(function_lines(entry))
            continue
        blocks.append("\n".join({
            "enum": constants.lines,
            "struct": struct_lines,
            "callback": callback_lines,
            "handle": lambda handle: [*doc_of(handle), HANDLE.format(name=handle["name"])],
            "typedef": lambda one: [*doc_of(one), f"pub type {one['name']} = {rust_type(one['type'])};"],
        }[kind](entry)))
    close()
    return NOTE + "\n\n".join(blocks) + "\n"


def number(layout, key):
    numbers = [layout[model][key] for model in ("lp64", "ilp32", "i386")]
    return str(numbers[0]) if len(set(numbers)) == 1 else f"either({', '.join(map(str, numbers))})"


def layout_text(api):
    lines = [NOTE + LAYOUT]
    for struct in api["structs"]:
        name, whole = struct["name"], struct["layout"]
        lines += ["", "const _: () = {", f"    assert!(size_of::<{name}>() == {number(whole, 'size')});",
                  f"    assert!(align_of::<{name}>() == {number(whole, 'align')});", "};",
                  "#[cfg(not(hrbfnpr_no_offset_of))]", "const _: () = {", "    use core::mem::offset_of;"]
        for field in struct["fields"]:
            what, value = f"offset_of!({name}, {named(field['name'])})", number(field["layout"], "offset")
            line = f"    assert!({what} == {value});"
            lines += [line] if len(line) <= WIDTH else ["    assert!(", f"        {what} == {value}", "    );"]
        lines.append("};")
    return "\n".join(lines) + "\n"


def outputs(api):
    """Return the text of each file."""
    return {FOLDER / "src" / "lib.rs": lib_text(api), FOLDER / "src" / "layout.rs": layout_text(api)}
