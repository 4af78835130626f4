#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes docs/presets.md, a section for each named style of the library, and draws its pictures.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so docs/preset_pictures.py MESH [FOLDER]

MESH is that of scripts/fetch_bunny; FOLDER is docs if it is not given.  A style of the library that USES lacks is an error:
say there what it is for.  Pictures have 16 greys, to be small.
"""

import sys
import tempfile
from pathlib import Path

from PIL import Image

import hrbfnpr
from hrbfnpr import cli

SIZE = 480
LARGEST = 1_500_000  # bytes of all pictures
VIEW = ["--azimuth", "20", "--elevation", "15", "--size", str(SIZE)]

USES = {
    "stipple": "Soft forms and fine tones without any line: the classic of scientific drawing.",
    "hatch": "Lines around the form, more of them where it is darker: tone and shape with one set.",
    "cross-hatch": "Up to three sets of lines at 30 to 65 degrees to each other, darker where they cross.",
    "combing": "Lines that do not follow curvature: for surfaces that bend much and irregularly.",
    "silhouette": "Contours alone, hidden ones pale: icons, instructions, a base to paint over.",
    "contour-and-stipple": "Contours and stipples: a good first choice for any model.",
    "xray": "Contours alone, hidden ones dashed: technical drawings, assemblies.",
    "full": "Contours with a white halo, stipples, and lines in the darks: as the article's most finished drawing.",
    "engraving": "Parallel lines that swell with the tone, as in a banknote or an old book.",
    "etching": "Thin lines in up to three layers that cross each other, a darker tone each.",
    "woodcut": "Few wide lines that close up to black, and heavy contours: posters, small prints.",
    "scientific-stipple": "Stipples in even tones with fine contours, as in plates of biology and palaeontology.",
    "sketch": "Lines that overshoot and wobble, contours drawn twice: first ideas, things not yet decided.",
    "blueprint": "Light lines on dark paper, hidden ones dashed: plans.",
    "archaeological": "The conventions of finds: light from the upper left, scars along the curvature.",
}

HEAD = """# The named styles

Each is a full set of fields to go on from: `hrbfnpr_style_init_preset`, in Python `hrbfnpr.Style("engraving")`, in C#
`Style.Preset`. All are drawn here from 1100 samples of one model, by the command below the picture; `python3 -m hrbfnpr
sheet model.ply styles.png` draws them of yours. What the fields mean is in [frames.md](frames.md),
[hatching.md](hatching.md) and [lines.md](lines.md).

This page and its pictures are written by `docs/preset_pictures.py`.

"""
FOOT = """## The model

The bunny is a scan by the Stanford Computer Graphics Laboratory
([Stanford 3D Scanning Repository](http://graphics.stanford.edu/data/3Dscanrep/)); its pictures are shown here for
scholarly use. `bunny.obj` in the commands is the file that `scripts/fetch_bunny` fetches.
"""
PLAIN = {"stipples": "stipples", "principal": "strokes along principal directions", "combing": "combing strokes"}


def _marks(style):
    """The layers that are drawn, in words."""
    for layer in hrbfnpr.preset_layers(style.preset):
        how = style.style_of(layer.kind, layer.name)
        if not how.shown:
            continue
        what = PLAIN.get(layer.kind, f"{layer.kind} lines")
        if layer.kind == "hatch":
            what += f" at {layer.angle:g}°"
        elif layer.kind != "stipples":
            what += f" ({' and '.join(how.directions)})"
        yield f"{what}, radius {how.radius:g}" + ("" if how.shape == "dots" else f", shape `{how.shape}`")


def fields(style):
    """The main fields, from the library itself."""
    lines = (f"{line.kind.replace('_', ' ')}s of {line.width:g} px, hidden parts `{line.hidden}`" for line in style.lines)
    tone = style.tone if isinstance(style.tone, str) else "of its own"
    rows = [("marks", "; ".join(_marks(style)) or "none"), ("lines", "; ".join(lines) or "none")]
    light = ", ".join(f"{x:.2g}" for x in style.light)
    rows.append(("tone", tone if tone == "none" else f"`{tone}` from ({light}), `{style.light_space}`"))
    return "".join(f"| {name} | {text} |\n" for name, text in rows)


def section(name):
    command = f"python3 -m hrbfnpr draw bunny.obj {name}.png --style {name} --samples 1100 {' '.join(VIEW)}"
    return (
        f"## {name}\n\n{USES[name]}\n\n"
        f'<p align="center"><img src="images/presets/{name}.png" alt="The Stanford bunny in the style {name}"></p>\n\n'
        f"| | |\n|---|---|\n{fields(hrbfnpr.Style(name))}\n```sh\n{command}\n```\n\n"
    )


def draw(model, name, target):
    """One picture, in few greys unless the style is coloured."""
    if cli.main(["draw", str(model), str(target), "--style", name, *VIEW, "--quiet"]) != 0:
        raise SystemExit(f"the style {name} could not be drawn")
    picture = Image.open(target).convert("RGB")
    picture.quantize(16, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(target, optimize=True)
    print(f"{target.name}: {target.stat().st_size} bytes", flush=True)


def main():
    mesh, folder = sys.argv[1], Path(sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parent)
    unsaid = [name for name in hrbfnpr.PRESETS if name not in USES]
    if unsaid:
        raise SystemExit(f"USES of docs/preset_pictures.py does not say what {', '.join(unsaid)} is for")
    pictures = folder / "images" / "presets"
    pictures.mkdir(parents=True, exist_ok=True)
    for old in pictures.glob("*.png"):
        old.unlink()
    with tempfile.TemporaryDirectory() as scratch:
        model = Path(scratch) / "bunny.hrbf"
        if cli.main(["fit", mesh, str(model), "--samples", "1100", "--quiet"]) != 0:
            raise SystemExit(f"{mesh} could not be fitted")
        for name in hrbfnpr.PRESETS:
            draw(model, name, pictures / f"{name}.png")
    (folder / "presets.md").write_text(HEAD + "".join(map(section, hrbfnpr.PRESETS)) + FOOT, encoding="utf-8")
    total = sum(path.stat().st_size for path in pictures.iterdir())
    if total > LARGEST:
        raise SystemExit(f"the pictures have {total} bytes, more than {LARGEST}: draw less")
    print(f"presets.md: {len(hrbfnpr.PRESETS)} styles, {total} bytes of pictures")


if __name__ == "__main__":
    main()
