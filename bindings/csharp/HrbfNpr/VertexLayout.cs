// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>What a vertex holds, and where.</summary>
    /// <remarks>Several threads may share a layout as long as no attribute is added.</remarks>
    /// <example>
    /// <code>var layout = new VertexLayout().Add(VertexAttribute.Position).Add(VertexAttribute.Color);</code>
    /// </example>
    public sealed class VertexLayout
    {
        private hrbfnpr_vertex_attribute[] attributes = new hrbfnpr_vertex_attribute[0];

        /// <summary>Creates a layout without attributes.</summary>
        /// <param name="primitive">What vertices are written for.</param>
        public VertexLayout(Primitive primitive = Primitive.Points)
        {
            Primitive = primitive;
        }

        /// <summary>What vertices are written for; default Points.</summary>
        public Primitive Primitive { get; set; }

        /// <summary>
        /// Bytes from one vertex to the next; default up to the end of the last attribute, rounded up to a multiple of
        /// 4.
        /// </summary>
        public int Stride { get; set; }

        internal hrbfnpr_vertex_attribute[] Attributes
        {
            get { return attributes; }
        }

        /// <summary>
        /// Adds an attribute after the others, in its usual type: byte for colours, classes and IsPaper.
        /// </summary>
        /// <returns>This layout.</returns>
        public VertexLayout Add(VertexAttribute attribute)
        {
            switch (attribute)
            {
                case VertexAttribute.Color:
                case VertexAttribute.Class:
                case VertexAttribute.IsPaper:
                    return Add(attribute, ScalarType.Uint8, End(1));
                case VertexAttribute.Id:
                case VertexAttribute.Layer:
                case VertexAttribute.Line:
                case VertexAttribute.HiddenLayers:
                case VertexAttribute.HiddenBy:
                    return Add(attribute, ScalarType.Uint32, End(4));
                default:
                    return Add(attribute, ScalarType.Float32, End(4));
            }
        }

        /// <summary>Adds an attribute with a given type and place.</summary>
        /// <param name="attribute">The attribute.</param>
        /// <param name="scalar">A type that the attribute can have.</param>
        /// <param name="offset">The bytes from the start of the vertex.</param>
        /// <returns>This layout.</returns>
        public unsafe VertexLayout Add(VertexAttribute attribute, ScalarType scalar, int offset)
        {
            hrbfnpr_vertex_attribute added;
            Errors.Check(
                NativeMethods.hrbfnpr_vertex_attribute_init(&added, (uint)sizeof(hrbfnpr_vertex_attribute)));
            added.attribute = unchecked((uint)attribute);
            added.scalar = (uint)scalar;
            added.offset = unchecked((uint)offset);
            Array.Resize(ref attributes, attributes.Length + 1);
            attributes[attributes.Length - 1] = added;
            Stride = Math.Max(Stride, (offset + Size(attribute, scalar) + 3) / 4 * 4);
            return this;
        }

        private static int Size(VertexAttribute attribute, ScalarType scalar)
        {
            int bytes = scalar == ScalarType.Uint8 ? 1 : 4;
            switch (attribute)
            {
                case VertexAttribute.Color:
                    return 4 * bytes;
                case VertexAttribute.Position:
                case VertexAttribute.Window:
                case VertexAttribute.Normal:
                case VertexAttribute.Direction:
                    return 3 * bytes;
                default:
                    return bytes;
            }
        }

        private int End(int alignment)
        {
            int end = 0;
            foreach (hrbfnpr_vertex_attribute one in attributes)
            {
                int size = Size((VertexAttribute)one.attribute, (ScalarType)one.scalar);
                end = Math.Max(end, (int)one.offset + size);
            }
            return (end + alignment - 1) / alignment * alignment;
        }
    }

    /// <summary>Numbers of vertices and indices.</summary>
    public readonly struct VertexCount
    {
        /// <summary>Number of vertices.</summary>
        public readonly long Vertices;

        /// <summary>Number of indices, including those that end strips.</summary>
        public readonly long Indices;

        internal VertexCount(long vertices, long indices)
        {
            Vertices = vertices;
            Indices = indices;
        }
    }

    /// <summary>The vertices of a drawing, and their indices.</summary>
    public sealed class Vertices
    {
        /// <summary>The index that ends a strip.</summary>
        public const uint Restart = 0xffffffff;

        internal Vertices(byte[] data, uint[] indices, long count)
        {
            Data = data;
            Indices = indices;
            Count = count;
        }

        /// <summary>The vertices: <see cref="VertexLayout.Stride"/> bytes each.</summary>
        public byte[] Data { get; }

        /// <summary>
        /// The indices.  For strips: the vertices of one stroke after the other, each stroke ended by
        /// <see cref="Restart"/>.
        /// </summary>
        public uint[] Indices { get; }

        /// <summary>Number of vertices.</summary>
        public long Count { get; }
    }
}
