# SPDX-License-Identifier: MIT
"""Models: implicit surfaces f = 0."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Optional, Tuple, Union

from . import _streams
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
from ._records import ModelInfo, Vector, get
from ._trim import Trimming

if TYPE_CHECKING:
    from ._layer import LayersToMake
    from ._point_set import PointSet

Function = Callable[[Array], Any]


def _load(data: bytes) -> Model:
    return Model.load(data)


class Model(MeshFits, Trimming, Combining):
    """An implicit surface: f < 0 inside, f > 0 outside, with a gradient near 1 at the surface [NPAR 4].

    Immutable: any number of threads may use one model at a time.  Made by `fit`, `from_function`,
    `load`, or from others by operators (``a | b``, ``a & b``, ``a - b``, ``~a``; see `hrbfnpr.csg`); can be pickled
    (but for one from a function), and is then loaded in the default context.

    A call that is given a single point (three numbers) returns results without the first axis;
    arrays of points may have any shape (..., 3).  float32 and float64 arrays are used in place.
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
        """Fit f with f(x_i) = 0 and grad f(x_i) = n_i to N samples [NPAR 4.1].

        Parameters
        ----------
        points, normals : array of float, shape (N, 3)
            Samples and their outward normals, in any unit.  Normals that are not of unit length are
            normalised; samples that coincide and agree are merged.  One sample is a plane.
            Without normals they are found first: see `orient`, as with every mode but "given".
        normal_mode : {"given", "none", "unoriented", "mixed", "inward", "auto"}, optional
            What is known of the normals; "given", or "none" without any.
        kernel : {"triharmonic", "gaussian", "wendland_c2"}
            r^3 (default), exp(-r^2 / 2 radius^2), or (1 - r/radius)^4 (4 r/radius + 1).
        kernel_radius : float
            Radius of the last two, in the unit of the points; 0 = from the sample spacing.
        polynomial_degree : int
            -1 (none) to 3.
        regularization : float or "auto"
            0 interpolates (default); more is smoother; "auto" takes it from the noise of the samples.
        outliers : {"keep", "drop"}
            What becomes of samples far from all others, or from the plane of those around them.
        flipped_normals : {"keep", "drop", "reorient"}
            What becomes of samples whose normal is against those around them.
        tolerance : float
            Choose samples as centres until all lie this near to the surface; 0 = no such end.
        maximum_centres : int
            Choose no more samples than this as centres; 0 = no limit.  With tolerance 0, too, every
            sample is a centre.
        solver : {"auto", "direct", "iterative"}
            "direct" is a dense factorisation: about 64 N^2 bytes, time N^3.
        refinement_steps : int
            Of iterative refinement after a direct solve, 0 to 20.
        solver_tolerance : float
            Relative residual at which the iterative solver ends; 0 = automatic.
        iteration_limit : int
            Most iterations of the iterative solver.
        preconditioner_neighbours : int
            Size of the iterative solver's local problems, 1 to 48; 0 = automatic.
        trim : {"auto", "never"}
            Whether the surface ends where the samples of an open one do, as by `Model.trim` with all samples: marks,
            lines and rays do; `trim_info` tells.  A closed one stays as it is.
        progress : callable or progress bar, optional
            See `Operation`.
        operation : Operation, optional
            To poll or cancel the fit from another thread; instead of `progress`.
        context : Context, optional

        Raises
        ------
        InvalidArgumentError
            For NaN, infinity, zero normals, coincident samples that disagree (the message names the
            index), and mismatched or empty arrays.
        SingularSystemError
            If there is no (numerically) unique solution.
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
        """Any implicit function in place of a fit: every operator works on it [NPAR 8].

        Parameters
        ----------
        value : callable
            Takes points of shape (n, 3) and returns n values, negative inside, finite within twice
            the bounds.
        gradient, hessian : callable, optional
            Return shapes (n, 3) and (n, 3, 3) or (n, 6) (xx xy xz yy yz zz); differenced if omitted.
            The gradient should be near 1 in length at the surface.
        bounds : (minimum, maximum)
            Two corners of the box that the surface lies in.
        difference_step : float
            For differences; 0 = 1e-4 of the box's diagonal (1e-3 for the Hessian).
        thread_safe : bool
            Whether the functions may be called from several threads at once.  Python code gains
            little by it; code that releases the interpreter lock does.
        context : Context, optional

        Notes
        -----
        An exception in a function makes the call that evaluates it raise CallbackError, with the
        exception as its cause.
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
        """f at points, and, if asked for, its gradient and Hessian.

        Parameters
        ----------
        points : array of float, shape (..., 3)
        gradient, hessian : bool
            Whether to compute them too.
        dtype : {"float64", "float32"}
            Type of the results; the arithmetic is float64.
        out : Evaluation, optional
            Arrays to write to; a field that is None is not computed, whatever the flags say.

        Returns
        -------
        Evaluation
            value (...), gradient (..., 3) or None, hessian (..., 6) or None: xx xy xz yy yz zz.
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
        """Project points on the surface by steepest descent on f^2 with Armijo's rule [NPAR 4.2].

        Parameters
        ----------
        points : array of float, shape (..., 3)
        evaluation_limit : int
            Evaluations of f at each point, 1 to 1000.
        tolerance : float
            A point has converged when abs(f) / abs(grad f) is at most this share of the diagonal.
        armijo_slope, armijo_factor : float
            sigma in (0, 0.5) and beta in (0, 1) of the rule.
        dtype : {"float64", "float32"}

        Returns
        -------
        Projection
            position (..., 3), normal (..., 3), status (...) and the number of points that
            converged.  A point that fails keeps its last iterate.
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
        """Principal curvatures and directions of the level set through each point [NPAR 5.3].

        Parameters
        ----------
        points : array of float, shape (..., 3)
        dtype : {"float64", "float32"}

        Returns
        -------
        Curvature
            k1 >= k2 (...): negative where the surface bends away from its normal, -1/radius on a
            sphere; d1, d2 (..., 3): unit, orthogonal, tangent, of arbitrary sign; confidence (...)
            in [0, 1]: 0 at umbilics and on planes, where d1 and d2 fall back to a smooth field.
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
        dtype: str = "float64",
        progress: Optional[Progress] = None,
        operation: Optional[Operation] = None,
    ) -> RayHits:
        """Where rays origin + t direction meet the surface [Hart 1996, "Sphere tracing"].

        Parameters
        ----------
        origins, directions : array of float, shape (..., 3)
            A direction may have any length but zero; rays may start inside.  One origin, or one
            direction, serves all rays.
        maximum_hits : int, optional
            Find up to so many hits of each ray, 1 to 256; None finds the first.
        t_min, t_max : float
            Where rays begin and end, in lengths of the direction.  To leave a surface that a ray
            starts on, begin behind it.
        lipschitz : float
            Bound on the length of grad f in the bounds grown by 0.05 diagonals, beyond which no
            surface is looked for; 0 = `lipschitz()` at each call.
        smallest_step : float
            In diagonals, at most 0.1.  What is met for a shorter length than this may be missed:
            grazing rays, and thinner sheets.
        tolerance : float
            On the place of a hit along the ray, in diagonals.
        evaluation_limit : int
            Evaluations of f on each ray, 1 to 1000000.
        dtype : {"float64", "float32"}

        Returns
        -------
        RayHits
            hits (...): how many; t (...), position (..., 3), normal (..., 3) and entering (...), 1
            where f goes from + to -; status (...), and the number of rays that hit.  With
            maximum_hits they have an axis for the hits, in order: t (..., h), position (..., h, 3).
            Where there is no hit t is infinite and the rest 0.
        """
        start, along = pairs(origins, directions)
        room = 1 if maximum_hits is None else maximum_hits
        desc = new_struct("hrbfnpr_cast_desc")
        desc.maximum_hits, desc.evaluation_limit = room, evaluation_limit
        desc.t_min, desc.t_max, desc.lipschitz = t_min, t_max, lipschitz
        desc.smallest_step, desc.tolerance = smallest_step, tolerance
        made = HitArrays(start.count, max(room, 0), float_code(dtype))
        self._run(lib.hrbfnpr_model_cast_rays, (start.view(), along.view(), desc, made.struct), operation, progress)
        each = start.shape if maximum_hits is None else (*start.shape, room)
        return RayHits(**made.shaped(start.shape, each), hit_rays=made.struct.hit_rays)

    def lipschitz(self, *, progress: Optional[Progress] = None, operation: Optional[Operation] = None) -> float:
        """The bound that `cast_rays` takes: the largest length of grad f at 24^3 points, times 1.5.

        An estimate, and no proof; of solids of primitives a bound that holds.  Pass it to `cast_rays` if you cast few
        rays at a time: otherwise each call evaluates those points.
        """
        bound = ffi.new("double *")
        self._run(lib.hrbfnpr_model_lipschitz, (bound,), operation, progress)
        return float(bound[0])

    def contains(
        self, points: Array, *, progress: Optional[Progress] = None, operation: Optional[Operation] = None
    ) -> Array:
        """Which points, of shape (..., 3), lie inside the surface; of shape (...), bool (without NumPy: 0 or 1).

        That is, where f < 0, and in the bounds grown by 0.05 diagonals on every side.
        """
        block = block_in("points", points)
        inside, inside_out = output("inside", None, block.shape, 1, "B")
        self._run(lib.hrbfnpr_model_contains, (block.view(), inside_out, ffi.NULL), operation, progress)
        return scalar(inside if np is None else inside.view(bool), block.shape)

    def generate(self, layers: Optional[LayersToMake] = None, **options: Any) -> PointSet:
        """Place marks on the surface: `PointSet.generate` with this model, as `model.generate(preset="full")`."""
        from ._point_set import PointSet

        return PointSet.generate(self, layers, **options)

    @property
    def info(self) -> ModelInfo:
        """What the fit did."""
        return get(ModelInfo, lib.hrbfnpr_model_get_info, self._handle)

    @property
    def bounds(self) -> Tuple[Vector, Vector]:
        """Two corners of the box of the samples, or of the function's bounds."""
        info = self.info
        return info.bounds_min, info.bounds_max

    @property
    def _view(self) -> Tuple[Any, ...]:
        return lib.hrbfnpr_model_view, self._handle

    points = view("MODEL", "POSITION", "The centres, or, with sharp edges, places all over the surface, float64 (n, 3): a "
                  "read-only view, nothing is copied.  Empty for a function.")  # fmt: skip
    normals = view("MODEL", "NORMAL", "The unit normals of the centres, as `points`.")
    residual_history = view("MODEL", "RESIDUAL_HISTORY", "Relative residual after each iteration of the iterative solver, "
                            "float64 (iterations,).\n\nEmpty after a direct solve, for a loaded model and for a "
                            "function.")  # fmt: skip

    def save(self, target: _streams.Target) -> None:
        """Write to a path (atomically) or a binary file object.  A function cannot be saved.

        The data is versioned and checksummed; a loaded model evaluates to the same bits.
        """
        _streams.save(lib.hrbfnpr_model_save, self._handle, target)

    def to_bytes(self) -> bytes:
        """What `save` writes."""
        return _streams.to_bytes(lib.hrbfnpr_model_save, self._handle)

    @classmethod
    def load(cls, source: _streams.Source, *, context: Optional[Context] = None) -> Model:
        """Read from a path, a binary file object or bytes.

        Raises
        ------
        CorruptDataError
            If the data is not a saved model, or cut short or damaged.
        VersionMismatchError
            If it was written by a newer library.
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
        """A long call with this model."""
        run(function, (self._handle, *arguments), operation, progress, self._context, shared=self._function)
