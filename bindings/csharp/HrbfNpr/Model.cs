// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// An implicit surface: f is negative inside, positive outside, with a gradient near 1 at the surface [NPAR 4].
    /// </summary>
    /// <remarks>
    /// <para>Immutable: any number of threads may use a model at a time.  A model that is disposed of or finalised
    /// goes on living where it is still needed.</para>
    /// <para>Points are packed x, y, z; see <see cref="ArrayView"/> for what can be given.  Results are double; the
    /// calls that end in Into write to memory of the caller's, float or double.</para>
    /// <para>All long calls report progress in [0, 1], which never falls within a call, on the calling thread, and can
    /// be cancelled from any thread; a report that throws cancels the call too.  They may throw
    /// <see cref="CancelledException"/>, <see cref="CallbackException"/>,
    /// <see cref="NativeOutOfMemoryException"/> and <see cref="ObjectDisposedException"/> beside what is named.</para>
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

        /// <summary>What the fit did.</summary>
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
        /// <param name="points">N points, in any unit.</param>
        /// <param name="normals">Their N outward normals; normalised if need be.  Coincident samples that agree are
        /// merged; one sample is a plane.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        /// <exception cref="InvalidArgumentException">NaN, infinity, zero normals, coincident samples that disagree
        /// (the message names the index), mismatched or empty arrays, options out of their range.</exception>
        /// <exception cref="SingularSystemException">There is no (numerically) unique solution.</exception>
        /// <exception cref="NotConvergedException">The message gives the residual reached.</exception>
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

        /// <summary>Any implicit function in place of a fit: every operator works on it [NPAR 8].</summary>
        /// <param name="function">Called with many points at a time.</param>
        /// <param name="boundsMin">Corner of the box that the surface lies in.</param>
        /// <param name="boundsMax">The opposite corner.</param>
        /// <param name="options">What it computes; values only if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">The box is empty or not finite.</exception>
        public static Model FromFunction(
            ImplicitFunction function, Vector3d boundsMin, Vector3d boundsMax, FunctionOptions options = null,
            Context context = null)
        {
            return FromState(new FunctionState(function), boundsMin, boundsMax, options, context);
        }

#if NET7_0_OR_GREATER
        /// <summary>As <see cref="FromFunction"/>, without copies.</summary>
        /// <param name="function">Called with many points at a time.</param>
        /// <param name="boundsMin">Corner of the box that the surface lies in.</param>
        /// <param name="boundsMax">The opposite corner.</param>
        /// <param name="options">What it computes; values only if null.</param>
        /// <param name="context">The default context if null.</param>
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
            GCHandle user = GCHandle.Alloc(state); // freed by the library's call of `release`
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
                    user.Free(); // `release` is not called then
                }
            }
            Errors.Check(status, &error);
            return new Model(made, state);
        }

        /// <summary>f at n points and, if asked for, its gradient and Hessian.</summary>
        /// <param name="points">n points.</param>
        /// <param name="gradient">Whether to compute gradients.</param>
        /// <param name="hessian">Whether to compute Hessians.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite.</exception>
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

        /// <summary>As <c>Evaluate</c>, into the caller's memory.</summary>
        /// <param name="points">n points.</param>
        /// <param name="value">n numbers, or not given.</param>
        /// <param name="gradient">3 n numbers, or not given.</param>
        /// <param name="hessian">6 n numbers, or not given.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call; a part of the results may then be written.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite, or an array does not fit.</exception>
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

        /// <summary>Projects n points on the surface [NPAR 4.2].</summary>
        /// <param name="points">n points.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite, or an option out of its range.</exception>
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

        /// <summary>As <c>Project</c>, into the caller's memory.</summary>
        /// <param name="points">n points.</param>
        /// <param name="position">3 n numbers, or not given; may be the points themselves.</param>
        /// <param name="normal">3 n numbers, or not given.</param>
        /// <param name="status">n numbers, byte or uint (<see cref="ProjectionStatus"/>), or not given.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call; a part of the results may then be written.</param>
        /// <returns>How many points converged.</returns>
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

        /// <summary>Principal curvatures and directions of the level set through each of n points [NPAR 5.3].</summary>
        /// <param name="points">n points.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite.</exception>
        public Curvature Curvature(
            ArrayView points, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var result = new Curvature(points.CountOf(3, nameof(points)));
            CurvatureInto(
                points, result.K1, result.K2, result.D1, result.D2, result.Confidence, progress, cancellationToken);
            return result;
        }

        /// <summary>As <c>Curvature</c>, into the caller's memory; see <see cref="HrbfNpr.Curvature"/>.</summary>
        /// <param name="points">n points.</param>
        /// <param name="k1">n numbers, or not given.</param>
        /// <param name="k2">n numbers, or not given.</param>
        /// <param name="d1">3 n numbers, or not given.</param>
        /// <param name="d2">3 n numbers, or not given.</param>
        /// <param name="confidence">n numbers, or not given.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call; a part of the results may then be written.</param>
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

        /// <summary>A part of the model's own memory, without a copy; empty for a function.</summary>
        public NativeView View(ModelAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_model_view(handle, (uint)attribute, &view, &error), &error);
            return new NativeView(handle.Share(), view);
        }

        /// <summary>Saves the model; the data is versioned and checksummed.</summary>
        /// <param name="stream">Written to on this thread, and not closed.</param>
        /// <exception cref="InvalidArgumentException">The model is a function.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
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

        /// <summary>What <see cref="Save"/> writes.</summary>
        /// <exception cref="InvalidArgumentException">The model is a function.</exception>
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

        /// <summary>Loads a saved model; it evaluates to the same bits.</summary>
        /// <param name="stream">Read from on this thread, not beyond the model's end, and not closed.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="CorruptDataException">It is not a saved model, or is cut short or damaged.</exception>
        /// <exception cref="VersionMismatchException">It was written by a newer library.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
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

        /// <summary>Loads what <see cref="ToBytes"/> returned.</summary>
        /// <param name="data">All of it.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="CorruptDataException">It is not a saved model, or is cut short or damaged.</exception>
        /// <exception cref="VersionMismatchException">It was written by a newer library.</exception>
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

        /// <summary>Lets go of the model; what still needs it keeps it alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        private static Model Load(byte* data, long size, Context context)
        {
            byte none;
            if (size == 0)
            {
                data = &none; // empty data is corrupt, not missing
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
