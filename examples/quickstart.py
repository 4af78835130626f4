# SPDX-License-Identifier: MIT
"""192 samples of a torus become a pen-and-ink drawing, torus.png and torus.svg."""
import numpy as np

import hrbfnpr

a, b = np.meshgrid(np.linspace(0, 2 * np.pi, 24, endpoint=False), np.linspace(0, 2 * np.pi, 8, endpoint=False))
normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=-1).reshape(-1, 3)
points = np.stack([np.cos(a), np.sin(a), 0 * a], axis=-1).reshape(-1, 3) + 0.4 * normals

picture = hrbfnpr.draw((points, normals), "engraving", size=(800, 600))
picture.save("torus.png")
picture.save("torus.svg")
