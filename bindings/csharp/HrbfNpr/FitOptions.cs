// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How <c>Model.Fit</c> fits; a new one holds all defaults.</summary>
    public sealed class FitOptions
    {
        /// <summary>The radial function: Triharmonic, Gaussian or WendlandC2; default Triharmonic.</summary>
        public Kernel Kernel { get; set; }

        /// <summary>
        /// Radius of Gaussian and WendlandC2, in the unit of the points; 0 or more; default 0 = from the sample
        /// spacing.  A larger radius fills larger gaps, but makes the system worse conditioned.
        /// </summary>
        public double KernelRadius { get; set; }

        /// <summary>
        /// Degree of the polynomial that is added to the kernels; -1 (none) to 3; default 1.  Triharmonic is well-posed
        /// from 1 on.
        /// </summary>
        public int PolynomialDegree { get; set; } = 1;

        /// <summary>
        /// Smoothing of the fit; 0 or more; default 0 = pass through every sample.  Larger values give a smoother
        /// surface that keeps a distance from noisy samples.
        /// </summary>
        public double Regularization { get; set; }

        /// <summary>
        /// Where the regularization comes from; default Given.  Auto needs a <see cref="Regularization"/> of 0.
        /// </summary>
        public RegularizationMode RegularizationMode { get; set; }

        /// <summary>What to do with samples far from all others: Keep or Drop; default Keep.</summary>
        public Repair Outliers { get; set; }

        /// <summary>
        /// What to do with samples whose normals are opposite to those of their neighbours; default Keep.
        /// </summary>
        public Repair FlippedNormals { get; set; }

        /// <summary>
        /// Largest distance of a sample from the surface at which no more centres are chosen, in the unit of the
        /// points; 0 or more; default 0 = none.  Smaller values give more centres.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>
        /// Largest number of samples that are chosen as centres; 0 or more; default 0 = no limit.  If
        /// <see cref="Tolerance"/> is 0, too, every sample is a centre.
        /// </summary>
        public long MaximumCentres { get; set; }

        /// <summary>How the linear system is solved; default Auto.</summary>
        public Solver Solver { get; set; }

        /// <summary>
        /// Steps of iterative refinement after a Direct solve; 0 to 20; default 2.  More steps give smaller residuals.
        /// </summary>
        public int RefinementSteps { get; set; } = 2;

        /// <summary>
        /// Relative residual at which Iterative ends; 0 to 0.1; default 0 = 1e-10 up to 2048 centres, 1e-8 beyond.
        /// </summary>
        /// <remarks>If rounding allows no more, the default may be up to 1e-6; the log then warns.</remarks>
        public double SolverTolerance { get; set; }

        /// <summary>Largest number of iterations of Iterative; 1 to 1000000; default 200.</summary>
        public int IterationLimit { get; set; } = 200;

        /// <summary>
        /// Neighbours of each sample in the preconditioner of Iterative; 1 to 48; default 0 = by the kernel and the
        /// number of samples.  More neighbours give fewer iterations and a longer setup.
        /// </summary>
        public int PreconditionerNeighbours { get; set; }

        /// <summary>
        /// How far the normals can be trusted; default Given.  None and Auto work without normals: pass
        /// <c>default(ArrayView)</c>.
        /// </summary>
        /// <remarks>
        /// With a mode other than Given, the fit first makes or repairs the normals, as <see cref="Orientation.Find"/>
        /// does.
        /// </remarks>
        public Normals NormalMode { get; set; }

        /// <summary>
        /// Whether the surface ends where its samples end; default Auto.  <see cref="Model.TrimInfo"/> tells the result.
        /// </summary>
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

    /// <summary>How points are projected onto a surface; a new one holds all defaults.</summary>
    public sealed class ProjectOptions
    {
        /// <summary>Largest number of evaluations of f for each point; 1 to 1000; default 50.</summary>
        public int EvaluationLimit { get; set; } = 50;

        /// <summary>
        /// Largest distance |f| / |grad f| from the surface at which the projection ends, in diagonals; above 0;
        /// default 1e-9.
        /// </summary>
        public double Tolerance { get; set; } = 1e-9;

        /// <summary>
        /// sigma of Armijo's rule: the share of the expected decrease that a step must reach; between 0 and 0.5;
        /// default 1e-4.
        /// </summary>
        public double ArmijoSlope { get; set; } = 1e-4;

        /// <summary>
        /// beta of Armijo's rule: the factor by which a step is shortened; between 0 and 1; default 0.5.
        /// </summary>
        public double ArmijoFactor { get; set; } = 0.5;

        internal void Write(ref hrbfnpr_project_desc desc)
        {
            desc.evaluation_limit = EvaluationLimit;
            desc.tolerance = Tolerance;
            desc.armijo_slope = ArmijoSlope;
            desc.armijo_factor = ArmijoFactor;
        }
    }

    /// <summary>How rays are cast; a new one holds all defaults.</summary>
    public sealed class CastOptions
    {
        /// <summary>Largest number of hits to find on a ray; 1 to 256; default 1 = only the first one.</summary>
        public int MaximumHits { get; set; } = 1;

        /// <summary>Largest number of evaluations of f for each ray; 1 to 1000000; default 20000.</summary>
        public int EvaluationLimit { get; set; } = 20000;

        /// <summary>Where rays begin, in lengths of their direction; finite; default 0.</summary>
        public double TMin { get; set; }

        /// <summary>
        /// Where rays end, in lengths of their direction; <see cref="TMin"/> or more; default infinity.
        /// </summary>
        public double TMax { get; set; } = double.PositiveInfinity;

        /// <summary>
        /// A bound on |grad f| in the search box; 0 or more; default 0 = that of <see cref="Model.Lipschitz"/>,
        /// computed in each call.  A bound that is too small may miss hits; one that is too large only takes time.
        /// </summary>
        public double Lipschitz { get; set; }

        /// <summary>
        /// Smallest step along a ray, in diagonals; above 0, at most 0.1; default 1e-4.  Smaller steps find thinner
        /// sheets and take more time.
        /// </summary>
        public double SmallestStep { get; set; } = 1e-4;

        /// <summary>Accuracy of the place of a hit along its ray, in diagonals; above 0; default 1e-9.</summary>
        public double Tolerance { get; set; } = 1e-9;

        /// <summary>
        /// A line set of this model, whose mesh the rays meet first, which is faster; default null = rays are searched
        /// without a mesh.  Parts of the surface that the mesh does not have are missed.
        /// </summary>
        public LineSet LineSet { get; set; }

        /// <summary>
        /// With <see cref="LineSet"/>: true = hits on the mesh are moved along their rays to f = 0; false = they stay on
        /// the mesh.  Default true.
        /// </summary>
        public bool Refine { get; set; } = true;

        internal void Write(ref hrbfnpr_cast_desc desc, HeldHandles held)
        {
            desc.maximum_hits = MaximumHits;
            desc.evaluation_limit = EvaluationLimit;
            desc.t_min = TMin;
            desc.t_max = TMax;
            desc.lipschitz = Lipschitz;
            desc.smallest_step = SmallestStep;
            desc.tolerance = Tolerance;
            desc.refine = Refine ? 1u : 0u;
            if (LineSet != null)
            {
                desc.line_set = held.Hold(LineSet.Handle);
            }
        }
    }
}
