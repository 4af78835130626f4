using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What became of one level's candidates: attempted = placed + all dropped.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_level_info")]
    public struct LevelInfo
    {
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

        /// <summary>Over the group's budget.</summary>
        public readonly long DroppedBudget;
    }

    /// <summary>One group of marks.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_group_info")]
    public unsafe struct GroupInfo
    {
        /// <summary>Marks in the group.</summary>
        public readonly long Count;

        /// <summary>Strokes in the group; 0 for stipples.</summary>
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

        private LevelInfo level0, level1, level2, level3, level4, level5, level6, level7, level8, level9, level10;
        private LevelInfo level11, level12;

        /// <summary>What became of one level's candidates: 0 for the seeds, then each refinement step.</summary>
        /// <param name="index">0 to 12.</param>
        public LevelInfo Level(int index)
        {
            if (index < 0 || index > 12)
            {
                throw new ArgumentOutOfRangeException(nameof(index));
            }
            fixed (LevelInfo* first = &level0)
            {
                return first[index];
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

        /// <summary>Add it to positions to get absolute coordinates.</summary>
        public readonly Vector3d Origin;

        /// <summary>Corner of the box of all marks, absolute.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>sqrt(area per mark) of the largest group, estimated.</summary>
        public readonly double Spacing;

        /// <summary>Seconds to find the seeds.</summary>
        public readonly double SecondsSeeds;

        /// <summary>Seconds of it all.</summary>
        public readonly double SecondsTotal;

        /// <summary>Bytes kept by the set.</summary>
        public readonly long Bytes;

        /// <summary>What became of the seeds' candidates.</summary>
        public readonly LevelInfo Seeds;

        private readonly GroupInfo group0, group1, group2;

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

        /// <summary>Marks in all groups.</summary>
        public long Count
        {
            get { return group0.Count + group1.Count + group2.Count; }
        }

        /// <summary>One group of marks.</summary>
        public GroupInfo this[Group group]
        {
            get
            {
                switch (group)
                {
                    case Group.Stipple: return group0;
                    case Group.Curvature: return group1;
                    case Group.Combing: return group2;
                    default: throw new ArgumentOutOfRangeException(nameof(group));
                }
            }
        }
    }
}
