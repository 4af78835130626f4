// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>What <see cref="DepthImage.Smooth"/> found and did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_depth_image_info")]
    public struct DepthImageInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of pixels with a point.</summary>
        public readonly long Seen;

        /// <summary>Number of these that are left out, because too few other pixels lie on their plane.</summary>
        public readonly long LeftOut;

        /// <summary>Standard deviation of 1 / z, as given or measured.</summary>
        public readonly double Noise;

        /// <summary>Mean of the focal lengths in both directions, in pixels.</summary>
        public readonly double FocalLength;

        /// <summary>Median of |z| over the points.</summary>
        public readonly double Depth;

        /// <summary>Radius of the smoothing at this depth, in pixels.</summary>
        public readonly double Radius;

        /// <summary>Time of the call, in seconds.</summary>
        public readonly double Seconds;
    }

    /// <summary>How the image of a depth camera is smoothed; a new one holds all defaults.</summary>
    public sealed class DepthImageOptions
    {
        /// <summary>Whether the points stay where they are and only get normals; default false.</summary>
        public bool KeepPoints { get; set; }

        /// <summary>
        /// Standard deviation of 1 / z, in 1 / (unit of the points); 0 or more; default 0 = measured.
        /// </summary>
        public double Noise { get; set; }

        /// <summary>
        /// Factor of the radius over which pixels are averaged; above 0, at most 100; default 1.  Larger values remove
        /// more noise and more small shapes.
        /// </summary>
        public double Smoothing { get; set; } = 1;

        internal unsafe void Write(hrbfnpr_depth_image_desc* desc)
        {
            desc->keep_points = KeepPoints ? 1u : 0u;
            desc->noise = Noise;
            desc->smoothing = Smoothing;
        }
    }

    /// <summary>Smooths images of depth cameras (Kinect, RealSense, time of flight, stereo).</summary>
    public static unsafe class DepthImage
    {
        /// <summary>Removes the sensor's noise from the image of a depth camera, and finds normals.</summary>
        /// <remarks>
        /// The camera is at the origin and looks along +z or -z.  For an image of depths z with the focal lengths f and
        /// the centre c in pixels, the points are x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.  The noise of
        /// such a camera is about the same everywhere in 1 / z, and planes are linear in 1 / z.  So a plane is fitted
        /// to the pixels around each pixel, except those beyond an edge, and the point moves along its ray onto the
        /// plane.
        /// </remarks>
        /// <param name="points">rows * columns points, row by row; NaN, infinity or z = 0: nothing was seen at the
        /// pixel.</param>
        /// <param name="columns">The number of pixels in a row; 8 to 65535.</param>
        /// <param name="rows">The number of rows; 8 to 65535.</param>
        /// <param name="normals">Receives x, y, z of a unit normal for each point, which points to the camera; 0 where
        /// there is no point.</param>
        /// <param name="info">Receives the findings.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>x, y, z of as many points; NaN where nothing was seen, and for points that are left out.</returns>
        /// <exception cref="InvalidArgumentException">The points are not such an image, or an option is out of its
        /// range.</exception>
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
