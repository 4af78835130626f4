# SPDX-License-Identifier: MIT
"""Writes frames as a GIF, an animated PNG, a film or a series of pictures.  Needs Pillow; films need the program ffmpeg."""
from __future__ import annotations

import io
import os
import re
import shutil
import struct
import subprocess
import tempfile
import zlib
from fractions import Fraction
from pathlib import Path
from typing import Any, BinaryIO, Dict, Iterable, Iterator, List, Sequence, Tuple, Union

import numpy as np

from ._arrays import Array
from ._pictures import format_of, save, to_pil
from ._streams import write_atomically

_COLOURS = 64  # number of colours of a GIF
_EXACT_COLOURS = 8  # number of these that are exact
_LEAST_DIFFERENCE = 8  # least difference of two of them in any channel
_NO_DITHER = 0  # the value of Image.Dither.NONE; Pillow before 9.1 has no Image.Dither
_NUMBERED = re.compile(r"%0?\d*d")
FORMATS = (".gif", ".png", ".apng", ".mp4")

Path_ = Union[str, "os.PathLike[str]"]


def check_movie(path: Path_, fps: float) -> None:
    """Raise an error if frames cannot be written in the format of this path's ending."""
    if not 0 < fps <= 1000:
        raise ValueError(f"fps must be above 0 and at most 1000, not {fps:g}")
    ending = Path(path).suffix.lower()
    if _NUMBERED.search(Path(path).name):
        format_of(path)
    elif ending not in FORMATS:
        raise ValueError(
            f"{os.fspath(path)}: an animation ends in {', '.join(FORMATS)}, or has a number for pictures, such as "
            "frame-%03d.png"
        )
    if ending == ".mp4":
        _ffmpeg()


def _ffmpeg() -> str:
    found = shutil.which("ffmpeg")
    if found is None:
        raise OSError("writing .mp4 needs the program ffmpeg (Debian: ffmpeg); .gif and .png need no program")
    return found


def write(path: Path_, frames: Iterable[Array], fps: float, loops: int, paper: Sequence[float]) -> None:
    """Write frames as they come.  The file appears when all frames are written.

    Parameters
    ----------
    frames : iterable of array of uint8, shape (height, width, 4)
        The frames, straight RGBA, all of the same size.
    loops : int
        How often a GIF or an animated PNG is played; 0 = without end.
    paper : (red, green, blue, alpha)
        The colour on which transparent frames are laid, in formats without transparency; white if it is transparent.
    """
    check_movie(path, fps)
    ending = Path(path).suffix.lower()
    if _NUMBERED.search(Path(path).name):
        _pictures_of(path, frames)
    elif ending == ".mp4":
        _film(path, (_opaque(frame, paper) for frame in frames), fps)
    elif ending == ".gif":
        pictures = _indexed(_opaque(frame, paper) for frame in frames)
        write_atomically(path, lambda file: _gif(file, pictures, fps, loops))
    else:
        write_atomically(path, lambda file: _animated_png(file, frames, fps, loops))


def _pictures_of(path: Path_, frames: Iterable[Array]) -> None:
    for number, frame in enumerate(frames):
        name = _NUMBERED.sub(lambda found: found.group(0) % number, Path(path).name)
        save(to_pil(frame), Path(path).with_name(name), None)


def _gif(file: BinaryIO, pictures: Iterable[Any], fps: float, loops: int) -> None:
    first, *others = pictures
    delay = max(10 * round(100 / fps), 20)  # milliseconds; GIF counts hundredths of a second, and browsers slow down below two
    options: Dict[str, Any] = {} if loops == 1 else {"loop": max(loops - 1, 0)}  # GIF counts repetitions
    # Pillow joins equal frames.  It adds their times only if each frame has its own time.
    times = [delay] * (1 + len(others))
    first.save(file, "GIF", append_images=others, save_all=True, duration=times, optimize=False, disposal=1, **options)


def _animated_png(file: BinaryIO, frames: Iterable[Array], fps: float, loops: int) -> None:
    """Write every frame whole.  Pillow would leave out frames that differ only in transparency."""
    header, pixels = b"", []
    for frame in frames:
        buffer = io.BytesIO()
        to_pil(frame).save(buffer, "PNG")
        chunks = list(_chunks(buffer.getvalue()))
        header = header or next(data for kind, data in chunks if kind == b"IHDR")
        pixels.append(b"".join(data for kind, data in chunks if kind == b"IDAT"))
    seconds = Fraction(1 / fps).limit_denominator(60_000)
    delay = struct.pack(">HHBB", min(seconds.numerator, 0xFFFF), seconds.denominator, 0, 0)
    file.write(b"\x89PNG\r\n\x1a\n")
    _write_chunk(file, b"IHDR", header)
    _write_chunk(file, b"acTL", struct.pack(">II", len(pixels), loops))
    number = 0
    for data in pixels:
        _write_chunk(file, b"fcTL", struct.pack(">I", number) + header[:8] + struct.pack(">II", 0, 0) + delay)
        if number == 0:
            _write_chunk(file, b"IDAT", data)
        else:
            _write_chunk(file, b"fdAT", struct.pack(">I", number + 1) + data)
        number += 1 if number == 0 else 2
    _write_chunk(file, b"IEND", b"")


def _chunks(png: bytes) -> Iterator[Tuple[bytes, bytes]]:
    at = 8
    while at < len(png):
        length = int.from_bytes(png[at : at + 4], "big")
        yield png[at + 4 : at + 8], png[at + 8 : at + 8 + length]
        at += 12 + length


def _write_chunk(file: BinaryIO, kind: bytes, data: bytes) -> None:
    file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


def _opaque(frame: Array, paper: Sequence[float]) -> Array:
    """A frame on its paper, as RGB, shape (height, width, 3)."""
    if (frame[..., 3] == 255).all():
        return np.ascontiguousarray(frame[..., :3])
    ground = np.asarray(paper[:3] if paper[3] > 0 else (1.0, 1.0, 1.0)) * 255
    alpha = frame[..., 3:].astype(np.float32) / 255
    mixed = np.rint(frame[..., :3] * alpha + ground * (1 - alpha))
    return mixed.astype(np.uint8)


def _indexed(frames: Iterable[Array]) -> Iterator[Any]:
    """Frames with one palette, that of the first frame: inks and paper are the same in all."""
    from PIL import Image

    palette: Any = None
    for frame in frames:
        picture = Image.fromarray(frame)
        palette = palette or _palette(picture)
        yield picture.quantize(palette=palette, dither=_NO_DITHER)


def _palette(picture: Any) -> Any:
    """A palette with the most frequent colours, which are paper and ink, exactly, and with colours between them."""
    from PIL import Image

    found = sorted(picture.getcolors(picture.width * picture.height), reverse=True)
    row = picture.quantize(_COLOURS, dither=_NO_DITHER).getpalette()
    between = list(zip(*(row[i::3][:_COLOURS] for i in range(3))))
    kept: List[Any] = []
    # Pillow confuses colours that are nearly the same.
    for colour in [*(colour for _, colour in found[:_EXACT_COLOURS]), *between]:
        if all(max(abs(x - y) for x, y in zip(colour, other)) >= _LEAST_DIFFERENCE for other in kept):
            kept.append(colour)
    values = [value for colour in kept for value in colour]
    palette = Image.new("P", (1, 1))
    palette.putpalette(values + values[:3] * (256 - len(values) // 3))
    return palette


def _film(path: Path_, frames: Iterator[Array], fps: float) -> None:
    """Write H.264 in MP4 with ffmpeg.  Odd sides are padded with the colour of the first pixel, because sides must be even."""
    program, first = _ffmpeg(), next(frames)
    height, width = first.shape[:2]
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile() as said:
        film = os.path.join(folder, "film.mp4")
        command = [
            program, "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
            "-r", repr(float(fps)), "-i", "-",
            "-vf", f"pad=ceil(iw/2)*2:ceil(ih/2)*2:color=0x{bytes(first[0, 0]).hex()}",
            "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", film,
        ]  # fmt: skip
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said)
        taken = _fed(process, first, frames)
        if process.wait() != 0 or not taken:
            said.seek(0)
            raise OSError(f"ffmpeg could not write {os.fspath(path)}: {said.readline().decode(errors='replace').strip()}")
        with open(film, "rb") as source:
            write_atomically(path, lambda file: shutil.copyfileobj(source, file))


def _fed(process: Any, first: Array, frames: Iterator[Array]) -> bool:
    """Feed all frames to the program.  False if it closed its input.  If drawing a frame fails, the program is ended."""
    try:
        process.stdin.write(first.tobytes())
        for frame in frames:
            process.stdin.write(np.ascontiguousarray(frame).tobytes())
        process.stdin.close()
    except BrokenPipeError:
        return False
    except BaseException:
        process.kill()
        process.wait()
        raise
    return True
