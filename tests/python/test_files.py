# SPDX-License-Identifier: MIT
"""Files of every format, in the dialects that programs write."""
import gzip
import sys
from pathlib import Path

import numpy as np
import pytest
from test_scans import COLOURS, NORMALS, POINTS, grid, is_right, las, lines, pcd
from test_shapes import CUBE, QUADS, ply_header, stl, write

from hrbfnpr import shapes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
from reader_files import amf, mf3, mf3_model  # noqa: E402

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
        ("a.xyz", "1 2 " + 300 * "x" + "\n", r"column 3: '" + 37 * "x" + r"\.\.\.' is not"),
        ("a.xyz", "lon lat\n1 2\n", "line 1, column 1: 'lon' is not a number"),
    ],
)
def test_broken_tables(tmp_path, name, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, name, text))


@pytest.mark.parametrize(
    "text, points, notes",
    [
        ("3\n1 2 3\n4 5 6\n", 2, ["the file says 3 points, but it has 2: these are read"]),
        ("1\n1 2 3\n4 5 6\n7 8 9\n", 3, ["the file says 1 points, but it has 3: these are read"]),
        ("2\n1 2 3\n4 5 6\n5\n7 8 9\n", 3, ["the file says 7 points, but it has 3: these are read"]),
        ("3\n1 2 3\n4 5 6\n7 8", 2, ["the file ends within its last line, which is left out",
                                    "the file says 3 points, but it has 2: these are read"]),
        ("1 2 3\n4 5 6\n7", 2, ["the file ends within its last line, which is left out"]),
        ("x,y,z,name\n1,2,3,one\n4,5,6,two\n7,8", 2, ["the file ends within its last line, which is left out"]),
    ],
)  # fmt: skip
def test_tables_with_a_wrong_count(tmp_path, text, points, notes):
    shape = shapes.read(write(tmp_path, "a.pts", text))
    np.testing.assert_array_equal(shape.points, np.arange(1, 3 * points + 1).reshape(-1, 3))
    assert shape.notes == tuple(notes)


LASER = np.column_stack([GREY + 100, GREY / 10, POINTS])  # the number of a shot, its time, and its place


@pytest.mark.parametrize(
    "heading",
    [
        "# shot time x y z",
        "// shot;time;x;y;z",
        "%shot\ttime\tX\tY\tZ",
        "; SHOT, TIME, EASTING, NORTHING, ELEVATION",
        "# Columns: shot time x y z",
        "# shot_number time_s x_m y_m z_m",
        "# shot time x (m) y (m) z (m)",
        "# made by a test\n# shot time E N H\n# of a laser",
        "# 1: shot\n# 2: time [s]\n# 3: x [m]\n# 4: y [m]\n# 5: z [m]",
        "# column 0 = shot\n# column 1 = time\n# column 2 = East\n# column 3 = North\n# column 4 = ellipsoidal height",
        "shot time Eastings Northings Height",
        "# shot, time, GPS East, GPS North, Orthometric Height (m)",
    ],
)
def test_names_in_comments(tmp_path, heading):
    shape = shapes.read(write(tmp_path, "a.txt", f"{heading}\n{lines(LASER)}"))
    assert is_right(shape, normals=False) and shape.columns[2:] == ("x", "y", "z") and shape.notes == ()
    assert shape.up == ((0, 0, 1) if "ast" in heading.lower() or " E N " in heading else None)


def test_names_in_comments_need_a_column_each(tmp_path):
    shape = shapes.read(write(tmp_path, "a.txt", "# x y z of shots\n# shot at x y z w u\n" + lines(POINTS)))
    assert is_right(shape, normals=False)


def test_coordinates_of_the_map_come_before_degrees(tmp_path):
    text = "lat,lon,height,Easting,Northing,H_ortho\n" + lines(0 * POINTS[:, :2], POINTS[:, 2:], POINTS, mark=",")
    shape = shapes.read(write(tmp_path, "a.csv", text))
    assert is_right(shape, normals=False) and shape.notes == ()


ODD = {"1.#IND": np.nan, "-1.#IND00": np.nan, "1.#QNAN": np.nan, "-1.#INF": -np.inf, "1.#INF00": np.inf, "nan(ind)": np.nan,
       "-nan(ind)": np.nan, "nan(snan)": np.nan, "-nan": np.nan, "1.#J": np.nan}  # fmt: skip


@pytest.mark.parametrize("word", ODD)
def test_numbers_of_other_languages_that_are_not_finite(tmp_path, word):
    xyz = "property float x\nproperty float y\nproperty float z\nend_header\n"
    files = {
        "a.obj": f"v 1 2 {word}\nv 0 1 0\nv 1 0 0\nf 1 2 3\n",
        "a.xyz": f"1 2 {word}\n0 1 0\n",
        "a.csv": f"x,y,z\n1,2,{word}\n0,1,0\n",
        "a.off": f"OFF\n3 1 0\n1 2 {word}\n0 1 0\n1 0 0\n3 0 1 2\n",
        "a.stl": f"solid a\nfacet normal 0 0 {word}\nouter loop\nvertex 1 2 {word}\nvertex 0 1 0\nvertex 1 0 0\nendloop\n"
        "endfacet\nendsolid a\n",
        "a.ply": f"ply\nformat ascii 1.0\nelement vertex 2\n{xyz}1 2 {word}\n0 1 0\n",
        "a.pcd": f"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n1 2 {word}\n0 1 0\n",
        "a.asc": f"ncols 2\nnrows 3\ncellsize 1\n{word} 1\n2 3\n4 5\n",
    }
    for name, text in files.items():
        points = shapes.read(write(tmp_path, name, text)).points
        if name == "a.asc":
            assert len(points) == 5
        else:
            np.testing.assert_array_equal(points[:2], [[1, 2, ODD[word]], [0, 1, 0]], name)
    for name, data in (("a.3mf", mf3(mf3_model().replace('x="0"', f'x="{word}"', 1))),
                       ("a.amf", amf().replace(b"<x>0<", f"<x>{word}<".encode(), 1))):  # fmt: skip
        assert (~np.isfinite(shapes.read(write(tmp_path, name, data)).points)).any(), name
    shape = shapes.read(write(tmp_path, "no_ending", f"{word} 2 3\n4 5 6\n7 8 9\n"))
    assert shape.format == "text" and len(shape.points) == 3


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
ZEROS = {"begin": b"\0\0" + CUBE_OBJ.encode(), "lines": CUBE_OBJ.replace("\n", "\0\n").encode(), "end": CUBE_OBJ.encode() + bytes(9),
         "words": CUBE_OBJ.replace(" ", "\0 ").encode(), "wide": CUBE_OBJ.encode("utf-16-le"), "big": CUBE_OBJ.encode("utf-16-be")}  # fmt: skip


@pytest.mark.parametrize("where", ZEROS)
def test_zero_bytes_in_text_are_spaces(tmp_path, where):
    shape = shapes.read(write(tmp_path, "a.obj", ZEROS[where]))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert len(shape.triangles) == 12


OFF_CORNERS = [" ".join(map(str, corner)) for corner in CUBE]
OFF_QUADS = [" ".join(map(str, (4, *quad))) for quad in QUADS]
STREAMS = {
    "one line": "OFF 8 6 12 " + " ".join(OFF_CORNERS + OFF_QUADS),
    "a word a line": "OFF\n" + "\n".join(" ".join(["8", "6", "12", *OFF_CORNERS, *OFF_QUADS]).split()),
    "faces over lines": "OFF\n8 6 12\n" + "\n".join(OFF_CORNERS) + "\n" + "\n".join(OFF_QUADS).replace(" ", "\n", 1).replace(" 3", "\n3"),
    "two faces a line": "OFF\n8 6 12\n" + "\n".join(OFF_CORNERS) + "\n" + "\n".join(OFF_QUADS[:3]) + " " + " ".join(OFF_QUADS[3:]) + "\n",
    "corners over lines": "OFF\n8 6 12\n" + "\n".join(OFF_CORNERS).replace(" ", "\n") + "\n" + "\n".join(OFF_QUADS),
    "colours": "OFF\n8 6 12\n" + "\n".join(OFF_CORNERS) + "\n" + "".join(q.replace(" ", "\n", 2) + " 255 0 7\n" for q in OFF_QUADS),
    "coloured corners": "COFF\n8 6 12\n" + "".join(f"{c}\n1 0 0 1\n" for c in OFF_CORNERS) + "\n".join(OFF_QUADS),
}  # fmt: skip


@pytest.mark.parametrize("name", STREAMS)
def test_off_is_a_stream_of_numbers(tmp_path, name):
    shape = shapes.read(write(tmp_path, "a.off", STREAMS[name]))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert len(shape.triangles) == 12 and shapes.mesh_facts(shape).closed


@pytest.mark.parametrize("text", [STREAMS["faces over lines"][:-1], STREAMS["one line"] + " 7", STREAMS["one line"].replace("4 ", "4.5 ", 1)])
def test_broken_streams_are_refused(tmp_path, text):
    with pytest.raises(shapes.ShapeError):
        shapes.read(write(tmp_path, "a.off", text))


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
