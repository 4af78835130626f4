# SPDX-License-Identifier: MIT
"""Write the C# declarations of the C interface, HrbfNpr/Native/Native*.cs, from api.json.  bindings/generate runs it.

The results are committed.  Structs that a program reads (..._info) are written by hand, with documentation.  A test
compares their layout with that of the header.
"""
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = HERE / "HrbfNpr" / "Native"

HANDLES = {
    "hrbfnpr_context": "ContextHandle",
    "hrbfnpr_operation": "OperationHandle",
    "hrbfnpr_model": "ModelHandle",
    "hrbfnpr_point_set": "PointSetHandle",
    "hrbfnpr_line_set": "LineSetHandle",
    "hrbfnpr_field": "FieldHandle",
    "hrbfnpr_mesh": "MeshHandle",
    "hrbfnpr_occluders": "OccludersHandle",
    "hrbfnpr_shading": "ShadingHandle",
    "hrbfnpr_renderer": "RendererHandle",
    "hrbfnpr_drawing": "DrawingHandle",
    "hrbfnpr_picture": "PictureHandle",
    "hrbfnpr_settings": "SettingsHandle",
}
# Structs that are written by hand, with the names of their C# types.
BY_HAND = {
    "hrbfnpr_context_info": "ContextInfo",
    "hrbfnpr_model_info": "ModelInfo",
    "hrbfnpr_orient_info": "OrientationInfo",
    "hrbfnpr_depth_image_info": "DepthImageInfo",
    "hrbfnpr_point_set_info": "PointSetInfo",
    "hrbfnpr_layer_info": "LayerInfo",
    "hrbfnpr_placement_info": "PlacementInfo",
    "hrbfnpr_line_set_info": "LineSetInfo",
    "hrbfnpr_trim_info": "TrimInfo",
    "hrbfnpr_csg_info": "CsgInfo",
    "hrbfnpr_mesh_info": "MeshInfo",
    "hrbfnpr_mesh_edges_info": "MeshEdgesInfo",
    "hrbfnpr_mesh_fit_info": "MeshFitInfo",
    "hrbfnpr_comparison": "MeshComparison",
    "hrbfnpr_drawing_info": "DrawingInfo",
    "hrbfnpr_drawing_layer_info": "DrawingLayerInfo",
    "hrbfnpr_mark_identity": "MarkIdentity",
    "hrbfnpr_page_info": "PageInfo",
    "hrbfnpr_source_info": "SourceInfo",
    "hrbfnpr_picture_info": "PictureInfo",
    "hrbfnpr_views_info": "ViewsInfo",
}
# Sections of the header whose structs are written to a separate file.
DRAWN = (9, 10, 11, 12)  # cameras, styles, renderers, drawings
PICTURES = (15, 16)  # pictures, views
SCALARS = {
    "int8_t": "sbyte",
    "uint8_t": "byte",
    "int16_t": "short",
    "uint16_t": "ushort",
    "int32_t": "int",
    "uint32_t": "uint",
    "int64_t": "long",
    "uint64_t": "ulong",
    "double": "double",
    "float": "float",
    "char": "byte",
    "size_t": "UIntPtr",
    "void": "void",
}
KEYWORDS = {"base", "class", "event", "fixed", "in", "out", "params", "ref"}  # the keywords of C# that are valid names in C
NOTE = "// SPDX-License-Identifier: MIT\n// Made by make_native.py from include/hrbfnpr.h; do not edit.\n"
PRELUDE = "using System;\nusing System.Runtime.InteropServices;\n"


def value_type(kind):
    """The C# type of a value that is not a pointer."""
    base = kind["base"]
    if kind["kind"] != "struct":
        return SCALARS[base]
    if base == "hrbfnpr_array_out":
        base = "hrbfnpr_array"  # both have the same layout
    return BY_HAND.get(base, base)


def parameter_type(function, kind):
    """The C# type of a parameter or a result."""
    base, stars = kind["base"], len(kind["pointers"])
    if kind["kind"] == "callback":
        return "IntPtr"
    if kind["kind"] == "handle":
        if base not in HANDLES:
            raise SystemExit(f"give {base} a class, in Native/Handles.cs and in bindings/csharp/make_native.py")
        if stars == 2:
            return "out IntPtr"
        # These functions take raw pointers.  An operation or a solid may be made after the program has disposed of its
        # context, and retain and release run on pointers that have no handle yet or any more.
        raw = function.endswith(("_retain", "_release")) or (
            function in ("hrbfnpr_operation_create", "hrbfnpr_model_create_csg") and base == "hrbfnpr_context")
        return "IntPtr" if raw else HANDLES[base]
    return value_type(kind) + "*" * stars


def escaped(name):
    return "@" + name if name in KEYWORDS else name


def methods(functions):
    for function in functions:
        name = function["name"]
        parameters = []
        for parameter in function["parameters"]:
            user = parameter["name"].endswith("user")
            kind = "IntPtr" if user else parameter_type(name, parameter["type"])
            parameters.append(f"{kind} {escaped(parameter['name'])}")
        yield parameter_type(name, function["returns"]), name, parameters


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
    lines += ["    }", "}", "#endif", ""]
    return "\n".join(lines)


def fields(struct):
    for field in struct["fields"]:
        name, kind, count = field["name"], field["type"], math.prod(field["array"])
        name = escaped(name)
        pointer = kind["pointers"] or kind["kind"] in ("callback", "function")
        native = "IntPtr" if pointer else value_type(kind)
        if not field["array"]:
            yield f"{native} {name};"
        elif not pointer and kind["kind"] == "scalar":
            yield f"fixed {native} {name}[{count}];"
        else:
            yield f"{native} " + ", ".join(f"{name}{i}" for i in range(count)) + ";"


def struct_file(structs):
    lines = [NOTE + "#pragma warning disable 169, 649 // some fields are only read or written by the library",
             PRELUDE + "\nnamespace HrbfNpr", "{"]
    for struct in structs:
        name = struct["name"]
        if name in BY_HAND:
            continue
        lines += [f'    [StructLayout(LayoutKind.Sequential), NativeStruct("{name}")]',
                  f"    internal unsafe struct {name}", "    {"]
        for field in fields(struct):
            if ", " in field:
                lines += wrapped("        internal", field[:-1].split(", "), ";")
            else:
                lines.append(f"        internal {field}")
        lines += ["    }", ""]
    lines[-1:] = ["}", ""]
    return "\n".join(lines)


def constants(abi):
    return (NOTE + "namespace HrbfNpr\n{\n    internal static unsafe partial class NativeMethods\n    {\n"
            "        /// <summary>The ABI version that this assembly was made for.</summary>\n"
            f"        internal const uint AbiVersion = {abi};\n    }}\n}}\n")


def outputs(api):
    """Return the text of each file."""
    functions = api["functions"]
    SCALARS.update({typedef["name"]: SCALARS[typedef["type"]["base"]] for typedef in api["typedefs"]})
    return {FOLDER / name: text for name, text in {
        "NativeMethods.DllImport.cs": method_file(
            functions, "!NET7_0_OR_GREATER",
            ["[DllImport(Name, CallingConvention = CallingConvention.Cdecl)]"], "extern", PRELUDE + "\n"),
        "NativeMethods.LibraryImport.cs": method_file(
            functions, "NET7_0_OR_GREATER",
            ["[LibraryImport(Name), UnmanagedCallConv(CallConvs = new[] { typeof(CallConvCdecl) })]"], "partial",
            PRELUDE.replace("InteropServices;", "CompilerServices;\nusing System.Runtime.InteropServices;") + "\n"),
        "NativeMethods.Constants.cs": constants(api["abi_version"]),
        "NativeStructs.cs": struct_file([each for each in api["structs"] if each["section"] not in DRAWN + PICTURES]),
        "NativeStructs.Drawn.cs": struct_file([each for each in api["structs"] if each["section"] in DRAWN]),
        "NativeStructs.Pictures.cs": struct_file([each for each in api["structs"] if each["section"] in PICTURES]),
    }.items()}
