# SPDX-License-Identifier: MIT
"""Godot 3: a GDNative library; each frame as a texture, and as points of a mesh under the engine's camera."""

import os
import re
import shutil
import subprocess
import sys

import run

NAME = "Godot 3 (GDNative)"

# What the mesh of the first frame should hold: the number of points, and the corner and the size of their box.
MESH = """
import sys
import numpy as np, hrbfnpr

samples = np.loadtxt(sys.argv[1])
model = hrbfnpr.Model.fit(samples[:, :3], samples[:, 3:])
style = hrbfnpr.Style("contour-and-stipple")
marks = model.generate(preset=style.preset)
camera = hrbfnpr.Camera.fit(model, direction=(0, 1, -1), up=(0, 0, 1), size=(640, 480), vertical_angle=0.5,
                            margin=0.02)
points = hrbfnpr.Renderer().draw((marks, style), camera).vertices("points", ["position"]).vertices["position"]
print(len(points), *points.min(axis=0), *np.ptp(points, axis=0))
"""
MOST_OFF = 0.2  # mean difference of the mesh's picture from the drawing's, of 255; measured 0.05
MOST_OFF_STROKES = 8.5  # the same of strokes, whose pixels are of one triangle or of none; measured 7.6


def program():
    """The engine with a window, or, where there is no screen for it, the one without."""
    if shutil.which("godot3-runner") and shutil.which("xvfb-run"):
        return "godot3-runner"
    if shutil.which("godot3-server"):
        return "godot3-server"
    raise run.Missing("there is neither godot3-runner with xvfb-run nor godot3-server here "
                      "(Debian: godot3-runner xvfb xauth, or godot3-server)")


def version():
    # It ends with 255 here, without a failure.
    return subprocess.run([program(), "--version"], stdout=subprocess.PIPE, text=True, timeout=60).stdout.strip()


def values(home):
    """The engine's environment: it writes to the user's folders, and knows no locale C."""
    folders = {name: str(home) for name in ("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")}
    return {**os.environ, **folders, "LC_ALL": "C.UTF-8", "LANG": "en_US.UTF-8"}


def engine(work, project, *options):
    """Runs the project on a screen; returns what it printed."""
    command = ["godot3-runner", "--audio-driver", "Dummy", "--path", project, *options]
    return run.on_a_screen(command, env=values(work))


def check_mesh(work, library, project, reference):
    shot = work / "mesh.rgba"
    printed = engine(work, project, "--marks", f"--screenshot={shot}")
    found = re.search(r"mesh of (\d+) points in (.*)", printed)
    if not found:
        raise run.Failed(f"it does not say what the mesh holds:\n{printed}")
    package = run.ROOT / "bindings" / "python"
    expected = run.run([sys.executable, "-B", "-c", MESH, run.SAMPLES],
                       env={**os.environ, "PYTHONPATH": str(package), "HRBFNPR_LIBRARY": str(library)})
    numbers = [float(number) for number in re.findall(r"-?\d[.\d]*(?:e-?\d+)?", " ".join(found.groups()))]
    wanted = [float(number) for number in expected.split()]
    if len(numbers) != len(wanted) or any(abs(a - b) > 1e-5 for a, b in zip(numbers, wanted)):
        raise run.Failed(f"the mesh is {found[0]}, and should have {expected}")
    picture = shot.read_bytes()
    if len(picture) != len(reference):
        raise run.Failed(f"the mesh's picture has {len(picture)} bytes in place of {len(reference)}")
    off = sum(abs(a - b) for a, b in zip(picture, reference)) / len(reference)
    if off > MOST_OFF or set(picture) == {255}:
        raise run.Failed(f"the picture of the mesh is off the drawing by {off:.2f} of 255 (at most {MOST_OFF})")


def ink_of(picture):
    """How much darker than paper a picture is, of 255."""
    return 255 - sum(picture[i] for i in range(0, len(picture), 4)) / (len(picture) / 4)


def check_strokes(work, project):
    """Triangles of strokes under the engine's camera look like the library's picture of them, but for soft edges."""
    reference, shot = work / "strokes.rgba", work / "strokes_mesh.rgba"
    engine(work, project, "--strokes", f"--picture={reference}")
    printed = engine(work, project, "--strokes", f"--screenshot={shot}")
    found = re.search(r"(\d+) triangles", printed)
    if not found or int(found[1]) < 1000:
        raise run.Failed(f"it does not say how many triangles its strokes have:\n{printed}")
    wanted, picture = reference.read_bytes(), shot.read_bytes()
    if len(picture) != len(wanted):
        raise run.Failed(f"the strokes' picture has {len(picture)} bytes in place of {len(wanted)}")
    off = sum(abs(a - b) for a, b in zip(picture, wanted)) / len(wanted)
    ink, asked = ink_of(picture), ink_of(wanted)
    if off > MOST_OFF_STROKES or not 0.8 < ink / asked < 1.2:
        raise run.Failed(f"the strokes are off the drawing by {off:.2f} of 255 (at most {MOST_OFF_STROKES}), and have an "
                         f"ink of {ink:.2f} in place of {asked:.2f}")


def check_errors(work, project):
    """The library's message reaches the engine's log, and the project ends with a failure."""
    samples = work / "wrong.xyzn"
    samples.write_text("0 0 0 0 0 0\n", encoding="utf-8")
    try:
        run.run(["godot3-server", "--path", project, f"--samples={samples}"], env=values(work))
    except run.Failed as failed:
        if "normals" in str(failed):
            return
        raise
    raise run.Failed("it took a sample whose normal is zero")


def draw(work, library, examples):
    project = work / "project"
    shutil.copytree(examples / "godot" / "project", project)
    picture = work / "picture.rgba"
    if shutil.which("godot3-server"):
        run.run(["godot3-server", "--path", project, f"--picture={picture}"], env=values(work))
        check_errors(work, project)
    if program() == "godot3-runner":
        shot = work / "screenshot.rgba"
        engine(work, project, f"--screenshot={shot}")
        reference = (work / "reference.rgba").read_bytes()
        if picture.exists() and picture.read_bytes() != reference:
            raise run.Failed("godot3-server's picture differs: " + run.difference(picture.read_bytes(), reference))
        check_mesh(work, library, project, reference)
        check_strokes(work, project)
        return shot
    return picture
