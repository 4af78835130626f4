// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>Result of <c>Model.Evaluate</c> at n points.</summary>
    public sealed class Evaluation
    {
        internal Evaluation(double[] value, double[] gradient, double[] hessian)
        {
            Value = value;
            Gradient = gradient;
            Hessian = hessian;
        }

        /// <summary>f; n numbers.</summary>
        public double[] Value { get; }

        /// <summary>grad f; 3 n numbers, or null if not asked for.</summary>
        public double[] Gradient { get; }

        /// <summary>The Hessian, xx xy xz yy yz zz; 6 n numbers, or null if not asked for.</summary>
        public double[] Hessian { get; }
    }

    /// <summary>Result of <c>Model.Project</c> for n points.</summary>
    public sealed class Projection
    {
        internal Projection(long count)
        {
            Position = new double[count * 3];
            Normal = new double[count * 3];
            Status = new ProjectionStatus[count];
        }

        /// <summary>Places on the surface; 3 n numbers.  A point that failed keeps its last iterate.</summary>
        public double[] Position { get; }

        /// <summary>Unit gradients there; 3 n numbers.</summary>
        public double[] Normal { get; }

        /// <summary>What became of each point.</summary>
        public ProjectionStatus[] Status { get; }

        /// <summary>How many converged.</summary>
        public long Converged { get; internal set; }
    }

    /// <summary>Result of <c>Model.Curvature</c> at n points.</summary>
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

        /// <summary>The larger principal curvature; -1/radius on a sphere with outward normals.</summary>
        public double[] K1 { get; }

        /// <summary>The smaller principal curvature.</summary>
        public double[] K2 { get; }

        /// <summary>Direction of the first: unit, tangent, of arbitrary sign; 3 n numbers.</summary>
        public double[] D1 { get; }

        /// <summary>Direction of the second.</summary>
        public double[] D2 { get; }

        /// <summary>In [0, 1]: 0 where the directions mean nothing, at umbilics and on planes.</summary>
        public double[] Confidence { get; }
    }

    /// <summary>Result of <c>Model.CastRays</c> for n rays with room for h hits each.</summary>
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

        /// <summary>h: how many hits of each ray the arrays have room for.</summary>
        public int Room { get; }

        /// <summary>How many hits each ray has, 0 to h.</summary>
        public uint[] Hits { get; }

        /// <summary>Where along the ray; n h numbers, infinite after the last hit.</summary>
        public double[] T { get; }

        /// <summary>Where in space; 3 n h numbers, 0 after the last hit.</summary>
        public double[] Position { get; }

        /// <summary>Unit gradients there; 3 n h numbers.</summary>
        public double[] Normal { get; }

        /// <summary>1 where f goes from + to - along the ray; n h numbers.</summary>
        public byte[] Entering { get; }

        /// <summary>What became of each ray.</summary>
        public RayStatus[] Status { get; }

        /// <summary>How many rays hit.</summary>
        public long HitRays { get; internal set; }
    }
}
