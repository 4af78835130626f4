// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Makes drawings of items for a camera [NPAR 6].</summary>
    /// <remarks>
    /// A renderer keeps its scratch memory from one drawing to the next, and the memory of drawings that were disposed
    /// of.  Calls of several threads to one renderer wait for each other, so give each thread its own renderer.
    /// </remarks>
    /// <example>
    /// <code>
    /// var renderer = new Renderer();
    /// using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
    /// {
    ///     byte[] pixels = drawing.Rasterize();
    /// }
    /// </code>
    /// </example>
    public sealed unsafe class Renderer : IDisposable
    {
        private readonly object gate = new object();
        private readonly RendererHandle handle = new RendererHandle();
        private readonly Item[] single = new Item[1];
        private readonly ItemMemory structs = new ItemMemory();
        private bool drawing;

        /// <summary>Creates a renderer.</summary>
        /// <param name="context">The context; null = the default context.</param>
        public Renderer(Context context = null)
        {
            context = Context.Resolve(context);
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_renderer_create(context.Handle, out IntPtr created, &error);
            handle.Take(created, context.Anchor);
            Errors.Check(status, &error);
        }

        /// <summary>Draws one item.</summary>
        /// <param name="item">The item.  A point set converts implicitly, to an item in the default style.</param>
        /// <param name="camera">The camera.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.  The renderer can be used again.</param>
        /// <returns>A drawing.  If it is disposed of before the next but one is made, its memory is used
        /// again.</returns>
        /// <exception cref="InvalidArgumentException">The camera has no viewport, a transform is singular, a number of
        /// a style is out of its range, or lines need curvatures and the line set has none.</exception>
        /// <exception cref="CallbackException">A tone function or the function of a model threw an
        /// exception.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public Drawing Draw(
            Item item, Camera camera, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            lock (gate)
            {
                CheckIdle();
                single[0] = item;
                try
                {
                    return DrawWatched(single, camera, progress, cancellationToken);
                }
                finally
                {
                    single[0] = null;
                }
            }
        }

        /// <summary>Draws several items.</summary>
        /// <param name="items">The items; may be empty.</param>
        /// <param name="camera">The camera.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.  The renderer can be used again.</param>
        /// <returns>A drawing.  If it is disposed of before the next but one is made, its memory is used
        /// again.</returns>
        /// <exception cref="InvalidArgumentException">The camera has no viewport, a transform is singular, a number of
        /// a style is out of its range, lines need curvatures and the line set has none, or styles have different paper
        /// or visibility.</exception>
        /// <exception cref="CallbackException">A tone function or the function of a model threw an
        /// exception.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public Drawing Draw(
            IReadOnlyList<Item> items, Camera camera, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            if (items == null)
            {
                throw new ArgumentNullException(nameof(items));
            }
            lock (gate)
            {
                CheckIdle();
                return DrawWatched(items, camera, progress, cancellationToken);
            }
        }

        /// <summary>Releases the memory of the renderer.  Its drawings stay alive.</summary>
        public void Dispose()
        {
            lock (gate)
            {
                CheckIdle();
                handle.Dispose();
                structs.Dispose();
            }
        }

        /// <summary>Refuses to draw from a function that a drawing of the same renderer runs.</summary>
        private void CheckIdle()
        {
            if (drawing)
            {
                throw new InvalidOperationException("the renderer is drawing; a tone function cannot use it");
            }
        }

        /// <summary>
        /// Draws without an operation if neither progress nor cancelling is used, so that a frame allocates no managed
        /// memory.
        /// </summary>
        private Drawing DrawWatched(
            IReadOnlyList<Item> items, Camera camera, IProgress<double> progress, CancellationToken token)
        {
            if (progress == null && !token.CanBeCanceled)
            {
                return DrawItems(items, camera, null);
            }
            using (var call = new LongCall(handle, progress, token))
            {
                return DrawItems(items, camera, call);
            }
        }

        private Drawing DrawItems(IReadOnlyList<Item> items, Camera camera, LongCall call)
        {
            if (camera == null)
            {
                throw new ArgumentNullException(nameof(camera));
            }
            drawing = true;
            try
            {
                return Call(items, camera, structs.Write(items), items.Count, call);
            }
            finally
            {
                drawing = false;
                structs.Clear();
            }
        }

        private Drawing Call(
            IReadOnlyList<Item> items, Camera camera, hrbfnpr_item* first, int count, LongCall call)
        {
            hrbfnpr_camera view = camera.Native;
            hrbfnpr_error error = Errors.New();
            var made = new DrawingHandle();
            OperationHandle operation = call == null ? OperationHandle.None : call.Operation;
            int status = NativeMethods.hrbfnpr_renderer_draw_with_operation(
                handle, first, count, sizeof(hrbfnpr_item), &view, operation, out IntPtr created, &error);
            if (created != IntPtr.Zero)
            {
                made.Take(created, handle.Anchor);
            }
            try
            {
                structs.CheckFunctions(items, status);
                if (call == null)
                {
                    Errors.Check(status, &error);
                }
                else
                {
                    call.Check(status, &error);
                }
                return new Drawing(made, camera);
            }
            catch
            {
                made.Dispose();
                throw;
            }
        }
    }
}
