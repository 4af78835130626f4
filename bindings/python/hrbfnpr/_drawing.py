"""A finished drawing."""
from __future__ import annotations

import io
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, BinaryIO, Optional, Union

from ._arrays import Array
from ._streams import write_atomically

if TYPE_CHECKING:
    from ._renderer import FrameInfo


@dataclass(frozen=True)
class Drawing:
    """A picture that shows itself in a notebook.

    Attributes
    ----------
    image : array of uint8, shape (height, width, 4)
        Straight RGBA, sRGB-encoded.
    depth, id, class_ : arrays, shape (height, width), or None
        See `Renderer.draw`.
    info : FrameInfo or None
    """

    image: Array
    depth: Optional[Array] = None
    id: Optional[Array] = None
    class_: Optional[Array] = None
    info: Optional[FrameInfo] = None

    def to_pil(self) -> Any:
        """A PIL.Image.  Needs Pillow."""
        try:
            from PIL import Image
        except ImportError as error:
            raise ImportError("making a PNG needs Pillow (Debian: python3-pil)") from error
        height, width = self.image.shape[:2]
        return Image.frombytes("RGBA", (width, height), bytes(self.image))

    def save(self, target: Union[str, "os.PathLike[str]", BinaryIO], format: Optional[str] = None) -> None:
        """Write a picture to a path (atomically) or a binary file object.  Needs Pillow.

        Parameters
        ----------
        target : path or file object
        format : str, optional
            One of Pillow's, such as "PNG"; by default as the path's ending says, or PNG.
        """
        from PIL import Image

        if format is None:
            ending = ""
            if isinstance(target, (str, os.PathLike)):
                ending = os.path.splitext(os.fspath(target))[1].lower()
            format = Image.registered_extensions().get(ending, "PNG" if not ending else None)
            if format is None:
                raise ValueError(f"no picture format is known for the ending {ending!r}; use .png")
        picture = self.to_pil()
        if format == "JPEG":
            picture = picture.convert("RGB")
        if isinstance(target, (str, os.PathLike)):
            write_atomically(target, lambda file: picture.save(file, format))
        else:
            picture.save(target, format)

    def to_png(self) -> bytes:
        """The bytes of a PNG file.  Needs Pillow."""
        buffer = io.BytesIO()
        self.save(buffer, "PNG")
        return buffer.getvalue()

    def _repr_png_(self) -> bytes:
        return self.to_png()
