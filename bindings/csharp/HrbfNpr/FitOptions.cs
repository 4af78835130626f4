// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How <see cref="Model.Fit(ArrayView, ArrayView, FitOptions, Context, System.IProgress{double}, System.Threading.CancellationToken)"/> fits.</summary>
    public sealed class FitOptions
    {
        /// <summary>Radial function; r^3 by default.</summary>
        public Kernel Kernel { get; set; }

        /// <summary>Radius of the other kernels, in the unit of the points; 0 = from the sample spacing (default).</summary>
        public double KernelRadius { get; set; }

        /// <summary>-1 (none) to 3; 1.  The r^3 kernel is well-posed from 1 on.</summary>
        public int PolynomialDegree { get; set; } = 1;

        /// <summary>0 interpolates (default); more is smoother.  Not below 0.</summary>
        public double Regularization { get; set; }

        /// <summary>Auto takes the regularization from the noise of the samples; Given by default.</summary>
        public RegularizationMode RegularizationMode { get; set; }

        /// <summary>What becomes of samples far from all others: kept (default) or dropped.</summary>
        public Repair Outliers { get; set; }

        /// <summary>What becomes of samples whose normal is against those around them; kept by default.</summary>
        public Repair FlippedNormals { get; set; }

        /// <summary>
        /// Above 0: samples are chosen as centres until all lie this near to the surface, in the unit of the points;
        /// 0 = no such end (default).
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>Above 0: no more samples than this are chosen as centres; 0 = no limit (default).</summary>
        public long MaximumCentres { get; set; }

        /// <summary>Auto by default.</summary>
        public Solver Solver { get; set; }

        /// <summary>Steps of iterative refinement after a direct solve, 0 to 20; 2.</summary>
        public int RefinementSteps { get; set; } = 2;

        /// <summary>Relative residual at which the iterative solver ends; 0 = automatic (default).</summary>
        public double SolverTolerance { get; set; }

        /// <summary>Most iterations of the iterative solver; 200.</summary>
        public int IterationLimit { get; set; } = 200;

        /// <summary>Of the iterative solver, 1 to 48; 0 = automatic (default).</summary>
        public int PreconditionerNeighbours { get; set; }

        /// <summary>What is known of the normals; Given by default.  With all others they are first made by
        /// <see cref="Orientation.Find"/>; None, and Auto, need no normals: pass default(ArrayView).</summary>
        public Normals NormalMode { get; set; }

        /// <summary>Whether the surface ends where the samples of an open one do; Auto by default.  See
        /// <see cref="Model.TrimInfo"/>.</summary>
        public TrimMode Trim { get; set; } = TrimMode.Auto;

        internal void Write(ref hrbfnpr_fit_desc desc)
        {
            desc.trim = (uint)Trim;
            desc.normal_mode = (uint)NormalMode;
            desc.kernel = (uint)Kernel;
            desc.kernel_radius = KernelRadius;
            desc.polynomial_degree = PolynomialDegree;
            desc.regularization_mode = (uint)RegularizationMode;
            desc.regularization = Regularization;
            desc.outliers = (uint)Outliers;
            desc.flipped_normals = (uint)FlippedNormals;
            desc.tolerance = Tolerance;
            desc.maximum_centres = MaximumCentres;
            desc.solver = (uint)Solver;
            desc.refinement_steps = RefinementSteps;
            desc.solver_tolerance = SolverTolerance;
            desc.iteration_limit = IterationLimit;
            desc.preconditioner_neighbours = unchecked((uint)PreconditionerNeighbours);
        }
    }

    /// <summary>How points are projected on a surface.</summary>
    public sealed class ProjectOptions
    {
        /// <summary>Evaluations of f at each point, 1 to 1000; 50.</summary>
        public int EvaluationLimit { get; set; } = 50;

        /// <summary>A point has converged when |f| / |grad f| is at most this share of the diagonal; 1e-9.</summary>
        public double Tolerance { get; set; } = 1e-9;

        /// <summary>sigma of Armijo's rule, in (0, 0.5); 1e-4.</summary>
        public double ArmijoSlope { get; set; } = 1e-4;

        /// <summary>beta of Armijo's rule, in (0, 1); 0.5.</summary>
        public double ArmijoFactor { get; set; } = 0.5;

        internal void Write(ref hrbfnpr_project_desc desc)
        {
            desc.evaluation_limit = EvaluationLimit;
            desc.tolerance = Tolerance;
            desc.armijo_slope = ArmijoSlope;
            desc.armijo_factor = ArmijoFactor;
        }
    }

    /// <summary>How rays are cast.</summary>
    public sealed class CastOptions
    {
        /// <summary>Hits to find on a ray, 1 to 256; 1 is the first.</summary>
        public int MaximumHits { get; set; } = 1;

        /// <summary>Evaluations of f on each ray, 1 to 1000000; 20000.</summary>
        public int EvaluationLimit { get; set; } = 20000;

        /// <summary>Where rays begin, in lengths of their direction; 0.</summary>
        public double TMin { get; set; }

        /// <summary>Where rays end, not below <see cref="TMin"/>; infinity.</summary>
        public double TMax { get; set; } = double.PositiveInfinity;

        /// <summary>Bound on |grad f| near the bounds; 0 = <see cref="Model.Lipschitz"/> at each call (default).</summary>
        public double Lipschitz { get; set; }

        /// <summary>In diagonals, above 0, at most 0.1; 1e-4.  What is met for a shorter length may be missed.</summary>
        public double SmallestStep { get; set; } = 1e-4;

        /// <summary>On the place of a hit along the ray, in diagonals, above 0; 1e-9.</summary>
        public double Tolerance { get; set; } = 1e-9;

        internal void Write(ref hrbfnpr_cast_desc desc)
        {
            desc.maximum_hits = MaximumHits;
            desc.evaluation_limit = EvaluationLimit;
            desc.t_min = TMin;
            desc.t_max = TMax;
            desc.lipschitz = Lipschitz;
            desc.smallest_step = SmallestStep;
            desc.tolerance = Tolerance;
        }
    }
}
