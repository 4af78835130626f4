// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What became of the candidates for marks: attempted = placed + all dropped.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_placement_info")]
    public struct PlacementInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of candidates.</summary>
        public readonly long Attempted;

        /// <summary>Number of candidates that became marks.</summary>
        public readonly long Placed;

        /// <summary>Number of candidates whose projection did not reach the tolerance.</summary>
        public readonly long DroppedNotConverged;

        /// <summary>
        /// Number of candidates that landed too far away, lie beyond the end of a trimmed model, or lost the connection
        /// to their stroke.
        /// </summary>
        public readonly long DroppedStrayed;

        /// <summary>Number of candidates where the gradient is 0 or not finite.</summary>
        public readonly long DroppedDegenerate;

        /// <summary>Number of candidates over the layer's budget.</summary>
        public readonly long DroppedBudget;
    }

    /// <summary>What a layer holds.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_info")]
    public unsafe struct LayerInfo
    {
        internal uint StructSize;
        private readonly uint kind;
        private fixed byte name[64];

        /// <summary>Number of marks.</summary>
        public readonly long Marks;

        /// <summary>Number of strokes that the marks form; 0 = none.</summary>
        public readonly long Strokes;

        /// <summary>Number of marks that there would be if none had been dropped.</summary>
        public readonly long FullCount;

        /// <summary>Number of refinement steps taken; for blue-noise Hatch the highest level.</summary>
        public readonly int Levels;

        private readonly uint reserved;

        /// <summary>Initial step used, in the unit of the samples; for blue-noise Hatch the separation.</summary>
        public readonly double Step;

        /// <summary>Time of making the layer, in seconds.</summary>
        public readonly double Seconds;

        /// <summary>Kind of the layer.</summary>
        public LayerKind Kind
        {
            get { return (LayerKind)kind; }
        }

        /// <summary>Name of the layer.</summary>
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

    /// <summary>
    /// What a point set holds, and how long it took to make.  Lengths are in the unit of the samples.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_point_set_info")]
    public struct PointSetInfo
    {
        internal uint StructSize;
        private readonly uint distribution;
        private readonly uint seedSource;
        private readonly uint reserved;

        /// <summary>Number of layers.</summary>
        public readonly long Layers;

        /// <summary>Number of marks in all layers.</summary>
        public readonly long Marks;

        /// <summary>Add it to positions to get absolute places.</summary>
        public readonly Vector3d Origin;

        /// <summary>Lower corner of the box around all marks, absolute.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>Upper corner of the box.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Square root of the area per mark of the largest layer, estimated.</summary>
        public readonly double Spacing;

        /// <summary>Time of finding the seeds, in seconds.</summary>
        public readonly double SecondsSeeds;

        /// <summary>Time of the whole call, in seconds.</summary>
        public readonly double SecondsTotal;

        /// <summary>Bytes that the point set keeps, with what it shares with other sets.</summary>
        public readonly long Bytes;

        /// <summary>Number of fields whose values the set holds.</summary>
        public readonly long FieldCount;

        /// <summary>The distribution that was used.</summary>
        public Distribution Distribution
        {
            get { return (Distribution)distribution; }
        }

        /// <summary>The seed source that was used.</summary>
        public SeedSource SeedSource
        {
            get { return (SeedSource)seedSource; }
        }
    }
}
