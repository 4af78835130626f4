// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>The sharp edges of a mesh as a whole.  Lengths are in units of the mesh.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_edges_info")]
    public struct MeshEdgesInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of sharp edges.</summary>
        public readonly long Edges;

        /// <summary>Number of smooth patches between them; 1 if no edge is sharp.</summary>
        public readonly long Patches;

        /// <summary>Length of the sharp edges.</summary>
        public readonly double Length;

        /// <summary>
        /// Length of those sharp edges that have the same patch on both sides, as where a crease fades out.
        /// </summary>
        public readonly double Fading;

        /// <summary>
        /// With Auto, length of edges that bend more than the crease angle but do not stand out; 0 if the mesh has
        /// sharp edges.
        /// </summary>
        public readonly double Doubtful;

        /// <summary>Time that the search took, in seconds.</summary>
        public readonly double Seconds;
    }
}
