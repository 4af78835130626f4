# SPDX-License-Identifier: MIT
"""The scene that each package draws when it is tried, and the hash of its picture.

The scene is the common scene of examples/README.md: the samples of examples/torus.xyzn seen along (0, 1, -1) with up
(0, 0, 1), drawn by one call of hrbfnpr_picture_create with its defaults into 640 x 480 pixels.  A program of the scene
takes the samples and the picture as arguments and writes the bytes of the RGBA8 image, row by row, and nothing else.
"""
from __future__ import annotations

import hashlib
import struct
import zlib
from pathlib import Path
from typing import Dict, List

from common import ROOT

SAMPLES = ROOT / "examples" / "torus.xyzn"
C_PROGRAM = ROOT / "tests" / "clients" / "reference.c"
CSHARP_PROJECT = ROOT / "tests" / "clients" / "csharp" / "Scene.csproj"
WIDTH, HEIGHT = 640, 480

# The scene by the Python package.
PYTHON_PROGRAM = """
import sys
import numpy, hrbfnpr

samples = numpy.loadtxt(sys.argv[1])
picture = hrbfnpr.draw((samples[:, :3], samples[:, 3:]), direction=(0, 1, -1), up=(0, 0, 1), size=(640, 480))
picture.image.tofile(sys.argv[2])
"""

# The scene by the Python package without NumPy: hrbfnpr.draw needs it, so this program calls the C functions.
PLAIN_PYTHON_PROGRAM = """
import sys
from hrbfnpr._library import ffi, lib

WIDTH, HEIGHT = 640, 480
error = ffi.new("hrbfnpr_error *", {"struct_size": ffi.sizeof("hrbfnpr_error")})


def new(name):
    struct = ffi.new(f"hrbfnpr_{name} *")
    assert getattr(lib, f"hrbfnpr_{name}_init")(struct, ffi.sizeof(struct[0])) == 0
    return struct


def made(call, kind, *arguments):
    out = ffi.new(f"hrbfnpr_{kind} **")
    assert call(*arguments, out, error) == 0, ffi.string(error.message)
    return out[0]


samples = [[float(word) for word in line.split()] for line in open(sys.argv[1])]
parts = [ffi.new("double[]", [x for sample in samples for x in sample[i:i + 3]]) for i in (0, 3)]
source, desc, image = new("picture_source"), new("picture_desc"), new("image")
for array, numbers in zip((source.points, source.normals), parts):
    array.data, array.count, array.scalar, array.components = numbers, len(samples), lib.HRBFNPR_SCALAR_FLOAT64, 3
desc.sources, desc.source_count, desc.width, desc.height = source, 1, WIDTH, HEIGHT
desc.direction, desc.up = (0, 1, -1), (0, 0, 1)
pixels = ffi.new("unsigned char[]", 4 * WIDTH * HEIGHT)
image.width, image.height, image.pixels = WIDTH, HEIGHT, pixels
context = made(lib.hrbfnpr_context_create, "context", ffi.NULL)
picture = made(lib.hrbfnpr_picture_create, "picture", context, desc, ffi.NULL)
drawing = made(lib.hrbfnpr_picture_draw, "drawing", picture, ffi.NULL, ffi.NULL)
assert lib.hrbfnpr_picture_rasterize(picture, drawing, ffi.NULL, image, error) == 0, ffi.string(error.message)
with open(sys.argv[2], "wb") as file:
    file.write(ffi.buffer(pixels))
"""

# `hrbfnpr draw SAMPLES PICTURE` draws the scene with these options. PICTURE ends with .png.
COMMAND_OPTIONS: List[str] = ["--direction=0,1,-1", "--up=z", "--size=640x480"]


def picture_hash(path: Path) -> str:
    """Return the first 16 digits of the SHA-256 of the RGBA8 pixels in a raw file or a PNG."""
    data = Path(path).read_bytes()
    pixels = png_pixels(data) if data.startswith(PNG_SIGNATURE) else data
    if len(pixels) != 4 * WIDTH * HEIGHT:
        raise ValueError(f"{path} has {len(pixels)} bytes of pixels in place of {4 * WIDTH * HEIGHT}")
    return hashlib.sha256(pixels).hexdigest()[:16]


PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
PNG_CHANNELS = {2: 3, 6: 4}  # colour type -> bytes of a pixel, for RGB and RGBA


def png_pixels(data: bytes) -> bytes:
    """Return the RGBA8 pixels of a PNG with 8 bits for each channel that is not interlaced."""
    chunks = png_chunks(data)
    width, height, depth, colour, *_, interlaced = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    if depth != 8 or colour not in PNG_CHANNELS or interlaced:
        raise ValueError("only PNGs with 8-bit RGB or RGBA that are not interlaced can be read")
    channels = PNG_CHANNELS[colour]
    pixels = png_rows(zlib.decompress(chunks[b"IDAT"]), width * channels, height, channels)
    if channels == 4:
        return bytes(pixels)
    opaque = bytearray(b"\xff") * (4 * width * height)
    for channel in range(3):
        opaque[channel::4] = pixels[channel::3]
    return bytes(opaque)


def png_chunks(data: bytes) -> Dict[bytes, bytes]:
    """Return the chunks by name.  Chunks of the same name are joined."""
    chunks: Dict[bytes, bytes] = {}
    place = len(PNG_SIGNATURE)
    while place < len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        chunks[name] = chunks.get(name, b"") + data[place + 8:place + 8 + length]
        place += 12 + length
    return chunks


def png_rows(packed: bytes, stride: int, height: int, channels: int) -> bytearray:
    """Undo the filters of a PNG's rows, which are given with a leading byte for the filter."""
    above = bytearray(stride)
    pixels = bytearray()
    for start in range(0, height * (stride + 1), stride + 1):
        row = bytearray(packed[start + 1:start + 1 + stride])
        unfilter(packed[start], row, above, channels)
        pixels += row
        above = row
    return pixels


def unfilter(kind: int, row: bytearray, above: bytearray, channels: int) -> None:
    if kind == 2:  # the filter "up"
        row[:] = bytes((byte + up) & 255 for byte, up in zip(row, above))
    elif kind:
        for i, byte in enumerate(row):
            left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
            guess = {1: left, 3: (left + above[i]) // 2, 4: paeth(left, above[i], corner)}[kind]
            row[i] = (byte + guess) & 255


def paeth(left: int, up: int, corner: int) -> int:
    """Return the neighbour that is nearest to left + up - corner, as the PNG standard defines it."""
    guess = left + up - corner
    distances = abs(guess - left), abs(guess - up), abs(guess - corner)
    return (left, up, corner)[distances.index(min(distances))]
