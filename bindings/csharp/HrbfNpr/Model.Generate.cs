// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>The squares of <see cref="Model.StepPatches"/>.</summary>
    public sealed class StepPatches
    {
        internal StepPatches(double[] corners, double step)
        {
            Corners = corners;
            Step = step;
        }

        /// <summary>
        /// The four corners of each square, absolute, counter-clockwise as seen from outside: 12 n numbers.
        /// </summary>
        public double[] Corners { get; }

        /// <summary>The initial step, in the unit of the samples.</summary>
        public double Step { get; }
    }

    public sealed unsafe partial class Model
    {
        /// <summary>Places marks on the surface [NPAR 4.2, 5].</summary>
        /// <param name="options">The options; null = all defaults: one layer of stipples.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or contradicts
        /// another.</exception>
        /// <exception cref="NotConvergedException">No seed or no mark could be placed, or no stroke has room with the
        /// given separation or step.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">A function of the caller threw an exception.</exception>
        public PointSet Generate(
            GenerateOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            using (var described = new GenerateCall(options))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_generate_desc desc = described.Desc;
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_generate(
                    context.Handle, handle, &desc, call.Operation, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                try
                {
                    described.Check(call, status, &error, this);
                    return new PointSet(made);
                }
                catch
                {
                    made.Dispose();
                    throw;
                }
            }
        }

        /// <summary>
        /// Makes squares that show how large the initial step of <see cref="Distribution.Published"/> is [NPAR 5.1,
        /// Figure 5].
        /// </summary>
        /// <param name="count">The number of squares.  Each has sides of two steps, and lies in the tangent plane of a
        /// random seed.</param>
        /// <param name="options">The options of <see cref="Generate"/>, which uses the same seeds and the same
        /// step.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public StepPatches StepPatches(
            int count, GenerateOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            var corners = new double[count * 12];
            double step;
            using (var pins = new Pins())
            using (var described = new GenerateCall(options))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_generate_desc desc = described.Desc;
                hrbfnpr_array target = ((ArrayView)corners).ToNative(pins, 12, nameof(corners));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_point_set_step_patches(
                    context.Handle, handle, &desc, &target, &step, call.Operation, &error);
                described.Check(call, status, &error, this);
            }
            return new StepPatches(corners, step);
        }
    }
}
