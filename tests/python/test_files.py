# SPDX-License-Identifier: MIT
"""Files of every format, in the dialects that programs write."""
import gzip
import sys

import numpy as np
import pytest
from test_scans import COLOURS, NORMALS, POINTS, grid, is_right, las, lines, pcd
from test_shapes import CUBE, QUADS, ply_header, stl, write

from hrbfnpr import shapes

# --- tables ------------------------------------------------------------------------------------

GREY = np.arange(60)
TABLES = {
    "plain.xyz": lines(POINTS, NORMALS),
    "tab.txt": lines(POINTS, NORMALS, mark="\t"),
    "comma.csv": lines(POINTS, NORMALS, mark=","),
    "comma_space.csv": lines(POINTS, NORMALS, mark=", "),
    "semicolon.csv": lines(POINTS, NORMALS, mark=";"),
    "ends_with_comma.csv": lines(POINTS, NORMALS, mark=",").replace("\n", ",\n"),
    "meshlab.pts": "60\n" + lines(POINTS, GREY, COLOURS, NORMALS),
    "cloudcompare.asc": "//X Y Z R G B Nx Ny Nz\n" + lines(POINTS, COLOURS, NORMALS),
    "cloudcompare_count.asc": "//X Y Z R G B Scalar_field Nx Ny Nz\n60\n" + lines(POINTS, COLOURS, GREY, NORMALS),
    "cloudcompare_commas.txt": "//X,Y,Z,Nx,Ny,Nz\n" + lines(POINTS, NORMALS, mark=","),
    "normals_first.txt": "nx ny nz x y z\n" + lines(NORMALS, POINTS),
    "colours.xyz": lines(POINTS, COLOURS, NORMALS),
    "colours_behind.xyz": lines(POINTS, NORMALS, COLOURS),
    "colours_of_one.xyz": lines(POINTS, COLOURS / 255, NORMALS),
    "intensity.pts": "60\n" + lines(POINTS, GREY, NORMALS),
    "numbered.txt": lines(GREY + 1, POINTS, NORMALS),
    "curvature.xyz": lines(POINTS, NORMALS, GREY / 60),
    "heading.csv": "id,X,Y,Z,Normal_X,Normal_Y,Normal_Z\n" + lines(GREY, POINTS, NORMALS, mark=","),
    "quoted.csv": '"x","y","z","nx","ny","nz"\n' + lines(POINTS, NORMALS, mark=","),
    "paraview.csv": '"Normals:0","Normals:1","Normals:2","Points:0","Points:1","Points:2"\n'
    + lines(NORMALS, POINTS, mark=","),
    "units.csv": "x [mm];y [mm];z [mm];nx;ny;nz\n" + lines(POINTS, NORMALS, mark=";"),
    "two_scans.pts": "20\n" + lines(POINTS, GREY, NORMALS).replace("\n", "\n40\n", 20).replace("\n40\n", "\n", 19),
    "comment_with_names.xyz": "# x y z\n" + lines(POINTS, NORMALS),
    "comment.xyz": "# made by a test\n; and another\n" + lines(POINTS, NORMALS),
    "decimal_commas.txt": lines(POINTS, NORMALS, mark="\t").replace(".", ","),
    "decimal_commas.csv": lines(POINTS, NORMALS, mark=";").replace(".", ","),
    "no_ending": lines(POINTS, NORMALS),
    "odd_ending.dat2": lines(POINTS, NORMALS),
    "scaled.xyz": lines(POINTS, 3 * NORMALS),
    "exponents.xyz": lines(POINTS, NORMALS, form="{:.9e}"),
}
TABLES["words.csv"] = "x,y,z,what,nx,ny,nz\n" + "".join(
    ",".join(map(str, [*p, "a tree", *n])) + "\n" for p, n in zip(POINTS.tolist(), NORMALS.tolist())
)


@pytest.mark.parametrize("name", TABLES)
@pytest.mark.parametrize("dress", ["", "crlf", "mac", "bom", "utf16", "gzip"])
def test_tables(tmp_path, name, dress):
    text = TABLES[name]
    data = {
        "": text.encode(),
        "crlf": text.replace("\n", "\r\n").encode(),
        "mac": text.replace("\n", "\r").encode(),
        "bom": b"\xef\xbb\xbf" + text.encode(),
        "utf16": text.encode("utf-16"),
        "gzip": gzip.compress(text.encode()),
    }[dress]
    shape = shapes.read(write(tmp_path, name + (".gz" if dress == "gzip" else ""), data))
    factor = 3 if name == "scaled.xyz" else 1
    np.testing.assert_allclose(shape.points, POINTS, atol=1e-5)
    np.testing.assert_allclose(shape.normals, factor * NORMALS, atol=1e-5)
    assert set("xyz") <= set(shape.columns) and "nx" in shape.columns


@pytest.mark.parametrize(
    "text, columns",
    [
        (lines(POINTS), "xyz"),
        (lines(POINTS, COLOURS), "rgb"),
        (lines(POINTS, COLOURS / 255), "rgb"),
        (lines(POINTS, GREY), "other"),
        (lines(POINTS, GREY, COLOURS), "rgb"),
        ("//X Y Z R G B\n" + lines(POINTS, COLOURS), "rgb"),
        (lines(GREY, POINTS), "number"),
        ("x,y,z,r,g,b,label\n" + lines(POINTS, COLOURS, GREY, mark=","), "rgb"),
        (lines(POINTS, 0 * COLOURS), "rgb"),
    ],
    ids=range(9),
)
def test_colours_are_no_normals(tmp_path, text, columns):
    shape = shapes.read(write(tmp_path, "a.txt", text))
    assert is_right(shape, normals=False)
    assert ("red" in shape.columns) == (columns == "rgb")


def test_the_meaning_of_columns_is_reported(tmp_path):
    assert "columns 4 to 6 are colours" in shapes.read(write(tmp_path, "a.xyz", lines(POINTS, COLOURS))).notes[0]
    scaled = write(tmp_path, "b.xyz", TABLES["scaled.xyz"])
    assert "columns 4 to 6 are read as normals, though" in shapes.read(scaled).notes[0]
    counted = shapes.read(write(tmp_path, "d.txt", lines(GREY, POINTS, COLOURS))).notes
    assert "column 1 counts the points" in counted[0] and "columns 5 to 7 are colours" in counted[1]
    assert "commas are read as decimal marks" in shapes.read(write(tmp_path, "c.txt", TABLES["decimal_commas.txt"])).notes[0]


def test_missing_values_become_nan(tmp_path):
    text = "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,,6,0,0,1\n7,8,9,,,\n"
    shape = shapes.read(write(tmp_path, "a.csv", text))
    assert np.isnan(shape.points[1, 1]) and np.isnan(shape.normals[2]).all() and shape.points[2, 2] == 9
    points, normals = shapes.samples(shape)
    np.testing.assert_array_equal(points, [[1, 2, 3]])


@pytest.mark.parametrize(
    "name, text, words",
    [
        ("a.xyz", "Dear Sir,\n", "line 1, column 1: 'Dear' is not a number; a line holds x y z"),
        ("a.xyz", "1 2 3\n4 5 six\n", "line 2, column 3: 'six' is not a number"),
        ("a.csv", "x,y,z\n1,2,3\n4,five,6\n", "line 3, column 2: 'five' is not a number"),
        ("a.csv", "1;2;3\n4;;6\n7;8;nine\n", "line 3, column 3: 'nine' is not a number"),
        ("a.csv", "x,y,z\n1,2\n", "line 2: there are 2 columns, but 3 were expected"),
        ("a.txt", "# one\n# two\n1 2 3\n\n4 5\n", "line 5: there are 2 numbers, but line 3 has 3"),
        ("a.pts", "3\n1 2 3\n4 5 6\n", "the first line says 3 points, but 2 lines"),
        ("a.xyz", "1 2 " + 300 * "x" + "\n", r"column 3: '" + 37 * "x" + r"\.\.\.' is not"),
        ("a.xyz", "lon lat\n1 2\n", "line 1, column 1: 'lon' is not a number"),
    ],
)
def test_broken_tables(tmp_path, name, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, name, text))


def test_a_large_table_is_read_fast(tmp_path):
    import time

    table = np.random.default_rng(1).normal(size=(200_000, 6)).round(5)
    text = "\n".join(" ".join(map(str, row)) for row in table.tolist())
    path = write(tmp_path, "a.xyz", text)
    start = time.perf_counter()
    shape = shapes.read(path)
    assert len(shape.points) == 200_000 and time.perf_counter() - start < 5.0
    path = write(tmp_path, "b.xyz", text + "\n1 2 3 4 5 six\n")
    with pytest.raises(shapes.ShapeError, match="line 200001, column 6: 'six'"):
        shapes.read(path)
    assert time.perf_counter() - start < 15.0


# --- the format of a file ----------------------------------------------------------------------

CUBE_OBJ = "# made by a test\no cube\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in CUBE) + "".join(
    "f " + " ".join(str(i + 1) for i in quad) + "\n" for quad in QUADS
)
CUBE_OFF = "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in CUBE)
CUBE_OFF += "".join("4 " + " ".join(map(str, quad)) + "\n" for quad in QUADS)


@pytest.mark.parametrize(
    "ending, data, kind",
    [
        ("xyz", stl(True), "STL, binary"),
        ("ply", stl(False), "STL, ascii"),
        ("stl", CUBE_OBJ.encode(), "OBJ"),
        ("obj", CUBE_OFF.encode(), "OFF"),
        ("docx", CUBE_OFF.encode(), "OFF"),
        ("off", TABLES["plain.xyz"].encode(), "text"),
        ("stl", TABLES["plain.xyz"].encode(), "text"),
        ("txt", CUBE_OBJ.encode(), "OBJ"),
        ("", CUBE_OBJ.encode(), "OBJ"),
        ("", ply_header("ascii", ("vertex", 1, ["float x", "float y", "float z"])) + b"1 2 3\n", "PLY, ascii"),
    ],
)
def test_contents_override_the_ending(tmp_path, ending, data, kind):
    path = write(tmp_path, f"a.{ending}" if ending else "a", data)
    shape = shapes.read(path)
    assert shape.format == kind
    lied = ending in ("xyz", "ply", "stl", "obj", "txt", "off")
    assert any(f"the ending is .{ending}, but the file holds" in note for note in shape.notes) == lied


@pytest.mark.parametrize(
    "name, data, words",
    [
        ("a.docx", b"PK\3\4" + bytes(200), r"files that end in \.docx are not read; MeshLab.* These are read: PLY, OBJ, STL"),
        ("a.sldprt", b"\xd0\xcf", "its program exports STEP or STL"),
        ("a.usdz", b"PK", "Blender exports it as glTF"),
        ("a.zip", b"PK\3\4" + bytes(200), "unpack it first"),
        ("a", bytes(range(256)), "no ending, and its contents are of no known format.* These are read: "),
        ("a.xyz", bytes(range(256)), "binary data"),
        ("a.ply", b"", "not a PLY file: the file is empty"),
        ("a.glb", b"", "not a glTF file: the file is empty"),
        ("a.csv", b" \n", "no points: the file holds only blanks"),
        ("a.obj", b"# nothing\n", "no points"),
        ("a.ply.gz", gzip.compress(b"ply\n")[:-6], "packed by gzip and is damaged"),
        ("a.blend", b"\x28\xb5\x2f\xfd" + bytes(20), "packed by zstd.*unzstd"),
        ("a.docx.gz", gzip.compress(b"PK\3\4" + bytes(200)), r"files that end in \.docx are not read"),
        ("a.obj", b"<!DOCTYPE html>\n<html>", "this is a web page"),
        ("a.ply", b"version https://git-lfs.github.com/spec/v1\noid sha256:00", "git lfs pull"),
        ("a.png", b"\x89PNG\r\n\x1a\n" + bytes(40), "it is a picture"),
    ],
)
def test_unreadable_files_are_named(tmp_path, name, data, words):
    with pytest.raises(shapes.ShapeError, match=words) as caught:
        shapes.read(write(tmp_path, name, data))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("module, name, data, package", [
    ("laspy", "a.laz", None, "pip install laspy"),
    ("pye57", "a.e57", b"ASTM-E57" + bytes(100), "pip install pye57"),
    ("rasterio", "a.tif", b"II*\0" + bytes(100), "python3-rasterio"),
    ("rasterio", "a.dem", bytes(100), "python3-rasterio"),
    ("vtk", "a.vtp", b'<?xml version="1.0"?>\n<VTKFile type="PolyData">', "python3-vtk9"),
    ("vtk", "a.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n", "python3-vtk9"),
    ("meshio", "a.vtu", b'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid">', "python3-meshio"),
])  # fmt: skip
def test_a_missing_package_is_named(tmp_path, monkeypatch, module, name, data, package):
    for missing in {module, "vtk"}:
        monkeypatch.setitem(sys.modules, missing, None)
    data = las(form=0x80) if data is None else data
    with pytest.raises(shapes.ShapeError, match=f"needs {module} .*{package}.*without it"):
        shapes.read(write(tmp_path, name, data))


def damaged(data, random):
    """Changes, removes, doubles or cuts off a few bytes."""
    data = bytearray(data)
    for _ in range(random.integers(1, 5)):
        if not data:
            break
        at, what = random.integers(len(data)), random.integers(5)
        if what == 0:
            data[at] = random.integers(256)
        elif what == 1:
            data[at] = random.choice(list(b"0123456789-. \n/"))
        elif what == 2:
            del data[at : at + random.integers(1, 40)]
        elif what == 3:
            data[at:at] = data[at : at + 30]
        else:
            data[at : at + 4] = [b"\xff\xff\xff\xff", b"\0\0\0\0", b"nan ", b"9999"][random.integers(4)]
    return bytes(data)


def whole_files():
    yield from {"a.stl": stl(True), "b.stl": stl(False), "a.las": las(), "a.asc": grid().encode()}.items()
    yield from ((f"{form}.pcd", pcd(form)) for form in ("ascii", "binary", "binary_compressed"))
    yield from ((name, TABLES[name].encode()) for name in ("cloudcompare.asc", "words.csv", "meshlab.pts"))
    yield from {"a.obj": CUBE_OBJ.encode(), "a.off": CUBE_OFF.encode()}.items()
    faces = ("face", 6, ["list uchar int vertex_index"])
    head = ply_header("ascii", ("vertex", 8, ["float x", "float y", "float z"]), faces)
    yield "a.ply", head + CUBE_OFF.split("\n", 2)[2].encode()


def test_damaged_files_are_refused_or_read(tmp_path):
    random = np.random.default_rng(1)
    refused = 0
    for name, data in whole_files():
        shapes.read(write(tmp_path, name, data))
        for _ in range(60):
            path = write(tmp_path, name, damaged(data, random))
            try:
                shape = shapes.read(path)
                if shape.is_mesh:
                    shapes.mesh_facts(shape)
            except shapes.ShapeError as error:
                refused += 1
                assert str(error) and "\n" not in str(error)
    assert refused > 150


def test_words_are_counted_across_blocks(monkeypatch):
    from hrbfnpr.shapes import _table

    random = np.random.default_rng(0)
    for _ in range(100):
        text = bytes(random.choice(list(b"12 \n. "), random.integers(0, 60)).tolist())
        monkeypatch.setattr(_table, "_BLOCK", int(random.integers(1, 9)))
        words, lines, counts = _table._words(text)
        expected = [(number, len(line.split())) for number, line in enumerate(text.split(b"\n")) if line.split()]
        assert list(zip(lines.tolist(), counts.tolist())) == expected and words == len(text.split())
