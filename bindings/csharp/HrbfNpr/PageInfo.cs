// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What of a page was written.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_page_info")]
    public struct PageInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Bytes of the file.</summary>
        public readonly long Bytes;

        /// <summary>Groups, the layers of the file.</summary>
        public readonly long Groups;

        /// <summary>Lines and outlines.</summary>
        public readonly long Paths;

        /// <summary>Curves or straight lines of all paths.</summary>
        public readonly long Segments;

        /// <summary>Dots of ink.</summary>
        public readonly long Dots;

        /// <summary>In plot order: pairs of ends that became one line.</summary>
        public readonly long Joined;

        /// <summary>In plot order: lines that are too short for the pen.</summary>
        public readonly long DroppedPaths;

        /// <summary>In plot order: dots that are too near to others for the pen.</summary>
        public readonly long DroppedDots;

        /// <summary>Of the page, mm.</summary>
        public readonly double Width;

        /// <summary>Of the page, mm.</summary>
        public readonly double Height;

        /// <summary>What a pen draws, mm; in plot order, else 0.</summary>
        public readonly double Drawn;

        /// <summary>What a pen goes between, mm; in plot order, else 0.</summary>
        public readonly double Travelled;

        /// <summary>What a plotter takes at the given speeds; in plot order, else 0.</summary>
        public readonly double Seconds;

        /// <summary>In plot order: lines wider than their pen, drawn in several passes.</summary>
        public readonly long FilledPaths;
    }
}
