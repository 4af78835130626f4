# SPDX-License-Identifier: MIT
"""Draws samples without a window: a mesh object in, the pixels of an image datablock out.

    blender -b --factory-startup --python-exit-code 3 --python-use-system-env -P draw.py -- SAMPLES PICTURE

SAMPLES has lines `x y z nx ny nz`. PICTURE is a PNG, or rows of RGBA8 if its name has another ending.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import hrbfnpr_addon


def samples_object(path):
    """Makes a mesh object with the points as vertices and the normals as an attribute. It becomes the active object."""
    values = np.loadtxt(path, ndmin=2)
    mesh = bpy.data.meshes.new("samples")
    mesh.from_pydata(values[:, :3].tolist(), [], [])
    normals = mesh.attributes.new(hrbfnpr_addon.NORMAL, "FLOAT_VECTOR", "POINT")
    normals.data.foreach_set("vector", values[:, 3:].astype(np.float32).ravel())
    result = bpy.data.objects.new("samples", mesh)
    bpy.context.collection.objects.link(result)
    bpy.context.view_layer.objects.active = result
    return result


def save(image, path):
    if path.endswith(".png"):
        image.file_format, image.filepath_raw = "PNG", path
        image.save()
        return
    width, height = image.size
    pixels = np.empty(4 * width * height, np.float32)
    image.pixels.foreach_get(pixels)
    rows = np.rint(pixels * 255).astype(np.uint8).reshape(height, width, 4)
    rows[::-1].tofile(path)  # Blender's rows start at the bottom


samples, picture = sys.argv[sys.argv.index("--") + 1 :]
hrbfnpr_addon.register()
samples_object(samples)
bpy.ops.hrbfnpr.draw()
save(bpy.data.images[hrbfnpr_addon.IMAGE], picture)
