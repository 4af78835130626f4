"""Hermite RBF implicit surfaces, drawn in pen and ink.

A few point-and-normal samples become a smooth implicit surface (`Model`); marks are placed on it
(`PointSet`); each frame draws the marks (`Renderer`) with a `Camera` and a `Style`.  The method is
that of Vital Brazil, Macedo, Sousa, Velho, de Figueiredo: "A Few Good Samples: Shape & Tone
Depiction for Hermite RBF Implicits", NPAR 2010, cited as [NPAR] with a section number.

>>> model = hrbfnpr.Model.fit(points, normals)
>>> style = hrbfnpr.Style("contour-and-stipple")
>>> marks = hrbfnpr.PointSet.generate(model, style.groups, budget=60000)
>>> hrbfnpr.Renderer().drawing((marks, style), hrbfnpr.Camera.fit(model)).save("drawing.png")

Arrays are NumPy arrays.  NumPy is optional: without it anything with the buffer protocol, or
nested sequences, is taken, and memoryviews of the same shape are returned.  Long calls release the
interpreter lock, report progress and can be cancelled (`Operation`, Ctrl-C).
"""
from typing import Any

from ._camera import Camera
from ._context import Context, ContextInfo, build_info, default_context, set_default_context
from ._drawing import Drawing
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
from ._library import ffi as _ffi
from ._library import lib as _lib
from ._library import library_path
from ._model import Model
from ._model_results import Curvature, Evaluation, ModelInfo, Projection, RayHits
from ._names import CLASSES
from ._names import PROJECTION as PROJECTION_STATUS
from ._names import RAY as RAY_STATUS
from ._operation import Operation
from ._point_set import PointSet, StepPatches
from ._point_set_info import GroupInfo, LevelInfo, PointSetInfo
from ._renderer import FrameInfo, Item, Renderer
from ._style import PRESETS, GroupStyle, Style

__version__: str = _ffi.string(_lib.hrbfnpr_version_string()).decode()

__all__ = [
    "CLASSES", "PRESETS", "PROJECTION_STATUS", "RAY_STATUS", "BufferTooSmallError", "CallbackError",
    "Camera", "CancelledError", "Context", "ContextInfo", "CorruptDataError", "Curvature", "Drawing",
    "Error", "Evaluation", "FrameInfo", "GroupInfo", "GroupStyle", "InternalError",
    "InvalidArgumentError", "Item", "LevelInfo", "Model", "ModelInfo", "NotConvergedError",
    "Operation", "OutOfMemoryError", "PointSet", "PointSetInfo", "Projection", "RayHits", "Renderer",
    "SingularSystemError", "StepPatches", "StreamError", "Style", "UnsupportedStructError",
    "VersionMismatchError", "build_info", "default_context", "library_path", "set_default_context",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    # Only on demand: it needs NumPy.
    if name == "shapes":
        import importlib

        return importlib.import_module(".shapes", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
