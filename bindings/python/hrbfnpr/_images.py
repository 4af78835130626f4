# SPDX-License-Identifier: MIT
"""Images to draw into: given by the caller, or new."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

from ._arrays import Array, new_array
from ._errors import new_struct
from ._library import ffi
from ._names import FORMATS, number_of
from ._numpy import np

# The type code, the bytes of a channel, and the number of channels; 0: the array has no axis for channels.
_EIGHT_BITS = ("B", 1, 4)
_LAYOUTS: Dict[int, Tuple[str, int, int]] = {
    FORMATS["rgba32f"]: ("f", 4, 4),
    FORMATS["rgba32f_premultiplied"]: ("f", 4, 4),
    FORMATS["coverage8"]: ("B", 1, 0),
}
_WORDS = {"B": "uint8", "f": "float32"}


def _shape(width: Any, height: Any, channels: int) -> Tuple[Any, ...]:
    return (height, width, channels) if channels else (height, width)


def _check(out: Any, layout: Tuple[str, int, int], size: Optional[Tuple[int, int]]) -> Array:
    code, itemsize, channels = layout
    out = np.asarray(out) if np is not None else memoryview(out)
    given = out.dtype.char if np is not None else out.format
    wanted = _shape("width", "height", channels)
    fits = given == code and len(out.shape) == len(wanted) and 0 not in out.shape
    if not fits or (channels and out.shape[2] != channels):
        raise ValueError(f"out must be a {_WORDS[code]} array of the shape ({', '.join(map(str, wanted))})")
    if size is not None and (out.shape[1], out.shape[0]) != size:
        given_size, wanted_size = (f"{w} x {h}" for w, h in ((out.shape[1], out.shape[0]), size))
        raise ValueError(f"out has {given_size} pixels, but the size asked for is {wanted_size}")
    packed = (channels * itemsize, itemsize) if channels else (itemsize,)
    packed_rows = out.strides[1:] == packed if np is not None else out.c_contiguous
    writeable = out.flags.writeable if np is not None else not out.readonly
    if not packed_rows or not writeable:
        raise ValueError("out must be writable and the pixels of a row side by side")
    return out


def image_for(
    format: str, out: Optional[Array], size: Optional[Tuple[int, int]], default: Tuple[int, int]
) -> Tuple[Array, Any]:
    """The pixels and a hrbfnpr_image on them.  The pixels are `out`, or a new array of `size`, or else of `default`."""
    image = new_struct("hrbfnpr_image")
    image.format = number_of("format", FORMATS, format)
    layout = _LAYOUTS.get(image.format, _EIGHT_BITS)
    if out is None:
        width, height = default if size is None else size
        if width <= 0 or height <= 0:
            raise ValueError(f"the size must be positive, not {width} x {height}")
        pixels = new_array(_shape(width, height, layout[2]), layout[0])
    else:
        pixels = _check(out, layout, size)
    image.height, image.width = pixels.shape[0], pixels.shape[1]
    if np is not None:
        image.pixels = ffi.cast("void *", pixels.__array_interface__["data"][0])
        image.row_stride = pixels.strides[0]
    else:
        image.pixels = ffi.cast("void *", ffi.from_buffer(pixels))
    return pixels, image
