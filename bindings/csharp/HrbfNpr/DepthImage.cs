// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>What smoothing the image of a depth camera found and did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_depth_image_info")]
    public struct DepthImageInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Pixels that have a point.</summary>
        public readonly long Seen;

        /// <summary>Of these, points with hardly any others on their plane.</summary>
        public readonly long LeftOut;

        /// <summary>Standard deviation of 1 / z, as given or measured.</summary>
        public readonly double Noise;

        /// <summary>In pixels.</summary>
        public readonly double FocalLength;

        /// <summary>Median distance |z| of the points.</summary>
        public readonly double Depth;

        /// <summary>Smoothed over at that distance, in pixels.</summary>
        public readonly double Radius;

        /// <summary>Time it took.</summary>
        public readonly double Seconds;
    }

    /// <summary>How the image of a depth camera is smoothed.</summary>
    public sealed class DepthImageOptions
    {
        /// <summary>Points stay where they are, and get normals; false by default.</summary>
        public bool KeepPoints { get; set; }

        /// <summary>Standard deviation of 1 / z; 0, by default, measures it.</summary>
        public double Noise { get; set; }

        /// <summary>Factor of the radius, above 0 and up to 100; 1 by default.</summary>
        public double Smoothing { get; set; } = 1;

        internal unsafe void Write(hrbfnpr_depth_image_desc* desc)
        {
            desc->keep_points = KeepPoints ? 1u : 0u;
            desc->noise = Noise;
            desc->smoothing = Smoothing;
        }
    }

    /// <summary>Images of depth cameras (Kinect, RealSense, time of flight, stereo).</summary>
    public static unsafe class DepthImage
    {
        /// <summary>Takes the sensor's noise off the image of a depth camera, and finds normals.</summary>
        /// <remarks>The camera is in the origin and looks along z, or against it.  Of an image of depths with focal
        /// lengths f and a centre c, in pixels, the points are x = (column - c_x) z / f_x, y = (row - c_y) z / f_y.
        /// Errors are as large everywhere in 1 / z, and planes are linear in it: one is fitted to the pixels around
        /// each, but for those beyond an edge; the point moves along its ray onto the plane.</remarks>
        /// <param name="points">rows * columns points, row by row; NaN, infinity or z = 0 where nothing was seen.</param>
        /// <param name="columns">8 to 65535.</param>
        /// <param name="rows">8 to 65535.</param>
        /// <param name="normals">Packed x, y, z, to the camera; 0 where there is no point.</param>
        /// <param name="info">What was found.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Packed x, y, z of as many points; NaN where nothing was seen, or the point is left out.</returns>
        /// <exception cref="InvalidArgumentException">The points are no image of such a camera.</exception>
        public static double[] Smooth(
            ArrayView points, int columns, int rows, out double[] normals, out DepthImageInfo info,
            DepthImageOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            hrbfnpr_depth_image_desc desc;
            Errors.Check(
                NativeMethods.hrbfnpr_depth_image_desc_init(&desc, (uint)sizeof(hrbfnpr_depth_image_desc)));
            (options ?? new DepthImageOptions()).Write(&desc);
            desc.columns = columns;
            desc.rows = rows;
            DepthImageInfo found;
            Errors.Check(NativeMethods.hrbfnpr_depth_image_info_init(&found, (uint)sizeof(DepthImageInfo)));
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                desc.points = points.ToNative(pins, 3, nameof(points));
                var result = new double[3 * desc.points.count];
                normals = new double[3 * desc.points.count];
                hrbfnpr_array toPoints = ((ArrayView)result).ToNative(pins, 3, nameof(result));
                hrbfnpr_array toNormals = ((ArrayView)normals).ToNative(pins, 3, nameof(normals));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_smooth_depth_image(
                    context.Handle, &desc, call.Operation, &toPoints, &toNormals, &found, &error);
                call.Check(status, &error);
                info = found;
                return result;
            }
        }
    }
}
