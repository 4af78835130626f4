// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Result of <see cref="Model.StepPatches"/>.</summary>
    public sealed class StepPatches
    {
        internal StepPatches(double[] corners, double step)
        {
            Corners = corners;
            Step = step;
        }

        /// <summary>Four corners of each patch, counter-clockwise seen from outside: 12 n numbers, absolute.</summary>
        public double[] Corners { get; }

        /// <summary>The initial step.</summary>
        public double Step { get; }
    }

    public sealed unsafe partial class Model
    {
        /// <summary>Places marks on the surface [NPAR 4.2, 5].</summary>
        /// <param name="options">All defaults, a layer of stipples, if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or does not go with another.</exception>
        /// <exception cref="NotConvergedException">All seeds or all marks were dropped, or no stroke fits.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">A function of the program threw.</exception>
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

        /// <summary>The visual feedback for choosing the initial step [NPAR 5.1, Figure 5].</summary>
        /// <param name="count">Squares of side 2 steps, in tangent planes of random seeds.</param>
        /// <param name="options">As for <see cref="Generate"/>, whose seeds and estimate they are.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
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
