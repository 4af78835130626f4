# SPDX-License-Identifier: MIT
"""The package and its command work with the NumPy 1.19 and the Pillow 8 of Debian 11, which lack some names of newer ones."""
import os
import re
import subprocess
import sys

import pytest
from conftest import PACKAGE, ROOT

WITHOUT_TYPING = "import sys, numpy\nsys.modules['numpy.typing'] = None\n"  # an import of numpy.typing now fails
TORUS = ROOT / "examples" / "torus.xyzn"


def run(code, folder, *arguments):
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT_TYPING + code, *map(str, arguments)],
        cwd=folder, env=os.environ, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_this_file_hides_numpy_typing(tmp_path):
    code = "try:\n    import numpy.typing\nexcept ImportError:\n    print('missing')"
    assert run(code, tmp_path) == "missing\n"


def test_shapes_need_no_numpy_typing(tmp_path):
    code = "import hrbfnpr.shapes\nprint(len(hrbfnpr.shapes.read(sys.argv[1]).points))"
    assert run(code, tmp_path, TORUS) == "192\n"


def test_the_command_needs_no_numpy_typing(tmp_path):
    code = "from hrbfnpr.cli import main\nsys.exit(main(sys.argv[1:]))"
    run(code, tmp_path, "draw", TORUS, "torus.svg", "--size", 60, "--style", "silhouette")
    assert (tmp_path / "torus.svg").stat().st_size > 100


def test_no_module_uses_the_enumerations_of_pillow_9():
    newer = re.compile(r"Image\.(Dither|Palette|Quantize|Resampling|Transform|Transpose)\b")
    lines = [f"{path.name}: {line}" for path in (PACKAGE / "hrbfnpr").rglob("*.py")
             for line in path.read_text().splitlines() if newer.search(line.partition("#")[0])]  # fmt: skip
    assert lines == []


def test_labels_of_a_sheet_with_a_font_of_pillow_8(monkeypatch):
    pytest.importorskip("PIL")
    from PIL import ImageFont

    from hrbfnpr.cli._sheet import _label

    newer = ImageFont.load_default()
    if not hasattr(newer, "getbbox"):
        pytest.skip("this is an old Pillow")

    class OldFont:
        getmask = staticmethod(newer.getmask)

        @staticmethod
        def getsize(text):
            return newer.getbbox(text)[2:]

    wanted = _label("engraving", 20, 400)
    monkeypatch.setattr(ImageFont, "load_default", OldFont)
    assert _label("engraving", 20, 400).size == wanted.size
