// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a surface is trimmed; a new one holds all defaults.</summary>
    public sealed class TrimOptions
    {
        /// <summary>
        /// The surface ends where s(x), which says how badly samples support it, is above this; 0.001 to 1000; default
        /// 1.5.  Larger values end it later: 1.5 about 0.7 spacings beyond its last samples, 3 about 0.9.
        /// </summary>
        /// <remarks>
        /// s(x) = 3 (|c|^2 - ln sum_j w_j), with q_j = (x - p_j) / (0.9 h_j), w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2
        /// and c = sum_j w_j q_j / sum_j w_j.  The p_j are the 24 samples nearest to x, with the normals n_j and the
        /// spacing h_j around them, and m is the normal at x.
        /// </remarks>
        public double Limit { get; set; } = 1.5;

        /// <summary>
        /// Holes whose points are all within this distance of a sample stay closed, in diagonals; 0 or more; default
        /// 0.05.  Larger values keep larger holes closed.
        /// </summary>
        public double Hole { get; set; } = 0.05;

        /// <summary>
        /// Samples closer to each other than this are treated as this far apart, in diagonals; 0 to 1; default 0.  Use
        /// it for samples that are much denser than the surface is accurate, such as many points of a mesh.
        /// </summary>
        /// <remarks>
        /// 0.01 leaves out whatever is more than about 0.01 diagonals off the samples.  Above 0, a part that is
        /// somewhere farther than <see cref="Hole"/> from all samples is always left out; with 0, only if s is 6 or
        /// more there.
        /// </remarks>
        public double Closest { get; set; }

        /// <summary>
        /// n samples, float or double; default not given = the model's centres.  All points of a scan show better than
        /// the chosen centres where it ends.
        /// </summary>
        public ArrayView Points { get; set; }

        /// <summary>
        /// Normals of <see cref="Points"/>, of any length but 0; default not given = those of the centres, or of the
        /// surface at the given points.
        /// </summary>
        public ArrayView Normals { get; set; }

        internal unsafe void Write(hrbfnpr_trim_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_trim_desc_init(desc, (uint)sizeof(hrbfnpr_trim_desc)));
            desc->limit = Limit;
            desc->hole = Hole;
            desc->closest = Closest;
            desc->points = Points.ToNative(pins, 3, nameof(Points));
            desc->normals = Normals.ToNative(pins, 3, nameof(Normals));
        }
    }
}
