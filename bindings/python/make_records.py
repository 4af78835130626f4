# SPDX-License-Identifier: MIT
"""Makes hrbfnpr/_records.json and hrbfnpr/_records.pyi: names, records, descriptions and styles for the Python package.

bindings/generate runs this module.  The package makes classes from the .json when it is imported (hrbfnpr/_records.py).
The .pyi describes these classes to type checkers and editors.  Both files are committed.  They are made from the header
and from the tables below, which hold what only Python needs.
"""
import json
import re
import textwrap
from pathlib import Path
from typing import Any, NamedTuple, Optional

HERE = Path(__file__).resolve().parent
NOTE = "# SPDX-License-Identifier: MIT\n# Made by make_records.py from include/hrbfnpr.h; do not edit.\n"
WIDTH = 116


class Record(NamedTuple):
    """A frozen dataclass with the fields of a struct.

    struct   the struct's name without "hrbfnpr_"
    doc      the first line of the docstring
    names    by field: the prefix of the constants that the field takes, if the header's comment does not name it
    words    by field: a description that replaces the header's comment
    order    the fields in the order of the dataclass; empty: all fields, as in the header
    renamed  by the name in Python: the struct's field, if the names differ
    """

    struct: str
    doc: str
    names: dict = {}
    words: dict = {}
    order: tuple = ()
    renamed: dict = {}
    base: bool = False  # True: the package derives its own class from this one


RECORDS = {
    "ContextInfo": Record("context_info", "What a context uses.",
                          {"thread_backend": "THREAD_BACKEND", "instruction_set": "INSTRUCTION_SET"},
                          {"thread_backend": 'what runs the tasks of a large call: "pool", "openmp", "run_tasks" or "serial"',
                           "instruction_set": 'the instruction set in use, such as "avx2"'},
                          ("thread_count", "thread_backend", "instruction_set", "bytes_now", "bytes_peak")),
    "ModelInfo": Record("model_info", "What a fit did.  Lengths are in the unit of the points.",
                        {"kernel": "KERNEL", "solver": "SOLVER", "normals_found": "NORMALS"},
                        {"kernel": "the kernel used", "polynomial_degree": "the degree used; -1 = none",
                         "outliers_found": "number of samples far from all others, or far from the plane of their neighbours",
                         "outliers_dropped": "number of these that were left out",
                         "value_residual_rms": "root mean square of abs(f(x_i)) at the centres",
                         "gradient_residual_rms": "root mean square of abs(grad f(x_i) - n_i) at the centres",
                         "input_distance_rms": "root mean square of the distances of the samples from the surface",
                         "bounds_max": "upper corner of the samples' box",
                         "noise_estimate": "standard deviation of the samples from their surface; 0 if no noise is seen, NaN if "
                                           "it was not measured",
                         "normals_inward": "whether the given normals all point into a closed surface"}),
    "TrimInfo": Record("trim_info", "What trimming left out.", {},
                       {"is_trimmed": "whether the surface ends somewhere; if not, every other field except `samples` and "
                                      "`spacing` is 0",
                        "farthest": "largest distance of a place that is left out from the samples, in the model's unit",
                        "spacing": "median distance of a sample to its sixth neighbour, in the model's unit"}),
    "OrientInfo": Record("orient_info", "What `orient` found and did.  Lengths are in the unit of the points.", {},
                         {"outward_by": "what decided which side is outward"}),
    "DepthImageInfo": Record("depth_image_info", "What `smooth_depth_image` found and did."),
    "CsgInfo": Record("csg_info", "What a CSG solid consists of.  All fields are 0 for a model that is not a CSG solid."),
    "PointSetInfo": Record("point_set_info", "What a point set holds.", {"distribution": "DISTRIBUTION", "seed_source": "SEED"},
                           {"distribution": "the distribution used", "origin": "add it to a layer's positions to get absolute places",
                            "bounds_max": "upper corner of the box"}),
    "LayerInfo": Record("layer_info", "What a layer of marks holds.", {},
                        {"name": "the layer's name, as given or that of its kind",
                         "strokes": "number of strokes that the marks form; 0 for stipples"}),
    "PlacementInfo": Record("placement_info", "What became of the candidates for marks: attempted = placed + all dropped."),
    "LineSetInfo": Record("line_set_info", "What making a line set did.", {},
                          {"triangles": "number of triangles of the mesh on which curves are looked for",
                           "lines": "number of lines that were found once, when the set was made",
                           "left_out": "share of the examined area that lies beyond the samples, 0 to 1; 0 without `support`. "
                                       "For a trimmed model, only a little of the area beyond its end is examined; see "
                                       "`Model.trim_info`"}),
    "DrawingInfo": Record("drawing_info", "What a drawing holds, and what making it did.", {},
                          {"items": "number of items drawn", "layers": "number of layers of the drawing; each has one ink and one "
                                                                       "class of marks",
                           "back": "number of marks of class back inside the frustum",
                           "silhouette": 'number of marks of class silhouette inside the frustum; "published" only'}),
    "DrawingLayerFields": Record(
        "drawing_layer_info", "A layer of a drawing: the ink of one layer of marks, from front marks or from contours.",
        {"mark_class": "CLASS"},
        {"mark_class": '"front" or "silhouette"', "item": "number of the item, from 0",
         "layer": "number of the layer in the item's point set; -1 for lines",
         "kind": "the kind of the layer of marks, or of the lines",
         "name": "the name of the layer of marks, or of the lines in the style", "shape": "", "ink": "straight RGBA, 0 to 1"},
        base=True),
    "MarkIdentity": Record("mark_identity", "The mark that an identity refers to.", {},
                           {"item": "number of the item, from 0", "layer": "number of the layer in the item's point set",
                            "mark": "number of the mark in that layer", "stroke": "number of its stroke; -1 if it has none",
                            "place": "place of the mark along its stroke"}),
    "PageInfo": Record("page_info", "What was written to a page."),
    "MeshInfo": Record("mesh_info", "What making a mesh found and did."),
    "MeshEdgesInfo": Record("mesh_edges_info", "The sharp edges of a mesh as a whole.  Lengths are in the mesh's unit."),
    "MeshFitInfo": Record(
        "mesh_fit_info", "What a fit to a mesh reached, by the last of its measurements.  Lengths are in the mesh's unit.", {},
        {"far": "the distance `far` that was used", "centres": "number of centres of the model",
         "surface_p99": "99 % of the surface is within this distance of the mesh",
         "surface_max": "largest distance of the surface from the mesh",
         "mesh_p99": "99 % of the mesh is within this distance of the surface",
         "mesh_max": "largest distance of the mesh from the surface"},
        ("reached", "tolerance", "far", "candidates", "centres", "off_surface_centres", "rounds", "supported",
         "surface_share", "surface_p99", "surface_max", "mesh_share", "mesh_p99", "mesh_max", "seconds_sample",
         "seconds_fit", "seconds_measure", "seconds_total", "sheets", "crease_length", "smooth_length", "cells",
         "poor_cells")),
    "Comparison": Record(
        "comparison", "How near a surface and a mesh are to each other.  Distances are in the mesh's unit; NaN without points.", {},
        {"surface_p99": "99 % of these distances are not larger", "surface_max": "largest of these distances",
         "mesh_p99": "99 % of these distances are not larger", "mesh_max": "largest of these distances",
         "normal_p99": "99 % of these angles are not larger"}),
    "MeshFacts": Record(
        "source_info", "Facts about a mesh, counted after vertices at the same place are joined.", {},
        {"components": "number of connected parts", "boundary_edges": "number of edges with one triangle",
         "holes": "number of closed lines that the boundary edges form",
         "non_manifold_edges": "number of edges with more than two triangles",
         "inconsistent_edges": "number of edges whose two triangles run the same way, so that one of them is turned over",
         "degenerate_triangles": "number of triangles without area",
         "duplicate_triangles": "number of triangles with the same corners as another one",
         "unused_vertices": "number of vertices without a triangle",
         "joined_vertices": "number of vertices at the same place as another one",
         "faces_not_finite": "number of triangles with a corner that is not finite",
         "parts_inside_out": "number of closed parts whose faces look inward; inside another part, such a part is a cavity"},
        ("components", "closed", "boundary_edges", "holes", "non_manifold_edges", "inconsistent_edges", "inside_out",
         "parts_inside_out", "degenerate_triangles", "duplicate_triangles", "unused_vertices", "joined_vertices",
         "faces_not_finite", "area", "volume"),
        {"holes": "boundary_loops", "non_manifold_edges": "nonmanifold_edges", "inconsistent_edges": "contrary_edges",
         "parts_inside_out": "components_inside_out", "degenerate_triangles": "degenerate_faces",
         "duplicate_triangles": "repeated_faces", "joined_vertices": "duplicates"}),
}  # fmt: skip


class Style(NamedTuple):
    """A class whose attributes are the fields of a struct.

    struct  the struct's name without "hrbfnpr_"
    hidden  fields that the package's class offers in another form
    words   by field: a description that replaces the header's comment
    """

    struct: str
    hidden: tuple
    words: dict = {}


STYLES = {
    "StyleFields": Style("style", ("tone", "tone_function", "tone_user", "layers", "layer_count", "layer_stride", "lines",
                                   "line_count", "line_stride", "lights", "light_count", "light_stride", "palette",
                                   "palette_count")),
    "LightFields": Style("light", ()),
    "LayerStyleFields": Style("layer_style", ("name", "directions", "density_field", "tone_field", "width_field", "ink_field",
                                                "mask_field")),
    "LineStyleFields": Style("line_style", ("name", "levels"), {
        "wobble_seed": "start of the random numbers of the wobble; any number; default 0",
        "upper": "a line is drawn if its strength is at least this somewhere; 0 together with `lower` 0 = the value of the kind"}),
}  # fmt: skip


_REQUIRED, _LIBRARYS = "required", "the library's"


class Row(NamedTuple):
    """A field that the caller sets.

    source   the struct's field, if its name differs; "": the package's class sets the field
    kind     as `kind_of` gives it; or text, ink, handle, or "array COMPONENTS CODES" as `block_in` of hrbfnpr/_arrays.py
             takes them
    type     the type in Python, if the kind does not imply it
    default  the default in Python, if it is not the one of the library's `_init` function
    words    a description that replaces the header's comment
    """

    name: str
    source: Optional[str] = None
    kind: Optional[str] = None
    type: Optional[str] = None
    default: Any = _LIBRARYS
    words: Optional[str] = None


class Described(NamedTuple):
    """A dataclass that a caller fills, and that the package copies into a struct."""

    struct: str
    doc: str
    rows: tuple
    examples: tuple = ()


_ARRAY = "Optional[Array]"
_TONE = ("Darkness at which the first mark is shown, and darkness at which all marks are shown, 0 to 1 each, for {}. None: as "
         "`tone_ranges` says")
_NAME = "the name by which styles and `PointSet.layer` refer to the layer; None: the kind"
DESCRIBED = {
    "PageItem": Described("page_item", "A drawing on a page.", (
        Row("drawing", kind="handle", type="Drawing", default=_REQUIRED, words="the drawing; what lies beyond its viewport is cut "
            "off"),
        Row("x", words="distance from the page's left edge to the viewport's, in mm"),
        Row("y", words="distance from the page's top edge to the viewport's, in mm"), Row("scale"),
        Row("name", kind="text", type="Optional[str]", default=None, words="the name of the group that holds the drawing"))),
    "Pen": Described("pen", "The pen for some groups of a page.", (
        Row("groups", kind="text", default="*", words="a group's name, or the beginning of names and a '*'. If several pens fit "
            "a group, the last one is taken"),
        Row("width"),
        Row("ink", kind="ink", type="Optional[Tuple[float, ...]]", default=None, words="red, green, blue and alpha, 0 to 1; "
            "None: as drawn"),
        Row("number", words="number of a plotter's pen, 1 to 255"),
        Row("line_type", words="as drawn, or a type of ISO 128-2"))),
    "Annotation": Described("annotation", "A line or a text beside the drawings of a page.", (
        Row("points", kind="array 2 fd", type="Array", default=_REQUIRED, words="the points of the line, in mm from the page's "
            "top left corner; for a text, the first row is the start of its baseline"),
        Row("text", kind="text", type="Optional[str]", default=None, words="the text; None: the points are a line"),
        Row("group", kind="text", default="annotations", words="the name of the group. Consecutive annotations of one group form "
            "one layer, in the ink and line type of the first"),
        Row("width"),
        Row("ink", kind="ink", type="Tuple[float, ...]", words="red, green, blue and alpha, 0 to 1; default black"),
        Row("line_type", words="as in `Pen`"))),
    "LinesFields": Described("line_desc", "Lines that are found once, when a `LineSet` is made.", (
        Row("kind", kind="LINE_KIND", words='"ridge", "valley", "parabolic", "section", "own", "soft_edge" or "tangent_edge"'),
        Row("name", kind="text", default="", words="the name by which `LineStyle.name` refers to the lines"),
        Row("lower"), Row("upper"), Row("shortest"),
        Row("plane", "", type="Sequence[float]", default=(0.0, 0.0, 1.0), words='for "section": the normal of the planes'),
        Row("levels", "", "array 1 d", "Sequence[float]", (), 'for "section": the positions of the planes along the unit normal, '
            "in the model's unit"),
        Row("polylines", "", "array 3 fd", "Sequence[Array]", (), 'for "own": the lines, on the surface or near it. A line is '
            "closed if its last point equals its first"))),
    "OwnLayerFields": Described("layer_arrays", "A layer of ready-made marks, for `PointSet.create`; the arrays are copied.", (
        Row("positions", "position", "array 3 fd", "Array", _REQUIRED, "absolute places of the marks, in the model's unit"),
        Row("normals", "normal", "array 3 fd", "Array", _REQUIRED, "outward normals, of any length except 0"),
        Row("name", kind="text", type="Optional[str]", default=None, words=_NAME),
        Row("kind", "", default="own", words='"own", "stipples" or "hatch"'),
        Row("stroke_first", None, "array 1 I", _ARRAY, None, "numbers that rise from 0 to n: stroke s has the marks "
            "stroke_first[s] to stroke_first[s + 1] - 1, from end to end. None: no strokes"),
        Row("stroke_directions", "stroke_direction", "array 1 B", _ARRAY, None, "0 for the first direction, 1 for the second; "
            "None: all 0"),
        Row("directions", "direction", "array 3 fd", _ARRAY, None, "directions of any length, not along the normal; None: along "
            "the stroke"),
        Row("curvatures", "curvature", "array 3 fd", _ARRAY, None, "k1, k2 and confidence; None: not known"),
        Row("ranks", "rank", "array 1 fd", _ARRAY, None, "ranks in [0, 1): a mark is shown where its rank is at least the tone. "
            "None: random, the same for all marks of a stroke"),
        Row("levels", "level", "array 1 B", _ARRAY, None, "refinement steps; None: all 0"),
        Row("widths", "width", "array 1 fd", _ARRAY, None, "widths in (0, 1], as factors of the style's radius; None: all 1"))),
    "LayerFields": Described("layer_desc", "How one layer of marks is made; see `PointSet.generate`.", (
        Row("kind", "", type="str", default="stipples", words='"stipples": scattered marks. "hatch": evenly spaced, nested '
            'lines along one smooth field of directions; with the distribution "published", strokes along these directions and '
            'across them [NPAR 5]'),
        Row("name", kind="text", type="Optional[str]", default=None, words=_NAME),
        Row("budget", "", "count", "Optional[int]", None, "largest number of marks. 0: no limit, for the distribution "
            '"published" and for lines with a separation. None: no limit for these, 40000 for others'),
        Row("tone", "", type="Optional[Interval]", default=None,
            words=_TONE.format('stipples, lines, and "published" strokes of the first direction')),
        Row("second_tone", "", type="Optional[Interval]", default=None,
            words=_TONE.format('"published" strokes of the second direction')),
        Row("with_curvature", "", type="bool", default=False, words="whether the marks keep their curvature; "
            '"published" strokes along curvature always do'),
        Row("density", "", type="Density", default="uniform", words='where "blue_noise" stipples are denser: "uniform", '
            '"curvature", a `Field` or a function. The function gets positions and unit normals, shape (n, 3) each, and returns n numbers '
            "from 0 (no stipples) to 1 (densest)"),
        Row("density_strength"), Row("separation", words='mean distance between neighbouring lines of "hatch", in the '
            "model's unit; 0: the distance at which the lines have about as many marks as the budget"),
        Row("step", words="distance between the marks of a line, in the model's unit; 0: 0.4 of the separation"),
        Row("direction", "", type="Optional[Direction]", default=None, words='a `Field`, or a function that gives the directions '
            'of "hatch" lines, instead of `guide`. The function gets positions and unit normals, shape (n, 3) each, and returns '
            "directions of the same shape. Their sign and length do not matter; (0, 0, 0) means no direction"),
        Row("start", words='where strokes of the distribution "published" start'),
        Row("start_level", words='for start "stipples": the last level of stipples at which strokes start, 0 to 12'),
        Row("levels", type="Optional[int]", default=None, words='number of refinement steps of the distribution "published", 0 to '
            "12. None: 4 for stipples, 3 for strokes. A stroke has 3^levels marks"),
        Row("angle", words='angle by which "hatch" lines are turned in the tangent plane, in degrees, counter-clockwise as seen '
            "from outside, -360 to 360"),
        Row("smoothing", words='distance over which the directions of "hatch" lines are smoothed, in diagonals of the model, '
            "1e-6 to 1; default 0.04. Larger values give calmer lines that follow the form less"),
        Row("axis", words='axis around which "hatch" lines run where the confidence of the curvature is low; default '
            "(0, 1, 0)"),
        Row("axis_weight", words="weight of the axis against the curvature, 0 to 1000; default 0.06"),
        Row("tone_smoothing", type="Optional[float]", default=None, words="distance over which the normals that set the tone are "
            "averaged, in diagonals of the model, 0 to 0.1. Larger: the grain of a rough surface makes fewer spots of light. 0: "
            'no averaging. None: 0.006 for "blue_noise" "hatch", 0 for others'),
        Row("guide", words='the directions that "hatch" lines follow if there is no `direction`. "curvature": the direction in '
            'which the surface bends most; "combing": Stark\'s combing direction; "sections": cuts by planes perpendicular to '
            '`axis`; "light": the direction to the light, in the tangent plane; "silhouette": along the silhouette, for places '
            "near it"),
        Row("guide_direction", words='direction to the light ("light") or to the eye ("silhouette"), in the model\'s coordinates'),
        Row("guide_weight", words='weight of a guide other than "curvature", 0 to 1; the curvature has the rest of 1')),
        ('>>> lines = hrbfnpr.Layer("hatch", name="fur", direction=lambda p, n: np.cross(n, (0, 0, 1)), separation=0.02)',
         '>>> marks = model.generate(["stipples", lines])')),
}  # fmt: skip


# ---- The header's words, for Python

_CLASSES = {"hrbfnpr_" + record.struct: name.replace("LayerFields", "LayerInfo") for name, record in RECORDS.items()}
_CALLS = {"hrbfnpr_model_fit_mesh": "`Model.fit_mesh`", "hrbfnpr_model_compare_mesh": "`Model.compare`",
          "hrbfnpr_mesh_create": "`Mesh`", "hrbfnpr_drawing_get_layer_info": "`Drawing.layers`"}  # fmt: skip
_NOT_NAMES = ("NULL", "NAME", "NONE_OF")


class Words:
    """Rewrites the header's comments for Python."""

    def __init__(self, api):
        self.names = names_of(api)
        self._docs = {group["prefix"][8:]: [one["doc"] for one in group["constants"]] for group in api["constants"]}
        self._plain = {name.upper() for names in self.names.values() for name in names if len(name) > 2} - set(_NOT_NAMES)

    def said(self, text):
        """A comment in terms of Python: PUBLISHED becomes "published", |f| becomes abs(f)."""
        text = re.sub(r"HRBFNPR_\w+_\.\.\.(?: of)?[:;,]?\s*", "", text)
        text = re.sub(r"(?:HRBFNPR_)?\b([A-Z][A-Z0-9_]+[A-Z0-9])\b", self._name, text)
        text = re.sub(r"\b(hrbfnpr_\w+?_info)\.(\w+)", lambda m: f"`{_CLASSES[m[1]]}.{m[2]}`", text)
        text = re.sub(r"\bhrbfnpr_\w+_desc\.(\w+)", r"`\1`", text)
        text = re.sub(r"\bhrbfnpr_line_desc\b", "`Lines`", text)
        text = re.sub(r"\bhrbfnpr_(layer|line)_style\b", lambda m: f"`{m[1].title()}Style`", text)
        text = re.sub(r"\bhrbfnpr_\w+", lambda m: _CALLS.get(m[0], m[0]), text)
        text = re.sub(r"\|([^|]+)\|", r"abs(\1)", text)
        return " ".join(text.replace(" .. ", " to ").split())

    def _name(self, found):
        word = found[1]
        if word in self._plain:
            return f'"{word.lower()}"'
        for prefix, names in self.names.items():
            if word.startswith(prefix + "_") and word[len(prefix) + 1 :].lower() in names:
                return f'{prefix.lower()} "{word[len(prefix) + 1 :].lower()}"'
        return found[0]

    def sentence(self, text):
        """A comment as a sentence, with a capital letter and a full stop."""
        text = re.sub(r"^mm\b", "millimetres", self.said(text).strip(" ;:,"))
        if re.match(r"[a-z]+(?![\w(]| >)", text):
            text = text[0].upper() + text[1:]
        return text + ("" if not text or text[-1] in ".!?" else ".")

    def choices(self, prefix, explained=True):
        """The names of a field's constants, each with the first sentence of its comment in the header."""
        parts = []
        for name, doc in zip(self.names[prefix], self._docs[prefix]):
            first = re.split(r"(?<=[a-z)\]])[.;:] ", " ".join(doc.split()) if explained else "")[0]
            parts.append(f'"{name}"' + (f" ({self.said(first).rstrip('.')})" if first else ""))
        return " or ".join([", ".join(parts[:-1]), parts[-1]])


def names_of(api):
    """For each prefix of constants: the names in lower case, and their numbers."""
    return {group["prefix"][8:]: {one["name"][len(group["prefix"]) + 1 :].lower(): one["value"] for one in group["constants"]}
            for group in api["constants"] if group["prefix"] != "HRBFNPR"}  # fmt: skip


# ---- Fields

_TYPES = {"flag": "bool", "number?": "Optional[float]", "number": "float", "count": "int", "text": "str"}


def kind_of(field, prefix):
    """How a field is read: a prefix of constants, flag, number, number? (NaN becomes None), count, text, or a number of numbers."""
    prefix = prefix or field.get("constants", "")[8:]
    if prefix:
        return prefix
    c, doc = field["type"]["c"], field["doc"]
    if c == "char":
        return "text"
    if field["array"]:
        return field["array"][0]
    if c in ("float", "double"):
        return "number?" if re.search(r"\bNaN\b", doc) else "number"
    return "flag" if doc.startswith(("1: ", "1 or 0: ")) else "count"


def type_of(kind):
    if isinstance(kind, int):
        return "Vector" if kind == 3 else f"Tuple[{', '.join(['float'] * kind)}]"
    return _TYPES.get(kind, "str")


def fields_of(struct, api):
    found = next(one for one in api["structs"] if one["name"] == f"hrbfnpr_{struct}")
    return {field["name"]: field for field in found["fields"]
            if field["name"] != "struct_size" and not re.fullmatch(r"reserved\d*", field["name"])}  # fmt: skip


def record_of(record, api, words):
    """For each field: its name in Python, the struct's field, the kind, and a description."""
    fields = fields_of(record.struct, api)
    rows = []
    for name in record.order or fields:
        source = record.renamed.get(name, name)
        field = fields[source]
        kind = kind_of(field, record.names.get(name))
        said = re.sub(r"^1: ", "whether ", record.words.get(name, field["doc"]))
        said = re.sub(r"\bNaN\b", "None", said) if kind == "number?" else said
        rows.append((name, source, kind, words.sentence(said)))
    return rows


def docstring(record, rows, words):
    """A docstring in NumPy style.  Consecutive fields without a description share a line."""
    lines, waiting = [record.doc, "", "Attributes", "----------"], []
    for i, (name, _, kind, said) in enumerate(rows):
        kind_in_words = "tuple of float" if isinstance(kind, int) else type_of(kind)
        if kind_in_words.startswith("Optional"):
            kind_in_words = "float or None"
        elif kind in words.names and not record.words.get(name):
            kind_in_words = "{" + ", ".join(f'"{one}"' for one in words.names[kind]) + "}"
        waiting.append(name)
        after = rows[i + 1] if i + 1 < len(rows) else None
        if not said and after is not None and not after[3] and after[2] == kind and type_of(kind) != "str":
            continue
        lines += textwrap.wrap(f"{', '.join(waiting)} : {kind_in_words}", WIDTH, subsequent_indent="        ")
        lines += textwrap.wrap(said, WIDTH - 4, initial_indent="    ", subsequent_indent="    ")
        waiting = []
    return "\n".join(lines) + "\n"


def described_of(described, api, words):
    """For each field: its name, the struct's field, the kind, the type, the default, and a description."""
    fields, rows = fields_of(described.struct, api), []
    for row in described.rows:
        field = fields.get(row.source or row.name)
        kind = row.kind or (kind_of(field, None) if field and not row.type == "Sequence[float]" else "count")
        kind = "vector" if kind == 3 else kind.replace("?", "")
        kind_type = {"vector": "Vector", "text": "str"}.get(kind) or type_of(kind)
        said = words.sentence(field["doc"] if row.words is None else row.words)
        source = row.name if row.source is None else row.source
        rows.append((row.name, source, kind, row.type or kind_type, row.default, said))
    return rows


def described_doc(described, rows, words):
    lines = [described.doc, "", "Attributes", "----------"]
    for name, source, kind, kind_type, default, said in rows:
        optional = kind_type.startswith("Optional")
        plain = kind_type[9:-1] if optional else kind_type
        if plain == "Array":
            _, components, codes = kind.split()
            size = "s + 1" if name == "stroke_first" else "s" if name.startswith("stroke") else "n"
            row = "" if components == "1" else f" {components}"
            plain = f"array of {'float' if codes == 'fd' else 'int'}, shape ({size},{row})"
        elif kind in words.names and source:
            names = ", ".join(f'"{one}"' for one in words.names[kind])
            plain = "str" if kind == "LINE_KIND" or len(names) > WIDTH else "{" + names + "}"
            if kind != "LINE_KIND" and plain == "str":
                said += f" One of {names}."
        else:
            plain = {"Vector": "(x, y, z)", "Interval": "(begin, end)", "Tuple[float, ...]": "tuple of float",
                     "Density": "str, Field or callable", "Direction": "Field or callable", "Sequence[float]": "sequence of float",
                     "Sequence[Array]": "sequence of array of float, shape (n, 3)"}.get(plain, plain)  # fmt: skip
        lines += textwrap.wrap(f"{name} : {plain}{', optional' if optional else ''}", WIDTH, subsequent_indent="        ")
        lines += textwrap.wrap(said, WIDTH - 4, initial_indent="    ", subsequent_indent="    ")
    if described.examples:
        lines += ["", "Examples", "--------", *described.examples]
    return "\n".join(lines) + "\n"


def style_of(style, api, words):
    """For each attribute: the field, the kind, and a description."""
    rows = []
    for name, field in fields_of(style.struct, api).items():
        if name in style.hidden:
            continue
        kind = kind_of(field, None).replace("?", "") if not field["array"] else "color" if field["array"] == [4] else "vector"
        said = words.sentence(style.words.get(name, re.sub(r"^1 or 0: ", "", field["doc"])))
        if kind in words.names:
            found = re.match(r'([^.]*?),? ?[Dd]efault ("\w+")(?:$|\. ?)', said) or re.match(r'()("\w+")(?:$|[.;] ?)', said)
            choices = words.choices(kind, name != "kind")
            if found:
                what = f"{found[1]}: " if found[1] else ""
                said = f"{what}{choices}. Default {found[2]}. {said[found.end():]}".strip()
            else:
                said = f"{choices}. {said}"
        rows.append((name, kind, said))
    return rows


# ---- The files


def data(api):
    words, everything = Words(api), {"names": names_of(api), "records": {}, "described": {}, "styles": {}}
    for name, record in RECORDS.items():
        rows = record_of(record, api, words)
        fields = [[field, source, kind] for field, source, kind, _ in rows]
        everything["records"][name] = {"struct": record.struct, "doc": docstring(record, rows, words), "fields": fields}
    for name, described in DESCRIBED.items():
        rows = described_of(described, api, words)
        everything["described"][name] = {
            "struct": described.struct, "doc": described_doc(described, rows, words), "fields": [row[:4] for row in rows],
            "required": [row[0] for row in rows if row[4] == _REQUIRED],
            "defaults": {row[0]: row[4] for row in rows if row[4] not in (_REQUIRED, _LIBRARYS)},
        }  # fmt: skip
    for name, style in STYLES.items():
        everything["styles"][name] = style_of(style, api, words)
    return everything


def one_a_line(everything):
    """JSON with one line for each entry of each part, so that diffs are readable."""
    parts = []
    for part, entries in everything.items():
        lines = (f"  {json.dumps(name)}: {json.dumps(entry, ensure_ascii=False)}" for name, entry in entries.items())
        parts.append(f" {json.dumps(part)}: {{\n" + ",\n".join(lines) + "\n }")
    return "{\n" + ",\n".join(parts) + "\n}\n"


_FIELD_TYPES = {"color": "Field[Tuple[float, ...], Color]", "vector": "Field[Tuple[float, ...], Sequence[float]]",
                "flag": "Field[bool, bool]", "count": "Field[int, int]", "number": "Field[float, float]"}  # fmt: skip


def quoted(text, indent):
    body = text.replace("\\", "\\\\").rstrip("\n")
    end = f"\n{indent}" if "\n" in body else ""
    return f'{indent}"""' + textwrap.indent(body, indent).lstrip() + f'{end}"""\n'


def stub(everything):
    parts = [NOTE, '"""The classes that _records.py makes from _records.json."""\nfrom dataclasses import dataclass\n',
             "from typing import Any, Callable, List, Optional, Sequence, Tuple, Type, TypeVar, Union\n\n",
             "from ._arrays import Array\nfrom ._drawing import Drawing\nfrom ._fields import Attributes, Color, Field\n"
             "from ._surface_field import Field as SurfaceField\n\n",
             "T = TypeVar(\"T\")\nVector = Tuple[float, float, float]\nInterval = Tuple[float, float]\n",
             "Density = Union[str, SurfaceField, Callable[[Array, Array], Array]]\n"
             "Direction = Union[SurfaceField, Callable[[Array, Array], Array]]\n\n",
             "def read(kind: Type[T], struct: Any, /, **known: Any) -> T: ...\n",
             "def get(kind: Type[T], function: Callable[..., int], *arguments: Any) -> T: ...\n",
             "def text_in(keep: List[Any], text: Optional[str]) -> Any: ...\n",
             "def fill(target: Any, described: Any, keep: List[Any], about: str = ...) -> None: ...\n",
             "def fill_list(desc: Any, name: str, kind: type, given: Sequence[Any], keep: List[Any]) -> None: ...\n"]  # fmt: skip
    for name, entry in everything["records"].items():
        parts.append(f"\n@dataclass(frozen=True)\nclass {name}:\n{quoted(entry['doc'], '    ')}\n")
        parts += [f"    {field}: {type_of(kind)}\n" for field, _, kind in entry["fields"]]
    for name, entry in everything["described"].items():
        parts.append(f"\n@dataclass\nclass {name}:\n{quoted(entry['doc'], '    ')}\n")
        for field, _, _, kind in entry["fields"]:
            parts.append(f"    {field}: {kind}{'' if field in entry['required'] else ' = ...'}\n")
    for name, rows in everything["styles"].items():
        parts.append(f"\nclass {name}(Attributes):\n")
        parts += [f"    {field}: {_FIELD_TYPES.get(kind, 'Field[str, str]')}\n" for field, kind, _ in rows]
    return "".join(parts)


def outputs(api):
    """The text of each file, by path."""
    everything = data(api)
    return {HERE / "hrbfnpr/_records.json": one_a_line(everything), HERE / "hrbfnpr/_records.pyi": stub(everything)}
