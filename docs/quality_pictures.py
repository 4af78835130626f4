#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of docs/quality.md: PUBLISHED, white noise and BLUE_NOISE side by side.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/quality_pictures.py MESH.obj docs/images

The rows of quality.png are a flat patch, a ramp of tones, a torus and the mesh.  spectrum.png is the power spectrum of
prefixes of the progressive order.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

import hrbfnpr
from hrbfnpr import shapes

SIDE = 480
MARKS = 12000
PANEL = (SIDE, SIDE)


def plane() -> hrbfnpr.Model:
    """The plane z = 0."""
    return hrbfnpr.Model.from_function(
        lambda p: p[:, 2], gradient=lambda p: np.tile([0.0, 0.0, 1.0], (len(p), 1)), bounds=((-1, -1, -0.2), (1, 1, 0.2))
    )


def torus() -> hrbfnpr.Model:
    """A torus around the z axis."""
    return hrbfnpr.Model.from_function(
        lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1.0, p[:, 2]) - 0.4, bounds=((-1.4, -1.4, -0.4), (1.4, 1.4, 0.4))
    )


def white(model: hrbfnpr.Model) -> hrbfnpr.PointSet:
    """Independent marks: a random subset of 16 times as many."""
    many = model.generate(budget=16 * MARKS)
    chosen = np.random.default_rng(1).choice(len(many), MARKS, replace=False)
    positions = np.asarray(many.layers[0].positions, dtype=float)[chosen] + np.asarray(many.origin)
    normals = np.asarray(many.layers[0].normals, dtype=float)[chosen]
    return hrbfnpr.PointSet.create(hrbfnpr.OwnLayer(positions, normals, kind="stipples"))


def schemes(model: hrbfnpr.Model) -> list:
    """The same number of marks, placed by each scheme."""
    published = model.generate(distribution="published", seed_source="box", box_resolution=6, levels=6, budget=MARKS)
    return [published, white(model), model.generate(budget=MARKS)]


def panel(marks: hrbfnpr.PointSet, style: hrbfnpr.Style, camera: hrbfnpr.Camera) -> Image.Image:
    """A drawing of the marks."""
    return hrbfnpr.Renderer().draw((marks, style), camera).to_pil()


def rows(mesh: str) -> list:
    """The panels of quality.png, row by row."""
    flat = schemes(plane())
    above = hrbfnpr.Camera.look_at((0, 0, 5), (0, 0, 0), (0, 1, 0)).orthographic(1.2, PANEL, 1.0, 10.0)
    even = hrbfnpr.Style("stipple", tone="none", hidden_lines="show")
    even.layer("stipples").radius = 1.4
    ramp = even.copy(tone=lambda p, n: 1.0 - 0.5 * (p[:, 0] + 0.6))
    lit = hrbfnpr.Style("stipple")
    lit.layer("stipples").radius = 1.2
    result = [[panel(marks, style, above) for marks in flat] for style in (even, ramp)]
    points, normals = shapes.samples(shapes.read(mesh), 1100)
    for model, direction in (
        (torus(), (0.2, 1.0, -0.8)),
        (hrbfnpr.Model.fit(points, normals), (-0.4, -0.25, -1.0)),
    ):
        up = (0, 0, 1) if direction[1] == 1.0 else (0, 1, 0)
        sets = schemes(model)
        camera = hrbfnpr.Camera.fit(sets[2], direction, up, size=PANEL)
        result.append([panel(marks, lit, camera) for marks in sets])
    return result


def spectrum(points: np.ndarray, radius: int) -> np.ndarray:
    """The periodogram around frequency 0 of the points in a square of side 1.8, with a Hann window.  White noise gives 1."""
    pixels = 1024
    inside = points[(np.abs(points) < 0.9).all(axis=1)]
    image = np.histogramdd(inside, bins=(pixels, pixels), range=((-0.9, 0.9), (-0.9, 0.9)))[0]
    window = np.hanning(pixels)[:, None] * np.hanning(pixels)
    power = np.abs(np.fft.fftshift(np.fft.fft2((image - image.mean()) * window))) ** 2
    middle = slice(pixels // 2 - radius, pixels // 2 + radius)
    return power[middle, middle] / (len(inside) * (window**2).mean())


def spectra() -> Image.Image:
    """Spectra of the first 25 %, 60 % and 100 % of 40 000 marks on a tilted plane, each the mean of eight progressive orders."""
    normal = np.array([0.35, 0.2, 1.0]) / np.linalg.norm([0.35, 0.2, 1.0])
    u = np.cross([0.0, 1.0, 0.0], normal)
    u /= np.linalg.norm(u)
    plane_axes = np.stack([u, np.cross(normal, u)], axis=1)
    model = hrbfnpr.Model.from_function(
        lambda p: p @ normal, gradient=lambda p: np.tile(normal, (len(p), 1)), bounds=((-1, -1, -0.6), (1, 1, 0.6))
    )
    orders = [model.generate(budget=40000, random_seed=seed) for seed in range(1, 9)]
    points = [(np.asarray(o.layers[0].positions, dtype=float) + np.asarray(o.origin)) @ plane_axes for o in orders]
    panels = []
    for share in (0.25, 0.6, 1.0):
        radius = int(1.8 * np.sqrt(share * 40000))
        mean = np.mean([spectrum(p[: int(share * len(p))], radius) for p in points], axis=0)
        panels.append(Image.fromarray((255 * np.clip(mean / 2.5, 0, 1)).astype("uint8")).resize((236, 236)))
    sheet = Image.new("L", (3 * 236 + 2 * 6, 236), 255)
    for x, image in enumerate(panels):
        sheet.paste(image, (x * 242, 0))
    return sheet


def main() -> None:
    mesh, folder = sys.argv[1], Path(sys.argv[2])
    panels = rows(mesh)
    gap = 8
    sheet = Image.new("L", (3 * SIDE + 2 * gap, len(panels) * (SIDE + gap) - gap), 255)
    for y, row in enumerate(panels):
        for x, image in enumerate(row):
            sheet.paste(image.convert("RGB").convert("L"), (x * (SIDE + gap), y * (SIDE + gap)))
    sheet.quantize(16).save(folder / "quality.png", optimize=True)
    spectra().save(folder / "spectrum.png", optimize=True)


if __name__ == "__main__":
    main()
