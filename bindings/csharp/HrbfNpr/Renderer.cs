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
        private readonly Memory memory = new Memory();
        private readonly HeldHandles held = new HeldHandles();
        private readonly Pins pins = new Pins();
        private readonly List<ToneState> tones = new List<ToneState>();
        private readonly List<UserHandle> users = new List<UserHandle>();
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
                memory.Dispose();
            }
        }

        private static long Size(Item item)
        {
            long size = Memory.Rounded(sizeof(hrbfnpr_item))
                + Memory.Rounded((long)item.Poses.Count * sizeof(hrbfnpr_layer_pose));
            return item.Style == null ? size : size + StyleMemory.Size(item.Style);
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
            int count = items.Count;
            long size = 0;
            for (int i = 0; i < count; ++i)
            {
                if (items[i] == null)
                {
                    throw new ArgumentNullException(nameof(items));
                }
                size += Size(items[i]);
            }
            drawing = true;
            try
            {
                memory.Begin(size);
                var first = (hrbfnpr_item*)memory.Take((long)count * sizeof(hrbfnpr_item));
                for (int i = 0; i < count; ++i)
                {
                    Describe(items[i], first + i);
                }
                return Call(items, camera, first, count, call);
            }
            finally
            {
                drawing = false;
                held.Dispose();
                pins.Dispose();
                tones.Clear();
                foreach (UserHandle user in users)
                {
                    user.Dispose();
                }
                users.Clear();
            }
        }

        private void Describe(Item item, hrbfnpr_item* native)
        {
            Errors.Check(NativeMethods.hrbfnpr_item_init(native, (uint)sizeof(hrbfnpr_item)));
            native->sides = (uint)item.Sides;
            native->point_set = held.Hold(item.PointSet.Handle);
            if (item.Model != null)
            {
                native->model = held.Hold(item.Model.Handle);
            }
            if (item.LineSet != null)
            {
                native->line_set = held.Hold(item.LineSet.Handle);
            }
            if (item.Style != null)
            {
                native->style = (IntPtr)Describe(item.Style);
            }
            double[] transform = item.Transform;
            for (int i = 0; transform != null && i < 16; ++i)
            {
                native->transform[i] = transform[i];
            }
            int poses = item.Poses.Count;
            if (poses > 0)
            {
                var pose = (hrbfnpr_layer_pose*)memory.Take((long)poses * sizeof(hrbfnpr_layer_pose));
                native->poses = (IntPtr)pose;
                native->pose_count = poses;
                for (int i = 0; i < poses; ++i)
                {
                    if (item.Poses[i] == null)
                    {
                        throw new ArgumentNullException(nameof(item.Poses));
                    }
                    item.Poses[i].Write(pose + i, pins);
                }
            }
        }

        private hrbfnpr_style* Describe(Style style)
        {
            hrbfnpr_style* native = StyleMemory.Write(style, memory);
            if (style.ToneFunction != null)
            {
                var tone = new ToneState(style.ToneFunction);
                tones.Add(tone);
                users.Add(new UserHandle(tone));
                native->tone_function = ToneState.Function;
                native->tone_user = users[users.Count - 1].Pointer;
            }
            else if (style.NativeTone != null)
            {
                native->tone_function = style.NativeTone.Function;
                native->tone_user = style.NativeTone.Hold(held);
            }
            return native;
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
                CheckFunctions(items, status);
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

        private void CheckFunctions(IReadOnlyList<Item> items, int status)
        {
            foreach (ToneState tone in tones)
            {
                Exception thrown = tone.TakeException();
                if (thrown != null)
                {
                    throw new CallbackException("the tone function threw: " + thrown.Message, thrown);
                }
            }
            for (int i = 0; status != 0 && i < items.Count; ++i)
            {
                CheckFunction(items[i].Model == null ? null : items[i].Model.Function);
                CheckFunction(items[i].LineSet == null ? null : items[i].LineSet.Function);
            }
        }

        private static void CheckFunction(FunctionState function)
        {
            Exception thrown = function == null ? null : function.TakeException();
            if (thrown != null)
            {
                throw new CallbackException("the function of a model threw: " + thrown.Message, thrown);
            }
        }
    }
}
