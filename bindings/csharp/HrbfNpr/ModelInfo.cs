// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// What a fit found and did.  Lengths are in the unit of the points.  A model from a function and a solid have
    /// bounds, kernel and bytes only.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_model_info")]
    public struct ModelInfo
    {
        internal uint StructSize;
        private readonly uint kernel;

        /// <summary>Degree of the polynomial that was used; -1 = none.</summary>
        public readonly int PolynomialDegree;

        /// <summary>Number of fits that were made to choose the centres; 0 if all samples are centres.</summary>
        public readonly int ChoiceRounds;

        /// <summary>Number of samples as given.</summary>
        public readonly long Samples;

        /// <summary>Number of centres, after merging, repairing and choosing.</summary>
        public readonly long Centres;

        /// <summary>Number of samples that were merged into another one at the same place.</summary>
        public readonly long MergedSamples;

        /// <summary>Number of samples that were merged into another one much nearer than the spacing.</summary>
        public readonly long NearDuplicates;

        /// <summary>Number of normals whose length differed from 1 by more than 1e-4.</summary>
        public readonly long RescaledNormals;

        /// <summary>Number of samples far from all others, or from the tangent planes around them.</summary>
        public readonly long OutliersFound;

        /// <summary>Number of these that were left out.</summary>
        public readonly long OutliersDropped;

        /// <summary>Number of normals that are opposite to those of their neighbours.</summary>
        public readonly long FlippedFound;

        /// <summary>Number of these that were left out or turned round.</summary>
        public readonly long FlippedRepaired;

        /// <summary>Lower corner of the samples' box, or of the bounds of a function or a solid.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>Upper corner of the box.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Mean distance of a sample to its nearest neighbour.</summary>
        public readonly double Spacing;

        /// <summary>Kernel radius that was used; 0 for Triharmonic.</summary>
        public readonly double KernelRadius;

        /// <summary>Regularization that was used; with Auto, that of the values.</summary>
        public readonly double Regularization;

        /// <summary>
        /// Standard deviation of the samples from their surface; 0 if no noise is seen, NaN with
        /// <see cref="RegularizationMode.Given"/>.
        /// </summary>
        public readonly double NoiseEstimate;

        /// <summary>Largest |f| at a centre.</summary>
        public readonly double ValueResidualMax;

        /// <summary>Root mean square of |f| at the centres.</summary>
        public readonly double ValueResidualRms;

        /// <summary>Largest |grad f - n| at a centre.</summary>
        public readonly double GradientResidualMax;

        /// <summary>Root mean square of |grad f - n| at the centres.</summary>
        public readonly double GradientResidualRms;

        /// <summary>Largest distance |f| / |grad f| of a sample from the surface; dropped ones do not count.</summary>
        public readonly double InputDistanceMax;

        /// <summary>Root mean square of these distances.</summary>
        public readonly double InputDistanceRms;

        /// <summary>
        /// Share of all samples that lie within the tolerance; a dropped sample counts as outside; NaN with tolerance
        /// 0.
        /// </summary>
        public readonly double InputShareWithin;

        private readonly uint solver;

        private readonly uint solverReason;

        /// <summary>Number of refinement steps of Direct, or of steps of Iterative.</summary>
        public readonly int Iterations;

        private readonly uint fallback;

        /// <summary>Relative residual of the linear system, in the 2-norm.</summary>
        public readonly double SolverResidual;

        /// <summary>
        /// Condition of the matrix in the 1-norm (Direct), or of the preconditioned matrix in the 2-norm (Iterative).
        /// </summary>
        public readonly double ConditionEstimate;

        /// <summary>Time of finding duplicates, outliers, flipped normals and noise, in seconds.</summary>
        public readonly double SecondsClean;

        /// <summary>Time of all rounds that chose centres, without the last fit, in seconds.</summary>
        public readonly double SecondsChoose;

        /// <summary>Time of assembling the matrix, in seconds.</summary>
        public readonly double SecondsAssemble;

        /// <summary>Time of making the preconditioner, in seconds.</summary>
        public readonly double SecondsPrecondition;

        /// <summary>Time of solving, in seconds.</summary>
        public readonly double SecondsSolve;

        /// <summary>Time of the whole fit, in seconds.</summary>
        public readonly double SecondsTotal;

        /// <summary>Bytes that the model keeps.</summary>
        public readonly long Bytes;

        /// <summary>
        /// Largest number of bytes allocated at the same time through the context, up to the fit's end.
        /// </summary>
        public readonly long PeakBytes;

        private readonly uint normalsFound;

        private readonly uint normalsInward;

        /// <summary>
        /// Number of normals that were turned round, with a <see cref="FitOptions.NormalMode"/> other than Given.
        /// </summary>
        public readonly long NormalsTurned;

        /// <summary>The <see cref="OrientationInfo.Confidence"/> of such a fit; NaN with Given.</summary>
        public readonly double NormalsConfidence;

        /// <summary>Time of making the normals, in seconds.</summary>
        public readonly double SecondsOrient;

        /// <summary>
        /// How far the given normals could be trusted, with a <see cref="FitOptions.NormalMode"/> other than Given;
        /// else Given.
        /// </summary>
        public Normals NormalsFound
        {
            get { return (Normals)normalsFound; }
        }

        /// <summary>
        /// Whether the given normals all point into a closed surface, with <see cref="FitOptions.NormalMode"/> Given.
        /// </summary>
        public bool NormalsInward
        {
            get { return normalsInward != 0; }
        }

        /// <summary>The radial function that was used.</summary>
        public Kernel Kernel
        {
            get { return (Kernel)kernel; }
        }

        /// <summary>The solver that was used.</summary>
        public Solver Solver
        {
            get { return (Solver)solver; }
        }

        /// <summary>Why this solver was used.</summary>
        public SolverReason SolverReason
        {
            get { return (SolverReason)solverReason; }
        }

        /// <summary>Whether the matrix was not definite, and LU with pivoting was used.</summary>
        public bool Fallback
        {
            get { return fallback != 0; }
        }
    }
}
