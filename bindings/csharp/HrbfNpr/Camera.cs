// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>
    /// A camera: a view matrix, a projection matrix and a viewport.  No method changes a camera; each returns a new
    /// one.
    /// </summary>
    /// <remarks>
    /// Any thread may use a camera.  Coordinate systems are right-handed, and the eye looks along -z.  A matrix has 16
    /// numbers in column-major order and acts on column vectors, as in OpenGL.  Pixels count from the top-left corner.
    /// </remarks>
    public sealed unsafe class Camera
    {
        private hrbfnpr_camera native;

        /// <summary>Creates a camera with identity matrices and a viewport of 0 x 0, which drawing refuses.</summary>
        public Camera()
        {
            fixed (hrbfnpr_camera* camera = &native)
            {
                Errors.Check(NativeMethods.hrbfnpr_camera_init(camera, (uint)sizeof(hrbfnpr_camera)));
            }
        }

        /// <summary>Creates a camera from the matrices of a host.</summary>
        /// <param name="view">World to eye: 16 numbers, invertible.</param>
        /// <param name="projection">Eye to clip: 16 numbers, invertible.</param>
        /// <param name="x">The left edge of the viewport, in pixels.</param>
        /// <param name="y">The top edge of the viewport, in pixels.</param>
        /// <param name="width">The width of the viewport, in pixels.</param>
        /// <param name="height">The height of the viewport, in pixels.</param>
        /// <param name="depthConvention">How depth runs in the projection and in depth buffers.</param>
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

        /// <summary>The matrix from world to eye, column-major: a copy of 16 numbers.</summary>
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

        /// <summary>The matrix from eye to clip space, column-major: a copy of 16 numbers.</summary>
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

        /// <summary>x and y of the viewport's top-left corner, its width and its height, in pixels; a copy.</summary>
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

        /// <summary>The width of an image that holds the viewport, in pixels.</summary>
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

        /// <summary>The height of an image that holds the viewport, in pixels.</summary>
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

        /// <summary>How depth runs in the projection and in depth buffers.</summary>
        public DepthConvention DepthConvention
        {
            get { return (DepthConvention)native.depth_convention; }
        }

        internal hrbfnpr_camera Native
        {
            get { return native; }
        }

        /// <summary>
        /// Creates a camera that looks from an eye towards a target.  Choose its lens with <c>Perspective</c> or
        /// <c>Orthographic</c>.
        /// </summary>
        /// <param name="eye">The place of the eye.</param>
        /// <param name="target">The place that the eye looks at.</param>
        /// <param name="up">A direction roughly upward in the picture.</param>
        /// <param name="depthConvention">How depth runs in the projection and in depth buffers.</param>
        /// <exception cref="InvalidArgumentException">Eye and target are the same, or <c>up</c> is zero or parallel to
        /// the line of sight.</exception>
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

        /// <summary>Returns this camera with a perspective projection.</summary>
        /// <param name="verticalAngle">The vertical angle of view in radians, in (0, pi).</param>
        /// <param name="width">The width in pixels.</param>
        /// <param name="height">The height in pixels.</param>
        /// <param name="near">The distance of the near plane from the eye; above 0.</param>
        /// <param name="far">The distance of the far plane from the eye; above <c>near</c>.</param>
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

        /// <summary>Returns this camera with an orthographic projection.</summary>
        /// <param name="viewHeight">The height of the visible region, in world units; above 0.</param>
        /// <param name="width">The width in pixels.</param>
        /// <param name="height">The height in pixels.</param>
        /// <param name="near">The distance of the near plane from the eye; may be negative.</param>
        /// <param name="far">The distance of the far plane from the eye; above <c>near</c>.</param>
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

        /// <summary>Creates a camera that shows a box as large as the viewport and the margin allow.</summary>
        /// <param name="boundsMin">The lower corner of the box.</param>
        /// <param name="boundsMax">The upper corner of the box.</param>
        /// <param name="direction">The direction from the eye into the scene.</param>
        /// <param name="up">A direction roughly upward in the picture.</param>
        /// <param name="width">The width in pixels.</param>
        /// <param name="height">The height in pixels.</param>
        /// <param name="verticalAngle">The vertical angle of view in radians; 0 = orthographic.</param>
        /// <param name="margin">The share of the picture that stays free on each side; 0 to 0.45.</param>
        /// <param name="depthConvention">How depth runs in the projection and in depth buffers.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range, or <c>up</c> is parallel to the
        /// direction.</exception>
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

        /// <summary>
        /// Creates a camera that shows n points as large as the viewport and the margin allow.  It fits the points
        /// themselves, not their box.
        /// </summary>
        /// <param name="points">The n points, such as the positions of a point set.</param>
        /// <param name="origin">Added to each point: <see cref="PointSetInfo.Origin"/> for positions of a point
        /// set.</param>
        /// <param name="direction">The direction from the eye into the scene.</param>
        /// <param name="up">A direction roughly upward in the picture.</param>
        /// <param name="width">The width in pixels.</param>
        /// <param name="height">The height in pixels.</param>
        /// <param name="verticalAngle">The vertical angle of view in radians; 0 = orthographic.</param>
        /// <param name="margin">The share of the picture that stays free on each side; 0 to 0.45.</param>
        /// <param name="depthConvention">How depth runs in the projection and in depth buffers.</param>
        /// <exception cref="InvalidArgumentException">There are no points, a number is out of its range, or <c>up</c>
        /// is parallel to the direction.</exception>
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
