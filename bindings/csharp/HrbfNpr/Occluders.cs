// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// The surfaces that cast shadows and hide the sky: those of all items that have a line set, at their transforms.
    /// </summary>
    /// <remarks>
    /// Walls thinner than a cell of the line set may let light through.  Occluders never change, so several threads may
    /// use them at the same time.  They need the items and their line sets only while they are made.
    /// </remarks>
    /// <example>
    /// <code>
    /// var style = Style.Preset(Preset.Engraving);
    /// style.AmbientSky = 0.4f;
    /// style.Lights.Add(new Light { Place = (-1, 1, 1), Space = LightSpace.World, Intensity = 0.8f, Shadow = 1 });
    /// var item = new Item(marks, style) { LineSet = lines };
    /// using (var occluders = new Occluders(item))
    /// {
    ///     item.Shading = new Shading(occluders, item);
    /// }
    /// </code>
    /// </example>
    public sealed unsafe class Occluders : IDisposable
    {
        private readonly OccludersHandle handle = new OccludersHandle();

        /// <summary>Gathers the surface of one item.</summary>
        /// <param name="item">The item.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">The item has no line set.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public Occluders(
            Item item, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
            : this(new[] { item }, context, progress, cancellationToken)
        {
        }

        /// <summary>Gathers the surfaces of several items.</summary>
        /// <param name="items">The items, of which at least one has a line set.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">No item has a line set.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public Occluders(
            IReadOnlyList<Item> items, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            if (items == null)
            {
                throw new ArgumentNullException(nameof(items));
            }
            context = Context.Resolve(context);
            using (var structs = new ItemMemory())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_item* first = structs.Write(items, false);
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_occluders_create(
                    context.Handle, first, items.Count, sizeof(hrbfnpr_item), call.Operation, out IntPtr created,
                    &error);
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

        internal OccludersHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Releases the occluders.  Shadings do not need them any more.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
