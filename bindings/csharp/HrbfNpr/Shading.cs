// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>How much of the sky and of each light with a shadow the marks of an item see.</summary>
    /// <remarks>
    /// It holds for the item's point set, its transform, the lights of its style, and the occluders.  While these stay,
    /// it is valid for any camera, except that lights in the space of the camera move with it.  A shading never changes,
    /// so several threads may use it at the same time.  It keeps the point set's data alive.
    /// </remarks>
    public sealed unsafe class Shading : IDisposable
    {
        private readonly ShadingHandle handle = new ShadingHandle();

        /// <summary>Computes the shading of an item; give it as <see cref="Item.Shading"/>.</summary>
        /// <param name="occluders">The surfaces that cast shadows and hide the sky.</param>
        /// <param name="item">The item.  Its point set, style and transform are used.</param>
        /// <param name="camera">The camera of lights in its space that cast shadows; null if no light is
        /// such.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A number of the options or of the style is out of its range, the
        /// item has poses, or a light in the space of the camera casts shadows and there is no camera.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public Shading(
            Occluders occluders, Item item, Camera camera = null, ShadingOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            if (occluders == null)
            {
                throw new ArgumentNullException(nameof(occluders));
            }
            context = Context.Resolve(context);
            hrbfnpr_camera view = camera == null ? default(hrbfnpr_camera) : camera.Native;
            using (var held = new HeldHandles())
            using (var structs = new ItemMemory())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_shading_desc desc;
                (options ?? new ShadingOptions()).Write(&desc, held);
                hrbfnpr_item* first = structs.Write(new[] { item }, false);
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_shading_create(
                    context.Handle, occluders.Handle, first, camera == null ? null : &view, &desc, call.Operation,
                    out IntPtr created, &error);
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

        /// <summary>Copies the shares of the sky that the marks of a layer see.</summary>
        /// <param name="layer">The number of the layer in the point set.</param>
        /// <returns>A number from 0 to 1 for each mark; 1 = the whole sky.</returns>
        /// <exception cref="InvalidArgumentException">There is no such layer, or no occlusion was
        /// computed.</exception>
        public float[] Openness(int layer = 0)
        {
            return Seen(layer, -1);
        }

        /// <summary>Copies the shares of a light that reach the marks of a layer past shadows.</summary>
        /// <param name="light">The number of the light among those of the style.</param>
        /// <param name="layer">The number of the layer in the point set.</param>
        /// <returns>A number from 0 to 1 for each mark; 1 = all of the light.</returns>
        /// <exception cref="InvalidArgumentException">There is no such layer, or the light casts no
        /// shadow.</exception>
        public float[] Visible(int light = 0, int layer = 0)
        {
            if (light < 0)
            {
                throw new ArgumentOutOfRangeException(nameof(light), light, "light must be at least 0");
            }
            return Seen(layer, light);
        }

        private float[] Seen(int layer, int light)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_shading_view(handle, layer, light, &view, &error), &error);
            float[] copy = new float[checked((int)view.count)];
            System.Runtime.InteropServices.Marshal.Copy((IntPtr)view.data, copy, 0, copy.Length);
            GC.KeepAlive(this);
            return copy;
        }

        internal ShadingHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Releases the shading.  A drawing needs it only while it is made.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
