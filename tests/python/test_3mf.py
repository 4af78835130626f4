# SPDX-License-Identifier: MIT
"""3MF: the build's items are placed, and damaged files give a clear error."""
import sys
from pathlib import Path

import numpy as np
import pytest
from test_shapes import write

from hrbfnpr import shapes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
from reader_files import CORE, TRIANGLES, VERTICES, mf3, mf3_model  # noqa: E402

CUBE = np.array(VERTICES, dtype=float)
PRODUCTION = 'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"'
MOVED = 'transform="1 0 0 0 1 0 0 0 1 5 6 7"'


def volume(shape):
    a, b, c = (shape.points[shape.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def test_a_cube(tmp_path):
    shape = shapes.read(write(tmp_path, "a.3mf", mf3()))
    np.testing.assert_array_equal(shape.points, CUBE)
    np.testing.assert_array_equal(shape.triangles, TRIANGLES)
    assert shape.format == "3MF" and shape.up == (0, 0, 1) and not shape.notes


def test_3mf_is_recognized_by_its_contents(tmp_path):
    other = shapes.read(write(tmp_path, "a.zip", mf3(name="other.model", target="other.model")))
    assert len(other.triangles) == 12
    assert "the file holds 3MF" in shapes.read(write(tmp_path, "a.stl", mf3())).notes[0]
    with pytest.raises(shapes.ShapeError, match="unpack it first"):
        shapes.read(write(tmp_path, "b.zip", b"PK\3\4" + bytes(100)))


def test_items_and_components_are_placed(tmp_path):
    pair = f'<object id="2"><components><component objectid="1"/><component objectid="1" {MOVED}/></components></object>'
    turned = 'transform="0 1 0 -1 0 0 0 0 2 0 0 0"'  # a quarter turn, and twice as high
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model(f'<item objectid="2" {turned}/>', pair))))
    turn = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 2]])
    np.testing.assert_allclose(shape.points, np.concatenate([CUBE @ turn, (CUBE + (5, 6, 7)) @ turn]))
    assert abs(volume(shape)) == pytest.approx(4)


def test_mirrored_parts_keep_their_outside(tmp_path):
    plain = shapes.read(write(tmp_path, "a.3mf", mf3()))
    mirror = 'transform="-1 0 0 0 1 0 0 0 1 0 0 0"'
    mirrored = shapes.read(write(tmp_path, "b.3mf", mf3(mf3_model(f'<item objectid="1" {mirror}/>'))))
    assert volume(mirrored) == pytest.approx(volume(plain))


def test_items_may_be_in_other_files_of_the_archive(tmp_path):
    build = f'<item objectid="1" p:path="/3D/a.model" {PRODUCTION}/><item objectid="1" {MOVED}/>'
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model(build), more=[("3D/a.model", mf3_model())])))
    np.testing.assert_array_equal(shape.points, np.concatenate([CUBE, CUBE + (5, 6, 7)]))


def test_print_supports_are_left_out(tmp_path):
    support = mf3_model('<item objectid="1"/><item objectid="3"/>').replace("</resources>", "{}</resources>")
    mesh = support[support.index("<mesh>") : support.index("</mesh>") + 7]
    model = support.replace("{}", f'<object id="3" type="support">{mesh}</object>')
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(model)))
    assert len(shape.points) == 8 and shape.notes == ("1 support object of the print left out",)


CIRCLE = '<object id="2"><components><component objectid="3"/></components></object>'
CIRCLE += '<object id="3"><components><component objectid="2"/></components></object>'
MANY = "".join(
    f'<object id="{i}"><components>{f"""<component objectid="{i - 1}"/>""" * 10}</components></object>'
    for i in range(2, 12)
)


@pytest.mark.parametrize(
    "data, words",
    [
        (mf3()[:-30], "not a whole ZIP archive"),
        (b"PK\3\4" + bytes(100), "not a whole ZIP archive"),
        (mf3().replace(b'x="1"', b'x="2"', 1), "not a whole ZIP archive"),  # its checksum differs
        (mf3("<model"), r"3D/3dmodel.model of the 3MF file is not XML: .*line 1, column"),
        (mf3('<?xml version="1.0" encoding="none"?><model/>'), "cannot be read|no XML"),
        (mf3(target="/3D/lost.model"), "refers to 3D/lost.model, which is not in it"),
        (mf3(mf3_model("")), "places nothing"),
        (mf3(f'<model xmlns="{CORE}"/>'), "places nothing"),
        (mf3(mf3_model('<item objectid="7"/>')), "places object '7', which 3D/3dmodel.model does not have"),
        (mf3(mf3_model('<item objectid="1" transform="1 2 x"/>')), "not 12 numbers: '1 2 x'"),
        (mf3(mf3_model('<item objectid="2"/>', CIRCLE)), "contain each other"),
        (mf3(mf3_model('<item objectid="11"/>', MANY)), "more than 100000 objects"),
        (mf3(mf3_model().replace('v3="3"', 'v3="99"', 1)), "names vertex 99, but there are only 8"),
        (mf3(mf3_model().replace('v3="3"', 'v3="-1"', 1)), "names vertex -1, but there are only 8"),
        (mf3(mf3_model().replace('v3="3"', 'v3="1e400"', 1)), "a triangle without v1, v2, v3"),
        (mf3(mf3_model().replace(' y="0"', "", 1)), "object '1' of the 3MF file has a vertex without x, y, z"),
    ],
)
def test_broken_files(tmp_path, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.3mf", data))


def test_odd_values_never_raise_anything_but_shape_error(tmp_path):
    rng = np.random.default_rng(5)
    odd = ["", "nan", "1e999", "-7", "x" * 50, "99999999999999999999", "model", "0x1", "é"]
    pieces = mf3_model(f'<item objectid="2" {MOVED}/>', CIRCLE.replace("3", "1", 1)).split('"')
    for _ in range(300):
        some = list(pieces)
        for at in rng.integers(1, len(some) - 1, 2):
            some[at] = odd[rng.integers(len(odd))]
        try:
            shapes.read(write(tmp_path, "a.3mf", mf3('"'.join(some))))
        except shapes.ShapeError:
            pass
