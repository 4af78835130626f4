// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What making a line set did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_line_set_info")]
    public struct LineSetInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Triangles of the mesh.</summary>
        public readonly long Triangles;

        /// <summary>
        /// Of these, triangles that look away from the surface: it is finer than the cells there, and curves may be
        /// missed.
        /// </summary>
        public readonly long Turned;

        /// <summary>Seeds that no triangle is near: a part of the surface is too thin for the cells.</summary>
        public readonly long MissedSeeds;

        /// <summary>Lines that were found once, of all <see cref="LineSetOptions.Lines"/>.</summary>
        public readonly long Lines;

        /// <summary>Curves where the surface ends.</summary>
        public readonly long Borders;

        /// <summary>As used, units of the model.</summary>
        public readonly double CellSize;

        /// <summary>Seconds that it took to make.</summary>
        public readonly double Seconds;

        /// <summary>Bytes kept by the set.</summary>
        public readonly long Bytes;

        /// <summary>
        /// The share of the surface's area that lies beyond its samples, 0 to 1; 0 without
        /// <see cref="LineSetOptions.Support"/>.
        /// </summary>
        public readonly double LeftOut;

        /// <summary>Curves where smooth sheets of the surface meet, from corner to corner, or closed.</summary>
        public readonly long Creases;
    }
}
