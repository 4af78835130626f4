# SPDX-License-Identifier: MIT
"""Pages for Sphinx's autodoc that together hold every public name of the Python package."""

import inspect

GROUPS = (
    ("call", "In one call", ("draw", "from_pyvista", "Picture", "animate", "Animation", "widget", "Viewer", "matplotlib_show",
                              "DrawingWarning")),
    ("model", "Models", ("Model", "Mesh", "orient", "farthest_points", "CsgInfo", "Evaluation", "Projection", "Curvature",
                         "RayHits", "ModelInfo", "TrimInfo", "Oriented", "OrientInfo", "Comparison", "MeshSamples",
                         "MeshInfo", "MeshFitInfo")),
    ("marks", "Marks and lines", ("PointSet", "Layer", "OwnLayer", "MarkLayer", "LineSet", "Lines", "preset_layers",
                                  "PointSetInfo", "LayerInfo", "PlacementInfo", "StepPatches", "LineSetInfo")),
    ("style", "Camera and style", ("Camera", "Style", "LayerStyle", "LineStyle")),
    ("drawing", "Drawings and pages", ("Renderer", "Item", "Drawing", "Raster", "Vertices", "MarkResults", "MarkIdentity",
                                       "DrawingInfo", "DrawingLayerInfo", "write_page", "PageItem", "Pen", "Annotation",
                                       "PageInfo")),
)  # fmt: skip
MODULES = ("csg", "datasets", "shapes", "batch")


def public(package):
    """All public names, except those of modules."""
    names = {*package.__all__, *package._ON_DEMAND}
    return sorted(name for name in names if not inspect.ismodule(getattr(package, name)))


def entry(package, name):
    thing = getattr(package, name)
    if inspect.isclass(thing) and hasattr(thing, "_fields"):  # a named tuple, whose docstring describes its fields
        fields = "".join(f"   .. py:attribute:: {field}\n\n" for field in thing._fields)
        return f".. autoclass:: hrbfnpr.{name}\n   :exclude-members: __new__, __init__\n\n{fields}"
    if inspect.isclass(thing):
        more = "" if issubclass(thing, BaseException) else "   :inherited-members:\n"
        if "handle" in getattr(thing.__init__, "__code__", entry.__code__).co_varnames:  # only the package calls this constructor
            more += "   :exclude-members: __init__, __new__\n"
        return f".. autoclass:: hrbfnpr.{name}\n   :members:\n{more}\n"
    if callable(thing):
        return f".. autofunction:: hrbfnpr.{name}\n\n"
    return f".. py:data:: hrbfnpr.{name}\n\n   ``{', '.join(map(str, thing))}``\n\n"


def titled(title, text):
    return f"{title}\n{'=' * len(title)}\n\n{text}"


def pages(package):
    """The name and the text of each page."""
    left, entries = public(package), []
    for page, title, names in GROUPS:
        text = "".join(entry(package, name) for name in names)
        left = [name for name in left if name not in names]
        entries.append(page)
        yield page, titled(title, text)
    for module in MODULES:
        thing = getattr(package, module)
        own = [name for name, one in vars(thing).items() if getattr(one, "__module__", "") == thing.__name__]
        names = getattr(thing, "__all__", [name for name in own if not name.startswith("_")])
        text = f".. automodule:: hrbfnpr.{module}\n\n"
        for name in names:
            one = getattr(thing, name)
            if getattr(one, "__module__", "").startswith("hrbfnpr"):
                kind = "autoclass" if inspect.isclass(one) else "autofunction"
                text += f".. {kind}:: hrbfnpr.{module}.{name}\n" + ("   :members:\n\n" if kind == "autoclass" else "\n")
        entries.append(module)
        yield module, titled(f"hrbfnpr.{module}", text)
    errors = [name for name in left if inspect.isclass(getattr(package, name)) and issubclass(getattr(package, name), Exception)]
    rest = [name for name in left if name not in errors]
    yield "errors", titled("Errors", "".join(entry(package, name) for name in errors))
    yield "others", titled("The library, contexts and names", "".join(entry(package, name) for name in rest))
    intro = titled("The Python package", "The public classes and functions, with their parameters and results.  "
                   ":doc:`/python` gives an overview with examples.\n\n.. toctree::\n   :maxdepth: 1\n\n")  # fmt: skip
    yield "index", intro + "".join(f"   {name}\n" for name in (*entries, "errors", "others"))
