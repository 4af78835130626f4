# SPDX-License-Identifier: MIT
"""Godot 3 with a GDNative library: each frame as a texture, and as parts of a mesh under the engine's camera."""

import os
import re
import shutil
import subprocess
import sys

import run

NAME = "Godot 3 (GDNative)"

# Prints the expected mesh of the first frame: the numbers of points and triangles, and the corner and size of their box.
MESH = """
import sys
import numpy as np, hrbfnpr

samples = np.loadtxt(sys.argv[1])
drawing = hrbfnpr.draw((samples[:, :3], samples[:, 3:]), direction=(0, 1, -1), up=(0, 0, 1), size=(640, 480)).drawing
dots, strips = (drawing.vertices(primitive, ["position"]) for primitive in ("points", "triangle_strips"))
ends = np.flatnonzero(strips.indices == 0xFFFFFFFF)
triangles = sum(max(length - 2, 0) for length in np.diff(ends, prepend=-1) - 1)
points = np.concatenate([dots.vertices["position"], strips.vertices["position"]])
print(len(dots.vertices), triangles, *points.min(axis=0), *np.ptp(points, axis=0))
"""

# Checks the members of the class that the project does not use.
CHECKS = """
extends SceneTree

var drawing = load("res://drawing.gdns").new()


func check(what, holds):
	print("checked: " if holds else "wrong: ", what)


func _init():
	check("without a picture there are no notes", drawing.notes() == null)
	check("nor a frame", not drawing.look(Vector3(0, 0, -1), 1.0) and drawing.pixels() == null)

	# The engine's faces are clockwise from outside. If they were not turned, a note would say so.
	var arrays = CubeMesh.new().get_mesh_arrays()
	var vertices = arrays[Mesh.ARRAY_VERTEX]
	var faces = arrays[Mesh.ARRAY_INDEX]
	var down = Vector3(0.3, -1, -0.5)
	check("a mesh", drawing.draw_mesh(vertices, faces, "hatch", down, Vector3.UP, 200, 100))
	check("its size", drawing.pixels().size() == 4 * 200 * 100)
	check("its strokes", drawing.strokes()[Mesh.ARRAY_VERTEX].size() > 100)
	check("it has no dots", drawing.points()[Mesh.ARRAY_VERTEX].size() == 0)
	check("its faces look outward: " + str(drawing.notes()), not "turned" in str(drawing.notes()))
	check("another style and size", drawing.restyle("stipple", down, Vector3.UP, 100, 50))
	check("that size", drawing.pixels().size() == 4 * 100 * 50)
	check("dots", drawing.points()[Mesh.ARRAY_VERTEX].size() > 100)
	check("no style of this name", not drawing.restyle("no such style", down, Vector3.UP, 100, 50))
	check("the frame stays after a failure", drawing.pixels().size() == 4 * 100 * 50)

	# A sphere with inward normals, and one without normals.
	var inward = SphereMesh.new().get_mesh_arrays()
	var normals = inward[Mesh.ARRAY_NORMAL]
	for i in normals.size():
		normals[i] = -normals[i]
	var side = Vector3(0, 0, -1)
	check("samples", drawing.draw(inward[Mesh.ARRAY_VERTEX], normals, "stipple", side, Vector3.UP, 100, 100))
	check("a note that they were turned: " + str(drawing.notes()), "turned" in str(drawing.notes()))
	check("points", drawing.draw(inward[Mesh.ARRAY_VERTEX], PoolVector3Array(), "stipple", side, Vector3.UP, 100, 100))
	check("a note that normals were found: " + str(drawing.notes()), "normals" in str(drawing.notes()))
	check("the eye", drawing.eye().z > 1 and abs(drawing.eye().x) < 0.1)
	print("all checked")
	quit()
"""

# Limits for the mean difference between the mesh's picture and the drawing, of 255. The engine paints pixels completely
# or not at all, but the library's lines have soft edges.
MOST_OFF = 1.6  # contours and dots, of which many are small; 1.27 when measured
MOST_OFF_STROKES = 17  # fine lines, broken in the lights; 14.8 when measured


def program():
    """The name of the engine: with a window, or without a window where there is no screen."""
    if shutil.which("godot3-runner") and shutil.which("xvfb-run"):
        return "godot3-runner"
    if shutil.which("godot3-server"):
        return "godot3-server"
    raise run.Missing("there is neither godot3-runner with xvfb-run nor godot3-server here "
                      "(Debian: godot3-runner xvfb xauth, or godot3-server)")


def version():
    # The status is 255 even without a failure.
    return subprocess.run([program(), "--version"], stdout=subprocess.PIPE, text=True, timeout=60).stdout.strip()


def values(home):
    """The engine's environment. It writes to the user's folders and does not know the locale C."""
    folders = {name: str(home) for name in ("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")}
    return {**os.environ, **folders, "LC_ALL": "C.UTF-8", "LANG": "en_US.UTF-8"}


def engine(work, project, *options):
    """Runs the project on a screen; returns its output."""
    command = ["godot3-runner", "--audio-driver", "Dummy", "--path", project, *options]
    return run.on_a_screen(command, env=values(work))


def run_project(work, project, *options):
    """Runs the project without a window if that engine is installed; returns its output."""
    if shutil.which("godot3-server"):
        return run.run(["godot3-server", "--path", project, *options], env=values(work))
    return engine(work, project, *options)


def difference(shot, reference):
    """The mean difference between the bytes of a screenshot and of a picture."""
    picture = shot.read_bytes()
    if len(picture) != len(reference):
        raise run.Failed(f"{shot.name} has {len(picture)} bytes in place of {len(reference)}")
    return sum(abs(a - b) for a, b in zip(picture, reference)) / len(reference)


def check_mesh(work, library, project, reference):
    shot = work / "mesh.rgba"
    printed = engine(work, project, "--mesh", f"--screenshot={shot}")
    found = re.search(r"mesh of (\d+) points and (\d+) triangles in (.*)", printed)
    if not found:
        raise run.Failed(f"it does not say what the mesh holds:\n{printed}")
    package = run.ROOT / "bindings" / "python"
    expected = run.run([sys.executable, "-B", "-c", MESH, run.SAMPLES],
                       env={**os.environ, "PYTHONPATH": str(package), "HRBFNPR_LIBRARY": str(library)})
    numbers = [float(number) for number in re.findall(r"-?\d[.\d]*(?:e-?\d+)?", " ".join(found.groups()))]
    wanted = [float(number) for number in expected.split()]
    if len(numbers) != len(wanted) or any(abs(a - b) > 1e-5 for a, b in zip(numbers, wanted)):
        raise run.Failed(f"the mesh is {found[0]}, and should have {expected}")
    off = difference(shot, reference)
    print(f"the mesh is off the drawing by {off:.2f} of 255")
    if off > MOST_OFF:
        raise run.Failed(f"the picture of the mesh is off the drawing by {off:.2f} of 255 (at most {MOST_OFF})")


def ink_of(picture):
    """How much darker than paper a picture is, of 255."""
    return 255 - sum(picture[i] for i in range(0, len(picture), 4)) / (len(picture) / 4)


def check_strokes(work, project):
    """Triangles of strokes under the engine's camera look like the library's picture, except for soft edges."""
    reference, shot = work / "strokes.rgba", work / "strokes_mesh.rgba"
    run_project(work, project, "--style=etching", f"--picture={reference}")
    engine(work, project, "--style=etching", "--mesh", f"--screenshot={shot}")
    wanted = reference.read_bytes()
    off = difference(shot, wanted)
    ink, asked = ink_of(shot.read_bytes()), ink_of(wanted)
    print(f"the strokes are off the drawing by {off:.2f} of 255, with an ink of {ink:.2f} in place of {asked:.2f}")
    if off > MOST_OFF_STROKES or not 0.8 < ink / asked < 1.2:
        raise run.Failed(f"the strokes are off the drawing by {off:.2f} of 255 (at most {MOST_OFF_STROKES}), and have an "
                         f"ink of {ink:.2f} in place of {asked:.2f}")


def check_script(work, project):
    """The class works from a script."""
    (project / "checks.gd").write_text(CHECKS, encoding="utf-8")
    printed = run_project(work, project, "--script", "res://checks.gd")
    if "wrong:" in printed or "all checked" not in printed:
        raise run.Failed(printed)


def check_errors(work, project):
    """The library's message reaches the engine's log, and the project exits with a failure."""
    samples = work / "wrong.xyzn"
    samples.write_text("", encoding="utf-8")
    try:
        run_project(work, project, f"--samples={samples}")
    except run.Failed as failed:
        if "points" in str(failed):
            return
        raise
    raise run.Failed("it drew a file without samples")


def draw(work, library, examples):
    project = work / "project"
    shutil.copytree(examples / "godot" / "project", project)
    picture = work / "picture.rgba"
    if program() == "godot3-server":
        run_project(work, project, f"--picture={picture}")
        check_errors(work, project)
        check_script(work, project)
        return picture
    shot = work / "screenshot.rgba"
    engine(work, project, f"--screenshot={shot}")
    reference = (work / "reference.rgba").read_bytes()
    run_project(work, project, f"--picture={picture}")
    if picture.read_bytes() != reference:
        raise run.Failed("the saved picture differs: " + run.difference(picture.read_bytes(), reference))
    check_mesh(work, library, project, reference)
    check_strokes(work, project)
    check_errors(work, project)
    check_script(work, project)
    return shot
