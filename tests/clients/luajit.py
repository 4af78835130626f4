# SPDX-License-Identifier: MIT
"""LuaJIT's FFI with the declarations of bindings/cdef: a picture, a callback and an error (luajit.lua)."""

import run

NAME = "LuaJIT FFI"
BY_STEPS = True  # tests more of the raw declarations than hrbfnpr_picture_create needs
CDEF = run.ROOT / "bindings" / "cdef" / "hrbfnpr_cdef.h"


def version():
    return run.run([run.need("luajit", "luajit"), "-v"]).split()[1]


def draw(work, library, examples):
    picture = work / "picture.rgba"
    program = run.ROOT / "tests" / "clients" / "luajit.lua"
    run.run(["luajit", program, CDEF, library, run.SAMPLES, picture])
    return picture
