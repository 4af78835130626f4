# SPDX-License-Identifier: MIT
"""Measures the native time of the page's first frame:  native_frame.py MODEL WIDTH HEIGHT

MODEL is the page's bunny.model. HRBFNPR_LIBRARY and PYTHONPATH name the library and its package.
"""
import statistics
import sys
import time

import hrbfnpr


def main(path, width, height):
    for threads in (1, 0):
        context = hrbfnpr.Context(threads)
        model = hrbfnpr.Model.load(path, context=context)
        marks = model.generate(preset="contour-and-stipple", budget=20000)
        lines = hrbfnpr.LineSet(model)
        renderer, style, times = hrbfnpr.Renderer(context=context), hrbfnpr.Style("contour-and-stipple"), []
        for turn in range(12):
            camera = hrbfnpr.Camera.fit(model, direction=(-0.4 - 0.1 * turn, -0.2, -1), size=(int(width), int(height)))
            begin = time.perf_counter()
            drawing = renderer.draw(hrbfnpr.Item(marks, style, line_set=lines), camera)
            drawing.raster(depth=False, id=False, class_=False)
            times.append(1000 * (time.perf_counter() - begin))
        print(f"native: a frame of {width} x {height} takes {statistics.median(times):.1f} ms with "
              f"{'one thread' if threads else 'all processors'}")


if __name__ == "__main__":
    main(*sys.argv[1:])
