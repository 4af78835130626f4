#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws a scene and compares it with its golden picture.

    compare.py DRAW_SCENE NAME GOLDEN.png [--update]

Tolerance: both images are blurred with a Gaussian of 2 pixels, because the place and amount of ink count, but not the
last bit of a mark's edge, which another compiler may round differently. After the blur no channel may differ by more
than 24 of 255, and the mean difference may be at most 0.5. The scene is drawn with the baseline instruction set, since
the order of stipples on a symmetric surface depends on last bits.

On one machine the bits must be equal for 1, 2, 3 and 7 threads and for every thread backend. Scenes with hatching are
slow, so they are drawn only with one thread, with seven and with OpenMP.
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Optional

try:
    import numpy as np
    from PIL import Image, ImageFilter
except ImportError as missing:
    print(f"skipped: {missing} (install python3-numpy and python3-pil)")
    sys.exit(77)

BLUR, MOST, MEAN = 2.0, 24.0, 0.5
# Threads and their backend. The others are compared with the first.
WAYS = ((1, "auto"), (2, "pool"), (3, "pool"), (7, "pool"), (3, "openmp"), (2, "run_tasks"), (3, "serial"))
FEW_WAYS = ((1, "auto"), (7, "pool"), (3, "openmp"))
HATCHED = ("torus-cross-hatch", "knot-full", "heart-combing")
NOT_BUILT_IN = 77


def draw(program: str, name: str, threads: int, backend: str, *more: str) -> Optional[np.ndarray]:
    """The picture, or None if the build does not have this backend."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.pam"
        result = subprocess.run([program, name, str(path), "480", "480", str(threads), backend, *more])
        if result.returncode == NOT_BUILT_IN:
            print(f"{name}: this build has no {backend}")
            return None
        result.check_returncode()
        data = path.read_bytes()
    pixels = data[data.index(b"ENDHDR\n") + 7:]
    return np.frombuffer(pixels, np.uint8).reshape(480, 480, 4)


def blurred(rgba: np.ndarray) -> np.ndarray:
    """Blurs the premultiplied colours, so that the colour of invisible pixels does not count."""
    colour = rgba.astype(np.float64)
    colour[..., :3] *= colour[..., 3:] / 255.0
    image = Image.fromarray(np.rint(colour).astype(np.uint8), "RGBA")
    return np.asarray(image.filter(ImageFilter.GaussianBlur(BLUR)), np.float64)


def main() -> int:
    program, name, golden = sys.argv[1:4]
    ways = FEW_WAYS if name in HATCHED else WAYS
    pictures = [draw(program, name, threads, backend) for threads, backend in ways]
    for (threads, backend), picture in zip(ways, pictures):
        if picture is not None and not np.array_equal(picture, pictures[0]):
            print(f"{name}: {threads} threads by {backend} draw other bits than one thread")
            return 1
    picture = draw(program, name, 2, "pool", "baseline")
    if "--update" in sys.argv:
        Image.fromarray(picture, "RGBA").save(golden, optimize=True)
        return 0
    reference = np.asarray(Image.open(golden).convert("RGBA"))
    difference = np.abs(blurred(picture) - blurred(reference))
    print(f"{name}: largest difference {difference.max():.1f} (limit {MOST}), mean {difference.mean():.4f} (limit {MEAN})")
    return 0 if difference.max() <= MOST and difference.mean() <= MEAN else 1


if __name__ == "__main__":
    sys.exit(main())
