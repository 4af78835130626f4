// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Counts of the shapes on a page that was written.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_page_info")]
    public struct PageInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Bytes of the file.</summary>
        public readonly long Bytes;

        /// <summary>Number of groups of ink.</summary>
        public readonly long Groups;

        /// <summary>Number of lines and outlines.</summary>
        public readonly long Paths;

        /// <summary>Number of curves or straight lines of all paths.</summary>
        public readonly long Segments;

        /// <summary>Number of dots.</summary>
        public readonly long Dots;

        /// <summary>In plot order, number of pairs of ends that became one line.</summary>
        public readonly long Joined;

        /// <summary>In plot order, number of lines dropped because they are too short for the pen.</summary>
        public readonly long DroppedPaths;

        /// <summary>In plot order, number of dots dropped because they are too near to others for the pen.</summary>
        public readonly long DroppedDots;

        /// <summary>Width of the page, in mm.</summary>
        public readonly double Width;

        /// <summary>Height of the page, in mm.</summary>
        public readonly double Height;

        /// <summary>In plot order, length that a pen draws, in mm; else 0.</summary>
        public readonly double Drawn;

        /// <summary>In plot order, length that a pen travels above the paper, in mm; else 0.</summary>
        public readonly double Travelled;

        /// <summary>In plot order, time that a plotter takes at the given speeds, in seconds; else 0.</summary>
        public readonly double Seconds;

        /// <summary>In plot order, number of lines wider than their pen, drawn in several passes.</summary>
        public readonly long FilledPaths;

        /// <summary>Number of lines longer than <see cref="PageOptions.Longest"/>, cut into parts.</summary>
        public readonly long CutPaths;
    }
}
