# SPDX-License-Identifier: MIT
"""Reading shapes from files of every format, and sampling them."""
import struct

import numpy as np
import pytest
from conftest import fibonacci_sphere

from hrbfnpr import shapes

# A tetrahedron with outward faces.
VERTICES = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def triangle_set(triangles):
    """Triangles as a set, each rotated so that its smallest index comes first."""
    turned = (tuple(np.roll(t, -int(np.argmin(t)))) for t in np.asarray(triangles).tolist())
    return set(turned)


def ply_header(form, *elements, newline="\n"):
    lines = ["ply", f"format {form} 1.0", "comment made by a test"]
    for name, count, properties in elements:
        lines += [f"element {name} {count}", *(f"property {p}" for p in properties)]
    return (newline.join([*lines, "end_header"]) + newline).encode()


XYZ = ["float x", "float y", "float z"]
XYZN = [*XYZ, "float nx", "float ny", "float nz"]


def write(tmp_path, name, data):
    path = tmp_path / name
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return path


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_ascii_ply_points(tmp_path, newline):
    rows = newline.join("1 2 3 0 0 1".split("|") + ["4 5 6 1 0 0", "", ""])
    data = ply_header("ascii", ("vertex", 2, XYZN), newline=newline) + rows.encode()
    shape = shapes.read(write(tmp_path, "a.ply", data))
    np.testing.assert_array_equal(shape.points, [[1, 2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(shape.normals, [[0, 0, 1], [1, 0, 0]])
    assert not shape.is_mesh


@pytest.mark.parametrize("form, order", [("binary_little_endian", "<"), ("binary_big_endian", ">")])
@pytest.mark.parametrize("code, kind", [("f", "float"), ("d", "double")])
def test_binary_ply_with_foreign_properties(tmp_path, form, order, code, kind):
    properties = ["bool red", f"{kind} x", f"{kind} y", f"{kind} z", "short label", f"{kind} nx", f"{kind} ny", f"{kind} nz"]
    data = ply_header(form, ("vertex", 4, properties), ("face", 4, ["list uchar int vertex_indices", "float quality"]))
    for v in VERTICES:
        data += struct.pack(order + "B3" + code + "h3" + code, 7, *v, -5, *(v + 1))
    for face in FACES:
        data += struct.pack(order + "B3if", 3, *face, 0.5)
    shape = shapes.read(write(tmp_path, "a.ply", data))
    np.testing.assert_array_equal(shape.points, VERTICES)
    np.testing.assert_array_equal(shape.normals, VERTICES + 1)
    assert triangle_set(shape.triangles) == triangle_set(FACES)


def test_ply_with_elements_before_and_lists_of_any_length(tmp_path):
    header = ply_header(
        "binary_little_endian",
        ("range_grid", 3, ["list uchar int vertex_indices"]),
        ("vertex", 8, XYZ),
        ("face", 3, ["int flags", "list uchar uint vertex_index"]),
    )
    data = header + struct.pack("<BBiBii", 0, 1, 5, 2, 6, 7)
    data += CUBE.astype("<f4").tobytes()
    data += struct.pack("<iB4I", 0, 4, *QUADS[0]) + struct.pack("<iB3I", 0, 3, 4, 5, 7) + struct.pack("<iB2I", 0, 2, 1, 2)
    shape = shapes.read(write(tmp_path, "a.ply", data))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert triangle_set(shape.triangles) == {(0, 2, 3), (0, 3, 1), (4, 5, 7)}


@pytest.mark.parametrize("form, data", [("ascii", b"\n\n1 2 3\n"), ("binary_little_endian", struct.pack("<3f", 1, 2, 3))])
def test_ply_with_empty_elements(tmp_path, form, data):
    for count in (3, 2**64):
        head = f"ply\nformat {form} 1.0\nelement nothing {count}\nelement vertex 1\n"
        head += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
        np.testing.assert_array_equal(shapes.read(write(tmp_path, "a.ply", head.encode() + data)).points, [[1, 2, 3]])


def test_ply_of_a_range_image_has_a_viewpoint(tmp_path):
    rows = "".join(f"{x} {y} 5\n" for x in range(4) for y in range(3))
    grid = "".join(f"1 {i}\n" if i < 12 else "0\n" for i in range(16))
    head = "ply\nformat ascii 1.0\nobj_info num_cols 4\nobj_info num_rows 4\nelement vertex 12\n"
    places = "property float x\nproperty float y\nproperty float z\n"
    grid_head = "element range_grid 16\nproperty list uchar int vertex_indices\nend_header\n"
    shape = shapes.read(write(tmp_path, "view.ply", head + places + grid_head + rows + grid))
    assert len(shape.points) == 12 and shape.triangles is None
    assert shape.viewpoint[2] > 100 and shape.viewpoint[:2] == (1.5, 1.0)
    assert shapes.read(write(tmp_path, "no.ply", head + places + "end_header\n" + rows)).viewpoint is None


def test_ply_strips(tmp_path):
    grid = np.array([[x, y, 0] for x in range(3) for y in range(2)], dtype=float)
    data = ply_header("ascii", ("vertex", 6, XYZ), ("tristrips", 1, ["list int int vertex_indices"]))
    data += "\n".join(" ".join(map(str, row)) for row in grid).encode() + b"\n8 0 2 1 3 -1 2 4 3\n"
    shape = shapes.read(write(tmp_path, "a.ply", data))
    assert triangle_set(shape.triangles) == {(0, 2, 1), (1, 2, 3), (2, 4, 3)}
    normals = shapes.samples(shape, 20)[1]
    np.testing.assert_allclose(normals, [[0, 0, 1]] * 20, atol=1e-12)


@pytest.mark.parametrize(
    "data, words",
    [
        (b"", "not a PLY"),
        (b"ply\nformat ascii 1.0\n", "not a PLY"),
        (ply_header("ascii", ("face", 0, ["float x"])), "no vertices"),
        (ply_header("ascii", ("vertex", 2, XYZ)), "ends in the middle"),
        (ply_header("ascii", ("vertex", 1, XYZ)) + b"1 2\n", r"line 9: element 'vertex' is not as declared: 2 numbers instead of 3"),
        (ply_header("ascii", ("vertex", 1, XYZ)) + b"1 2 x\n", r"line 9, column 3: 'x' is not a number"),
        (ply_header("ascii", ("vertex", 0, XYZ)), "no vertices|no points"),
        (ply_header("ascii", ("vertex", -1, XYZ)), "negative"),
        (ply_header("binary_little_endian", ("vertex", 10**9, XYZ)) + bytes(11), "ends in the middle"),
        (ply_header("binary_little_endian", ("vertex", 10**9, XYZ), ("face", 1, ["list int int vertex_indices"])) + bytes(50),
         "ends in the middle"),
        (ply_header("binary_big_endian", ("vertex", 1, XYZ), ("face", 9, ["list int int vertex_indices"]))
         + bytes(12) + b"\x7f\xff\xff\xff", "ends in the middle"),
        (ply_header("binary_big_endian", ("vertex", 1, XYZ), ("face", 1, ["list int int vertex_indices"]))
         + bytes(12) + b"\xff\xff\xff\xff", "list of -1"),
        (ply_header("ascii", ("vertex", 1, XYZ), ("face", 1, ["list int int vertex_indices"]))
         + b"0 0 0\n3 0 1 2\n", "line 12: a face names vertex 1, but there is one vertex, 0"),
        (ply_header("odd", ("vertex", 1, XYZ)), "is not valid"),
        (ply_header("ascii", ("vertex", 1, ["complex x"])), "is not valid"),
    ],
)  # fmt: skip
def test_broken_ply(tmp_path, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.ply", data))


@pytest.mark.parametrize("name", ["a.xyz", "a.pwn", "a.XYZ"])
@pytest.mark.parametrize(
    "text",
    [
        "1 2 3 0 0 1\n4 5 6 1 0 0\n",
        "# a comment\r\n1 2 3 0 0 1\r\n\r\n4 5 6 1 0 0",
        "2\n1 2 3\n4 5 6\n0 0 1\n1 0 0\n",
        "2\n1 2 3 0 0 1\n4 5 6 1 0 0\n",
        "1,2,3,0,0,1\n4, 5, 6, 1, 0, 0\n",
        "\ufeff1e0 2 3 0 0 1\n4 5 6 1 0 0\n",
    ],
)
def test_xyz_and_pwn(tmp_path, name, text):
    shape = shapes.read(write(tmp_path, name, text))
    np.testing.assert_array_equal(shape.points, [[1, 2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(shape.normals, [[0, 0, 1], [1, 0, 0]])


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "no points"),
        ("# nothing\n", "no points"),
        ("1 2 3 0 0 1\n4 5 6\n", "line 2: there are 3 numbers, but line 1 has 6"),
        ("1 2 x 0 0 1\n", "line 1, column 3: 'x' is not a number"),
        ("1 2\n", "line 1: a line holds x y z, .*; this line holds 2 numbers"),
        ("5\n", "5 points, but none follow"),
        ("-2\n1 2 3\n", "count was expected"),
    ],
)
def test_broken_xyz(tmp_path, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.xyz", text))


def test_pwn_with_a_wrong_count_is_refused(tmp_path):
    """Its count would tell which of its lines are normals."""
    with pytest.raises(shapes.ShapeError, match="says 3 points, but 4 lines of 3 numbers"):
        shapes.read(write(tmp_path, "a.pwn", "3\n1 2 3\n4 5 6\n0 0 1\n1 0 0\n"))


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
def test_ply_points_with_a_wrong_count(tmp_path, form):
    rows = b"1 2 3\n4 5 6\n7 8 9\n" if form == "ascii" else np.arange(1, 10, dtype="<f4").tobytes()
    for data in (rows, rows[:-3]):
        shape = shapes.read(write(tmp_path, "a.ply", ply_header(form, ("vertex", 4, XYZ)) + data))
        found = 3 if data == rows else 2
        np.testing.assert_array_equal(shape.points, np.arange(1, 10).reshape(3, 3)[:found])
        assert shape.notes == (f"the file says 4 points, but it has {found}: these are read",)


def test_obj(tmp_path):
    text = "# cube\nmtllib x.mtl\n" + "".join(f"v {x} {y} {z} 1.0\n" for x, y, z in CUBE) + "vt 0 0\nvn 0 0 1\n"
    text += "".join("f " + " ".join(f"{i + 1}/1/1" for i in quad) + "\n" for quad in QUADS[:5])
    text += "f " + " ".join(f"{i - 8}//1" for i in QUADS[5]) + "\r\n"
    shape = shapes.read(write(tmp_path, "a.obj", text))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert len(shape.triangles) == 12 and shape.triangles.max() == 7


def test_obj_points(tmp_path):
    shape = shapes.read(write(tmp_path, "a.obj", "v 1 2 3\nvn 0 0 1\nv 4 5 6\nvn 1 0 0\n"))
    np.testing.assert_array_equal(shape.normals, [[0, 0, 1], [1, 0, 0]])
    assert shapes.read(write(tmp_path, "b.obj", "v 1 2 3\n")).normals is None


def test_obj_lines(tmp_path):
    corners = "".join(f"v {x} {y} {z}\n" for x, y, z in [(0, 0, 0), (2, 0, 0), (2, 1, 0), (9, 9, 9)])
    shape = shapes.read(write(tmp_path, "a.obj", corners + "l 1 2/5 3\nl -2 1\n"))
    assert shape.triangles is None and "along its 2 lines" in shape.notes[0]
    points = shape.points
    assert 4000 <= len(points) <= 4004 and len(np.unique(points, axis=0)) == len(points)  # corner 3 is shared by both lines
    assert points[:, 0].max() == 2 and (points[:, 2] == 0).all()
    sides = [points[:, 1] == 0, points[:, 0] == 2, np.isclose(points[:, 0], 2 * points[:, 1])]
    assert np.logical_or.reduce(sides).all()
    for side, length in zip(sides, (2, 1, 5**0.5)):
        assert side.sum() == pytest.approx(4000 * length / (3 + 5**0.5), abs=3)
    assert shape.notes[1:] == ("vertices left out, as they are on no line: 1",)
    broken = shapes.read(write(tmp_path, "c.obj", corners + "v nan 0 0\nl 1 2 3 5\n"))
    assert np.isfinite(broken.points).all() and "a corner is not finite: 1" in broken.notes[2]
    few = shapes.read(write(tmp_path, "b.obj", 3 * corners + "l 1 2\n"))
    assert len(few.points) == 12 and "1 line left out: the file is drawn as points" in few.notes


@pytest.mark.parametrize(
    "text, words",
    [
        ("v 1 2 3\nl 1 2\n", "line 2, column 3: a line names vertex 2, but there is one vertex, 1"),
        ("v 1 2 3\nl 1 1\n", "its lines have no length"),
        ("v 1 2 3\nl 1\n", "its lines have no length"),
        ("v 1 2 3\nl a 1\n", "a line has the corner 'a'"),
        ("f 1 2 3\n", "names vertex|no points"),
        ("v 1 2\n", "line 1: a vertex needs 3 numbers, and there are 2"),
        ("v 1 2 3\nf 1 2 3\n", "line 2, column 3: a face names vertex 2, but there is one vertex, 1"),
        ("v 1 2 3\nf 1 1 x\n", "corner 'x'"),
        ("v 1 2 3\nf 1 1 -5\n", "line 2, column 4: a face names vertex -5"),
    ],
)
def test_broken_obj(tmp_path, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.obj", text))


@pytest.mark.parametrize("head", ["OFF\n8 6 12\n", "OFF 8 6 12\n", "OFF # cube\n\n8  6\t0\n", "COFF\n8 6 0\n", "\t  OFF8 6\n"])
def test_off(tmp_path, head):
    colour = " 255 0 0 255" if head.startswith("COFF") else ""
    text = head + "".join(f"{x} {y} {z}{colour}\n" for x, y, z in CUBE)
    text += "".join("4 " + " ".join(map(str, quad)) + " 0.5 0.5 0.5\n" for quad in QUADS)
    shape = shapes.read(write(tmp_path, "a.off", text))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert len(shape.triangles) == 12


def test_noff_points(tmp_path):
    shape = shapes.read(write(tmp_path, "a.off", "NOFF\n2 0 0\n1 2 3 0 0 1\n4 5 6 1 0 0\n"))
    np.testing.assert_array_equal(shape.normals, [[0, 0, 1], [1, 0, 0]])
    assert not shape.is_mesh


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "not an OFF"),
        ("OFF BINARY\n", "lacks its counts"),
        ("COFF BINARY\n" + 12 * "\0", "of the kind 'COFF'"),
        ("OFF\n", "lacks its counts"),
        ("OFF\n8 x 0\n", "count was expected"),
        ("OFF\n8 6 0\n1 2 3\n", "ends before"),
        ("OFF\n1 1 0\n1 2 3\n3 0 0\n", "fewer than its 3"),
        ("4OFF\n1 0 0\n1 2 3 4\n", "are not read"),
        ("OFF\n1 0 0\n1 2\n", "line 3: a vertex needs 3 numbers, and there are 2"),
    ],
)
def test_broken_off(tmp_path, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.off", text))


@pytest.mark.parametrize("order", "<>")
@pytest.mark.parametrize("faces", [FACES, QUADS])
@pytest.mark.parametrize("colours", [None, 0, 3])
def test_binary_off(tmp_path, order, faces, colours):
    faces = np.asarray(faces)
    corners = VERTICES if faces.shape[1] == 3 else CUBE
    behind = [] if colours is None else [colours] + colours * [0.5]
    words = [(len(face), *face.tolist()) for face in faces]
    data = struct.pack(f"{order}3i", len(corners), len(faces), 0) + np.asarray(corners, order + "f4").tobytes()
    for row in words:
        data += struct.pack(f"{order}{len(row)}i", *row)
        data += b"" if colours is None else struct.pack(f"{order}i{colours}f", *behind)
    head = b"OFF BINARY\n"
    shape = shapes.read(write(tmp_path, "a.off", head + data))
    np.testing.assert_array_equal(shape.points, np.asarray(corners, dtype=np.float32))
    assert len(shape.triangles) == (4 if faces.shape[1] == 3 else 12)
    assert shape.triangles.max() == len(corners) - 1
    for broken in (data[:-4], data[:20], data + b"\0\0\0\0"):
        with pytest.raises(shapes.ShapeError, match="is damaged"):
            shapes.read(write(tmp_path, "a.off", head + broken))
    if faces.shape[1] == 3 and colours is None:
        with pytest.raises(shapes.ShapeError, match="names vertex 9, but there are 4 vertices"):
            shapes.read(write(tmp_path, "a.off", head + data[:-4] + struct.pack(f"{order}i", 9)))


def test_binary_noff(tmp_path):
    table = np.arange(12, dtype="<f4")
    data = b"NOFF BINARY\n" + struct.pack("<3i", 2, 0, 0) + table.tobytes()
    shape = shapes.read(write(tmp_path, "a.off", data))
    np.testing.assert_array_equal(shape.normals, [[3, 4, 5], [9, 10, 11]])
    assert not shape.is_mesh


def stl(binary):
    if not binary:
        lines = ["solid cube"]
        for face in FACES:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += [f"vertex {x} {y} {z}" for x, y, z in VERTICES[face]] + ["endloop", "endfacet"]
        return "\n".join([*lines, "endsolid cube", ""]).encode()
    data = b"solid but binary".ljust(80) + struct.pack("<I", 4)
    return data + b"".join(struct.pack("<12fH", 0, 0, 0, *VERTICES[face].ravel(), 0) for face in FACES)


@pytest.mark.parametrize("binary", [False, True])
def test_stl(tmp_path, binary):
    pytest.importorskip("meshio")
    shape = shapes.read(write(tmp_path, "a.stl", stl(binary)))
    assert len(shape.triangles) == 4
    points, normals = shapes.samples(shape, 300)
    on_slope = np.abs(points.sum(axis=1) - 1) < 1e-6
    assert 80 < on_slope.sum() < 180
    np.testing.assert_allclose(normals[on_slope], np.full((on_slope.sum(), 3), 3**-0.5), atol=1e-6)


def test_stl_with_comments(tmp_path):
    text = b"# by hand\n" + stl(False).replace(b"\n", b" # vertex\n").replace(b"facet normal", b"# facet\n facet normal")
    shape = shapes.read(write(tmp_path, "a.stl", text))
    assert shape.format == "STL, ascii" and len(shape.triangles) == 4


@pytest.mark.parametrize("name, data", [("a.stl", b"solid"), ("a.stl", b""), ("a.vtk", b"x"), ("a.nothing", b""), ("a", b"")])
def test_files_that_meshio_cannot_read(tmp_path, name, data, capfd):
    pytest.importorskip("meshio")
    with pytest.raises(shapes.ShapeError):
        shapes.read(write(tmp_path, name, data))
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("name", ["a.ply", "a.xyz", "a.stl", "a.nothing"])
def test_no_such_file(tmp_path, name):
    with pytest.raises(FileNotFoundError):
        shapes.read(tmp_path / name)


# --- sampling ----------------------------------------------------------------------------------


def ball_mesh():
    from scipy.spatial import ConvexHull

    points = fibonacci_sphere(500)
    triangles = ConvexHull(points).simplices
    a, b, c = (points[triangles[:, i]] for i in range(3))
    turned = np.einsum("ij,ij->i", a, np.cross(b, c)) < 0
    triangles[turned] = triangles[turned][:, ::-1]
    return points, triangles.astype(np.int64)


def test_samples_of_a_mesh():
    pytest.importorskip("scipy")
    points, normals = shapes.samples(shapes.Shape(*ball_mesh()[:1], triangles=ball_mesh()[1]), 200)
    assert points.shape == normals.shape == (200, 3)
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1, atol=0.02)
    np.testing.assert_allclose(normals, points, atol=0.05)
    distance = np.linalg.norm(points[:, None] - points[None], axis=-1) + 9 * np.eye(200)
    nearest = distance.min(axis=1)
    assert nearest.min() > 0.75 * np.median(nearest)  # well spread
    again = shapes.samples(shapes.Shape(*ball_mesh()[:1], triangles=ball_mesh()[1]), 200)
    np.testing.assert_array_equal(points, again[0])


def test_a_mesh_inside_out_is_turned():
    inside_out = shapes.Shape(VERTICES, triangles=np.array(FACES)[:, ::-1])
    points, normals = shapes.samples(inside_out, 100)
    assert (np.einsum("ij,ij->i", normals, points - 0.25) > 0).all()
    turned = shapes.samples(inside_out, 100, flip=True)[1]
    np.testing.assert_array_equal(turned, -normals)
    # An open mesh is not turned: either side may be its outside.
    open_sheet = shapes.Shape(VERTICES, triangles=np.array([[0, 1, 2]]))
    np.testing.assert_allclose(shapes.samples(open_sheet, 5)[1], [[0, 0, 1]] * 5)


def test_creases():
    cube = shapes.Shape(CUBE, triangles=shapes._polygons.fans(QUADS))
    sharp = np.abs(shapes.samples(cube, 200)[1]).max(axis=1)
    np.testing.assert_allclose(sharp, 1)
    round_ = np.abs(shapes.samples(cube, 200, crease=180)[1]).max(axis=1)
    assert round_.min() < 0.8


def test_unused_and_degenerate_parts_are_ignored():
    vertices = np.vstack([VERTICES, VERTICES, [[9, 9, 9], [np.nan] * 3]])
    faces = np.array([*FACES[:2], [4, 7, 6], [5, 6, 7], [1, 1, 2], [0, 4, 1]])
    points, normals = shapes.samples(shapes.Shape(vertices, triangles=faces), 100)
    assert points.max() <= 1 and np.isfinite(normals).all()
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1)
    with pytest.raises(shapes.ShapeError, match="none has an area"):
        shapes.samples(shapes.Shape(VERTICES, triangles=np.array([[0, 0, 1]])), 10)
    with pytest.raises(shapes.ShapeError, match="must be finite"):
        shapes.samples(shapes.Shape(vertices, triangles=np.array([[0, 1, 9]])), 10)


def test_samples_of_points():
    points = fibonacci_sphere(3000) * 5
    shape = shapes.Shape(points, points)
    every, normals = shapes.samples(shape)
    np.testing.assert_array_equal(every, points)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1)
    few = shapes.samples(shape, 50)[0]
    assert len(few) == 50 and len(np.unique(few, axis=0)) == 50
    assert len(shapes.samples(shape, 5000)[0]) == 3000


def test_unusable_points_are_left_out():
    points = fibonacci_sphere(10)
    bad, normals = points.copy(), points.copy()
    bad[2, 1] = np.nan
    normals[5] = 0
    normals[7] = np.inf
    assert len(shapes.samples(shapes.Shape(bad, normals))[0]) == 7
    with pytest.raises(shapes.ShapeError, match="no point"):
        shapes.samples(shapes.Shape(points, np.zeros((10, 3))))
    with pytest.raises(shapes.ShapeError, match="no normals"):
        shapes.samples(shapes.Shape(points))
    with pytest.raises(shapes.ShapeError, match="at least 1"):
        shapes.samples(shapes.Shape(points, points), 0)


def test_progress_of_sampling():
    seen = []
    shapes.samples(shapes.Shape(VERTICES, triangles=np.array(FACES)), 100, report=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1.0
