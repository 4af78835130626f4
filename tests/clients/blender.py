# SPDX-License-Identifier: MIT
"""Blender 3.4: a mesh object in, an image datablock out. Also the add-on's panel, marks and errors."""

import os
import re

import run

NAME = "Blender"
ADDON = run.EXAMPLES / "blender"

# Runs after draw.py in the same Blender.
CHECKS = """
import sys
import bpy, hrbfnpr, hrbfnpr_addon
import numpy as np
from bpy_extras.object_utils import world_to_camera_view

WIDTH, HEIGHT = 640, 480
settings = bpy.context.scene.hrbfnpr


def check(what, holds):
    if not holds:
        raise AssertionError(what)
    print("checked:", what)


def activate(points, faces, attributes=()):
    mesh = bpy.data.meshes.new("test")
    mesh.from_pydata(points, [], faces)
    for name, values in attributes:
        mesh.attributes.new(name, "FLOAT_VECTOR", "POINT").data.foreach_set("vector", np.ravel(values))
    thing = bpy.data.objects.new("test", mesh)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    return thing


def failure(operator):
    try:
        operator()
    except RuntimeError as error:  # what a report of an error becomes for a script
        return str(error)
    return "nothing"


def values(mesh, name, key, components, dtype=np.float32):
    data = mesh.attributes[name].data
    array = np.empty(len(data) * components, dtype)
    data.foreach_get(key, array)
    return array.reshape(-1, components)


# The attributes of the marks equal those of the library, mark by mark.
settings.style, settings.budget = "full", 3000
bpy.ops.hrbfnpr.marks()
thing = bpy.data.objects["samples marks"]
samples = np.loadtxt(sys.argv[sys.argv.index("--") + 1])
view = {"direction": (0, 1, -1), "up": (0, 0, 1), "size": (WIDTH, HEIGHT), "marks": 3000}
marks = hrbfnpr.draw((samples[:, :3], samples[:, 3:]), "full", keep_marks=True, **view).marks
joined = lambda attribute: np.concatenate([getattr(layer, attribute) for layer in marks.layers])
check("as many marks", len(thing.data.vertices) == len(marks) and len(marks.layers) > 1)
check("their origin", np.allclose(thing.location, marks.origin))
positions = np.empty(3 * len(marks), np.float32)
thing.data.vertices.foreach_get("co", positions)
check("positions", np.array_equal(positions.reshape(-1, 3), joined("positions")))
check("normals", np.array_equal(values(thing.data, hrbfnpr_addon.NORMAL, "vector", 3), joined("normals")))
check("directions", np.array_equal(values(thing.data, "direction", "vector", 3), joined("directions")))
check("ranks", np.array_equal(values(thing.data, "rank", "value", 1)[:, 0], joined("ranks")))
check("levels", np.array_equal(values(thing.data, "level", "value", 1, np.int32)[:, 0], joined("levels")))
for column, name in enumerate(("stroke", "place")):
    check(name, np.array_equal(values(thing.data, name, "value", 1, np.int32)[:, 0], joined("stroke_places")[:, column]))
layers = values(thing.data, "layer", "value", 1, np.int32)[:, 0]
check("layers", [(layers == layer.number).sum() for layer in marks.layers] == [len(layer) for layer in marks.layers])
radii = values(thing.data, "radius", "value", 1)
check("radii", 0 < radii.min() and radii.max() < 0.05)
shown = [instance.object for instance in bpy.context.evaluated_depsgraph_get().object_instances]
(cloud,) = [part.data for part in shown if part.type == "POINTCLOUD"]
check("a point cloud", len(cloud.points) == len(marks))
check("its radii", np.array_equal([point.radius for point in cloud.points], radii[:, 0]))
check("its ranks", np.array_equal(values(cloud, "rank", "value", 1)[:, 0], joined("ranks")))

# The curves of strokes have the places and the width in the picture that the library gives them.
settings.style = "cross-hatch"
bpy.context.view_layer.objects.active = bpy.data.objects["samples"]
bpy.ops.hrbfnpr.strokes()
curve = bpy.data.objects["samples strokes"].data
picture = hrbfnpr.draw((samples[:, :3], samples[:, 3:]), "cross-hatch", **view)
camera = picture.camera
lines = [line for line in picture.drawing.polylines() if line["hidden_layers"][0] == 0]
check("as many strokes", len(curve.splines) == len(lines) > 10)
for spline, line in zip(curve.splines, lines):
    points = np.array([point.co[:3] for point in spline.points])
    clip = np.append(points, np.ones((len(points), 1)), axis=1) @ (camera.projection @ camera.view).T
    seen = (clip[:, :2] / clip[:, 3:] * (1, -1) + 1) / 2 * camera.size
    assert np.allclose(seen, line["window"][:, :2], atol=0.05), "positions of strokes"
    pixels = [point.radius for point in spline.points] / hrbfnpr_addon.units_per_pixel(camera, points)
    assert np.allclose(pixels, line["radius"], rtol=1e-4), "widths of strokes"

# The scene's camera sees a place where Blender shows it.
settings.style, settings.budget, settings.scene_camera = "contour-and-stipple", 0, True
scene = bpy.context.scene
scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
place = bpy.context.object.matrix_world.to_translation()
for kind in ("PERSP", "ORTHO"):
    scene.camera.data.type = kind
    camera = hrbfnpr_addon.camera_of(hrbfnpr, bpy.context)
    clip = camera.projection @ camera.view @ (0.3, -0.2, 0.1, 1)
    ours = (clip[:2] / clip[3] + 1) / 2
    theirs = world_to_camera_view(scene, scene.camera, type(place)((0.3, -0.2, 0.1)))[:2]
    check(f"the place in the {kind} camera, {ours}", np.allclose(ours, theirs, atol=1e-5))
bpy.ops.hrbfnpr.draw()
image = bpy.data.images[hrbfnpr_addon.IMAGE]
drawn = np.rint(np.reshape(image.pixels, (HEIGHT, WIDTH, 4))[::-1] * 255)
source = hrbfnpr_addon.source_of(hrbfnpr, bpy.context)
seen = hrbfnpr.draw((source.points, source.normals), camera=camera, up=(0, 0, 1)).image
check("a drawing with it", np.min(seen) == 0 and np.array_equal(drawn, seen))

# Objects with faces are read as meshes in world space. The image gets another size.
bpy.ops.mesh.primitive_monkey_add(location=(3, 2, 1), rotation=(0.3, 0.2, 0.1), scale=(-1, 1, 2))
settings.scene_camera, settings.samples, settings.width, settings.height = False, 300, 200, 100
monkey = bpy.context.object
source = hrbfnpr_addon.source_of(hrbfnpr, bpy.context)
check("its mesh", source.is_mesh and source.normals is None and len(source.points) == len(monkey.data.vertices))
check("in the world", np.allclose(source.points[7], monkey.matrix_world @ monkey.data.vertices[7].co, atol=1e-5))
check("no edges are marked sharp", source.sharp_edges is None)
bpy.ops.hrbfnpr.draw()
check("another size", tuple(image.size) == (200, 100) and np.mean(image.pixels) < 0.999)
monkey.data.edges[5].use_edge_sharp = True
source = hrbfnpr_addon.source_of(hrbfnpr, bpy.context)
check("an edge that is marked sharp", source.sharp_edges.tolist() == [list(monkey.data.edges[5].vertices)])
sheets = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1)]
settings.samples = 0
crossing = activate(sheets, [(0, 1, 2, 3), (4, 5, 6, 7)])
bpy.ops.hrbfnpr.marks()
heights = [vertex.co.z for vertex in bpy.data.objects[f"{crossing.name} marks"].data.vertices]
check("marks on sheets that cross, in one cloud", max(heights) - min(heights) > 1.9)
thing = activate([(1, 2, 3), (4, 5, 6)], [], [(hrbfnpr_addon.NORMAL, [1, 1, 0, 0, 0, 1])])
thing.location, thing.rotation_euler, thing.scale = (10, 20, 30), (0, 0, np.pi / 2), (1, 2, 1)
source = hrbfnpr_addon.source_of(hrbfnpr, bpy.context)
check("points turned and stretched", np.allclose(source.points, [(6, 21, 33), (0, 24, 36)], atol=1e-5))
check("normals turned and shrunk", np.allclose(source.normals, [(-0.5, 1, 0), (0, 0, 1)], atol=1e-5))
bpy.ops.mesh.primitive_plane_add()
bpy.context.object.scale = (-1, 1, 1)
source = hrbfnpr_addon.source_of(hrbfnpr, bpy.context)
a, b, c = (source.points[source.triangles[:, i]] for i in range(3))
check("an open mesh that is mirrored looks where it looked", np.all(np.cross(b - a, c - a)[:, 2] > 0))

# Errors are reported in the library's words.
activate([(0, 0, 0), (1, 0, 0)], [], [(hrbfnpr_addon.NORMAL, np.zeros(6))])
for operator in (bpy.ops.hrbfnpr.draw, bpy.ops.hrbfnpr.marks):
    message = failure(operator)
    check("too few points: " + message.strip(), "points" in message and "Traceback" not in message)

# Unregister and register the add-on, and install it like a user.
hrbfnpr_addon.unregister()
check("unregistered", not hasattr(bpy.types, "HRBFNPR_PT_panel") and not hasattr(scene, "hrbfnpr")
      and not hasattr(bpy.types, "HRBFNPR_OT_draw"))
bpy.ops.preferences.addon_install(filepath=hrbfnpr_addon.__file__)
bpy.ops.preferences.addon_enable(module="hrbfnpr_addon")
check("installed", hasattr(bpy.types, "HRBFNPR_PT_panel") and bpy.ops.hrbfnpr.draw.poll())
bpy.ops.preferences.addon_disable(module="hrbfnpr_addon")
check("disabled", not hasattr(bpy.types, "HRBFNPR_PT_panel"))
print("all checked")
"""


def version():
    program = run.need("blender", "blender")
    found = re.search(r"Blender ([\d.]+)", run.run([program, "--version"]))
    return found[1] if found else "of no version"


def draw(work, library, examples):
    picture, checks = work / "picture.rgba", work / "checks.py"
    checks.write_text(CHECKS, encoding="utf-8")
    folders = {"HOME": str(work), "XDG_CONFIG_HOME": str(work), "XDG_CACHE_HOME": str(work),
               "BLENDER_USER_SCRIPTS": str(work / "scripts"), "TMPDIR": str(work)}
    package = {"PYTHONPATH": str(run.ROOT / "bindings" / "python"), "HRBFNPR_LIBRARY": str(library),
               "PYTHONDONTWRITEBYTECODE": "1"}
    blender = ["blender", "-b", "--factory-startup", "--python-exit-code", "3", "--python-use-system-env"]
    printed = run.run([*blender, "-P", ADDON / "draw.py", "-P", checks, "--", run.SAMPLES, picture],
                      env={**os.environ, **folders, **package})
    if "all checked" not in printed:
        raise run.Failed(printed)
    return picture
