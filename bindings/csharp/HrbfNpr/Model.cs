// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// An implicit surface f = 0 [NPAR 4].  The function f is negative inside and positive outside, and the length of
    /// its gradient is near 1 at the surface.
    /// </summary>
    /// <remarks>
    /// <para>A model never changes, so several threads may use it at the same time.  A model that is disposed of or
    /// finalised stays alive as long as other objects need it.</para>
    /// <para>Points are packed x, y, z; <see cref="ArrayView"/> says what can be given.  Results are double.  Methods
    /// whose names end in Into write to memory of the caller, float or double.</para>
    /// <para>Long calls report progress from 0 to 1 on the calling thread; it never falls within a call.  They can be
    /// cancelled from any thread.  A progress report that throws cancels the call, too.  Besides the exceptions that a
    /// method names, it may throw <see cref="CancelledException"/>, <see cref="CallbackException"/>,
    /// <see cref="NativeOutOfMemoryException"/> and <see cref="ObjectDisposedException"/>.</para>
    /// </remarks>
    public sealed unsafe partial class Model : IDisposable
    {
        private readonly ModelHandle handle;
        private readonly FunctionState function;

        internal Model(ModelHandle handle, FunctionState function = null)
        {
            this.handle = handle;
            this.function = function;
        }

        /// <summary>What the fit found and did.</summary>
        public ModelInfo Info
        {
            get
            {
                ModelInfo info;
                Errors.Check(NativeMethods.hrbfnpr_model_info_init(&info, (uint)sizeof(ModelInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_model_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        internal ModelHandle Handle
        {
            get { return handle; }
        }

        internal FunctionState Function
        {
            get { return function; }
        }

        /// <summary>Fits f with f(x) = 0 and grad f(x) = n at N samples [NPAR 4.1].</summary>
        /// <param name="points">The N samples, in any unit.  One sample is enough: its surface is a plane.</param>
        /// <param name="normals">The N outward normals, of any length.  Samples at the same place with the same normal
        /// are merged.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        /// <exception cref="InvalidArgumentException">NaN, infinity or a zero normal; samples at the same place with
        /// different normals (the message gives both indices); empty arrays, or arrays of different counts; an option
        /// out of its range.</exception>
        /// <exception cref="SingularSystemException">The linear system has no numerically unique solution.</exception>
        /// <exception cref="NotConvergedException">The iterative solver did not reach its tolerance; the message gives
        /// the residual.</exception>
        public static Model Fit(
            ArrayView points, ArrayView normals, FitOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            hrbfnpr_fit_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_fit_desc_init(&desc, (uint)sizeof(hrbfnpr_fit_desc)));
            (options ?? new FitOptions()).Write(ref desc);
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                desc.points = points.ToNative(pins, 3, nameof(points));
                desc.normals = normals.ToNative(pins, 3, nameof(normals));
                hrbfnpr_error error = Errors.New();
                var made = new ModelHandle();
                int status = NativeMethods.hrbfnpr_model_fit(
                    context.Handle, &desc, call.Operation, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                return Finish(made, null, call, status, &error);
            }
        }

        /// <summary>
        /// Makes a model of any implicit function.  Everything that works on a fit works on it [NPAR 8].
        /// </summary>
        /// <param name="function">The function, which gets many points in each call.</param>
        /// <param name="boundsMin">The lower corner of the box that holds the surface.  Make the box fit the surface
        /// closely.</param>
        /// <param name="boundsMax">The upper corner of the box.</param>
        /// <param name="options">What the function can do; null = it computes values only, on one thread at a
        /// time.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">The box is empty or not finite.</exception>
        public static Model FromFunction(
            ImplicitFunction function, Vector3d boundsMin, Vector3d boundsMax, FunctionOptions options = null,
            Context context = null)
        {
            return FromState(new FunctionState(function), boundsMin, boundsMax, options, context);
        }

#if NET7_0_OR_GREATER
        /// <summary>
        /// Makes a model of any implicit function, like <see cref="FromFunction"/>, but the function works on spans,
        /// without copies.
        /// </summary>
        /// <param name="function">The function, which gets many points in each call.</param>
        /// <param name="boundsMin">The lower corner of the box that holds the surface.  Make the box fit the surface
        /// closely.</param>
        /// <param name="boundsMax">The upper corner of the box.</param>
        /// <param name="options">What the function can do; null = it computes values only, on one thread at a
        /// time.</param>
        /// <param name="context">The context; null = the default context.</param>
        public static Model FromSpanFunction(
            ImplicitSpanFunction function, Vector3d boundsMin, Vector3d boundsMax, FunctionOptions options = null,
            Context context = null)
        {
            return FromState(new FunctionState(function), boundsMin, boundsMax, options, context);
        }
#endif

        private static Model FromState(
            FunctionState state, Vector3d boundsMin, Vector3d boundsMax, FunctionOptions options, Context context)
        {
            context = Context.Resolve(context);
            hrbfnpr_custom_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_custom_desc_init(&desc, (uint)sizeof(hrbfnpr_custom_desc)));
            options = options ?? new FunctionOptions();
            desc.flags = options.Flags;
            desc.difference_step = options.DifferenceStep;
            desc.function = FunctionState.Evaluate;
            desc.release = FunctionState.Release;
            *(Vector3d*)desc.bounds_min = boundsMin;
            *(Vector3d*)desc.bounds_max = boundsMax;
            GCHandle user = GCHandle.Alloc(state); // the library's call of `release` frees it
            desc.user = GCHandle.ToIntPtr(user);
            hrbfnpr_error error = Errors.New();
            var made = new ModelHandle();
            int status = -1;
            try
            {
                status = NativeMethods.hrbfnpr_model_create_custom(
                    context.Handle, &desc, out IntPtr created, &error);
                made.Take(created, context.Anchor);
            }
            finally
            {
                if (status != 0)
                {
                    user.Free(); // the library does not call `release` in this case
                }
            }
            Errors.Check(status, &error);
            return new Model(made, state);
        }

        /// <summary>Evaluates f at n points, and on request its gradient and its Hessian.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="gradient">Whether to compute gradients; default false.</param>
        /// <param name="hessian">Whether to compute Hessians; default false.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite or too far away.</exception>
        public Evaluation Evaluate(
            ArrayView points, bool gradient = false, bool hessian = false, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            long count = points.CountOf(3, nameof(points));
            var result = new Evaluation(
                new double[count], gradient ? new double[count * 3] : null, hessian ? new double[count * 6] : null);
            EvaluateInto(points, result.Value, result.Gradient, result.Hessian, progress, cancellationToken);
            return result;
        }

        /// <summary>Evaluates f, its gradient and its Hessian at n points, into the caller's memory.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="value">Receives n values; optional.</param>
        /// <param name="gradient">Receives 3 n derivatives; optional.</param>
        /// <param name="hessian">Receives 6 n derivatives, xx xy xz yy yz zz; optional.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call; some of the results may have been written by then.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite or too far away, or an array has another
        /// size or type.</exception>
        public void EvaluateInto(
            ArrayView points, ArrayView value, ArrayView gradient = default(ArrayView),
            ArrayView hessian = default(ArrayView), IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array at = points.ToNative(pins, 3, nameof(points));
                hrbfnpr_array values = value.ToNative(pins, 1, nameof(value));
                hrbfnpr_array gradients = gradient.ToNative(pins, 3, nameof(gradient));
                hrbfnpr_array hessians = hessian.ToNative(pins, 6, nameof(hessian));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_model_evaluate(
                    handle, &at, value.IsGiven ? &values : null, gradient.IsGiven ? &gradients : null,
                    hessian.IsGiven ? &hessians : null, call.Operation, &error);
                call.Check(status, &error, function);
            }
        }

        /// <summary>Projects n points onto the surface [NPAR 4.2].</summary>
        /// <param name="points">The n points.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite or too far away, or an option is out of its
        /// range.</exception>
        public Projection Project(
            ArrayView points, ProjectOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var result = new Projection(points.CountOf(3, nameof(points)));
            ArrayView status = ArrayView.OfBytes(result.Status);
            result.Converged = ProjectInto(
                points, result.Position, result.Normal, status, options, progress, cancellationToken);
            return result;
        }

        /// <summary>Projects n points onto the surface, into the caller's memory.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="position">Receives 3 n numbers; optional; may be the memory of the points.</param>
        /// <param name="normal">Receives 3 n numbers; optional.</param>
        /// <param name="status">Receives n numbers, byte or uint (<see cref="ProjectionStatus"/>); optional.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call; some of the results may have been written by then.</param>
        /// <returns>The number of points that converged.</returns>
        public long ProjectInto(
            ArrayView points, ArrayView position, ArrayView normal = default(ArrayView),
            ArrayView status = default(ArrayView), ProjectOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            hrbfnpr_project_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_project_desc_init(&desc, (uint)sizeof(hrbfnpr_project_desc)));
            (options ?? new ProjectOptions()).Write(ref desc);
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array at = points.ToNative(pins, 3, nameof(points));
                hrbfnpr_projection result;
                Errors.Check(NativeMethods.hrbfnpr_projection_init(&result, (uint)sizeof(hrbfnpr_projection)));
                result.position = position.ToNative(pins, 3, nameof(position));
                result.normal = normal.ToNative(pins, 3, nameof(normal));
                result.status = status.ToNative(pins, 1, nameof(status));
                hrbfnpr_error error = Errors.New();
                int failed = NativeMethods.hrbfnpr_model_project(
                    handle, &at, &desc, &result, call.Operation, &error);
                call.Check(failed, &error, function);
                return result.converged;
            }
        }

        /// <summary>
        /// Computes the principal curvatures and directions of the level set through each of n points [NPAR 5.3].
        /// </summary>
        /// <param name="points">The n points.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite or too far away.</exception>
        public Curvature Curvature(
            ArrayView points, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var result = new Curvature(points.CountOf(3, nameof(points)));
            CurvatureInto(
                points, result.K1, result.K2, result.D1, result.D2, result.Confidence, progress, cancellationToken);
            return result;
        }

        /// <summary>
        /// Computes principal curvatures and directions into the caller's memory; <see cref="HrbfNpr.Curvature"/>
        /// describes them.
        /// </summary>
        /// <param name="points">The n points.</param>
        /// <param name="k1">Receives n numbers; optional.</param>
        /// <param name="k2">Receives n numbers; optional.</param>
        /// <param name="d1">Receives 3 n numbers; optional.</param>
        /// <param name="d2">Receives 3 n numbers; optional.</param>
        /// <param name="confidence">Receives n numbers; optional.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call; some of the results may have been written by then.</param>
        public void CurvatureInto(
            ArrayView points, ArrayView k1, ArrayView k2 = default(ArrayView), ArrayView d1 = default(ArrayView),
            ArrayView d2 = default(ArrayView), ArrayView confidence = default(ArrayView),
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array at = points.ToNative(pins, 3, nameof(points));
                hrbfnpr_curvature result;
                Errors.Check(NativeMethods.hrbfnpr_curvature_init(&result, (uint)sizeof(hrbfnpr_curvature)));
                result.k1 = k1.ToNative(pins, 1, nameof(k1));
                result.k2 = k2.ToNative(pins, 1, nameof(k2));
                result.d1 = d1.ToNative(pins, 3, nameof(d1));
                result.d2 = d2.ToNative(pins, 3, nameof(d2));
                result.confidence = confidence.ToNative(pins, 1, nameof(confidence));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_model_curvature(handle, &at, &result, call.Operation, &error);
                call.Check(status, &error, function);
            }
        }

        /// <summary>
        /// Gives a view of an array of the model, without a copy.  It is empty for a model from a function and for a
        /// solid.
        /// </summary>
        public NativeView View(ModelAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_model_view(handle, (uint)attribute, &view, &error), &error);
            return new NativeView(handle.Share(), view);
        }

        /// <summary>Saves the model.  The data has a version and a checksum.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <exception cref="InvalidArgumentException">The model is from a function, or is a solid with such a model
        /// among its leaves.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public void Save(Stream stream)
        {
            var state = new StreamState(stream);
            using (var user = new UserHandle(state))
            {
                hrbfnpr_error error = Errors.New();
                state.Check(
                    NativeMethods.hrbfnpr_model_save(handle, StreamState.Write, user.Pointer, &error), &error);
            }
        }

        /// <summary>Returns what <see cref="Save"/> writes.</summary>
        /// <exception cref="InvalidArgumentException">The model is from a function, or is a solid with such a model
        /// among its leaves.</exception>
        public byte[] ToBytes()
        {
            long size = 0;
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_model_save_memory(handle, null, 0, &size, &error);
            if (status != (int)Status.BufferTooSmall)
            {
                Errors.Check(status, &error);
            }
            var data = new byte[size];
            fixed (byte* destination = data)
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_model_save_memory(handle, destination, size, &size, &error), &error);
            }
            return data;
        }

        /// <summary>Loads a saved model.  It evaluates to the same bits.</summary>
        /// <param name="stream">The stream, which is read on this thread, not beyond the model's end, and is not
        /// closed.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="CorruptDataException">The data is not a saved model, or is truncated or
        /// damaged.</exception>
        /// <exception cref="VersionMismatchException">A newer library wrote the data.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public static Model Load(Stream stream, Context context = null)
        {
            context = Context.Resolve(context);
            var state = new StreamState(stream);
            using (var user = new UserHandle(state))
            {
                hrbfnpr_error error = Errors.New();
                var made = new ModelHandle();
                int status = NativeMethods.hrbfnpr_model_load(
                    context.Handle, StreamState.Read, user.Pointer, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                state.Check(status, &error);
                return new Model(made);
            }
        }

        /// <summary>Loads a model from the data that <see cref="ToBytes"/> returned.</summary>
        /// <param name="data">The whole data.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="CorruptDataException">The data is not a saved model, or is truncated or
        /// damaged.</exception>
        /// <exception cref="VersionMismatchException">A newer library wrote the data.</exception>
        public static Model Load(byte[] data, Context context = null)
        {
            if (data == null)
            {
                throw new ArgumentNullException(nameof(data));
            }
            fixed (byte* start = data)
            {
                return Load(start, data.LongLength, context);
            }
        }

        /// <summary>Releases the model.  Objects that need it keep it alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        private static Model Load(byte* data, long size, Context context)
        {
            byte none;
            if (size == 0)
            {
                data = &none; // so that empty data is corrupt, not missing
            }
            context = Context.Resolve(context);
            hrbfnpr_error error = Errors.New();
            var made = new ModelHandle();
            int status = NativeMethods.hrbfnpr_model_load_memory(
                context.Handle, data, size, out IntPtr created, &error);
            made.Take(created, context.Anchor);
            Errors.Check(status, &error);
            return new Model(made);
        }

        private static Model Finish(
            ModelHandle made, FunctionState function, LongCall call, int status, hrbfnpr_error* error)
        {
            try
            {
                call.Check(status, error);
                return new Model(made, function);
            }
            catch
            {
                made.Dispose();
                throw;
            }
        }
    }
}
