# SPDX-License-Identifier: MIT
"""SDL2: a window, whose contents are read back."""

import ctypes.util

import run

NAME = "SDL2"


def version():
    path = ctypes.util.find_library("SDL2-2.0")
    if path is None:
        return ""
    numbers = (ctypes.c_uint8 * 3)()
    ctypes.CDLL(path).SDL_GetVersion(numbers)
    return ".".join(map(str, numbers))


def draw(work, library, examples):
    program = examples / "sdl2" / "sdl2"
    if not program.is_file():
        raise run.Missing("the examples were built without SDL2 (Debian: libsdl2-dev)")
    picture = work / "picture.rgba"
    run.on_a_screen([program, "--screenshot", picture])
    return picture
