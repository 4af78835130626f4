// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>The results of <c>Model.Evaluate</c> at n points.</summary>
    public sealed class Evaluation
    {
        internal Evaluation(double[] value, double[] gradient, double[] hessian)
        {
            Value = value;
            Gradient = gradient;
            Hessian = hessian;
        }

        /// <summary>f: n numbers.</summary>
        public double[] Value { get; }

        /// <summary>grad f: 3 n numbers; null if not wanted.</summary>
        public double[] Gradient { get; }

        /// <summary>The Hessian, xx xy xz yy yz zz: 6 n numbers; null if not wanted.</summary>
        public double[] Hessian { get; }
    }

    /// <summary>The results of <c>Model.Project</c> for n points.</summary>
    public sealed class Projection
    {
        internal Projection(long count)
        {
            Position = new double[count * 3];
            Normal = new double[count * 3];
            Status = new ProjectionStatus[count];
        }

        /// <summary>The projected points: 3 n numbers.  A point that failed keeps its last place.</summary>
        public double[] Position { get; }

        /// <summary>The unit gradients there: 3 n numbers; 0 where the gradient is unknown.</summary>
        public double[] Normal { get; }

        /// <summary>What became of each point.</summary>
        public ProjectionStatus[] Status { get; }

        /// <summary>Number of points that converged.</summary>
        public long Converged { get; internal set; }
    }

    /// <summary>The results of <c>Model.Curvature</c> at n points.</summary>
    public sealed class Curvature
    {
        internal Curvature(long count)
        {
            K1 = new double[count];
            K2 = new double[count];
            D1 = new double[count * 3];
            D2 = new double[count * 3];
            Confidence = new double[count];
        }

        /// <summary>
        /// The larger principal curvature, in 1 / unit of length: n numbers; -1/radius on a sphere with outward
        /// normals.
        /// </summary>
        public double[] K1 { get; }

        /// <summary>The smaller principal curvature: n numbers.</summary>
        public double[] K2 { get; }

        /// <summary>The direction of K1: unit, tangent, of arbitrary sign; 3 n numbers.</summary>
        public double[] D1 { get; }

        /// <summary>The direction of K2: unit, tangent, perpendicular to D1, of arbitrary sign; 3 n numbers.</summary>
        public double[] D2 { get; }

        /// <summary>How sure the directions are: n numbers from 0 to 1; 0 at umbilics and on planes.</summary>
        public double[] Confidence { get; }
    }

    /// <summary>The results of <c>Model.CastRays</c> for n rays with up to h hits each.</summary>
    public sealed class RayHits
    {
        internal RayHits(long count, int room)
        {
            Room = room;
            Hits = new uint[count];
            T = new double[count * room];
            Position = new double[count * room * 3];
            Normal = new double[count * room * 3];
            Entering = new byte[count * room];
            Status = new RayStatus[count];
        }

        /// <summary>h: the largest number of hits of a ray, <see cref="CastOptions.MaximumHits"/>.</summary>
        public int Room { get; }

        /// <summary>Number of hits of each ray: n numbers, 0 to h.</summary>
        public uint[] Hits { get; }

        /// <summary>
        /// Places of the hits, in lengths of the direction: n h numbers; infinity after the last hit of a ray.
        /// </summary>
        public double[] T { get; }

        /// <summary>Places of the hits: 3 n h numbers; 0 after the last hit of a ray.</summary>
        public double[] Position { get; }

        /// <summary>Unit gradients at the hits: 3 n h numbers; 0 after the last hit of a ray.</summary>
        public double[] Normal { get; }

        /// <summary>1 where the ray enters the inside (f changes from + to -), else 0: n h numbers.</summary>
        public byte[] Entering { get; }

        /// <summary>What became of each ray.</summary>
        public RayStatus[] Status { get; }

        /// <summary>Number of rays that have a hit.</summary>
        public long HitRays { get; internal set; }
    }
}
