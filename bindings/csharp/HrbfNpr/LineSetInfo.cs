// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What making a line set found.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_line_set_info")]
    public struct LineSetInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of triangles of the mesh on which curves are searched.</summary>
        public readonly long Triangles;

        /// <summary>
        /// Number of these that face away from the surface.  The surface is finer than the cells there, and curves may
        /// be missed.
        /// </summary>
        public readonly long Turned;

        /// <summary>
        /// Number of seeds that no triangle is near.  A part of the surface is too thin for the cells there.
        /// </summary>
        public readonly long MissedSeeds;

        /// <summary>Number of lines that were found once, for all <see cref="LineSetOptions.Lines"/>.</summary>
        public readonly long Lines;

        /// <summary>Number of curves where the surface ends.</summary>
        public readonly long Borders;

        /// <summary>Side of the cells as used, in units of the model.</summary>
        public readonly double CellSize;

        /// <summary>Time that it took to make the line set, in seconds.</summary>
        public readonly double Seconds;

        /// <summary>Bytes that the line set keeps.</summary>
        public readonly long Bytes;

        /// <summary>
        /// Share of the examined area that lies beyond the samples; 0 to 1; 0 without
        /// <see cref="LineSetOptions.Support"/>.
        /// </summary>
        public readonly double LeftOut;

        /// <summary>Number of creases at any angle, each from corner to corner or closed.</summary>
        public readonly long Creases;
    }
}
