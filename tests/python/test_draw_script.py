# SPDX-License-Identifier: MIT
"""scripts/draw uses an installed package or library of this version, and builds the library if there is none."""
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import PACKAGE, ROOT

import hrbfnpr

PYTHON = "/usr/bin/python3"  # the one that scripts/draw uses
TOOLS = ("bash", "basename", "cat", "dirname", "env", "grep", "id", "ln", "mkdir", "paste", "sed", "tr")
# It builds nothing: the build folder gets the library of this test.
CMAKE = """#!/bin/bash
if [ "$1" = --build ]; then mkdir -p "$2/src" && ln -sf {library} "$2/src/libhrbfnpr.so"; fi
"""


def can_draw():
    code = "import cffi, numpy, PIL, meshio, tqdm"
    return os.path.exists(PYTHON) and subprocess.run([PYTHON, "-c", code], capture_output=True).returncode == 0


pytestmark = pytest.mark.skipif(not can_draw(), reason=f"{PYTHON} lacks packages for drawing")


def write_program(path, text):
    path.write_text(text)
    path.chmod(0o755)


@pytest.fixture
def checkout(tmp_path):
    """A checkout with scripts/draw, the header and the Python package, and a PATH without apt-get."""
    library = Path(hrbfnpr.library_path).resolve()
    if not library.is_file():
        pytest.skip("the library is the system's")
    for folder in ("scripts", "include", "bindings", "bin"):
        (tmp_path / folder).mkdir()
    for name in ("scripts/draw", "scripts/lib.sh", "include/hrbfnpr.h"):
        shutil.copy(ROOT / name, tmp_path / name)
    copy_package(tmp_path / "bindings" / "python")
    torus = ROOT / "examples" / "torus.xyzn"
    write_program(tmp_path / "scripts" / "fetch_bunny", f"#!/bin/bash\necho {torus}\n")
    write_program(tmp_path / "bin" / "cmake", CMAKE.format(library=library))
    for tool in TOOLS:
        (tmp_path / "bin" / tool).symlink_to(shutil.which(tool))
    return tmp_path


def copy_package(folder):
    shutil.copytree(PACKAGE / "hrbfnpr", folder / "hrbfnpr", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def install_package(checkout):
    """Put a package with the library inside into a folder, and return it."""
    folder = copy_package(checkout / "site")
    (folder / "hrbfnpr" / "libhrbfnpr.so").symlink_to(Path(hrbfnpr.library_path).resolve())
    return folder


def draw(checkout, *options, **variables):
    environment = {"PATH": str(checkout / "bin"), "PYTHONDONTWRITEBYTECODE": "1", "HOME": str(checkout), **variables}
    run = subprocess.run(
        [checkout / "scripts" / "draw", "--size", "40", "--style", "silhouette", *options],
        env=environment, cwd=checkout, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    assert run.returncode == 0, run.stdout
    assert (checkout / "out" / "bunny.svg").stat().st_size > 100
    return run.stdout


def test_an_installed_package_of_this_version_is_used(checkout):
    site = install_package(checkout)
    told = draw(checkout, PYTHONPATH=str(site))
    assert f"using the installed Python package hrbfnpr {hrbfnpr.__version__}, with {site}" in told
    assert "building" not in told


def test_the_package_of_a_virtual_environment_is_used(checkout):
    site = install_package(checkout)
    write_program(checkout / "bin" / "python3", f'#!/bin/bash\nPYTHONPATH={site} exec {PYTHON} "$@"\n')
    assert f"using the installed Python package hrbfnpr {hrbfnpr.__version__}, with {site}" in draw(checkout)


def test_an_option_builds_although_a_package_is_installed(checkout):
    told = draw(checkout, "--build", PYTHONPATH=str(install_package(checkout)))
    assert "building the library" in told and "using the installed" not in told


def test_an_installed_package_of_another_version_is_not_used(checkout):
    header = checkout / "include" / "hrbfnpr.h"
    header.write_text(header.read_text().replace("HRBFNPR_VERSION_MINOR = ", "HRBFNPR_VERSION_MINOR = 9"))
    assert "building the library" in draw(checkout, PYTHONPATH=str(install_package(checkout)))


def test_the_package_of_the_checkout_is_not_an_installed_one(checkout):
    package = checkout / "bindings" / "python"
    variables = {"PYTHONPATH": str(package), "HRBFNPR_LIBRARY": hrbfnpr.library_path}
    assert "building the library" in draw(checkout, **variables)


def test_an_installed_library_of_this_version_is_used(checkout):
    folder = checkout / "lib"
    folder.mkdir()
    (folder / "libhrbfnpr.so.1").symlink_to(Path(hrbfnpr.library_path).resolve())
    told = draw(checkout, LD_LIBRARY_PATH=str(folder))
    assert f"using the installed library libhrbfnpr.so.1 {hrbfnpr.__version__}" in told
    assert "building" not in told


def test_help_names_the_option_that_builds():
    told = subprocess.run([ROOT / "scripts" / "draw", "--help"], capture_output=True, text=True, check=True).stdout
    assert "scripts/draw --build" in told
