# SPDX-License-Identifier: MIT
"""Scenes and data of VTK, and those of PyVista, whose classes are subclasses of VTK's: what `hrbfnpr.draw` draws of them.

A scene is a Plotter of PyVista, a vtkRenderWindow or a vtkRenderer.  Each actor that it shows becomes a surface at its place.
Colours become inks, and the camera and the size of the window those of the picture.  Data alone (vtkPolyData, grids,
collections of blocks, actors) become surfaces without a camera.  Parts of VTK are imported when the first object is met.
"""
from __future__ import annotations

import importlib
import math
from collections import Counter
from dataclasses import dataclass, field, replace
from types import SimpleNamespace
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from ._camera import Camera
from ._style import Style
from .shapes import Shape, ShapeError
from .shapes._attributes import COLOUR, PointValues
from .shapes._shape import Floats, Vector
from .shapes._vtk import has_faces, shape_of_arrays
from .shapes._vtk_reader import arrays_of, polygons_of

_CLASSES = {
    "vtkCommonCore": ("reference",), "vtkCommonDataModel": ("vtkPlane", "vtkPolyData"),
    "vtkRenderingCore": ("vtkPolyDataMapper", "vtkCamera"),
    "vtkFiltersCore": ("vtkClipPolyData", "vtkTriangleFilter"), "vtkFiltersGeometry": ("vtkDataSetSurfaceFilter",),
}  # fmt: skip
_WIREFRAME = 1  # VTK_WIREFRAME, the representation of faces by their edges
_VIEW = ("azimuth", "elevation", "direction", "eye", "target", "fov")  # options that replace the camera of the scene
_NEAREST = 1e-3  # least distance of the near plane, in distances of the farthest point
_LEFT_OUT = {
    "hidden": "{} hidden {actors} left out",
    "blocks": "{} hidden {blocks} left out",
    "text": "{} {parts} that {are} no surface left out, such as axes, text and scalar bars",
    "volume": "{} {volumes} left out: contour() makes a surface of a volume",
    "lines": "{} {actors} of lines or wires left out: tube() and the representation as a surface show them",
    "glyphs": "{} {actors} of glyphs left out: glyph() makes a mesh of them",
    "empty": "{} {parts} without points left out",
}  # fmt: skip
_ASSUMED = {
    "opacity": "{} translucent {actors} drawn as opaque; hidden actors are left out",
    "edges": "{} {actors} with the edges of cells shown: edges of cells are not drawn",
    "texture": "{} {textures} not drawn: colours of the points are",
}  # fmt: skip
_PLURALS = {"blocks": "block", "actors": "actor", "parts": "part", "volumes": "volume", "textures": "texture", "are": "is"}


@dataclass
class VtkScene:
    """What a scene shows: a shape for each actor, and the camera if there is a window.

    Attributes
    ----------
    shapes : list of Shape
        The surfaces, in the scene's coordinates.  With `is_coloured`, all have colours by the name "rgb".
    camera : vtkCamera, or None
        The camera; None for data alone, and for a camera that was never placed.
    view_angle : float
        The vertical angle of view in degrees, of a camera that was never placed; 0 is parallel.
    size : tuple of int, or None
        Width and height of the window in pixels.
    is_coloured : bool
        Whether colours tell anything: there are values, or actors of different colours.
    """

    shapes: List[Shape] = field(default_factory=list)
    camera: Any = None
    view_angle: Optional[float] = None
    size: Optional[Tuple[int, int]] = None
    is_coloured: bool = False
    counts: "Counter[str]" = field(default_factory=Counter)
    notes: List[str] = field(default_factory=list)
    is_window: bool = False


class _Surface(NamedTuple):
    """The polygons of an actor, its matrix, and the colour of its property; the colours of its values are an array."""

    polygons: Any
    matrix: Floats
    colour: Vector
    has_values: bool


def scene_in(thing: Any) -> Optional[VtkScene]:
    """The scene of an object of VTK or PyVista; None if it is another object.

    Raises
    ------
    ValueError
        If it shows nothing that can be drawn.
    """
    if not _is_vtk(thing):
        if not is_window(thing):
            return None
        return _of_renderer(thing.renderer, getattr(thing, "window_size", None), _others(thing, thing.renderer))
    if thing.IsA("vtkRenderer"):
        return _of_renderer(thing)
    if thing.IsA("vtkRenderWindow"):
        return _of_window(thing)
    scene = VtkScene()
    if thing.IsA("vtkProp"):
        _add_all(scene, _surfaces(scene, thing, np.eye(4)))
    else:
        if thing.IsA("vtkAlgorithm"):
            thing.Update()
            thing = thing.GetOutputDataObject(0)
        if not thing.IsA("vtkDataObject"):
            return None
        _add_all(scene, (_Surface(polygons, np.eye(4), (1.0, 1.0, 1.0), False) for polygons in _polygons(thing)))
    return _finished(scene, type(thing).__name__)


def is_window(thing: Any) -> bool:
    """Whether an object is a Plotter of PyVista, a vtkRenderWindow or a vtkRenderer."""
    if not _is_vtk(thing):
        thing = getattr(thing, "renderer", None)
    return _is_vtk(thing) and bool(thing.IsA("vtkRenderer") or thing.IsA("vtkRenderWindow"))


def _is_vtk(thing: Any) -> bool:
    return thing is not None and callable(getattr(thing, "IsA", None)) and callable(getattr(thing, "GetClassName", None))


def _vtk() -> Any:
    """The classes that are used, and `to_numpy`."""
    found = {"to_numpy": importlib.import_module("vtkmodules.util.numpy_support").vtk_to_numpy}
    for module, names in _CLASSES.items():
        for name in names:
            found[name] = getattr(importlib.import_module(f"vtkmodules.{module}"), name)
    return SimpleNamespace(**found)


# ---- Windows


def _others(plotter: Any, renderer: Any) -> int:
    """The number of other renderers of a Plotter that show actors."""
    try:
        return sum(1 for one in plotter.renderers if one is not renderer and _shows_actors(one))
    except (AttributeError, TypeError):
        return 0


def _shows_actors(renderer: Any) -> bool:
    return bool(renderer.GetDraw()) and renderer.GetLayer() == 0 and renderer.GetActors().GetNumberOfItems() > 0


def _of_window(window: Any) -> VtkScene:
    renderers = window.GetRenderers()
    found = [renderers.GetItemAsObject(i) for i in range(renderers.GetNumberOfItems())]
    shown = [one for one in found if _shows_actors(one)]
    if not shown:
        raise ValueError("the window shows no actors: add some to its renderer before it is drawn")
    return _of_renderer(shown[0], None, len(shown) - 1)


def _of_renderer(renderer: Any, size: Any = None, others: int = 0) -> VtkScene:
    scene = VtkScene(size=_size_of(renderer, size), is_window=True)
    if others:
        scene.notes.append(f"the window has {others + 1} renderers with actors: one is drawn; give another one to draw it")
    props = renderer.GetViewProps()
    for i in range(props.GetNumberOfItems()):
        _add_all(scene, _surfaces(scene, props.GetItemAsObject(i), np.eye(4)))
    is_placed = renderer.IsActiveCameraCreated()
    camera = renderer.GetActiveCamera()  # VTK makes one that sees everything
    if not getattr(camera, "is_set", True):  # PyVista places it when the window is shown
        is_placed, scene.view_angle = 0, 0.0 if camera.GetParallelProjection() else camera.GetViewAngle()
    elif not is_placed:
        renderer.ResetCamera()
        is_placed = 1
    scene.camera = camera if is_placed else None
    return _finished(scene, "scene")


def _size_of(renderer: Any, size: Any) -> Optional[Tuple[int, int]]:
    """The size of a renderer in pixels: its share of the window."""
    window = renderer.GetVTKWindow()
    if size is None:
        size = (0, 0) if window is None else window.GetSize()
    x0, y0, x1, y1 = renderer.GetViewport()
    width, height = round(size[0] * (x1 - x0)), round(size[1] * (y1 - y0))
    return (width, height) if width > 0 and height > 0 else None


# ---- Actors


def _surfaces(scene: VtkScene, prop: Any, place: Floats) -> Iterator[_Surface]:
    """The surfaces that a prop shows, with those of its parts."""
    if not prop.GetVisibility():
        scene.counts["hidden"] += 1
        return
    if prop.IsA("vtkAssembly") or prop.IsA("vtkPropAssembly"):
        place = place @ _matrix_of(prop) if prop.IsA("vtkProp3D") else place
        parts = prop.GetParts()
        for i in range(parts.GetNumberOfItems()):
            yield from _surfaces(scene, parts.GetItemAsObject(i), place)
        return
    if prop.IsA("vtkVolume"):
        scene.counts["volume"] += 1
        return
    mapper = prop.GetMapper() if prop.IsA("vtkActor") else None
    if mapper is None or prop.IsA("vtkCubeAxesActor") or prop.IsA("vtkAxisActor"):
        scene.counts["text"] += 1
        return
    if mapper.IsA("vtkGlyph3DMapper"):
        scene.counts["glyphs"] += 1
        return
    look = prop.GetProperty()
    if look.GetOpacity() <= 0.0:
        scene.counts["hidden"] += 1
        return
    scene.counts["opacity"] += look.GetOpacity() < 1.0
    scene.counts["texture"] += prop.GetTexture() is not None
    if look.GetRepresentation() == _WIREFRAME and _has_faces(mapper):
        scene.counts["lines"] += 1
        return
    scene.counts["edges"] += bool(look.GetEdgeVisibility())
    mapper.Update()
    data = mapper.GetInputDataObject(0, 0)
    of_blocks = getattr(mapper, "GetCompositeDataDisplayAttributes", lambda: None)()
    for block in _blocks(data) if data is not None else ():
        colour = look.GetColor()
        if of_blocks is not None:
            if of_blocks.HasBlockVisibility(block) and not of_blocks.GetBlockVisibility(block):
                scene.counts["blocks"] += 1
                continue
            if of_blocks.HasBlockColor(block):
                colour = of_blocks.GetBlockColor(block)
        for polygons in _polygons(block):
            has_values = _colour(mapper, polygons)
            matrix = place @ _matrix_of(prop)
            yield _Surface(_clipped(mapper, polygons, matrix), matrix, colour, has_values)


def _has_faces(mapper: Any) -> bool:
    mapper.Update()
    data = mapper.GetInputDataObject(0, 0)
    return data is not None and any(one.GetNumberOfPolys() + one.GetNumberOfStrips() for one in _polygons(data))


def _matrix_of(prop: Any) -> Floats:
    matrix = prop.GetMatrix()
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _blocks(data: Any) -> Iterator[Any]:
    """The blocks of data that are no collections; the data itself if it is none."""
    if not data.IsA("vtkCompositeDataSet"):
        yield data
        return
    each = data.NewIterator()
    each.InitTraversal()
    while not each.IsDoneWithTraversal():
        yield each.GetCurrentDataObject()
        each.GoToNextItem()


def _clipped(mapper: Any, polygons: Any, matrix: Floats) -> Any:
    """Polygons without what the planes of a mapper, which are in the scene's coordinates, cut off."""
    planes = mapper.GetClippingPlanes()
    for i in range(0 if planes is None else planes.GetNumberOfItems()):
        vtk, plane = _vtk(), planes.GetItem(i)
        cut, moved = vtk.vtkClipPolyData(), vtk.vtkPlane()
        moved.SetOrigin(*np.linalg.solve(matrix, [*plane.GetOrigin(), 1.0])[:3])
        moved.SetNormal(*(matrix[:3, :3].T @ np.array(plane.GetNormal())))
        cut.SetClipFunction(moved)
        cut.SetInputData(polygons)
        cut.Update()
        polygons = cut.GetOutput()
    return polygons


def _polygons(data: Any) -> Iterator[Any]:
    """Copies of the polygons of data, one for each block."""
    vtk = _vtk()
    if data.IsA("vtkCompositeDataSet"):
        for block in _blocks(data):
            yield from _polygons(block)
        return
    if not data.IsA("vtkDataSet"):
        raise ShapeError(f"{data.GetClassName()} holds no points and no cells: give a data set of VTK")
    copy = vtk.vtkPolyData()
    copy.ShallowCopy(data if data.IsA("vtkPolyData") else polygons_of(vtk, data))
    yield copy


def _colour(mapper: Any, polygons: Any) -> bool:
    """Give polygons the colours that a mapper shows, as an array of their points or cells.  Whether it shows some."""
    if not mapper.GetScalarVisibility():
        return False
    vtk = _vtk()
    as_shown, of_cells = vtk.vtkPolyDataMapper(), vtk.reference(0)  # without interpolation, for which there is no array
    by_number = mapper.GetArrayAccessMode() == 0
    array = mapper.GetArrayId() if by_number else mapper.GetArrayName() or ""
    as_shown.ColorByArrayComponent(array, mapper.GetArrayComponent())
    for name in ("LookupTable", "ScalarRange", "UseLookupTableScalarRange", "ColorMode", "ScalarMode"):
        getattr(as_shown, f"Set{name}")(getattr(mapper, f"Get{name}")())
    colours = as_shown.MapScalars(polygons, 1.0, of_cells)
    if colours is None:
        return False
    copy = colours.NewInstance()
    copy.DeepCopy(colours)
    copy.SetName(COLOUR)
    attributes = polygons.GetCellData() if int(of_cells) else polygons.GetPointData()
    if copy.GetNumberOfTuples() != (polygons.GetNumberOfCells() if int(of_cells) else polygons.GetNumberOfPoints()):
        return False
    polygons.GetPointData().RemoveArray(COLOUR)
    polygons.GetCellData().RemoveArray(COLOUR)
    attributes.AddArray(copy)
    return True


# ---- Shapes


def _add_all(scene: VtkScene, surfaces: Iterator[_Surface]) -> None:
    vtk = _vtk()
    for one in surfaces:
        arrays = arrays_of(vtk, vtk.to_numpy, one.polygons)
        if not len(arrays["points"]):
            scene.counts["empty"] += 1
        elif arrays["lines"] and not has_faces(arrays):
            scene.counts["lines"] += 1
        else:
            scene.shapes.append(_placed(shape_of_arrays(arrays, "VTK"), one))
            scene.is_coloured |= one.has_values


def _placed(shape: Shape, surface: _Surface) -> Shape:
    """A shape at its place, with the colour of its property if its values have none."""
    linear, fields = surface.matrix[:3, :3], dict(shape.fields)
    if COLOUR not in fields:
        fields[COLOUR] = PointValues("colour", np.tile(np.float32(surface.colour), (len(shape.points), 1)))
    triangles, normals = shape.triangles, shape.normals
    if not np.array_equal(surface.matrix, np.eye(4)):
        if triangles is not None and np.linalg.det(linear) < 0.0:
            triangles = triangles[:, ::-1]
        if normals is not None:
            normals = normals @ np.linalg.pinv(linear)
        for name, values in fields.items():
            if values.kind == "direction":
                fields[name] = PointValues("direction", (values.values @ linear.T).astype(np.float32))
        shape = replace(shape, points=shape.points @ linear.T + surface.matrix[:3, 3])
    return replace(shape, triangles=triangles, normals=normals, fields=fields)


def _finished(scene: VtkScene, name: str) -> VtkScene:
    """The scene with its notes."""
    if not scene.shapes:
        why = "; ".join(_in_words(scene.counts, _LEFT_OUT))
        raise ValueError(f"there is nothing to draw in the {name}" + (f": {why}" if why else ": it has no points"))
    first = [tuple(shape.fields[COLOUR].values[0]) for shape in scene.shapes]
    scene.is_coloured |= len(set(first)) > 1
    scene.notes += _in_words(scene.counts, {**_LEFT_OUT, **_ASSUMED})
    return scene


def _in_words(counts: Mapping[str, int], texts: Mapping[str, str]) -> List[str]:
    return [
        text.format(counts[name], **{many: one if counts[name] == 1 else many for many, one in _PLURALS.items()})
        for name, text in texts.items()
        if counts.get(name)
    ]


# ---- Pictures


def options_in(scene: VtkScene, options: Mapping[str, Any], style: Any) -> Dict[str, Any]:
    """The options of a picture, with those that the scene sets unless they, or a `Style`, are given."""
    result = dict(options)
    if scene.is_coloured and "ink" not in options and not isinstance(style, Style):
        result.setdefault("field", f"ink={COLOUR}")
    if scene.is_window:
        if scene.size is not None:
            result["size"] = _size_in(scene.size, options.get("size"))
        result.setdefault("up", _up_of(scene.camera))
        if scene.camera is None and scene.view_angle is not None and not any(name in options for name in _VIEW):
            result.update(direction=(-1.0, -1.0, -1.0), fov=scene.view_angle)  # PyVista's first view
    return result


def _size_in(window: Tuple[int, int], size: Any) -> Any:
    """The size of the picture: that of the window, or as large as `size`, the longer side alone, says."""
    if isinstance(size, tuple):
        return size
    scale = 1.0 if size is None else size / max(window)
    return tuple(max(1, round(side * scale)) for side in window)


def _up_of(camera: Any) -> Vector:
    """The axis that is nearest to the camera's up direction: z if the camera was not placed."""
    if camera is None:
        return 0.0, 0.0, 1.0
    given = np.array(camera.GetViewUp())
    axis = int(np.argmax(np.abs(given)))
    x, y, z = (math.copysign(1.0, given[axis]) if i == axis else 0.0 for i in range(3))
    return x, y, z


def camera_in(scene: VtkScene, options: Mapping[str, Any]) -> Optional[Camera]:
    """The scene's camera for a picture of the size in the options.  None if the options choose a camera."""
    size = options.get("size")
    if scene.camera is None or any(name in options for name in _VIEW) or not isinstance(size, tuple):
        return None
    camera = _vtk().vtkCamera()
    camera.DeepCopy(scene.camera)
    view = _elements(camera.GetViewTransformMatrix())
    depths = np.concatenate([-(shape.points @ view[2, :3] + view[2, 3]) for shape in scene.shapes])
    depths = depths[np.isfinite(depths)]
    far, near = (float(depths.max()), float(depths.min())) if len(depths) else (1.0, 0.0)
    room = 0.01 * max(far - near, abs(far), 1e-300)
    far, near = far + room, near - room
    if not camera.GetParallelProjection():
        if far <= 0.0:
            raise ValueError("the camera of the scene looks away from everything: reset_camera() turns it")
        near = max(near, _NEAREST * far)
    camera.SetClippingRange(near, far)
    matrix = camera.GetProjectionTransformMatrix(size[0] / size[1], -1.0, 1.0)
    return Camera(view, _elements(matrix), (0.0, 0.0, float(size[0]), float(size[1])))


def _elements(matrix: Any) -> Floats:
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
