# SPDX-License-Identifier: MIT
"""Models and meshes: fit a model to a mesh, and compare the two."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Type, TypeVar

from . import _records
from ._errors import new_struct
from ._library import lib
from ._mesh import Mesh
from ._names import EDGES, KERNELS, SOLVERS, TRIMS, number_of
from ._operation import Operation, Progress, make
from ._records import read

if TYPE_CHECKING:
    from ._records import Comparison, MeshFitInfo

M = TypeVar("M", bound="MeshFits")


class MeshFits:
    """The part of `Model` that deals with a `Mesh`."""

    _handle: Any
    _context: Any
    _run: Any

    mesh_fit: Optional[MeshFitInfo] = None
    """What `fit_mesh` reached; None for models that were made or loaded in another way."""

    @classmethod
    def fit_mesh(
        cls: Type[M],
        mesh: Mesh,
        *,
        tolerance: float = 0.0,
        share: float = 0.99,
        far: float = 0.0,
        maximum_centres: int = 8000,
        candidates: int = 0,
        random_seed: int = 1,
        edges: str = "auto",
        crease_angle: float = 30.0,
        kernel: str = "triharmonic",
        kernel_radius: float = 0.0,
        polynomial_degree: int = 1,
        regularization: float = 0.0,
        solver: str = "auto",
        trim: str = "auto",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> M:
        """Fit a surface to a mesh, with as many samples as the tolerance needs.

        A fit that does not reach the tolerance is no error: `mesh_fit` tells the result.

        Parameters
        ----------
        mesh : Mesh
            The mesh to fit.
        tolerance : float
            Largest distance between the surface and the mesh, in the mesh's unit, 1e-6 diagonals or more; 0 = 0.002
            diagonals.  A smaller tolerance needs more samples and time.
        share : float
            Share of both the surface and the mesh that must be within the tolerance, above 0, at most 1.
        far : float
            Distance that no part may exceed, in the mesh's unit, not below the tolerance; 0 = five times the tolerance.
        maximum_centres : int
            Largest number of centres, 16 to 1 000 000.  If the fit ends there, `mesh_fit.reached` is False.
        candidates : int
            Number of places on the mesh to choose samples from; 0 = by its area and its details.
        random_seed : int
            Start of the random numbers.
        edges : {"auto", "smooth", "sharp"}
            Which edges of the mesh stay sharp.  "auto": those that stand out, as on machine parts; closed parts that cross
            are fitted separately.  "smooth": none.  "sharp": all that bend by more than `crease_angle`.
        crease_angle : float
            Angle between the normals of two faces, in degrees, 5 to 175.  An edge that bends more is sharp.  So is an edge
            of coarse faces, if rounding it would move the surface off the mesh by four fifths of `far`.
        kernel, kernel_radius, polynomial_degree, regularization, solver
            As in `fit`.
        trim : {"auto", "never"}
            "auto": the surface of an open mesh ends where the mesh ends; if the tolerance was not reached, surface that is
            more than 0.009 diagonals (up to 0.015 with coarse faces) from the mesh is left out.
        progress, operation
            As in `fit`.

        Returns
        -------
        Model
            The model, with `mesh_fit`.

        Notes
        -----
        If the surface would go on far from a mesh that has an inside, the fit holds f to the signed distance from the mesh
        at a few places off it.  These places are the last `mesh_fit.off_surface_centres` of `points`.

        With sharp edges, the model consists of `mesh_fit.sheets` smooth fits, and its `points` are places all over the
        mesh.
        """
        desc, options = new_struct("hrbfnpr_mesh_fit_desc"), new_struct("hrbfnpr_fit_desc")
        desc.tolerance, desc.share, desc.far = tolerance, share, far
        desc.edges, desc.crease_angle = number_of("edges", EDGES, edges), crease_angle
        desc.maximum_centres, desc.candidates, desc.random_seed = maximum_centres, candidates, random_seed
        options.kernel = number_of("kernel", KERNELS, kernel)
        options.kernel_radius, options.polynomial_degree = kernel_radius, polynomial_degree
        options.regularization = regularization
        options.solver = number_of("solver", SOLVERS, solver)
        options.trim = number_of("trim", TRIMS, trim)
        context = mesh._made_in
        info = new_struct("hrbfnpr_mesh_fit_info")
        given = mesh._handle, desc, options, info
        made = make("model", lib.hrbfnpr_model_fit_mesh, given, operation, progress, context._handle, context)
        model: Any = cls(made, context)  # type: ignore[call-arg]
        model.mesh_fit = read(_records.MeshFitInfo, info)
        return model  # type: ignore[no-any-return]

    def compare(
        self,
        mesh: Mesh,
        *,
        tolerance: float = 0.0,
        far: float = 0.0,
        support: float = 0.0,
        points: int = 0,
        cell_size: float = 0.0,
        random_seed: int = 1,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Comparison:
        """Measure how near the surface is to a mesh, and the mesh to the surface.

        Parameters
        ----------
        mesh : Mesh
            The mesh, in the same coordinates as the model.
        tolerance : float
            Distance within which shares are counted, in the mesh's unit; 0 = 0.002 diagonals.
        far : float
            Distance beyond which surface counts as invented and mesh as missed, in the mesh's unit; 0 = 0.01 diagonals.
        support : float
            Above 0: surface that the samples do not support up to this limit is left out, as in `LineSet`.
        points : int
            Number of places to measure at, on the surface and on the mesh each, 100 to 10 000 000; 0 = 20 000.
        cell_size : float
            Size of the cells in which the surface is looked for, in the mesh's unit; 0 = 1/128 of the diagonal, and
            smaller where the surface is thin.  Thinner and smaller parts may be missed.
        random_seed : int
            Start of the random numbers.
        progress, operation
            As in `fit`.

        Returns
        -------
        Comparison
            Distances and shares, both ways.
        """
        desc, result = new_struct("hrbfnpr_compare_desc"), new_struct("hrbfnpr_comparison")
        desc.tolerance, desc.far, desc.support = tolerance, far, support
        desc.points, desc.cell_size, desc.random_seed = points, cell_size, random_seed
        self._run(lib.hrbfnpr_model_compare_mesh, (mesh._handle, desc, result), operation, progress)
        return read(_records.Comparison, result)
