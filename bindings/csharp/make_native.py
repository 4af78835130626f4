#!/usr/bin/env python3
"""Make the C# declarations of the C boundary, HrbfNpr/Native/Native*.cs, from include/hrbfnpr.h.

    make_native.py            write them
    make_native.py --check    fail if they are not what the header says

Run it after every change of the header.  The results are committed.  Structs that a program reads
(..._info) are written by hand, with documentation; a test compares their layout with the header's.
"""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = HERE / "HrbfNpr" / "Native"
sys.path.insert(0, str(HERE.parents[1] / "tests" / "abi"))
sys.dont_write_bytecode = True

import header  # noqa: E402

HANDLES = {
    "hrbfnpr_context": "ContextHandle",
    "hrbfnpr_operation": "OperationHandle",
    "hrbfnpr_model": "ModelHandle",
    "hrbfnpr_point_set": "PointSetHandle",
    "hrbfnpr_renderer": "RendererHandle",
}
# Structs that are written by hand.
BY_HAND = {
    "hrbfnpr_context_info": "ContextInfo",
    "hrbfnpr_model_info": "ModelInfo",
    "hrbfnpr_level_info": "LevelInfo",
    "hrbfnpr_group_info": "GroupInfo",
    "hrbfnpr_point_set_info": "PointSetInfo",
    "hrbfnpr_frame_info": "FrameInfo",
}
SCALARS = {
    "int32_t": "int",
    "uint32_t": "uint",
    "int64_t": "long",
    "uint64_t": "ulong",
    "double": "double",
    "float": "float",
    "char": "byte",
    "void": "void",
    "hrbfnpr_status": "int",
}
NOTE = "// Made by make_native.py from include/hrbfnpr.h; do not edit.\n"
PRELUDE = "using System;\nusing System.Runtime.InteropServices;\n"


def value_type(name):
    if name == "hrbfnpr_array_out":
        name = "hrbfnpr_array"  # of the same layout
    return BY_HAND.get(name) or SCALARS.get(name) or name


def parameter_type(function, declaration):
    """The C# type of a parameter such as `const hrbfnpr_model* model`."""
    kind = re.sub(r"\bconst\b|\s", "", declaration)
    base, stars = kind.rstrip("*"), kind.count("*")
    if base.endswith("_fn"):
        return "IntPtr"
    if base in HANDLES:
        if stars == 2:
            return "out IntPtr"
        # An operation can outlive the program's handle of its context, and release gets what is left of a handle.
        raw = function.endswith(("_retain", "_release")) or (function, base) == (
            "hrbfnpr_operation_create", "hrbfnpr_context")
        return "IntPtr" if raw else HANDLES[base]
    return value_type(base) + "*" * stars


def methods(functions):
    for name, signature in functions.items():
        result, rest = re.match(rf"(.*?)\s*\b{name}\s*\((.*)\)$", signature).groups()
        parameters = []
        for part in rest.split(","):
            if part.strip() == "void":
                continue
            declaration, parameter = re.match(r"(.*?)(\w+)$", part.strip()).groups()
            kind = "IntPtr" if parameter == "user" else parameter_type(name, declaration)
            parameters.append(f"{kind} {parameter}")
        yield parameter_type(name, result), name, parameters


def wrapped(first, parameters, last):
    line = first
    for index, parameter in enumerate(parameters):
        piece = parameter + ("," if index + 1 < len(parameters) else last)
        if len(line) + 1 + len(piece) > 118:
            yield line.rstrip()
            line = "            "
        line += ("" if line.endswith(("(", "            ")) else " ") + piece
    yield line if parameters else line + last


def method_file(functions, condition, attribute, modifiers, usings):
    lines = [NOTE + f"#if {condition}", usings + "namespace HrbfNpr", "{",
             "    internal static unsafe partial class NativeMethods", "    {"]
    for result, name, parameters in methods(functions):
        lines += ["        " + part for part in attribute]
        lines += wrapped(f"        internal static {modifiers} {result} {name}(", parameters, ");")
        lines.append("")
    lines[-1:] = ["    }", "}", "#endif", ""]
    return "\n".join(lines)


def fields(name, types):
    for key, declaration in types.items():
        if not key.startswith(name + "."):
            continue
        field = key.split(".")[1]
        kind, count = re.match(rf"(.*?)\b{field}\)?(?:\[(\d+)\]|\(.*\))?$", declaration).groups()
        kind = re.sub(r"\bconst\b|\s|\(\*$", "", kind)
        if kind.endswith("*") or kind.endswith("_fn") or "(*" in declaration:
            yield f"IntPtr {field};"
        elif count is None:
            yield f"{value_type(kind)} {field};"
        elif kind in SCALARS:
            yield f"fixed {value_type(kind)} {field}[{count}];"
        else:
            yield f"{value_type(kind)} " + ", ".join(f"{field}{i}" for i in range(int(count))) + ";"


def struct_file(declared):
    lines = [NOTE + "#pragma warning disable 169, 649 // some fields are only read or written by the library",
             PRELUDE + "\nnamespace HrbfNpr", "{"]
    for name in declared.structs:
        if name in BY_HAND:
            continue
        lines += [f'    [StructLayout(LayoutKind.Sequential), NativeStruct("{name}")]',
                  f"    internal unsafe struct {name}", "    {"]
        for field in fields(name, declared.types):
            if ", " in field:
                lines += wrapped("        internal", field[:-1].split(", "), ";")
            else:
                lines.append(f"        internal {field}")
        lines += ["    }", ""]
    lines[-1:] = ["}", ""]
    return "\n".join(lines)


def constants():
    text = header.HEADER.read_text(encoding="utf-8")
    abi = re.search(r"HRBFNPR_ABI_VERSION = (\d+)", text).group(1)
    return (NOTE + "namespace HrbfNpr\n{\n    internal static unsafe partial class NativeMethods\n    {\n"
            "        /// <summary>The ABI version that this assembly was made for.</summary>\n"
            f"        internal const uint AbiVersion = {abi};\n    }}\n}}\n")


def generate():
    declared = header.read()
    return {
        "NativeMethods.DllImport.cs": method_file(
            declared.functions, "!NET7_0_OR_GREATER",
            ["[DllImport(Name, CallingConvention = CallingConvention.Cdecl)]"], "extern", PRELUDE + "\n"),
        "NativeMethods.LibraryImport.cs": method_file(
            declared.functions, "NET7_0_OR_GREATER",
            ["[LibraryImport(Name), UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]"], "partial",
            PRELUDE.replace("InteropServices;", "CompilerServices;\nusing System.Runtime.InteropServices;") + "\n"),
        "NativeMethods.Constants.cs": constants(),
        "NativeStructs.cs": struct_file(declared),
    }


def main():
    out_of_date = []
    for name, text in generate().items():
        path = FOLDER / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            out_of_date.append(name)
            if "--check" not in sys.argv[1:]:
                path.write_text(text, encoding="utf-8")
    if "--check" in sys.argv[1:]:
        for name in out_of_date:
            print(f"{name} is out of date: run {Path(__file__).name}")
        if not out_of_date:
            print("the C# declarations are what the header says")
        return 1 if out_of_date else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
