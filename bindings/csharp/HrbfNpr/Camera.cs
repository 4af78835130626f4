// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>Where a picture is seen from.  Plain data: no method changes a camera; a camera is not thread-bound.</summary>
    /// <remarks>
    /// Frames are right-handed and the eye looks along -z.  Matrices are 16 numbers, column-major, and act on column
    /// vectors (OpenGL's layout).  Pixels count from the top-left corner.
    /// </remarks>
    public sealed unsafe class Camera
    {
        private hrbfnpr_camera native;

        /// <summary>A camera of identity matrices and no viewport.</summary>
        public Camera()
        {
            fixed (hrbfnpr_camera* camera = &native)
            {
                Errors.Check(NativeMethods.hrbfnpr_camera_init(camera, (uint)sizeof(hrbfnpr_camera)));
            }
        }

        /// <summary>A camera from a host's matrices.</summary>
        /// <param name="view">World to eye, 16 numbers.</param>
        /// <param name="projection">Eye to clip, 16 numbers.</param>
        /// <param name="x">Left of the viewport, pixels.</param>
        /// <param name="y">Top of the viewport, pixels.</param>
        /// <param name="width">Of the viewport, pixels.</param>
        /// <param name="height">Of the viewport, pixels.</param>
        /// <param name="depthConvention">Range of clip-space depth of the projection.</param>
        public Camera(
            double[] view, double[] projection, double x, double y, double width, double height,
            DepthConvention depthConvention = DepthConvention.NegativeOneToOne)
            : this()
        {
            Check(view, nameof(view));
            Check(projection, nameof(projection));
            fixed (hrbfnpr_camera* camera = &native)
            {
                camera->depth_convention = (uint)depthConvention;
                for (int i = 0; i < 16; ++i)
                {
                    camera->view[i] = view[i];
                    camera->projection[i] = projection[i];
                }
                camera->viewport[0] = x;
                camera->viewport[1] = y;
                camera->viewport[2] = width;
                camera->viewport[3] = height;
            }
        }

        internal Camera(hrbfnpr_camera native)
        {
            this.native = native;
        }

        /// <summary>World to eye; a copy.</summary>
        public double[] View
        {
            get
            {
                fixed (double* first = native.view)
                {
                    return Copy(first, 16);
                }
            }
        }

        /// <summary>Eye to clip; a copy.</summary>
        public double[] Projection
        {
            get
            {
                fixed (double* first = native.projection)
                {
                    return Copy(first, 16);
                }
            }
        }

        /// <summary>x, y of the top-left corner, width, height, in pixels; a copy.</summary>
        public double[] Viewport
        {
            get
            {
                fixed (double* first = native.viewport)
                {
                    return Copy(first, 4);
                }
            }
        }

        /// <summary>Width of an image that holds the viewport.</summary>
        public int Width
        {
            get
            {
                fixed (double* viewport = native.viewport)
                {
                    return (int)Math.Ceiling(viewport[0] + viewport[2]);
                }
            }
        }

        /// <summary>Height of an image that holds the viewport.</summary>
        public int Height
        {
            get
            {
                fixed (double* viewport = native.viewport)
                {
                    return (int)Math.Ceiling(viewport[1] + viewport[3]);
                }
            }
        }

        /// <summary>Range of clip-space depth, and of depth buffers.</summary>
        public DepthConvention DepthConvention
        {
            get { return (DepthConvention)native.depth_convention; }
        }

        internal hrbfnpr_camera Native
        {
            get { return native; }
        }

        /// <summary>From an eye towards a target; choose the lens of the result.</summary>
        /// <param name="eye">Where the eye is.</param>
        /// <param name="target">What it looks at.</param>
        /// <param name="up">Roughly up.</param>
        /// <param name="depthConvention">For the projection to come.</param>
        /// <exception cref="InvalidArgumentException">Eye and target are the same, or up is parallel to the view.</exception>
        public static Camera LookAt(
            Vector3d eye, Vector3d target, Vector3d up,
            DepthConvention depthConvention = DepthConvention.NegativeOneToOne)
        {
            hrbfnpr_camera camera = New(depthConvention);
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_camera_look_at(
                    &camera, (double*)&eye, (double*)&target, (double*)&up, &error),
                &error);
            return new Camera(camera);
        }

        /// <summary>This camera with a perspective projection.</summary>
        /// <param name="verticalAngle">Radians, in (0, pi).</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="near">Distance of the near plane, above 0.</param>
        /// <param name="far">Distance of the far plane, above near.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range.</exception>
        public Camera Perspective(double verticalAngle, double width, double height, double near, double far)
        {
            hrbfnpr_camera camera = native;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_camera_perspective(&camera, verticalAngle, width, height, near, far, &error),
                &error);
            return new Camera(camera);
        }

        /// <summary>This camera with a parallel projection.</summary>
        /// <param name="viewHeight">Visible height in world units.</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="near">Near plane, of either sign.</param>
        /// <param name="far">Far plane, above near.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range.</exception>
        public Camera Orthographic(double viewHeight, double width, double height, double near, double far)
        {
            hrbfnpr_camera camera = native;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_camera_orthographic(&camera, viewHeight, width, height, near, far, &error),
                &error);
            return new Camera(camera);
        }

        /// <summary>A camera that sees a box so that it fills the picture.</summary>
        /// <param name="boundsMin">Corner of the box.</param>
        /// <param name="boundsMax">The opposite corner.</param>
        /// <param name="direction">From the eye into the scene.</param>
        /// <param name="up">Roughly up.</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="verticalAngle">Radians; 0 = orthographic.</param>
        /// <param name="margin">Share of the picture left free on each side, 0 to 0.45.</param>
        /// <param name="depthConvention">Of the projection.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range.</exception>
        public static Camera FitBounds(
            Vector3d boundsMin, Vector3d boundsMax, Vector3d direction, Vector3d up, double width, double height,
            double verticalAngle = 0, double margin = 0.05,
            DepthConvention depthConvention = DepthConvention.NegativeOneToOne)
        {
            hrbfnpr_camera camera = New(depthConvention);
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_camera_fit_bounds(
                    &camera, (double*)&boundsMin, (double*)&boundsMax, (double*)&direction, (double*)&up,
                    verticalAngle, width, height, margin, &error),
                &error);
            return new Camera(camera);
        }

        /// <summary>As <see cref="FitBounds"/>, but n points themselves fill the picture, not a box.</summary>
        /// <param name="points">n points, such as a point set's positions.</param>
        /// <param name="origin">Added to each point: <see cref="PointSetInfo.Origin"/>.</param>
        /// <param name="direction">From the eye into the scene.</param>
        /// <param name="up">Roughly up.</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="verticalAngle">Radians; 0 = orthographic.</param>
        /// <param name="margin">Share of the picture left free on each side, 0 to 0.45.</param>
        /// <param name="depthConvention">Of the projection.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range.</exception>
        public static Camera FitPoints(
            ArrayView points, Vector3d origin, Vector3d direction, Vector3d up, double width, double height,
            double verticalAngle = 0, double margin = 0.05,
            DepthConvention depthConvention = DepthConvention.NegativeOneToOne)
        {
            hrbfnpr_camera camera = New(depthConvention);
            hrbfnpr_error error = Errors.New();
            using (var pins = new Pins())
            {
                hrbfnpr_array at = points.ToNative(pins, 3, nameof(points));
                Errors.Check(
                    NativeMethods.hrbfnpr_camera_fit_points(
                        &camera, &at, (double*)&origin, (double*)&direction, (double*)&up, verticalAngle, width,
                        height, margin, &error),
                    &error);
            }
            return new Camera(camera);
        }

        private static hrbfnpr_camera New(DepthConvention depthConvention)
        {
            hrbfnpr_camera camera;
            Errors.Check(NativeMethods.hrbfnpr_camera_init(&camera, (uint)sizeof(hrbfnpr_camera)));
            camera.depth_convention = (uint)depthConvention;
            return camera;
        }

        private static void Check(double[] matrix, string argument)
        {
            if (matrix == null)
            {
                throw new ArgumentNullException(argument);
            }
            if (matrix.Length != 16)
            {
                throw new InvalidArgumentException(argument + " must have 16 numbers, not " + matrix.Length);
            }
        }

        private static double[] Copy(double* first, int count)
        {
            var result = new double[count];
            for (int i = 0; i < count; ++i)
            {
                result[i] = first[i];
            }
            return result;
        }
    }
}
