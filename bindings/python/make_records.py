# SPDX-License-Identifier: MIT
"""hrbfnpr/_records.json and hrbfnpr/_records.pyi: names, records, descriptions and styles as the Python package has them.

bindings/generate runs it.  The package makes classes of the .json when it is imported (hrbfnpr/_records.py); the .pyi tells
type checkers and editors what these classes are.  Both are made from the header and from the tables below, which hold
what is of Python alone, and are committed.
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

    names    by field: the prefix of the constants that it takes, where the header's comment does not name it
    words    by field: words in place of the header's comment
    renamed  by the name in Python: the struct's field, where that differs; then these alone, and `order`, are fields
    """

    struct: str
    doc: str
    names: dict = {}
    words: dict = {}
    order: tuple = ()
    renamed: dict = {}
    base: bool = False  # whether the package derives its class from this one


_AS_USED = "as used"
_SAME_FROM_SURFACE = "of the mesh: the same from the surface"
RECORDS = {
    "ContextInfo": Record("context_info", "What a context really uses.",
                          {"thread_backend": "THREAD_BACKEND", "instruction_set": "INSTRUCTION_SET"},
                          {"thread_backend": 'who runs the tasks of a large call: "pool", "openmp", "run_tasks" or "serial"',
                           "instruction_set": 'the one in use, such as "avx2"'},
                          ("thread_count", "thread_backend", "instruction_set", "bytes_now", "bytes_peak")),
    "ModelInfo": Record("model_info", "What a fit did.  Lengths are in the unit of the points.",
                        {"kernel": "KERNEL", "solver": "SOLVER", "normals_found": "NORMALS"},
                        {"kernel": _AS_USED, "polynomial_degree": _AS_USED,
                         "outliers_found": "samples far from all others, or from the plane of those around them",
                         "outliers_dropped": "of these, left out",
                         "value_residual_rms": "root mean square of the same",
                         "gradient_residual_rms": "root mean square of the same",
                         "input_distance_rms": "root mean square of the same",
                         "bounds_max": "the box's other corner",
                         "noise_estimate": "standard deviation of the samples off their surface; 0 if none is seen, NaN if "
                                           "nobody asked",
                         "normals_inward": "whether normals as given all point into a closed surface"}),
    "TrimInfo": Record("trim_info", "What trimming left out.", {},
                       {"is_trimmed": "whether the surface ends somewhere; if not, all else is 0 but `samples` and `spacing`",
                        "farthest": "of the places left out from the samples, in units of the model",
                        "spacing": "of the samples: the median of how far their sixth neighbours are"}),
    "OrientInfo": Record("orient_info", "What `orient` found and did.  Lengths are in the unit of the points.", {},
                         {"outward_by": "what decided which side is outward"}),
    "DepthImageInfo": Record("depth_image_info", "What `smooth_depth_image` found and did."),
    "CsgInfo": Record("csg_info", "What a solid is made of; all 0 for a model that is not put together from others."),
    "PointSetInfo": Record("point_set_info", "A point set.", {"distribution": "DISTRIBUTION", "seed_source": "SEED"},
                           {"distribution": _AS_USED, "origin": "add it to positions",
                            "bounds_max": "the box's other corner"}),
    "LayerInfo": Record("layer_info", "One layer of marks.", {}, {"name": "as it was given, or its kind",
                                                                   "strokes": "that the marks form; 0 for stipples"}),
    "PlacementInfo": Record("placement_info", "What became of candidates for marks: attempted = placed + all dropped."),
    "LineSetInfo": Record("line_set_info", "What making a line set did.", {},
                          {"triangles": "of the mesh that curves are looked for on", "lines": "lines that were found once",
                           "left_out": "the share of the area that was looked at that lies beyond its samples, 0 to 1; 0 "
                                       "without `support`. Of a trimmed model little beyond its end is looked at: see "
                                       "`Model.trim_info`"}),
    "DrawingInfo": Record("drawing_info", "What a drawing holds, and what making it did.", {},
                          {"items": "items drawn", "layers": "layers of the drawing, of one ink and one class each",
                           "back": "of those inside, too", "silhouette": "of those inside, too"}),
    "DrawingLayerFields": Record(
        "drawing_layer_info", "A layer of a drawing: ink of one layer of marks, of the front or of contours.",
        {"mark_class": "CLASS"},
        {"mark_class": '"front" or "silhouette"', "item": "number of the item",
         "layer": "number of the layer of its point set; -1: of lines", "kind": "of that layer, or the kind of lines",
         "name": "of that layer, or the name in the style of the lines", "shape": "", "ink": "straight RGBA"}, base=True),
    "MarkIdentity": Record("mark_identity", "The mark that an id stands for.", {},
                           {"item": "number of the item", "layer": "number of the layer of its point set",
                            "mark": "its number in that layer", "stroke": "number of its stroke, -1 for none",
                            "place": "its place along that"}),
    "PageInfo": Record("page_info", "What was written."),
    "MeshInfo": Record("mesh_info", "What making a mesh found, and did."),
    "MeshEdgesInfo": Record("mesh_edges_info", "The sharp edges of a mesh as a whole; lengths are in units of the mesh."),
    "MeshFitInfo": Record(
        "mesh_fit_info", "What a fit to a mesh came to: the last of the measurements that it went by.", {},
        {"far": _AS_USED, "centres": "as many as the model has", 
         "surface_p99": "99 % of the surface are not farther from the mesh",
         "surface_max": "the greatest distance of the surface from the mesh", "mesh_p99": _SAME_FROM_SURFACE,
         "mesh_max": _SAME_FROM_SURFACE},
        ("reached", "tolerance", "far", "candidates", "centres", "off_surface_centres", "rounds", "supported",
         "surface_share", "surface_p99", "surface_max", "mesh_share", "mesh_p99", "mesh_max", "seconds_sample",
         "seconds_fit", "seconds_measure", "seconds_total", "sheets", "crease_length", "smooth_length", "cells",
         "poor_cells")),
    "Comparison": Record(
        "comparison", "How near a surface is to a mesh, both ways; distances are in units of the mesh, NaN of no points.", {},
        {"surface_p99": "99 % are not farther", "surface_max": "the greatest of them", "mesh_p99": "99 % are not farther",
         "mesh_max": "the greatest of them", "normal_p99": "99 % are not above"}),
    "MeshFacts": Record(
        "source_info", "What a mesh is like, counted after vertices at the same place are joined.", {},
        {"components": "parts that no edge joins", "boundary_edges": "edges of one triangle",
         "holes": "the lines that these make", "non_manifold_edges": "edges of more than two triangles",
         "inconsistent_edges": "edges whose two triangles run the same way: one of them is turned over",
         "degenerate_triangles": "triangles without area", "duplicate_triangles": "triangles with the corners of another",
         "unused_vertices": "vertices of no triangle", "joined_vertices": "vertices at the place of another",
         "faces_not_finite": "triangles with a corner that is not finite",
         "parts_inside_out": "closed parts whose faces look inward; one in another is a cavity"},
        ("components", "closed", "boundary_edges", "holes", "non_manifold_edges", "inconsistent_edges", "inside_out",
         "parts_inside_out", "degenerate_triangles", "duplicate_triangles", "unused_vertices", "joined_vertices",
         "faces_not_finite", "area", "volume"),
        {"holes": "boundary_loops", "non_manifold_edges": "nonmanifold_edges", "inconsistent_edges": "contrary_edges",
         "parts_inside_out": "components_inside_out", "degenerate_triangles": "degenerate_faces",
         "duplicate_triangles": "repeated_faces", "joined_vertices": "duplicates"}),
}  # fmt: skip


class Style(NamedTuple):
    """Attributes that are fields of a struct that is kept.

    hidden  fields that the package's own class has in another form
    """

    struct: str
    hidden: tuple
    words: dict = {}


STYLES = {
    "StyleFields": Style("style", ("tone", "tone_function", "tone_user", "layers", "layer_count", "layer_stride", "lines",
                                   "line_count", "line_stride")),
    "LayerStyleFields": Style("layer_style", ("name", "directions")),
    "LineStyleFields": Style("line_style", ("name", "levels"), {
        "wobble_seed": "which of many wobbles; 0",
        "upper": "a line is drawn if its strength is at least this somewhere; 0 with `lower` 0 = that of the kind"}),
}  # fmt: skip


_REQUIRED, _LIBRARYS = "required", "the library's"


class Row(NamedTuple):
    """A field of what a caller describes.

    source   the struct's field, if it has another name; "" of what the package's own class puts there
    kind     as `kind_of` has it; or text, ink, handle, or "array COMPONENTS CODES" as block_in of hrbfnpr/_arrays.py has them
    type     in Python, where the kind does not say it
    default  of Python; that of the library's `_init` function by itself
    words    in place of the header's comment
    """

    name: str
    source: Optional[str] = None
    kind: Optional[str] = None
    type: Optional[str] = None
    default: Any = _LIBRARYS
    words: Optional[str] = None


class Described(NamedTuple):
    """A dataclass that a caller fills, and the package puts into a struct."""

    struct: str
    doc: str
    rows: tuple
    examples: tuple = ()


_ARRAY = "Optional[Array]"
_TONE = "The darkness at which the first mark is shown, and that at which all are: of {}; None: as `tone_ranges` says"
DESCRIBED = {
    "PageItem": Described("page_item", "A drawing on a page.", (
        Row("drawing", kind="handle", type="Drawing", default=_REQUIRED),
        Row("x", words="millimetres from the page's left edge to the viewport's"),
        Row("y", words="millimetres from the page's top edge to the viewport's"), Row("scale"),
        Row("name", kind="text", type="Optional[str]", default=None, words="of the group around it"))),
    "Pen": Described("pen", "What some groups of a page are drawn with.", (
        Row("groups", kind="text", default="*", words="a group's name, or the beginning of names and a '*'. Of pens that fit a "
            "group the last one is taken"),
        Row("width"),
        Row("ink", kind="ink", type="Optional[Tuple[float, ...]]", default=None, words="red, green, blue and alpha, from 0 to 1; "
            "None = as drawn"),
        Row("number", words="of a plotter's pen, from 1 to 255"), Row("line_type", words="as drawn, or a type of ISO 128-2"))),
    "Annotation": Described("annotation", "A line or a text beside the drawings of a page.", (
        Row("points", kind="array 2 fd", type="Array", default=_REQUIRED, words="millimetres: the line, or in its first row "
            "where the text's baseline begins"),
        Row("text", kind="text", type="Optional[str]", default=None, words="None: the points are a line"),
        Row("group", kind="text", default="annotations", words="annotations of one group that follow each other are one layer, "
            "in the ink and line type of the first"),
        Row("width"),
        Row("ink", kind="ink", type="Tuple[float, ...]", words="red, green, blue and alpha, from 0 to 1; black"),
        Row("line_type", words="as of `Pen`"))),
    "LinesFields": Described("line_desc", "Lines that are found once, when a `LineSet` is made.", (
        Row("kind", kind="LINE_KIND", words='"ridge", "valley", "parabolic", "section" or "own"'),
        Row("name", kind="text", default="", words="for `LineStyle.name`"), Row("lower"), Row("upper"), Row("shortest"),
        Row("plane", "", type="Sequence[float]", default=(0.0, 0.0, 1.0), words="of sections: the normal of the planes"),
        Row("levels", "", "array 1 d", "Sequence[float]", (), "of sections: where the planes are along the unit normal"),
        Row("polylines", "", "array 3 fd", "Sequence[Array]", (), "of own lines: on the surface or near it; closed if the last "
            "point is the first"))),
    "OwnLayerFields": Described("layer_arrays", "A layer of ready-made marks, for `PointSet.create`; the arrays are copied.", (
        Row("positions", "position", "array 3 fd", "Array", _REQUIRED),
        Row("normals", "normal", "array 3 fd", "Array", _REQUIRED),
        Row("name", kind="text", type="Optional[str]", default=None, words="as styles and `PointSet.layer` call it; the kind if "
            "None"),
        Row("kind", "", default="own", words='"own", "stipples" or "hatch"'),
        Row("stroke_first", None, "array 1 I", _ARRAY, None, "rising from 0 to n: stroke s has the marks stroke_first[s] up to "
            "stroke_first[s + 1] - 1, from end to end. None: no strokes"),
        Row("stroke_directions", "stroke_direction", "array 1 B", _ARRAY, None, "0 the first direction, 1 the second; 0 if None"),
        Row("directions", "direction", "array 3 fd", _ARRAY, None, "unit, tangent; along the stroke if None"),
        Row("curvatures", "curvature", "array 3 fd", _ARRAY, None, "k1, k2, confidence"),
        Row("ranks", "rank", "array 1 fd", _ARRAY, None, "in [0, 1); random, the same for all marks of a stroke, if None"),
        Row("levels", "level", "array 1 B", _ARRAY, None, "the refinement step of each; 0 if None"),
        Row("widths", "width", "array 1 fd", _ARRAY, None, "in (0, 1]; 1 if None"))),
    "LayerFields": Described("layer_desc", "How one layer of marks is made; see `PointSet.generate`.", (
        Row("kind", "", type="str", default="stipples", words='"stipples": scattered marks; "hatch": evenly spaced, '
            'nested lines along one smooth field of directions, or, with the distribution "published", strokes along these '
            'directions and across them [NPAR 5]'),
        Row("name", kind="text", type="Optional[str]", default=None, words="as styles and `PointSet.layer` call it; the kind if "
            "None"),
        Row("budget", "", "count", "Optional[int]", None, "the most marks; 0 = no limit, for the "
            'distribution "published" and lines with a separation. None = no limit for these, and 40000 for others'),
        Row("tone", "", type="Optional[Interval]", default=None,
            words=_TONE.format('stipples, lines, and "published" strokes of the first direction')),
        Row("second_tone", "", type="Optional[Interval]", default=None, words=_TONE.format('"published" strokes of the second direction')),
        Row("with_curvature", "", type="bool", default=False, words="whether its marks shall know their curvature; "
            '"published" strokes along curvature always do'),
        Row("density", "", type="Density", default="uniform", words='"uniform", "curvature" or a function: where "blue_noise" '
            "stipples are denser. A function gets positions and unit normals, shape (n, 3) each, and returns n numbers from 0 "
            "(none) to 1 (densest)"),
        Row("density_strength"), Row("separation", words='mean distance of neighbouring lines of "hatch", in the unit of '
            "the model; 0 = as many lines as make about the budget's marks"),
        Row("step", words="distance of the marks of a line; 0 = 0.4 of the separation"),
        Row("direction", "", type="Optional[Direction]", default=None, words='what lines of "hatch" follow in place of '
            "`guide`. It gets positions and unit normals, shape (n, 3) each, and returns directions of the same shape: "
            "their sign and length count nothing, 0 0 0 is none"),
        Row("start", words='what strokes of the distribution "published" start from'),
        Row("start_level", words='with "stipples", the last stippling level used'),
        Row("levels", type="Optional[int]", default=None, words='refinement steps of the distribution "published", 0 to 12; None '
            "= 4 for stipples and 3 for strokes, which have 3^levels marks"),
        Row("angle", words='degrees by which lines of "hatch" are turned in the tangent plane, counter-clockwise from outside'),
        Row("smoothing", words='over so long a way directions of "hatch" are smoothed; in diagonals of the model, 1 at most'),
        Row("axis", words='where curvature says little lines of "hatch" run around this'),
        Row("axis_weight", words="how much that counts against curvature"),
        Row("tone_smoothing", type="Optional[float]", default=None, words="over so much of the surface the normals that tone "
            "goes by are averaged, so that the grain of a rough one makes no islands of light; in diagonals, 0.1 at most, 0 = "
            'not; None = 0.006 for "blue_noise" "hatch", 0 for others'),
        Row("guide", words='what lines of "hatch" follow where no `direction` is given: the direction in which the surface bends '
            "most, Stark's first one, sections by planes across `axis`, away from a light, or as the silhouette"),
        Row("guide_direction", words='towards the light of "light", or the eye of "silhouette", in the model\'s own space'),
        Row("guide_weight", words="0 to 1: of a guide other than \"curvature\"; what is left of 1 is curvature's")),
        ('>>> lines = hrbfnpr.Layer("hatch", name="fur", direction=lambda p, n: np.cross(n, (0, 0, 1)), separation=0.02)',
         '>>> marks = model.generate(["stipples", lines])')),
}  # fmt: skip


# ---- Words of the header as those of Python

_CLASSES = {"hrbfnpr_" + record.struct: name.replace("LayerFields", "LayerInfo") for name, record in RECORDS.items()}
_CALLS = {"hrbfnpr_model_fit_mesh": "`Model.fit_mesh`", "hrbfnpr_model_compare_mesh": "`Model.compare`",
          "hrbfnpr_mesh_create": "`Mesh`", "hrbfnpr_drawing_get_layer_info": "`Drawing.layers`"}  # fmt: skip
_NOT_NAMES = ("NULL", "NAME", "NONE_OF")


class Words:
    """Rewrites comments of the header."""

    def __init__(self, api):
        self.names = names_of(api)
        self._docs = {group["prefix"][8:]: [one["doc"] for one in group["constants"]] for group in api["constants"]}
        self._plain = {name.upper() for names in self.names.values() for name in names if len(name) > 2} - set(_NOT_NAMES)

    def said(self, text):
        """A comment without what only C has: PUBLISHED is "published", |f| is abs(f)."""
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
        """With a capital letter and a full stop."""
        text = re.sub(r"^mm\b", "millimetres", self.said(text).strip(" ;:,"))
        if re.match(r"[a-z]+(?![\w(]| >)", text):
            text = text[0].upper() + text[1:]
        return text + ("" if not text or text[-1] in ".!?" else ".")

    def choices(self, prefix, explained=True):
        """The names of a field's constants, with what the header says of each."""
        parts = []
        for name, doc in zip(self.names[prefix], self._docs[prefix]):
            first = re.split(r"(?<=[a-z)\]])[.;:] ", " ".join(doc.split()) if explained else "")[0]
            parts.append(f'"{name}"' + (f" ({self.said(first).rstrip('.')})" if first else ""))
        return " or ".join([", ".join(parts[:-1]), parts[-1]])


def names_of(api):
    """By the prefix of constants: their names in lower case, and numbers."""
    return {group["prefix"][8:]: {one["name"][len(group["prefix"]) + 1 :].lower(): one["value"] for one in group["constants"]}
            for group in api["constants"] if group["prefix"] != "HRBFNPR"}  # fmt: skip


# ---- Fields

_TYPES = {"flag": "bool", "number?": "Optional[float]", "number": "float", "count": "int", "text": "str"}


def kind_of(field, prefix):
    """How a field is read: a prefix of constants, flag, number, number? (NaN is None), count, text, or how many numbers."""
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
    """(name in Python, field of the struct, kind, what it is) of each field."""
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
    """In the form of NumPy's; fields that follow each other and need no words share a line."""
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
    """(name, field of the struct, kind, type, default, what it is) of each field."""
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
            plain = "{" + ", ".join(f'"{one}"' for one in words.names[kind]) + "}" if kind != "LINE_KIND" else "str"
        else:
            plain = {"Vector": "(x, y, z)", "Interval": "(begin, end)", "Tuple[float, ...]": "tuple of float",
                     "Density": "str or callable", "Direction": "callable", "Sequence[float]": "sequence of float",
                     "Sequence[Array]": "sequence of array of float, shape (n, 3)"}.get(plain, plain)  # fmt: skip
        lines += textwrap.wrap(f"{name} : {plain}{', optional' if optional else ''}", WIDTH, subsequent_indent="        ")
        lines += textwrap.wrap(said, WIDTH - 4, initial_indent="    ", subsequent_indent="    ")
    if described.examples:
        lines += ["", "Examples", "--------", *described.examples]
    return "\n".join(lines) + "\n"


def style_of(style, api, words):
    """(field, kind, what it is) of each attribute."""
    rows = []
    for name, field in fields_of(style.struct, api).items():
        if name in style.hidden:
            continue
        kind = kind_of(field, None).replace("?", "") if not field["array"] else "color" if field["array"] == [4] else "vector"
        said = words.sentence(style.words.get(name, re.sub(r"^1 or 0: ", "", field["doc"])))
        if kind in words.names:
            default = re.match(r'("\w+")(?:$|[.;] ?)', said)
            said = f"{default[1]} by default. {said[default.end():]}".strip() if default else said
            said = f"{words.choices(kind, name != 'kind')}. {said}"
        rows.append((name, kind, said))
    return rows


# ---- What is written


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
    """JSON with a line for each entry of each part, so that changes can be read."""
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
    parts = [NOTE, '"""Classes that _records.py makes of _records.json."""\nfrom dataclasses import dataclass\n',
             "from typing import Any, Callable, List, Optional, Sequence, Tuple, Type, TypeVar, Union\n\n",
             "from ._arrays import Array\nfrom ._drawing import Drawing\nfrom ._fields import Attributes, Color, Field\n\n",
             "T = TypeVar(\"T\")\nVector = Tuple[float, float, float]\nInterval = Tuple[float, float]\n",
             "Density = Union[str, Callable[[Array, Array], Array]]\nDirection = Callable[[Array, Array], Array]\n\n",
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
    """The text of each file."""
    everything = data(api)
    return {HERE / "hrbfnpr/_records.json": one_a_line(everything), HERE / "hrbfnpr/_records.pyi": stub(everything)}
