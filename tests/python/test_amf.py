# SPDX-License-Identifier: MIT
"""AMF files, plain and zipped as slicers write them."""
import io
import zipfile

import numpy as np
import pytest
from test_shapes import CUBE, QUADS, write

from hrbfnpr import shapes
from hrbfnpr.cli import main

TRIANGLES = [part for a, b, c, d in QUADS for part in ((a, b, c), (a, c, d))]


def mesh(triangles=TRIANGLES):
    corners = "".join(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>" for x, y, z in CUBE)
    faces = ["".join(f"<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>" for a, b, c in part)
             for part in (triangles[:4], triangles[4:])]  # fmt: skip
    volumes = "".join(f"<volume materialid='1'><metadata type='name'>x</metadata>{part}</volume>" for part in faces)
    return f"<mesh><vertices>{corners}</vertices>{volumes}</mesh>"


def amf(more="", body=None):
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<!-- a slicer -->\n<amf unit="millimeter">'
        '<metadata type="cad">none</metadata><object id="1"><metadata type="name">box</metadata>'
        f"{mesh() if body is None else body}</object>{more}</amf>"
    )


def instance(number, **place):
    return f"<instance objectid='{number}'>" + "".join(f"<{k}>{v}</{k}>" for k, v in place.items()) + "</instance>"


def zipped(*files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files:
            archive.writestr(name, text)
    return data.getvalue()


def test_all_volumes_of_an_object_are_read(tmp_path):
    shape = shapes.read(write(tmp_path, "box.amf", amf()))
    assert shape.format == "AMF" and shape.up == (0, 0, 1) and len(shape.triangles) == 12
    np.testing.assert_array_equal(shape.points, CUBE)
    assert shapes.read(write(tmp_path, "box.xml", amf())).format == "AMF"  # known by its contents


def test_constellations_place_objects(tmp_path):
    one = instance(1, deltax=5, rx=90, rz=90) + instance(1, deltaz=-3)
    outer = f"<constellation id='2'>{one}</constellation><constellation id='3'>{instance(2, deltay=10)}</constellation>"
    alone = f"<object id='4'>{mesh()}</object>"
    shape = shapes.read(write(tmp_path, "boxes.amf", amf(outer + alone)))
    assert len(shape.triangles) == 36
    first, second, third = (shape.points[8 * k : 8 * k + 8] for k in range(3))
    x, y, z = np.array(CUBE, dtype=float).T
    np.testing.assert_allclose(first, np.column_stack([z + 5, x + 10, y]), atol=1e-12)  # x to y, y to z, z to x
    np.testing.assert_allclose(second, np.array(CUBE) + [0, 10, -3], atol=1e-12)
    np.testing.assert_array_equal(third, CUBE)


def test_zipped_files_are_read(tmp_path, capsys):
    path = write(tmp_path, "box.amf", zipped(("readme.txt", "none"), ("Box.AMF", amf())))
    assert len(shapes.read(path).triangles) == 12
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "100", "--marks", "600"]) == 0
    assert "AMF: " in capsys.readouterr().out


def test_unreadable_files_are_named(tmp_path):
    circle = f"<constellation id='2'>{instance(3)}</constellation><constellation id='3'>{instance(2)}</constellation>"
    within = f"<constellation id='5'>{instance(2)}</constellation>"
    cases = {
        "not valid XML": "<amf><object>",
        "has no triangles$": "<amf></amf>",
        "has no triangles, or none that is placed": amf(body=mesh([])),
        "object '1' of the AMF file names vertex 8, but there are only 8": amf(body=mesh([*TRIANGLES, (0, 1, 8)])),
        "names vertex 0.5": amf(body=mesh([*TRIANGLES, (0, 1, 0.5)])),
        "a triangle whose v1, v2, v3 are not numbers": amf(body=mesh([*TRIANGLES, (0, 1, "a")])),
        "a vertex whose coordinates/x, ": amf(body=mesh().replace("<x>", "<w>").replace("</x>", "</w>")),
        "contain each other": amf(circle + within),
        "places object '7', which it does not have": amf(f"<constellation id='2'>{instance(7)}</constellation>"),
        "the place of object '1' in the AMF file is not given by numbers":
            amf(f"<constellation id='2'>{instance(1, deltax='here')}</constellation>"),
        "packed as a ZIP archive, and the model is not in it": zipped(("box.txt", amf())),
        "packed as a ZIP archive, and damaged": zipped(("box.amf", amf()))[:200],
    }  # fmt: skip
    for number, (what, data) in enumerate(cases.items()):
        with pytest.raises(shapes.ShapeError, match=what):
            shapes.read(write(tmp_path, f"{number}.amf", data))
