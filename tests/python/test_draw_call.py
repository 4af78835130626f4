# SPDX-License-Identifier: MIT
"""hrbfnpr.draw draws any source in one call."""
import io
import warnings

import numpy as np
import pytest
from conftest import torus
from test_cli import rows
from test_shapes import CUBE, write

import hrbfnpr
from hrbfnpr import _request, datasets
from hrbfnpr.cli import _grammar, main

Image = pytest.importorskip("PIL.Image")

QUICK = {"size": 120, "marks": 1500, "samples": 60}
POINTS, NORMALS = torus(12, 6)
TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def ink(picture):
    return (picture.image[..., :3].min(axis=-1) < 128).mean()


def test_the_picture_equals_that_of_the_command_line(tmp_path):
    path = write(tmp_path, "a.xyz", rows(np.hstack([POINTS, NORMALS])))
    words = ["--size", "120", "--marks", "1500", "--azimuth", "50", "--ink", "#203040", "--quiet"]
    assert main(["draw", str(path), str(tmp_path / "out.png"), "--style", "hatch", *words]) == 0
    picture = hrbfnpr.draw(path, "hatch", size=120, marks=1500, azimuth=50, ink="#203040")
    assert np.array_equal(picture.image, np.asarray(Image.open(tmp_path / "out.png")))
    picture.save(tmp_path / "again.png")
    assert np.array_equal(picture.image, np.asarray(Image.open(tmp_path / "again.png")))


def test_a_picture_holds_its_parts(tmp_path):
    picture = hrbfnpr.draw((POINTS, NORMALS), **QUICK)
    assert picture.image.dtype == np.uint8 and picture.image.shape == (*picture.size[::-1], 4)
    assert max(picture.size) == 120 and 0.01 < ink(picture) < 0.9
    assert picture.model.info.samples == 60 and len(picture.marks) <= 1500 and picture.line_set is not None
    assert picture.style.preset == "contour-and-stipple" and picture.drawing.info.shown > 0
    assert picture._repr_png_().startswith(b"\x89PNG") and "<svg" in picture._repr_svg_()
    picture.save(tmp_path / "out.svg")
    assert (tmp_path / "out.svg").read_text().startswith("<?xml")
    for target, format, start in ((io.BytesIO(), None, b"\x89PNG"), (io.BytesIO(), "svg", b"<?xml"),
                                  (io.BytesIO(), "GIF", b"GIF8")):  # fmt: skip
        picture.save(target, format)
        assert target.getvalue().startswith(start)
    with pytest.raises(ValueError, match="no picture format is known for the ending '.bmpx'"):
        picture.save(tmp_path / "out.bmpx")
    assert "Picture contour-and-stipple, " in repr(picture)


def test_the_same_model_can_be_seen_from_another_side():
    picture = hrbfnpr.draw((POINTS, NORMALS), **QUICK, azimuth=10)
    other = picture.seen(azimuth=70, elevation=60)
    assert other.marks is picture.marks and other.camera != picture.camera
    # The marks that `picture` was drawn with are not enough from there, so all marks were placed.
    whole = hrbfnpr.draw((POINTS, NORMALS), **QUICK, azimuth=70, elevation=60, keep_marks=True)
    assert other.camera == whole.camera and np.array_equal(other.image, whole.image)
    assert picture.seen().camera == picture.camera
    assert picture.seen(direction=(0, 0, -1)).camera == hrbfnpr.draw((POINTS, NORMALS), **QUICK, direction=(0, 0, -1)).camera
    assert picture.seen(camera=whole.camera).camera == whole.camera


def test_an_archaeological_plate_is_larger_than_its_drawing(tmp_path):
    picture = hrbfnpr.draw((POINTS, NORMALS), "archaeological", size=200, marks=1500)
    assert picture.image.shape[1] > 1.2 * picture.size[0]
    picture.save(tmp_path / "plate.png")
    assert Image.open(tmp_path / "plate.png").size == picture.image.shape[1::-1] and picture._repr_svg_() is None


@pytest.mark.parametrize(
    "option, words",
    [
        ({"size": (160, 90)}, ["--size", "160x90"]),
        ({"marks": {"stipples": 200, "hatch": 30}}, ["--marks", "stipples=200,hatch=30"]),
        ({"budget": np.int64(70)}, ["--marks", "70"]),
        ({"lines": ["contour", "section=z:4"]}, ["--lines", "contour,section=z:4"]),
        ({"lines": []}, ["--lines", "none"]),
        ({"up": (0, 0, 1)}, ["--up", "z"]),
        ({"light": np.array([1.0, -2.0, 0.5])}, ["--light", "1,-2,0.5"]),
        ({"paper": (1.0, 0.5, 0.0)}, ["--paper", "1,0.5,0"]),
        ({"hidden_lines": "hide", "flip": True}, ["--hidden-lines", "hide", "--flip"]),
        ({"kernel": "wendland_c2"}, ["--kernel", "wendland-c2"]),
        ({"max_centres": 40, "tolerance": 1e-3}, ["--max-centres", "40", "--tolerance", "0.001"]),
        ({"set": {"hatch.ink": "#800000", "halo_width": 3}}, ["--set", "hatch.ink=#800000", "--set", "halo_width=3"]),
        ({"page": (210, 297)}, ["--page", "210x297"]),
        ({"depth_range": None}, []),
    ],
)
def test_options_match_the_command_line(option, words):
    wanted = _grammar.options_of(_grammar.build().parse_args(["draw", "x", *words]))
    assert _request.options_of(option) == wanted


def test_notes_have_codes_and_figures():
    notes = hrbfnpr.draw((POINTS, -NORMALS), size=100, marks=500).notes
    assert [(note.code, note.severity) for note in notes] == [("normals_turned", "note")]
    assert hrbfnpr.Note("").code == "" and not hrbfnpr.Note("").figures


@pytest.mark.parametrize(
    "option, error, words",
    [
        ({"azimut": 3}, TypeError, "no option 'azimut': did you mean azimuth"),
        ({"azimuth": "east"}, ValueError, "azimuth: a number is needed, not 'east'"),
        ({"azimuth": float("nan")}, ValueError, "azimuth: a finite number"),
        ({"samples": 0}, ValueError, "samples: the number must be at least 1, not 0"),
        ({"samples": 2.5}, ValueError, "samples: a whole number is needed"),
        ({"flip": "yes"}, ValueError, "flip must be True or False"),
        ({"style": "cubist"}, ValueError, "style must be one of .*, not 'cubist'"),
        ({"kernel": "cubist"}, ValueError, "kernel must be one of "),
        ({"set": {"colour": 3}}, ValueError, "set: there is no field 'colour'"),
        ({"set": "ink=red"}, TypeError, "set must be a mapping"),
        ({"camera": 3}, TypeError, "camera must be a hrbfnpr.Camera, not int"),
        ({"style": hrbfnpr.Style("stipple"), "mark_radius": 2}, ValueError, "mark_radius is for named styles"),
        ({"progress": 3}, TypeError, "progress must be a function"),
    ],
)
def test_wrong_options_are_named(option, error, words):
    with pytest.raises(error, match=words):
        hrbfnpr.draw((POINTS, NORMALS), **option)


def test_a_given_style_and_camera_are_used():
    style = hrbfnpr.Style("stipple", stipples={"radius": 3.0})
    camera = hrbfnpr.Camera.fit(((-1.4, -1.4, -1.4), (1.4, 1.4, 1.4)), size=(90, 80))
    picture = hrbfnpr.draw((POINTS, NORMALS), style, camera=camera, marks=200)
    assert picture.camera == camera and picture.image.shape == (80, 90, 4)
    assert picture.style.layer("stipples").radius == 3.0
    style.layer("stipples").radius = 9.0  # the picture has a copy of the style
    assert picture.style.layer("stipples").radius == 3.0


# Stand-ins for classes of other packages, with only the members that are read.


class PolyData:
    """pyvista.PolyData."""

    def __init__(self, points, faces=(), normals=None):
        self.points, self.faces = points, np.array(faces)
        self.point_data = {} if normals is None else {"Normals": normals}


class UnstructuredGrid:
    """pyvista.UnstructuredGrid: a mesh of cells."""

    def __init__(self, surface):
        self.points, self.point_data = surface.points, {}
        self._surface = surface

    def extract_surface(self):
        return self._surface


class Trimesh:
    """trimesh.Trimesh, or a point cloud, which has no `faces`."""

    def __init__(self, vertices, faces=None):
        self.vertices = vertices
        if faces is not None:
            self.faces = faces


class TrimeshScene:
    def __init__(self, mesh):
        self.geometry, self._mesh = {"part": mesh}, mesh

    def dump(self, concatenate):
        assert concatenate
        return self._mesh


class Vector:
    """Vectors of Open3D: not arrays, but NumPy converts them."""

    def __init__(self, values):
        self._values = values

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self._values, dtype=dtype)

    def __len__(self):
        return len(self._values)


class TriangleMesh:
    """open3d.geometry.TriangleMesh."""

    def __init__(self, vertices, triangles):
        self.vertices, self.triangles = Vector(vertices), Vector(triangles)
        self.vertex_normals = Vector(np.zeros((0, 3)))


class PointCloud:
    """open3d.geometry.PointCloud."""

    def __init__(self, points, normals=np.zeros((0, 3))):
        self.points, self.normals = Vector(points), Vector(normals)

    def has_normals(self):
        return len(self.normals) > 0


class Tensors:
    """Geometry of open3d.t, which has to_legacy()."""

    def __init__(self, legacy):
        self._legacy = legacy

    def to_legacy(self):
        return self._legacy


PACKED = np.column_stack([np.full(4, 3), FACES]).reshape(-1)


@pytest.mark.parametrize(
    "thing, faces, has_normals",
    [
        ((TETRAHEDRON, FACES), 4, False),
        ((TETRAHEDRON.tolist(), FACES.tolist()), 4, False),
        ([POINTS, NORMALS], 0, True),
        ((POINTS, None), 0, False),
        (POINTS, 0, False),
        (POINTS.tolist(), 0, False),
        (tuple(map(tuple, TETRAHEDRON[:2])), 0, False),  # two points, not points with normals
        (PolyData(TETRAHEDRON, PACKED), 4, False),
        (PolyData(np.array(CUBE, dtype=float), [4, 0, 1, 2, 3, 3, 4, 5, 6]), 3, False),
        (PolyData(POINTS, (), NORMALS), 0, True),
        (PolyData(POINTS), 0, False),
        (UnstructuredGrid(PolyData(TETRAHEDRON, PACKED)), 4, False),
        (Trimesh(TETRAHEDRON, FACES), 4, False),
        (Trimesh(POINTS), 0, False),
        (TrimeshScene(Trimesh(TETRAHEDRON, FACES)), 4, False),
        (TriangleMesh(TETRAHEDRON, FACES), 4, False),
        (PointCloud(POINTS, NORMALS), 0, True),
        (PointCloud(POINTS), 0, False),
        (Tensors(TriangleMesh(TETRAHEDRON, FACES)), 4, False),
        (Tensors(PointCloud(POINTS, NORMALS)), 0, True),
        (hrbfnpr.Mesh(TETRAHEDRON, FACES), 4, False),
        (datasets.sphere(30), 0, True),
    ],
)
def test_objects_with_points_become_shapes(thing, faces, has_normals):
    from hrbfnpr._foreign import shape_of

    shape = shape_of(thing)
    assert shape.points.shape[1] == 3 and shape.points.dtype == np.float64
    assert (0 if shape.triangles is None else len(shape.triangles)) == faces
    assert (shape.normals is not None) == has_normals
    if has_normals and len(shape.points) == len(POINTS):
        assert np.array_equal(shape.normals, NORMALS)


def test_objects_without_points_are_refused():
    for thing in (3, None, object()):
        with pytest.raises(TypeError, match="PyVista, trimesh or Open3D, not "):
            hrbfnpr.draw(thing)
    for thing, words in (
        ((POINTS, NORMALS[:5]), "there are 72 points and 5 normals"),
        ((POINTS, np.array([[0, 0, -1]])), "give normals as floats"),
        ((POINTS, np.array([[0, 0, 72]])), "a face names vertex 72"),
        (POINTS[:, :2], r"points must have the shape \(n, 3\), not \(72, 2\)"),
        (PolyData(POINTS, [3, 0, 1]), "faces must be lists of a count"),
    ):
        with pytest.raises(ValueError, match=words):
            hrbfnpr.draw(thing)


def test_a_mesh_of_another_package_is_drawn():
    shape = datasets.torus(mesh=True)
    drawn = hrbfnpr.draw(Trimesh(shape.points, shape.triangles), size=100, marks=800, samples=80)
    assert drawn.model.info.samples == 80 and ink(drawn) > 0.01
    assert np.array_equal(drawn.image, hrbfnpr.draw(shape, size=100, marks=800, samples=80).image)


def test_models_and_marks_are_drawn_unchanged(ring, tmp_path):
    picture = hrbfnpr.draw(ring, size=100, marks=800, keep_marks=True)
    assert picture.model is ring
    marks = hrbfnpr.draw(picture.marks, size=100)
    assert marks.marks is picture.marks and marks.model is None
    picture.marks.save(tmp_path / "a.hrbm")
    assert np.array_equal(hrbfnpr.draw(tmp_path / "a.hrbm", size=100).image, marks.image)


def test_warnings_are_python_warnings_and_notes_are_kept(tmp_path):
    few = datasets.sphere(6)
    with pytest.warns(hrbfnpr.DrawingWarning, match="there are only 6 points: the surface between them is a guess") as told:
        hrbfnpr.draw(few, size=100, marks=500)
    assert all(one.filename == __file__ for one in told)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        picture = hrbfnpr.draw((POINTS, -NORMALS), size=100, marks=500)
    assert any("inward" in note for note in picture.notes), picture.notes
    with pytest.raises(FileNotFoundError):
        hrbfnpr.draw(tmp_path / "missing.ply")
    with pytest.raises(ValueError, match="bad.xyz: .*is not a number"):
        hrbfnpr.draw(write(tmp_path, "bad.xyz", "a b\n"))


def test_a_blank_picture_is_an_error_unless_allowed():
    away = {"eye": (0, 0, 9), "target": (0, 0, 20), "marks": 300, "size": 80}
    with pytest.raises(ValueError, match="would be blank: .*leave out eye and direction, or set target in the model"):
        hrbfnpr.draw((POINTS, NORMALS), **away)
    assert ink(hrbfnpr.draw((POINTS, NORMALS), **away, allow_blank=True)) == 0


def test_progress_by_a_function_or_a_bar():
    told = []
    hrbfnpr.draw((POINTS, NORMALS), **QUICK, progress=lambda stage, fraction: told.append((stage, fraction)))
    stages = list(dict.fromkeys(stage for stage, _ in told))
    assert stages[:1] == ["sampling"] and "fitting" in stages and stages[-1] == "drawing"
    for stage in stages:
        part = [fraction for name, fraction in told if name == stage]
        assert part[0] == 0 and part[-1] == 1 and part == sorted(part) and max(part) <= 1

    class Stop(Exception):
        pass

    def stop(stage, fraction):
        if stage == "placing marks":
            raise Stop

    with pytest.raises(Stop):
        hrbfnpr.draw((POINTS, NORMALS), **QUICK, progress=stop)
    tqdm = pytest.importorskip("tqdm")
    screen = io.StringIO()
    with tqdm.tqdm(file=screen, mininterval=0) as bar:
        hrbfnpr.draw((POINTS, NORMALS), **QUICK, progress=bar)
    assert "fitting" in screen.getvalue() and bar.n == pytest.approx(1)
