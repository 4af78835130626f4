// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What trimming a model left out.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_trim_info")]
    public struct TrimInfo
    {
        internal uint StructSize;
        private readonly uint isTrimmed;

        /// <summary>
        /// Number of samples that were looked at; 0 if trimming was not asked for, or if the end could not be found.
        /// </summary>
        public readonly long Samples;

        /// <summary>Number of connected parts of the surface that are left out.</summary>
        public readonly long Parts;

        /// <summary>Number of these that reach the end of the search box: the samples are open there.</summary>
        public readonly long PartsToEnd;

        /// <summary>
        /// Share of the surface's area in the box that is left out; 0 to 1; accurate to some percent.
        /// </summary>
        public readonly double Share;

        /// <summary>Largest distance of a place that is left out from the samples, in the model's unit.</summary>
        public readonly double Farthest;

        /// <summary>Spacing of the samples: the median distance to the sixth neighbour.</summary>
        public readonly double Spacing;

        /// <summary>
        /// Whether the surface ends somewhere.  If not, all fields except <see cref="Samples"/> and
        /// <see cref="Spacing"/> are 0.
        /// </summary>
        public bool IsTrimmed
        {
            get { return isTrimmed != 0; }
        }
    }
}
