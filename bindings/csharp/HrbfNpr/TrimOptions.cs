// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a model is trimmed; a new one holds all defaults.</summary>
    public sealed class TrimOptions
    {
        /// <summary>
        /// The surface ends where s(x) = 3 (|c|^2 - ln sum_j w_j) exceeds this, with q_j = (x - p_j) / (0.9 h_j),
        /// w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2 and c = sum_j w_j q_j / sum_j w_j; p_j: the 24 samples nearest to
        /// x, with normals n_j and the spacing h_j around them, m: the normal at x.  0.001 to 1000; 1.5 ends it some
        /// 0.7 spacings beyond the last samples, 3 some 0.9.
        /// </summary>
        public double Limit { get; set; } = 1.5;

        /// <summary>
        /// Holes that nowhere are farther from the samples than so many diagonals stay closed; 0 or more, 0.05.
        /// </summary>
        public double Hole { get; set; } = 0.05;

        /// <summary>
        /// Diagonals, 0 to 1: spacings are taken to be at least this, and no part that is farther than
        /// <see cref="Hole"/> from all samples stays.  For many points of a mesh, of which 0.01 leaves out what is
        /// more than about 0.01 diagonals off them.  0, the default: the spacing is the samples' own, and only what
        /// they surely do not bear out (s at least 6 somewhere) goes by <see cref="Hole"/>.
        /// </summary>
        public double Closest { get; set; }

        /// <summary>n points, float or double: the samples; if not given, the model's centres.</summary>
        public ArrayView Points { get; set; }

        /// <summary>Of <see cref="Points"/>, of any length; if not given, those of the surface there.</summary>
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
