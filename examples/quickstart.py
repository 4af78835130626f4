"""192 samples of a torus become a pen-and-ink drawing, torus.png."""
import numpy as np
from PIL import Image

import hrbfnpr

a, b = (grid.ravel() for grid in np.meshgrid(2 * np.pi * np.arange(24) / 24, 2 * np.pi * np.arange(8) / 8))
normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=1)
points = np.stack([np.cos(a), np.sin(a), 0 * a], axis=1) + 0.4 * normals

# Samples become a smooth surface, on which the marks of a style are placed and drawn for a camera.
model = hrbfnpr.Model.fit(points, normals)
style = hrbfnpr.Style.preset("hatch")
marks = hrbfnpr.PointSet.generate(model, groups=style.groups)
camera = hrbfnpr.Camera.fit_bounds(*model.bounds, direction=(0, 1, -1), up=(0, 0, 1), size=(800, 600))
picture = hrbfnpr.Renderer().draw(marks, camera, style)
Image.fromarray(picture).save("torus.png")
