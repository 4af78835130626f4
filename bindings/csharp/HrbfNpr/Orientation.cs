// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>What <see cref="Orientation.Find"/> found and did.  Lengths are in the unit of the points.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_orient_info")]
    public struct OrientationInfo
    {
        internal uint StructSize;
        private readonly uint found;

        /// <summary>Number of given normals that were turned round.</summary>
        public readonly long Turned;

        /// <summary>Number of normals that were made, because they were missing, zero or useless.</summary>
        public readonly long Made;

        /// <summary>Number of points that coincide with another one.</summary>
        public readonly long Merged;

        /// <summary>
        /// Mean angle between the lines of the given and the resulting normals, in degrees; NaN if no normals are
        /// given.
        /// </summary>
        public readonly double DirectionChange;

        /// <summary>Standard deviation of the points from their surface; 0 if no noise is seen.</summary>
        public readonly double Noise;

        /// <summary>Median distance of a point to its nearest neighbour.</summary>
        public readonly double Spacing;

        /// <summary>
        /// Bending energy of the result per degree of freedom, in spacings.  Below 0.006: the points resolve the
        /// surface; 0.026: points without any order.
        /// </summary>
        public readonly double Energy;

        /// <summary>
        /// How sure the result is; 0 to 1.  A heuristic, not a probability: results above 0.9 are usually right; check
        /// the others.
        /// </summary>
        public readonly double Confidence;

        private readonly uint closed;
        private readonly uint outwardBy;

        /// <summary>Number of pieces that lie apart by more than their spacing.</summary>
        public readonly long Components;

        /// <summary>Time of the call, in seconds.</summary>
        public readonly double Seconds;

        /// <summary>How far the given normals could be trusted.</summary>
        public Normals Found
        {
            get { return (Normals)found; }
        }

        /// <summary>Whether the points surround one or several solids.</summary>
        public bool Closed
        {
            get { return closed != 0; }
        }

        /// <summary>How it was decided which side is outward.</summary>
        public OutwardBy OutwardBy
        {
            get { return (OutwardBy)outwardBy; }
        }
    }

    /// <summary>How normals are found; a new one holds all defaults.</summary>
    public sealed class OrientationOptions
    {
        /// <summary>
        /// How far the given normals can be trusted; default Auto.  Given only looks: it changes no normal.
        /// </summary>
        public Normals Mode { get; set; } = Normals.Auto;

        /// <summary>
        /// The direction that decides for surfaces like a terrain; of any length, not 0; default (0, 0, 1).
        /// </summary>
        public Vector3d Up { get; set; } = new Vector3d(0, 0, 1);

        /// <summary>
        /// The place from which the points were seen; default null.  Normals of open surfaces point to its side.
        /// </summary>
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

    /// <summary>Finds normals of points that have none, or wrong ones.</summary>
    public static unsafe class Orientation
    {
        /// <summary>
        /// Finds outward unit normals for points, or repairs given normals.  A low
        /// <see cref="OrientationInfo.Confidence"/> is no error.
        /// </summary>
        /// <param name="points">The N points: at least 4 different ones, not all on one line.</param>
        /// <param name="normals">The N normals, of any length; not needed with None and Auto: pass
        /// <c>default(ArrayView)</c>.  Normals that stay are returned unchanged; a zero normal is made.</param>
        /// <param name="info">Receives the findings.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>x, y, z of N normals.</returns>
        /// <exception cref="InvalidArgumentException">NaN or infinity (the message names the index), fewer than 4
        /// different points, points on one line, or no normals with a mode that needs them.</exception>
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
