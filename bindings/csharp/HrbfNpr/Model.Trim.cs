// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>What the last trim of the model left out.</summary>
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

        /// <summary>Makes the same model with a surface that ends where its samples end.</summary>
        /// <remarks>
        /// A fitted surface goes on where its samples end, and may have sheets where there never was a sample.  Marks,
        /// line sets and rays of the new model end with the samples. f, projections, curvatures and Contains do not
        /// change.  If nothing is to be left out, the surface stays whole.
        /// </remarks>
        /// <param name="options">The options; null = all defaults, with the model's centres as samples.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or the model is not a fit and no
        /// points are given.</exception>
        /// <exception cref="NotConvergedException">No part of the surface is near the samples, or a single sample has
        /// no spacing.</exception>
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
