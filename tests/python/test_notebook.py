# SPDX-License-Identifier: MIT
"""Pictures in matplotlib axes, and the notebook viewer."""
import io
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT, torus

import hrbfnpr

Image = pytest.importorskip("PIL.Image")

SOURCE = torus(14, 6)
QUICK = {"size": 90, "marks": 800}


def shown(viewer):
    return np.asarray(Image.open(io.BytesIO(viewer.image.value)))


def test_the_package_imports_no_notebook_packages():
    code = "import sys, hrbfnpr; hrbfnpr.draw, hrbfnpr.matplotlib_show, hrbfnpr.widget, hrbfnpr.batch, hrbfnpr.animate"
    code += "; print([name for name in ('matplotlib', 'ipywidgets', 'IPython', 'distributed') if name in sys.modules])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.stdout == "[]\n", run.stderr


def test_missing_packages_are_named(monkeypatch):
    for name, call, words in (
        ("matplotlib", lambda: hrbfnpr.matplotlib_show(np.zeros((2, 2, 4), dtype=np.uint8)), "python3-matplotlib"),
        ("ipywidgets", lambda: hrbfnpr.widget(SOURCE, **QUICK), "python3-ipywidgets"),
    ):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ImportError, match=words):
            call()


def test_axes_show_the_pixels():
    matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed (Debian: python3-matplotlib)")
    matplotlib.use("agg")
    from matplotlib import pyplot

    picture = hrbfnpr.draw(SOURCE, **QUICK)
    figure, axes = pyplot.subplots(1, 2)
    image = hrbfnpr.matplotlib_show(picture, axes[0], interpolation="nearest")
    assert np.array_equal(image.get_array(), picture.image) and image.get_interpolation() == "nearest"
    assert not axes[0].axison and axes[1].axison
    pyplot.sca(axes[1])
    assert np.array_equal(hrbfnpr.matplotlib_show(picture.drawing).get_array(), picture.image)
    assert hrbfnpr.matplotlib_show(picture.image).axes is axes[1]
    figure.canvas.draw()
    assert (np.asarray(figure.canvas.buffer_rgba())[..., 0] < 100).sum() > 200  # there is ink
    pyplot.close(figure)


def test_the_same_model_can_be_drawn_in_another_style():
    picture = hrbfnpr.draw(SOURCE, "stipple", **QUICK).seen(azimuth=80)
    other = picture.restyled("silhouette")
    assert other.camera == picture.camera and other.model is picture.model and other.style.preset == "silhouette"
    whole = hrbfnpr.draw(SOURCE, "silhouette", azimuth=80, **QUICK)
    assert np.array_equal(other.image, whole.image)
    assert other.seen(elevation=50).camera == picture.seen(elevation=50).camera
    with pytest.raises(ValueError, match="style must be one of"):
        picture.restyled("cubist")


def test_a_viewer_follows_its_widgets(monkeypatch):
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed (Debian: python3-ipywidgets)")
    viewer = hrbfnpr.widget(SOURCE, "stipple", **QUICK)
    assert (viewer.azimuth.value, viewer.elevation.value, viewer.style.value) == (30, 20, "stipple")
    assert np.array_equal(shown(viewer), viewer.picture.image)
    viewer.azimuth.value = 75
    assert np.array_equal(shown(viewer), hrbfnpr.draw(SOURCE, "stipple", azimuth=75, **QUICK).image)
    viewer.style.value = "silhouette"
    viewer.elevation.value = 45
    assert np.array_equal(shown(viewer), hrbfnpr.draw(SOURCE, "silhouette", azimuth=75, elevation=45, **QUICK).image)
    assert viewer.message.value == "" and viewer.box.children[1] is viewer.image
    display, put = pytest.importorskip("IPython.display"), []
    monkeypatch.setattr(display, "display", put.append)
    viewer._ipython_display_()
    assert put == [viewer.box]


def test_a_viewer_keeps_the_given_style():
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed (Debian: python3-ipywidgets)")
    viewer = hrbfnpr.widget(SOURCE, hrbfnpr.Style("stipple", stipples={"radius": 3.0}), **QUICK)
    first = shown(viewer)
    viewer.style.value = "silhouette"
    assert not np.array_equal(shown(viewer), first)
    viewer.style.value = "own"
    assert np.array_equal(shown(viewer), first)


def test_a_viewer_shows_errors(monkeypatch):
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed (Debian: python3-ipywidgets)")
    viewer = hrbfnpr.widget(SOURCE, **QUICK)
    before = shown(viewer)

    def fail(*arguments):
        raise ValueError("the picture would be blank")

    monkeypatch.setattr(hrbfnpr.Picture, "restyled", fail)
    viewer.style.value = "silhouette"
    assert viewer.message.value == "the picture would be blank" and np.array_equal(shown(viewer), before)


def test_the_example_of_the_documentation_runs():
    matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed (Debian: python3-matplotlib)")
    pytest.importorskip("ipywidgets", reason="ipywidgets is not installed (Debian: python3-ipywidgets)")
    matplotlib.use("agg")
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    (block,) = [one for one in re.findall(r"^```py\n(.*?)^```$", text, re.DOTALL | re.MULTILINE) if "matplotlib_show" in one]
    names = {}
    exec(compile(block, "python.md", "exec"), names)
    assert [len(ax.images) for ax in names["axes"]] == [1, 1] and names["viewer"].message.value == ""
    matplotlib.pyplot.close("all")
