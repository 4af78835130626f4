# SPDX-License-Identifier: MIT
"""Hermite RBF implicit surfaces, drawn in pen and ink.

A `Model` is a smooth implicit surface that is fitted to points with normals.  A `PointSet` holds marks on the surface.  A
`Renderer` draws marks and lines with a `Camera` and a `Style`.  The resulting `Drawing` becomes an image or vertices.
`draw` does all of this in one call.  The method is that of Vital Brazil, Macedo, Sousa, Velho, de Figueiredo: "A Few Good
Samples: Shape & Tone Depiction for Hermite RBF Implicits", NPAR 2010, cited as [NPAR] with a section number.

>>> model = hrbfnpr.Model.fit(points, normals)
>>> marks = model.generate(preset="contour-and-stipple", budget=60000)
>>> style = hrbfnpr.Style("contour-and-stipple")
>>> hrbfnpr.Renderer().draw((marks, style), hrbfnpr.Camera.fit(model)).save("drawing.png")

Arrays are NumPy arrays.  NumPy is optional: without it, arguments may be nested sequences or objects with the buffer
protocol, and results are memoryviews of the same shape.  Long calls release the interpreter lock, report their progress
and can be cancelled (`Operation`, Ctrl-C).  Objects that never change, such as models, point sets and drawings, may be used
by several threads at the same time.
"""
from typing import TYPE_CHECKING, Any, List

from ._camera import Camera
from ._context import Context, build_info, default_context, set_default_context
from ._depth_image import SmoothedDepthImage, smooth_depth_image
from ._drawing import Drawing, DrawingLayerInfo, MarkResults, Raster, Vertices
from ._errors import (
    BufferTooSmallError,
    CallbackError,
    CancelledError,
    CorruptDataError,
    Error,
    InternalError,
    InvalidArgumentError,
    NotConvergedError,
    OutOfMemoryError,
    SingularSystemError,
    StreamError,
    UnsupportedStructError,
    VersionMismatchError,
)
from ._layer import Layer, OwnLayer, preset_layers
from ._library import ffi as _ffi
from ._library import lib as _lib
from ._library import library_path
from ._line_set import Lines, LineSet
from ._item import Item
from ._light import Light
from ._line_style import LineStyle
from ._marks import MarkLayer
from ._mesh import Mesh, MeshEdges, MeshSamples, farthest_points
from ._model import Model
from ._model_results import Curvature, Evaluation, Projection, RayHits
from ._names import CLASSES, PRESETS
from ._names import PROJECTION as PROJECTION_STATUS
from ._names import RAY as RAY_STATUS
from ._operation import Operation
from ._orient import Oriented, orient
from ._page import write_page
from ._point_set import PointSet, StepPatches
from ._renderer import Renderer
from ._shading import Occluders, Shading
from ._style import LayerStyle, Style
from ._surface_field import Dab, Field, FieldValues

from . import csg  # noqa: E402 isort: skip

__version__: str = _ffi.string(_lib.hrbfnpr_version_string()).decode()

__all__ = [
    "CLASSES", "PRESETS", "PROJECTION_STATUS", "RAY_STATUS", "Annotation", "BufferTooSmallError", "CallbackError",
    "Camera", "CancelledError", "Comparison", "Context", "ContextInfo", "CorruptDataError", "CsgInfo", "Curvature",
    "Dab", "Field", "FieldValues",
    "DepthImageInfo", "Drawing", "DrawingInfo", "DrawingLayerInfo", "Error", "Evaluation", "InternalError", "InvalidArgumentError", "Item", "Layer",
    "LayerInfo", "LayerStyle", "Light", "LineSet", "LineSetInfo", "LineStyle", "Lines", "MarkIdentity", "MarkLayer",
    "MarkResults", "Mesh", "MeshEdges", "MeshEdgesInfo", "MeshFitInfo", "MeshInfo", "MeshSamples", "Model", "ModelInfo",
    "NotConvergedError",
    "Occluders", "Operation", "OrientInfo", "Oriented", "OutOfMemoryError", "OwnLayer", "PageInfo", "PageItem", "Pen",
    "PlacementInfo", "PointSet", "PointSetInfo", "Projection", "Raster", "RayHits", "Renderer", "SingularSystemError",
    "SmoothedDepthImage", "StepPatches", "StreamError", "Style", "TrimInfo", "UnsupportedStructError", "VersionMismatchError", "Vertices",
    "build_info", "csg", "default_context", "farthest_points", "library_path", "orient", "preset_layers",
    "set_default_context", "smooth_depth_image", "write_page",
]  # fmt: skip


# Imported on demand, because these modules need NumPy, and some of them other packages.
_MODULES = ("shapes", "datasets", "batch")
# Records are made on demand, because making a dataclass takes about a millisecond.
_RECORDS = (
    "Annotation", "Comparison", "ContextInfo", "CsgInfo", "DepthImageInfo", "DrawingInfo", "LayerInfo", "LineSetInfo",
    "MarkIdentity", "MeshEdgesInfo", "MeshFitInfo", "MeshInfo", "ModelInfo", "OrientInfo", "PageInfo", "PageItem", "Pen",
    "PlacementInfo", "PointSetInfo", "TrimInfo",
)  # fmt: skip
_ON_DEMAND = {
    **dict.fromkeys(_RECORDS, "_records"),
    "Animation": "_animate", "DrawingWarning": "_report", "Note": "_report", "Picture": "_picture", "animate": "_animate",
    "draw": "_draw_call", "from_pyvista": "_draw_call", "matplotlib_show": "_notebook", "widget": "_notebook", "Viewer": "_notebook",
}  # fmt: skip

if TYPE_CHECKING:
    from . import batch as batch
    from . import datasets as datasets
    from . import shapes as shapes
    from ._animate import Animation as Animation
    from ._animate import animate as animate
    from ._draw_call import draw as draw
    from ._draw_call import from_pyvista as from_pyvista
    from ._notebook import Viewer as Viewer
    from ._notebook import matplotlib_show as matplotlib_show
    from ._notebook import widget as widget
    from ._picture import Picture as Picture
    from ._records import (
        Annotation,
        Comparison,
        ContextInfo,
        CsgInfo,
        DepthImageInfo,
        DrawingInfo,
        LayerInfo,
        LineSetInfo,
        MarkIdentity,
        MeshEdgesInfo,
        MeshFitInfo,
        MeshInfo,
        ModelInfo,
        OrientInfo,
        PageInfo,
        PageItem,
        Pen,
        PlacementInfo,
        PointSetInfo,
        TrimInfo,
    )
    from ._report import DrawingWarning as DrawingWarning
    from ._report import Note as Note


def __getattr__(name: str) -> Any:
    import importlib

    if name in _MODULES:
        return importlib.import_module(f".{name}", __name__)
    if name in _ON_DEMAND:
        value = getattr(importlib.import_module(f".{_ON_DEMAND[name]}", __name__), name)
        globals()[name] = value
        return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> List[str]:
    return sorted({*globals(), *_MODULES, *_ON_DEMAND})
