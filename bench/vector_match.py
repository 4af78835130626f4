#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures how close SVGs are to images: all named styles of a few models, rendered by librsvg.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so bench/vector_match.py [--models=DIR] [--named=TEXT]
        [--styles=NAMES] [--marks=N] [--size=PIXELS] [--keep=DIR] [--tolerance=MM]

Prints a table of PSNR values in dB, and the smallest one as vector.match_db. DIR contains bunny_256.ply, head_4096.ply and
heart_1024.ply; the knot is made from a formula. --marks is the largest number of marks in a layer (60000; 0 lets the
command line decide, which takes long). --named selects models whose names contain TEXT. --keep keeps the files.
"""

import argparse
import contextlib
import io
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from PIL import Image

import hrbfnpr
from hrbfnpr import cli, shapes

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scripts" / "figures"))
import models  # noqa: E402

FILES = {"bunny": "bunny_256.ply", "head": "head_4096.ply", "heart": "heart_1024.ply"}
ASKED = 35.0  # PSNR that each drawing should reach, in dB


def run(*words):
    """Runs the command line. Its output becomes the error message if it fails."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
        status = cli.main([str(word) for word in words])
    if status != 0:
        raise SystemExit(f"hrbfnpr {words[0]}: {said.getvalue()}")


def fitted(folder, wanted, out):
    """Yields the name and the saved model of each available model."""
    points, normals = models.knot()
    chosen = shapes.farthest_points(points, 1024)
    np.savetxt(out / "knot.xyz", np.column_stack((points[chosen], normals[chosen])))
    sources = {name: Path(folder) / file for name, file in FILES.items()} if folder else {}
    for name, source in {**sources, "knot": out / "knot.xyz"}.items():
        if wanted in name:
            run("fit", source, out / f"{name}.hrbf", "-q")
            yield name, out / f"{name}.hrbf"


def picture(file):
    return np.asarray(Image.open(file).convert("RGB"), dtype=float)


def match(model, style, options, out):
    """The PSNR in dB between the command line's PNG and its SVG rendered by librsvg."""
    svg, png, rendered = (out / f"{model.stem}_{style}{ending}" for ending in (".svg", ".png", "_rsvg.png"))
    few = ["--marks", options.marks] if options.marks else []
    few += ["--vector-tolerance", options.tolerance]
    run("draw", model, svg, "--also", png, "--style", style, "--size", options.size, "--scale-bar", "none", "--profile", "no",
        *few, "-q")  # fmt: skip
    ours = picture(png)
    size = ["-w", str(ours.shape[1]), "-h", str(ours.shape[0])]
    subprocess.run(["rsvg-convert", *size, str(svg), "-o", str(rendered)], check=True)
    return 10 * np.log10(255**2 / max(((picture(rendered) - ours) ** 2).mean(), 1e-9))


def table(options, out):
    styles = [style for style in hrbfnpr.PRESETS if not options.styles or style in options.styles.split(",")]
    found = {}
    for name, model in fitted(options.models, options.named, out):
        for style in styles:
            start = time.process_time()
            found[name, style] = match(model, style, options, out)
            print(f"{name} {style}: {found[name, style]:.1f} dB, {time.process_time() - start:.1f} s", flush=True)
    names = list(dict.fromkeys(name for name, _ in found))
    print("| style |", " | ".join(names), "|")
    print("|---|" + "---|" * len(names))
    for style in styles:
        print(f"| {style} |", " | ".join(f"{found[name, style]:.1f}" for name in names), "|")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option, default in (("--models", ""), ("--named", ""), ("--styles", ""), ("--marks", 60000), ("--size", 1600),
                            ("--keep", ""), ("--tolerance", 0.05)):  # fmt: skip
        parser.add_argument(option, default=default, type=type(default))
    options, _ = parser.parse_known_args()  # other options are those of bench/vector.cpp
    if shutil.which("rsvg-convert") is None:
        print("vector.match_db is not measured: rsvg-convert is not here (apt-get install librsvg2-bin)")
        return
    if not options.models:
        print("without --models=DIR: only the knot")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(options.keep or folder)
        out.mkdir(parents=True, exist_ok=True)
        found = table(options, out)
    (name, style), least = min(found.items(), key=lambda item: item[1])
    print(f"least: {name}, {style}; {sum(value < ASKED for value in found.values())} of {len(found)} below {ASKED:g} dB")
    print(f"vector.match_db {least:.3f}")


if __name__ == "__main__":
    main()
