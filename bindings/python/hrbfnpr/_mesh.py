# SPDX-License-Identifier: MIT
"""Triangle meshes: made usable, sampled, and what a surface is compared with."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Tuple

from ._arrays import INDICES, Array, block_in, new_array, output, reshaped, wrap
from ._callbacks import check
from ._context import Context, resolve
from ._errors import new_error, new_struct
from ._handles import Owner, own
from ._library import ffi, lib
from ._model_results import Vector
from ._names import FACES, PARTS, number_of
from ._operation import Operation, Progress, running
from ._structs import read_struct


@dataclass(frozen=True)
class MeshInfo:
    """What making a mesh found, and did.

    Attributes
    ----------
    closed : bool
        No edge has one face, or more than two, and all faces agree.
    given_vertices, given_faces, vertices, faces : int
        As given, and as kept.
    welded_vertices : int
        In the place of another, and joined with it.
    degenerate_faces, repeated_faces : int
        Without area, or with the corners of another: left out.
    turned_faces : int
        Against those beside them, turned.
    components, turned_components, nested_components, left_out_components, left_out_faces : int
        Of the given faces; closed but inside out, turned; inside another; left out.
    boundary_edges, boundary_loops, nonmanifold_edges, contrary_edges : int
    euler_characteristic, genus : int
        genus is -1 where the mesh is not closed.
    area : float
    volume : float, optional
        None where the mesh is not closed.
    bounds_min, bounds_max : (float, float, float)
    seconds : float
    bytes : int
    crease_length : float
        Of the edges that bend by more than 30 degrees, in diagonals of the bounds.
    creases : bool
        These stand out, as those of machine parts: `Model.fit_mesh` with edges "auto" keeps them sharp.
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


@dataclass(frozen=True)
class MeshFitInfo:
    """What a fit to a mesh came to: the last of the measurements that it went by.

    Attributes
    ----------
    reached : bool
        tolerance, share and far are kept, both ways.
    tolerance, far : float
        As used.
    candidates, centres, rounds : int
    off_surface_centres : int
        The last ones of the model's centres: where f is held to the distance from the mesh.
    supported : bool
        The mesh has a border, and the surface beyond it was not counted.
    surface_share, surface_p99, surface_max : float
        Of the surface: the share within the tolerance of the mesh, and distances from it.
    mesh_share, mesh_p99, mesh_max : float
        Of the mesh: the same from the surface.
    seconds_sample, seconds_fit, seconds_measure, seconds_total : float
    sheets : int
        Smooth pieces that the surface is made of; 1: it has no edges.
    crease_length, smooth_length : float
        Of the mesh's edges: those that are sharp, and those that are not, as the mesh could not be cut there.
    cells, poor_cells : int
        Of space, in each of which a few sheets rule; and those in which no maximum and minimum of its sheets does all
        that the mesh does.
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
    """How near a surface is to a mesh, both ways; distances are in units of the mesh, NaN of no points.

    Attributes
    ----------
    surface_points : int
        Places on the surface, even over its area, within the mesh's box, grown by 0.05 diagonals.
    surface_mean, surface_p99, surface_max, surface_share : float
        Of their distances from the mesh; share: within the tolerance.
    invented_share, left_out_share : float
        Of the surface: farther than `far` from the mesh; beyond the mesh's border, or left out by `support`.
    mesh_points : int
        Places on the mesh, even over its area.
    mesh_mean, mesh_p99, mesh_max, mesh_share, missed_share : float
        Of their distances from the surface.
    normal_mean, normal_p99 : float
        Degrees between the mesh's normals and the surface's.
    components, genus : int
        Of the surface; genus is -1 if it has a border in the box.
    tolerance, diagonal, seconds : float
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


class MeshSamples(NamedTuple):
    """Points on a mesh and their unit normals, float64 (n, 3) each."""

    points: Array
    normals: Array


class Mesh(Owner):
    """A triangle mesh, welded, oriented, and without the parts that lie inside others; immutable.

    Parameters
    ----------
    vertices : array of float, shape (n, 3)
    triangles : array of int, shape (m, 3)
        Numbers of vertices, from 0, counter-clockwise as seen from outside.
    parts : {"outer", "all", "largest"}
        Which components are kept: all but those inside a closed one; all; that of the largest area.
    crease_angle : float
        Degrees: faces that meet at a sharper angle do not share their normals.
    faces : {"turn", "keep"}
        Whether faces are turned to agree with their component, and closed components outward.
    progress, operation, context
        As in `Model.fit`.

    Raises
    ------
    InvalidArgumentError
        For an index that is no vertex's (the message names the face and the index), a corner that is not
        finite, and a mesh that has no face with an area.

    Examples
    --------
    >>> mesh = hrbfnpr.Mesh(vertices, triangles)
    >>> model = hrbfnpr.Model.fit_mesh(mesh)
    >>> model.mesh_fit.reached, model.compare(mesh).surface_max
    """

    def __init__(
        self,
        vertices: Array,
        triangles: Array,
        *,
        parts: str = "outer",
        crease_angle: float = 60.0,
        faces: str = "turn",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> None:
        context = resolve(context)
        desc = new_struct("hrbfnpr_mesh_desc")
        desc.parts = number_of("parts", PARTS, parts)
        desc.faces = number_of("faces", FACES, faces)
        desc.crease_angle = crease_angle
        keep = [
            block_in("vertices", vertices).fill(desc.vertices),
            block_in("triangles", triangles, 3, INDICES).fill(desc.triangles),
        ]
        out, error = ffi.new("hrbfnpr_mesh **"), new_error()
        with running(operation, progress, context._handle) as (handle, state):
            check(lib.hrbfnpr_mesh_create(context._handle, desc, handle, out, error), error, state)
        del keep
        super().__init__(own(out[0], lib.hrbfnpr_mesh_release, context))
        self._made_in = context

    @property
    def info(self) -> MeshInfo:
        """What making it found, and did."""
        info, error = new_struct("hrbfnpr_mesh_info"), new_error()
        check(lib.hrbfnpr_mesh_get_info(self._handle, info, error), error)
        return read_struct(MeshInfo, info, {"closed": bool, "creases": bool})

    def _view(self, attribute: str) -> Array:
        view, error = ffi.new("hrbfnpr_array *"), new_error()
        number = ffi.integer_const(f"HRBFNPR_MESH_ATTRIBUTE_{attribute}")
        check(lib.hrbfnpr_mesh_view(self._handle, number, view, error), error)
        return wrap(view, self._handle)

    @property
    def vertices(self) -> Array:
        """Those that are kept, float64 (n, 3): a read-only view, nothing is copied."""
        return self._view("VERTEX")

    @property
    def triangles(self) -> Array:
        """Numbers of vertices, int32 (m, 3): a read-only view."""
        return self._view("TRIANGLE")

    @property
    def components(self) -> Array:
        """Of each face, from 0, int32 (m,): a read-only view."""
        return self._view("COMPONENT")

    @property
    def given_faces(self) -> Array:
        """The number that each face was given by, int32 (m,): a read-only view."""
        return self._view("GIVEN_FACE")

    @property
    def corner_normals(self) -> Array:
        """Unit normals of the corners of each face, float64 (m, 3, 3); with NumPy, a read-only view."""
        flat = self._view("CORNER_NORMAL")
        return reshaped(flat, (flat.shape[0], 3, 3))

    def sample(
        self,
        count: int,
        *,
        candidates: int = 0,
        random_seed: int = 1,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> MeshSamples:
        """Points with normals, even over the mesh's area; every prefix is even.

        Parameters
        ----------
        count : int
        candidates : int
            Random places to choose from; 0 = 40 for each sample, 1000000 at most; as many as samples: all
            of them, in random order.
        random_seed : int
        """
        desc, error = new_struct("hrbfnpr_sample_desc"), new_error()
        desc.candidates, desc.random_seed = candidates, random_seed
        points, points_out = output("points", None, (max(count, 0),), 3, "d")
        normals, normals_out = output("normals", None, (max(count, 0),), 3, "d")
        with running(operation, progress, self._made_in._handle) as (handle, state):
            status = lib.hrbfnpr_mesh_sample(self._handle, desc, points_out, normals_out, handle, error)
            check(status, error, state)
        return MeshSamples(points, normals)

    def __repr__(self) -> str:
        if self.closed:
            return "<hrbfnpr.Mesh closed>"
        info = self.info
        return f"<hrbfnpr.Mesh {info.vertices} vertices, {info.faces} faces>"


def farthest_points(
    points: Array,
    count: int,
    *,
    progress: Optional[Progress] = None,
    operation: Optional[Operation] = None,
    context: Optional[Context] = None,
) -> Tuple[Array, Array]:
    """Farthest-point order: each point the farthest from those before it, so that every prefix is even.

    Parameters
    ----------
    points : array of float, shape (n, 3)
    count : int
        From 1 to n.
    progress, operation, context
        As in `Model.fit`.

    Returns
    -------
    indices : array of int64, shape (count,)
        The first is the point nearest to the middle of the bounding box; of equals the one of lower number.
    distances : array of float64, shape (count,)
        Of each from those before it; infinite for the first.
    """
    context = resolve(context)
    block = block_in("points", points)
    indices, indices_out = output("indices", new_array((max(count, 0),), "q"), (max(count, 0),), 1, "q")
    distances, distances_out = output("distance", None, (max(count, 0),), 1, "d")
    error = new_error()
    with running(operation, progress, context._handle) as (handle, state):
        status = lib.hrbfnpr_farthest_points(context._handle, block.view(), indices_out, distances_out, handle, error)
        check(status, error, state)
    return indices, distances


def read_fit_info(info: Any) -> MeshFitInfo:
    """From a hrbfnpr_mesh_fit_info."""
    return read_struct(MeshFitInfo, info, {"reached": bool, "supported": bool})
