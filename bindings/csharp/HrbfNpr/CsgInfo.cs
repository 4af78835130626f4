// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What a solid is made of; all 0 of a model that is not put together from others.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_csg_info")]
    public struct CsgInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Nodes of its tree, with those of trees that became part of it.</summary>
        public readonly long Nodes;

        /// <summary>Nodes from the root to the deepest leaf.</summary>
        public readonly long Depth;

        /// <summary>Leaves that are models, each once.</summary>
        public readonly long Models;

        /// <summary>Smooth functions that it is made of.</summary>
        public readonly long Sheets;

        /// <summary>A bound on the length of grad f that holds everywhere; 0: none is known.</summary>
        public readonly double Lipschitz;
    }
}
