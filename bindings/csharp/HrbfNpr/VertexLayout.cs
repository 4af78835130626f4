// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>What a vertex holds, and where.  A layout that is not added to any more may be shared by threads.</summary>
    /// <example>
    /// <code>var layout = new VertexLayout().Add(VertexAttribute.Position).Add(VertexAttribute.Color);</code>
    /// </example>
    public sealed class VertexLayout
    {
        private hrbfnpr_vertex_attribute[] attributes = new hrbfnpr_vertex_attribute[0];

        /// <summary>Without attributes.</summary>
        /// <param name="primitive">What the vertices are.</param>
        public VertexLayout(Primitive primitive = Primitive.Points)
        {
            Primitive = primitive;
        }

        /// <summary>What the vertices are.</summary>
        public Primitive Primitive { get; set; }

        /// <summary>Bytes of a vertex: up to the end of its last attribute, and a multiple of 4, unless set.</summary>
        public int Stride { get; set; }

        internal hrbfnpr_vertex_attribute[] Attributes
        {
            get { return attributes; }
        }

        /// <summary>Adds an attribute after the others, in its usual type: colours, classes and IsPaper in bytes.</summary>
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

        /// <summary>Adds an attribute at a place of its own.</summary>
        /// <param name="attribute">Such as Position.</param>
        /// <param name="scalar">A type that it can have.</param>
        /// <param name="offset">Bytes from the start of the vertex.</param>
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

    /// <summary>How many vertices and indices there are.</summary>
    public readonly struct VertexCount
    {
        /// <summary>Vertices.</summary>
        public readonly long Vertices;

        /// <summary>Indices, restarts included.</summary>
        public readonly long Indices;

        internal VertexCount(long vertices, long indices)
        {
            Vertices = vertices;
            Indices = indices;
        }
    }

    /// <summary>Vertices of a drawing, and their indices.</summary>
    public sealed class Vertices
    {
        /// <summary>Ends a strip among indices.</summary>
        public const uint Restart = 0xffffffff;

        internal Vertices(byte[] data, uint[] indices, long count)
        {
            Data = data;
            Indices = indices;
            Count = count;
        }

        /// <summary><see cref="VertexLayout.Stride"/> bytes for each vertex.</summary>
        public byte[] Data { get; }

        /// <summary>Of strips: the vertices of one stroke after the other, each ended by <see cref="Restart"/>.</summary>
        public uint[] Indices { get; }

        /// <summary>Vertices.</summary>
        public long Count { get; }
    }
}
