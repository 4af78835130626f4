// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Gives values on a surface.</summary>
    /// <param name="positions">3 n numbers: absolute positions.</param>
    /// <param name="normals">3 n numbers: unit normals.</param>
    /// <param name="values">Receives n numbers for <see cref="FieldKind.Scalar"/>, 3 n for other kinds.</param>
    /// <param name="weights">Receives n numbers from 0 to 1; they are 1 before the call.</param>
    public delegate void FieldFunction(double[] positions, double[] normals, double[] values, double[] weights);

    /// <summary>Values on a surface: a number, a colour or a direction at each place, and a weight.</summary>
    /// <remarks>
    /// Give it to <see cref="PointSet.WithFields"/>, or to a <see cref="Layer"/>.  A field never changes, so several
    /// threads may use it at the same time.
    /// </remarks>
    /// <example>
    /// <code>
    /// using (var heat = Field.FromPoints(vertices, values, triangles, range: (20.0, 90.0)))
    /// {
    ///     marks = marks.WithFields(new Dictionary&lt;string, Field&gt; { { "heat", heat } });
    /// }
    /// style.Layers[0].ToneField = "heat";
    /// </code>
    /// </example>
    public sealed unsafe class Field : IDisposable
    {
        private readonly FieldHandle handle = new FieldHandle();

        private Field(FieldKind kind)
        {
            Kind = kind;
        }

        /// <summary>The kind of values.</summary>
        public FieldKind Kind { get; }

        internal FieldHandle Handle
        {
            get { return handle; }
        }

        /// <summary>What the function of the field threw; null for other fields.</summary>
        internal CallbackState Function { get; private set; }

        private int Components
        {
            get { return Kind == FieldKind.Scalar ? 1 : 3; }
        }

        /// <summary>Makes a new reference to a field of a picture's layers; null if there is none.</summary>
        /// <param name="value">The field; may be zero.</param>
        /// <param name="kind">The kind of its values.</param>
        /// <param name="owner">The handle of the picture; null for a preset.</param>
        internal static Field Of(IntPtr value, FieldKind kind, SafeHandle owner)
        {
            if (value == IntPtr.Zero || owner == null)
            {
                return null;
            }
            var made = new Field(kind);
            made.handle.Keep(owner);
            NativeMethods.hrbfnpr_field_retain(value);
            made.handle.Take(value, ((NativeHandle)owner).Anchor);
            return made;
        }

        /// <summary>Makes a field from values at points, or at the vertices of a mesh.</summary>
        /// <param name="points">n points; float or double.</param>
        /// <param name="values">n or 3 n numbers; float, double or byte.  Colours are sRGB-encoded, 0 to 1, or bytes
        /// from 0 to 255.</param>
        /// <param name="triangles">The numbers of their corners; int, uint or long.  With triangles, values are
        /// interpolated on the nearest one.  Not given: a place has the value of the nearest point.</param>
        /// <param name="kind">The kind of values.</param>
        /// <param name="range">For Scalar: the first number becomes 0, the second 1, and values are clamped; null =
        /// values stay as they are.</param>
        /// <param name="reach">The distance beyond which a place has no value; 0 = there is no such distance.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An array has a wrong size, or a triangle a corner that does not
        /// exist.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public static Field FromPoints(
            ArrayView points, ArrayView values, ArrayView triangles = default(ArrayView),
            FieldKind kind = FieldKind.Scalar, (double Low, double High)? range = null, double reach = 0,
            Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var made = new Field(kind);
            using (var pins = new Pins())
            {
                hrbfnpr_field_desc desc = made.Describe(FieldSource.Points, range);
                desc.points = points.ToNative(pins, 3, nameof(points));
                desc.values = values.ToNative(pins, made.Components, nameof(values));
                desc.triangles = triangles.ToNative(pins, 3, nameof(triangles));
                desc.reach = reach;
                made.Create(ref desc, context, progress, cancellationToken);
            }
            return made;
        }

        /// <summary>Makes a field from a function, which runs on the thread that uses the field.</summary>
        /// <param name="function">The function.  If it throws, the call that uses the field throws a
        /// <see cref="CallbackException"/>.</param>
        /// <param name="kind">The kind of values.</param>
        /// <param name="range">As in <see cref="FromPoints"/>.</param>
        /// <param name="context">The context; null = the default context.</param>
        public static Field FromFunction(
            FieldFunction function, FieldKind kind = FieldKind.Scalar, (double Low, double High)? range = null,
            Context context = null)
        {
            var made = new Field(kind);
            var state = new FieldState(function, made.Components);
            made.Function = state;
            hrbfnpr_field_desc desc = made.Describe(FieldSource.Function, range);
            desc.function = FieldState.Evaluate;
            desc.user = made.handle.Keep(state);
            try
            {
                made.Create(ref desc, context, null, default(CancellationToken));
            }
            catch
            {
                made.handle.Forget();
                throw;
            }
            return made;
        }

        /// <summary>Makes a field from dabs of a brush, which act one after the other.</summary>
        /// <param name="dabs">The dabs.  All act, whatever their map.  Scalar takes their Value; Direction takes their
        /// Direction, and Colour takes it as r, g and b.</param>
        /// <param name="kind">The kind of values.</param>
        /// <param name="range">As in <see cref="FromPoints"/>.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">A number of a dab is out of its range.</exception>
        public static Field FromDabs(
            IReadOnlyList<Dab> dabs, FieldKind kind = FieldKind.Scalar, (double Low, double High)? range = null,
            Context context = null)
        {
            if (dabs == null)
            {
                throw new ArgumentNullException(nameof(dabs));
            }
            var made = new Field(kind);
            var list = new hrbfnpr_dab[dabs.Count];
            using (var pins = new Pins())
            {
                var first = (hrbfnpr_dab*)pins.Pin(list);
                for (int i = 0; i < list.Length; ++i)
                {
                    Dab dab = dabs[i] ?? throw new ArgumentNullException(nameof(dabs));
                    dab.Write(first + i);
                }
                hrbfnpr_field_desc desc = made.Describe(FieldSource.Dabs, range);
                desc.dabs = list.Length == 0 ? IntPtr.Zero : (IntPtr)first;
                desc.dab_count = list.Length;
                made.Create(ref desc, context, null, default(CancellationToken));
            }
            return made;
        }

        /// <summary>Makes a field from an image that is projected onto the surface along a camera.</summary>
        /// <param name="pixels">The pixels, row by row from the top, packed.</param>
        /// <param name="width">The width in pixels.</param>
        /// <param name="height">The height in pixels.</param>
        /// <param name="camera">The camera.  The image fills its viewport.</param>
        /// <param name="kind">Colour takes the colour, Scalar its luminance.</param>
        /// <param name="format">The format of the pixels, with colours.  Alpha is the weight.</param>
        /// <param name="occluders">The surfaces that hide places from the camera; null = none.</param>
        /// <param name="range">As in <see cref="FromPoints"/>.</param>
        /// <param name="context">The context; null = the default context.</param>
        public static Field FromImage(
            byte[] pixels, int width, int height, Camera camera, FieldKind kind = FieldKind.Colour,
            PixelFormat format = PixelFormat.Rgba8, Occluders occluders = null,
            (double Low, double High)? range = null, Context context = null)
        {
            if (pixels == null || camera == null)
            {
                throw new ArgumentNullException(pixels == null ? nameof(pixels) : nameof(camera));
            }
            if (pixels.LongLength < (long)width * height * Drawing.PixelBytes(format))
            {
                throw new InvalidArgumentException("pixels has fewer bytes than width * height pixels need");
            }
            var made = new Field(kind);
            hrbfnpr_camera view = camera.Native;
            hrbfnpr_image image;
            Errors.Check(NativeMethods.hrbfnpr_image_init(&image, (uint)sizeof(hrbfnpr_image)));
            image.format = (uint)format;
            image.width = width;
            image.height = height;
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            {
                image.pixels = pins.Pin(pixels);
                hrbfnpr_field_desc desc = made.Describe(FieldSource.Image, range);
                desc.image = (IntPtr)(&image);
                desc.camera = (IntPtr)(&view);
                desc.occluders = occluders == null ? IntPtr.Zero : held.Hold(occluders.Handle);
                made.Create(ref desc, context, null, default(CancellationToken));
            }
            return made;
        }

        /// <summary>Evaluates the field.</summary>
        /// <param name="positions">n places; float or double.</param>
        /// <param name="normals">n unit normals; float or double.  Fields of points do not need them.</param>
        /// <param name="weights">Receives n weights.</param>
        /// <returns>n numbers for Scalar, 3 n for other kinds; 0 where the weight is 0.</returns>
        /// <exception cref="CallbackException">The function of the field threw an exception.</exception>
        public double[] Evaluate(ArrayView positions, ArrayView normals, out double[] weights)
        {
            long count = positions.CountOf(3, nameof(positions));
            var values = new double[count * Components];
            weights = new double[count];
            using (var pins = new Pins())
            using (var call = new LongCall(handle, null, default(CancellationToken)))
            {
                hrbfnpr_array place = positions.ToNative(pins, 3, nameof(positions));
                hrbfnpr_array normal = normals.ToNative(pins, 3, nameof(normals));
                hrbfnpr_array value = ((ArrayView)values).ToNative(pins, Components, nameof(values));
                hrbfnpr_array weight = ((ArrayView)weights).ToNative(pins, 1, nameof(weights));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_field_evaluate(
                    handle, &place, &normal, &value, &weight, call.Operation, &error);
                call.Check(status, &error, Function);
            }
            return values;
        }

        /// <summary>Releases the field.  Point sets that have its values do not need it any more.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        private hrbfnpr_field_desc Describe(FieldSource source, (double Low, double High)? range)
        {
            hrbfnpr_field_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_field_desc_init(&desc, (uint)sizeof(hrbfnpr_field_desc)));
            desc.kind = (uint)Kind;
            desc.source = (uint)source;
            if (range != null)
            {
                desc.range[0] = range.Value.Low;
                desc.range[1] = range.Value.High;
            }
            return desc;
        }

        private void Create(
            ref hrbfnpr_field_desc desc, Context context, IProgress<double> progress, CancellationToken token)
        {
            context = Context.Resolve(context);
            using (var call = new LongCall(context.Handle, progress, token))
            {
                hrbfnpr_field_desc copy = desc;
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_field_create(
                    context.Handle, &copy, call.Operation, out IntPtr created, &error);
                handle.Take(created, context.Anchor);
                try
                {
                    call.Check(status, &error);
                }
                catch
                {
                    handle.Dispose(); // progress may throw after the call has succeeded
                    throw;
                }
            }
        }
    }

    /// <summary>Where the values of a field come from.</summary>
    [NativeConstants("HRBFNPR_FIELD_SOURCE_")]
    internal enum FieldSource
    {
        Points = 0,
        Function = 1,
        Dabs = 2,
        Image = 3,
    }

    /// <summary>The function of one field, and what it threw.</summary>
    internal sealed unsafe class FieldState : CallbackState
    {
        internal static readonly IntPtr Evaluate;
        private static readonly NativeCallbacks.Field EvaluateCallback = OnEvaluate;
        private readonly FieldFunction function;
        private readonly int components;

        static FieldState()
        {
            Evaluate = Marshal.GetFunctionPointerForDelegate(EvaluateCallback);
        }

        internal FieldState(FieldFunction function, int components)
        {
            this.function = function ?? throw new ArgumentNullException(nameof(function));
            this.components = components;
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Field))]
        private static int OnEvaluate(
            IntPtr user, long count, double* positions, double* normals, double* values, double* weights)
        {
            var state = From<FieldState>(user);
            try
            {
                var place = new double[count * 3];
                var normal = new double[count * 3];
                var value = new double[count * state.components];
                var weight = new double[count];
                Marshal.Copy((IntPtr)positions, place, 0, place.Length);
                Marshal.Copy((IntPtr)normals, normal, 0, normal.Length);
                Marshal.Copy((IntPtr)weights, weight, 0, weight.Length);
                state.function(place, normal, value, weight);
                Marshal.Copy(value, 0, (IntPtr)values, value.Length);
                Marshal.Copy(weight, 0, (IntPtr)weights, weight.Length);
                return 0;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return 1;
            }
        }
    }
}
