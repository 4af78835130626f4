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

        /// <summary>Samples that tell where the surface ends; 0: the model was never trimmed.</summary>
        public readonly long Samples;

        /// <summary>Connected parts of the surface that are left out.</summary>
        public readonly long Parts;

        /// <summary>Of these, those that reach the end of the search box: the samples are open there.</summary>
        public readonly long PartsToEnd;

        /// <summary>Of the surface's area in the box that is left out, 0 to 1, within some percent.</summary>
        public readonly double Share;

        /// <summary>Of the places left out from the samples, units of the model.</summary>
        public readonly double Farthest;

        /// <summary>Of the samples: the median of how far their sixth neighbours are.</summary>
        public readonly double Spacing;

        /// <summary>
        /// Whether the surface ends somewhere; if not, all else is 0 but <see cref="Samples"/> and
        /// <see cref="Spacing"/>.
        /// </summary>
        public bool IsTrimmed
        {
            get { return isTrimmed != 0; }
        }
    }
}
