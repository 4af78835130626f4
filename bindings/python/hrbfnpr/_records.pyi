# SPDX-License-Identifier: MIT
# Made by make_records.py from include/hrbfnpr.h; do not edit.
"""The classes that _records.py makes from _records.json."""
from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from ._arrays import Array
from ._drawing import Drawing
from ._fields import Attributes, Color, Field
from ._surface_field import Field as SurfaceField

T = TypeVar("T")
Vector = Tuple[float, float, float]
Interval = Tuple[float, float]
Density = Union[str, SurfaceField, Callable[[Array, Array], Array]]
Direction = Union[SurfaceField, Callable[[Array, Array], Array]]

def read(kind: Type[T], struct: Any, /, **known: Any) -> T: ...
def get(kind: Type[T], function: Callable[..., int], *arguments: Any) -> T: ...
def text_in(keep: List[Any], text: Optional[str]) -> Any: ...
def fill(target: Any, described: Any, keep: List[Any], about: str = ...) -> None: ...
def fill_list(desc: Any, name: str, kind: type, given: Sequence[Any], keep: List[Any]) -> None: ...

@dataclass(frozen=True)
class ContextInfo:
    """What a context uses.

    Attributes
    ----------
    thread_count : int
        Number of threads that a large call uses.
    thread_backend : str
        What runs the tasks of a large call: "pool", "openmp", "run_tasks" or "serial".
    instruction_set : str
        The instruction set in use, such as "avx2".
    bytes_now : int
        Bytes that are allocated through this context now.
    bytes_peak : int
        The largest number of bytes that were ever allocated at the same time.
    """

    thread_count: int
    thread_backend: str
    instruction_set: str
    bytes_now: int
    bytes_peak: int

@dataclass(frozen=True)
class ModelInfo:
    """What a fit did.  Lengths are in the unit of the points.

    Attributes
    ----------
    kernel : str
        The kernel used.
    polynomial_degree : int
        The degree used; -1 = none.
    choice_rounds : int
        Number of fits that were made to choose the centres; 0 if all samples are centres.
    samples : int
        Number of samples as given.
    centres : int
        Number of centres, after merging, repairing and choosing.
    merged_samples : int
        Number of samples that were merged into another one at the same place.
    near_duplicates : int
        Number of samples that were merged into another one much nearer than the spacing.
    rescaled_normals : int
        Number of normals whose length differed from 1 by more than 1e-4.
    outliers_found : int
        Number of samples far from all others, or far from the plane of their neighbours.
    outliers_dropped : int
        Number of these that were left out.
    flipped_found : int
        Number of normals that are opposite to those of their neighbours.
    flipped_repaired : int
        Number of these that were left out or turned round.
    bounds_min : tuple of float
        Lower corner of the samples' box. For up to 20 000 samples along curves, or 100 others, it also holds the
        surface, if that closes within a third of a diagonal.
    bounds_max : tuple of float
        Upper corner of the samples' box.
    spacing : float
        Mean distance of a sample to its nearest neighbour.
    kernel_radius : float
        The one used; 0 for "triharmonic".
    regularization : float
        The one used; with "auto", that of the values.
    noise_estimate : float or None
        Standard deviation of the samples from their surface; 0 if no noise is seen, None if it was not measured.
    value_residual_max : float
        Largest abs(f(x_i)) at the centres.
    value_residual_rms : float
        Root mean square of abs(f(x_i)) at the centres.
    gradient_residual_max : float
        Largest abs(grad f(x_i) - n_i) at the centres.
    gradient_residual_rms : float
        Root mean square of abs(grad f(x_i) - n_i) at the centres.
    input_distance_max : float
        Largest distance abs(f) / abs(grad f) of a sample from the surface; dropped ones do not count.
    input_distance_rms : float
        Root mean square of the distances of the samples from the surface.
    input_share_within : float or None
        Share of all samples that lie within the tolerance; a dropped sample counts as outside; None with tolerance
        0.
    solver : {"auto", "direct", "iterative"}
        The one used.
    solver_reason : {"requested", "small", "large", "not_converged", "not_definite"}
        Why it was used.
    iterations : int
        Number of refinement steps of "direct", or of steps of "iterative".
    fallback : bool
        Whether the matrix was not definite, and LU with pivoting was used.
    solver_residual : float
        Relative residual of the linear system, in the 2-norm.
    condition_estimate : float
        Condition of the matrix in the 1-norm ("direct"), or of the preconditioned matrix in the 2-norm
        ("iterative").
    seconds_clean : float
        Time of finding duplicates, outliers, flipped normals and noise.
    seconds_choose : float
        Time of all rounds that chose centres, without the last fit.
    seconds_assemble : float
        Time of reading the samples and assembling the matrix.
    seconds_precondition : float
        Time of making the preconditioner.
    seconds_solve : float
        Time of solving.
    seconds_total : float
        Time of the whole fit.
    bytes : int
        Memory that the model keeps.
    peak_bytes : int
        Largest number of bytes allocated at the same time through the context, up to the fit's end.
    normals_found : {"given", "none", "unoriented", "mixed", "inward", "auto"}
        `OrientInfo.found`, if the fit had a normal_mode; else "given".
    normals_inward : bool
        Whether the given normals all point into a closed surface.
    normals_turned : int
        `OrientInfo.turned`.
    normals_confidence : float or None
        `OrientInfo.confidence`; None without a normal_mode.
    seconds_orient : float
        Time of making the normals.
    """

    kernel: str
    polynomial_degree: int
    choice_rounds: int
    samples: int
    centres: int
    merged_samples: int
    near_duplicates: int
    rescaled_normals: int
    outliers_found: int
    outliers_dropped: int
    flipped_found: int
    flipped_repaired: int
    bounds_min: Vector
    bounds_max: Vector
    spacing: float
    kernel_radius: float
    regularization: float
    noise_estimate: Optional[float]
    value_residual_max: float
    value_residual_rms: float
    gradient_residual_max: float
    gradient_residual_rms: float
    input_distance_max: float
    input_distance_rms: float
    input_share_within: Optional[float]
    solver: str
    solver_reason: str
    iterations: int
    fallback: bool
    solver_residual: float
    condition_estimate: float
    seconds_clean: float
    seconds_choose: float
    seconds_assemble: float
    seconds_precondition: float
    seconds_solve: float
    seconds_total: float
    bytes: int
    peak_bytes: int
    normals_found: str
    normals_inward: bool
    normals_turned: int
    normals_confidence: Optional[float]
    seconds_orient: float

@dataclass(frozen=True)
class TrimInfo:
    """What trimming left out.

    Attributes
    ----------
    is_trimmed : bool
        Whether the surface ends somewhere; if not, every other field except `samples` and `spacing` is 0.
    samples : int
        Number of samples that were looked at; 0 if trimming was not asked for, if the model is a fit to a closed
        mesh, or if the end could not be found.
    parts : int
        Number of connected parts of the surface that are left out.
    parts_to_end : int
        Number of these that reach the end of the search box: the samples are open there.
    share : float
        Share of the surface's area in the box that is left out; 0 to 1; accurate to some percent.
    farthest : float
        Largest distance of a place that is left out from the samples, in the model's unit.
    spacing : float
        Median distance of a sample to its sixth neighbour, in the model's unit.
    """

    is_trimmed: bool
    samples: int
    parts: int
    parts_to_end: int
    share: float
    farthest: float
    spacing: float

@dataclass(frozen=True)
class OrientInfo:
    """What `orient` found and did.  Lengths are in the unit of the points.

    Attributes
    ----------
    found : {"given", "none", "unoriented", "mixed", "inward", "auto"}
        How far the given normals could be trusted; "none" also if they have nothing to do with the points, as
        colours have not.
    turned : int
        Number of given normals that were turned round.
    made : int
        Number of normals that were made, because they were missing, zero or useless.
    merged : int
        Number of points that coincide with another one.
    direction_change : float or None
        Mean angle between the lines of the given and the resulting normals, in degrees; None if no normals are
        given.
    noise : float
        Standard deviation of the points from their surface, in their unit; 0 if no noise is seen.
    spacing : float
        Median distance of a point to its nearest neighbour, in the unit of the points.
    energy : float
        Bending energy of the result per degree of freedom, in spacings. Below 0.006: the points resolve the
        surface; 0.026: points without any order.
    confidence : float
        How sure the result is; 0 to 1. A heuristic, not a probability: results above 0.9 are usually right; check
        the others.
    closed : bool
        Whether the points surround one or several solids.
    outward_by : str
        What decided which side is outward.
    components : int
        Number of pieces that lie apart by more than their spacing.
    seconds : float
        Time of the call.
    """

    found: str
    turned: int
    made: int
    merged: int
    direction_change: Optional[float]
    noise: float
    spacing: float
    energy: float
    confidence: float
    closed: bool
    outward_by: str
    components: int
    seconds: float

@dataclass(frozen=True)
class DepthImageInfo:
    """What `smooth_depth_image` found and did.

    Attributes
    ----------
    seen : int
        Number of pixels with a point.
    left_out : int
        Number of these that are left out, because too few other pixels lie on their plane.
    noise : float
        Standard deviation of 1 / z, as given or measured.
    focal_length : float
        Mean of the focal lengths in both directions, in pixels.
    depth : float
        Median of abs(z) over the points.
    radius : float
        Radius of the smoothing at this depth, in pixels.
    seconds : float
        Time of the call.
    """

    seen: int
    left_out: int
    noise: float
    focal_length: float
    depth: float
    radius: float
    seconds: float

@dataclass(frozen=True)
class CsgInfo:
    """What a CSG solid consists of.  All fields are 0 for a model that is not a CSG solid.

    Attributes
    ----------
    nodes : int
        Number of nodes, with those of solids that became part of it.
    depth : int
        Number of nodes from the root to the deepest leaf, both included.
    models : int
        Number of different models among the leaves.
    sheets : int
        Number of smooth functions that it consists of: sides of primitives, sides of the boxes at which models end,
        and one for each pair of those that a blend joins.
    lipschitz : float
        A bound on abs(grad f) that holds everywhere; 0 if none is known, because leaves are models.
    """

    nodes: int
    depth: int
    models: int
    sheets: int
    lipschitz: float

@dataclass(frozen=True)
class PointSetInfo:
    """What a point set holds.

    Attributes
    ----------
    distribution : str
        The distribution used.
    seed_source : {"auto", "samples", "box", "points"}
        The seed source used.
    layers : int
        Number of layers.
    marks : int
        Number of marks in all layers.
    origin : tuple of float
        Add it to a layer's positions to get absolute places.
    bounds_min : tuple of float
        Lower corner of the box around all marks, absolute.
    bounds_max : tuple of float
        Upper corner of the box.
    spacing : float
        Square root of the area per mark of the largest layer, estimated. A frame takes it as the size of a mark's
        piece of surface.
    seconds_seeds : float
        Time of finding the seeds.
    seconds_total : float
        Time of the whole call.
    bytes : int
        Memory that the set keeps, with what it shares with other sets.
    field_count : int
        Number of fields whose values the set holds.
    """

    distribution: str
    seed_source: str
    layers: int
    marks: int
    origin: Vector
    bounds_min: Vector
    bounds_max: Vector
    spacing: float
    seconds_seeds: float
    seconds_total: float
    bytes: int
    field_count: int

@dataclass(frozen=True)
class LayerInfo:
    """What a layer of marks holds.

    Attributes
    ----------
    kind : {"any", "stipples", "hatch", "own"}
    name : str
        The layer's name, as given or that of its kind.
    marks : int
        Number of marks.
    strokes : int
        Number of strokes that the marks form; 0 for stipples.
    full_count : int
        Number of marks that there would be if none had been dropped.
    levels : int
        Number of refinement steps taken; for "hatch" of "blue_noise" the highest level.
    step : float
        Initial step rho_0 used, in the unit of the samples; for "hatch" of "blue_noise" the separation.
    seconds : float
        Time of making the layer.
    """

    kind: str
    name: str
    marks: int
    strokes: int
    full_count: int
    levels: int
    step: float
    seconds: float

@dataclass(frozen=True)
class PlacementInfo:
    """What became of the candidates for marks: attempted = placed + all dropped.

    Attributes
    ----------
    attempted : int
        Number of candidates.
    placed : int
        Number of candidates that became marks.
    dropped_not_converged : int
        Number of candidates whose projection did not reach the tolerance.
    dropped_strayed : int
        Number of candidates that landed farther away than a cell's diagonal or the step, lie beyond the end of a
        trimmed model, or lost the connection to their stroke because a mark between was dropped.
    dropped_degenerate : int
        Number of candidates where the gradient is 0 or not finite.
    dropped_budget : int
        Number of candidates over the layer's budget.
    """

    attempted: int
    placed: int
    dropped_not_converged: int
    dropped_strayed: int
    dropped_degenerate: int
    dropped_budget: int

@dataclass(frozen=True)
class LineSetInfo:
    """What making a line set did.

    Attributes
    ----------
    triangles : int
        Number of triangles of the mesh on which curves are looked for.
    turned : int
        Triangles of that mesh that face away from the surface. The surface is finer than the cells there, and
        curves may be missed.
    missed_seeds : int
        Seeds that no triangle is near. A part of the surface is too thin for the cells there.
    lines : int
        Number of lines that were found once, when the set was made.
    borders : int
        Curves where the surface ends.
    cell_size : float
        Side of the cells as used, in units of the model.
    seconds : float
        Time that it took to make the line set.
    bytes : int
        Memory that the line set keeps.
    left_out : float
        Share of the examined area that lies beyond the samples, 0 to 1; 0 without `support`. For a trimmed model,
        only a little of the area beyond its end is examined; see `Model.trim_info`.
    creases : int
        Creases at any angle, each from corner to corner or closed.
    """

    triangles: int
    turned: int
    missed_seeds: int
    lines: int
    borders: int
    cell_size: float
    seconds: float
    bytes: int
    left_out: float
    creases: int

@dataclass(frozen=True)
class DrawingInfo:
    """What a drawing holds, and what making it did.

    Attributes
    ----------
    items : int
        Number of items drawn.
    layers : int
        Number of layers of the drawing; each has one ink and one class of marks.
    dots : int
        Dots of ink.
    strokes : int
        Strokes of marks and of lines.
    stroke_points : int
        Points of all strokes.
    marks : int
        Marks of the layers that the styles use, in all items.
    outside : int
        Marks outside the view frustum.
    front : int
        Marks of class front inside the frustum.
    back : int
        Number of marks of class back inside the frustum.
    silhouette : int
        Number of marks of class silhouette inside the frustum; "published" only.
    culled : int
        Marks without a class, because no tone could show them and they were skipped; "depth_layers" only.
    shown : int
        Marks drawn as ink.
    dropped_tone : int
        Front marks not shown because of light or share.
    dropped_depth : int
        Front and silhouette marks not shown because of their distance.
    dropped_zoom : int
        Front marks not shown because of the zoom.
    dropped_hidden : int
        Marks not drawn because the surface in front of them lets nothing of them through.
    splats : int
        With "published", discs of paper; with "depth_layers", marks from which depth layers were found.
    nanoseconds_classify : int
        Time for transforms, classes and tones.
    nanoseconds_visibility : int
        Time for finding what hides marks.
    nanoseconds_sort : int
        Time for ordering ink.
    bytes : int
        Memory that the drawing keeps.
    scratch_bytes : int
        Memory that its renderer keeps, without drawings.
    line_curves : int
        Curves that lines were drawn from.
    line_cusps : int
        Cusps of these curves.
    line_crossings : int
        Crossings of their images at which the farther curve changes its visibility.
    line_broken : int
        Curves that end inside the surface, and places where a curve was missed.
    line_settled : int
        Curves whose visibility did not add up. A ray decided for each of their parts.
    line_contradictions : int
        Curves among these with a part whose ray was not certain.
    nanoseconds_lines : int
        Time for lines.
    line_refined : int
        Curves whose visibility did not add up at first. They, and those that cross them, were refined.
    line_tangles : int
        Cells of the image, four pixels wide or more, with so many crossings that none was used. Lines run to and
        fro over each other there, as on a flat face seen edge-on.
    line_pieces : int
        Visible and hidden parts of lines that rays were compared with (`verify_lines`).
    line_agreeing : int
        Parts whose decided rays all agree with the drawing.
    line_undecided : int
        Parts without a decided ray: they are within 0.4 pixels of an edge, in the image or in depth.
    line_repaired : int
        Parts that were divided, or drawn otherwise than counted, because rays disagreed.
    """

    items: int
    layers: int
    dots: int
    strokes: int
    stroke_points: int
    marks: int
    outside: int
    front: int
    back: int
    silhouette: int
    culled: int
    shown: int
    dropped_tone: int
    dropped_depth: int
    dropped_zoom: int
    dropped_hidden: int
    splats: int
    nanoseconds_classify: int
    nanoseconds_visibility: int
    nanoseconds_sort: int
    bytes: int
    scratch_bytes: int
    line_curves: int
    line_cusps: int
    line_crossings: int
    line_broken: int
    line_settled: int
    line_contradictions: int
    nanoseconds_lines: int
    line_refined: int
    line_tangles: int
    line_pieces: int
    line_agreeing: int
    line_undecided: int
    line_repaired: int

@dataclass(frozen=True)
class DrawingLayerFields:
    """A layer of a drawing: the ink of one layer of marks, from front marks or from contours.

    Attributes
    ----------
    mark_class : str
        "front" or "silhouette".
    item : int
        Number of the item, from 0.
    layer : int
        Number of the layer in the item's point set; -1 for lines.
    kind : str
        The kind of the layer of marks, or of the lines.
    shape : {"dots", "strokes", "hatch"}
    name : str
        The name of the layer of marks, or of the lines in the style.
    ink : tuple of float
        Straight RGBA, 0 to 1.
    dots : int
        Dots of the layer.
    strokes : int
        Strokes of the layer.
    ink_number : int
        Number of the ink in the style's palette; -1 = the layer's own ink. Each ink that marks of a layer take is a
        layer of the drawing of its own.
    """

    mark_class: str
    item: int
    layer: int
    kind: str
    shape: str
    name: str
    ink: Tuple[float, float, float, float]
    dots: int
    strokes: int
    ink_number: int

@dataclass(frozen=True)
class MarkIdentity:
    """The mark that an identity refers to.

    Attributes
    ----------
    id : int
        The id itself.
    item : int
        Number of the item, from 0.
    layer : int
        Number of the layer in the item's point set.
    mark : int
        Number of the mark in that layer.
    stroke : int
        Number of its stroke; -1 if it has none.
    place : int
        Place of the mark along its stroke.
    """

    id: int
    item: int
    layer: int
    mark: int
    stroke: int
    place: int

@dataclass(frozen=True)
class PageInfo:
    """What was written to a page.

    Attributes
    ----------
    bytes : int
        Bytes of the file.
    groups : int
        Groups of ink.
    paths : int
        Lines and outlines.
    segments : int
        Curves or straight lines of all paths.
    dots : int
        Dots.
    joined : int
        In plot order, pairs of ends that became one line.
    dropped_paths : int
        Lines dropped because they are too short for the pen.
    dropped_dots : int
        Dots dropped because they are too near to others for the pen.
    width : float
        Width of the page, in mm.
    height : float
        Height of the page, in mm.
    drawn : float
        Length that a pen draws, in mm; in plot order, else 0.
    travelled : float
        Length that a pen travels above the paper, in mm; in plot order, else 0.
    seconds : float
        Time that a plotter takes at the given speeds, in seconds; in plot order, else 0.
    filled_paths : int
        Lines wider than their pen, drawn in several passes.
    cut_paths : int
        Lines longer than `longest`, cut into parts.
    """

    bytes: int
    groups: int
    paths: int
    segments: int
    dots: int
    joined: int
    dropped_paths: int
    dropped_dots: int
    width: float
    height: float
    drawn: float
    travelled: float
    seconds: float
    filled_paths: int
    cut_paths: int

@dataclass(frozen=True)
class MeshInfo:
    """What making a mesh found and did.

    Attributes
    ----------
    closed : bool
        Whether no edge is at the boundary or not manifold, and all faces agree.
    given_vertices : int
        Vertices that were given.
    given_faces : int
        Faces that were given.
    vertices : int
        Vertices that are kept. They are more than were given where solids that touch in an edge are parted, at most
        three for each face.
    faces : int
        Faces that are kept.
    welded_vertices : int
        Vertices at the place of another, joined with it; on borders also those within 1e-6 diagonals of another.
    degenerate_faces : int
        Faces left out because they have no area beyond the rounding of single precision. The face across the
        largest side is cut in two at the corner on it, so that no slit stays.
    repeated_faces : int
        Faces left out because another has the same corners; both where two solids share a wall.
    turned_faces : int
        Faces turned to agree with those beside them.
    components : int
        Components of the given faces.
    turned_components : int
        Closed components turned because they were inside out.
    nested_components : int
        Components inside a closed one.
    left_out_components : int
        Components left out, by `parts`.
    left_out_faces : int
        Faces of the components left out.
    boundary_edges : int
        Edges with one face.
    boundary_loops : int
        Loops that these edges form.
    nonmanifold_edges : int
        Edges with more than two faces.
    contrary_edges : int
        Edges whose two faces do not agree, because the mesh cannot be oriented or was not to be.
    euler_characteristic : int
        Vertices - edges + faces.
    genus : int
        Number of handles of all components; -1 if the mesh is not closed.
    area : float
        Area, in squared units of the mesh.
    volume : float or None
        Enclosed volume, in cubed units of the mesh; None if the mesh is not closed.
    bounds_min : tuple of float
        Least coordinates of the vertices.
    bounds_max : tuple of float
        Greatest coordinates of the vertices.
    seconds : float
        Time that making it took.
    bytes : int
        Memory that the mesh keeps.
    crease_length : float
        Length of the edges that bend by more than 30 degrees, in diagonals of the bounds.
    creases : bool
        Whether the mesh has edges that stand out, as those of machine parts do. `Model.fit_mesh` keeps them sharp
        with edges "auto" and the default crease_angle.
    cavities : int
        Components that are kept and are walls of cavities.
    """

    closed: bool
    given_vertices: int
    given_faces: int
    vertices: int
    faces: int
    welded_vertices: int
    degenerate_faces: int
    repeated_faces: int
    turned_faces: int
    components: int
    turned_components: int
    nested_components: int
    left_out_components: int
    left_out_faces: int
    boundary_edges: int
    boundary_loops: int
    nonmanifold_edges: int
    contrary_edges: int
    euler_characteristic: int
    genus: int
    area: float
    volume: Optional[float]
    bounds_min: Vector
    bounds_max: Vector
    seconds: float
    bytes: int
    crease_length: float
    creases: bool
    cavities: int

@dataclass(frozen=True)
class MeshEdgesInfo:
    """The sharp edges of a mesh as a whole.  Lengths are in the mesh's unit.

    Attributes
    ----------
    edges : int
        Number of sharp edges.
    patches : int
        Number of smooth patches between them; 1 if no edge is sharp.
    length : float
        Length of the sharp edges.
    fading : float
        Length of those sharp edges that have the same patch on both sides, as where a crease fades out.
    doubtful : float
        With "auto", length of edges that bend more than crease_angle but do not stand out; 0 if the mesh has sharp
        edges.
    seconds : float
        Time that the search took.
    """

    edges: int
    patches: int
    length: float
    fading: float
    doubtful: float
    seconds: float

@dataclass(frozen=True)
class MeshFitInfo:
    """What a fit to a mesh reached, by the last of its measurements.  Lengths are in the mesh's unit.

    Attributes
    ----------
    reached : bool
        Whether surface and mesh keep the tolerance, the share and `far`, both ways.
    tolerance : float
        Tolerance as used.
    far : float
        The distance `far` that was used.
    candidates : int
        Places on the mesh that samples were chosen from.
    centres : int
        Number of centres of the model.
    off_surface_centres : int
        Centres off the surface, at which f is held to the distance from the mesh. They are the last ones.
    rounds : int
        Number of fits.
    supported : bool
        Whether the mesh has a border, and the surface beyond it was not counted.
    surface_share : float
        Share of the surface within the tolerance of the mesh, 0 to 1.
    surface_p99 : float
        99 % of the surface is within this distance of the mesh.
    surface_max : float
        Largest distance of the surface from the mesh.
    mesh_share : float
        Share of the mesh within the tolerance of the surface, 0 to 1.
    mesh_p99 : float
        99 % of the mesh is within this distance of the surface.
    mesh_max : float
        Largest distance of the mesh from the surface.
    seconds_sample : float
        Time for choosing samples.
    seconds_fit : float
        Time for the fits of all rounds.
    seconds_measure : float
        Time for measuring distances.
    seconds_total : float
        Time of the whole call.
    sheets : int
        Smooth sheets that the surface consists of; 1 if it has no sharp edges.
    crease_length : float
        Length of the mesh's edges that are sharp, in units of the mesh.
    smooth_length : float
        Length of edges that stay smooth because the mesh could not be cut there, in units of the mesh.
    cells : int
        Cells of space, in each of which a few sheets make the surface.
    poor_cells : int
        Cells in which no maximum and minimum of sheets follows the mesh everywhere.
    """

    reached: bool
    tolerance: float
    far: float
    candidates: int
    centres: int
    off_surface_centres: int
    rounds: int
    supported: bool
    surface_share: float
    surface_p99: float
    surface_max: float
    mesh_share: float
    mesh_p99: float
    mesh_max: float
    seconds_sample: float
    seconds_fit: float
    seconds_measure: float
    seconds_total: float
    sheets: int
    crease_length: float
    smooth_length: float
    cells: int
    poor_cells: int

@dataclass(frozen=True)
class Comparison:
    """How near a surface and a mesh are to each other.  Distances are in the mesh's unit; NaN without points.

    Attributes
    ----------
    surface_points : int
        Places on the surface, even over its area.
    surface_mean : float
        Mean of their distances from the mesh.
    surface_p99 : float
        99 % of these distances are not larger.
    surface_max : float
        Largest of these distances.
    surface_share : float
        Share of the surface within the tolerance of the mesh, 0 to 1.
    invented_share : float
        Share of the surface farther than `far` from the mesh, 0 to 1.
    left_out_share : float
        Share of the surface left out, beyond the mesh's border or by `support`, 0 to 1; no other figure includes
        it.
    mesh_points : int
        Places on the mesh, even over its area.
    mesh_mean : float
        Mean of their distances from the surface.
    mesh_p99 : float
        99 % of these distances are not larger.
    mesh_max : float
        Largest of these distances.
    mesh_share : float
        Share of the mesh within the tolerance of the surface, 0 to 1.
    missed_share : float
        Share of the mesh farther than `far` from the surface, 0 to 1.
    normal_mean : float
        Mean angle between the mesh's normals and those of the surface beside them, in degrees.
    normal_p99 : float
        99 % of these angles are not larger.
    components : int
        Components of the surface.
    genus : int
        Genus of the surface, summed over its components; -1 if it has a border in the box.
    tolerance : float
        Tolerance as used.
    diagonal : float
        Diagonal of the mesh.
    seconds : float
        Time that the comparison took.
    """

    surface_points: int
    surface_mean: float
    surface_p99: float
    surface_max: float
    surface_share: float
    invented_share: float
    left_out_share: float
    mesh_points: int
    mesh_mean: float
    mesh_p99: float
    mesh_max: float
    mesh_share: float
    missed_share: float
    normal_mean: float
    normal_p99: float
    components: int
    genus: int
    tolerance: float
    diagonal: float
    seconds: float

@dataclass(frozen=True)
class MeshFacts:
    """Facts about a mesh, counted after vertices at the same place are joined.

    Attributes
    ----------
    components : int
        Number of connected parts.
    closed : bool
        Whether each edge has two faces, which run along it in opposite directions.
    boundary_edges : int
        Number of edges with one triangle.
    holes : int
        Number of closed lines that the boundary edges form.
    non_manifold_edges : int
        Number of edges with more than two triangles.
    inconsistent_edges : int
        Number of edges whose two triangles run the same way, so that one of them is turned over.
    inside_out : bool
        Whether the mesh is closed, and its faces look inward.
    parts_inside_out : int
        Number of closed parts whose faces look inward; inside another part, such a part is a cavity.
    degenerate_triangles : int
        Number of triangles without area.
    duplicate_triangles : int
        Number of triangles with the same corners as another one.
    unused_vertices : int
        Number of vertices without a triangle.
    joined_vertices : int
        Number of vertices at the same place as another one.
    faces_not_finite : int
        Number of triangles with a corner that is not finite.
    area : float
        Area, in squared units of the source.
    volume : float
        Enclosed volume, in cubed units of the source; 0 if the mesh is not closed.
    """

    components: int
    closed: bool
    boundary_edges: int
    holes: int
    non_manifold_edges: int
    inconsistent_edges: int
    inside_out: bool
    parts_inside_out: int
    degenerate_triangles: int
    duplicate_triangles: int
    unused_vertices: int
    joined_vertices: int
    faces_not_finite: int
    area: float
    volume: float

@dataclass
class PageItem:
    """A drawing on a page.

    Attributes
    ----------
    drawing : Drawing
        The drawing; what lies beyond its viewport is cut off.
    x : float
        Distance from the page's left edge to the viewport's, in mm.
    y : float
        Distance from the page's top edge to the viewport's, in mm.
    scale : float
        Millimetres of a pixel; above 0, up to 1e6; default 25.4 / 96.
    name : str, optional
        The name of the group that holds the drawing.
    """

    drawing: Drawing
    x: float = ...
    y: float = ...
    scale: float = ...
    name: Optional[str] = ...

@dataclass
class Pen:
    """The pen for some groups of a page.

    Attributes
    ----------
    groups : str
        A group's name, or the beginning of names and a '*'. If several pens fit a group, the last one is taken.
    width : float
        Width of all lines, in mm; 0 to 1e6; default 0 = as drawn. For plotters it is the width of the pen, 0.3 if
        it is 0.
    ink : tuple of float, optional
        Red, green, blue and alpha, 0 to 1; None: as drawn.
    number : int
        Number of a plotter's pen, 1 to 255.
    line_type : str
        As drawn, or a type of ISO 128-2. One of "as_drawn", "continuous", "dashed", "dashed_spaced",
        "long_dashed_dotted", "long_dashed_double_dotted", "long_dashed_triple_dotted", "dotted",
        "long_dashed_short_dashed", "long_dashed_double_short_dashed", "dashed_dotted", "double_dashed_dotted",
        "dashed_double_dotted", "double_dashed_double_dotted", "dashed_triple_dotted",
        "double_dashed_triple_dotted".
    """

    groups: str = ...
    width: float = ...
    ink: Optional[Tuple[float, ...]] = ...
    number: int = ...
    line_type: str = ...

@dataclass
class Annotation:
    """A line or a text beside the drawings of a page.

    Attributes
    ----------
    points : array of float, shape (n, 2)
        The points of the line, in mm from the page's top left corner; for a text, the first row is the start of its
        baseline.
    text : str, optional
        The text; None: the points are a line.
    group : str
        The name of the group. Consecutive annotations of one group form one layer, in the ink and line type of the
        first.
    width : float
        Width of the line, or height of the text's capitals, in mm; above 0, up to 1e6; default 0.35.
    ink : tuple of float
        Red, green, blue and alpha, 0 to 1; default black.
    line_type : str
        As in `Pen`. One of "as_drawn", "continuous", "dashed", "dashed_spaced", "long_dashed_dotted",
        "long_dashed_double_dotted", "long_dashed_triple_dotted", "dotted", "long_dashed_short_dashed",
        "long_dashed_double_short_dashed", "dashed_dotted", "double_dashed_dotted", "dashed_double_dotted",
        "double_dashed_double_dotted", "dashed_triple_dotted", "double_dashed_triple_dotted".
    """

    points: Array
    text: Optional[str] = ...
    group: str = ...
    width: float = ...
    ink: Tuple[float, ...] = ...
    line_type: str = ...

@dataclass
class LinesFields:
    """Lines that are found once, when a `LineSet` is made.

    Attributes
    ----------
    kind : str
        "ridge", "valley", "parabolic", "section", "own", "soft_edge" or "tangent_edge".
    name : str
        The name by which `LineStyle.name` refers to the lines.
    lower : float
        Least strength at which a line goes on; 0 or more; default 0. If `lower` and `upper` are 0, it is 6 for
        ridges and valleys, 15 (degrees) for soft edges, and 0 for other kinds.
    upper : float
        Strength that a line must reach somewhere, or it is dropped; not below `lower`; default 0. If `lower` and
        `upper` are 0, it is 15 for ridges and valleys, 35 (degrees) for soft edges, and 0 for other kinds.
    shortest : float
        Length below which a line is dropped, in diagonals; 0 or more; default 0.01.
    plane : sequence of float
        For "section": the normal of the planes.
    levels : sequence of float
        For "section": the positions of the planes along the unit normal, in the model's unit.
    polylines : sequence of array of float, shape (n, 3)
        For "own": the lines, on the surface or near it. A line is closed if its last point equals its first.
    """

    kind: str = ...
    name: str = ...
    lower: float = ...
    upper: float = ...
    shortest: float = ...
    plane: Sequence[float] = ...
    levels: Sequence[float] = ...
    polylines: Sequence[Array] = ...

@dataclass
class OwnLayerFields:
    """A layer of ready-made marks, for `PointSet.create`; the arrays are copied.

    Attributes
    ----------
    positions : array of float, shape (n, 3)
        Absolute places of the marks, in the model's unit.
    normals : array of float, shape (n, 3)
        Outward normals, of any length except 0.
    name : str, optional
        The name by which styles and `PointSet.layer` refer to the layer; None: the kind.
    kind : str
        "own", "stipples" or "hatch".
    stroke_first : array of int, shape (s + 1,), optional
        Numbers that rise from 0 to n: stroke s has the marks stroke_first[s] to stroke_first[s + 1] - 1, from end
        to end. None: no strokes.
    stroke_directions : array of int, shape (s,), optional
        0 for the first direction, 1 for the second; None: all 0.
    directions : array of float, shape (n, 3), optional
        Directions of any length, not along the normal; None: along the stroke.
    curvatures : array of float, shape (n, 3), optional
        k1, k2 and confidence; None: not known.
    ranks : array of float, shape (n,), optional
        Ranks in [0, 1): a mark is shown where its rank is at least the tone. None: random, the same for all marks
        of a stroke.
    levels : array of int, shape (n,), optional
        Refinement steps; None: all 0.
    widths : array of float, shape (n,), optional
        Widths in (0, 1], as factors of the style's radius; None: all 1.
    """

    positions: Array
    normals: Array
    name: Optional[str] = ...
    kind: str = ...
    stroke_first: Optional[Array] = ...
    stroke_directions: Optional[Array] = ...
    directions: Optional[Array] = ...
    curvatures: Optional[Array] = ...
    ranks: Optional[Array] = ...
    levels: Optional[Array] = ...
    widths: Optional[Array] = ...

@dataclass
class LayerFields:
    """How one layer of marks is made; see `PointSet.generate`.

    Attributes
    ----------
    kind : str
        "stipples": scattered marks. "hatch": evenly spaced, nested lines along one smooth field of directions; with
        the distribution "published", strokes along these directions and across them [NPAR 5].
    name : str, optional
        The name by which styles and `PointSet.layer` refer to the layer; None: the kind.
    budget : int, optional
        Largest number of marks. 0: no limit, for the distribution "published" and for lines with a separation.
        None: no limit for these, 40000 for others.
    tone : (begin, end), optional
        Darkness at which the first mark is shown, and darkness at which all marks are shown, 0 to 1 each, for
        stipples, lines, and "published" strokes of the first direction. None: as `tone_ranges` says.
    second_tone : (begin, end), optional
        Darkness at which the first mark is shown, and darkness at which all marks are shown, 0 to 1 each, for
        "published" strokes of the second direction. None: as `tone_ranges` says.
    with_curvature : bool
        Whether the marks keep their curvature; "published" strokes along curvature always do.
    density : str, Field or callable
        Where "blue_noise" stipples are denser: "uniform", "curvature", a `Field` or a function. The function gets
        positions and unit normals, shape (n, 3) each, and returns n numbers from 0 (no stipples) to 1 (densest).
    density_strength : float
        Strength of "curvature"; 0 to 1; default 0.5. 0 = uniform; larger values put more stipples where the surface
        bends.
    separation : float
        Mean distance between neighbouring lines of "hatch", in the model's unit; 0: the distance at which the lines
        have about as many marks as the budget.
    step : float
        Distance between the marks of a line, in the model's unit; 0: 0.4 of the separation.
    direction : Field or callable, optional
        A `Field`, or a function that gives the directions of "hatch" lines, instead of `guide`. The function gets
        positions and unit normals, shape (n, 3) each, and returns directions of the same shape. Their sign and
        length do not matter; (0, 0, 0) means no direction.
    start : {"seeds", "stipples"}
        Where strokes of the distribution "published" start.
    start_level : int
        For start "stipples": the last level of stipples at which strokes start, 0 to 12.
    levels : int, optional
        Number of refinement steps of the distribution "published", 0 to 12. None: 4 for stipples, 3 for strokes. A
        stroke has 3^levels marks.
    angle : float
        Angle by which "hatch" lines are turned in the tangent plane, in degrees, counter-clockwise as seen from
        outside, -360 to 360.
    smoothing : float
        Distance over which the directions of "hatch" lines are smoothed, in diagonals of the model, 1e-6 to 1;
        default 0.04. Larger values give calmer lines that follow the form less.
    axis : (x, y, z)
        Axis around which "hatch" lines run where the confidence of the curvature is low; default (0, 1, 0).
    axis_weight : float
        Weight of the axis against the curvature, 0 to 1000; default 0.06.
    tone_smoothing : float, optional
        Distance over which the normals that set the tone are averaged, in diagonals of the model, 0 to 0.1. Larger:
        the grain of a rough surface makes fewer spots of light. 0: no averaging. None: 0.006 for "blue_noise"
        "hatch", 0 for others.
    guide : {"curvature", "combing", "sections", "light", "silhouette"}
        The directions that "hatch" lines follow if there is no `direction`. "curvature": the direction in which the
        surface bends most; "combing": Stark's combing direction; "sections": cuts by planes perpendicular to
        `axis`; "light": the direction to the light, in the tangent plane; "silhouette": along the silhouette, for
        places near it.
    guide_direction : (x, y, z)
        Direction to the light ("light") or to the eye ("silhouette"), in the model's coordinates.
    guide_weight : float
        Weight of a guide other than "curvature", 0 to 1; the curvature has the rest of 1.

    Examples
    --------
    >>> lines = hrbfnpr.Layer("hatch", name="fur", direction=lambda p, n: np.cross(n, (0, 0, 1)), separation=0.02)
    >>> marks = model.generate(["stipples", lines])
    """

    kind: str = ...
    name: Optional[str] = ...
    budget: Optional[int] = ...
    tone: Optional[Interval] = ...
    second_tone: Optional[Interval] = ...
    with_curvature: bool = ...
    density: Density = ...
    density_strength: float = ...
    separation: float = ...
    step: float = ...
    direction: Optional[Direction] = ...
    start: str = ...
    start_level: int = ...
    levels: Optional[int] = ...
    angle: float = ...
    smoothing: float = ...
    axis: Vector = ...
    axis_weight: float = ...
    tone_smoothing: Optional[float] = ...
    guide: str = ...
    guide_direction: Vector = ...
    guide_weight: float = ...

class StyleFields(Attributes):
    paper: Field[Tuple[float, ...], Color]
    tone_rule: Field[str, str]
    tone_curve: Field[str, str]
    light: Field[Tuple[float, ...], Sequence[float]]
    tone_exponent: Field[float, float]
    light_space: Field[str, str]
    tone_fade: Field[float, float]
    silhouette_threshold: Field[float, float]
    silhouette_radius: Field[float, float]
    silhouette_radius_zoom: Field[float, float]
    silhouette_ink: Field[Tuple[float, ...], Color]
    visibility: Field[str, str]
    hidden_lines: Field[str, str]
    attenuation_front: Field[float, float]
    attenuation_back: Field[float, float]
    splat_radius: Field[float, float]
    splat_overlap: Field[float, float]
    halo_width: Field[float, float]
    verify_lines: Field[int, int]
    depth_min: Field[float, float]
    depth_max: Field[float, float]
    zoom_reference: Field[float, float]
    zoom_exponent: Field[float, float]
    fill_light: Field[float, float]
    light_intensity: Field[float, float]
    light_shadow: Field[float, float]
    light_softness: Field[float, float]
    evenness: Field[str, str]
    ambient_up: Field[Tuple[float, ...], Sequence[float]]
    ambient_sky: Field[float, float]
    ambient_ground: Field[float, float]
    occlusion: Field[float, float]
    occlusion_exponent: Field[float, float]
    rim_light: Field[float, float]
    rim_exponent: Field[float, float]
    tone_black: Field[float, float]
    tone_white: Field[float, float]
    tone_gamma: Field[float, float]
    tone_steps: Field[int, int]
    curvature_contrast: Field[float, float]
    occlusion_lights: Field[float, float]

class LightFields(Attributes):
    kind: Field[str, str]
    space: Field[str, str]
    intensity: Field[float, float]
    shadow: Field[float, float]
    softness: Field[float, float]
    place: Field[Tuple[float, ...], Sequence[float]]

class LayerStyleFields(Attributes):
    kind: Field[str, str]
    shown: Field[bool, bool]
    contours: Field[int, int]
    shape: Field[str, str]
    share: Field[float, float]
    radius: Field[float, float]
    radius_zoom: Field[float, float]
    ink: Field[Tuple[float, ...], Color]
    hatch_tone_begin: Field[float, float]
    hatch_tone_end: Field[float, float]
    hatch_coverage_begin: Field[float, float]
    hatch_coverage_end: Field[float, float]
    hatch_spacing: Field[float, float]
    hatch_pen: Field[float, float]
    hatch_white: Field[float, float]
    hatch_taper: Field[float, float]
    hatch_shortest: Field[float, float]
    hatch_wobble: Field[float, float]
    hatch_overshoot: Field[float, float]
    hatch_seed: Field[int, int]
    tone_field_rule: Field[str, str]
    palette_rule: Field[str, str]
    hatch_fade: Field[float, float]

class LineStyleFields(Attributes):
    kind: Field[str, str]
    hidden: Field[str, str]
    cap: Field[str, str]
    width: Field[float, float]
    taper: Field[float, float]
    hidden_width: Field[float, float]
    hidden_opacity: Field[float, float]
    dash: Field[float, float]
    gap: Field[float, float]
    shortest: Field[float, float]
    fade: Field[float, float]
    lower: Field[float, float]
    upper: Field[float, float]
    ink: Field[Tuple[float, ...], Color]
    outline_factor: Field[float, float]
    far_factor: Field[float, float]
    lit_factor: Field[float, float]
    curvature_factor: Field[float, float]
    curvature_radius: Field[float, float]
    wobble: Field[float, float]
    wobble_width: Field[float, float]
    wobble_length: Field[float, float]
    wobble_seed: Field[int, int]
    creases: Field[str, str]
