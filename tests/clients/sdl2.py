# SPDX-License-Identifier: MIT
"""SDL2: a window whose contents are read back."""

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
    check_strokes(program, work / "strokes.rgba")
    return picture


def check_strokes(program, path):
    """Hatching drawn as triangles with a brush is ink on white paper with soft edges."""
    run.on_a_screen([program, "--strokes", "--screenshot", path])
    grey = path.read_bytes()[::4]
    if len(grey) != run.WIDTH * run.HEIGHT or set(grey[: run.WIDTH]) != {255}:
        raise run.Failed("the strokes are not on white paper")
    ink = sum(255 - value for value in grey) / 255 / len(grey)
    soft = sum(40 < value < 215 for value in grey) / len(grey)
    if not (0.01 < ink < 0.2 and soft > 0.08):
        raise run.Failed(f"the strokes cover {ink:.3f} of the picture, {soft:.3f} of it softly")
