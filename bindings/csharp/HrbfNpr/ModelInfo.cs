// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What a fit did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_model_info")]
    public struct ModelInfo
    {
        internal uint StructSize;
        private readonly uint kernel;

        /// <summary>-1 (none) to 3.</summary>
        public readonly int PolynomialDegree;

        /// <summary>Fits made to choose the centres; 0 if all samples are centres.</summary>
        public readonly int ChoiceRounds;

        /// <summary>Samples, as given.</summary>
        public readonly long Samples;

        /// <summary>Samples after merging, cleaning and choosing.</summary>
        public readonly long Centres;

        /// <summary>Samples that were merged into another.</summary>
        public readonly long MergedSamples;

        /// <summary>Samples much nearer to another than the spacing, merged into it.</summary>
        public readonly long NearDuplicates;

        /// <summary>Normals whose length was off 1 by more than 1e-4.</summary>
        public readonly long RescaledNormals;

        /// <summary>Samples that look like outliers.</summary>
        public readonly long OutliersFound;

        /// <summary>Those that were dropped.</summary>
        public readonly long OutliersDropped;

        /// <summary>Normals against those of their neighbours.</summary>
        public readonly long FlippedFound;

        /// <summary>Of these, dropped or turned round.</summary>
        public readonly long FlippedRepaired;

        /// <summary>Corner of the samples' box, or of the function's bounds.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Mean distance of a sample to its nearest neighbour.</summary>
        public readonly double Spacing;

        /// <summary>As used.</summary>
        public readonly double KernelRadius;

        /// <summary>As used; of Auto, that of the values.</summary>
        public readonly double Regularization;

        /// <summary>Standard deviation of the samples off their surface; 0 if none is seen, NaN if nobody asked.</summary>
        public readonly double NoiseEstimate;

        /// <summary>The largest |f| at a centre, in the unit of the points.</summary>
        public readonly double ValueResidualMax;

        /// <summary>Its root mean square.</summary>
        public readonly double ValueResidualRms;

        /// <summary>The largest |grad f - n| at a centre.</summary>
        public readonly double GradientResidualMax;

        /// <summary>Its root mean square.</summary>
        public readonly double GradientResidualRms;

        /// <summary>Largest distance of a sample that was not dropped from the surface, |f| / |grad f|.</summary>
        public readonly double InputDistanceMax;

        /// <summary>Its root mean square.</summary>
        public readonly double InputDistanceRms;

        /// <summary>Share of all samples that lie within the tolerance; NaN with tolerance 0.</summary>
        public readonly double InputShareWithin;

        private readonly uint solver;

        private readonly uint solverReason;

        /// <summary>Refinement steps of the direct solver, steps of the iterative one.</summary>
        public readonly int Iterations;

        private readonly uint fallback;

        /// <summary>Relative residual of the linear system, 2-norm.</summary>
        public readonly double SolverResidual;

        /// <summary>Of the matrix, 1-norm (direct), or of the preconditioned one, 2-norm (iterative).</summary>
        public readonly double ConditionEstimate;

        /// <summary>Seconds to look for samples that look wrong.</summary>
        public readonly double SecondsClean;

        /// <summary>Seconds of all rounds but the last fit.</summary>
        public readonly double SecondsChoose;

        /// <summary>Seconds to assemble the system.</summary>
        public readonly double SecondsAssemble;

        /// <summary>Seconds to make the preconditioner.</summary>
        public readonly double SecondsPrecondition;

        /// <summary>Seconds to solve it.</summary>
        public readonly double SecondsSolve;

        /// <summary>Seconds of the whole fit.</summary>
        public readonly double SecondsTotal;

        /// <summary>Bytes kept by the model.</summary>
        public readonly long Bytes;

        /// <summary>Most bytes that the context had given out at a time, up to the fit's end.</summary>
        public readonly long PeakBytes;

        private readonly uint normalsFound;

        private readonly uint normalsInward;

        /// <summary>Normals that a fit with a normal mode turned round.</summary>
        public readonly long NormalsTurned;

        /// <summary><see cref="OrientationInfo.Confidence"/> of such a fit; NaN of others.</summary>
        public readonly double NormalsConfidence;

        /// <summary>Seconds to find or repair the normals.</summary>
        public readonly double SecondsOrient;

        /// <summary>What the normals turned out to be, of a fit with a normal mode.</summary>
        public Normals NormalsFound
        {
            get { return (Normals)normalsFound; }
        }

        /// <summary>Whether normals as given all point into a closed surface.</summary>
        public bool NormalsInward
        {
            get { return normalsInward != 0; }
        }

        /// <summary>The radial function.</summary>
        public Kernel Kernel
        {
            get { return (Kernel)kernel; }
        }

        /// <summary>The solver that was used.</summary>
        public Solver Solver
        {
            get { return (Solver)solver; }
        }

        /// <summary>Why it was.</summary>
        public SolverReason SolverReason
        {
            get { return (SolverReason)solverReason; }
        }

        /// <summary>Whether the matrix was not definite and a pivoted LU was used.</summary>
        public bool Fallback
        {
            get { return fallback != 0; }
        }
    }
}
