// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>Makes the line set of the model, from which its lines are drawn for every camera.</summary>
        /// <param name="options">The options; null = all defaults: contours, borders and creases only.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or the mesh would have more than 4
        /// 000 000 triangles: give a larger <see cref="LineSetOptions.CellSize"/>.</exception>
        /// <exception cref="NotConvergedException">No surface was found, or none near its samples.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">A function of the caller threw an exception.</exception>
        public LineSet LineSet(
            LineSetOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_line_set_desc desc;
                (options ?? new LineSetOptions()).Write(&desc, pins, held);
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
