# SPDX-License-Identifier: MIT
"""Scenes of VTK and PyVista: what their windows show becomes a picture, seen by the same camera."""
import re

import numpy as np
import pytest
from conftest import ROOT, fibonacci_sphere

import hrbfnpr
from hrbfnpr import _vtk_scene, shapes

pytest.importorskip("vtkmodules", reason="VTK is missing (Debian: python3-vtk9)")

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPlane,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkCamera,
    vtkCompositeDataDisplayAttributes,
    vtkDataSetMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkVolume,
)

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
FEW = {"style": "silhouette", "samples": 60}


def ball(center=(0, 0, 0), radius=0.5):
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(16)
    source.SetCenter(*center)
    source.SetRadius(radius)
    return source


def actor_of(source, colour=None):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    if source.IsA("vtkAlgorithm"):
        mapper.SetInputConnection(source.GetOutputPort())
    else:
        mapper.SetInputDataObject(source)
    actor.SetMapper(mapper)
    if colour is not None:
        actor.GetProperty().SetColor(*colour)
    return actor


def renderer_of(*props):
    renderer = vtkRenderer()
    for prop in props:
        renderer.AddViewProp(prop)
    return renderer


def window_of(renderer, size=(200, 150)):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return window


def output_of(source):
    source.Update()
    return source.GetOutput()


def with_values(data, values, name, of_cells=False, active=True):
    array = numpy_to_vtk(np.asarray(values), deep=True)
    array.SetName(name)
    attributes = data.GetCellData() if of_cells else data.GetPointData()
    attributes.SetScalars(array) if active else attributes.AddArray(array)
    return data


def extent(shape):
    return np.array([shape.points.min(axis=0), shape.points.max(axis=0)])


# ---- Actors


def test_actors_are_at_their_places():
    moved, mirrored = actor_of(ball()), actor_of(vtkCubeSource())
    moved.SetPosition(3, 0, 0)
    moved.SetScale(1, 2, 1)
    moved.RotateZ(90)
    mirrored.SetScale(1, 1, -2)
    inner, outer = vtkAssembly(), vtkAssembly()
    inner.AddPart(actor_of(ball((0, 0, 1))))
    inner.SetPosition(0, 5, 0)
    outer.AddPart(inner)
    outer.SetScale(2)
    scene = _vtk_scene.scene_in(renderer_of(moved, mirrored, outer))
    first, second, third = scene.shapes
    np.testing.assert_allclose(extent(first), [[2, -0.5, -0.5], [4, 0.5, 0.5]], atol=0.03)
    np.testing.assert_allclose(extent(second), [[-0.5, -0.5, -1], [0.5, 0.5, 1]])
    np.testing.assert_allclose(extent(third), [[-1, 9, 1], [1, 11, 3]], atol=0.03)
    for shape in scene.shapes:  # seen from outside, also of the mirrored cube
        corners = shape.points[shape.triangles] - shape.points.mean(axis=0)
        assert np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() > 0.5


def test_what_a_window_does_not_show_is_left_out_and_said():
    hidden, clear, pale, wires = (actor_of(ball()) for _ in range(4))
    hidden.VisibilityOff()
    clear.GetProperty().SetOpacity(0)
    pale.GetProperty().SetOpacity(0.5)
    wires.GetProperty().SetRepresentationToWireframe()
    line = actor_of(vtkLineSource())
    scene = _vtk_scene.scene_in(renderer_of(hidden, clear, pale, wires, line, vtkTextActor(), vtkVolume()))
    assert len(scene.shapes) == 1
    assert scene.notes == [
        "2 hidden actors left out",
        "1 part that is no surface left out, such as axes, text and scalar bars",
        "1 volume left out: contour() makes a surface of a volume",
        "2 actors of lines or wires left out: tube() and the representation as a surface show them",
        "1 translucent actor drawn as opaque; hidden actors are left out",
    ]
    for renderer, words in (
        (renderer_of(), "there is nothing to draw in the scene: it has no points"),
        (renderer_of(hidden), "nothing to draw in the scene: 1 hidden actor left out"),
        (renderer_of(actor_of(vtkPolyData())), "1 part without points left out"),
    ):
        with pytest.raises(ValueError, match=words):
            hrbfnpr.draw(renderer)


def test_blocks_have_colours_of_their_own():
    blocks = vtkMultiBlockDataSet()
    for i in range(3):
        blocks.SetBlock(i, output_of(ball((2 * i, 0, 0))))
    mapper, actor, attributes = vtkCompositePolyDataMapper2(), vtkActor(), vtkCompositeDataDisplayAttributes()
    mapper.SetInputDataObject(blocks)
    mapper.SetCompositeDataDisplayAttributes(attributes)
    attributes.SetBlockColor(blocks.GetBlock(0), RED)
    attributes.SetBlockVisibility(blocks.GetBlock(1), False)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*BLUE)
    actor.GetProperty().EdgeVisibilityOn()
    scene = _vtk_scene.scene_in(renderer_of(actor))
    assert [tuple(shape.fields["rgb"].values[0]) for shape in scene.shapes] == [RED, BLUE]
    np.testing.assert_allclose([shape.points[:, 0].mean() for shape in scene.shapes], [0, 4], atol=0.01)
    assert scene.notes == ["1 hidden block left out", "1 actor with the edges of cells shown: edges of cells are not drawn"]


def test_planes_of_mappers_cut():
    actor, plane = actor_of(vtkCubeSource()), vtkPlane()
    actor.SetPosition(3, 0, 0)
    actor.SetScale(2, 1, 1)
    plane.SetOrigin(3.5, 0, 0)
    plane.SetNormal(-1, 0, 0)
    actor.GetMapper().AddClippingPlane(plane)
    np.testing.assert_allclose(extent(_vtk_scene.scene_in(renderer_of(actor)).shapes[0])[:, 0], [2, 3.5])


def test_data_becomes_surfaces():
    cube = output_of(vtkCubeSource())
    grid, corners = vtkUnstructuredGrid(), vtkPoints()
    for i in (0, 1, 3, 2, 4, 5, 7, 6):
        corners.InsertNextPoint(i >> 2, i >> 1 & 1, i & 1)
    grid.SetPoints(corners)
    grid.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
    blocks, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    inner.SetBlock(0, cube)
    blocks.SetBlock(0, inner)
    blocks.SetBlock(2, grid)
    cloud, places = vtkPolyData(), fibonacci_sphere(50)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    cloud.SetPoints(points)
    cloud.GetPointData().SetNormals(numpy_to_vtk(places, deep=True))
    for data, faces in ((cube, [12]), (vtkCubeSource(), [12]), (grid, [12]), (blocks, [12, 12]), (cloud, [0])):
        found = _vtk_scene.scene_in(data)
        assert [0 if one.triangles is None else len(one.triangles) for one in found.shapes] == faces
        assert found.camera is None and not found.is_window
    np.testing.assert_allclose(found.shapes[0].normals, places)
    named = cloud.GetPointData().GetNormals()
    named.SetName("Normals")
    cloud.GetPointData().SetActiveAttribute(-1, 2)  # no active normals
    assert cloud.GetPointData().GetNormals() is None
    (shape,) = _vtk_scene.scene_in(cloud).shapes
    np.testing.assert_allclose(shape.normals, places)
    assert list(shape.fields) == ["rgb"]
    assert [len(one.triangles) for one in _vtk_scene.scene_in(actor_of(ball())).shapes] == [24 * 14 * 2]
    mapper, actor = vtkDataSetMapper(), vtkActor()
    mapper.SetInputData(grid)
    actor.SetMapper(mapper)
    assert len(_vtk_scene.scene_in(actor).shapes[0].triangles) == 12
    with pytest.raises(TypeError, match="VTK"):
        hrbfnpr.draw(vtkPlane())


# ---- Values and colours


def test_arrays_are_fields():
    data = output_of(ball())
    heights = np.array([data.GetPoint(i)[2] for i in range(data.GetNumberOfPoints())])
    with_values(data, heights, "height", active=False)
    with_values(data, np.tile([0.0, 0.0, 1.0], (len(heights), 1)), "flow", active=False)
    actor = actor_of(data)
    actor.RotateX(90)  # z becomes -y
    shape = _vtk_scene.scene_in(actor).shapes[0]
    assert shape.fields["height"].kind == "scalar" and shape.fields["flow"].kind == "direction"
    np.testing.assert_allclose(shape.fields["flow"].values, np.tile([0.0, -1.0, 0.0], (len(heights), 1)), atol=1e-6)
    np.testing.assert_allclose(shape.fields["height"].values, -shape.points[:, 1], atol=1e-6)
    picture = hrbfnpr.draw(data, "stipple", field="tone=height", up="z", size=100, marks=2000, samples=60)
    row = np.nonzero(picture.image[..., :3].min(axis=2) < 128)[0]
    assert (row >= 50).mean() > 0.7  # the low places are dark


def test_values_of_cells_have_sharp_borders(tmp_path):
    data = with_values(output_of(vtkCubeSource()), np.arange(6.0), "side", of_cells=True)
    shape = _vtk_scene.scene_in(data).shapes[0]
    values = shape.fields["side"].values[shape.triangles]
    assert (values == values[:, :1]).all() and sorted(set(values[:, 0])) == list(range(6))
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(tmp_path / "cube.vtp"))
    writer.SetInputData(data)
    writer.Write()
    read = shapes.read(tmp_path / "cube.vtp")  # files have the same fields
    np.testing.assert_array_equal(read.fields["side"].values, shape.fields["side"].values)
    assert len(read.triangles) == 12


@pytest.mark.parametrize("of_cells", [False, True])
def test_colours_of_values_are_those_of_the_window(of_cells):
    data = output_of(vtkCubeSource())
    count = data.GetNumberOfCells() if of_cells else data.GetNumberOfPoints()
    with_values(data, np.linspace(2, 3, count), "heat", of_cells)
    actor, table = actor_of(data, RED), vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.SetTableValue(0, 0, 0, 1, 1)
    table.SetTableValue(1, 0, 1, 0, 1)
    table.Build()
    actor.GetMapper().SetLookupTable(table)
    actor.GetMapper().SetScalarRange(2, 3)
    scene = _vtk_scene.scene_in(renderer_of(actor))
    colours = scene.shapes[0].fields["rgb"].values
    heat = scene.shapes[0].fields["heat"].values
    np.testing.assert_array_equal(colours, np.where(heat[:, None] < 2.5, [[0, 0, 1]], [[0, 1, 0]]))
    assert scene.is_coloured and data.GetPointData().GetArray("rgb") is None  # the data is unchanged
    actor.GetMapper().ScalarVisibilityOff()
    plain = _vtk_scene.scene_in(renderer_of(actor))
    assert not plain.is_coloured and (plain.shapes[0].fields["rgb"].values == [1, 0, 0]).all()


def test_colours_of_actors_become_inks():
    renderer = renderer_of(actor_of(ball(), RED), actor_of(ball((1.2, 0, 0)), BLUE))
    picture = hrbfnpr.draw(window_of(renderer), "stipple", marks=3000, samples=60)
    note = next(note for note in picture.notes if note.code == "palette_chosen")
    assert note.figures == (2.0,)
    left, right = (picture.image[:, half, :3].reshape(-1, 3).astype(int) for half in (slice(0, 90), slice(110, 200)))
    assert (left[:, 0] - left[:, 2]).max() > 80 and (left[:, 2] - left[:, 0]).max() < 20
    assert (right[:, 2] - right[:, 0]).max() > 80 and (right[:, 0] - right[:, 2]).max() < 20
    black = hrbfnpr.draw(renderer, "stipple", marks=3000, samples=60, ink="#000000", size=(200, 150)).image[..., :3].astype(int)
    assert np.ptp(black, axis=2).max() == 0  # a given ink replaces them
    same = hrbfnpr.draw(renderer_of(actor_of(ball(), RED)), "stipple", marks=900, samples=60, size=80)
    assert np.ptp(same.image[..., :3].astype(int), axis=2).max() == 0  # one colour says nothing


# ---- Cameras


@pytest.mark.parametrize("parallel", [False, True])
@pytest.mark.parametrize("size", [(200, 150), (120, 240)])
def test_the_camera_is_that_of_the_window(parallel, size):
    renderer = renderer_of(actor_of(ball()), actor_of(ball((1, 2, 3))))
    window = window_of(renderer, size)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(4, -7, 3)
    camera.SetFocalPoint(0.5, 0.3, 1)
    camera.SetViewUp(0.1, 0, 1)
    camera.SetViewAngle(40)
    camera.SetWindowCenter(0.2, -0.1)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(3.5)
    camera.SetClippingRange(6.9, 7)  # which VTK renews when it renders
    picture = hrbfnpr.from_pyvista(window, **FEW)
    assert picture.size == size
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
    expected = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    made = picture.camera.projection @ picture.camera.view
    places = np.vstack([shape.points for shape in _vtk_scene.scene_in(window).shapes])
    places = np.column_stack([places, np.ones(len(places))])
    for both in (made, expected):
        assert abs(np.linalg.det(both)) > 0
    ours, theirs = ((places @ both.T)[:, :2] / (places @ both.T)[:, 3:] for both in (made, expected))
    np.testing.assert_allclose(ours, theirs, atol=1e-9)
    depth = (places @ made.T)[:, 2] / (places @ made.T)[:, 3]
    assert (np.abs(depth) < 1).all()  # everything is between the planes


def test_options_replace_the_camera_and_the_size():
    window = window_of(renderer_of(actor_of(ball())), (200, 100))
    assert hrbfnpr.draw(window, size=100, **FEW).size == (100, 50)
    assert hrbfnpr.draw(window, size=(60, 90), **FEW).size == (60, 90)
    above = hrbfnpr.draw(window, elevation=30, size=(60, 60), **FEW)
    assert above.camera.view[2, 1] == pytest.approx(0.5)  # y is up for VTK's first camera
    given = hrbfnpr.Camera.fit(((-1, -1, -1), (1, 1, 1)), size=(50, 40))
    assert hrbfnpr.draw(window, camera=given, **FEW).camera == given
    away = window.GetRenderers().GetFirstRenderer().GetActiveCamera()
    away.SetFocalPoint(*(2 * np.array(away.GetPosition())))
    with pytest.raises(ValueError, match="looks away from everything"):
        hrbfnpr.draw(window, **FEW)


def test_lines_are_hidden_exactly_between_actors():
    front, back = actor_of(ball((0, 0, 2), 0.8)), actor_of(ball((0.1, 0, -2), 0.5))
    both, alone = renderer_of(front, back), renderer_of(front)
    for renderer in (both, alone):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 9)
        camera.SetFocalPoint(0, 0, 0)
    row, column = np.indices((120, 120)) - 59.5
    inside = np.hypot(row, column) < 23  # within the outline of the ball in front, whose radius is 26 pixels
    for renderer in (both, alone):  # the ball in the back is hidden wholly
        image = hrbfnpr.draw(renderer, size=(120, 120), hidden="none", **FEW).image[..., 0]
        assert (image[inside] == 255).all() and (image < 128).sum() > 100
    front.SetVisibility(False)
    assert (hrbfnpr.draw(both, size=(120, 120), **FEW).image[..., 0][inside] < 128).sum() > 30


# ---- PyVista


class Plotter:
    """pyvista.Plotter, with only the members that are read."""

    def __init__(self, *renderers, window_size=(160, 120)):
        self.renderers, self.renderer, self.window_size = renderers, renderers[0], list(window_size)


class PyVistaCamera(vtkCamera):
    """pyvista.Camera: `is_set` is false before the window is shown."""

    is_set = False


def test_plotters_of_pyvista_are_drawn():
    renderer = renderer_of(actor_of(ball()), actor_of(ball((1, 0, 0))))
    picture = hrbfnpr.from_pyvista(Plotter(renderer), "hatch", samples=60, marks=2000)
    assert picture.size == (160, 120)
    assert np.array_equal(picture.image, hrbfnpr.draw(Plotter(renderer), "hatch", samples=60, marks=2000).image)
    camera = PyVistaCamera()
    renderer.SetActiveCamera(camera)
    first = hrbfnpr.from_pyvista(Plotter(renderer), **FEW).camera
    np.testing.assert_allclose(first.view[2, :3], np.full(3, 3**-0.5), atol=1e-9)  # from (1, 1, 1), as PyVista does
    assert first.size == (160, 120) and camera.GetPosition() == vtkCamera().GetPosition()
    camera.is_set = True
    camera.SetPosition(0, 0, 5)
    camera.SetParallelProjection(True)
    np.testing.assert_allclose(hrbfnpr.from_pyvista(Plotter(renderer), **FEW).camera.view[2], [0, 0, 1, -5])


def test_one_of_several_renderers_is_drawn():
    one, other = renderer_of(actor_of(ball())), renderer_of(actor_of(ball(radius=2)))
    one.SetViewport(0, 0, 0.5, 1)
    window = window_of(one, (200, 100))
    window.AddRenderer(other)
    picture = hrbfnpr.from_pyvista(window, **FEW)
    assert picture.size == (100, 100)
    assert picture.notes[0] == "the window has 2 renderers with actors: one is drawn; give another one to draw it"
    assert hrbfnpr.from_pyvista(Plotter(other, one), **FEW).notes[0].startswith("the window has 2 renderers")


def test_other_objects_are_named():
    for thing in (vtkSphereSource(), vtkPolyData(), 3, fibonacci_sphere(9)):
        with pytest.raises(TypeError, match="from_pyvista draws a Plotter of PyVista"):
            hrbfnpr.from_pyvista(thing)
    with pytest.raises(ValueError, match="the window shows no actors"):
        hrbfnpr.from_pyvista(window_of(vtkRenderer()))
    with pytest.raises(ValueError, match="vtkTable holds no points|holds no points and no cells"):
        from vtkmodules.vtkCommonDataModel import vtkTable

        hrbfnpr.draw(vtkTable())
    two = renderer_of(actor_of(ball()), actor_of(vtkPlaneSource()))
    with pytest.raises(ValueError, match="fields are values of the points of one surface, and vtk\\w*Renderer has 2"):
        hrbfnpr.draw(two, fields={"heat": np.zeros(3)})
    with pytest.raises(ValueError, match="nothing to draw in the vtkPolyData"):
        hrbfnpr.draw(vtkPolyData())
    empty = vtkImageData()
    empty.SetDimensions(3, 3, 3)
    assert len(_vtk_scene.scene_in(empty).shapes[0].triangles) == 48


def test_strips_are_faces():
    strip, points = vtkCellArray(), vtkPoints()
    for x, y in ((0, 0), (0, 1), (1, 0), (1, 1)):
        points.InsertNextPoint(x, y, 0)
    strip.InsertNextCell(4, [0, 1, 2, 3])
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetStrips(strip)
    assert len(_vtk_scene.scene_in(data).shapes[0].triangles) == 2


def test_the_example_of_the_page_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    (block,) = [one for one in re.findall(r"^```py\n(.*?)^```$", text, re.DOTALL | re.MULTILINE) if "from_pyvista" in one]
    exec(compile(block, "python.md", "exec"), {})
    drawn = (tmp_path / "scene.svg").read_text(encoding="utf-8")
    assert "hatch ink 1" in drawn and "hatch ink 2" in drawn


def test_pyvista_itself():
    pyvista = pytest.importorskip("pyvista", reason="PyVista is missing (pip install pyvista)")
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
    plotter.add_mesh(pyvista.Sphere(), color="red")
    plotter.add_mesh(pyvista.Cube(center=(2, 0, 0)), color="blue")
    picture = hrbfnpr.from_pyvista(plotter, "stipple", samples=60, marks=2000)
    assert picture.size == (160, 120) and any(note.code == "palette_chosen" for note in picture.notes)
    np.testing.assert_allclose(picture.camera.view[2, :3], np.full(3, 3**-0.5), atol=1e-6)
