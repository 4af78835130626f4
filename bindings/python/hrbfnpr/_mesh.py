# SPDX-License-Identifier: MIT
"""Triangle meshes: repaired, sampled, and compared with surfaces."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

from . import _records
from ._arrays import INDICES, Array, block_in, new_array, output, reshaped, view
from ._context import Context, resolve
from ._errors import new_struct
from ._handles import Owner
from ._library import lib
from ._names import EDGES, FACES, PARTS, number_of
from ._operation import Operation, Progress, make, run
from ._records import get, read

if TYPE_CHECKING:
    from ._records import MeshEdgesInfo, MeshInfo


class MeshSamples(NamedTuple):
    """Result of `Mesh.sample`: points on the mesh and their unit normals, float64 (n, 3) each."""

    points: Array
    normals: Array


class MeshEdges(NamedTuple):
    """The sharp edges of a mesh, and the smooth patches between them.

    Attributes
    ----------
    sharp : array of int32, shape (m, 3)
        1 if the edge from corner k of a face to the next corner is sharp, 2 if it is a tangent edge, else 0.
    patches : array of int32, shape (m,)
        The number of each face's patch, from 0 in the order of their first faces.
    info : MeshEdgesInfo
        Numbers and lengths of the edges.
    """

    sharp: Array
    patches: Array
    info: MeshEdgesInfo


class Mesh(Owner):
    """A triangle mesh, repaired and oriented.

    Vertices at the same place are joined.  Faces without area, repeated faces and unused vertices are left out.  Faces are
    turned to agree, and closed components to face outward.  `info` counts all this.  A mesh never changes, and several
    threads may use it at the same time.

    Parameters
    ----------
    vertices : array of float, shape (n, 3)
        The places of the vertices; coordinates up to 1e60.
    triangles : array of int, shape (m, 3)
        Numbers of vertices, from 0, counter-clockwise as seen from outside.
    parts : {"outer", "all", "largest", "solids"}
        Which components are kept: all except those inside a closed one; all; the one of the largest area; all except open
        ones inside a closed one.  With "all" and "solids", closed components inside an odd number of others are cavities.
    crease_angle : float
        Angle between the normals of two faces, in degrees, 0 to 180; faces that meet at a larger angle do not share
        corner normals.
    faces : {"turn", "keep"}
        Whether faces are turned to agree with their component, and closed components to face outward.
    progress, operation, context
        As in `Model.fit`.

    Raises
    ------
    InvalidArgumentError
        If an index is not that of a vertex (the message names the face and the index), a corner is not finite, or no face
        has an area.
    OutOfMemoryError, CancelledError

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
        given = context._handle, desc
        super().__init__(make("mesh", lib.hrbfnpr_mesh_create, given, operation, progress, context._handle, context))
        del keep
        self._made_in = context

    @property
    def info(self) -> MeshInfo:
        """What making the mesh found and did."""
        return get(_records.MeshInfo, lib.hrbfnpr_mesh_get_info, self._handle)

    @property
    def _view(self) -> Tuple[Any, ...]:
        return lib.hrbfnpr_mesh_view, self._handle

    vertices = view("MESH", "VERTEX", "The vertices that are kept, float64 (n, 3); a read-only view, without a copy.")
    triangles = view("MESH", "TRIANGLE", "The numbers of the vertices of each face, int32 (m, 3); a read-only view.")
    components = view("MESH", "COMPONENT", "The number of each face's component, from 0, int32 (m,); a read-only view.")
    given_faces = view("MESH", "GIVEN_FACE", "The number of each face among the given ones, int32 (m,); a read-only view.")
    _corner_normals = view("MESH", "CORNER_NORMAL", "The normals of all corners, shape (3 m, 3).")

    @property
    def corner_normals(self) -> Array:
        """The unit normals of the corners of each face, float64 (m, 3, 3); with NumPy, a read-only view."""
        flat = self._corner_normals
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
        """Choose points with normals that are evenly spread over the mesh; every prefix of them is even, too.

        Parameters
        ----------
        count : int
            Number of samples, 1 to 10 000 000.
        candidates : int
            Number of random places to choose from, up to 1 000 000; 0 = 40 for each sample.  More candidates give more
            even samples, in more time.  If there are only `count` candidates, all are taken, in random order.
        random_seed : int
            Start of the random numbers.
        progress, operation
            As in `Model.fit`.

        Returns
        -------
        MeshSamples
            Points and unit normals, which are interpolated between those of the corners.
        """
        desc = new_struct("hrbfnpr_sample_desc")
        desc.candidates, desc.random_seed = candidates, random_seed
        points, points_out = output("points", None, (max(count, 0),), 3, "d")
        normals, normals_out = output("normals", None, (max(count, 0),), 3, "d")
        given = self._handle, desc, points_out, normals_out
        run(lib.hrbfnpr_mesh_sample, given, operation, progress, self._made_in._handle)
        return MeshSamples(points, normals)

    def edges(
        self,
        *,
        edges: str = "auto",
        crease_angle: float = 30.0,
        far: float = 0.0,
        tangent: bool = False,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> MeshEdges:
        """Find the sharp edges and the smooth patches between them, as `Model.fit_mesh` does.

        An edge that bends by more than `crease_angle` is sharp.  If a sharp edge ends within a patch, it goes on along
        edges that bend by 8 degrees or more and keep its direction.  Short sharp edges that separate nothing are dropped as
        noise.

        Parameters
        ----------
        edges : {"auto", "smooth", "sharp"}
            "auto": an edge is sharp if it stands out from the faces beside it, as the edges of machine parts do.
            "smooth": no edge is sharp.  "sharp": every edge that bends by more than `crease_angle` is sharp.
        crease_angle : float
            Angle between the normals of two faces, in degrees, 1 to 179.
        far : float
            Distance that decides about coarse faces, in the mesh's unit; 0 = 0.01 diagonals.  If a round surface would
            leave such faces by more than four fifths of it, they stay flat, with sharp edges.
        tangent : bool
            Whether tangent edges are found, too.  Along these, two surfaces of a part touch without a kink but bend
            differently, such as a fillet and a plane.
        progress, operation
            As in `Model.fit`.

        Returns
        -------
        MeshEdges
            The sharp edges, the patches and an info.
        """
        desc, info = new_struct("hrbfnpr_mesh_edges_desc"), new_struct("hrbfnpr_mesh_edges_info")
        desc.edges, desc.crease_angle, desc.far = number_of("edges", EDGES, edges), crease_angle, far
        desc.tangent = tangent
        count = self.triangles.shape[0]
        patches, patches_out = output("patch", new_array((count,), "i"), (count,), 1, "i")
        sharp, sharp_out = output("sharp", new_array((count, 3), "i"), (count,), 3, "i")
        given = self._handle, desc, patches_out, sharp_out, info
        run(lib.hrbfnpr_mesh_edges, given, operation, progress, self._made_in._handle)
        return MeshEdges(sharp, patches, read(_records.MeshEdgesInfo, info))

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
    """Choose points so that each is the farthest from those before it; every prefix is evenly spread.

    Parameters
    ----------
    points : array of float, shape (n, 3)
        The points to choose from; finite.
    count : int
        Number of points to choose, 1 to n.
    progress, operation, context
        As in `Model.fit`.

    Returns
    -------
    indices : array of int64, shape (count,)
        The numbers of the chosen points.  The first is the point nearest to the middle of the bounding box.  If two points
        are equally far, the one with the lower number comes first.
    distances : array of float64, shape (count,)
        The distance of each chosen point from those before it; infinite for the first.
    """
    context = resolve(context)
    block = block_in("points", points)
    indices, indices_out = output("indices", new_array((max(count, 0),), "q"), (max(count, 0),), 1, "q")
    distances, distances_out = output("distance", None, (max(count, 0),), 1, "d")
    given = context._handle, block.view(), indices_out, distances_out
    run(lib.hrbfnpr_farthest_points, given, operation, progress, context._handle)
    return indices, distances
