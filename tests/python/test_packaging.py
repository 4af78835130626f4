# SPDX-License-Identifier: MIT
"""The wheel, the type annotations and the documentation."""
import os
import shutil
import subprocess
import sys
import zipfile

import pytest
from conftest import PACKAGE, ROOT, torus

import hrbfnpr


def test_a_wheel_with_the_library_inside(tmp_path):
    for module in ("setuptools", "wheel", "pip"):
        pytest.importorskip(module)
    if not os.path.isfile(hrbfnpr.library_path):
        pytest.skip("the library is the system's")
    # Build a copy, so that no build folder stays in the checkout.
    copy = tmp_path / "tree" / "bindings" / "python"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
    (tmp_path / "tree" / "include").mkdir()
    for name in ("include/hrbfnpr.h", "LICENSE", "THIRD-PARTY-NOTICES.md"):
        shutil.copy(ROOT / name, tmp_path / "tree" / name)
    environment = {**os.environ, "HRBFNPR_LIBRARY": hrbfnpr.library_path, "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    options = ["--no-build-isolation", "--no-deps", "--no-index", "-q", "-w", str(tmp_path)]
    run = subprocess.run(
        [sys.executable, "-m", "pip", "wheel", *options, str(copy)], env=environment, capture_output=True, text=True
    )
    assert run.returncode == 0, run.stderr + run.stdout
    (wheel,) = tmp_path.glob("*.whl")
    name, version, python, abi, platform = wheel.stem.split("-")
    assert (name, version, python, abi) == ("hrbfnpr", hrbfnpr.__version__, "py3", "none")
    assert platform != "any"
    place = tmp_path / "place"
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        archive.extractall(place)
    assert "hrbfnpr/py.typed" in names and "hrbfnpr/cli/__init__.py" in names
    assert {"hrbfnpr/_records.json", "hrbfnpr/_records.pyi", "hrbfnpr/_options.json", "hrbfnpr/_draw_call.pyi"} <= set(names)
    assert any(name.startswith("hrbfnpr/libhrbfnpr.") for name in names)
    assert {f"hrbfnpr-{version}.dist-info/{name}" for name in ("LICENSE", "THIRD-PARTY-NOTICES.md")} <= set(names)
    environment.update(PYTHONPATH=str(place), HRBFNPR_LIBRARY="")
    code = "import hrbfnpr; print(hrbfnpr.library_path); hrbfnpr.Model.fit([[0, 0, 0]], [[0, 0, 1]])"
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment, cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert run.stdout.startswith(str(place))
    entry_points = next(name for name in names if name.endswith("entry_points.txt"))
    assert "hrbfnpr = hrbfnpr.cli:main" in (place / entry_points).read_text()


def test_types():
    mypy = shutil.which("mypy")
    if mypy is None:
        pytest.skip("mypy is not installed")
    run = subprocess.run(
        [mypy, "--cache-dir", os.devnull, "--python-version", "3.9"], cwd=PACKAGE, capture_output=True, text=True
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_examples_of_the_documentation_run(tmp_path, monkeypatch):
    import re

    import numpy as np

    tqdm = pytest.importorskip("tqdm")
    pytest.importorskip("PIL")
    points, normals = torus()
    lines = [f"{x} {y} {z} {a} {b} {c}" for (x, y, z), (a, b, c) in zip(points, normals)]
    header = ["ply", "format ascii 1.0", f"element vertex {len(lines)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    (tmp_path / "bunny.ply").write_text("\n".join([*header, "end_header", *lines, ""]))
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE)
    assert len(blocks) >= 3
    names = {"np": np, "tqdm": tqdm, "hrbfnpr": hrbfnpr}
    for block in blocks:
        exec(compile(block, "python.md", "exec"), names)
    assert (tmp_path / "bunny.png").stat().st_size > 1000
    for name in ("stippled.png", "torus.gif", "torus.png", "torus-07.png"):
        assert (tmp_path / name).stat().st_size > 1000
    assert names["ball"].evaluate([0, 0, 3]).value == pytest.approx(2)


def test_everything_public_is_documented():
    import inspect

    for name in (*hrbfnpr.__all__, *hrbfnpr._ON_DEMAND):
        value = getattr(hrbfnpr, name)
        if not (inspect.isclass(value) or inspect.isfunction(value)):
            continue
        assert value.__doc__, name
        if not inspect.isclass(value):
            continue
        for member, thing in vars(value).items():
            if not member.startswith("_") and (inspect.isfunction(thing) or isinstance(thing, (property, classmethod))):
                documented = thing if isinstance(thing, property) else getattr(value, member)
                assert documented.__doc__, f"{name}.{member}"
