# SPDX-License-Identifier: MIT
"""192 samples of a torus become a pen-and-ink drawing, torus.png."""
import numpy as np

import hrbfnpr

a, b = np.meshgrid(np.linspace(0, 2 * np.pi, 24, endpoint=False), np.linspace(0, 2 * np.pi, 8, endpoint=False))
normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=-1).reshape(-1, 3)
points = np.stack([np.cos(a), np.sin(a), 0 * a], axis=-1).reshape(-1, 3) + 0.4 * normals

model = hrbfnpr.Model.fit(points, normals)  # samples become a smooth surface,
style = hrbfnpr.Style("contour-and-stipple")
marks = model.generate(preset=style.preset)  # on which the marks of a style are placed
camera = hrbfnpr.Camera.fit(model, direction=(0, 1, -1), up=(0, 0, 1), size=(800, 600))
hrbfnpr.Renderer().draw((marks, style), camera).save("torus.png")  # and drawn for a camera.
