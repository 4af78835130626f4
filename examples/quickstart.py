# SPDX-License-Identifier: MIT
import hrbfnpr

picture = hrbfnpr.draw(hrbfnpr.datasets.torus(), "engraving", size=(800, 600))
picture.save("torus.png")
picture.save("torus.svg")
