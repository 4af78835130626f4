// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>The sharp edges of a mesh as a whole; lengths are in units of the mesh.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_edges_info")]
    public struct MeshEdgesInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>The number of sharp edges.</summary>
        public readonly long Edges;

        /// <summary>The number of smooth patches between them; 1 where no edge is sharp.</summary>
        public readonly long Patches;

        /// <summary>The length of the sharp edges.</summary>
        public readonly double Length;

        /// <summary>The length of those that have the same patch on both sides.</summary>
        public readonly double Fading;

        /// <summary>The length of edges that bend more than the crease angle but do not stand out.</summary>
        public readonly double Doubtful;

        /// <summary>The time that the call took.</summary>
        public readonly double Seconds;
    }
}
