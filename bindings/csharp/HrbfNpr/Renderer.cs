using System;

namespace HrbfNpr
{
    /// <summary>Draws point sets with a camera [NPAR 6]: prepare a frame, then draw it or write its vertices.</summary>
    /// <remarks>
    /// It keeps its scratch memory from frame to frame.  Calls of several threads wait for each other: give each
    /// thread a renderer of its own.
    /// </remarks>
    /// <example>
    /// <code>
    /// var renderer = new Renderer();
    /// renderer.Prepare(camera, new Item(marks, style));
    /// renderer.Draw(pixels, camera.Width, camera.Height); // byte[], Span&lt;byte&gt; or IntPtr
    /// </code>
    /// </example>
    public sealed unsafe class Renderer : IDisposable
    {
        private readonly object gate = new object();
        private readonly RendererHandle handle = new RendererHandle();

        /// <summary>Makes a renderer.</summary>
        /// <param name="context">The default context if null.</param>
        public Renderer(Context context = null)
        {
            context = Context.Resolve(context);
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_renderer_create(context.Handle, out IntPtr created, &error);
            handle.Take(created, context.Anchor);
            Errors.Check(status, &error);
        }

        /// <summary>What the last frame did, its drawing included.</summary>
        public FrameInfo Info
        {
            get
            {
                FrameInfo info = NewInfo();
                hrbfnpr_error error = Errors.New();
                lock (gate)
                {
                    Errors.Check(NativeMethods.hrbfnpr_renderer_get_info(handle, &info, &error), &error);
                }
                return info;
            }
        }

        /// <summary>How many vertices the prepared frame has.</summary>
        /// <exception cref="InvalidArgumentException">No frame was prepared.</exception>
        public long VertexBound
        {
            get
            {
                long count;
                hrbfnpr_error error = Errors.New();
                lock (gate)
                {
                    Errors.Check(NativeMethods.hrbfnpr_renderer_vertex_bound(handle, &count, &error), &error);
                }
                return count;
            }
        }

        /// <summary>Classifies, shades and orders the marks of a frame.</summary>
        /// <param name="camera">Where it is seen from.</param>
        /// <param name="items">What is drawn; a point set stands for itself in the default style.</param>
        /// <exception cref="InvalidArgumentException">A camera without a viewport, a singular transform, a style's
        /// number out of its range, or styles of different paper or visibility.</exception>
        /// <exception cref="CallbackException">A tone function, or the function of an item's model, threw.</exception>
        public FrameInfo Prepare(Camera camera, params Item[] items)
        {
            if (camera == null)
            {
                throw new ArgumentNullException(nameof(camera));
            }
            if (items == null || Array.IndexOf(items, null) >= 0)
            {
                throw new ArgumentNullException(nameof(items));
            }
            var structs = new hrbfnpr_item[Math.Max(items.Length, 1)];
            var styles = new hrbfnpr_style[structs.Length];
            var users = new UserHandle[structs.Length];
            var tones = new ToneState[structs.Length];
            var held = new HeldHandles(2 * structs.Length);
            try
            {
                fixed (hrbfnpr_item* first = structs)
                fixed (hrbfnpr_style* style = styles)
                {
                    for (int i = 0; i < items.Length; ++i)
                    {
                        Describe(items[i], first + i, style + i, ref tones[i], ref users[i], ref held);
                    }
                    return PrepareItems(camera, items, first, tones);
                }
            }
            finally
            {
                held.Dispose();
                foreach (UserHandle user in users)
                {
                    user.Dispose();
                }
            }
        }

        /// <summary>Draws the prepared frame; may be called again, also with other images.</summary>
        /// <param name="pixels">The image, 4 bytes a pixel; what lies outside the viewport is not touched.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="options">All defaults if null.</param>
        /// <exception cref="InvalidArgumentException">No frame was prepared, the array is too short, or an option does
        /// not fit.</exception>
        public void Draw(byte[] pixels, int width, int height, DrawOptions options = null)
        {
            if (pixels == null)
            {
                throw new ArgumentNullException(nameof(pixels));
            }
            long start = Start(pixels.LongLength, width, height, options);
            fixed (byte* data = pixels)
            {
                Draw((IntPtr)(data + start), width, height, options);
            }
        }

#if NET7_0_OR_GREATER
        /// <summary>As the other <c>Draw</c>, into a span.</summary>
        /// <param name="pixels">The image, 4 bytes a pixel.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="options">All defaults if null.</param>
        public void Draw(Span<byte> pixels, int width, int height, DrawOptions options = null)
        {
            long start = Start(pixels.Length, width, height, options);
            fixed (byte* data = pixels)
            {
                Draw((IntPtr)(data + start), width, height, options);
            }
        }

        /// <summary>As the other <c>WriteVertices</c>, into a span.</summary>
        /// <param name="layout">What a vertex holds.</param>
        /// <param name="destination">Memory for whole vertices.</param>
        /// <returns>How many were written.</returns>
        public long WriteVertices(VertexLayout layout, Span<byte> destination)
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            fixed (byte* data = destination)
            {
                return WriteVertices(layout, (IntPtr)data, destination.Length / Math.Max(layout.Stride, 1));
            }
        }
#endif

        /// <summary>As the other <c>Draw</c>, into native memory, such as a texture's or a NativeArray's.</summary>
        /// <param name="pixels">The top-left pixel, whatever the sign of the row stride.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="options">All defaults if null.</param>
        public void Draw(IntPtr pixels, int width, int height, DrawOptions options = null)
        {
            hrbfnpr_image image;
            Errors.Check(NativeMethods.hrbfnpr_image_init(&image, (uint)sizeof(hrbfnpr_image)));
            image.width = width;
            image.height = height;
            image.pixels = pixels;
            hrbfnpr_error error = Errors.New();
            if (options == null)
            {
                lock (gate)
                {
                    Errors.Check(NativeMethods.hrbfnpr_renderer_draw_image(handle, &image, null, &error), &error);
                }
                return;
            }
            image.format = (uint)options.Format;
            image.row_stride = options.RowStride;
            hrbfnpr_draw_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_draw_desc_init(&desc, (uint)sizeof(hrbfnpr_draw_desc)));
            using (var pins = new Pins())
            {
                options.Write(ref desc, pins);
                lock (gate)
                {
                    Errors.Check(NativeMethods.hrbfnpr_renderer_draw_image(handle, &image, &desc, &error), &error);
                }
            }
        }

        /// <summary>Prepares a frame and draws it into a new image that holds the camera's viewport.</summary>
        /// <param name="camera">Where it is seen from.</param>
        /// <param name="items">What is drawn.</param>
        /// <returns>camera.Width * camera.Height pixels, straight RGBA, 4 bytes each.</returns>
        public byte[] Draw(Camera camera, params Item[] items)
        {
            lock (gate)
            {
                Prepare(camera, items);
                var pixels = new byte[4L * camera.Width * camera.Height];
                Draw(pixels, camera.Width, camera.Height);
                return pixels;
            }
        }

        /// <summary>
        /// Writes the prepared frame as points, far to near: discs of paper and of ink.  Painted in this order as round
        /// points with "source over" blending they give the picture of <c>Draw</c>.
        /// </summary>
        /// <param name="layout">What a vertex holds.</param>
        /// <param name="destination">Memory for <paramref name="capacity"/> vertices.</param>
        /// <param name="capacity">In vertices; <see cref="VertexBound"/> is always enough.</param>
        /// <returns>How many were written.</returns>
        /// <exception cref="BufferTooSmallException">The capacity is too small; nothing was written.</exception>
        /// <exception cref="InvalidArgumentException">No frame was prepared, or an attribute cannot have its type.</exception>
        public long WriteVertices(VertexLayout layout, IntPtr destination, long capacity)
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            hrbfnpr_vertex_layout native = layout.Native;
            long count;
            hrbfnpr_error error = Errors.New();
            lock (gate)
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_renderer_write_vertices(
                        handle, &native, (void*)destination, capacity, &count, &error),
                    &error);
            }
            return count;
        }

        /// <summary>The vertices of the prepared frame, <see cref="VertexLayout.Stride"/> bytes each.</summary>
        /// <param name="layout">What a vertex holds.</param>
        public byte[] Vertices(VertexLayout layout)
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            lock (gate)
            {
                long bound = VertexBound;
                var data = new byte[Math.Max(bound, 1) * Math.Max(layout.Stride, 1)];
                long count;
                fixed (byte* first = data)
                {
                    count = WriteVertices(layout, (IntPtr)first, bound);
                }
                if (count * layout.Stride != data.LongLength)
                {
                    Array.Resize(ref data, checked((int)(count * layout.Stride)));
                }
                return data;
            }
        }

        /// <summary>Lets go of the renderer's memory, and of the point sets of its frame.</summary>
        public void Dispose()
        {
            lock (gate)
            {
                handle.Dispose();
            }
        }

        private static FrameInfo NewInfo()
        {
            FrameInfo info;
            Errors.Check(NativeMethods.hrbfnpr_frame_info_init(&info, (uint)sizeof(FrameInfo)));
            return info;
        }

        private static void Describe(
            Item item, hrbfnpr_item* native, hrbfnpr_style* style, ref ToneState tone, ref UserHandle user,
            ref HeldHandles held)
        {
            Errors.Check(NativeMethods.hrbfnpr_item_init(native, (uint)sizeof(hrbfnpr_item)));
            native->point_set = held.Hold(item.PointSet.Handle);
            if (item.Model != null)
            {
                native->model = held.Hold(item.Model.Handle);
            }
            if (item.Style != null)
            {
                item.Style.Write(style);
                native->style = (IntPtr)style;
                if (item.Style.ToneFunction != null)
                {
                    tone = new ToneState(item.Style.ToneFunction);
                    user = new UserHandle(tone);
                    style->tone_function = ToneState.Function;
                    style->tone_user = user.Pointer;
                }
            }
            double[] transform = item.Transform;
            for (int i = 0; transform != null && i < 16; ++i)
            {
                native->transform[i] = transform[i];
            }
        }

        private static long Start(long length, int width, int height, DrawOptions options)
        {
            long stride = options == null || options.RowStride == 0 ? 4L * width : options.RowStride;
            if (width > 0 && height > 0 && width <= 32768 && height <= 32768)
            {
                // The bytes from the first one in memory to the last one.
                bool tooLong = Math.Abs(stride / 4) > int.MaxValue;
                if (tooLong || Math.Abs(stride) * (height - 1) + 4L * width > length)
                {
                    throw new InvalidArgumentException(
                        "pixels has " + length + " bytes, too few for " + width + " x " + height + " pixels");
                }
                return stride < 0 ? -stride * (height - 1) : 0;
            }
            return 0; // sizes out of range are refused by the library before it writes
        }

        private FrameInfo PrepareItems(Camera camera, Item[] items, hrbfnpr_item* first, ToneState[] tones)
        {
            FrameInfo info = NewInfo();
            hrbfnpr_camera view = camera.Native;
            hrbfnpr_error error = Errors.New();
            int status;
            lock (gate)
            {
                status = NativeMethods.hrbfnpr_renderer_prepare(
                    handle, first, items.Length, sizeof(hrbfnpr_item), &view, &info, &error);
            }
            foreach (ToneState tone in tones)
            {
                Exception thrown = tone == null ? null : tone.TakeException();
                if (thrown != null)
                {
                    throw new CallbackException("the tone function threw: " + thrown.Message, thrown);
                }
            }
            if (status != 0)
            {
                foreach (Item item in items)
                {
                    FunctionState function = item.Model == null ? null : item.Model.Function;
                    Exception thrown = function == null ? null : function.TakeException();
                    if (thrown != null)
                    {
                        throw new CallbackException("the function of a model threw: " + thrown.Message, thrown);
                    }
                }
            }
            Errors.Check(status, &error);
            return info;
        }
    }
}
