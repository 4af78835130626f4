# SPDX-License-Identifier: MIT
"""The Python declarations match the header."""
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

from hrbfnpr._cffi import ffi

sys.path.append(str(ROOT / "bindings"))

import outputs  # noqa: E402

API = outputs.load()


def test_the_committed_module_is_up_to_date():
    pytest.importorskip("pycparser")
    command = [sys.executable, "-B", ROOT / "bindings" / "generate", "--check", "python"]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr


def constants():
    return [constant["name"] for group in API["constants"] for constant in group["constants"]]


def layout_program():
    """A C program that prints the sizes and offsets of all structs, and all constants."""
    lines = ["#include <hrbfnpr.h>", "#include <stddef.h>", "#include <stdio.h>", "int main(void) {"]
    for name in ffi.list_types()[0]:
        if ffi.typeof(name).kind != "struct" or ffi.typeof(name).fields is None:
            continue
        lines.append(f'printf("{name} %d\\n", (int)sizeof({name}));')
        for field, _ in ffi.typeof(name).fields:
            lines.append(f'printf("{name}.{field} %d\\n", (int)offsetof({name}, {field}));')
    for name in constants():
        lines.append(f'printf("{name} %d\\n", (int){name});')
    return "\n".join([*lines, "return 0; }"])


def test_layouts_and_constants_match_the_compilers(tmp_path):
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        pytest.skip("no C compiler")
    source, program = tmp_path / "layout.c", tmp_path / "layout"
    source.write_text(layout_program())
    subprocess.run([compiler, f"-I{ROOT / 'include'}", "-o", program, source], check=True)
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    assert len(lines) > 300
    for line in lines:
        name, value = line.split()
        if name.startswith("HRBFNPR_"):
            ours = ffi.integer_const(name)
        elif "." in name:
            struct, field = name.split(".")
            ours = ffi.offsetof(struct, field)
        else:
            ours = ffi.sizeof(name)
        assert ours == int(value), name


def test_every_declared_function_is_in_the_library():
    import hrbfnpr._library as library

    assert len(API["functions"]) > 60
    for function in API["functions"]:
        parameters = ", ".join(parameter["type"]["c"] for parameter in function["parameters"]) or "void"
        wanted = ffi.typeof(f"{function['returns']['c']} (*)({parameters})")
        assert ffi.typeof(getattr(library.lib, function["name"])) is wanted, function["name"]


def test_dataclasses_hold_every_field_of_their_structs():
    import dataclasses

    import hrbfnpr

    pairs = {
        "hrbfnpr_context_info": hrbfnpr.ContextInfo,
        "hrbfnpr_model_info": hrbfnpr.ModelInfo,
        "hrbfnpr_point_set_info": hrbfnpr.PointSetInfo,
        "hrbfnpr_layer_info": hrbfnpr.LayerInfo,
        "hrbfnpr_placement_info": hrbfnpr.PlacementInfo,
        "hrbfnpr_drawing_info": hrbfnpr.DrawingInfo,
        "hrbfnpr_line_set_info": hrbfnpr.LineSetInfo,
        "hrbfnpr_trim_info": hrbfnpr.TrimInfo,
        "hrbfnpr_drawing_layer_info": hrbfnpr.DrawingLayerInfo,
        "hrbfnpr_mark_identity": hrbfnpr.MarkIdentity,
    }
    for struct, kind in pairs.items():
        theirs = {name for name, _ in ffi.typeof(struct).fields} - {"struct_size", "reserved", "reserved2"}
        assert {field.name for field in dataclasses.fields(kind)} == theirs, struct


def test_the_stub_names_the_fields_of_records():
    import ast
    import dataclasses
    from pathlib import Path

    from hrbfnpr import _records

    tree = ast.parse(Path(_records.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    assert len(classes) > 20
    for node in classes:
        named = [part.target.id for part in node.body if isinstance(part, ast.AnnAssign)]
        kind = getattr(_records, node.name)
        fields = [field.name for field in dataclasses.fields(kind)] if dataclasses.is_dataclass(kind) else list(kind.fields())
        assert named == fields, node.name


def test_the_import_makes_no_records_and_looks_for_no_compiler():
    import subprocess
    import sys

    script = (
        "import sys, hrbfnpr\n"
        "assert 'ModelInfo' not in vars(hrbfnpr._records)\n"
        "assert 'ctypes.util' not in sys.modules\n"
        "assert hrbfnpr.ModelInfo is hrbfnpr._records.ModelInfo\n"
        "assert 'ModelInfo' in vars(hrbfnpr) and 'TrimInfo' not in vars(hrbfnpr)\n"
        "from hrbfnpr import *\n"
        "assert TrimInfo is hrbfnpr.TrimInfo\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


def test_style_has_every_field_of_its_struct():
    import hrbfnpr

    def fields(struct):
        names = {name for name, _ in ffi.typeof(struct).fields} - {"struct_size"}
        return {name for name in names if not name.startswith("reserved")}

    names = {"name", "density_field", "tone_field", "width_field", "ink_field", "mask_field"}
    assert {*hrbfnpr.LayerStyle.fields(), *names} == fields("hrbfnpr_layer_style")
    assert {*hrbfnpr.LineStyle.fields(), "name", "levels"} == fields("hrbfnpr_line_style")
    theirs = fields("hrbfnpr_style") - {"tone_function", "tone_user", "layers", "layer_count", "layer_stride"}
    theirs -= {"lines", "line_count", "line_stride", "light_count", "light_stride", "palette_count"}
    assert {*hrbfnpr.Style.fields(), "tone", "lights", "palette"} == theirs


@pytest.mark.parametrize(
    "function, struct",
    [
        ("Model.fit", "hrbfnpr_fit_desc"),
        ("Model.project", "hrbfnpr_project_desc"),
        ("PointSet.generate", "hrbfnpr_generate_desc"),
        ("Layer.__init__", "hrbfnpr_layer_desc"),
    ],
)
def test_default_arguments_match_the_librarys(function, struct):
    import inspect

    import hrbfnpr
    from hrbfnpr._errors import new_struct

    kind, method = function.split(".")
    desc = new_struct(struct)
    checked = 0
    for name, parameter in inspect.signature(getattr(getattr(hrbfnpr, kind), method)).parameters.items():
        value = getattr(desc, name, None)
        if isinstance(parameter.default, (int, float)) and isinstance(value, (int, float)):
            assert parameter.default == value, name
            checked += 1
    assert checked >= 4
