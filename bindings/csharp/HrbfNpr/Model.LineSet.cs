// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>Makes what lines of the surface are drawn from, whatever the camera.</summary>
        /// <param name="options">All defaults, for contours and borders, if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or there are more than 4 000 000
        /// triangles: a larger <see cref="LineSetOptions.CellSize"/> is needed.</exception>
        /// <exception cref="NotConvergedException">No surface was found, or none near its samples.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">A function of the program threw.</exception>
        public LineSet LineSet(
            LineSetOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_line_set_desc desc;
                (options ?? new LineSetOptions()).Write(&desc, pins);
                hrbfnpr_error error = Errors.New();
                var made = new LineSetHandle();
                int status = NativeMethods.hrbfnpr_line_set_create(
                    context.Handle, handle, &desc, call.Operation, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                try
                {
                    call.Check(status, &error, function);
                    return new LineSet(made, function);
                }
                catch
                {
                    made.Dispose();
                    throw;
                }
            }
        }
    }
}
