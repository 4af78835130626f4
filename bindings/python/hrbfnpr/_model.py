# SPDX-License-Identifier: MIT
"""Models: implicit surfaces f = 0."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Optional, Tuple, Union

from . import _records, _streams
from ._arrays import Array, block_in, float_code, output, output_field, scalar, vector, view
from ._callbacks import check
from ._context import Context, resolve
from ._csg import Combining
from ._errors import new_error, new_struct
from ._fit_desc import fit_desc
from ._function import FunctionState, on_evaluate, on_release
from ._handles import own
from ._library import ffi, lib
from ._mesh_fit import MeshFits
from ._model_results import Curvature, Evaluation, Projection, RayHits
from ._numpy import np
from ._operation import Operation, Progress, make, run
from ._rays import HitArrays, pairs
from ._records import Vector, get
from ._trim import Trimming

if TYPE_CHECKING:
    from ._layer import LayersToMake
    from ._line_set import LineSet
    from ._point_set import PointSet
    from ._records import ModelInfo

Function = Callable[[Array], Any]


def _load(data: bytes) -> Model:
    return Model.load(data)


class Model(MeshFits, Trimming, Combining):
    """An implicit surface: f < 0 inside, f > 0 outside, and grad f has a length near 1 at the surface [NPAR 4].

    Make a model with `fit`, `fit_mesh`, `from_function` or `load`, or from other models with operators (``a | b``,
    ``a & b``, ``a - b``, ``~a``; see `hrbfnpr.csg`).  A model never changes, and several threads may use it at the same
    time.  It can be pickled, except if it comes from a function; it is then loaded in the default context.

    Arrays of points may have any shape (..., 3).  For a single point (three numbers), results have no first axis.  float32
    and float64 arrays are used without a copy.
    """

    def __init__(self, handle: Any, context: Context, function: Optional[FunctionState] = None) -> None:
        super().__init__(handle)
        self._context = context._handle
        self._function = function

    @classmethod
    def fit(
        cls,
        points: Array,
        normals: Optional[Array] = None,
        *,
        normal_mode: Optional[str] = None,
        kernel: str = "triharmonic",
        kernel_radius: float = 0.0,
        polynomial_degree: int = 1,
        regularization: Union[float, str] = 0.0,
        outliers: str = "keep",
        flipped_normals: str = "keep",
        tolerance: float = 0.0,
        maximum_centres: int = 0,
        solver: str = "auto",
        refinement_steps: int = 2,
        solver_tolerance: float = 0.0,
        iteration_limit: int = 200,
        preconditioner_neighbours: int = 0,
        trim: str = "auto",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
        context: Optional[Context] = None,
    ) -> Model:
        """Fit a surface to N samples, so that f(x_i) = 0 and grad f(x_i) = n_i [NPAR 4.1].

        Parameters
        ----------
        points : array of float, shape (N, 3)
            The samples, in any unit.  Samples that coincide and agree are merged.  One sample is enough: its surface is a
            plane.
        normals : array of float, shape (N, 3), optional
            The outward normals, of any length except 0.  None: they are found first, as by `orient`.
        normal_mode : {"given", "none", "unoriented", "mixed", "inward", "auto"}, optional
            How far the normals can be trusted, as in `orient`; with a mode other than "given", they are repaired or made
            first.  The default is "given", or "none" without normals.
        kernel : {"triharmonic", "gaussian", "wendland_c2"}
            The radial function: r^3 (default), exp(-r^2 / 2 radius^2), or (1 - r/radius)^4 (4 r/radius + 1) for r < radius.
        kernel_radius : float
            Radius of "gaussian" and "wendland_c2", in the unit of the points; 0 = from the sample spacing.  A larger
            radius fills larger gaps, but makes the system worse conditioned.
        polynomial_degree : int
            Degree of the added polynomial, -1 (none) to 3.  With "triharmonic" and a degree below 1, the fit may fail.
        regularization : float or "auto"
            Smoothing of the fit, 0 or more.  0 (default): the surface passes through every sample.  Larger values give a
            smoother surface that keeps a distance from noisy samples.  "auto": from the noise of the samples.
        outliers : {"keep", "drop"}
            What to do with samples far from all others, or far from the plane of their neighbours.
        flipped_normals : {"keep", "drop", "reorient"}
            What to do with samples whose normal is opposite to those of their neighbours.
        tolerance : float
            The fit chooses some samples as centres until all samples are within this distance of the surface, in the unit
            of the points; 0 = no such limit.  A smaller tolerance needs more centres.
        maximum_centres : int
            Largest number of samples that are chosen as centres; 0 = no limit.  If `tolerance` is 0, too, every sample is a
            centre.
        solver : {"auto", "direct", "iterative"}
            How the linear system is solved.  "direct" needs about 64 N^2 bytes, and time that grows with N^3.  "auto" takes
            "iterative" for many samples.
        refinement_steps : int
            Steps of iterative refinement after a direct solve, 0 to 20.
        solver_tolerance : float
            Relative residual at which the iterative solver ends, 0 to 0.1; 0 = automatic.
        iteration_limit : int
            Largest number of iterations of the iterative solver, 1 to 1 000 000.
        preconditioner_neighbours : int
            Number of neighbours of each sample in the preconditioner of the iterative solver, 1 to 48; 0 = automatic.
        trim : {"auto", "never"}
            "auto": an open surface ends where the samples end, as after `trim` with all samples; a closed one stays whole.
            Marks, lines and rays end there; `trim_info` counts the parts that were left out.  "never": the surface goes on to the
            end of the search box.
        progress : callable or progress bar, optional
            Receives the progress; see `Operation`.
        operation : Operation, optional
            An operation, to poll or cancel the fit from another thread.  Give it instead of `progress`.
        context : Context, optional
            The threads and the log to use; None: the default context.

        Returns
        -------
        Model
            The model.  `info` says how the fit went.

        Raises
        ------
        InvalidArgumentError
            If there are NaN, infinity, zero normals or samples at the same place with different normals (the message names
            the index), or the arrays are empty or do not match.
        SingularSystemError
            If the linear system has no unique solution within rounding.
        NotConvergedError
            If the iterative solver does not reach its tolerance.
        OutOfMemoryError, CancelledError
        """
        context = resolve(context)
        desc, keep = fit_desc(
            points, normals, normal_mode, kernel, regularization, outliers, flipped_normals, solver, trim,
            kernel_radius=kernel_radius, polynomial_degree=polynomial_degree, tolerance=tolerance,
            maximum_centres=maximum_centres, refinement_steps=refinement_steps, solver_tolerance=solver_tolerance,
            iteration_limit=iteration_limit, preconditioner_neighbours=preconditioner_neighbours,
        )  # fmt: skip
        given = context._handle, desc
        made = make("model", lib.hrbfnpr_model_fit, given, operation, progress, context._handle, context)
        del keep
        return cls(made, context)

    @classmethod
    def from_function(
        cls,
        value: Function,
        gradient: Optional[Function] = None,
        hessian: Optional[Function] = None,
        *,
        bounds: Any,
        difference_step: float = 0.0,
        thread_safe: bool = False,
        context: Optional[Context] = None,
    ) -> Model:
        """Make a model from an implicit function; every method works on it as on a fit [NPAR 8].

        Parameters
        ----------
        value : callable
            The function.  It gets points of shape (n, 3) and returns n values, negative inside.  They must be finite in a
            box twice as wide as the bounds.
        gradient : callable, optional
            Returns the gradients, shape (n, 3).  Their length should be near 1 at the surface.  None: from differences.
        hessian : callable, optional
            Returns the Hessians, shape (n, 3, 3) or (n, 6) (xx xy xz yy yz zz).  None: from differences.
        bounds : (minimum, maximum)
            Two corners of the box that holds the surface.  Choose it as small as you can: tolerances and steps are shares
            of its diagonal.
        difference_step : float
            Step of the differences, in the unit of the points; 0 = 1e-4 diagonals for gradients, 1e-3 for Hessians.
        thread_safe : bool
            Whether several threads may call the functions at the same time.  This helps functions that release the
            interpreter lock; plain Python code gains little.
        context : Context, optional
            As in `fit`.

        Returns
        -------
        Model
            The model.

        Notes
        -----
        If a function raises an exception, the call that evaluates it raises CallbackError, with the exception as its cause.
        """
        context = resolve(context)
        function = FunctionState(value, gradient, hessian)
        desc = new_struct("hrbfnpr_custom_desc")
        desc.flags = function.flags(thread_safe)
        desc.function, desc.release = on_evaluate, on_release
        desc.user = user = function.keep()
        desc.bounds_min, desc.bounds_max = (vector("bounds", corner) for corner in bounds)
        desc.difference_step = difference_step
        out, error = ffi.new("hrbfnpr_model **"), new_error()
        status = lib.hrbfnpr_model_create_custom(context._handle, desc, out, error)
        if status != 0:
            on_release(user)
        check(status, error)
        return cls(own(out[0], lib.hrbfnpr_model_release, context), context, function)

    def evaluate(
        self,
        points: Array,
        gradient: bool = False,
        hessian: bool = False,
        *,
        dtype: str = "float64",
        out: Optional[Evaluation] = None,
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Evaluation:
        """Evaluate f at points, and its gradient and Hessian if asked for.

        Parameters
        ----------
        points : array of float, shape (..., 3)
            The points; finite.
        gradient, hessian : bool
            Whether to compute the gradient and the Hessian.
        dtype : {"float64", "float32"}
            Type of the results.  The arithmetic is float64.
        out : Evaluation, optional
            Arrays to write to.  A field that is None is not computed; `gradient` and `hessian` are then ignored.
        progress, operation
            As in `fit`.

        Returns
        -------
        Evaluation
            `value` (...), `gradient` (..., 3) or None, and `hessian` (..., 6) or None: xx xy xz yy yz zz.
        """
        block = block_in("points", points)
        code = float_code(dtype)
        wanted = (1, 3 if gradient else 0, 6 if hessian else 0)
        if out is not None:
            wanted = tuple(0 if given is None else n for given, n in zip(out, (1, 3, 6)))  # type: ignore[assignment]
        given = (None, None, None) if out is None else out
        arrays, views = [], []
        for name, size, target in zip(("value", "gradient", "hessian"), wanted, given):
            array, view = output(name, target, block.shape, size, code) if size else (None, ffi.NULL)
            arrays.append(array)
            views.append(view)
        self._run(lib.hrbfnpr_model_evaluate, (block.view(), *views), operation, progress)
        return Evaluation(scalar(arrays[0], block.shape), arrays[1], arrays[2])

    def project(
        self,
        points: Array,
        *,
        evaluation_limit: int = 50,
        tolerance: float = 1e-9,
        armijo_slope: float = 1e-4,
        armijo_factor: float = 0.5,
        dtype: str = "float64",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Projection:
        """Project points onto the surface by steepest descent on f^2 with Armijo's rule [NPAR 4.2].

        Parameters
        ----------
        points : array of float, shape (..., 3)
            The points; finite.
        evaluation_limit : int
            Largest number of evaluations of f for each point, 1 to 1000.
        tolerance : float
            A point has converged if abs(f) / abs(grad f) is at most this number of diagonals; above 0.
        armijo_slope, armijo_factor : float
            sigma, between 0 and 0.5, and beta, between 0 and 1, of Armijo's rule.
        dtype : {"float64", "float32"}
            Type of the results.
        progress, operation
            As in `fit`.

        Returns
        -------
        Projection
            `position` (..., 3), `normal` (..., 3), `status` (...), and `converged`, the number of points that converged.  A
            point that fails keeps its last place.
        """
        block = block_in("points", points)
        desc = new_struct("hrbfnpr_project_desc")
        desc.evaluation_limit, desc.tolerance = evaluation_limit, tolerance
        desc.armijo_slope, desc.armijo_factor = armijo_slope, armijo_factor
        code = float_code(dtype)
        result = new_struct("hrbfnpr_projection")
        position = output_field(result, "position", block.shape, 3, code)
        normal = output_field(result, "normal", block.shape, 3, code)
        status = output_field(result, "status", block.shape, 1, "B")
        self._run(lib.hrbfnpr_model_project, (block.view(), desc, result), operation, progress)
        return Projection(position, normal, scalar(status, block.shape), result.converged)

    def curvature(
        self,
        points: Array,
        *,
        dtype: str = "float64",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> Curvature:
        """Compute the principal curvatures and directions of the level set through each point [NPAR 5.3].

        Parameters
        ----------
        points : array of float, shape (..., 3)
            The points; finite.
        dtype : {"float64", "float32"}
            Type of the results.
        progress, operation
            As in `fit`.

        Returns
        -------
        Curvature
            `k1` >= `k2` (...), in 1 / unit of length; they are negative where the surface bends away from its normal:
            -1/radius on a sphere.  `d1` and `d2` (..., 3): the directions, unit, tangent, perpendicular, of arbitrary sign.
            `confidence` (...), 0 to 1: it is 0 at umbilics and on planes, where `d1` and `d2` follow a smooth field.
        """
        block = block_in("points", points)
        code = float_code(dtype)
        result = new_struct("hrbfnpr_curvature")
        sizes = zip(Curvature._fields, (1, 1, 3, 3, 1))
        k1, k2, d1, d2, confidence = (output_field(result, name, block.shape, size, code) for name, size in sizes)
        self._run(lib.hrbfnpr_model_curvature, (block.view(), result), operation, progress)
        one = block.shape
        return Curvature(scalar(k1, one), scalar(k2, one), d1, d2, scalar(confidence, one))

    def cast_rays(
        self,
        origins: Array,
        directions: Array,
        *,
        maximum_hits: Optional[int] = None,
        t_min: float = 0.0,
        t_max: float = float("inf"),
        lipschitz: float = 0.0,
        smallest_step: float = 1e-4,
        tolerance: float = 1e-9,
        evaluation_limit: int = 20000,
        line_set: Optional[LineSet] = None,
        refine: bool = True,
        dtype: str = "float64",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> RayHits:
        """Find where rays origin + t direction meet the surface [Hart 1996, "Sphere tracing"].

        The surface is looked for in the model's bounds, enlarged by 0.05 diagonals on every side.

        A call with a few thousand rays on a fit prepares the model and is 30 to 60 times as fast, unless `lipschitz` is
        given.  It finds the same hits within the tolerance.

        Parameters
        ----------
        origins, directions : array of float, shape (..., 3)
            The rays.  A direction may have any length except 0.  Rays may start inside.  One origin, or one direction, may
            serve all rays.
        maximum_hits : int, optional
            Largest number of hits to find on each ray, 1 to 256; None: only the first hit.
        t_min, t_max : float
            Where rays begin and end, in lengths of the direction.  If a ray starts on the surface, begin beyond it.
        lipschitz : float
            A bound on the length of grad f; 0 = that of `lipschitz()`, which each call then computes.  If the bound is too
            small, hits may be missed; if it is too large, the call only takes longer.
        smallest_step : float
            Smallest step along a ray, in diagonals, above 0, at most 0.1.  Two hits that are closer than this, as on
            grazing rays and thin sheets, may be missed.
        tolerance : float
            Accuracy of the place of a hit along the ray, in diagonals, above 0.
        evaluation_limit : int
            Largest number of evaluations of f on each ray, 1 to 1 000 000.
        line_set : LineSet, optional
            A line set of this model.  Rays meet its mesh first, which is faster.  Parts of the surface that the mesh does
            not have are missed: those smaller than a cell, and those that a ray meets just beside the mesh's outline.
        refine : bool
            With `line_set`: move hits from the mesh to f = 0.  False: hits stay on the mesh, which is fastest.
        dtype : {"float64", "float32"}
            Type of the results.
        progress, operation
            As in `fit`.

        Returns
        -------
        RayHits
            `hits` (...): number of hits.  `t` (...), `position` (..., 3), `normal` (..., 3) and `entering` (...): 1 if the
            ray enters the inside.  `status` (...), and `hit_rays`, the number of rays that hit.  With `maximum_hits`, they
            have an axis for the hits, in the order of t: t (..., h), position (..., h, 3).  Without a hit, t is infinite
            and the other numbers are 0.
        """
        start, along = pairs(origins, directions)
        room = 1 if maximum_hits is None else maximum_hits
        desc = new_struct("hrbfnpr_cast_desc")
        desc.maximum_hits, desc.evaluation_limit = room, evaluation_limit
        desc.t_min, desc.t_max, desc.lipschitz = t_min, t_max, lipschitz
        desc.smallest_step, desc.tolerance = smallest_step, tolerance
        if line_set is not None:
            desc.line_set, desc.refine = line_set._handle, refine
        made = HitArrays(start.count, max(room, 0), float_code(dtype))
        self._run(lib.hrbfnpr_model_cast_rays, (start.view(), along.view(), desc, made.struct), operation, progress)
        each = start.shape if maximum_hits is None else (*start.shape, room)
        return RayHits(**made.shaped(start.shape, each), hit_rays=made.struct.hit_rays)

    def lipschitz(self, *, progress: Optional[Progress] = None, operation: Optional[Operation] = None) -> float:
        """Compute the bound on the length of grad f that `cast_rays` uses.

        For a solid of primitives it is a true bound.  For other models it is an estimate: 1.5 times the largest length of
        grad f at 24^3 points.  If you cast few rays in each call, compute it once and pass it to `cast_rays`, because each
        call without it evaluates these points.
        """
        bound = ffi.new("double *")
        self._run(lib.hrbfnpr_model_lipschitz, (bound,), operation, progress)
        return float(bound[0])

    def contains(
        self, points: Array, *, progress: Optional[Progress] = None, operation: Optional[Operation] = None
    ) -> Array:
        """Tell which points lie inside the surface: where f < 0, in the bounds enlarged by 0.05 diagonals on every side.

        Parameters
        ----------
        points : array of float, shape (..., 3)
            The points; finite.
        progress, operation
            As in `fit`.

        Returns
        -------
        array of bool, shape (...)
            Whether each point is inside; without NumPy, 0 or 1.
        """
        block = block_in("points", points)
        inside, inside_out = output("inside", None, block.shape, 1, "B")
        self._run(lib.hrbfnpr_model_contains, (block.view(), inside_out, ffi.NULL), operation, progress)
        return scalar(inside if np is None else inside.view(bool), block.shape)

    def generate(self, layers: Optional[LayersToMake] = None, **options: Any) -> PointSet:
        """Place marks on the surface, as `PointSet.generate` does with this model: ``model.generate(preset="full")``."""
        from ._point_set import PointSet

        return PointSet.generate(self, layers, **options)

    @property
    def info(self) -> ModelInfo:
        """What the fit found and did."""
        return get(_records.ModelInfo, lib.hrbfnpr_model_get_info, self._handle)

    @property
    def bounds(self) -> Tuple[Vector, Vector]:
        """Two corners of the box of the samples, or the bounds of a function."""
        info = self.info
        return info.bounds_min, info.bounds_max

    @property
    def _view(self) -> Tuple[Any, ...]:
        return lib.hrbfnpr_model_view, self._handle

    points = view("MODEL", "POSITION", "The centres or, with sharp edges, places all over the surface, float64 (n, 3); a "
                  "read-only view, without a copy.  Empty for a function and for a solid.")  # fmt: skip
    normals = view("MODEL", "NORMAL", "The unit normals at `points`, float64 (n, 3); a read-only view.")
    residual_history = view("MODEL", "RESIDUAL_HISTORY", "The relative residual after each iteration of the iterative "
                            "solver, float64 (iterations,).\n\nEmpty after a direct solve, for a loaded model and for a "
                            "function.")  # fmt: skip

    def save(self, target: _streams.Target) -> None:
        """Write the model to a path or to a binary file object.

        A file is written whole or not at all.  The data has a version and a checksum, and a loaded model evaluates to the
        same bits.  A model with a function cannot be saved.
        """
        _streams.save(lib.hrbfnpr_model_save, self._handle, target)

    def to_bytes(self) -> bytes:
        """Return the bytes that `save` writes."""
        return _streams.to_bytes(lib.hrbfnpr_model_save, self._handle)

    @classmethod
    def load(cls, source: _streams.Source, *, context: Optional[Context] = None) -> Model:
        """Read a model from a path, a binary file object or bytes.

        Raises
        ------
        CorruptDataError
            If the data is not a saved model, or is truncated or damaged.
        VersionMismatchError
            If a newer library wrote it.
        """
        context = resolve(context)
        out = ffi.new("hrbfnpr_model **")
        functions = lib.hrbfnpr_model_load, lib.hrbfnpr_model_load_memory
        _streams.load(*functions, context._handle, out, source)
        return cls(own(out[0], lib.hrbfnpr_model_release, context), context)

    def __reduce__(self) -> Any:
        return _load, (self.to_bytes(),)

    def __repr__(self) -> str:
        if self.closed:
            return "<hrbfnpr.Model closed>"
        info = self.info
        if info.kernel == "csg":
            return f"<hrbfnpr.Model csg, {self.csg_info.nodes} nodes>"
        return f"<hrbfnpr.Model {info.kernel}, {info.centres} centres>"

    def _run(self, function: Any, arguments: Tuple[Any, ...], operation: Any, progress: Any) -> None:
        """Make a long call with this model."""
        run(function, (self._handle, *arguments), operation, progress, self._context, shared=self._function)
