# SPDX-License-Identifier: MIT
"""Draws a panel of a figure."""

import contextlib
import io
import shlex
import shutil
import subprocess
from pathlib import Path

import numpy as np
import plot
from models import Missing
from PIL import Image, ImageDraw

import hrbfnpr
from hrbfnpr import cli, shapes

SUFFIXES = {"sheet-views": ".svg", "svg": ".svg", "plot": ".hpgl"}


class Failed(Exception):
    """A drawing failed; the text says why."""


def _run(words):
    """Runs a command line in this process."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        code = cli.main([*words, "--quiet"])
    if code == 130:
        raise KeyboardInterrupt
    if code != 0:
        raise Failed(said.getvalue().strip().replace("hrbfnpr: error: ", ""))


def _numbers(path, size):
    """Values for the options of a panel that depend on the model's extent: the zoom, and the range of distances from a camera with
    an angle of view of 30 degrees."""
    points = shapes.read(path).points
    extent = points.max(axis=0) - points.min(axis=0)
    radius = float(np.linalg.norm(extent)) / 2
    distance = radius / np.sin(np.radians(15))
    far = distance + 1.4 * radius
    return {"zoom": f"{size / extent.max():.6g}", "near": f"{distance - radius:.6g}", "far": f"{far:.6g}"}


def _pens(options, size):
    """Scales the pens among the options, which are for 640 pixels, to this size."""
    words = shlex.split(options)
    for i, word in enumerate(words[:-1]):
        if word in ("--mark-radius", "--halo"):
            words[i + 1] = f"{float(words[i + 1]) * size / 640:.6g}"
    return words


def _samples(path, more, options, size, target):
    """Draws the samples of a model as dots; hidden samples are left out."""
    count = int(more[more.index("--samples") + 1]) if "--samples" in more else None
    points, normals = shapes.samples(shapes.read(path), count)
    marks = hrbfnpr.PointSet.create(hrbfnpr.OwnLayer(points, normals, kind="stipples"))
    saved = target.with_suffix(".hrbm")
    try:
        marks.save(saved)
        words = [*options, "--style", "stipple", "--tone", "none", "--mark-radius", f"{max(1.0, size / 200):g}"]
        _run(["draw", str(saved), str(target), *words, "--size", str(size)])
    finally:
        saved.unlink(missing_ok=True)


def _decay(size, target):
    """Plots alpha over |nu|: nu^2 for front points (green), and 0.2 (ln(nu - 0.05) + 5) for back points (red)."""
    picture = Image.new("RGB", (size, size), "white")
    pen, low, side = ImageDraw.Draw(picture), 0.9 * size, 0.8 * size
    pen.line([(0.1 * size, 0.1 * size), (0.1 * size, low), (low, low)], fill="black", width=max(1, size // 300))
    nu = np.linspace(0, 1, 200)
    back = np.clip(0.2 * (np.log(np.maximum(nu - 0.05, 1e-9)) + 5), 0, 1)
    for alpha, colour in ((nu**2, (0, 140, 0)), (back, (200, 0, 0))):
        curve = [(0.1 * size + side * x, low - side * y) for x, y in zip(nu, alpha)]
        pen.line(curve, fill=colour, width=max(1, size // 160))
    picture.save(target)


def _from_svg(source, target, size, part):
    """Draws an SVG, or a part of it at the same size, and deletes the SVG."""
    if shutil.which("rsvg-convert") is None:
        raise Missing("rsvg-convert, which draws SVG files, is not installed (Debian: librsvg2-bin)")
    length = size if part is None else round(size / (part[2] - part[0]))
    command = ["rsvg-convert", "--keep-aspect-ratio", "-b", "white", "-w", str(length), "-h", str(length), "-o", str(target)]
    subprocess.run([*command, str(source)], check=True)
    source.unlink()
    if part is not None:
        _cut(target, part)


def _cut(target, part):
    picture = Image.open(target)
    size = (picture.width, picture.height, picture.width, picture.height)
    picture.crop(tuple(round(share * length) for share, length in zip(part, size))).save(target)


def _command(panel, path, more, size):
    """Returns the command that draws a panel, and its options."""
    whole = size / panel.scale
    options = panel.options.format(**_numbers(path, whole)) if "{" in panel.options else panel.options
    command = panel.kind if panel.kind in ("sheet", "sheet-views", "csg") else "draw"
    words = [*more, *_pens(options, whole)]
    if command != "sheet-views":
        words += ["--size", str(max(16, size // 2) if command == "sheet" else size)]
    return command, words


def command(panel, models, size, name):
    """Returns the command line that draws a panel, without folders, and the credit. The command line is "" if no command draws the
    panel."""
    path, more, credit = models.source(panel.model)
    if panel.kind in ("samples", "decay"):
        return "", "made from a formula" if panel.kind == "decay" else credit
    what, words = _command(panel, path, more, max(16, round(panel.scale * size)))
    written = Path(name).with_suffix(SUFFIXES.get(panel.kind, ".png")).name
    return "python3 -m hrbfnpr " + shlex.join([what, path.name, written, *words]), credit


def draw(panel, models, size, target):
    """Draws a panel and writes the picture to `target`."""
    path, more, _ = models.source(panel.model)
    size = max(16, round(panel.scale * size))
    if panel.kind == "decay":
        return _decay(size, target)
    what, words = _command(panel, path, more, size)
    if panel.kind == "samples":
        return _samples(path, more, words[len(more) : -2], size, target)
    written = target.with_suffix(SUFFIXES.get(panel.kind, ".png"))
    _run([what, str(path), str(written), *words])
    if panel.kind == "plot":
        plot.paint(written, target, size)
    elif written != target:
        _from_svg(written, target, size, panel.part)
    elif panel.part is not None:
        _cut(target, panel.part)
    return None
