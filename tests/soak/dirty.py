#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws files as they are and damaged. Each gives a picture with ink, or an error message and no file.

    PYTHONPATH=bindings/python HRBFNPR_LIBRARY=.../libhrbfnpr.so tests/soak/dirty.py [--only TEXT] [--clean] [FILE|DIR ...]

Without files, it makes points of a torus and of a sheet and a mesh of a torus, and divides the kinds of damage among
them. --only draws the cases whose file name or damage contains TEXT. --clean draws no damaged files. Prints a line for
each case; the status is 1 if a case breaks the rule.
"""
import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from PIL import Image

from hrbfnpr import shapes

PATIENCE = 600  # seconds
MADE = 3  # generated shapes that share the kinds of damage
DRAW = ["--size", "200", "--marks", "3000"]
QUICK = ["--samples", "400"]  # for generated files


def write(path, points, normals=None, triangles=None):
    """Writes an ASCII PLY with full double precision."""
    columns = [points] if normals is None else [points, normals]
    names = "xyz" if normals is None else ("x", "y", "z", "nx", "ny", "nz")
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property double {name}" for name in names)]
    if triangles is not None:
        lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    lines.append("end_header")
    lines += [" ".join(repr(float(number)) for number in row) for row in np.hstack(columns)]
    if triangles is not None:
        lines += ["3 " + " ".join(str(int(corner)) for corner in row) for row in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def torus(around, across):
    u, v = (2 * np.pi * grid.ravel() for grid in np.meshgrid(np.arange(around) / around, np.arange(across) / across))
    normals = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) + 0.4 * normals, normals


def torus_faces(around, across):
    at = np.arange(around * across).reshape(across, around)
    right, up = np.roll(at, -1, axis=1), np.roll(at, -1, axis=0)
    across_both = np.roll(right, -1, axis=0)
    halves = [(at, right, across_both), (at, across_both, up)]
    return np.vstack([np.stack([corner.ravel() for corner in half], axis=1) for half in halves])


def make_files(folder):
    """The files that are drawn if none are given."""
    points, normals = torus(24, 12)
    write(folder / "torus.ply", points, normals)
    write(folder / "torus_mesh.ply", points, triangles=torus_faces(24, 12))
    x, y = (grid.ravel() for grid in np.meshgrid(np.linspace(-1, 1, 15), np.linspace(-1, 1, 15)))
    up = np.stack([-0.6 * np.cos(3 * x), 0 * x, np.ones_like(x)], axis=1)
    write(folder / "sheet.ply", np.stack([x, y, 0.2 * np.sin(3 * x)], axis=1), up / np.linalg.norm(up, axis=1)[:, None])
    (folder / "zz.md").write_text("# Not a shape\n")
    return sorted(folder.glob("*.ply")) + [folder / "zz.md"]


def some(random, points, share):
    return random.choice(len(points), max(1, int(share * len(points))), replace=False)


def put(array, rows, value):
    array = array.copy()
    array[rows] = value
    return array


# The kinds of damage to the points, normals and triangles of a shape. None: does not apply to this shape.


def without_numbers(random, points, normals, triangles):
    return put(points, some(random, points, 0.01), np.nan), normals, triangles


def infinite(random, points, normals, triangles):
    return put(points, some(random, points, 0.001), np.inf), normals, triangles


def huge(random, points, normals, triangles):
    return put(points, some(random, points, 0.001), 1e300), normals, triangles


def noisy(random, points, normals, triangles):
    return points + 0.003 * np.ptp(points, axis=0).max() * random.standard_normal(points.shape), normals, triangles


def repeated(random, points, normals, triangles):
    rows = some(random, points, 0.3)
    return np.vstack([points, points[rows]]), normals if normals is None else np.vstack([normals, normals[rows]]), triangles


def tiny(random, points, normals, triangles):
    return 1e-25 * points, normals, triangles


def far_away(random, points, normals, triangles):
    return points + 1e6 * np.ptp(points, axis=0).max(), normals, triangles


def flat(random, points, normals, triangles):
    return points * [1, 1, 0], normals, triangles


def in_one_place(random, points, normals, triangles):
    return np.zeros_like(points), normals, triangles


def with_normals(change):
    def damage(random, points, normals, triangles):
        return None if normals is None or triangles is not None else (points, change(random, normals), None)

    damage.__name__ = change.__name__
    return damage


@with_normals
def no_normals(random, normals):
    return None


@with_normals
def inward(random, normals):
    return -normals


@with_normals
def mixed_normals(random, normals):
    return normals * random.choice([-1.0, 1.0], len(normals))[:, None]


@with_normals
def zero_normals(random, normals):
    return put(normals, some(random, normals, 0.05), 0.0)


@with_normals
def long_normals(random, normals):
    return normals * random.uniform(0.5, 300.0, len(normals))[:, None]


@with_normals
def random_normals(random, normals):
    return random.standard_normal(normals.shape)


def with_faces(change):
    def damage(random, points, normals, triangles):
        return None if triangles is None else (points, normals, change(random, points, triangles))

    damage.__name__ = change.__name__
    return damage


@with_faces
def turned_faces(random, points, triangles):
    rows = some(random, triangles, 0.5)
    return put(triangles, rows, triangles[rows, ::-1])


@with_faces
def inside_out(random, points, triangles):
    return triangles[:, ::-1]


@with_faces
def holes(random, points, triangles):
    return np.delete(triangles, some(random, triangles, 0.05), axis=0)


@with_faces
def no_such_vertex(random, points, triangles):
    return put(triangles, some(random, triangles, 0.001), [0, 1, len(points) + 7])


@with_faces
def no_area(random, points, triangles):
    rows = some(random, triangles, 0.1)
    return put(triangles, rows, triangles[rows, :1])


DAMAGES = [without_numbers, infinite, huge, noisy, repeated, tiny, far_away, flat, in_one_place, no_normals, inward,
           mixed_normals, zero_normals, long_normals, random_normals, turned_faces, inside_out, holes, no_such_vertex,
           no_area]  # fmt: skip
OF_ALL = DAMAGES.index(in_one_place) + 1  # the rest apply only to points with normals, or to meshes


def cut_off(path, folder):
    data = path.read_bytes()
    short = folder / ("cut_off" + path.suffix)
    short.write_bytes(data[: int(0.7 * len(data))])
    return short


def cases(path, folder, clean, turn, turns):
    """Pairs of a damage and a file. Damage that applies to all shapes is done once in `turns` files, the rest always."""
    yield "as it is", path
    if clean:
        return
    yield "cut_off", cut_off(path, folder)
    try:
        shape = shapes.read(path)
    except shapes.ShapeError:
        return  # not a shape, such as a text beside the models
    for number, damage in enumerate(DAMAGES):
        if number < OF_ALL and number % turns != turn:
            continue
        random = np.random.default_rng(number)
        changed = damage(random, shape.points, shape.normals, shape.triangles)
        if changed is not None:
            write(folder / "damaged.ply", *changed)
            yield damage.__name__, folder / "damaged.ply"


def has_ink(path):
    with Image.open(path) as picture:
        return np.asarray(picture.convert("L")).min() < 128


def draw(path, out, options):
    """The result in words, and True if it keeps the rule."""
    out.unlink(missing_ok=True)
    command = [sys.executable, "-m", "hrbfnpr", "draw", str(path), str(out), *DRAW, *options]
    try:
        ended = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return f"still at work after {PATIENCE} s", False
    said = (ended.stdout + ended.stderr).splitlines()
    errors = [line for line in ended.stderr.splitlines() if "error:" in line]
    last = errors[-1].strip() if errors else ""
    if "Traceback" in ended.stderr or ended.returncode not in (0, 1, 2, 3):
        return f"status {ended.returncode}: {ended.stderr[-300:]}", False
    if ended.returncode != 0:
        return f"refused: {last}", len(last) > 20 and not out.exists()
    warnings = sum("warning" in line.lower() for line in said)
    return f"drawn, {warnings} warnings", out.exists() and has_ink(out)


def files_of(arguments, folder):
    if not arguments:
        return make_files(folder)
    return [path for given in map(Path, arguments) for path in _within(given)]


def _within(given):
    return sorted(path for path in given.rglob("*") if path.is_file()) if given.is_dir() else [given]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="FILE|DIR")
    parser.add_argument("--only", default="", metavar="TEXT")
    parser.add_argument("--clean", action="store_true")
    given = parser.parse_args()
    counts = {True: 0, False: 0}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = files_of(given.files, folder)
        for turn, path in enumerate(files):
            turns = 1 if given.files else MADE
            for done, file in cases(path, folder, given.clean, turn % turns, turns):
                if given.only not in f"{path.name} {done}":
                    continue
                start = time.monotonic()
                came, keeps = draw(file, folder / "out.png", [] if given.files else QUICK)
                counts[keeps] += 1
                seconds = time.monotonic() - start
                print(f"{'' if keeps else 'BROKEN '}{path.name}, {done}: {came}, {seconds:.1f} s", flush=True)
    print(f"{sum(counts.values())} drawn or refused, {counts[False]} broke the rule")
    return 1 if counts[False] or not counts[True] else 0


if __name__ == "__main__":
    sys.exit(main())
