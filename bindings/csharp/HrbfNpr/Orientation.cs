// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>What finding normals found and did.  Lengths are in the unit of the points.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_orient_info")]
    public struct OrientationInfo
    {
        internal uint StructSize;
        private readonly uint found;

        /// <summary>Given normals that were turned round.</summary>
        public readonly long Turned;

        /// <summary>Normals that are new.</summary>
        public readonly long Made;

        /// <summary>Points that coincide with another.</summary>
        public readonly long Merged;

        /// <summary>Mean angle between the lines of given and resulting normals, in degrees; NaN if none were given.</summary>
        public readonly double DirectionChange;

        /// <summary>Standard deviation of the points off their surface; 0 if none is seen.</summary>
        public readonly double Noise;

        /// <summary>Median distance of a point to its nearest neighbour.</summary>
        public readonly double Spacing;

        /// <summary>Of the result over its degrees of freedom: below 0.006 for surfaces that the points resolve.</summary>
        public readonly double Energy;

        /// <summary>0 to 1: how far starts with energies as low agree, and how low that is.</summary>
        public readonly double Confidence;

        private readonly uint closed;
        private readonly uint outwardBy;

        /// <summary>Pieces that lie apart by more than their spacing.</summary>
        public readonly long Components;

        /// <summary>Time it took.</summary>
        public readonly double Seconds;

        /// <summary>What the given normals turned out to be.</summary>
        public Normals Found
        {
            get { return (Normals)found; }
        }

        /// <summary>Whether the points are all around a solid, or several.</summary>
        public bool Closed
        {
            get { return closed != 0; }
        }

        /// <summary>What decided which side is outward.</summary>
        public OutwardBy OutwardBy
        {
            get { return (OutwardBy)outwardBy; }
        }
    }

    /// <summary>How normals are found.</summary>
    public sealed class OrientationOptions
    {
        /// <summary>What is known of the given normals; Auto by default.</summary>
        public Normals Mode { get; set; } = Normals.Auto;

        /// <summary>The side of open surfaces that is outward, where nothing else tells; (0, 0, 1).</summary>
        public Vector3d Up { get; set; } = new Vector3d(0, 0, 1);

        /// <summary>Where the points were seen from: open surfaces are turned to it; null by default.</summary>
        public Vector3d? Viewpoint { get; set; }

        internal unsafe void Write(hrbfnpr_orient_desc* desc)
        {
            desc->mode = (uint)Mode;
            desc->up[0] = Up.X;
            desc->up[1] = Up.Y;
            desc->up[2] = Up.Z;
            if (!Viewpoint.HasValue) return;
            desc->has_viewpoint = 1;
            desc->viewpoint[0] = Viewpoint.Value.X;
            desc->viewpoint[1] = Viewpoint.Value.Y;
            desc->viewpoint[2] = Viewpoint.Value.Z;
        }
    }

    /// <summary>Normals for points that have none, or wrong ones.</summary>
    public static unsafe class Orientation
    {
        /// <summary>Finds the outward unit normals of points, or repairs given ones.</summary>
        /// <param name="points">N points, at least 4 different ones that are not all on a line.</param>
        /// <param name="normals">N normals of any length, or default(ArrayView) with the modes None and Auto.  Those
        /// that stay are returned as they are; a zero one is made.</param>
        /// <param name="info">What was found.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Packed x, y, z of N normals.</returns>
        /// <exception cref="InvalidArgumentException">NaN or infinity (the message names the index), too few points,
        /// or all on one line.</exception>
        public static double[] Find(
            ArrayView points, ArrayView normals, out OrientationInfo info, OrientationOptions options = null,
            Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            hrbfnpr_orient_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_orient_desc_init(&desc, (uint)sizeof(hrbfnpr_orient_desc)));
            (options ?? new OrientationOptions()).Write(&desc);
            OrientationInfo found;
            Errors.Check(NativeMethods.hrbfnpr_orient_info_init(&found, (uint)sizeof(OrientationInfo)));
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                desc.points = points.ToNative(pins, 3, nameof(points));
                desc.normals = normals.ToNative(pins, 3, nameof(normals));
                var result = new double[3 * desc.points.count];
                hrbfnpr_array target = ((ArrayView)result).ToNative(pins, 3, nameof(result));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_orient(
                    context.Handle, &desc, call.Operation, &target, &found, &error);
                call.Check(status, &error);
                info = found;
                return result;
            }
        }
    }
}
