# SPDX-License-Identifier: MIT
"""Writes pictures as files.  Needs Pillow."""
from __future__ import annotations

import os
from typing import Any, BinaryIO, Optional, Union

from ._arrays import Array
from ._streams import write_atomically


def to_pil(image: Array) -> Any:
    """A PIL.Image from straight RGBA, uint8 (height, width, 4)."""
    try:
        from PIL import Image
    except ImportError as error:
        raise ImportError("making a PNG needs Pillow (Debian: python3-pil)") from error
    height, width = image.shape[:2]
    return Image.frombytes("RGBA", (width, height), bytes(image))


def format_of(target: Union[str, "os.PathLike[str]", BinaryIO]) -> str:
    """Pillow's name for the format of a file's ending; PNG without an ending."""
    from PIL import Image

    ending = os.path.splitext(os.fspath(target))[1].lower() if isinstance(target, (str, os.PathLike)) else ""
    Image.preinit()  # loads only the usual formats, which takes less time than all
    format = Image.EXTENSION.get(ending) or Image.registered_extensions().get(ending) if ending else "PNG"
    if format is None or format not in Image.SAVE:
        raise ValueError(f"no picture format is known for the ending {ending!r}; use .png")
    return str(format)


def save(picture: Any, target: Union[str, "os.PathLike[str]", BinaryIO], format: Optional[str]) -> None:
    """Write a PIL.Image to a path or to a binary file object.  A file is written whole or not at all."""
    if format is None:
        format = format_of(target)
    if format == "JPEG":
        picture = picture.convert("RGB")
    if isinstance(target, (str, os.PathLike)):
        write_atomically(target, lambda file: picture.save(file, format))
    else:
        picture.save(target, format)
