// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>What <see cref="Trim"/> left out.</summary>
        public TrimInfo TrimInfo
        {
            get
            {
                TrimInfo info;
                Errors.Check(NativeMethods.hrbfnpr_trim_info_init(&info, (uint)sizeof(TrimInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_model_get_trim_info(handle, &info, &error), &error);
                return info;
            }
        }

        /// <summary>The same model with a surface that ends where its samples do.</summary>
        /// <remarks>
        /// The surface of an open scan or a terrain goes on where the samples end, and a fit may grow sheets where no
        /// sample ever was.  Marks, line sets and rays of the new model end where those do; f, projections, curvatures
        /// and Contains do not change.  A surface of which nothing is to be left out stays whole.
        /// </remarks>
        /// <param name="options">All defaults, the model's centres for samples, if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or a model from a function got no
        /// points.</exception>
        /// <exception cref="NotConvergedException">No part of the surface is near the samples.</exception>
        public Model Trim(
            TrimOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_trim_desc desc;
                (options ?? new TrimOptions()).Write(&desc, pins);
                hrbfnpr_error error = Errors.New();
                var made = new ModelHandle();
                int status = NativeMethods.hrbfnpr_model_trim(
                    handle, &desc, call.Operation, out IntPtr created, &error);
                made.Take(created, handle.Anchor);
                return Finish(made, function, call, status, &error);
            }
        }
    }
}
