// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What a solid is made of.  All fields are 0 for a model that is not a solid.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_csg_info")]
    public struct CsgInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of nodes, with those of solids that became part of it.</summary>
        public readonly long Nodes;

        /// <summary>Number of nodes from the root to the deepest leaf, both included.</summary>
        public readonly long Depth;

        /// <summary>Number of different models among the leaves.</summary>
        public readonly long Models;

        /// <summary>Number of smooth functions that the solid consists of.</summary>
        public readonly long Sheets;

        /// <summary>A bound on |grad f| that holds everywhere; 0 if none is known, because leaves are models.</summary>
        public readonly double Lipschitz;
    }
}
