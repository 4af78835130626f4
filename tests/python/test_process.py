# SPDX-License-Identifier: MIT
"""Other processes: without NumPy, after a fork, and with a wrong or missing library."""
import os
import shutil
import subprocess
import sys

import pytest
from conftest import PACKAGE


def run(code, **environment):
    return subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "PYTHONPATH": str(PACKAGE), **environment},
    )


WITHOUT_NUMPY = """
import sys
sys.modules["numpy"] = None
import array, math, hrbfnpr

axis = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
model = hrbfnpr.Model.fit(axis, axis)
result = model.evaluate([(2, 0, 0), (0, 0, 0)], gradient=True, hessian=True)
assert isinstance(result.value, memoryview) and result.value.shape == (2,)
assert result.gradient.shape == (2, 3) and result.hessian.shape == (2, 6)
assert result.value[0] > 0 > result.value[1]
flat = array.array("f", [2, 0, 0, 0, 0, 0])
assert list(model.evaluate(flat).value) == list(result.value)
assert list(model.evaluate(memoryview(flat).cast("B").cast("f", shape=[2, 3])).value) == list(result.value)
out = array.array("d", [0, 0])
model.evaluate(flat, out=hrbfnpr.Evaluation(out, None, None))
assert list(out) == list(result.value)
assert model.points.shape == (6, 3) and model.points.readonly
assert model.project([(2, 0, 0)]).converged == 1

def value(points):
    return [math.sqrt(sum(x * x for x in row)) - 1 for row in points.tolist()]

ball = hrbfnpr.Model.from_function(value, bounds=((-1, -1, -1), (1, 1, 1)))
assert abs(ball.evaluate([(0, 3, 0)]).value[0] - 2) < 1e-12
rays = ball.cast_rays([(0, 3, 0), (0, 0, 3)], [(0, -1, 0), (0, 0, 1)], maximum_hits=2)
assert rays.t.shape == (2, 2) and rays.position.shape == rays.normal.shape == (2, 2, 3)
assert abs(rays.t[0, 1] - 4) < 1e-8 and abs(rays.position[0, 0, 1] - 1) < 1e-8 and rays.t[1, 0] == math.inf
assert list(rays.hits) == [2, 0] and list(ball.contains([(0, 0.9, 0), (0, 1.1, 0)])) == [1, 0]
assert ball.cast_rays([(0, 3, 0)], [(0, -1, 0)]).position.shape == (1, 3)
marks = hrbfnpr.PointSet.generate(model, budget=500)
assert marks.layers[0].positions.shape == (len(marks), 3)
strokes = model.generate("hatch", budget=500).layers[0]
assert [sum(map(len, strokes.strokes())), len(strokes.strokes())] == [len(strokes), strokes.info.strokes]
own = hrbfnpr.PointSet.create(hrbfnpr.OwnLayer([(1, 0, 0), (0, 1, 0)], [(1, 0, 0), (0, 1, 0)], stroke_first=[0, 2]))
assert list(own.layers[0].stroke_first) == [0, 2] and list(own.layers[0].strokes()[0]) == [0, 1]
style = hrbfnpr.Style("stipple", tone=lambda positions, normals: [0.0] * len(normals))
camera = hrbfnpr.Camera.fit(marks, size=(60, 40))
assert camera.view[3, 3] == 1.0
drawing = hrbfnpr.Renderer().draw((marks, style), camera)
image = drawing.image()
assert image.shape == (40, 60, 4) and min(image.tobytes()) < 100
assert drawing.image(format="coverage8").shape == (40, 60)
assert drawing.image(format="rgba32f").format == "f" and drawing.raster().depth.shape == (40, 60)
vertices, indices = drawing.vertices()
assert vertices.shape[1] == 24 and len(vertices) > 100 and list(indices) == list(range(len(vertices)))
shown = drawing.mark_results().shown
assert sum(map(bool, shown)) == drawing.info.shown == len(drawing.mark_indices())
assert len(drawing.vertices("line_strips").indices) == 0
assert hrbfnpr.Camera(camera.view, camera.projection, camera.viewport) == camera
for bad in ([(1, 2)], [(1, 2, 3), (1, 2)], "abc"):
    try:
        model.evaluate(bad)
    except (ValueError, TypeError):
        continue
    raise AssertionError(bad)
print("fine")
"""


def test_without_numpy():
    result = run(WITHOUT_NUMPY)
    assert result.stdout == "fine\n", result.stderr


FORK = """
import multiprocessing, sys
import numpy as np, hrbfnpr

points = np.random.default_rng(1).normal(size=(150, 3))
points /= np.linalg.norm(points, axis=1)[:, None]
model = hrbfnpr.Model.fit(points, points)  # the library's threads are up before the fork
renderer = hrbfnpr.Renderer()

def work(i):
    other = hrbfnpr.Model.fit(points, points)
    marks = hrbfnpr.PointSet.generate(other, budget=400)
    style = hrbfnpr.Style("stipple")
    picture = renderer.draw((marks, style), hrbfnpr.Camera.fit(model, size=(50, 50))).image()
    return model.evaluate(points * 1.1).value, picture

if __name__ == "__main__":
    context = multiprocessing.get_context(sys.argv[1])
    with context.Pool(2) as pool:
        results = pool.map(work, range(4)) + [work(0)]
    for value, picture in results:
        assert np.array_equal(value, results[0][0]) and np.array_equal(picture, results[0][1])
    print("same")
"""


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_worker_processes(method, tmp_path):
    if not hasattr(os, "fork"):
        pytest.skip("no fork here")
    script = tmp_path / "work.py"
    script.write_text(FORK)
    result = subprocess.run(
        [sys.executable, script, method],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "PYTHONPATH": str(PACKAGE)},
    )
    assert result.stdout == "same\n", result.stderr


def test_a_missing_library_is_named():
    result = run("import hrbfnpr", HRBFNPR_LIBRARY="/nowhere/libhrbfnpr.so")
    assert result.returncode == 1
    assert "ImportError: cannot load HRBFNPR_LIBRARY" in result.stderr and "/nowhere/libhrbfnpr.so" in result.stderr


@pytest.mark.parametrize(
    "source, words",
    [
        ("unsigned hrbfnpr_abi_version(void) { return 4711; }", "has ABI version 4711, this package needs "),
        ("int something_else(void) { return 0; }", "is not a hrbfnpr library"),
    ],
)
def test_a_wrong_library_is_named(tmp_path, source, words):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler")
    (tmp_path / "wrong.c").write_text(source)
    library = tmp_path / "libhrbfnpr.so"
    subprocess.run([compiler, "-shared", "-fPIC", "-o", library, tmp_path / "wrong.c"], check=True)
    result = run("import hrbfnpr", HRBFNPR_LIBRARY=str(library))
    assert result.returncode == 1 and words in result.stderr


def test_a_copy_of_the_package_finds_the_library_inside(tmp_path):
    import hrbfnpr

    shutil.copytree(PACKAGE / "hrbfnpr", tmp_path / "hrbfnpr", ignore=shutil.ignore_patterns("__pycache__"))
    if not os.path.isfile(hrbfnpr.library_path):
        pytest.skip("the library is the system's")
    shutil.copy(hrbfnpr.library_path, tmp_path / "hrbfnpr" / "libhrbfnpr.so")
    result = run("import hrbfnpr; print(hrbfnpr.library_path)", PYTHONPATH=str(tmp_path), HRBFNPR_LIBRARY="")
    assert result.stdout.strip() == str(tmp_path / "hrbfnpr" / "libhrbfnpr.so"), result.stderr


def test_the_interpreter_exits_cleanly_with_live_objects():
    result = run(
        "import hrbfnpr\n"
        "context = hrbfnpr.Context(2, log=print)\n"
        "model = hrbfnpr.Model.from_function(lambda p: p[:, 0], bounds=((0, 0, 0), (1, 1, 1)), context=context)\n"
        "marks = hrbfnpr.PointSet.generate(model, budget=100, context=context)\n"
        "view = marks.layers[0].positions\n"
        "renderer = hrbfnpr.Renderer(context=context)\n"
        "drawing = renderer.draw(marks, hrbfnpr.Camera.fit(marks, size=(50, 50)))\n"
    )
    assert (result.returncode, result.stderr) == (0, "")
