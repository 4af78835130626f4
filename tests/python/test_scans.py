# SPDX-License-Identifier: MIT
"""Files of scanners, height maps and VTK."""
import gzip
import struct
import sys
import types

import numpy as np
import pytest
from conftest import fibonacci_sphere
from test_shapes import CUBE, QUADS, VERTICES, write

from hrbfnpr import shapes
from hrbfnpr.shapes import _vtk

POINTS = fibonacci_sphere(60) * [1.0, 0.7, 1.3] + 5
NORMALS = fibonacci_sphere(60)
COLOURS = np.random.default_rng(1).integers(0, 256, (60, 3))


def lines(*columns, mark=" ", form="{:.6f}"):
    """A table of columns. Columns of integers are written without a decimal point."""
    table = [column.reshape(60, -1) for column in columns]
    rows = zip(*(part.tolist() for part in table))
    return "".join(
        mark.join(str(x) if isinstance(x, int) else form.format(x) for part in row for x in part) + "\n" for row in rows
    )


def is_right(shape, normals=True):
    np.testing.assert_allclose(shape.points, POINTS, atol=1e-5)
    if normals:
        np.testing.assert_allclose(shape.normals, NORMALS, atol=1e-5)
    else:
        assert shape.normals is None
    return True


# --- PCD ---------------------------------------------------------------------------------------


def lzf(data):
    """A simple LZF encoder: literal runs, and copies of five or more equal bytes."""
    out, i, run = b"", 0, b""
    while i < len(data):
        same = 1
        while i + same < len(data) and data[i + same] == data[i] and same < 200:
            same += 1
        if same >= 5:
            run += data[i : i + 1]
            out += b"".join(bytes([len(run[k : k + 32]) - 1]) + run[k : k + 32] for k in range(0, len(run), 32))
            run, length = b"", same - 1 - 2
            out += bytes([7 << 5, length - 7, 0]) if length >= 7 else bytes([length << 5, 0])
            i += same
        else:
            run += data[i : i + 1]
            i += 1
    return out + b"".join(bytes([len(run[k : k + 32]) - 1]) + run[k : k + 32] for k in range(0, len(run), 32))


def pcd(form):
    head = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb normal_x normal_y normal_z\n"
    head += "SIZE 4 4 4 4 4 4 4\nTYPE F F F U F F F\nCOUNT 1 1 1 1 1 1 1\nWIDTH 60\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
    head = (head + f"POINTS 60\nDATA {form}\n").encode()
    if form == "ascii":
        return head + lines(POINTS, np.zeros(60, int), NORMALS).encode()
    table = np.zeros(60, dtype=[("p", "<f4", 3), ("rgb", "<u4"), ("n", "<f4", 3)])
    table["p"], table["n"] = POINTS, NORMALS
    if form == "binary":
        return head + table.tobytes()
    fields = [table["p"][:, i] for i in range(3)] + [table["rgb"]] + [table["n"][:, i] for i in range(3)]
    raw = b"".join(field.tobytes() for field in fields)
    packed = lzf(raw)
    assert len(packed) < len(raw)
    return head + struct.pack("<II", len(packed), len(raw)) + packed


def pcd_picture(upward=1.0, looks=1.0, holes=True):
    """40 x 30 pixels of a ball before a wall, seen by a camera at the origin along +z (looks = 1) or -z (looks = -1)."""
    row, column = np.indices((30, 40)).reshape(2, -1)
    x, y = (column - 19.5) / 35, -upward * (row - 14.5) / 35
    ray = np.column_stack([x, y, np.ones(1200)])
    along, middle = np.sum(ray * ray, axis=1), ray @ [0.1, 0.0, 2.0]
    inside = middle**2 - along * (0.1**2 + 2.0**2 - 0.5**2)
    depth = np.where(inside > 0, (middle - np.sqrt(np.maximum(inside, 0))) / along, 3.0)
    points = ray * depth[:, None] * [1, 1, looks]
    if holes:
        points[::17] = np.nan
    head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 40\nHEIGHT 30\nVIEWPOINT 0 0 0 0 1 0 0\n"
    rows = "".join("{:.6f} {:.6f} {:.6f}\n".format(*point) for point in points.tolist())
    return (head + "POINTS 1200\nDATA ascii\n" + rows).encode()


def test_lzf_data_is_decoded():
    from hrbfnpr.shapes._pcd import _unpack

    assert _unpack(bytes([2]) + b"abc" + bytes([7 << 5, 0, 2]), 12) == 4 * b"abc"
    assert _unpack(bytes([3]) + b"abcd" + bytes([1 << 5, 3, 2 << 5, 1]), 11) == b"abcdabcbcbc"
    far = bytes(range(32)) * 20
    packed = b"".join(bytes([31]) + far[k : k + 32] for k in range(0, len(far), 32))
    assert _unpack(packed + bytes([(1 << 5) + 1, 255]), len(far) + 3) == far + far[-512:-509]
    for broken in (bytes([0]) + b"a" + bytes([1 << 5, 1]), bytes([3]) + b"abcd" + bytes([7 << 5])):
        with pytest.raises(shapes.ShapeError, match="damaged"):
            _unpack(broken, 7)


@pytest.mark.parametrize("form", ["ascii", "binary", "binary_compressed"])
def test_pcd(tmp_path, form):
    assert is_right(shapes.read(write(tmp_path, "a.pcd", pcd(form))))


def test_pictures_of_depth_cameras(tmp_path):
    for upward in (1.0, -1.0):
        for looks in (1.0, -1.0):
            shape = shapes.read(write(tmp_path, "a.pcd", pcd_picture(upward, looks)))
            assert shape.is_picture and shape.up == (0.0, upward, 0.0) and shape.viewpoint == (0.0, 0.0, 0.0)
    data = pcd_picture(holes=False)
    for other in (
        data.replace(b"WIDTH 40\nHEIGHT 30", b"WIDTH 1200\nHEIGHT 1"),
        data.replace(b"WIDTH 40\nHEIGHT 30", b"WIDTH 30\nHEIGHT 40"),
        data.replace(b"FIELDS x y z", b"FIELDS z x y"),  # the camera looks along y
        data.replace(b"WIDTH 40\n", b"WIDTH\n"),
        data[: data.index(b"ascii\n") + 6] + 1200 * b"0 0 1\n",
        data[: data.index(b"ascii\n") + 6] + 1200 * b"1e30 2 1e-300\n",
    ):
        shape = shapes.read(write(tmp_path, "a.pcd", other))
        assert not shape.is_picture and shape.up is None and shape.viewpoint is None


@pytest.mark.parametrize(
    "data, words",
    [
        (pcd("ascii").replace(b"\n5.065884 ", b"\n", 1), "line 12: 6 numbers, where the header has 7"),
        (pcd("binary_compressed")[:-300], "ends in the middle"),
        (pcd("ascii").replace(b"FIELDS x y z", b"FIELDS a b c"), "no x, y and z"),
        (pcd("ascii").replace(b"DATA ascii", b"DATA odd"), "'odd' are not read"),
        (pcd("ascii").replace(b"SIZE", b"SIZES"), "lacks SIZE"),
        (b"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\n", "no DATA line"),
    ],
)
def test_broken_pcd(tmp_path, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.pcd", data))


@pytest.mark.parametrize("form", ["ascii", "binary", "binary_compressed"])
def test_pcd_with_a_wrong_count(tmp_path, form):
    for said in (59, 61, 4000):
        data = pcd(form).replace(b"POINTS 60", f"POINTS {said}".encode())
        shape = shapes.read(write(tmp_path, "a.pcd", data))
        assert is_right(shape) and shape.notes == (f"the file says {said} points, but it has 60: these are read",)
    if form == "binary_compressed":
        return
    shape = shapes.read(write(tmp_path, "a.pcd", pcd(form)[: -5 if form == "binary" else -12]))
    np.testing.assert_allclose(shape.points, POINTS[:59], atol=1e-5)
    assert shape.notes == ("the file says 60 points, but it has 59: these are read",)
    padded = pcd(form) + (bytes(56) if form == "binary" else b"\n \n")
    assert is_right(shapes.read(write(tmp_path, "b.pcd", padded)))


def test_pcd_with_names_in_upper_case(tmp_path):
    data = pcd("ascii").replace(b"FIELDS x y z rgb normal_x normal_y normal_z", b"FIELDS X Y Z RGB Normal_X NORMAL_Y normal_z")
    shape = shapes.read(write(tmp_path, "a.pcd", data.replace(b"TYPE F F F U", b"TYPE f f F u")))
    assert is_right(shape) and "rgb" in shape.fields


# --- scanners and heights ----------------------------------------------------------------------


def las(version=2, form=0, count=60, points=POINTS, scale=0.001, records=(), flags=None, classes=None):
    """A LAS file. `records` are pairs of an identifier and the data of a coordinate system; flags and classes are bytes."""
    size = 30 if form == 6 else 20
    more = b"".join(struct.pack("<H16sHH32s", 0, b"LASF_Projection", i, len(data), b"") + data for i, data in records)
    head = bytearray(375 if version == 4 else 227)
    head[:4], head[24], head[25] = b"LASF", 1, version
    struct.pack_into("<HIIBHI", head, 94, len(head), len(head) + len(more), len(records), form, size, 0 if version == 4 else count)
    shift = np.floor(points[0]) - 1
    struct.pack_into("<6d", head, 131, *np.broadcast_to(scale, 3), *shift)
    if version == 4:
        struct.pack_into("<Q", head, 247, count)
    table = np.zeros((len(points), size), np.uint8)
    table[:, :12] = np.round((points - shift) / scale).astype("<i4").view(np.uint8).reshape(-1, 12)
    if flags is not None:
        table[:, 15] = flags
    if classes is not None:
        table[:, 16] = classes
    return bytes(head) + more + table.tobytes()


@pytest.mark.parametrize("version", [2, 4])
def test_las(tmp_path, version):
    shape = shapes.read(write(tmp_path, "a.las", las(version)))
    np.testing.assert_allclose(shape.points, POINTS, atol=6e-4)
    assert shape.up == (0, 0, 1) and shape.format == "LAS"


def test_broken_las(tmp_path, monkeypatch):
    cases = ((las()[:227], "no points"), (las()[:100], "header is cut short"), (las(count=0)[:227], "no points"))
    for data, words in cases:
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.las", data))
    monkeypatch.setattr("hrbfnpr.shapes._scans.MOST_POINTS", 20)
    shape = shapes.read(write(tmp_path, "a.las", las()))
    assert len(shape.points) == 20 and shape.notes == ("20 of its 60 points are read",)


@pytest.mark.parametrize("version", [2, 4])
def test_las_with_a_wrong_count(tmp_path, version):
    for said, data in ((60, las(version)[:-5]), (0, las(version, count=0)), (59, las(version, count=59)), (61, las(version, count=61))):
        shape = shapes.read(write(tmp_path, "a.las", data))
        found = 59 if said == 60 else 60
        np.testing.assert_allclose(shape.points, POINTS[:found], atol=6e-4)
        assert shape.notes == (f"the file says {said} points, but it has {found}: these are read",)
    padded = shapes.read(write(tmp_path, "b.las", las(version) + bytes(40)))
    assert len(padded.points) == 60 and padded.notes == ()


# Longitude, latitude and height of a hill, and the same in metres from its middle.
DEGREES = np.column_stack([10 + 0.005 * NORMALS[:, 0], 47 + 0.005 * NORMALS[:, 1], 500 + 25 * NORMALS[:, 2]])
METRES = (DEGREES - [(DEGREES[:, 0].min() + DEGREES[:, 0].max()) / 2, (DEGREES[:, 1].min() + DEGREES[:, 1].max()) / 2, 0]) * [
    111_320 * np.cos(np.radians(47)), 111_320, 1]  # fmt: skip
GEOGRAPHIC, PROJECTED = b'GEOGCS["WGS 84",DATUM["x"]]\0', b'PROJCS["UTM 32",GEOGCS["WGS 84"]]\0'


def keys(model):
    """The keys of a GeoTIFF: two keys, the first of which is of the kind of model."""
    return struct.pack("<12H", 1, 1, 0, 2, 1024, 0, 1, model, 2054, 0, 1, 9102)


def are_metres(shape):
    np.testing.assert_allclose(shape.points, METRES, atol=0.3)
    assert shape.up == (0, 0, 1) and shape.notes == ("degrees are converted to metres, the unit of the heights",)
    return True


def test_las_in_degrees(tmp_path):
    hill = {"points": DEGREES, "scale": (1e-7, 1e-7, 0.01)}
    assert are_metres(shapes.read(write(tmp_path, "a.las", las(**hill))))
    flat = {**hill, "points": DEGREES * [1, 1, 0.0001]}  # the numbers alone say nothing of degrees
    assert shapes.read(write(tmp_path, "a.las", las(**flat))).notes == ()
    for records in ([(2112, GEOGRAPHIC)], [(34735, keys(2))], [(7, b"no system"), (2112, GEOGRAPHIC)]):
        shape = shapes.read(write(tmp_path, "a.las", las(**flat, records=records)))
        np.testing.assert_allclose(shape.points[:, :2], METRES[:, :2], atol=0.3)
    for records in ([(2112, PROJECTED)], [(34735, keys(1))], [(34735, keys(3))]):
        shape = shapes.read(write(tmp_path, "a.las", las(**hill, records=records)))
        np.testing.assert_allclose(shape.points, DEGREES, atol=0.01)
    (tmp_path / "b.prj").write_bytes(PROJECTED)
    assert shapes.read(write(tmp_path, "b.las", las(**hill))).notes == ()
    assert len(shapes.read(write(tmp_path, "b.las", las(**hill, records=[(2112, GEOGRAPHIC)]))).notes) == 1  # its own is first


@pytest.mark.parametrize("heading", ["", "lon,lat,height", "Longitude,Latitude,Elevation (m)", '"LON","LAT","Z"', "lng,lat,alt_m",
                                     "GLON,GLAT,ZG", "LONGITUDE_LOW,LATITUDE_LOW,ELEVATION_LOW", "x_deg,y_deg,h"])  # fmt: skip
def test_text_in_degrees(tmp_path, heading):
    text = lines(DEGREES, mark=",", form="{:.9f}")
    assert are_metres(shapes.read(write(tmp_path, "a.csv", f"{heading}\n{text}" if heading else text)))
    assert are_metres(shapes.read(write(tmp_path, "a.txt", (f"# {heading}\n" if heading else "") + text)))
    swapped = lines(DEGREES[:, [1, 0, 2]], mark=";", form="{:.9f}")
    if heading.startswith(("lon", "Lon")):
        names = heading.split(",")
        shape = shapes.read(write(tmp_path, "a.csv", f"{names[1]};{names[0]};{names[2]}\n{swapped}"))
        assert are_metres(shape) and shape.columns == ("y", "x", "z")


@pytest.mark.parametrize("points", [
    DEGREES - [10, 47, 0],  # around 0, 0
    DEGREES * [1, 2, 1],  # no latitude
    np.column_stack([30 + NORMALS[:, 0], 40 + NORMALS[:, 1], 20 * NORMALS[:, 2]]),  # a slim column
], ids=["local", "no latitude", "column"])  # fmt: skip
def test_lengths_are_not_taken_for_degrees(tmp_path, points):
    shape = shapes.read(write(tmp_path, "a.xyz", lines(points, form="{:.9f}")))
    np.testing.assert_allclose(shape.points, points, atol=1e-6)
    assert shape.notes == () and shape.up is None


@pytest.mark.parametrize("form", [0, 6])
def test_classes_of_las(tmp_path, form):
    number = np.repeat([2, 3, 5, 6, 7, 9], 10)
    withheld = np.arange(60) % 10 == 0
    byte = {"flags": withheld * 128 + number} if form == 0 else {"flags": withheld * 4, "classes": number}
    path = write(tmp_path, "a.las", las(4, form, **byte))
    read = {(): [2, 3, 5, 6, 7, 9], (2, 6): [2, 6], (7,): [7], None: [2, 9]}
    for wanted, kept in read.items():
        shape = shapes.read(path, wanted)
        np.testing.assert_allclose(shape.points, POINTS[np.isin(number, kept) & ~withheld], atol=6e-4)
        assert shape.notes[0] == "6 withheld points left out" and len(shape.notes) == (3 if wanted is None else 2 if wanted else 1)
    assert "only the ground is read, 18 of 45 points" in shapes.read(path).notes[2]
    with pytest.raises(shapes.ShapeError, match="the file has the classes 2, 3, 5, 6, 7, 9"):
        shapes.read(path, [1])
    bare = np.where(number == 2, 1, number)  # without ground, all but the noise is read
    byte = {"flags": bare} if form == 0 else {"classes": bare}
    shape = shapes.read(write(tmp_path, "b.las", las(4, form, **byte)))
    assert len(shape.points) == 50 and len(shape.notes) == 1
    with pytest.raises(shapes.ShapeError, match="classes are of the points of LAS and LAZ"):
        shapes.read(write(tmp_path, "a.xyz", lines(POINTS)), [2])


class Laspy:
    """A stand-in for laspy: two chunks of the points."""

    number = np.repeat([2, 3, 5, 6, 7, 9], 10)
    names = ("X", "intensity", "classification", "withheld")

    def __init__(self, path):
        self.header = types.SimpleNamespace(point_count=60, point_format=types.SimpleNamespace(dimension_names=self.names))

    def __enter__(self):
        return self

    def __exit__(self, *error):
        pass

    def chunk_iterator(self, size):
        for part in (slice(0, 25), slice(25, 60)):
            class Chunk(dict):
                x, y, z = POINTS[part].T

            yield Chunk(intensity=np.arange(60)[part], classification=self.number[part], withheld=np.arange(60)[part] % 10 == 0)


def test_laz_by_its_package(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "laspy", types.SimpleNamespace(open=Laspy))
    path = write(tmp_path, "a.laz", las(4, 0x86))
    shape = shapes.read(path)
    kept = np.isin(Laspy.number, [2, 9]) & (np.arange(60) % 10 > 0)
    np.testing.assert_allclose(shape.points, POINTS[kept])
    np.testing.assert_array_equal(shape.fields["intensity"].values, np.flatnonzero(kept))
    assert "only the ground is read, 18 of 45 points" in shape.notes[2] and shape.format == "LAZ"
    assert len(shapes.read(path, [6]).points) == 9 and len(shapes.read(path, []).points) == 54
    monkeypatch.setattr(Laspy, "names", ("X", "intensity"))  # no classes
    assert len(shapes.read(path).points) == 60
    degrees = shapes.read(write(tmp_path, "b.laz", las(4, 0x86, records=[(2112, GEOGRAPHIC)])))
    np.testing.assert_allclose(np.ptp(degrees.points[:, 1]), 111_320 * np.ptp(POINTS[:, 1]))


class E57:
    """A stand-in for the class of pye57, which reads no normals: two scans.

    The second scan is turned and has an invalid point.
    """

    scan_count = 2
    image_file = None
    with_normals = (True, True)
    TURN = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    closed = 0

    def __init__(self, path):
        self.fields = [
            {f"nor:normal{axis}": NORMALS[:30, i] for i, axis in enumerate("XYZ")},
            {f"nor:normal{axis}": np.append((NORMALS[30:] @ self.TURN)[:, i], 9) for i, axis in enumerate("XYZ")},
        ]
        self.fields[1]["cartesianInvalidState"] = np.append(np.zeros(30), 2)

    def close(self):
        E57.closed += 1

    def read_scan(self, number, **options):
        part = slice(None, 30) if number == 0 else slice(30, None)
        data = {f"cartesian{axis}": POINTS[part, i] for i, axis in enumerate("XYZ")}
        if options["colors"] and number == 0:
            data.update({f"color{ink}": COLOURS[part, i].astype(np.uint8) for i, ink in enumerate(("Red", "Green", "Blue"))})
        return {**data, "intensity": COLOURS[part, 0] / 256} if options["intensity"] else data

    def get_header(self, number):
        fields = self.fields[number] if self.with_normals[number] else {}

        def fill(buffers):
            for name, column in buffers:
                column[:] = fields[name]

        return types.SimpleNamespace(
            point_fields=list(fields),
            point_count=30 + number,
            rotation_matrix=self.TURN if number else np.eye(3),
            points=types.SimpleNamespace(reader=lambda buffers: types.SimpleNamespace(read=lambda: fill(buffers))),
        )


def pye57_stand_in():
    buffer = lambda file, name, column, count, convert, scale: (name, column)  # noqa: E731
    return types.SimpleNamespace(
        E57=E57, libe57=types.SimpleNamespace(VectorSourceDestBuffer=list, SourceDestBuffer=buffer)
    )


def test_e57_by_its_package(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pye57", pye57_stand_in())
    path = write(tmp_path, "a.e57", b"ASTM-E57" + bytes(100))
    before = E57.closed
    whole = shapes.read(path)
    assert is_right(whole) and E57.closed == before + 1
    np.testing.assert_array_equal(whole.fields["intensity"].values, COLOURS[:, 0] / 256)
    np.testing.assert_allclose(whole.fields["rgb"].values[:30], COLOURS[:30] / 255, rtol=1e-6)
    assert np.isnan(whole.fields["rgb"].values[30:]).all()  # the second scan has no colours
    monkeypatch.setattr(E57, "with_normals", (True, False))
    mixed = shapes.read(path)
    assert is_right(mixed, normals=False) and mixed.notes == ("only 1 of its 2 scans have normals: these are not used",)
    monkeypatch.setattr(E57, "scan_count", 0)
    with pytest.raises(shapes.ShapeError, match="no points"):
        shapes.read(path)


HEIGHTS = np.round(100 + 10 * np.add.outer(np.arange(5), np.arange(4)) ** 0.5, 3)


def grid(head="xllcorner 1000\nyllcorner 2000\ncellsize 5\n"):
    return f"ncols 4\nnrows 5\n{head}NODATA_value -9999\n" + "\n".join(" ".join(map(str, row)) for row in HEIGHTS)


@pytest.mark.parametrize("name", ["a.asc", "a.grd", "a.txt"])
def test_esri_grids(tmp_path, name):
    shape = shapes.read(write(tmp_path, name, grid()))
    assert shape.up == (0, 0, 1) and len(shape.triangles) == 2 * 4 * 3
    np.testing.assert_allclose(shape.points[0], [1000, 2020, HEIGHTS[0, 0]])  # north-west corner
    np.testing.assert_allclose(shape.points[-1], [1015, 2000, HEIGHTS[-1, -1]])
    assert (shapes.samples(shape, 20)[1][:, 2] > 0).all()
    holes = shapes.read(write(tmp_path, "b.asc", grid().replace(str(HEIGHTS[0, 0]), "-9999")))
    assert len(holes.points) == 19 and len(holes.triangles) == 22 and "1 of 20 heights are missing" in holes.notes


def test_grids_in_degrees(tmp_path):
    shape = shapes.read(write(tmp_path, "a.asc", grid("xllcorner 10\nyllcorner 60\ncellsize 0.001\n")))
    extent = np.ptp(shape.points, axis=0)
    np.testing.assert_allclose(extent[:2], [3 * 55.66, 4 * 111.32], rtol=1e-3)
    assert "degrees" in shape.notes[0]


@pytest.mark.parametrize(
    "text, words",
    [
        (grid() + " 7", "line 11: the height map has 21 heights, but its header says 4 x 5"),
        (grid().replace(str(HEIGHTS[4, 3]), "deep"), "line 11, column 4: 'deep' is not a number"),
        (grid("xllcorner 0\n"), "needs ncols, nrows and cellsize"),
        ("ncols 4\nnrows 5\ncellsize five\n", "line 3, column 2: 'five' is not a number"),
        ("ncols 2\nnrows 2\ncellsize 1\n-9999 -9999 -9999 -9999", "no heights"),
    ],
)
def test_broken_grids(tmp_path, text, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.asc", text))


def test_local_grids_are_not_in_degrees(tmp_path):
    """Grids of things that were measured from close by have cells of centimetres."""
    x, y = np.meshgrid(np.linspace(-3, 3, 40), np.linspace(-3, 3, 40))
    hat = 2.4 * np.exp(-x * x - y * y)
    rows = "\n".join(" ".join(f"{h:.4f}" for h in row) for row in hat)
    corners = ((-3, -3, 0.15), (0, 0, 0.02), (100, 20, 0.15))
    for west, south, cell in corners:
        head = f"ncols 40\nnrows 40\nxllcorner {west}\nyllcorner {south}\ncellsize {cell}\n"
        shape = shapes.read(write(tmp_path, "a.asc", head + rows))
        np.testing.assert_allclose(np.ptp(shape.points, axis=0), [39 * cell, 39 * cell, np.ptp(hat)], atol=1e-3)
        assert shape.notes == ()


def test_a_prj_file_tells_what_a_grid_has(tmp_path):
    degrees, metres = grid("xllcorner 10\nyllcorner 60\ncellsize 0.001\n"), grid("xllcorner 0\nyllcorner 0\ncellsize 0.02\n")
    for said in (GEOGRAPHIC, b"Projection    GEOGRAPHIC\nUnits         DD\n"):
        (tmp_path / "a.prj").write_bytes(said)
        assert "degrees" in shapes.read(write(tmp_path, "a.asc", metres)).notes[0]
        packed = gzip.compress(metres.encode())
        assert "degrees" in shapes.read(write(tmp_path, "a.asc.gz", packed)).notes[0]
    for said in (PROJECTED, b"Projection    UTM\nUnits         METERS\n"):
        (tmp_path / "a.prj").write_bytes(said)
        assert shapes.read(write(tmp_path, "a.asc", degrees)).notes == ()
    (tmp_path / "a.prj").write_bytes(b"nothing")
    assert "degrees" in shapes.read(write(tmp_path, "a.asc", degrees)).notes[0]


def test_grids_of_whole_continents_are_in_degrees(tmp_path):
    x, y = np.meshgrid(np.arange(0, 40), np.arange(0, 30))
    heights = "\n".join(" ".join(f"{h:.0f}" for h in row) for row in 2000 * np.sin(x / 5) * np.cos(y / 7))
    shape = shapes.read(write(tmp_path, "a.asc", "ncols 40\nnrows 30\nxllcorner -20\nyllcorner 10\ncellsize 1\n" + heights))
    assert np.ptp(shape.points[:, 1]) == pytest.approx(29 * 111_320) and "degrees" in shape.notes[0]


def test_large_height_maps_are_thinned(tmp_path, monkeypatch):
    monkeypatch.setattr("hrbfnpr.shapes._heights.MOST_CELLS", 6)
    shape = shapes.read(write(tmp_path, "a.asc", grid()))
    assert len(shape.points) == 6 and "every second row and column" in shape.notes[0]
    np.testing.assert_allclose(np.ptp(shape.points, axis=0)[:2], [10, 20])


def test_pgm(tmp_path):
    deep = b"P5\n# decimetres; cell 24.5 m x 30.0 m\n4 5\n65535\n" + (10 * HEIGHTS).astype(">u2").tobytes()
    shape = shapes.read(write(tmp_path, "a.pgm", deep))
    np.testing.assert_allclose(np.ptp(shape.points, axis=0), [3 * 24.5, 4 * 30, np.ptp(HEIGHTS)], atol=0.2)
    assert shape.notes == ()
    flat = "P2\n4 5\n255\n" + " ".join(map(str, HEIGHTS.astype(int).ravel()))
    shape = shapes.read(write(tmp_path, "b.pgm", flat))
    np.testing.assert_allclose(np.ptp(shape.points, axis=0), [3, 4, 0.75])
    assert "gives no scale" in shape.notes[0]
    with pytest.raises(shapes.ShapeError, match="after 15"):
        shapes.read(write(tmp_path, "a.pgm", deep[:-10]))


# --- VTK ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("with_vtk", [False, True])
def test_cells_of_a_volume(tmp_path, monkeypatch, with_vtk):
    meshio = pytest.importorskip("meshio")
    if with_vtk:
        pytest.importorskip("vtk")
    else:
        monkeypatch.setitem(sys.modules, "vtk", None)
    points = np.vstack([VERTICES, [[1, 1, 1]]])
    meshio.Mesh(points, [("tetra", np.array([[0, 1, 2, 3], [1, 2, 3, 4]]))]).write(tmp_path / "a.vtu")
    shape = shapes.read(tmp_path / "a.vtu")
    facts = shapes.mesh_facts(shape)
    assert len(shape.triangles) == 6 and facts.boundary_edges == 0 and "outer faces" in shape.notes[0]
    assert len(shape.notes) == 1
    meshio.Mesh(CUBE, [("hexahedron", np.array([[0, 1, 3, 2, 4, 5, 7, 6]]))]).write(tmp_path / "b.vtk")
    facts = shapes.mesh_facts(shapes.read(tmp_path / "b.vtk"))
    assert facts.closed and not facts.inside_out and facts.volume == pytest.approx(1)


def round_tetrahedron():
    """Corners on a sphere, then the middle nodes of the edges, also on the sphere."""
    corners = np.array([[1, 1, 1], [-1, 1, -1], [1, -1, -1], [-1, -1, 1]], dtype=float)
    middles = [corners[a] + corners[b] for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
    points = np.vstack([corners, middles])
    return points / np.linalg.norm(points, axis=1)[:, None]


@pytest.mark.parametrize("with_vtk, faces", [(False, 4), (True, 16)])
def test_cells_with_nodes_on_their_edges(tmp_path, monkeypatch, with_vtk, faces):
    """Such cells are read as a surface, not as a cloud of points."""
    meshio = pytest.importorskip("meshio")
    if with_vtk:
        pytest.importorskip("vtk")
    else:
        monkeypatch.setitem(sys.modules, "vtk", None)
    meshio.Mesh(round_tetrahedron(), [("tetra10", np.arange(10)[None])]).write(tmp_path / "a.vtu")
    shape = shapes.read(tmp_path / "a.vtu")
    facts = shapes.mesh_facts(shape)
    assert len(shape.triangles) == faces and facts.closed and not facts.inside_out
    np.testing.assert_allclose(np.linalg.norm(shape.points[shape.triangles], axis=2), 1)
    meshio.Mesh(round_tetrahedron(), [("triangle6", np.array([[0, 1, 2, 4, 5, 6]]))]).write(tmp_path / "b.vtu")
    assert len(shapes.read(tmp_path / "b.vtu").triangles) in (1, 4)


def test_possible_errors_of_meshio_are_reported(tmp_path, monkeypatch):
    meshio = pytest.importorskip("meshio")
    monkeypatch.setitem(sys.modules, "vtk", None)
    apart = np.vstack([VERTICES, VERTICES + 5.0])
    meshio.Mesh(apart, [("tetra", np.arange(8).reshape(2, 4))]).write(tmp_path / "a.vtu")
    assert "no two of its 2 cells share a face" in shapes.read(tmp_path / "a.vtu").notes[1]
    meshio.Mesh(VERTICES, [("triangle", np.array([[0, 1, 2]])), ("line", np.array([[0, 1]]))]).write(tmp_path / "b.vtu")
    assert shapes.read(tmp_path / "b.vtu").notes == ()
    kinds = [meshio.CellBlock("tetra", np.zeros((1, 4))), meshio.CellBlock("hexahedron64", np.zeros((3, 64)))]
    assert _vtk._left_out(kinds) == ("3 cells of the kind hexahedron64 left out",)
    broken = b'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid">'
    with pytest.raises(shapes.ShapeError, match="meshio cannot read it.*VTK itself, if it is installed .python3-vtk9"):
        shapes.read(write(tmp_path, "c.vtu", broken))


MNI = """P 0.3 0.3 0.4 10 1 4
 0 0 0
 1 0 0
 0 1 0
 0 0 1

 0 0 -1
 1 0 0
 0 1 0
 0 0 1

 4
 0 1 1 1 1

 3 6 9 12

 0 2 1 0 1 3 1 2 3 0 3 2
"""


def test_mni_objects_are_read(tmp_path, monkeypatch):
    """MNI objects also end in .obj, but are not Wavefront OBJ."""
    file = write(tmp_path, "a.obj", MNI)
    with monkeypatch.context() as without:
        without.setitem(sys.modules, "vtk", None)
        with pytest.raises(shapes.ShapeError, match="reading MNI objects needs vtk .python3-vtk9"):
            shapes.read(file)
    pytest.importorskip("vtk")
    shape = shapes.read(file)
    facts = shapes.mesh_facts(shape)
    assert len(shape.triangles) == 4 and facts.closed and not facts.inside_out and shape.format == "MNI object"


@pytest.mark.parametrize("ended, words", [("exit 1", "VTK crashed on it"), ("kill -SEGV $$", "crashed on it"),
                                          ("exit 0", "VTK finds no points in it")])  # fmt: skip
def test_a_crash_of_vtk_is_an_error_only(tmp_path, monkeypatch, ended, words):
    interpreter = tmp_path / "python"
    interpreter.write_text(f"#!/bin/sh\n{ended}\n")
    interpreter.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(interpreter))
    monkeypatch.setattr(_vtk, "is_here", lambda module: True)
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.vtp", b'<?xml version="1.0"?>\n<VTKFile type="PolyData">'))
    monkeypatch.setattr(sys, "executable", "")
    with pytest.raises(shapes.ShapeError, match="needs a Python interpreter"):
        shapes.read(tmp_path / "a.vtp")


def test_lines_and_volumes_of_vtk(tmp_path):
    vtk = pytest.importorskip("vtk")
    writer, source = vtk.vtkPolyDataWriter(), vtk.vtkLineSource()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(str(tmp_path / "a.vtk"))
    writer.Write()
    assert shapes.read(tmp_path / "a.vtk").notes == ("it has 1 lines and no faces: their points are used",)
    volume = b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"
    with pytest.raises(shapes.ShapeError, match="it holds a volume"):
        shapes.read(write(tmp_path, "b.vtk", volume))


def test_polygons_of_vtk(tmp_path):
    vtk = pytest.importorskip("vtk")
    source = vtk.vtkSphereSource()
    for writer, name in ((vtk.vtkXMLPolyDataWriter(), "a.vtp"), (vtk.vtkPolyDataWriter(), "a.vtk")):
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(str(tmp_path / name))
        writer.Write()
        facts = shapes.mesh_facts(shapes.read(tmp_path / name))
        assert facts.closed and not facts.inside_out


def test_geotiff(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    place = rasterio.transform.from_origin(1000, 2025, 5, 5)
    options = {"width": 4, "height": 5, "count": 1, "dtype": "float64", "nodata": -9999, "transform": place}
    with rasterio.open(tmp_path / "a.tif", "w", driver="GTiff", **options) as file:
        file.write(HEIGHTS, 1)
    shape = shapes.read(tmp_path / "a.tif")
    np.testing.assert_allclose(shape.points, shapes.read(write(tmp_path, "a.asc", grid())).points)
    with rasterio.open(tmp_path / "a.bil", "w", driver="EHdr", **{**options, "dtype": "float32"}) as file:
        file.write(HEIGHTS.astype("f"), 1)
    elevations = shapes.read(tmp_path / "a.bil")
    np.testing.assert_allclose(elevations.points, shape.points, rtol=1e-6)
    assert elevations.format == "height map, DEM"
    with pytest.raises(shapes.ShapeError, match="rasterio cannot read it"):
        shapes.read(write(tmp_path, "a.dem", b"no elevations"))


VRML = """#VRML V2.0 utf8
Transform { translation 1 2 3 children [ Shape { geometry IndexedFaceSet { coord Coordinate { point [ %s ] }
coordIndex [ %s ] } } ] }
"""


def test_vrml(tmp_path):
    pytest.importorskip("vtk")
    corners = ", ".join(f"{x} {y} {2 * z}" for x, y, z in CUBE)
    faces = ", ".join(" ".join(map(str, [*quad, -1])) for quad in QUADS)
    for name in ("box.wrl", "box.txt"):
        shape = shapes.read(write(tmp_path, name, VRML % (corners, faces)))
        assert shape.format == "VRML" and len(shape.triangles) == 12
        np.testing.assert_allclose(shape.points.max(axis=0), [2, 3, 5], atol=1e-6)
        assert shape.notes == () or name != "box.wrl"
    cut = shapes.read(write(tmp_path, "cut.wrl", VRML % (corners, faces) + "Transform { children [ ] ] }\n"))
    assert len(cut.triangles) == 12 and "VTK cannot read on from line 4" in cut.notes[0]
    with pytest.raises(shapes.ShapeError, match="VTK finds no points in it: (VTK cannot read on|it is damaged)"):
        shapes.read(write(tmp_path, "bad.wrl", VRML[:90]))
    with pytest.raises(shapes.ShapeError, match="VRML of version 1"):
        shapes.read(write(tmp_path, "old.wrl", "#VRML V1.0 ascii\n"))


def test_classes_are_an_option_of_drawings(tmp_path, capsys):
    from test_input import QUICK, forest

    import hrbfnpr
    from hrbfnpr.cli import main

    path = write(tmp_path, "a.las", forest())
    counts = {"": 225, "--classes=2,5": 300, "--classes=5": 75, "--classes=all": 300}
    for option, count in counts.items():
        assert main(["draw", str(path), *filter(None, [option]), str(tmp_path / "a.png"), *QUICK]) == 0
        assert f"LAS: {count} points" in capsys.readouterr().out
    for given, note in ((5, "75 of 300 points are of the classes 5"), ([5, 2], "300 of 300 points are of the classes 5, 2")):
        assert note in map(str, hrbfnpr.draw(path, size=50, marks=100, classes=given).notes)
    assert main(["draw", str(path), "--classes", "2,x"]) == 2 and "a whole number is needed" in capsys.readouterr().err
    assert main(["draw", str(path), "--classes", "256"]) == 2
    with pytest.raises(ValueError, match="classes are of the points of a LAS or LAZ file"):
        hrbfnpr.draw((POINTS, NORMALS), classes=2)
    hrbfnpr.Model.fit(NORMALS, NORMALS).save(tmp_path / "a.hrbf")
    with pytest.raises(ValueError, match="classes are of the points of a LAS or LAZ file, and this is a saved one"):
        hrbfnpr.draw(tmp_path / "a.hrbf", classes=2)
