// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What became of candidates for marks: attempted = placed + all dropped.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_placement_info")]
    public struct PlacementInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Candidates.</summary>
        public readonly long Attempted;

        /// <summary>Marks that came of them.</summary>
        public readonly long Placed;

        /// <summary>Projection ended short of the tolerance.</summary>
        public readonly long DroppedNotConverged;

        /// <summary>Landed too far away, or cut off the rest of the stroke.</summary>
        public readonly long DroppedStrayed;

        /// <summary>Zero gradient, or not finite.</summary>
        public readonly long DroppedDegenerate;

        /// <summary>Over the layer's budget.</summary>
        public readonly long DroppedBudget;
    }

    /// <summary>One layer of marks.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_info")]
    public unsafe struct LayerInfo
    {
        internal uint StructSize;
        private readonly uint kind;
        private fixed byte name[64];

        /// <summary>Marks in the layer.</summary>
        public readonly long Marks;

        /// <summary>Strokes in the layer; 0: its marks form none.</summary>
        public readonly long Strokes;

        /// <summary>What the count would be if nothing had been dropped, or left out for the budget.</summary>
        public readonly long FullCount;

        /// <summary>Refinement steps taken; of blue-noise strokes the last pass.</summary>
        public readonly int Levels;

        private readonly uint reserved;

        /// <summary>Initial step used; of blue-noise strokes the separation.</summary>
        public readonly double Step;

        /// <summary>Seconds that it took.</summary>
        public readonly double Seconds;

        /// <summary>What its marks are.</summary>
        public LayerKind Kind
        {
            get { return (LayerKind)kind; }
        }

        /// <summary>What it is called.</summary>
        public string Name
        {
            get
            {
                fixed (byte* text = name)
                {
                    return Errors.Utf8(text);
                }
            }
        }
    }

    /// <summary>What generating a point set did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_point_set_info")]
    public struct PointSetInfo
    {
        internal uint StructSize;
        private readonly uint distribution;
        private readonly uint seedSource;
        private readonly uint reserved;

        /// <summary>How many layers there are.</summary>
        public readonly long Layers;

        /// <summary>Marks in all layers.</summary>
        public readonly long Marks;

        /// <summary>Add it to positions to get absolute coordinates.</summary>
        public readonly Vector3d Origin;

        /// <summary>Corner of the box of all marks, absolute.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>sqrt(area per mark) of the largest layer, estimated.</summary>
        public readonly double Spacing;

        /// <summary>Seconds to find the seeds.</summary>
        public readonly double SecondsSeeds;

        /// <summary>Seconds of it all.</summary>
        public readonly double SecondsTotal;

        /// <summary>Bytes kept by the set.</summary>
        public readonly long Bytes;

        /// <summary>As asked for.</summary>
        public Distribution Distribution
        {
            get { return (Distribution)distribution; }
        }

        /// <summary>The one used.</summary>
        public SeedSource SeedSource
        {
            get { return (SeedSource)seedSource; }
        }
    }
}
