// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;

namespace HrbfNpr
{
    /// <summary>How each mark of a layer is drawn, in the order of the point set.</summary>
    public sealed class MarkResults
    {
        internal MarkResults(long count)
        {
            Shown = new MarkClass[count];
            Radius = new float[count];
            Opacity = new float[count];
        }

        /// <summary>The class as which each mark is drawn: Front or Silhouette; None if it is not drawn.</summary>
        public MarkClass[] Shown { get; }

        /// <summary>The radius of each mark, in pixels; 0 if it is not drawn.</summary>
        public float[] Radius { get; }

        /// <summary>
        /// The alpha of each mark's ink times the transmittance of what lies in front; 0 if it is not drawn.
        /// </summary>
        public float[] Opacity { get; }
    }

    /// <summary>
    /// A picture as a value: dots and strokes in layers.  It can be drawn into an image, or written as vertices or as a
    /// page.
    /// </summary>
    /// <remarks>
    /// It never changes, so several threads may read a drawing at the same time.  It keeps its point sets alive.
    /// Dispose of it when it is not needed any more: the renderer then uses its memory for another drawing.
    /// </remarks>
    public sealed unsafe partial class Drawing : IDisposable
    {
        private readonly DrawingHandle handle;

        internal Drawing(DrawingHandle handle, Camera camera)
        {
            this.handle = handle;
            Camera = camera;
        }

        /// <summary>The camera with which the drawing was made.</summary>
        public Camera Camera { get; }

        /// <summary>The width of an image that holds the camera's viewport, in pixels.</summary>
        public int Width
        {
            get { return Camera.Width; }
        }

        /// <summary>The height of an image that holds the camera's viewport, in pixels.</summary>
        public int Height
        {
            get { return Camera.Height; }
        }

        /// <summary>What the drawing holds, and what making it took.</summary>
        public DrawingInfo Info
        {
            get
            {
                DrawingInfo info;
                Errors.Check(NativeMethods.hrbfnpr_drawing_info_init(&info, (uint)sizeof(DrawingInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_drawing_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        /// <summary>The layers of ink, as a new list.</summary>
        public IReadOnlyList<DrawingLayerInfo> Layers
        {
            get
            {
                var layers = new DrawingLayerInfo[Info.Layers];
                for (int i = 0; i < layers.Length; ++i)
                {
                    DrawingLayerInfo info;
                    Errors.Check(
                        NativeMethods.hrbfnpr_drawing_layer_info_init(&info, (uint)sizeof(DrawingLayerInfo)));
                    hrbfnpr_error error = Errors.New();
                    Errors.Check(NativeMethods.hrbfnpr_drawing_get_layer_info(handle, i, &info, &error), &error);
                    layers[i] = info;
                }
                return new ReadOnlyCollection<DrawingLayerInfo>(layers);
            }
        }

        /// <summary>Finds the mark that has an id, as <see cref="RasterOptions.Id"/> or a vertex gives it.</summary>
        /// <exception cref="InvalidArgumentException">No mark has the id, as with 0.</exception>
        public MarkIdentity Identify(uint id)
        {
            MarkIdentity identity;
            Errors.Check(NativeMethods.hrbfnpr_mark_identity_init(&identity, (uint)sizeof(MarkIdentity)));
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_drawing_identify(handle, id, &identity, &error), &error);
            return identity;
        }

        /// <summary>
        /// Computes how each mark of a layer is drawn, in the order of the point set.  The layer need not be drawn.
        /// </summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">A layer of the item's point set.</param>
        /// <exception cref="InvalidArgumentException">There is no such item, or the layer is not of its point
        /// set.</exception>
        public MarkResults MarkResults(int item, MarkLayer layer)
        {
            if (layer == null)
            {
                throw new ArgumentNullException(nameof(layer));
            }
            var results = new MarkResults(layer.Count);
            MarkResultsInto(item, layer.Number, ArrayView.OfBytes(results.Shown), results.Radius, results.Opacity);
            return results;
        }

        /// <summary>Writes the results of <c>MarkResults</c> into the caller's memory.</summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="shown">Receives the class of each mark (<see cref="MarkClass"/>), a byte each;
        /// optional.</param>
        /// <param name="radius">Receives the radius of each mark in pixels, a float each; optional.</param>
        /// <param name="opacity">Receives the opacity of each mark, a float each; optional.</param>
        /// <exception cref="InvalidArgumentException">There is no such item or layer, or an array has another size or
        /// type.</exception>
        public void MarkResultsInto(
            int item, int layer, ArrayView shown, ArrayView radius = default(ArrayView),
            ArrayView opacity = default(ArrayView))
        {
            hrbfnpr_mark_results results;
            Errors.Check(NativeMethods.hrbfnpr_mark_results_init(&results, (uint)sizeof(hrbfnpr_mark_results)));
            using (var pins = new Pins())
            {
                results.shown = shown.ToNative(pins, 1, nameof(shown));
                results.radius = radius.ToNative(pins, 1, nameof(radius));
                results.opacity = opacity.ToNative(pins, 1, nameof(opacity));
                hrbfnpr_error error = Errors.New();
                Errors.Check(
                    NativeMethods.hrbfnpr_drawing_mark_results(handle, item, layer, &results, &error), &error);
            }
        }

        /// <summary>
        /// Lists the marks of a layer that are drawn as one class, by their numbers: from far to near, or along
        /// strokes.
        /// </summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="markClass">The class of the marks: Front or Silhouette.</param>
        /// <param name="primitive">Points: the marks from far to near.  LineStrips: runs of shown marks along strokes,
        /// each ended by <see cref="HrbfNpr.Vertices.Restart"/>.  TriangleStrips: the same runs, with 2 * number and 2
        /// * number + 1 for each mark.</param>
        /// <exception cref="InvalidArgumentException">There is no such item, layer or class.</exception>
        public uint[] MarkIndices(
            int item, int layer, MarkClass markClass = MarkClass.Front, Primitive primitive = Primitive.Points)
        {
            long count = MarkIndexCount(item, layer, markClass, primitive);
            var indices = new uint[count];
            fixed (uint* first = indices)
            {
                WriteMarkIndices(item, layer, markClass, primitive, (IntPtr)first, count);
            }
            return indices;
        }

        /// <summary>Counts the indices that <c>MarkIndices</c> returns.</summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="markClass">The class of the marks: Front or Silhouette.</param>
        /// <param name="primitive">The primitive, as for <c>MarkIndices</c>.</param>
        public long MarkIndexCount(int item, int layer, MarkClass markClass, Primitive primitive)
        {
            long count;
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_drawing_write_mark_indices(
                handle, item, layer, (uint)markClass, (uint)primitive, null, 0, &count, &error);
            if (status != (int)Status.BufferTooSmall)
            {
                Errors.Check(status, &error);
            }
            return count;
        }

        /// <summary>Writes the result of <c>MarkIndices</c> into native memory.</summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="markClass">The class of the marks: Front or Silhouette.</param>
        /// <param name="primitive">The primitive, as for <c>MarkIndices</c>.</param>
        /// <param name="indices">The address of memory for <paramref name="capacity"/> uints.</param>
        /// <param name="capacity">The number of indices that the memory has room for; <see cref="MarkIndexCount"/> is
        /// enough.</param>
        /// <returns>The number of indices that were written.</returns>
        /// <exception cref="BufferTooSmallException">The capacity is too small; nothing was written.</exception>
        public long WriteMarkIndices(
            int item, int layer, MarkClass markClass, Primitive primitive, IntPtr indices, long capacity)
        {
            long count;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_drawing_write_mark_indices(
                    handle, item, layer, (uint)markClass, (uint)primitive, (uint*)indices, capacity, &count, &error),
                &error);
            return count;
        }

        /// <summary>Computes the numbers of vertices and indices of a primitive.</summary>
        public VertexCount VertexBound(Primitive primitive = Primitive.Points)
        {
            long vertices, indices;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_drawing_vertex_bound(handle, (uint)primitive, &vertices, &indices, &error),
                &error);
            return new VertexCount(vertices, indices);
        }

        /// <summary>
        /// Writes the vertices of dots or strokes, from far to near.  Painted in this order as round points with
        /// "source over" blending, points give the dots of <c>Rasterize</c>.
        /// </summary>
        /// <remarks>Points are discs of paper and of ink.</remarks>
        /// <param name="layout">What a vertex holds, and where.</param>
        /// <param name="vertices">The address of memory for <paramref name="vertexCapacity"/> vertices.</param>
        /// <param name="vertexCapacity">The number of vertices that the memory has room for; <see cref="VertexBound"/>
        /// is always enough.</param>
        /// <param name="indices">The address of memory for <paramref name="indexCapacity"/> uints; zero = not
        /// wanted.</param>
        /// <param name="indexCapacity">The number of indices that the memory has room for.</param>
        /// <returns>The numbers of vertices and indices that were written.</returns>
        /// <exception cref="BufferTooSmallException">A capacity is too small; nothing was written.</exception>
        /// <exception cref="InvalidArgumentException">An attribute has a type that it cannot have.</exception>
        public VertexCount WriteVertices(
            VertexLayout layout, IntPtr vertices, long vertexCapacity, IntPtr indices = default(IntPtr),
            long indexCapacity = 0)
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            hrbfnpr_vertex_layout native;
            Errors.Check(NativeMethods.hrbfnpr_vertex_layout_init(&native, (uint)sizeof(hrbfnpr_vertex_layout)));
            native.primitive = (uint)layout.Primitive;
            native.stride = layout.Stride;
            long vertexCount, indexCount;
            hrbfnpr_error error = Errors.New();
            fixed (hrbfnpr_vertex_attribute* attributes = layout.Attributes)
            {
                native.attributes = (IntPtr)attributes;
                native.attribute_count = layout.Attributes.Length;
                Errors.Check(
                    NativeMethods.hrbfnpr_drawing_write_vertices(
                        handle, &native, (void*)vertices, vertexCapacity, &vertexCount, (uint*)indices, indexCapacity,
                        &indexCount, &error),
                    &error);
            }
            return new VertexCount(vertexCount, indices == IntPtr.Zero ? 0 : indexCount);
        }

        /// <summary>Returns dots or strokes as vertices and indices, in new arrays.</summary>
        /// <param name="layout">What a vertex holds, and where.</param>
        public Vertices Vertices(VertexLayout layout)
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            VertexCount bound = VertexBound(layout.Primitive);
            var data = new byte[bound.Vertices * Math.Max(layout.Stride, 1)];
            var indices = new uint[bound.Indices];
            fixed (byte* first = data)
            fixed (uint* index = indices)
            {
                WriteVertices(layout, (IntPtr)first, bound.Vertices, (IntPtr)index, bound.Indices);
            }
            return new Vertices(data, indices, bound.Vertices);
        }

#if NET7_0_OR_GREATER
        /// <summary>Writes vertices into spans, like the other <c>WriteVertices</c>.</summary>
        /// <param name="layout">What a vertex holds, and where.</param>
        /// <param name="vertices">Memory for whole vertices: structs of <see cref="VertexLayout.Stride"/> bytes, or
        /// bytes.</param>
        /// <param name="indices">Memory for indices; empty = not wanted.</param>
        /// <typeparam name="T">A struct, or byte.</typeparam>
        /// <returns>The numbers of vertices and indices that were written.</returns>
        public VertexCount WriteVertices<T>(VertexLayout layout, Span<T> vertices, Span<uint> indices = default)
            where T : unmanaged
        {
            if (layout == null)
            {
                throw new ArgumentNullException(nameof(layout));
            }
            fixed (T* data = vertices)
            fixed (uint* index = indices)
            {
                long capacity = (long)vertices.Length * sizeof(T) / Math.Max(layout.Stride, 1);
                return WriteVertices(layout, (IntPtr)data, capacity, (IntPtr)index, indices.Length);
            }
        }

        /// <summary>Writes the result of <c>MarkIndices</c> into a span.</summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="markClass">The class of the marks: Front or Silhouette.</param>
        /// <param name="primitive">The primitive, as for <c>MarkIndices</c>.</param>
        /// <param name="indices">Memory for <see cref="MarkIndexCount"/> indices.</param>
        /// <returns>The number of indices that were written.</returns>
        public long WriteMarkIndices(
            int item, int layer, MarkClass markClass, Primitive primitive, Span<uint> indices)
        {
            fixed (uint* first = indices)
            {
                return WriteMarkIndices(item, layer, markClass, primitive, (IntPtr)first, indices.Length);
            }
        }

        /// <summary>Writes how each mark of a layer is drawn into spans.</summary>
        /// <param name="item">The number of the item.</param>
        /// <param name="layer">The number of the layer in the item's point set.</param>
        /// <param name="shown">Receives the class of each mark; may be empty.</param>
        /// <param name="radius">Receives the radius of each mark in pixels; may be empty.</param>
        /// <param name="opacity">Receives the opacity of each mark; may be empty.</param>
        public void MarkResults(
            int item, int layer, Span<MarkClass> shown, Span<float> radius = default, Span<float> opacity = default)
        {
            hrbfnpr_mark_results results;
            Errors.Check(NativeMethods.hrbfnpr_mark_results_init(&results, (uint)sizeof(hrbfnpr_mark_results)));
            fixed (MarkClass* classes = shown)
            fixed (float* radii = radius, opacities = opacity)
            {
                results.shown = Column(classes, shown.Length, ScalarType.Uint8);
                results.radius = Column(radii, radius.Length, ScalarType.Float32);
                results.opacity = Column(opacities, opacity.Length, ScalarType.Float32);
                hrbfnpr_error error = Errors.New();
                Errors.Check(
                    NativeMethods.hrbfnpr_drawing_mark_results(handle, item, layer, &results, &error), &error);
            }
        }

        private static hrbfnpr_array Column(void* data, int count, ScalarType scalar)
        {
            return data == null ? default : new hrbfnpr_array
            {
                data = (IntPtr)data, count = count, scalar = (uint)scalar, components = 1,
            };
        }
#endif

        /// <summary>Releases the drawing.  Its renderer may then use the memory again.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
