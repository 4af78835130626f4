# SPDX-License-Identifier: MIT
"""Models by meshes: fitted to them, and compared with them."""
from __future__ import annotations

from typing import Any, Optional, Type, TypeVar

from ._errors import new_struct
from ._library import lib
from ._mesh import Mesh
from ._names import EDGES, KERNELS, SOLVERS, TRIMS, number_of
from ._operation import Operation, Progress, make
from ._records import Comparison, MeshFitInfo, read

M = TypeVar("M", bound="MeshFits")


class MeshFits:
    """What a `Model` does with a `Mesh`."""

    _handle: Any
    _context: Any
    _run: Any

    mesh_fit: Optional[MeshFitInfo] = None
    """What `fit_mesh` came to; None for other models, and for a loaded one."""

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
        """Fit a surface to a mesh with as many samples as that takes; see `mesh_fit` for what was reached.

        Parameters
        ----------
        mesh : Mesh
        tolerance : float
            How near the surface and the mesh are to be to each other, in units of the mesh; 0 = 0.002 of its
            diagonal.
        share : float
            Of both that has to be within the tolerance, above 0, at most 1.
        far : float
            What no part may be beyond; 0 = five times the tolerance.
        maximum_centres : int
            An end there, short of the tolerance, is no error: `mesh_fit.reached` is False.
        candidates : int
            Places on the mesh to choose from; 0 = by its area and its details.
        random_seed : int
        edges : {"auto", "smooth", "sharp"}
            What becomes of the mesh's edges: sharp where they stand out, as those of machine parts do; never; or wherever
            it bends by more than `crease_angle`. With "auto" closed parts that cross are fitted apart.
        crease_angle : float
            Degrees between the normals of two faces, 5 to 175: what bends more is an edge, and what rounding would take
            four fifths of `far` off the mesh.
        trim : {"auto", "never"}
            Whether the surface ends where an open mesh does, and what lies more than 0.009 diagonals (of coarse faces
            up to 0.015) off a mesh that was not reached is left out.
        kernel, kernel_radius, polynomial_degree, regularization, solver, progress, operation
            As in `fit`.

        Notes
        -----
        Where the surface goes on far from a mesh with an inside, f is held to the signed distance from the mesh at a few
        places off it: these are the last `mesh_fit.off_surface_centres` of `points`.

        With sharp edges the model is made of `mesh_fit.sheets` smooth fits, and its `points` are places all over the
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
        model.mesh_fit = read(MeshFitInfo, info)
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
        """How near the surface is to a mesh, and the mesh to the surface.

        Parameters
        ----------
        mesh : Mesh
            In the same coordinates.
        tolerance, far : float
            That shares are counted for, in units of the mesh; 0 = 0.002 and 0.01 of its diagonal.
        support : float
            Above 0: what the samples do not bear out by this limit is left out, as by `LineSet`.
        points : int
            On each side; 0 = 20000.
        cell_size : float
            Of the cells that the surface is looked for in; 0 = 1/128 of the diagonal, and finer where it is thin.
        random_seed : int
        """
        desc, result = new_struct("hrbfnpr_compare_desc"), new_struct("hrbfnpr_comparison")
        desc.tolerance, desc.far, desc.support = tolerance, far, support
        desc.points, desc.cell_size, desc.random_seed = points, cell_size, random_seed
        self._run(lib.hrbfnpr_model_compare_mesh, (mesh._handle, desc, result), operation, progress)
        return read(Comparison, result)
